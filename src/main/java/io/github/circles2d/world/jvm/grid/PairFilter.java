package io.github.circles2d.world.jvm.grid;

import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.model.JointStep;
import io.github.circles2d.world.model.PairTable;

/**
 * The rule that decides, of two circles that are near, whether they may meet: whether they become a contact, and whether continuous
 * collision looks at them. All that finds pairs asks it. {@code PairFilter.cl} is the same.
 */
public final class PairFilter {
    private PairFilter() {}

    /** Whether the circles of two slots may meet: of two static ones neither moves, and kinds and groups may keep others apart. */
    public static boolean mayMeet(State state, int slot, int other) {
        if (state.isStatic(slot) && state.isStatic(other)) {
            return false;
        }
        if (state.parting != null && areParted(state, state.id[slot], state.id[other])) {
            return false;
        }
        // Pairs that are only sensed end here, too: Sensing finds them.
        return !state.filtering || response(state, state.id[slot], state.id[other]) == PairTable.SOLID;
    }

    /** Whether a joint keeps two circles from colliding. */
    private static boolean areParted(State state, int id, int otherId) {
        JointStep joints = state.parting;
        if (id >= joints.partnered || otherId >= joints.partnered) {
            return false;
        }
        for (int k = joints.partnerStart[id]; k < joints.partnerStart[id + 1]; k++) {
            if (joints.partners[2 * k] == otherId
                    && !state.partingStates.hasBroken(joints.partners[2 * k + 1], joints)) {
                return true;
            }
        }
        return false;
    }

    /** Whether the circles of two slots may be noticed, if their kinds say so: not two static ones unless a kind asks, nor two of one group. */
    public static boolean maySense(State state, int slot, int other, boolean asked) {
        boolean still = state.isStatic(slot) && state.isStatic(other);
        boolean known = asked && !state.isAsleep(slot) && !state.isAsleep(other);
        return (!still || known) && !areOfOneGroup(state, state.id[slot], state.id[other]);
    }

    private static boolean areOfOneGroup(State state, int id, int otherId) {
        int group = state.fields.getInt(CircleField.GROUP, id);
        return group != 0 && group == state.fields.getInt(CircleField.GROUP, otherId);
    }

    /** Whether two circles would meet, if one of them moves. */
    public static boolean wouldMeet(State state, int id, int otherId) {
        if (state.parting != null && areParted(state, id, otherId)) {
            return false;
        }
        return !state.filtering || response(state, id, otherId) == PairTable.SOLID;
    }

    /** Whether two circles would notice each other, if one of them moves. */
    public static boolean wouldNotice(State state, int id, int otherId) {
        return !state.filtering || response(state, id, otherId) != PairTable.IGNORE;
    }

    /** What two circles do to each other, by {@link PairTable}: circles of one group nothing, others what their kinds say. */
    private static int response(State state, int id, int otherId) {
        if (areOfOneGroup(state, id, otherId)) {
            return PairTable.IGNORE;
        }
        int kind = state.fields.getInt(CircleField.KIND, id);
        return PairTable.get(state.responses, kind, state.fields.getInt(CircleField.KIND, otherId));
    }
}
