package io.github.circles2d.world.joints;

import java.util.Arrays;

/** Joints that have gone by themselves, in order, until somebody takes them. */
public final class GoneJoints {
    // reasons
    public static final int BROKEN = 0;
    public static final int CIRCLE_REMOVED = 1;
    public static final int BODY_REMOVED = 2;

    private int count;

    private long[] joint = new long[0];
    private long[] circle = new long[0];
    private long[] other = new long[0];
    private float[] force = new float[0];
    private float[] torque = new float[0];
    private byte[] reason = new byte[0];

    public GoneJoints() {}

    /** Makes room for more. If there is none, nothing has changed. */
    void ensure(int more) {
        int needed = count + more;
        if (needed > reason.length) {
            // All arrays are made before one is assigned: a growth that fails changes nothing.
            int c = Math.max(needed, reason.length + (reason.length >> 1));
            long[] newJoint = Arrays.copyOf(joint, c);
            long[] newCircle = Arrays.copyOf(circle, c);
            long[] newOther = Arrays.copyOf(other, c);
            float[] newForce = Arrays.copyOf(force, c);
            float[] newTorque = Arrays.copyOf(torque, c);
            byte[] newReason = Arrays.copyOf(reason, c);
            joint = newJoint;
            circle = newCircle;
            other = newOther;
            force = newForce;
            torque = newTorque;
            reason = newReason;
        }
    }

    /** There is room. */
    void add(long itsJoint, long itsCircle, long itsOther, int itsReason) {
        joint[count] = itsJoint;
        circle[count] = itsCircle;
        other[count] = itsOther;
        force[count] = 0f;
        torque[count] = 0f;
        reason[count++] = (byte) itsReason;
    }

    /** By what the one that was added last has broken. */
    void setLoad(float itsForce, float itsTorque) {
        force[count - 1] = itsForce;
        torque[count - 1] = itsTorque;
    }

    public void clear() {
        count = 0;
    }

    /** Gives all away, in place of what there is. */
    public void moveTo(GoneJoints to) {
        long[] joints = to.joint;
        long[] circles = to.circle;
        long[] others = to.other;
        float[] forces = to.force;
        float[] torques = to.torque;
        byte[] reasons = to.reason;
        to.count = count;
        to.joint = joint;
        to.circle = circle;
        to.other = other;
        to.force = force;
        to.torque = torque;
        to.reason = reason;
        count = 0;
        joint = joints;
        circle = circles;
        other = others;
        force = forces;
        torque = torques;
        reason = reasons;
    }

    /** Memory of the arrays. */
    public long bytes() {
        return 8L * (joint.length + circle.length + other.length) + 4L * (force.length + torque.length) + reason.length;
    }

    public int count() {
        return count;
    }

    public long joint(int k) {
        return joint[check(k)];
    }

    public long circle(int k) {
        return circle[check(k)];
    }

    public long other(int k) {
        return other[check(k)];
    }

    public float force(int k) {
        return force[check(k)];
    }

    public float torque(int k) {
        return torque[check(k)];
    }

    public int reason(int k) {
        return reason[check(k)];
    }

    private int check(int k) {
        if (k < 0 || k >= count) {
            throw new IndexOutOfBoundsException("there is no event " + k + " of " + count);
        }
        return k;
    }
}
