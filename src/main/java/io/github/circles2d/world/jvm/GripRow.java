package io.github.circles2d.world.jvm;

/** The table of a contact's grip: where its numbers lie in {@link Contacts#grip}. A contact that does not grip has 0 for the first two. */
final class GripRow {
    /** Floats per contact. */
    static final int STRIDE = 7;

    /** Friction of the pair. */
    static final int FRICTION = 0;

    /** Rolling resistance of the pair by the greater radius. */
    static final int REACH = 1;

    /** Sum of the belt speeds. */
    static final int BELT = 2;

    static final int TANGENT_MASS = 3;
    static final int ROLLING_MASS = 4;

    /** Accumulated, along the tangent. */
    static final int FRICTION_IMPULSE = 5;

    /** Accumulated, angular. */
    static final int ROLLING_IMPULSE = 6;

    private GripRow() {}

    static int of(int contact) {
        return STRIDE * contact;
    }
}
