package io.github.circles2d.world.model;

/** What a pipeline must be ready for; worlds that do without pay nothing. */
public record Features(
        boolean edges,
        boolean turning,
        boolean terrain,
        boolean joints,
        boolean sleeping,
        boolean ownMotion,
        boolean bodies) {
    /** All that there are: to make one in each restored frame would be garbage. */
    private static final Features[] ALL = new Features[128];

    static {
        for (int bits = 0; bits < ALL.length; bits++) {
            ALL[bits] = new Features(
                    (bits & 1) != 0,
                    (bits & 2) != 0,
                    (bits & 4) != 0,
                    (bits & 8) != 0,
                    (bits & 16) != 0,
                    (bits & 32) != 0,
                    (bits & 64) != 0);
        }
    }

    /** A walled world of circles that neither turn nor sleep. */
    public static final Features NONE = ALL[0];

    /** What circles need that never sleep, and move as their kinds say. */
    public Features(boolean edges, boolean turning, boolean terrain, boolean joints) {
        this(edges, turning, terrain, joints, false, false, false);
    }

    /** Always the same object for the same values, of circles that move as their kinds say. */
    public static Features of(boolean edges, boolean turning, boolean terrain, boolean joints, boolean sleeping) {
        return of(edges, turning, terrain, joints, sleeping, false);
    }

    /** Always the same object for the same values, of a world without bodies that are pushed. */
    public static Features of(
            boolean edges, boolean turning, boolean terrain, boolean joints, boolean sleeping, boolean ownMotion) {
        return of(edges, turning, terrain, joints, sleeping, ownMotion, false);
    }

    /** Always the same object for the same values. */
    public static Features of(
            boolean edges,
            boolean turning,
            boolean terrain,
            boolean joints,
            boolean sleeping,
            boolean ownMotion,
            boolean bodies) {
        return ALL[
                (edges ? 1 : 0)
                        | (turning ? 2 : 0)
                        | (terrain ? 4 : 0)
                        | (joints ? 8 : 0)
                        | (sleeping ? 16 : 0)
                        | (ownMotion ? 32 : 0)
                        | (bodies ? 64 : 0)];
    }

    /** Both together. */
    public Features and(Features other) {
        return of(
                edges || other.edges,
                turning || other.turning,
                terrain || other.terrain,
                joints || other.joints,
                sleeping || other.sleeping,
                ownMotion || other.ownMotion,
                bodies || other.bodies);
    }
}
