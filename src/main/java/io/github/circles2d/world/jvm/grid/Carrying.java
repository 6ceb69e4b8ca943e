package io.github.circles2d.world.jvm.grid;

import static io.github.circles2d.world.model.CircleRow.RADIUS;
import static io.github.circles2d.world.model.CircleRow.X;
import static io.github.circles2d.world.model.CircleRow.Y;

import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.jvm.threads.SharedInts;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.PairRule;
import io.github.circles2d.world.model.Paths;
import io.github.circles2d.world.model.TimeOfImpact;
import io.github.circles2d.world.model.Tuning;

/**
 * Static circles that move take along what they come upon, so that they pass through nothing. Continuous collision has told
 * before how far each circle goes if it meets none of them; it waits there for the rest of the step. The static circle that
 * touches it first, on its way or while it waits, moves it as it moves itself from then on. A slow one leaves this to their
 * contact if they have one. A circle that flies ahead of a fast one keeps to its path, whatever it meets: if something held it up
 * in the step, the static circle would come upon it unseen. What it meets changes its velocity alone.
 *
 * <p>Circles that are carried stop at nothing, so a crowd in the way of a fast static circle is pressed into each other.
 */
final class Carrying {
    private static final float NEVER = 2f;
    private static final int NOBODY = Integer.MAX_VALUE;

    private final State state;
    private final Grid grid;

    /** By slot: the share of the step after which a static circle carries it, as the bits of a float, which sort like the float. */
    private int[] carryTime = new int[0];

    /** By slot: that static circle, of several the first; {@link #NOBODY}. */
    private int[] carrier = new int[0];

    Carrying(State state, Grid grid) {
        this.state = state;
        this.grid = grid;
    }

    void ensure() {
        if (carryTime.length < state.capacity()) {
            carrier = new int[state.capacity()];
            carryTime = new int[state.capacity()];
        }
    }

    long bytes() {
        return 8L * carryTime.length;
    }

    void start(int slot) {
        carryTime[slot] = Float.floatToRawIntBits(NEVER);
        carrier[slot] = NOBODY;
    }

    /** Whether a static circle moves so far in the step that it pushes one of a radius along. */
    boolean pushes(int slot, float r) {
        return Paths.isFast(grid.path[slot], r);
    }

    /** When a static circle takes another along, which goes a free share of its path; the second time, to note the first carrier. */
    void meet(int slot, int other, float free, boolean note) {
        int s = CircleRow.of(slot);
        int o = CircleRow.of(other);
        float r = state.circle[s + RADIUS];
        float ro = state.circle[o + RADIUS];
        float px = state.plan[CircleRow.vector(slot) + X];
        float py = state.plan[CircleRow.vector(slot) + Y];
        float pxo = state.plan[CircleRow.vector(other) + X];
        float pyo = state.plan[CircleRow.vector(other) + Y];
        float dx = state.differenceX(slot, other);
        float dy = state.differenceY(slot, other);
        float t = TimeOfImpact.timeOfCarry(dx, dy, px, py, pxo, pyo, free, ro, r + ro);
        boolean carries = pushes(slot, ro) ? t <= 1f : t < 1f && !contactHas(slot, other, dx, dy, px - pxo, py - pyo);
        if (!carries) {
            return;
        }
        if (!note) {
            lower(carryTime, other, Float.floatToRawIntBits(t));
        } else if (carryTime[other] == Float.floatToRawIntBits(t)) {
            lower(carrier, other, slot);
        }
    }

    /** Whether two circles are so close, or move so little against each other, that their contact in this step suffices. */
    private boolean contactHas(int slot, int other, float dx, float dy, float ux, float uy) {
        float r = state.circle[CircleRow.of(slot) + RADIUS];
        float ro = state.circle[CircleRow.of(other) + RADIUS];
        return PairRule.isNear(dx, dy, r + Tuning.MARGIN * r, ro + Tuning.MARGIN * ro) != 0
                || PairRule.isNear(dx, dy, grid.speculativeDistance[slot], grid.speculativeDistance[other]) != 0
                        && !CircleMath.isLonger(ux, uy, (0.5f * Tuning.CAP) * (r + ro));
    }

    private static void lower(int[] values, int slot, int value) {
        int seen = values[slot];
        while (value < seen && !SharedInts.compareAndSet(values, slot, seen, value)) {
            seen = SharedInts.get(values, slot);
        }
    }

    boolean isCarried(int slot) {
        return carrier[slot] != NOBODY;
    }

    /** The share of the step after which a circle is carried; more than 1 if it is not. */
    float time(int slot) {
        return Float.intBitsToFloat(carryTime[slot]);
    }

    /** How far a circle that is carried is moved along x. */
    float x(int slot) {
        return (1f - time(slot)) * state.plan[CircleRow.vector(carrier[slot]) + X];
    }

    /** How far a circle that is carried is moved along y. */
    float y(int slot) {
        return (1f - time(slot)) * state.plan[CircleRow.vector(carrier[slot]) + Y];
    }

    /** The allowance of a circle that is carried. */
    float allowance(int slot) {
        return pushes(carrier[slot], state.circle[CircleRow.of(slot) + RADIUS]) ? Tuning.CARRIED : 0f;
    }
}
