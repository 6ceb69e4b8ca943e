package io.github.circles2d.world.model;

/**
 * The rows of a contact behind the normal one. A row has an effective mass, a bound and an accumulated impulse. The visit of a contact
 * knows what its rows do, {@link #actingImpulse} whether they act, {@link #impulseAlongNormal}, {@link #tangentImpulse} and
 * {@link #angularImpulse} what they give together; warm starts, copies, caches, snapshots and the hash move the impulses of all rows alike.
 */
public final class ContactRows {
    /** Along the tangent. */
    public static final int FRICTION = 0;

    /** Angular, by rolling resistance. */
    public static final int ROLLING = 1;

    public static final int COUNT = 2;

    /** Floats of a contact: a vector of kernels has room for them. */
    public static final int STRIDE = Integer.highestOneBit(2 * COUNT - 1);

    /** From row to row of a wall. */
    public static final int OF_WALL = 2;

    /** Impulses that a circle keeps of its walls. */
    public static final int OF_WALLS = 2 * COUNT;

    private static final String[] NAMES = {"a friction impulse", "a rolling impulse by radius"};

    private ContactRows() {}

    /** The impulses of a contact. */
    public static int of(int contact) {
        return STRIDE * contact;
    }

    /** The impulses of a circle's walls. */
    public static int ofWalls(int slot) {
        return 2 * STRIDE * slot;
    }

    /** Among those of a circle's walls: the impulse of a row of the nearer wall of an axis. */
    public static int ofWall(int row, int axis) {
        return OF_WALL * row + axis;
    }

    public static void copy(float[] from, int at, float[] to, int toPlace) {
        for (int row = 0; row < COUNT; row++) {
            to[toPlace + row] = from[at + row];
        }
    }

    /** Whether some impulse of a contact is not 0; stride: from row to row. */
    public static boolean any(float[] impulses, int at, int stride) {
        int bits = 0;
        for (int row = 0; row < COUNT; row++) {
            bits |= Float.floatToRawIntBits(impulses[at + stride * row]);
        }
        return bits << 1 != 0; // without a branch for each row, and without the sign of zeros
    }

    /**
     * How hard a contact acts, whatever the direction. If this is greater than 0, it loads its circles, and the next sub-step and step go on from
     * its impulses; else they are forgotten. Of a wall the normal impulse is a magnitude.
     */
    public static float actingImpulse(float normalImpulse, float[] impulses, int at, int stride) {
        return normalImpulse;
    }

    /** What all rows of a contact give along its normal. */
    public static float impulseAlongNormal(float normalImpulse, float[] impulses, int at, int stride) {
        return normalImpulse;
    }

    /** What the rows of a contact give along its tangent. */
    public static float tangentImpulse(float[] impulses, int at, int stride) {
        return impulses[at + stride * FRICTION];
    }

    /** What they give angularly. */
    public static float angularImpulse(float[] impulses, int at, int stride) {
        return impulses[at + stride * ROLLING];
    }

    /** What those of a wall or piece give to a surface speed, by the inverse inertia. */
    public static float spinOfOneBody(float[] impulses, int at, int stride) {
        return angularImpulse(impulses, at, stride) - tangentImpulse(impulses, at, stride);
    }

    public static void clear(float[] impulses, int at, int stride) {
        for (int row = 0; row < COUNT; row++) {
            impulses[at + stride * row] = 0f;
        }
    }

    /** Checks an impulse that a snapshot has of two circles; radius: the lesser one. */
    public static void check(int row, float impulse, float radius) {
        boolean rolls = row == ROLLING;
        float most = rolls ? Limits.CACHED_ROLLING : Limits.CACHED_IMPULSE;
        Limits.within(NAMES[row], rolls ? impulse / radius : impulse, -most, most);
    }
}
