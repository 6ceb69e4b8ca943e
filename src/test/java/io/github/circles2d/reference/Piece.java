package io.github.circles2d.reference;

import static io.github.circles2d.reference.Numbers.dot;
import static io.github.circles2d.reference.Numbers.length;
import static io.github.circles2d.reference.Numbers.minus;

/**
 * A piece of terrain. Its form is in the frame of its body; the numbers that a step needs are in the world, as the step begins. An o is a
 * place against the origin of the piece, in the frame in which its body stands at the start of the step.
 */
abstract class Piece {
    static final float GRAZE = 0.01f;
    private static final long PIECE = 0x7069656365733264L;

    /** What there is at an end. */
    enum Joint {
        FREE,
        CONVEX,
        CONCAVE
    }

    /** What of a piece a circle is at. */
    enum Feature {
        NONE,
        FACE,
        START,
        END
    }

    /**
     * Where a circle stands.
     *
     * @param height of its centre over the front
     */
    record Stand(Feature feature, float[] normal, float gap, float curve, float height) {}

    final int id;
    final long handle;
    final Body body;
    int kind;
    int serial;

    /** The neighbours in a chain, or null. */
    Piece before;

    Piece after;
    Joint startJoint = Joint.FREE;
    Joint endJoint = Joint.FREE;

    // in the world, as a step begins
    /** Start of a line, centre of an arc. */
    final float[] origin = new float[2];

    /** Direction of a line, from its start to its end; direction of the middle of an arc, from its centre. */
    final float[] t = new float[2];

    /** Of a line; the radius of an arc. */
    float size;

    final float[] start = new float[2];
    final float[] end = new float[2];

    /** Where the next piece of a chain leaves the end. */
    final float[] next = new float[2];

    final float[] middle = new float[2];

    /** Of its box around the middle. */
    final float[] halfExtent = new float[2];

    /** What the body turns around, against the origin. */
    final float[] pivot = new float[2];

    /** How far a point of it moves at most in the step. */
    float most;

    Piece(int id, long handle, Body body, int kind) {
        this.id = id;
        this.handle = handle;
        this.body = body;
        this.kind = kind;
    }

    /** The radius around it. */
    float thickness() {
        return 0f;
    }

    /** Whether circles may be on both sides. */
    boolean hasTwoSides() {
        return false;
    }

    /** Finds the numbers of the step. */
    final void place(Arena arena) {
        placeForm(arena);
        double[] leaves = after == null ? new double[2] : after.startDirection();
        double[] turned = body.turned(leaves);
        next[0] = (float) turned[0];
        next[1] = (float) turned[1];
    }

    abstract void placeForm(Arena arena);

    /** By form, and its numbers in the frame of the body. */
    abstract int shape();

    abstract int half();

    abstract float[] numbers();

    final long hash() {
        long h = ReferenceWorld.absorb(ReferenceWorld.absorb(PIECE, id), shape());
        h = ReferenceWorld.absorb(ReferenceWorld.absorb(h, kind), body.id);
        h = ReferenceWorld.absorb(ReferenceWorld.absorb(h, after == null ? -1 : after.id), half());
        return ReferenceWorld.absorb(h, numbers());
    }

    /** In the frame of the body. */
    abstract double[] startDirection();

    abstract double[] endDirection();

    /** From the pivot of the body; no point of it is farther. */
    abstract double farthest();

    abstract Stand measure(float[] o, float r, float side);

    abstract boolean isInFrontOfFace(float[] o);

    /** Whether a place is beyond the end, not the start. */
    abstract boolean isBeyondEnd(float[] o);

    /** Whether it is in front of the piece, or at the tip of it and the next one in front of that. */
    final boolean isInFront(float[] o) {
        if (isInFrontOfFace(o) || !isBeyondEnd(o) || endJoint != Joint.CONVEX) {
            return isInFrontOfFace(o);
        }
        float[] e = minus(o, end);
        return e[0] * next[1] - e[1] * next[0] >= 0f;
    }

    /** From a place to the nearest point. */
    abstract float distance(float[] o);

    /** Whether the face hides a vertex from a circle: hardly higher, between its ends, but not at the end that the circle is beyond. */
    abstract boolean covers(float[] o, float side, float[] vertex, float thicknessOfVertex, float slack, float step);

    /** Of the coordinates of terrain. */
    final float rounding() {
        return 0x1p-22f * (Math.abs(origin[0]) + Math.abs(origin[1]));
    }

    /** After which share of its motion u a circle touches the face; 2 if it does not. */
    abstract float timeOfFace(float[] o, float[] u, float r, float side);

    /** The same of an end; a concave one is not touched. */
    final float timeOfEnd(boolean first, float[] o, float[] u, float r) {
        float[] vertex = first ? start : end;
        return joint(first) == Joint.CONCAVE
                ? 2f
                : ContinuousCollision.timeOfImpact(minus(vertex, o), u, r + thickness());
    }

    /** After which share of its motion a circle touches the face, from any side; 2 if it does not. */
    abstract float timeOfNoticedFace(float[] o, float[] u, float r);

    /** Gives a thing its lines and corners, against what the piece turns around. */
    abstract void addTo(RigidThing t, float[] around);

    /** A corner at an end, with a normal on both sides of it; an end at a joint has one only where a convex one ends. */
    final void addEnd(RigidThing t, boolean atStart, float[] around, float r, float[] normal) {
        float[] at = minus(atStart ? start : end, around);
        float nx = normal[0];
        float ny = normal[1];
        if (joint(atStart) == Joint.FREE && atStart) {
            t.addCorner(at[0], at[1], r, -nx, -ny, nx, ny);
        } else if (joint(atStart) == Joint.FREE) {
            t.addCorner(at[0], at[1], r, nx, ny, -nx, -ny);
        } else if (joint(atStart) == Joint.CONVEX && !atStart) {
            t.addCorner(at[0], at[1], r, nx, ny, next[1], -next[0]);
        }
    }

    boolean isArc() {
        return false;
    }

    /** Of an arc, whether it is solid outside. */
    boolean isHollow() {
        return false;
    }

    boolean isCircle() {
        return false;
    }

    /** The same of the whole piece, joints among it. */
    final float timeOfNotice(float[] o, float[] u, float r) {
        if (distance(o) <= r) {
            return 0f;
        }
        float time = timeOfNoticedFace(o, u, r);
        if (isCircle()) {
            return time;
        }
        float reach = r + thickness();
        float first = ContinuousCollision.timeOfTouch(minus(start, o), u, reach);
        float last = ContinuousCollision.timeOfTouch(minus(end, o), u, reach);
        return Numbers.min(Numbers.min(first, last), time);
    }

    /** When a circle from behind touches the face from its front; 2 if it does not. */
    float timeOfReturn(float[] o, float[] u, float r) {
        return 2f;
    }

    final Joint joint(boolean atStart) {
        return atStart ? startJoint : endJoint;
    }

    /** Beyond an end. The normal of a centre in the end itself is given. */
    final Stand atVertex(boolean atStart, float[] o, float reach, float[] central, float height) {
        float[] e = minus(o, atStart ? start : end);
        float d = length(e);
        float[] normal = d == 0f ? central : new float[] {e[0] / d, e[1] / d};
        boolean claims =
                switch (joint(atStart)) {
                    case FREE -> true;
                    case CONVEX -> !atStart && dot(e, next) < 0f;
                    case CONCAVE -> false;
                };
        Feature feature = !claims ? Feature.NONE : atStart ? Feature.START : Feature.END;
        return new Stand(feature, normal, d - reach, d == 0f ? 0f : -1f / d, height);
    }
}
