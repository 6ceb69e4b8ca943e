package io.github.circles2d.world.model;

/**
 * The rows behind the normal one of a contact with a wall or a terrain piece, as {@link OneBody} is its visit; it leaves its results in the
 * fields. Impulses are speeds. B is the circle; t is the normal, which points to the circle, rotated 90 degrees anticlockwise.
 */
public final class OneBodyRows {
    /** Floats that {@link #keep} stores. */
    public static final int KEPT = 4;

    // the surfaces: friction, rolling resistance, the sum of the belt speeds along t, and KindSurface.INERTIA
    private float friction;
    private float resistance;
    private float belt;
    private float inertia;

    /** By row. */
    private final float[] impulses = new float[ContactRows.COUNT];

    /** Of the circle: to be set before, and found after. */
    public float surfaceSpeed;

    // what the rows have given to the circle's velocity along t
    private float gain;

    /** Takes the surfaces of a circle and of a kind or wall, rows of {@link KindSurface}; sumOfBelts: along t. */
    public void between(
            float[] ofCircles,
            int circle,
            float[] others,
            int other,
            float sumOfBelts,
            float inverseInertia,
            float inverseMass) {
        friction = Surface.friction(ofCircles[circle + KindSurface.FRICTION], others[other + KindSurface.FRICTION]);
        resistance = CircleMath.max(
                ofCircles[circle + KindSurface.ROLLING_RESISTANCE], others[other + KindSurface.ROLLING_RESISTANCE]);
        belt = sumOfBelts;
        inertia = inverseInertia / inverseMass;
    }

    /** Stores the surfaces, for {@link #recall}. */
    public void keep(float[] to, int at) {
        to[at] = friction;
        to[at + 1] = resistance;
        to[at + 2] = belt;
        to[at + 3] = inertia;
    }

    public void recall(float[] from, int at) {
        friction = from[at];
        resistance = from[at + 1];
        belt = from[at + 2];
        inertia = from[at + 3];
    }

    /** Takes the accumulated impulses; stride: from row to row. */
    public void take(float[] from, int at, int stride) {
        for (int row = 0; row < ContactRows.COUNT; row++) {
            impulses[row] = from[at + stride * row];
        }
    }

    public void give(float[] to, int at, int stride) {
        for (int row = 0; row < ContactRows.COUNT; row++) {
            to[at + stride * row] = impulses[row];
        }
    }

    /** Adds to a velocity what {@link #warmStart} or {@link #visit} has given. */
    public void push(float[] velocities, int at, float nx, float ny) {
        velocities[at] += -1f * ny * gain;
        velocities[at + 1] += nx * gain;
    }

    /** The same at a wall, whose normal has no other part. */
    public void pushAtWall(float[] velocities, int at, int axis, float side) {
        velocities[at + 1 - axis] += Walls.tangentAlong(axis, side) * gain;
    }

    /** Whether some row does something. */
    public boolean act() {
        return friction > 0f || resistance > 0f;
    }

    /** How fast the surfaces slide, if they have friction; along: the circle's speed along t, spin: its surface speed. */
    public float slip(float along, float spin) {
        return Surface.hitSlip(friction, along, 0f, spin, belt);
    }

    /** Before the visits of a sub-step: what is accumulated acts again, unless the surfaces have changed. */
    public void warmStart() {
        float along = friction > 0f ? impulses[ContactRows.FRICTION] : 0f;
        float rolling = resistance > 0f && inertia > 0f ? impulses[ContactRows.ROLLING] : 0f;
        impulses[ContactRows.FRICTION] = along;
        impulses[ContactRows.ROLLING] = rolling;
        gain = ContactRows.tangentImpulse(impulses, 0, 1);
        surfaceSpeed += inertia * ContactRows.spinOfOneBody(impulses, 0, 1);
    }

    /** Behind the visit of the normal impulse; along: the circle's speed along t, against the other's surface; bounce: target speed. */
    public void visit(OneBody normal, float along, float bounce) {
        float normalImpulse = normal.boundingImpulse();
        boolean keep = normal.keepsRows(bounce);
        gain = 0f;
        if (resistance > 0f && inertia > 0f) {
            float before = impulses[ContactRows.ROLLING];
            float next = Surface.rolling(before, 1f / inertia, surfaceSpeed, resistance * normalImpulse);
            surfaceSpeed += inertia * (next - before);
            impulses[ContactRows.ROLLING] = keep ? next : 0f;
        }
        if (friction > 0f) {
            float before = impulses[ContactRows.FRICTION];
            float slip = Surface.slip(along, 0f, surfaceSpeed, belt);
            float mass = Surface.tangentMass(0f, 0f, 1f, inertia, 1f);
            float next = Surface.grip(before, mass, slip, friction * normalImpulse);
            gain = next - before;
            surfaceSpeed += inertia * -gain;
            impulses[ContactRows.FRICTION] = keep ? next : 0f;
        }
    }
}
