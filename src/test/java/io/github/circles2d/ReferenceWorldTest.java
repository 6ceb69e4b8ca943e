package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.opencl.TestScale;
import io.github.circles2d.reference.BodyOutline;
import io.github.circles2d.reference.ReferenceWorld;
import io.github.circles2d.scenes.Scene;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** World has the same bits as its description in the plainest form, after every step. */
class ReferenceWorldTest {
    /** More would take each build long. */
    private static final int FEW_CIRCLES = 1_500;

    private static final int CIRCLES = 5_000;
    private static final int STEPS = TestScale.of(10, 100);

    /** Of many circles: callers change them behind 7. */
    private static final int FEWER_STEPS = TestScale.of(8, 100);

    /** Nobody sleeps before 60 steps are over. */
    private static final int STEPS_OF_SLEEP = TestScale.of(160, 1000);

    private static final int SUB_STEPS = 4;

    static List<GoldenScene> smallScenes() {
        return scenes(0, FEW_CIRCLES);
    }

    static List<GoldenScene> largerScenes() {
        return scenes(FEW_CIRCLES, CIRCLES);
    }

    /** Those of more circles than one number, and no more than the other. */
    private static List<GoldenScene> scenes(int more, int most) {
        return GoldenScene.all().stream()
                .filter(golden -> golden.scene().size() > more && golden.scene().size() <= most)
                .toList();
    }

    @ParameterizedTest
    @MethodSource("smallScenes")
    void everyStepOfTheScenesOnRecordIsTheReferences(GoldenScene golden) {
        compare(golden);
    }

    @ParameterizedTest
    @MethodSource("largerScenes")
    @Tag("long")
    void soIsEveryStepOfThoseWithThousandsOfCircles(GoldenScene golden) {
        compare(golden);
    }

    private static void compare(GoldenScene golden) {
        Scene scene = golden.scene();
        ReferenceWorld reference =
                new ReferenceWorld(scene.restitution(), World.builder().build().subSteps());
        reference.setBounds(scene.minX(), scene.minY(), scene.maxX(), scene.maxY());
        reference.edges(golden.edgeX(), golden.edgeY()).surfaces(golden.surfaces());
        reference.setGravity(scene.gravityX(), scene.gravityY());
        if (golden.sleeps()) {
            reference.sleep();
        }
        int steps = scene.size() > FEW_CIRCLES ? FEWER_STEPS : STEPS;
        steps = golden.sleeps() ? STEPS_OF_SLEEP : steps;
        try (GoldenScene.Run run =
                        golden.start(golden.builder().subSteps(SUB_STEPS).build());
                GoldenScene.Run expected = golden.start(reference)) {
            assertThat(run.hash()).as("hash before the first step").isEqualTo(expected.hash());
            for (int step = 1; step <= steps; step++) {
                run.advanceTo(step);
                expected.advanceTo(step);
                assertThat(run.hash()).as("hash after step %d", step).isEqualTo(expected.hash());
            }
        }
    }

    /** Some balls are pushed by two static circles at once, and some pushers are slower than the balls. */
    @ParameterizedTest
    @CsvSource({"0.5", "5", "40"})
    void staticCirclesThatMovePushThoseThatTheReferencePushes(float speed) {
        ReferenceWorld reference = new ReferenceWorld(0.5f, SUB_STEPS);
        try (World world =
                WorldScenes.jvm().restitution(0.5f).subSteps(SUB_STEPS).build()) {
            List<WorldCalls> both = List.of(WorldCalls.of(world), reference);
            for (WorldCalls calls : both) {
                calls.setGravity(0f, -1f);
                for (int k = 0; k < 8; k++) {
                    float x = 0.06f + 0.12f * k;
                    calls.add(x - 0.02f, 0.2f, 0.03f, Float.POSITIVE_INFINITY, 0.01f * k * speed, speed);
                    calls.add(x + 0.02f, 0.2f, 0.03f, Float.POSITIVE_INFINITY, -0.01f * k * speed, speed);
                    calls.add(x, 0.25f + 0.02f * k, 0.004f + 0.002f * (k % 3), 1f, 0f, -0.1f * k * speed);
                    calls.add(x, 0.45f + 0.02f * k, 0.01f, 1f, 0f, 0f);
                }
            }
            for (int step = 1; step <= 12; step++) {
                both.forEach(calls -> calls.step(1 / 60f, 1));
                assertThat(world.hash()).as("hash after step %d", step).isEqualTo(reference.hash());
            }
        }
    }

    /** Two circles meet on their paths, but far from the part of the path that the faster one goes at most: neither stops. */
    @ParameterizedTest
    @CsvSource({"0, 0.84", "3000, 0.84", "4200, 0.80", "4200, 0.82", "4200, 0.84", "4200, 0.86", "4200, 0.88"})
    void aVeryFastCircleStopsTheCirclesThatTheReferenceStops(int others, float y) {
        ReferenceWorld reference = new ReferenceWorld(0.5f, SUB_STEPS);
        try (World world =
                WorldScenes.jvm().restitution(0.5f).subSteps(SUB_STEPS).build()) {
            for (WorldCalls calls : List.of(WorldCalls.of(world), reference)) {
                calls.add(0.1f, 0.1f, 0.0005f, 1f, 0f, 60f);
                calls.add(0.1f, y, 0.0005f, 1f, 0f, -1.5f);
                for (int k = 0; k < others; k++) {
                    calls.add(0.25f + 0.01f * (k % 70), 0.05f + 0.015f * (k / 70), 0.0005f, 1f, 0f, 0f);
                }
                calls.step(1 / 60f, 1);
            }
            assertThat(world.hash()).isEqualTo(reference.hash());
        }
    }

    /** Its sharp tip has a gap of zero, which is no gap, whatever its sign. */
    @Test
    void aBodyThatTouchesAWallExactlyIsTheReferences() {
        try (World world = WorldScenes.jvm()
                .bounds(0, 0, 40, 40)
                .restitution(0)
                .subSteps(SUB_STEPS)
                .build()) {
            ReferenceWorld reference = new ReferenceWorld(0f, SUB_STEPS);
            reference.setBounds(0, 0, 40, 40);
            for (WorldCalls calls : List.of(WorldCalls.of(world), reference)) {
                long lens = calls.addRigid(BodyOutline.lens(2f), 39f, 20f, 0f, 1f, 0);
                calls.setRigidVelocity(lens, 5f, 0f, 1f);
            }
            for (int step = 0; step < 20; step++) {
                world.step(1 / 60f);
                reference.step(1 / 60f, 1);
                assertThat(world.hash()).as("after step %d", step).isEqualTo(reference.hash());
            }
        }
    }
}
