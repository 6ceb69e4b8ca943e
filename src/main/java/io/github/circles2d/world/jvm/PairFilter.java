package io.github.circles2d.world.jvm;

/**
 * The rule that decides, of two circles that are near, whether they may meet: whether they become a contact, and whether continuous
 * collision looks at them. All that finds pairs asks it. {@code PairFilter.cl} is the same.
 */
final class PairFilter {
    private PairFilter() {}

    /** Whether the circles of two slots may meet: of two static ones neither moves. */
    static boolean mayMeet(State state, int slot, int other) {
        return !(state.isStatic(slot) && state.isStatic(other));
    }
}
