package io.github.circles2d.world.events;

import java.util.Arrays;

/** Events, one after the other. */
public final class EventRows {
    private static final int VALUES = TouchRecords.VALUES;

    int count;

    /** By event: what the events of a step are ordered by. */
    private long[] key = new long[0];

    private int[] order = new int[0];
    private int[] type = new int[0];
    private long[] step = new long[0];
    private long[] a = new long[0];
    private long[] b = new long[0];
    private int[] side = new int[0];
    float[] values = new float[0];

    /** No events. */
    public EventRows() {}

    void clear() {
        count = 0;
    }

    /** Makes room. The length of the array that grows last tells whether there is room. */
    void ensure(int rows) {
        if (rows > side.length) {
            int c = Math.max(rows, Math.max(64, side.length + (side.length >> 1)));
            key = Arrays.copyOf(key, c);
            order = Arrays.copyOf(order, c);
            type = Arrays.copyOf(type, c);
            step = Arrays.copyOf(step, c);
            a = Arrays.copyOf(a, c);
            b = Arrays.copyOf(b, c);
            values = Arrays.copyOf(values, VALUES * c);
            side = Arrays.copyOf(side, c);
        }
    }

    /** Adds an event without values, and returns where its values begin. */
    int add(long orderKey, int eventType, long handleA, long handleB, int wallSide) {
        ensure(count + 1);
        key[count] = orderKey;
        type[count] = eventType;
        a[count] = handleA;
        b[count] = handleB;
        side[count] = wallSide;
        Arrays.fill(values, VALUES * count, VALUES * (count + 1), 0f);
        return VALUES * count++;
    }

    /** Adds the events of another list, in the order of their keys, which are distinct, as those of a step. */
    void addInOrder(EventRows from, long stepNumber) {
        ensure(count + from.count);
        from.sort();
        for (int k = 0; k < from.count; k++) {
            int row = from.order[k];
            int at = add(from.key[row], from.type[row], from.a[row], from.b[row], from.side[row]);
            step[count - 1] = stepNumber;
            System.arraycopy(from.values, VALUES * row, values, at, VALUES);
        }
    }

    /** Moves the events from a step on, which are in the order of steps, into a list whose first step that is. */
    void moveFrom(long firstStep, EventRows to) {
        int first = count;
        while (first > 0 && step[first - 1] >= firstStep) {
            first--;
        }
        for (int row = first; row < count; row++) {
            int at = to.add(key[row], type[row], a[row], b[row], side[row]);
            to.step[to.count - 1] = step[row] - firstStep;
            System.arraycopy(values, VALUES * row, to.values, at, VALUES);
        }
        count = first;
    }

    /** Removes an event; the last one takes its number. */
    void remove(int row) {
        int last = --count;
        key[row] = key[last];
        type[row] = type[last];
        a[row] = a[last];
        b[row] = b[last];
        side[row] = side[last];
        System.arraycopy(values, VALUES * last, values, VALUES * row, VALUES);
    }

    /** Sorts the order by keys: a heap sort, without memory. */
    void sort() {
        for (int k = 0; k < count; k++) {
            order[k] = k;
        }
        for (int k = count / 2 - 1; k >= 0; k--) {
            sink(k, count);
        }
        for (int end = count - 1; end > 0; end--) {
            int top = order[0];
            order[0] = order[end];
            order[end] = top;
            sink(0, end);
        }
    }

    private void sink(int root, int end) {
        int row = order[root];
        int k = root;
        while (2 * k + 1 < end) {
            int child = 2 * k + 1;
            if (child + 1 < end && key[order[child]] < key[order[child + 1]]) {
                child++;
            }
            if (key[order[child]] <= key[row]) {
                break;
            }
            order[k] = order[child];
            k = child;
        }
        order[k] = row;
    }

    /** The row that is at a place of the order. */
    int ordered(int place) {
        return order[place];
    }

    long key(int row) {
        return key[row];
    }

    /** Number of events. */
    public int size() {
        return count;
    }

    /** The type: one of those in {@link ContactEvents}. */
    public int type(int event) {
        return type[check(event)];
    }

    /** The number of the step; 2^31 - 1 for all from there on. */
    public int step(int event) {
        return (int) Math.min(step[check(event)], Integer.MAX_VALUE);
    }

    /** The handle of the circle of lower id. */
    public long a(int event) {
        return a[check(event)];
    }

    /** The handle of the other circle, or 0. */
    public long b(int event) {
        return b[check(event)];
    }

    /** The number of the wall, or -1. */
    public int side(int event) {
        return side[check(event)];
    }

    /** The approach speed. */
    public float speed(int event) {
        return values[VALUES * check(event) + TouchRecords.APPROACH];
    }

    /** The impulse. */
    public float impulse(int event) {
        return values[VALUES * check(event) + TouchRecords.IMPULSE];
    }

    /** The normal, x. */
    public float normalX(int event) {
        return values[VALUES * check(event) + TouchRecords.NORMAL_X];
    }

    /** The normal, y. */
    public float normalY(int event) {
        return values[VALUES * check(event) + TouchRecords.NORMAL_Y];
    }

    /** The point, x. */
    public float x(int event) {
        return values[VALUES * check(event) + TouchRecords.POINT_X];
    }

    /** The point, y. */
    public float y(int event) {
        return values[VALUES * check(event) + TouchRecords.POINT_Y];
    }

    private int check(int event) {
        if (event < 0 || event >= count) {
            throw new IndexOutOfBoundsException("there is no event " + event + " of " + count);
        }
        return event;
    }

    /** Memory of the arrays. */
    long bytes() {
        return 44L * side.length + 4L * values.length;
    }
}
