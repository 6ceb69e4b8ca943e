package io.github.circles2d.world.jvm;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.opencl.TestScale;
import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import io.github.circles2d.world.model.KindField;
import io.github.circles2d.world.shared.Call;
import io.github.circles2d.world.shared.Calls;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** What must not show in the state: threads and slots. */
@Timeout(120) // a barrier that is wrong may as well hang
@Tag("each-jdk")
class JvmPipelineTest {
    private static final int STEPS = TestScale.of(6, 15, 40);

    static Stream<Scene> scenes() {
        return Stream.of(
                Scenes.thesis(1250, Scenes.SEED),
                Scenes.packed(3000, Scenes.SEED),
                Scenes.gas(1250, Scenes.SEED),
                Scenes.pyramid(),
                Scenes.mixed(2000, Scenes.SEED),
                Scenes.mixed(2000, 100, Scenes.SEED),
                Scenes.noCollide(),
                Scenes.billiards(40),
                Scenes.onePoint(TestScale.of(250, 500, 1000), Scenes.SEED));
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void theStateDoesNotDependOnTheNumberOfThreads(Scene scene) {
        for (boolean grips : new boolean[] {false, true}) {
            long[] expected = hashes(scene, 1, false, grips);
            assertThat(hashes(scene, 2, false, grips)).isEqualTo(expected);
            assertThat(hashes(scene, 7, false, grips)).isEqualTo(expected);
        }
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void theStateDoesNotDependOnTheSlotsThatCirclesLieIn(Scene scene) {
        for (boolean grips : new boolean[] {false, true}) {
            assertThat(hashes(scene, 1, true, grips)).isEqualTo(hashes(scene, 1, false, grips));
        }
    }

    /** The hash after each step, with a circle that comes or goes every third step. */
    private static long[] hashes(Scene scene, int threads, boolean shuffled, boolean grips) {
        Random random = new Random(11);
        Random order = new Random(12);
        long[] hashes = new long[STEPS];
        try (JvmWorld world = new JvmWorld(scene, threads)) {
            if (grips) {
                world.simulation.kinds.set(KindField.FRICTION, 0, 0.6f);
                world.simulation.kinds.set(KindField.ROLLING_RESISTANCE, 0, 0.1f);
                setWall(world.simulation.calls, 2, 0.6f, 0.1f, 0.5f);
                setWall(world.simulation.calls, 1, 0.3f, 0, 0);
            }
            for (int step = 0; step < STEPS; step++) {
                if (step % 3 == 1) {
                    long[] handles = world.handles();
                    world.simulation.circles.remove(handles[random.nextInt(handles.length)]);
                } else if (step % 3 == 2) {
                    world.add(
                            scene.minX() + (scene.maxX() - scene.minX()) * random.nextFloat(),
                            scene.minY() + (scene.maxY() - scene.minY()) * random.nextFloat(),
                            scene.radius(0),
                            1,
                            0.5f,
                            0,
                            0);
                }
                if (shuffled) {
                    world.permute(permutation(world.simulation.circles.size(), order));
                }
                world.step(1);
                hashes[step] = world.simulation.hash();
            }
        }
        return hashes;
    }

    private static void setWall(Calls calls, int wall, float friction, float rolling, float belt) {
        int rollingBits = Float.floatToRawIntBits(rolling);
        calls.make(
                Call.WALL_SURFACE, wall, Float.floatToRawIntBits(friction), rollingBits, Float.floatToRawIntBits(belt));
    }

    private static int[] permutation(int n, Random random) {
        int[] order = new int[n];
        for (int k = 0; k < n; k++) {
            int other = random.nextInt(k + 1);
            order[k] = order[other];
            order[other] = k;
        }
        return order;
    }
}
