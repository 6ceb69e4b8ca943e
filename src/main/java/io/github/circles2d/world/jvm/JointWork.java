package io.github.circles2d.world.jvm;

/** The numbers of a joint within a step on the JVM, by its place in the order. */
final class JointWork {
    static final int STRIDE = 12;

    static final int BASE_X = 0; // from the base of A to that of B, or to the anchor
    static final int BASE_Y = 1;
    static final int NORMAL_X = 2; // from A to B, as measured last
    static final int NORMAL_Y = 3;
    static final int DISTANCE = 4;
    static final int INV_MASS_A = 5;
    static final int INV_MASS_B = 6;
    static final int INV_INERTIA_A = 7; // what a surface speed gains by an impulse along the surface
    static final int INV_INERTIA_B = 8;
    static final int SHARE_A = 9; // by how much a circle counts as lighter; 1 unless the joint is split
    static final int SHARE_B = 10;
    static final int DIRECTION = 11; // how far B is off the direction that it should have, by length

    /** Ints of a joint. */
    static final int SLOTS = 2;

    // slots
    static final int A = 0; // or NONE, if the joint does nothing in this step
    static final int B = 1; // or NONE

    static final int NONE = -1;

    private JointWork() {}

    static int of(int place) {
        return STRIDE * place;
    }

    static int slots(int place) {
        return SLOTS * place;
    }
}
