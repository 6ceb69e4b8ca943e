package io.github.circles2d.world.device;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.OnEachDevice;
import io.github.circles2d.opencl.TestScale;
import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.jvm.JvmPipeline;
import io.github.circles2d.world.jvm.SparseArena;
import io.github.circles2d.world.model.AxisEdge;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.Features;
import io.github.circles2d.world.shared.Pipeline;
import java.util.Random;
import java.util.function.Consumer;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * However circles lie in an arena of far more cells than buckets, they test about as many pairs as those of a square; and two static
 * circles none.
 */
class SheetsTest {
    private static final Bounds UNIT = new Bounds(0, 0, 1, 1);
    private static final float STATIC = Float.POSITIVE_INFINITY;

    /** How many times the pairs of a square others may test. */
    private static final double MOST = 2;

    private static Pipeline java() {
        return new JvmPipeline(1, JvmPipeline.LEAST_SHARE, 0, false);
    }

    /** Candidate pairs a circle of what is added to an empty world, on all pipelines alike. */
    private static double candidates(Bounds bounds, Consumer<Twins> scene, Pipeline... pipelines) {
        try (Twins twins = Twins.empty(bounds, pipelines)) {
            scene.accept(twins);
            twins.step(1 / 60f, 1);
            twins.assertEqual("a step");
            twins.assertSameFigures();
            return pipelines[0].candidatePairs() / (double) twins.size();
        }
    }

    private static double ofSquare(Bounds bounds, int circles, Pipeline... pipelines) {
        return candidates(bounds, twins -> SparseArena.square((int) Math.sqrt(circles), 1, twins::add), pipelines);
    }

    private static Consumer<Twins> line(int circles, double degrees, double gap, float mass) {
        return twins -> SparseArena.line(circles, degrees, gap, mass, twins::add);
    }

    private static void assertFew(String what, double candidates, double ofSquare) {
        assertThat(candidates).as(what).isLessThanOrEqualTo(MOST * ofSquare);
    }

    @ParameterizedTest
    @CsvSource({"1000, WALL", "4000, WALL", "1000, OPEN", "4000, OPEN", "1000, WRAP", "4000, WRAP"})
    @Tag("long")
    void linesOfAnyAngleHaveFewCandidatePairs(int circles, AxisEdge edge) {
        Bounds bounds = UNIT.with(edge, edge);
        double ofSquare = ofSquare(bounds, circles, java());
        for (int degrees = 0; degrees < 180; degrees++) {
            double found = candidates(bounds, line(circles, degrees, 1, 1), java());
            assertFew(circles + " circles in a line of " + degrees + " degrees", found, ofSquare);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1000, 4000})
    void linesOfAnyAngleAndGapHaveFewCandidatePairs(int circles) {
        assertFewOfRandomLines(circles, 60);
    }

    @ParameterizedTest
    @ValueSource(ints = {1000, 4000, 30_000})
    @Tag("exhaustive")
    void manyLinesOfAnyAngleAndGapHaveFewCandidatePairs(int circles) {
        assertFewOfRandomLines(circles, 1000);
    }

    private static void assertFewOfRandomLines(int circles, int lines) {
        Random random = new Random(circles + lines);
        double ofSquare = ofSquare(UNIT, circles, java());
        for (int k = 0; k < lines; k++) {
            double degrees = 180 * random.nextDouble();
            double gap = 1 + (0.9 * SparseArena.RADII / 2 / circles - 1) * Math.pow(random.nextDouble(), 3);
            double found = candidates(UNIT, line(circles, degrees, gap, 1), java());
            assertFew(circles + " circles, " + gap + " diameters apart, at " + degrees + " degrees", found, ofSquare);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {200, 1000, 4000, 30_000})
    void ringsHaveFewCandidatePairs(int circles) {
        double ofSquare = ofSquare(UNIT, circles, java());
        double found = candidates(UNIT, twins -> SparseArena.ring(circles, 1, twins::add), java());
        assertFew("a ring of " + circles, found, ofSquare);
    }

    @ParameterizedTest
    @ValueSource(ints = {10, 31, 63})
    @Tag("long")
    void latticesOfAnySpacingHaveFewCandidatePairs(int side) {
        double ofSquare = ofSquare(UNIT, side * side, java());
        for (int spacing = 1; spacing < 400; spacing += spacing < 150 ? 1 : 17) {
            assertFewOfLattice(side, spacing, ofSquare);
        }
    }

    /** Those multiples of the sides of the torus bring all circles into one bucket. */
    @Test
    void latticesThatLieInOneBucketHaveFewCandidatePairs() {
        double ofSquare = ofSquare(UNIT, 31 * 31, java());
        assertFewOfLattice(31, 26 * 11, ofSquare);
        assertFewOfLattice(31, 26 * 22, ofSquare);
        assertFewOfLattice(31, 2 * 26 * 22, ofSquare);
    }

    private static void assertFewOfLattice(int side, int spacing, double ofSquare) {
        double found = candidates(UNIT, twins -> SparseArena.lattice(side, spacing, twins::add), java());
        assertFew("a lattice of side " + side + ", " + spacing + " cells apart", found, ofSquare);
    }

    @ParameterizedTest
    @EnumSource(AxisEdge.class)
    void staticCirclesTestNoPairs(AxisEdge edge) {
        Bounds bounds = UNIT.with(edge, edge);
        assertThat(candidates(bounds, line(4000, 0, 1, STATIC), java())).isZero();
        assertThat(candidates(bounds, line(4000, 30, 1, STATIC), java())).isZero();
        assertThat(candidates(bounds, twins -> SparseArena.square(60, STATIC, twins::add), java()))
                .isZero();
    }

    /** In a level that is not folded, too, and between levels. */
    @Test
    void staticCirclesTestNoPairsInAnyLevel() {
        Bounds small = new Bounds(0.4999f, 0.4999f, 0.5001f, 0.5001f);
        assertThat(candidates(small, twins -> SparseArena.square(15, STATIC, twins::add), java()))
                .isZero();
        for (Bounds bounds : new Bounds[] {small, UNIT}) {
            assertThat(candidates(bounds, SheetsTest::addStaticsOfManySizes, java()))
                    .isZero();
        }
    }

    private static void addStaticsOfManySizes(Twins twins) {
        Random random = new Random(5);
        for (int i = 0; i < 2000; i++) {
            float x = 0.5f + 1e-4f * (random.nextFloat() - 0.5f);
            float y = 0.5f + 1e-4f * (random.nextFloat() - 0.5f);
            float radius = (float) (1e-6 * Math.pow(30, random.nextDouble()));
            twins.add(x, y, radius, STATIC, 0, 0, 0);
        }
    }

    /** A pair of which one is static is tested once, whichever of the two looks. */
    @Test
    void movingCirclesAmongStaticOnesTestThoseAroundThemAlone() {
        double few = candidates(
                UNIT,
                twins -> {
                    SparseArena.square(50, STATIC, twins::add);
                    twins.add(0.5f, 0.5f, SparseArena.RADIUS, 1, 0, 0, 0);
                },
                java());
        assertThat(few * 2501).isBetween(4., 40.);
    }

    @OnEachDevice
    @Tag("long")
    void devicesTestTheSamePairsAsJava(Device device) {
        double ofSquare = ofSquare(UNIT, 1000, PipelinesAgreeTest.pipelines(device));
        for (double degrees : new double[] {0, 33, 45, 90, 151.7}) {
            double found = candidates(UNIT, line(1000, degrees, 1, 1), PipelinesAgreeTest.pipelines(device));
            assertFew("a line of " + degrees + " degrees", found, ofSquare);
        }
        assertThat(candidates(UNIT, line(1000, 45, 1, STATIC), PipelinesAgreeTest.pipelines(device)))
                .isZero();
        Consumer<Twins> lattice = twins -> SparseArena.lattice(31, 26 * 22, twins::add);
        assertFew("a lattice", candidates(UNIT, lattice, PipelinesAgreeTest.pipelines(device)), ofSquare);
        Bounds small = new Bounds(0.4999f, 0.4999f, 0.5001f, 0.5001f);
        Consumer<Twins> statics = twins -> SparseArena.square(15, STATIC, twins::add);
        assertThat(candidates(small, statics, PipelinesAgreeTest.pipelines(device)))
                .isZero();
    }

    @OnEachDevice
    @Tag("long")
    void linesHaveTheSameBitsAndEventsOnTheDeviceAsInJava(Device device) {
        for (AxisEdge edge : AxisEdge.values()) {
            for (int large : TestScale.EXHAUSTIVE ? new int[] {1, 6} : new int[] {6}) {
                Features features = edge == AxisEdge.WALL ? Features.NONE : Pipelines.INSIDE_EDGES;
                Pipeline[] pipelines = Pipelines.all(device, features);
                try (Twins twins = Twins.empty(UNIT.with(edge, edge), pipelines)) {
                    twins.report(ContactEvents.BEGIN | ContactEvents.END | ContactEvents.HIT);
                    Random random = new Random(7);
                    for (int degrees : new int[] {0, 90, 45, 160}) {
                        SparseArena.line(
                                150, degrees, 1, 1, (x, y, r, mass, e, vx, vy) -> addAny(twins, random, large, x, y));
                    }
                    int events = 0;
                    for (int k = 0; k < 5; k++) {
                        twins.step(1 / 60f, 2);
                        twins.assertEqual(edge + " after " + 2 * (k + 1) + " steps");
                        twins.assertSameFigures();
                        events += twins.assertSameEvents(edge + " after " + 2 * (k + 1) + " steps");
                    }
                    assertThat(events).isGreaterThan(100);
                }
            }
        }
    }

    /**
     * A circle that moves or is static or both, some so fast that they look ahead; one in thirty is several times as large. Static ones
     * may cross half of the torus in a step.
     */
    private static void addAny(Twins twins, Random random, int large, float x, float y) {
        float radius = SparseArena.RADIUS * (0.8f + 0.2f * random.nextFloat()) * (random.nextInt(30) == 0 ? large : 1);
        boolean isStatic = random.nextInt(4) == 0;
        float speed = radius * (random.nextInt(8) == 0 ? isStatic ? 3000 : 500 : 5);
        twins.add(
                x,
                y,
                radius,
                isStatic ? STATIC : 1,
                0.5f,
                speed * (random.nextFloat() - 0.5f),
                speed * (random.nextFloat() - 0.5f));
    }
}
