package io.github.circles2d.world.changes;

import io.github.circles2d.world.joints.JointForm;
import io.github.circles2d.world.model.CircleRow;

/**
 * Circles that are to come, at rest and of one kind, and the joints that are to hold them. An end of a joint is one of these circles, by its
 * number, or one that is in the world already, by its handle.
 */
public final class Net {
    // what the second end of a joint is
    static final int NEW_CIRCLE = 0;
    static final int CIRCLE = 1;
    static final int PLACE = 2;

    private static final int FIRST_IS_THERE = 4;
    private static final int SECOND = 3;

    /** As a call that adds circles takes them. */
    final float[] circles;

    final int kind;

    private int joints;
    private final JointForm[] forms;
    private final byte[] ends;
    private final long[] first;
    private final long[] second;
    private final float[] x;
    private final float[] y;

    /** Circles without joints, and room for so many of these. */
    public Net(float[] circles, int kind, int joints) {
        this.circles = circles;
        this.kind = kind;
        forms = new JointForm[joints];
        ends = new byte[joints];
        first = new long[joints];
        second = new long[joints];
        x = new float[joints];
        y = new float[joints];
    }

    /** Joins two circles that are to come. */
    public Net join(JointForm form, int one, int other) {
        return put(form, NEW_CIRCLE, one, other);
    }

    /** Joins a circle that is there to one that is to come. */
    public Net joinTo(JointForm form, long there, int other) {
        return put(form, FIRST_IS_THERE | NEW_CIRCLE, there, other);
    }

    /** Joins two circles that are there. */
    public Net joinThere(JointForm form, long one, long other) {
        return put(form, FIRST_IS_THERE | CIRCLE, one, other);
    }

    /** Joins a circle that is to come to a place of a body. */
    public Net anchor(JointForm form, int circle, long body, float x, float y) {
        return place(put(form, PLACE, circle, body), x, y);
    }

    /** Joins a circle that is there to a place of a body. */
    public Net anchorThere(JointForm form, long circle, long body, float x, float y) {
        return place(put(form, FIRST_IS_THERE | PLACE, circle, body), x, y);
    }

    private Net put(JointForm form, int of, long one, long other) {
        forms[joints] = form;
        ends[joints] = (byte) of;
        first[joints] = one;
        second[joints] = other;
        joints++;
        return this;
    }

    private Net place(Net net, float placeX, float placeY) {
        x[joints - 1] = placeX;
        y[joints - 1] = placeY;
        return net;
    }

    /** The number of its circles. */
    public int size() {
        return circles.length / CircleRow.STRIDE;
    }

    /** The number of its joints. */
    public int joints() {
        return joints;
    }

    JointForm form(int joint) {
        return forms[joint];
    }

    /** Whether the first end is in the world already. */
    boolean firstIsThere(int joint) {
        return (ends[joint] & FIRST_IS_THERE) != 0;
    }

    /** {@link #NEW_CIRCLE}, {@link #CIRCLE} or {@link #PLACE}. */
    int second(int joint) {
        return ends[joint] & SECOND;
    }

    /** The number or the handle of the first end. */
    long firstEnd(int joint) {
        return first[joint];
    }

    /** The number or the handle of the second end, or the handle of its body. */
    long secondEnd(int joint) {
        return second[joint];
    }

    float placeX(int joint) {
        return x[joint];
    }

    float placeY(int joint) {
        return y[joint];
    }
}
