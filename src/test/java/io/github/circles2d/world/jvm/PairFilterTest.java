package io.github.circles2d.world.jvm;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.scenes.Scenes;
import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.KindTable;
import io.github.circles2d.world.jvm.grid.PairFilter;
import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.model.PairTable;
import org.junit.jupiter.api.Test;

class PairFilterTest {
    /** By circle: whether it is static, its kind, its group. Kinds 0 and 1 ignore each other; kinds 1 and 2 sense each other. */
    private static final int[][] CIRCLES = {
        {0, 0, 0}, {0, 0, 7}, {0, 1, 7}, {0, 1, 0}, {0, 2, -7}, {0, 2, -7}, {1, 0, 0}, {1, 2, 7}
    };

    /** By row and column, whether two of them may meet. */
    private static final String[] MEET = {
        "-1001111", "1-001110", "00-10000", "001-0000", "1100-011", "11000-11", "110011-0", "1000110-"
    };

    @Test
    void groupsAndKindsDecideAndStaticCirclesNeverMeet() {
        try (JvmWorld world = new JvmWorld(Scenes.thesis(CIRCLES.length, 1), 1)) {
            long[] handles = world.handles();
            for (int k = 0; k < CIRCLES.length; k++) {
                if (CIRCLES[k][0] == 1) {
                    world.simulation.circles.set(Commands.MASS, handles[k], Float.POSITIVE_INFINITY, 0);
                }
                world.simulation.circles.setKind(handles[k], CIRCLES[k][1]);
                world.simulation.fields.set(CircleField.GROUP, handles[k], CIRCLES[k][2]);
            }
            world.simulation.kinds.setSetting(0, 1, KindTable.RESPONSE + PairTable.IGNORE);
            world.simulation.kinds.setSetting(2, 1, KindTable.RESPONSE + PairTable.SENSE);
            world.step(1);
            State state = world.pipeline.state;
            for (int a = 0; a < CIRCLES.length; a++) {
                for (int b = 0; b < CIRCLES.length; b++) {
                    if (a != b) {
                        assertThat(PairFilter.mayMeet(state, state.slotOf[a], state.slotOf[b]))
                                .as("circles %d and %d", a, b)
                                .isEqualTo(MEET[a].charAt(b) == '1');
                    }
                }
            }
        }
    }
}
