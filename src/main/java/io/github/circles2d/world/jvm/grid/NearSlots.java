package io.github.circles2d.world.jvm.grid;

import static io.github.circles2d.world.model.CircleRow.X;
import static io.github.circles2d.world.model.CircleRow.Y;

import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.PairRule;
import java.util.Arrays;

/** A list of slots whose circles are near to one: their speculative distances meet. {@code Pairs} lists pairs of several circles. */
public final class NearSlots {
    public int[] slots = new int[64];
    public int count;

    /** Tests the circles of a range of slots against one, which is near to itself. */
    public void scan(State state, Grid grid, int slot, int from, int to) {
        if (slots.length < count + (to - from)) {
            slots = Arrays.copyOf(slots, 2 * (count + (to - from)));
        }
        int[] hits = slots;
        float[] speculativeDistance = grid.speculativeDistance;
        float own = speculativeDistance[slot];
        int many = count;
        if (state.wraps) {
            for (int other = from; other < to; other++) {
                hits[many] = other;
                many -= PairRule.isNear(
                        state.differenceX(slot, other),
                        state.differenceY(slot, other),
                        own,
                        speculativeDistance[other]);
            }
        } else {
            float[] circle = state.circle;
            float x = circle[CircleRow.of(slot) + X];
            float y = circle[CircleRow.of(slot) + Y];
            for (int other = from; other < to; other++) {
                float dx = circle[CircleRow.of(other) + X] - x;
                float dy = circle[CircleRow.of(other) + Y] - y;
                hits[many] = other;
                many -= PairRule.isNear(dx, dy, own, speculativeDistance[other]);
            }
        }
        count = many;
    }

    /** The same of so many slots in an array, from one place on. */
    void test(State state, Grid grid, int slot, int[] others, int from, int length) {
        if (slots.length < count + length) {
            slots = Arrays.copyOf(slots, 2 * (count + length));
        }
        int[] hits = slots;
        float own = grid.speculativeDistance[slot];
        int many = count;
        for (int k = from; k < from + length; k++) {
            int other = others[k];
            hits[many] = other;
            many -= PairRule.isNear(
                    state.differenceX(slot, other),
                    state.differenceY(slot, other),
                    own,
                    grid.speculativeDistance[other]);
        }
        count = many;
    }
}
