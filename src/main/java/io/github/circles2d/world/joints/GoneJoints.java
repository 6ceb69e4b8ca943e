package io.github.circles2d.world.joints;

import java.util.Arrays;

/** Joints that have gone by themselves, in order, until somebody takes them. */
public final class GoneJoints {
    // reasons
    public static final int BROKEN = 0;
    public static final int CIRCLE_REMOVED = 1;
    public static final int BODY_REMOVED = 2;

    // of a joint that has gone: the handles of the joint and its circles; the loads
    private static final int HANDLES = 3;
    private static final int LOADS = 2;

    private int count;
    private long[] handles = new long[0];
    private float[] loads = new float[0];
    private byte[] reasons = new byte[0];

    /** Makes room for more. If there is none, nothing has changed. */
    void ensure(int more) {
        int needed = count + more;
        if (needed > reasons.length) {
            int c = Math.max(needed, reasons.length + (reasons.length >> 1));
            handles = Arrays.copyOf(handles, HANDLES * c);
            loads = Arrays.copyOf(loads, LOADS * c);
            reasons = Arrays.copyOf(reasons, c);
        }
    }

    /** There is room. */
    void add(long joint, long circle, long other, int reason, float force, float torque) {
        handles[HANDLES * count] = joint;
        handles[HANDLES * count + 1] = circle;
        handles[HANDLES * count + 2] = other;
        loads[LOADS * count] = force;
        loads[LOADS * count + 1] = torque;
        reasons[count++] = (byte) reason;
    }

    public void clear() {
        count = 0;
    }

    /** Gives all away, in place of what there is. */
    public void moveTo(GoneJoints to) {
        long[] ofHandles = to.handles;
        float[] ofLoads = to.loads;
        byte[] ofReasons = to.reasons;
        to.count = count;
        to.handles = handles;
        to.loads = loads;
        to.reasons = reasons;
        count = 0;
        handles = ofHandles;
        loads = ofLoads;
        reasons = ofReasons;
    }

    public long bytes() {
        return 8L * handles.length + 4L * loads.length + reasons.length;
    }

    public int count() {
        return count;
    }

    public long joint(int k) {
        return handles[HANDLES * check(k)];
    }

    public long circle(int k) {
        return handles[HANDLES * check(k) + 1];
    }

    public long other(int k) {
        return handles[HANDLES * check(k) + 2];
    }

    public float force(int k) {
        return loads[LOADS * check(k)];
    }

    public float torque(int k) {
        return loads[LOADS * check(k) + 1];
    }

    public int reason(int k) {
        return reasons[check(k)];
    }

    private int check(int k) {
        if (k < 0 || k >= count) {
            throw new IndexOutOfBoundsException("there is no event " + k + " of " + count);
        }
        return k;
    }
}
