package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import java.util.Arrays;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Steps on a machine with as many other busy threads as processors. */
@Timeout(120)
class BusyMachineTest {
    private static final int ROUNDS = 5;
    private static final double FACTOR = 20;

    private static final int PROCESSORS = Runtime.getRuntime().availableProcessors();
    private static final Scene SCENE = Scenes.packed(1250, 1);

    private static World world() {
        return WorldScenes.world(SCENE, WorldScenes.builder(SCENE).backend(Backend.JVM));
    }

    @Test
    void stepsBesideBusyThreadsHaveTheSameBits() {
        BusyMachine.Others others = new BusyMachine.Others(PROCESSORS);
        try (World expected = world();
                World world = world()) {
            expected.step(SCENE.timeStep(), 40);
            for (int step = 0; step < 20; step++) {
                world.step(SCENE.timeStep());
                world.positions();
            }
            world.step(SCENE.timeStep(), 20);
            assertThat(world.hash()).isEqualTo(expected.hash());
        } finally {
            others.stop();
        }
    }

    /**
     * This measures time, so it asks only that steps are not tens of times as long, in the middle one of several rounds: threads
     * that wait in a wrong way make them a hundred times as long.
     */
    @Test
    @Tag("exhaustive")
    void stepsBesideBusyThreadsTakeFewTimesAsLong() {
        double[] factors = new double[ROUNDS];
        try (World world = world()) {
            BusyMachine.round(world, SCENE.timeStep(), 0);
            for (int round = 0; round < ROUNDS; round++) {
                double idle = BusyMachine.round(world, SCENE.timeStep(), 0).mean();
                factors[round] =
                        BusyMachine.round(world, SCENE.timeStep(), PROCESSORS).mean() / idle;
            }
        }
        Arrays.sort(factors);
        assertThat(factors[ROUNDS / 2])
                .as("times of steps over those on an idle machine")
                .isLessThan(FACTOR);
    }
}
