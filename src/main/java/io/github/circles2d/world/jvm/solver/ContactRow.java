package io.github.circles2d.world.jvm.solver;

/**
 * The table of a contact: where its numbers lie in the arrays of {@link Contacts}. A is the circle of the lower id, B the other.
 * The inverse masses of a cross contact are those of the light circle and of the heavy one.
 */
final class ContactRow {
    /** Floats per contact. */
    static final int STRIDE = 14;

    /** Elements per contact of {@link Contacts#pair}. */
    static final int PAIR_STRIDE = 2;

    /** Difference of the bases, x. */
    static final int BASE_X = 0;

    static final int BASE_Y = 1;

    /** Sum of the radii. */
    static final int RADII = 2;

    static final int RESTITUTION = 3;
    static final int INV_MASS_A = 4;
    static final int INV_MASS_B = 5;

    /** Square of the speed; see {@link io.github.circles2d.world.model.Bounce#flightThreshold}. */
    static final int FLIGHT_THRESHOLD = 6;

    static final int NORMAL_X = 7;
    static final int NORMAL_Y = 8;
    static final int SEPARATION = 9;

    /** Accumulated. */
    static final int NORMAL_IMPULSE = 10;

    /** Target speed of a bounce, between the two passes of a sub-step. */
    static final int BOUNCE_SPEED = 11;

    /** Effective mass; that of a cross contact counts the heavy circle as lighter. */
    static final int MASS = 12;

    /** Square of the speed. */
    static final int RESTITUTION_THRESHOLD = 13;

    private ContactRow() {}

    static int of(int contact) {
        return STRIDE * contact;
    }

    /** Where the circle of the lower id stands in {@link Contacts#pair}. */
    static int a(int contact) {
        return PAIR_STRIDE * contact;
    }

    /** Where the circle of the higher id stands in {@link Contacts#pair}. */
    static int b(int contact) {
        return PAIR_STRIDE * contact + 1;
    }
}
