package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.opencl.TestScale;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * The states that the scenes on record go through are the same for every number of threads; {@link WorldHashesOnDevicesTest} has devices. The more
 * circles a scene has, the earlier the mark that it runs to. {@code -Dcircles2d.golden=full} asks for all marks.
 */
class GoldenHashesTest {
    /** {@link GoldenScene#cost} times steps that one run may take. */
    private static final int SHORTEST = TestScale.of(60_000, 150_000, 150_000);

    /** As no long run has these numbers of threads. */
    private static final int SHORT = TestScale.of(SHORTEST, 1_000_000);

    private static final boolean FULL =
            System.getProperty("circles2d.golden", "").equals("full");

    private static final long LONG = FULL ? Long.MAX_VALUE : 13_000_000;

    /** Of a run on a device. */
    static final long OF_DEVICES = TestScale.EXHAUSTIVE ? LONG : SHORTEST;

    static List<Arguments> scenesAndTwoNumbersOfThreads() throws IOException {
        return scenesAndThreads(1, 7);
    }

    static List<Arguments> scenesAndThreadsOfLongRuns() throws IOException {
        return FULL ? scenesAndThreads(1, 2, 7) : scenesAndThreads(3);
    }

    private static List<Arguments> scenesAndThreads(int... numbers) throws IOException {
        List<Arguments> runs = new ArrayList<>();
        for (GoldenScene scene : GoldenHashes.scenes()) {
            for (int threads : numbers) {
                runs.add(Arguments.of(scene, threads));
            }
        }
        return runs;
    }

    @ParameterizedTest
    @MethodSource("scenesAndTwoNumbersOfThreads")
    @Tag("each-jdk")
    void theJvmBackEndGivesTheHashesOnRecordWithAnyNumberOfThreads(GoldenScene scene, int threads) throws IOException {
        check(scene, jvm(scene, threads), SHORT);
    }

    @ParameterizedTest
    @MethodSource("scenesAndThreadsOfLongRuns")
    @Tag("exhaustive")
    void theJvmBackEndGivesTheHashesOfLongRuns(GoldenScene scene, int threads) throws IOException {
        check(scene, jvm(scene, threads), LONG);
    }

    private static World jvm(GoldenScene scene, int threads) {
        return WorldScenes.onThreads(threads, scene.builder());
    }

    static void check(GoldenScene scene, World world, long affordable) throws IOException {
        GoldenHashes golden = GoldenHashes.load();
        try (GoldenScene.Run run = scene.start(world)) {
            for (int mark : GoldenHashes.MARKS) {
                if ((long) mark * scene.cost() <= affordable) {
                    run.advanceTo(mark);
                    assertThat(Long.toHexString(run.world().hash()))
                            .as("hash after %d steps", mark)
                            .isEqualTo(Long.toHexString(golden.hash(scene, mark)));
                }
            }
        }
    }
}
