package io.github.circles2d.world.bodies;

import java.util.Arrays;

/** Touches of bodies that have begun or ended, in order, until somebody takes them. */
public final class RigidTouches {
    private static final int HANDLES = 2;

    private int count;

    /** Of an event: the handles of the body, and of what it touches, or the number of a wall. */
    private long[] handles = new long[0];

    /** Of an event: {@link RigidStep#TOUCH_VALUES}. */
    private float[] values = new float[0];

    /** Of an event: whether it is a begin, and the type of {@link RigidStep}. */
    private boolean[] begins = new boolean[0];

    private byte[] types = new byte[0];

    public RigidTouches() {}

    /** Makes room for more. If there is none, nothing has changed. */
    void ensure(int more) {
        int needed = count + more;
        if (needed > types.length) {
            int c = Math.max(needed, types.length + (types.length >> 1));
            handles = Arrays.copyOf(handles, HANDLES * c);
            values = Arrays.copyOf(values, RigidStep.TOUCH_VALUES * c);
            begins = Arrays.copyOf(begins, c);
            types = Arrays.copyOf(types, c);
        }
    }

    /** An end, for which there is room. */
    void end(int type, long body, long other) {
        Arrays.fill(values, RigidStep.TOUCH_VALUES * count, RigidStep.TOUCH_VALUES * (count + 1), 0f);
        add(false, type, body, other);
    }

    /** A begin, for which there is room; from: where its values are. */
    void begin(int type, long body, long other, float[] of, int from) {
        System.arraycopy(of, from, values, RigidStep.TOUCH_VALUES * count, RigidStep.TOUCH_VALUES);
        add(true, type, body, other);
    }

    private void add(boolean isBegin, int type, long body, long other) {
        handles[HANDLES * count] = body;
        handles[HANDLES * count + 1] = other;
        begins[count] = isBegin;
        types[count++] = (byte) type;
    }

    void clear() {
        count = 0;
    }

    /** Gives all away, in place of what there is. */
    public void moveTo(RigidTouches to) {
        long[] ofHandles = to.handles;
        float[] ofValues = to.values;
        boolean[] ofBegins = to.begins;
        byte[] ofTypes = to.types;
        to.count = count;
        to.handles = handles;
        to.values = values;
        to.begins = begins;
        to.types = types;
        count = 0;
        handles = ofHandles;
        values = ofValues;
        begins = ofBegins;
        types = ofTypes;
    }

    public int count() {
        return count;
    }

    public boolean begins(int k) {
        return begins[check(k)];
    }

    public int type(int k) {
        return types[check(k)];
    }

    public long body(int k) {
        return handles[HANDLES * check(k)];
    }

    public long other(int k) {
        return handles[HANDLES * check(k) + 1];
    }

    /** One of {@link RigidStep#TOUCH_VALUES}. */
    public float value(int k, int which) {
        return values[RigidStep.TOUCH_VALUES * check(k) + which];
    }

    /** Memory of the arrays. */
    public long bytes() {
        return 8L * handles.length + 4L * values.length + 2L * types.length;
    }

    private int check(int k) {
        if (k < 0 || k >= count) {
            throw new IndexOutOfBoundsException("there is no event " + k + " of " + count);
        }
        return k;
    }
}
