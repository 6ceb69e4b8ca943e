package io.github.circles2d.world.model;

/** What a pipeline must be ready for; worlds that do without pay nothing. The same features are always the same object. */
public final class Features {
    /** All that there are: to make one in each restored frame would be garbage. */
    private static final Features[] ALL = new Features[128];

    static {
        for (int bits = 0; bits < ALL.length; bits++) {
            ALL[bits] = new Features(bits);
        }
    }

    /** A walled world of circles that neither turn nor sleep, and move as their kinds say. */
    public static final Features NONE = ALL[0];

    public static final Features EDGES = ALL[1];
    public static final Features TURNING = ALL[2];
    public static final Features TERRAIN = ALL[4];
    public static final Features JOINTS = ALL[8];
    public static final Features SLEEPING = ALL[16];
    public static final Features OWN_MOTION = ALL[32];

    /** Bodies that are pushed. */
    public static final Features BODIES = ALL[64];

    private final int bits;

    private Features(int bits) {
        this.bits = bits;
    }

    /** Both together. */
    public Features and(Features other) {
        return ALL[bits | other.bits];
    }

    /** These if a condition holds, else none. */
    public Features when(boolean holds) {
        return holds ? this : NONE;
    }

    /** Whether all of others are among these. */
    public boolean have(Features others) {
        return (bits & others.bits) == others.bits;
    }

    public boolean edges() {
        return have(EDGES);
    }

    public boolean turning() {
        return have(TURNING);
    }

    public boolean terrain() {
        return have(TERRAIN);
    }

    public boolean joints() {
        return have(JOINTS);
    }

    public boolean sleeping() {
        return have(SLEEPING);
    }

    public boolean ownMotion() {
        return have(OWN_MOTION);
    }

    public boolean bodies() {
        return have(BODIES);
    }
}
