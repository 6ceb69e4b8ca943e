package io.github.circles2d.world.jvm.joints;

/** The numbers of a joint within a step on the JVM, by its place in the order. */
final class JointWork {
    static final int STRIDE = 16;

    static final int BASE_X = 0; // from the base of A to that of B, or to the anchor
    static final int BASE_Y = 1;
    static final int NORMAL_X = 2; // from A to B, as measured last
    static final int NORMAL_Y = 3;
    static final int DISTANCE = 4;
    static final int INV_MASS_A = 5; // also of one that sleeps
    static final int INV_MASS_B = 6;
    static final int INV_INERTIA_A = 7; // what a surface speed gains by an impulse along the surface
    static final int INV_INERTIA_B = 8;
    static final int SHARE_A = 9; // by how much a circle counts as lighter; 1 unless the joint is split
    static final int SHARE_B = 10;
    static final int DIRECTION = 11; // how far B is off the direction that it should have, by length
    static final int PUSH = 12; // the greatest speed by which it corrects where its ends are

    // of a plain spring, in place of the words from INV_INERTIA_A on
    static final int LENGTH = 7;
    static final int MASS = 8; // effective
    static final int NOW = 9; // of its JointSpring
    static final int BEGUN = 10;
    static final int WAY = 11;
    static final int SUM_X = 12; // of its impulses in the step
    static final int SUM_Y = 13;

    /** Ints of a joint. */
    static final int SLOTS = 4;

    // slots
    static final int A = 0; // or NONE, if the joint does nothing in this step
    static final int B = 1; // or NONE
    static final int KIND = 2; // how it is visited
    static final int STILL = 3; // STILL_A and STILL_B: which of them sleeps, and gets nothing

    static final int NONE = -1;

    // KIND
    static final int BOTH = 0; // with bias, and without
    static final int ALONE = 1; // an exact spring alone, which is visited with bias only
    static final int PLAIN = 2; // the same along the line between two circles, not split

    // STILL
    static final int STILL_A = 1;
    static final int STILL_B = 2;

    private JointWork() {}

    static int of(int place) {
        return STRIDE * place;
    }

    static int slots(int place) {
        return SLOTS * place;
    }
}
