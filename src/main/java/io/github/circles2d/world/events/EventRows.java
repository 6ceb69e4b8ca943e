package io.github.circles2d.world.events;

import static io.github.circles2d.world.events.EventRow.FIRST_VALUE;
import static io.github.circles2d.world.events.EventRow.HIGHER;
import static io.github.circles2d.world.events.EventRow.LOWER;
import static io.github.circles2d.world.events.EventRow.RANK;
import static io.github.circles2d.world.events.EventRow.STRIDE;

import io.github.circles2d.world.circles.BulkCopies;
import io.github.circles2d.world.model.Bounds;
import java.nio.IntBuffer;
import java.util.Arrays;

/** Events, one after the other. */
public final class EventRows {
    private static final int LEAST_ROWS = 64;

    int count;

    /** By event: see {@link EventRow}; the number of the step is in {@link #step}. */
    private int[] words = new int[0];

    /** By event: the handles. */
    private long[] a = new long[0];

    private long[] b = new long[0];
    private long[] step = new long[0];

    /** Null until events are sorted. */
    private EventSort sort;

    void clear() {
        count = 0;
    }

    /** Makes room. The array that is compared grows last: a growth that fails is tried again. */
    void ensure(int rows) {
        if (rows > step.length) {
            int c = Math.max(rows, Math.max(LEAST_ROWS, step.length + (step.length >> 1)));
            words = Arrays.copyOf(words, Math.multiplyExact(STRIDE, c));
            a = Arrays.copyOf(a, c);
            b = Arrays.copyOf(b, c);
            step = Arrays.copyOf(step, c);
        }
    }

    /** Adds an event without values, and returns its row. */
    int add(int lower, int higher, int rank, long handleA, long handleB) {
        ensure(count + 1);
        int at = STRIDE * count;
        Arrays.fill(words, at, at + STRIDE, 0);
        words[at + LOWER] = lower;
        words[at + HIGHER] = higher;
        words[at + RANK] = rank;
        a[count] = handleA;
        b[count] = handleB;
        return count++;
    }

    void setValues(int row, float[] from, int at) {
        for (int k = 0; k < TouchRecords.VALUES; k++) {
            words[STRIDE * row + FIRST_VALUE + k] = Float.floatToRawIntBits(from[at + k]);
        }
    }

    void copyValues(int row, float[] to, int at) {
        for (int k = 0; k < TouchRecords.VALUES; k++) {
            to[at + k] = value(row, k);
        }
    }

    /** Adds rows of a step that a device has decided, with the handles that their circles have. */
    void addDecided(
            IntBuffer from,
            int firstRow,
            int rows,
            long stepNumber,
            KnownCircles circles,
            KnownPieces pieces,
            Bounds arena) {
        ensure(count + rows);
        BulkCopies.get(from, STRIDE * firstRow, words, STRIDE * count, STRIDE * rows);
        Arrays.fill(step, count, count + rows, stepNumber);
        for (int row = count; row < count + rows; row++) {
            int higher = words[STRIDE * row + HIGHER];
            a[row] = circles.handle(words[STRIDE * row + LOWER]);
            b[row] = pieces.handleOfPartner(higher);
            if (arena.wraps()) {
                bringInside(row, arena);
            }
        }
        count += rows;
    }

    /** Brings the point of an event inside, if it is beyond the edge of an axis that wraps. */
    private void bringInside(int row, Bounds arena) {
        int at = STRIDE * row;
        if (words[at + RANK] == EventRow.END) {
            return; // it has no point
        }
        words[at + FIRST_VALUE + TouchRecords.POINT_X] =
                Float.floatToRawIntBits(arena.placeX(value(row, TouchRecords.POINT_X)));
        words[at + FIRST_VALUE + TouchRecords.POINT_Y] =
                Float.floatToRawIntBits(arena.placeY(value(row, TouchRecords.POINT_Y)));
    }

    /** Adds the events of another list, in the order of their keys, which are distinct, as those of a step. */
    void addInOrder(EventRows from, long stepNumber) {
        if (from.count == 0) {
            return;
        }
        ensure(count + from.count);
        from.sort();
        for (int k = 0; k < from.count; k++) {
            copy(from, from.ordered(k), count + k);
        }
        Arrays.fill(step, count, count + from.count, stepNumber);
        count += from.count;
    }

    private void copy(EventRows from, int row, int to) {
        System.arraycopy(from.words, STRIDE * row, words, STRIDE * to, STRIDE);
        a[to] = from.a[row];
        b[to] = from.b[row];
        step[to] = from.step[row];
    }

    /** The number of events from a step on, which are in the order of steps. */
    int countFrom(long firstStep) {
        int first = count;
        while (first > 0 && step[first - 1] >= firstStep) {
            first--;
        }
        return count - first;
    }

    /** Moves the events from a step on into a list whose first step that is. */
    void moveFrom(long firstStep, EventRows to) {
        int first = count - countFrom(firstStep);
        to.ensure(to.count + count - first);
        for (int row = first; row < count; row++) {
            to.copy(this, row, to.count);
            to.step[to.count++] -= firstStep;
        }
        count = first;
    }

    /** Moves all events into a list, instead of those that it has. */
    public void moveTo(EventRows to) {
        to.clear();
        moveFrom(0, to);
    }

    /** Removes an event; the last one takes its number. */
    void remove(int row) {
        copy(this, --count, row);
    }

    /** Sorts the order by keys. */
    void sort() {
        if (sort == null) {
            sort = new EventSort();
        }
        sort.ensure(count);
        sort.sort(this);
    }

    int ordered(int place) {
        return sort.row(place);
    }

    /** What the events of a step are ordered by. */
    long key(int row) {
        int at = STRIDE * row;
        return Partner.key(words[at + LOWER], words[at + HIGHER], words[at + RANK]);
    }

    private float value(int row, int which) {
        return Float.intBitsToFloat(words[STRIDE * row + FIRST_VALUE + which]);
    }

    public int size() {
        return count;
    }

    /** The type: one of those in {@link ContactEvents}. */
    public int type(int event) {
        return EventRow.type(words[STRIDE * check(event) + RANK]);
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
        return isPiece(event) ? 0 : b[event];
    }

    /** The handle of the piece of terrain, or 0. */
    public long piece(int event) {
        return isPiece(event) ? b[event] : 0;
    }

    private boolean isPiece(int event) {
        return Partner.isPiece(words[STRIDE * check(event) + HIGHER]);
    }

    /** The handle of the other circle or of the piece, or 0. */
    long partner(int row) {
        return b[row];
    }

    /** The number of the wall, or -1. */
    public int side(int event) {
        int side = sideOf(check(event));
        return side == Partner.PIECE ? Partner.NO_SIDE : side;
    }

    boolean isOfWall(int row) {
        return Partner.isWall(words[STRIDE * row + HIGHER]);
    }

    /** See {@link Partner#side}. */
    int sideOf(int row) {
        return Partner.side(words[STRIDE * row + HIGHER]);
    }

    /** The approach speed. */
    public float speed(int event) {
        return value(check(event), TouchRecords.APPROACH);
    }

    public float impulse(int event) {
        return value(check(event), TouchRecords.IMPULSE);
    }

    public float normalX(int event) {
        return value(check(event), TouchRecords.NORMAL_X);
    }

    public float normalY(int event) {
        return value(check(event), TouchRecords.NORMAL_Y);
    }

    public float x(int event) {
        return value(check(event), TouchRecords.POINT_X);
    }

    public float y(int event) {
        return value(check(event), TouchRecords.POINT_Y);
    }

    /** The speed along the surfaces. */
    public float slipSpeed(int event) {
        return value(check(event), TouchRecords.SLIP);
    }

    private int check(int event) {
        if (event < 0 || event >= count) {
            throw new IndexOutOfBoundsException("there is no event " + event + " of " + count);
        }
        return event;
    }

    public long bytes() {
        return (4L * STRIDE + 24L) * step.length + (sort == null ? 0 : sort.bytes());
    }

    /** Sorts the events of a step by their keys: a radix sort, which takes memory only when it sorts more than before. */
    private static final class EventSort {
        private static final int DIGIT_BITS = 8;
        private static final int DIGITS = 1 << DIGIT_BITS;

        /** Up to this many rows an insertion sort is faster. */
        private static final int FEW = 32;

        private final int[] starts = new int[DIGITS];
        private long[] key = new long[0];
        private long[] keyNext = new long[0];
        private int[] order = new int[0];
        private int[] orderNext = new int[0];

        /** Makes room. All arrays are made before one is assigned: a growth that fails changes nothing. */
        void ensure(int rows) {
            if (rows > orderNext.length) {
                int c = Math.max(rows, orderNext.length + (orderNext.length >> 1));
                long[] newKey = new long[c];
                long[] newKeyNext = new long[c];
                int[] newOrder = new int[c];
                int[] newOrderNext = new int[c];
                key = newKey;
                keyNext = newKeyNext;
                order = newOrder;
                orderNext = newOrderNext;
            }
        }

        /** Sorts rows, for which there is room, by distinct keys. */
        void sort(EventRows rows) {
            int count = rows.count;
            long varying = 0;
            for (int row = 0; row < count; row++) {
                key[row] = rows.key(row);
                order[row] = row;
                varying |= key[row] ^ key[0];
            }
            if (count <= FEW) {
                insert(count);
                return;
            }
            for (int shift = 0; shift < Long.SIZE; shift += DIGIT_BITS) {
                if ((varying >>> shift & DIGITS - 1) != 0) {
                    pass(count, shift);
                }
            }
        }

        private void insert(int count) {
            for (int k = 1; k < count; k++) {
                long own = key[k];
                int row = order[k];
                int place = k;
                for (; place > 0 && key[place - 1] > own; place--) {
                    key[place] = key[place - 1];
                    order[place] = order[place - 1];
                }
                key[place] = own;
                order[place] = row;
            }
        }

        private void pass(int count, int shift) {
            Arrays.fill(starts, 0);
            for (int k = 0; k < count; k++) {
                starts[(int) (key[k] >>> shift) & DIGITS - 1]++;
            }
            int sum = 0;
            for (int digit = 0; digit < DIGITS; digit++) {
                int many = starts[digit];
                starts[digit] = sum;
                sum += many;
            }
            for (int k = 0; k < count; k++) {
                int place = starts[(int) (key[k] >>> shift) & DIGITS - 1]++;
                keyNext[place] = key[k];
                orderNext[place] = order[k];
            }
            long[] keys = key;
            key = keyNext;
            keyNext = keys;
            int[] orders = order;
            order = orderNext;
            orderNext = orders;
        }

        int row(int place) {
            return order[place];
        }

        long bytes() {
            return 24L * orderNext.length + 4L * DIGITS;
        }
    }
}
