package io.github.circles2d.bench.engines;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import io.github.circles2d.PairIndexing;
import io.github.circles2d.bench.Devices;
import io.github.circles2d.scenes.Quality;
import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

class EnginesTest {
    /** All engines; those on OpenCL where there is a device. */
    static List<String> all() {
        List<String> names = new ArrayList<>(Engines.PEERS);
        names.add(Engines.WORLD_JVM);
        for (String device : Devices.all().keySet()) {
            for (PairIndexing indexing : PairIndexing.values()) {
                names.add(Engines.thesis(indexing) + "@" + device);
            }
            names.add(Engines.world(device));
        }
        return names;
    }

    @Test
    void aDeviceIsThereWhereOneIsRequired() {
        if (Boolean.getBoolean("circles2d.device.required")) {
            assertThat(Devices.all()).isNotEmpty();
        }
    }

    @ParameterizedTest
    @MethodSource("all")
    void aSingleCircleFallsAsFarAsGravityTakesItInTheUnitsOfTheScene(String name) {
        Scene scene = Scenes.thesis(1, 3);
        try (Engine engine = Engines.create(name)) {
            Motion end = run(engine, scene, 60);
            // g t^2 / 2 after one second; engines that take the new velocity fall by g t dt / 2 more
            assertThat(end.x[0]).isCloseTo(scene.x(0), within(1e-5f));
            assertThat(scene.y(0) - end.y[0]).isBetween(0.005f - 1e-5f, 0.005f + 1e-4f);
            assertThat(end.vx[0]).isCloseTo(0f, within(1e-6f));
            assertThat(end.vy[0]).isCloseTo(-0.01f, within(1e-5f));
        }
    }

    @ParameterizedTest
    @MethodSource("all")
    @Tag("long")
    void aCrowdEndsInTheArenaAndHardlyOverlaps(String name) {
        Scene scene = Scenes.packed(300, 4);
        try (Engine engine = Engines.create(name)) {
            Motion end = run(engine, scene, 600);
            end.requirePlausible(scene, 0.01f);
            assertThat(end.quality(scene).meanDepth())
                    .isLessThan(0.5 * Quality.of(scene).meanDepth());
        }
    }

    @ParameterizedTest
    @MethodSource("all")
    @Tag("long")
    void loadingASceneAgainStartsItAnew(String name) {
        Scene scene = Scenes.packed(200, 5);
        try (Engine engine = Engines.create(name)) {
            // Where work-items race, the steps differ a little. What is left of the scene between them would differ by
            // more.
            float tolerance = engine.repeatable() ? 0 : 0.1f * (scene.maxX() - scene.minX());
            Motion first = run(engine, scene, 1);
            run(engine, Scenes.packed(50, 6), 3);
            Motion second = run(engine, scene, 1);
            for (int i = 0; i < scene.size(); i++) {
                assertThat(second.x[i]).isCloseTo(first.x[i], within(tolerance));
                assertThat(second.y[i]).isCloseTo(first.y[i], within(tolerance));
            }
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"java-all-pairs", "gdx-box2d", "jbox2d", "dyn4j", "java-grid", "world-jvm"})
    @Tag("long")
    void enginesThatSaySoEndTheSameRunInTheSameStateToTheBit(String name) {
        Scene scene = Scenes.packed(300, 7);
        try (Engine engine = Engines.create(name)) {
            assertThat(engine.repeatable()).isTrue();
            assertThat(run(engine, scene, 200).hash())
                    .isEqualTo(run(engine, scene, 200).hash());
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"gdx-box2d", "dyn4j", "world-jvm"})
    void enginesThatSearchFindTheSameCircles(String name) {
        Scene scene = Scenes.packed(40, 7);
        Random random = new Random(1);
        float[] discs = new float[3 * 100];
        float[] rays = new float[4 * 100];
        long overlaps = 0;
        for (int q = 0; q < 100; q++) {
            float x = random.nextFloat();
            float y = random.nextFloat();
            float radius = 0.2f * random.nextFloat();
            System.arraycopy(new float[] {x, y, radius}, 0, discs, 3 * q, 3);
            System.arraycopy(new float[] {0.01f, y, 0.98f, 0}, 0, rays, 4 * q, 4); // from left of all circles
            overlaps += overlapping(scene, x, y, radius);
        }
        try (SearchEngine engine = (SearchEngine) Engines.create(name)) {
            engine.loadCircles(scene);
            for (int repeat = 0; repeat < 2; repeat++) {
                assertThat(engine.overlaps(discs)).isEqualTo(overlaps);
                assertThat(engine.rayHits(rays)).isEqualTo(raysThatMeet(scene, rays));
            }
        }
    }

    private static long overlapping(Scene scene, float x, float y, float radius) {
        return IntStream.range(0, scene.size())
                .filter(i -> Math.hypot(scene.x(i) - x, scene.y(i) - y) <= scene.radius(i) + radius)
                .count();
    }

    /** Of horizontal rays that go all the way through the arena. */
    private static long raysThatMeet(Scene scene, float[] rays) {
        return IntStream.range(0, rays.length / 4)
                .filter(q -> IntStream.range(0, scene.size())
                        .anyMatch(i -> Math.abs(scene.y(i) - rays[4 * q + 1]) <= scene.radius(i)))
                .count();
    }

    @ParameterizedTest
    @ValueSource(strings = {"gdx-box2d", "jbox2d", "dyn4j", "world-jvm"})
    void massesAndRestitutionAreTheScenes(String name) {
        requireTheBlowOfTheCueBall(name, 0.25);
    }

    @ParameterizedTest
    @ValueSource(strings = {"gdx-box2d", "jbox2d", "dyn4j", "java-grid", "world-jvm"})
    void fixedCirclesStay(String name) {
        Scene scene = Scenes.noCollide();
        try (Engine engine = Engines.create(name)) {
            Motion end = run(engine, scene, 60);
            for (int i = 0; i < scene.size(); i++) {
                assertThat(end.x[i] - scene.x(i)).isCloseTo(scene.vx(i), within(0.05f));
                assertThat(end.y[i] - scene.y(i)).isCloseTo(scene.vy(i), within(0.05f));
            }
        }
    }

    /** Otherwise a comparison of their speeds would say nothing. */
    @Test
    @Tag("long")
    void thePlainGridSolvesAsWellAsWorld() {
        Scene scene = Scenes.packed(1250, Scenes.SEED);
        try (Engine grid = Engines.create("java-grid");
                Engine world = Engines.create("world-jvm")) {
            Quality plain = run(grid, scene, 600).quality(scene);
            Quality ours = run(world, scene, 600).quality(scene);
            assertThat(plain.meanDepth()).isBetween(0.4 * ours.meanDepth(), 2.5 * ours.meanDepth());
            assertThat(plain.deep()).isZero();
            assertThat(ours.deep()).isZero();
        }
    }

    /** It has restitution once a step: a blow through a whole rack keeps its momentum, but less of its energy than in World. */
    @Test
    void thePlainGridKeepsTheMomentumOfABlowAndTheMassesOfTheScene() {
        requireTheBlowOfTheCueBall("java-grid", 0.15);
    }

    /** Of the blow's energy, 0.5 a unit of mass, some is left. */
    private static void requireTheBlowOfTheCueBall(String name, double leastEnergy) {
        // The cue ball has hit the rack, no ball has reached a wall.
        Scene scene = Scenes.billiards(1);
        try (Engine engine = Engines.create(name)) {
            Motion end = run(engine, scene, 68);
            double momentum = 0;
            double energy = 0;
            for (int i = 0; i < scene.size(); i++) {
                momentum += scene.mass(i) * end.vx[i];
                energy += 0.5 * scene.mass(i) * (end.vx[i] * end.vx[i] + end.vy[i] * end.vy[i]);
            }
            // forwards, or back from the two balls behind it
            assertThat(Math.abs(end.vx[0])).as("the rack's apex moves").isGreaterThan(0.01f);
            assertThat(momentum).isCloseTo(scene.mass(15), within(1e-3));
            assertThat(energy).isBetween(leastEnergy * scene.mass(15), 0.5 * scene.mass(15));
        }
    }

    @Test
    void thePlainGridComesToRest() {
        Scene scene = Scenes.packed(300, 8);
        try (Engine grid = Engines.create("java-grid")) {
            Quality quality = run(grid, scene, 6000).quality(scene);
            assertThat(quality.kineticEnergyPerCircle()).isLessThan(1e-6);
            assertThat(quality.meanDepth()).isLessThan(0.002);
        }
    }

    @Test
    void thePlainGridBouncesOffAWallByTheRestitution() {
        Scene scene = Scenes.thesis(1, 3);
        try (Engine grid = Engines.create("java-grid")) {
            grid.load(scene);
            Motion motion = new Motion(1);
            float fall = 0;
            for (int step = 0; step < 1500; step++) {
                grid.step();
                grid.read(motion);
                if (motion.vy[0] > 0) {
                    assertThat(motion.vy[0]).isCloseTo(0.5f * fall, within(0.02f * fall));
                    return;
                }
                fall = -motion.vy[0];
            }
            throw new AssertionError("it has not bounced");
        }
    }

    @Test
    void theAllPairsLoopRefusesScenesOfAnotherArena() {
        try (Engine engine = Engines.create("java-all-pairs")) {
            assertThatThrownBy(() -> engine.load(Scenes.billiards(1)))
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessageContaining("billiards");
        }
    }

    @ParameterizedTest
    @MethodSource("all")
    void everyEngineHasRemarks(String name) {
        assertThat(Engines.remarks(name)).isNotBlank();
    }

    @Test
    void anUnknownEngineIsRefusedByName() {
        assertThatThrownBy(() -> Engines.create("havok"))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("havok");
    }

    private static Motion run(Engine engine, Scene scene, int steps) {
        engine.load(scene);
        for (int step = 0; step < steps; step++) {
            engine.step();
        }
        engine.finish();
        Motion motion = new Motion(scene.size());
        engine.read(motion);
        return motion;
    }
}
