package io.github.circles2d.thesis;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.OnEachDevice;
import io.github.circles2d.opencl.TestDevices;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Every kernel against the sequential oracle, in scenes where no circle has two contacts, so that there is no race.
 *
 * <p>Devices may fuse products into sums, and their native_sqrt and division are not rounded correctly. All values are at
 * most 2, where a float's steps are 1.2e-7 wide, so single stages are compared within 5e-7, and twenty steps within 1e-5;
 * the tests make sure that no decision in the oracle is nearer than that to falling the other way.
 */
class KernelsAgainstOracleTest {
    private static final float STEP = 1 / 60f;
    private static final float GX = 0.02f;
    private static final float GY = -0.3f;
    private static final double STAGE_TOLERANCE = 5e-7;
    private static final double RUN_TOLERANCE = 1e-5;

    private static final int STRATEGIES = 4;

    /** Each with a work-item a slot, as on a CPU; one with few work-items, too, as on a GPU. */
    static List<Arguments> everyStrategyOnEveryDevice() {
        List<Arguments> cases = new ArrayList<>();
        for (int strategy = 0; strategy < STRATEGIES; strategy++) {
            addCases(cases, strategy, false);
        }
        addCases(cases, STRATEGIES - 1, true);
        return cases;
    }

    static List<Arguments> theOthersWithFewWorkItems() {
        List<Arguments> cases = new ArrayList<>();
        for (int strategy = 0; strategy < STRATEGIES - 1; strategy++) {
            addCases(cases, strategy, true);
        }
        return cases;
    }

    /** A program on each device, which a driver compiles for seconds. */
    private static void addCases(List<Arguments> cases, int strategy, boolean fewWorkItems) {
        for (Device device : TestDevices.all()) {
            for (float restitution : new float[] {0, 0.5f, 1}) {
                cases.add(Arguments.of(device, strategy, fewWorkItems, restitution));
            }
        }
    }

    static Stream<Arguments> everyElasticStrategyOnEveryDevice() {
        return everyStrategyOnEveryDevice().stream()
                .filter(arguments -> (float) arguments.get()[3] > 0);
    }

    @ParameterizedTest
    @MethodSource("everyStrategyOnEveryDevice")
    void updatePositionMovesAndReflectsAsTheOracleDoes(Device device, int strategy, boolean few, float e) {
        TestScene scene = TestScene.atTheWalls(500, 7);
        ThesisOracle oracle = new ThesisOracle(scene, STEP, e, GX, GY);
        try (ThesisStages stages =
                new ThesisStages(device, ThesisStages.strategies().get(strategy), few, scene, STEP, e, GX, GY)) {
            oracle.update();
            assertThat(oracle.takeMargin()).isGreaterThan(10 * STAGE_TOLERANCE);
            stages.update();
            assertSameState(stages, oracle, STAGE_TOLERANCE);
        }
    }

    @ParameterizedTest
    @MethodSource("everyStrategyOnEveryDevice")
    void detectFindsTheMtvOfEveryPairAndClearsTheSlotsOfAllOthers(Device device, int strategy, boolean few, float e) {
        TestScene scene = TestScene.isolatedPairs(16, 11);
        ThesisOracle oracle = new ThesisOracle(scene, STEP, e, GX, GY);
        oracle.detect();
        assertThat(oracle.takeMargin()).isGreaterThan(10 * STAGE_TOLERANCE);
        assertThat(oracle.contacts()).hasSizeBetween(80, 220);
        try (ThesisStages stages =
                new ThesisStages(device, ThesisStages.strategies().get(strategy), few, scene, STEP, e, GX, GY)) {
            stages.detect();
            float[][] mtv = stages.collisions();
            for (int c = 0; c < oracle.mtvX.length; c++) {
                if (oracle.mtvX[c] == 0 && oracle.mtvY[c] == 0) {
                    assertThat(mtv[0][c]).isZero();
                    assertThat(mtv[1][c]).isZero();
                }
            }
            assertNear(mtv[0], oracle.mtvX, STAGE_TOLERANCE, "mtv x");
            assertNear(mtv[1], oracle.mtvY, STAGE_TOLERANCE, "mtv y");
            assertSameState(stages, oracle, 0);
        }
    }

    @ParameterizedTest
    @MethodSource("everyStrategyOnEveryDevice")
    void resolvePartsOverlappingPairsAndExchangesTheirImpulses(Device device, int strategy, boolean few, float e) {
        TestScene scene = TestScene.isolatedPairs(16, 13);
        ThesisOracle oracle = new ThesisOracle(scene, STEP, e, GX, GY);
        oracle.detect();
        assertThat(oracle.someCircleHasTwoContacts()).isFalse();
        try (ThesisStages stages =
                new ThesisStages(device, ThesisStages.strategies().get(strategy), few, scene, STEP, e, GX, GY)) {
            stages.setCollisionsOf(oracle);
            stages.resolve();
            oracle.resolve();
            assertSameState(stages, oracle, STAGE_TOLERANCE);
        }
    }

    @OnEachDevice
    void rowsHoldEveryPropertyOfEveryCircleInOrder(Device device) {
        for (int n : new int[] {2, 256, 300}) {
            TestScene scene = TestScene.crowd(n, 0.02f, 7);
            try (ThesisStages stages = new ThesisStages(device, new ExactPairs(), scene, STEP, 0, GX, GY)) {
                float[] rows = stages.rows();
                assertThat(Arrays.copyOfRange(rows, 0, n)).isEqualTo(scene.x);
                assertThat(Arrays.copyOfRange(rows, n, 2 * n)).isEqualTo(scene.y);
                assertThat(Arrays.copyOfRange(rows, 2 * n, 3 * n)).isEqualTo(scene.radius);
                assertThat(Arrays.copyOfRange(rows, 3 * n, 4 * n)).isEqualTo(scene.mass);
            }
        }
    }

    /**
     * Restitution 0 is left to the single stages: circles that stay in touch are a rounding error away from not touching, in
     * every step.
     */
    @ParameterizedTest
    @MethodSource("everyElasticStrategyOnEveryDevice")
    void twentyWholeStepsFollowTheOracle(Device device, int strategy, boolean few, float e) {
        TestScene scene = TestScene.isolatedPairs(8, 480);
        ThesisOracle oracle = new ThesisOracle(scene, STEP, e, 0, 0);
        int contacts = 0;
        try (ThesisStages stages =
                new ThesisStages(device, ThesisStages.strategies().get(strategy), few, scene, STEP, e, 0, 0)) {
            for (int k = 0; k < 20; k++) {
                oracle.update();
                oracle.detect();
                assertThat(oracle.someCircleHasTwoContacts()).isFalse();
                contacts += oracle.contacts().size();
                oracle.resolve();
                stages.update();
                stages.detect();
                stages.resolve();
            }
            assertThat(contacts).isGreaterThan(50);
            assertThat(oracle.takeMargin()).isGreaterThan(3 * RUN_TOLERANCE);
            assertSameState(stages, oracle, RUN_TOLERANCE);
        }
    }

    @ParameterizedTest
    @MethodSource("theOthersWithFewWorkItems")
    @Tag("exhaustive")
    void everyStageOfEveryStrategyIsTheOraclesWithFewWorkItemsToo(Device device, int strategy, boolean few, float e) {
        updatePositionMovesAndReflectsAsTheOracleDoes(device, strategy, few, e);
        detectFindsTheMtvOfEveryPairAndClearsTheSlotsOfAllOthers(device, strategy, few, e);
        resolvePartsOverlappingPairsAndExchangesTheirImpulses(device, strategy, few, e);
        if (e > 0) {
            twentyWholeStepsFollowTheOracle(device, strategy, few, e);
        }
    }

    private static void assertSameState(ThesisStages stages, ThesisOracle oracle, double tolerance) {
        float[][] circles = stages.circles();
        float[][] velocities = stages.velocities();
        assertNear(circles[0], oracle.x, tolerance, "x");
        assertNear(circles[1], oracle.y, tolerance, "y");
        assertThat(circles[2]).isEqualTo(oracle.radius);
        assertThat(circles[3]).isEqualTo(oracle.mass);
        assertNear(velocities[0], oracle.vx, 4 * tolerance, "vx");
        assertNear(velocities[1], oracle.vy, 4 * tolerance, "vy");
    }

    private static void assertNear(float[] actual, float[] expected, double tolerance, String what) {
        assertThat(actual).hasSameSizeAs(expected);
        for (int i = 0; i < actual.length; i++) {
            if (!(Math.abs(actual[i] - expected[i]) <= tolerance)) {
                assertThat((double) actual[i]).as(what + " of " + i).isCloseTo(expected[i], within(tolerance));
            }
        }
    }
}
