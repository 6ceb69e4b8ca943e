package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.TestDevices;
import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import java.util.Arrays;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * Steps on a machine with as many other busy threads as processors. This measures time, so it asks only that steps are not tens
 * of times as long, in the middle one of several rounds: threads that wait in a wrong way make them a hundred times as long.
 */
@Tag("exhaustive")
@Timeout(120)
class BusyMachineTest {
    private static final int ROUNDS = 5;
    private static final double FACTOR = 20;

    @Test
    void stepsOnTheJvmTakeFewTimesAsLong() throws InterruptedException {
        check(Backend.JVM);
    }

    @Test
    void stepsByOpenClOnAProcessorTakeFewTimesAsLong() throws InterruptedException {
        if (TestDevices.all().stream().anyMatch(device -> device.kind() == Device.Kind.CPU)) {
            check(Backend.OPENCL_CPU);
        }
    }

    private static void check(Backend backend) throws InterruptedException {
        int processors = Runtime.getRuntime().availableProcessors();
        Scene scene = Scenes.packed(1250, 1);
        double[] factors = new double[ROUNDS];
        try (World world = WorldScenes.world(scene, WorldScenes.builder(scene).backend(backend))) {
            BusyMachine.round(world, scene.timeStep(), 0);
            for (int round = 0; round < ROUNDS; round++) {
                double idle = BusyMachine.round(world, scene.timeStep(), 0).mean();
                factors[round] =
                        BusyMachine.round(world, scene.timeStep(), processors).mean() / idle;
            }
        }
        Arrays.sort(factors);
        assertThat(factors[ROUNDS / 2])
                .as("times of steps over those on an idle machine")
                .isLessThan(FACTOR);
    }
}
