package io.github.circles2d.world.device;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.TestDevices;
import io.github.circles2d.opencl.TestScale;
import io.github.circles2d.scenes.Scenes;
import io.github.circles2d.world.device.plan.Plans;
import io.github.circles2d.world.device.plan.Tiles;
import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.jvm.JvmPipeline;
import io.github.circles2d.world.jvm.SparseArena;
import io.github.circles2d.world.model.AxisEdge;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.Tuning;
import io.github.circles2d.world.shared.Pipeline;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Which way a step takes where tiles are the plan; that all ways have the same bits is for {@link PipelinesAgreeTest}. */
class TilesTest {
    private static final Bounds UNIT = new Bounds(0, 0, 1, 1);

    static List<Device> devices() {
        return TestDevices.all().stream().filter(Tiles::fit).toList();
    }

    @ParameterizedTest
    @MethodSource("devices")
    @Tag("long")
    void crowdsThatAreThinnedOutAreSolvedByTilesWhereTheseFit(Device device) {
        DevicePipeline pipeline = Pipelines.of(device, Plans.TILES, true);
        Pipeline java = new JvmPipeline(1, JvmPipeline.LEAST_SHARE, 0, false);
        try (Twins twins = Twins.empty(new Bounds(0, 0, 1, 1), java, pipeline)) {
            twins.addCrowd(1 + Tuning.CROWD / 2);
            twins.step(1 / 60f, 1);
            twins.assertEqual("the step that is refused at first, for the crowd");
            Map<String, Long> nanos = pipeline.kernelNanos();
            assertThat(nanos).containsKey("contacts_crowd");
            twins.step(1 / 60f, 1);
            twins.assertEqual("the step behind it");
            assertThat(pipeline.greatestContacts()).isGreaterThan(Tuning.CROWD);
            Map<String, Long> nanosThen = pipeline.kernelNanos();
            for (String kernel : List.of("contacts_crowd", "solver_solveTile", "solver_relaxTile")) {
                assertThat(nanosThen.get(kernel)).as(kernel).isGreaterThan(nanos.get(kernel));
            }
            assertThat(nanosThen).doesNotContainKeys("solver_solve", "solver_relax");
        }
    }

    @ParameterizedTest
    @MethodSource("devices")
    void circlesOfAllLevelsAreSolvedByTiles(Device device) {
        DevicePipeline pipeline = Pipelines.of(device, Plans.TILES, true);
        try (Twins twins = Twins.load(Scenes.mixed(600, 1), pipeline)) {
            twins.step(1 / 60f, 3);
            twins.assertEqual("made");
            assertThat(pipeline.kernelNanos())
                    .containsKeys("solver_solveLevels", "solver_relaxLevels", "cross_solve")
                    .doesNotContainKeys("solver_solve", "solver_relax", "solver_solveTile");
        }
    }

    @ParameterizedTest
    @MethodSource("devices")
    @Tag("long")
    void tilesThatHoldTooMuchAreCut(Device device) {
        DevicePipeline pipeline = Pipelines.of(device, Plans.TILES, true);
        Pipeline java = new JvmPipeline(1, JvmPipeline.LEAST_SHARE, 0, false);
        float side = 40;
        SplittableRandom random = new SplittableRandom(1);
        try (Twins twins = Twins.empty(new Bounds(0, 0, side, side), java, pipeline)) {
            for (int i = 0; i < 1200; i++) {
                // A third of them in a corner, where there are many in a cell.
                double reach = i % 3 == 0 ? side : 0.35 * side;
                twins.add((float) random.nextDouble(reach), (float) random.nextDouble(reach), 1, 1, 0, 0, 0);
            }
            for (int k = 0; k < 6; k++) {
                twins.step(1 / 60f, 1 + k % 2);
                twins.assertEqual("step " + k);
            }
            assertThat(pipeline.kernelNanos()).containsKey("contacts_cutTiles").doesNotContainKey("solver_solve");
        }
    }

    /** A tile of 2 x 2 cells has more circles than there is room for. */
    @ParameterizedTest
    @MethodSource("devices")
    @Tag("long")
    void manyTurnsOfTheTorusAreSolvedByColoursWithTheSameBitsAndEvents(Device device) {
        AxisEdge[] edges = {AxisEdge.WALL, AxisEdge.OPEN};
        for (AxisEdge edge : Arrays.copyOf(edges, TestScale.of(1, 2))) {
            for (int large : new int[] {1, 8}) {
                DevicePipeline pipeline = Pipelines.of(device, Plans.TILES, true);
                Pipeline java = new JvmPipeline(1, JvmPipeline.LEAST_SHARE, 0, false);
                try (Twins twins = Twins.empty(UNIT.with(edge, edge), java, pipeline)) {
                    twins.report(ContactEvents.BEGIN | ContactEvents.END | ContactEvents.HIT);
                    SparseArena.corners(edge == AxisEdge.OPEN, large * SparseArena.RADIUS, new Random(2), twins::add);
                    int events = 0;
                    for (int k = 0; k < TestScale.of(2, 20); k++) {
                        String when = edge + ", " + large + ", after " + 2 * (k + 1) + " steps";
                        twins.step(1 / 60f, 2);
                        twins.assertEqual(when);
                        twins.assertSameFigures();
                        events += twins.assertSameEvents(when);
                    }
                    assertThat(events).isGreaterThan(100);
                    assertThat(pipeline.kernelNanos()).containsKeys("contacts_cutTiles", "solver_solve");
                }
            }
        }
    }

    /** Worlds of any size, edges and density, in which tiles are cut or do not suffice, have the bits of Java. */
    @ParameterizedTest
    @MethodSource("devices")
    @Tag("exhaustive")
    void crowdsInArenasOfAnyShapeHaveTheSameBits(Device device) {
        for (int seed = 1; seed <= 60; seed++) {
            SplittableRandom random = new SplittableRandom(seed);
            float width = side(random);
            float height = side(random);
            Bounds bounds = new Bounds(0, 0, width, height, edge(random), edge(random));
            Pipeline java = new JvmPipeline(1, JvmPipeline.LEAST_SHARE, 0, false);
            try (Twins twins = Twins.empty(bounds, java, Pipelines.of(device, Plans.TILES))) {
                double reach = random.nextDouble(0.2, 1);
                double ratio = 1 + random.nextInt(3) * 3;
                int circles = (int) Math.min(3000, 2 * width * height);
                for (int i = 0; i < circles; i++) {
                    double part = i % 3 == 0 ? 1 : reach;
                    float x = (float) (random.nextDouble(0.99 * width) * part);
                    float y = (float) (random.nextDouble(0.99 * height) * part);
                    float r = (float) (i == 0 ? 1 : Math.pow(ratio, -random.nextDouble()));
                    twins.add(x, y, r, 1, 0.3f, (float) random.nextDouble(-20, 20), (float) random.nextDouble(-20, 20));
                }
                for (int k = 0; k < 4; k++) {
                    twins.step(1 / 60f, 1 + k % 3);
                    twins.assertEqual("seed " + seed + ", " + bounds + ", call " + k);
                }
            }
        }
    }

    /** From four to forty cells. */
    private static float side(SplittableRandom random) {
        return (2 * random.nextInt(2, 21) + 0.5f) * 2 * (1 + Tuning.MARGIN + Tuning.CAP);
    }

    private static AxisEdge edge(SplittableRandom random) {
        return AxisEdge.values()[random.nextInt(AxisEdge.values().length)];
    }
}
