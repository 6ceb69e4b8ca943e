package io.github.circles2d.reference;

/** A joint: what it is, and what it keeps from step to step. */
final class ReferenceJoint {
    enum Linear {
        NONE,
        ALONG,
        POINT,
        DRAG
    }

    enum Angular {
        NONE,
        SPEED,
        ANGLE,
        RIGID
    }

    final int id;
    final long handle;
    final Circle a;

    /** Null if there is an anchor, or nothing. */
    final Circle b;

    /** Of the anchor; null if it is the world's. */
    final Body body;

    /** In the frame of the body, or of the world. */
    float[] anchor;

    int colour;

    // what it is
    Linear linear = Linear.NONE;
    Angular angular = Angular.NONE;
    boolean rigid;
    boolean elastic;
    boolean hasLeast;
    boolean hasGreatest;
    boolean keepsDirection;
    boolean collides;
    float length;
    float leastLength;
    float greatestLength;
    float frequency;
    float damping;
    float mostForce = Float.POSITIVE_INFINITY;
    float mostTorque = Float.POSITIVE_INFINITY;
    float speed;
    float angle;
    float breakForce = Float.POSITIVE_INFINITY;
    float breakTorque = Float.POSITIVE_INFINITY;

    /** From A to B at the reference angles. */
    float[] direction = new float[2];

    int referenceOfA;
    int referenceOfB;

    // the impulses that it has, on B; the angular one on A
    float along;
    float across;
    float least;
    float greatest;
    float turning;

    /** Of the impulses of a step. */
    final float[] sum = new float[2];

    float sumOfTurning;

    ReferenceJoint(int id, long handle, Circle a, Circle b, Body body, float[] anchor) {
        this.id = id;
        this.handle = handle;
        this.a = a;
        this.b = b;
        this.body = body;
        this.anchor = anchor;
    }

    boolean isOf(Circle c) {
        return a == c || b == c;
    }

    /** Whether its spring pushes. */
    boolean isElastic() {
        return elastic || angular == Angular.ANGLE;
    }

    /** Where the anchor is now, in the world. */
    float[] anchorPlace(Arena arena) {
        if (body == null) {
            return anchor;
        }
        double[] at = body.place(anchor);
        float[] place = new float[2];
        for (int axis = 0; axis < 2; axis++) {
            place[axis] = (float) (at[axis] - arena.laps(axis, at[axis]));
        }
        return place;
    }

    /** How the anchor moves in a step; null if it is at rest. */
    AnchorMotion anchorMotion(StepParameters k) {
        return body == null || body.motion == null ? null : body.motionOf(anchor, k);
    }
}
