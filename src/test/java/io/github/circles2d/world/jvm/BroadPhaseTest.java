package io.github.circles2d.world.jvm;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.opencl.TestScale;
import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.model.AxisEdge;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.snapshots.SavedState;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** The grid finds what a test of all pairs finds. */
class BroadPhaseTest {
    static Stream<Scene> scenes() {
        return Stream.of(
                Scenes.thesis(1250, Scenes.SEED),
                Scenes.gas(1500, Scenes.SEED),
                Scenes.mixed(2000, Scenes.SEED),
                Scenes.noCollide(),
                Scenes.bouncy(Scenes.SEED),
                Scenes.billiards(40),
                Scenes.oneCell(700, Scenes.SEED),
                Scenes.onePoint(1500, Scenes.SEED));
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void findsThePairsThatATestOfAllPairsFinds(Scene scene) {
        for (int threads = 1; threads <= 3; threads += 2) {
            try (JvmWorld world = new JvmWorld(scene, threads)) {
                for (int k = 0; k < TestScale.of(2, 4, 6); k++) {
                    compareOneStep(world);
                    world.step(1 + k * k);
                }
            }
        }
    }

    @Test
    void findsThePairsOfRadiiOverThreeDecadesAtAnySpeed() {
        Random random = new Random(3);
        Scene frame = Scenes.pyramid();
        try (JvmWorld world = new JvmWorld(frame, 2)) {
            for (int i = 0; i < 1500; i++) {
                float r = (float) (0.0001 * StrictMath.pow(1000, random.nextDouble()));
                float mass = i % 7 == 0 ? Float.POSITIVE_INFINITY : r * r;
                float speed = (float) StrictMath.pow(10, 4 * random.nextDouble() - 2);
                world.add(
                        random.nextFloat(),
                        random.nextFloat(),
                        r,
                        mass,
                        0.5f,
                        speed * (random.nextFloat() - 0.5f),
                        speed * (random.nextFloat() - 0.5f));
            }
            for (int k = 0; k < 8; k++) {
                compareOneStep(world);
            }
        }
    }

    @Test
    void findsThePairsAcrossTheEdgesOfATorusThatIsMuchSmallerThanTheArena() {
        for (int groups : new int[] {40, 150, 600}) {
            try (JvmWorld world = new JvmWorld(Scenes.pyramid(), 2)) {
                for (long handle : world.handles()) {
                    world.simulation.circles.remove(handle);
                }
                SparseArena.groups(groups, 3000, new Random(groups), world::add);
                for (int k = 0; k < 3; k++) {
                    compareOneStep(world);
                    assertThat(world.pipeline.contacts()).isGreaterThan(groups);
                }
            }
        }
    }

    static Stream<Arguments> edges() {
        return Stream.of(
                Arguments.of(AxisEdge.WALL, AxisEdge.WALL),
                Arguments.of(AxisEdge.OPEN, AxisEdge.OPEN),
                Arguments.of(AxisEdge.WRAP, AxisEdge.WRAP),
                Arguments.of(AxisEdge.WRAP, AxisEdge.OPEN),
                Arguments.of(AxisEdge.WALL, AxisEdge.WRAP));
    }

    /** Lines and rings, which lie in few buckets of the torus, of circles of all sizes and speeds; also across the edges of the arena. */
    @ParameterizedTest
    @MethodSource("edges")
    void findsThePairsOfLinesThatGoRoundTheTorusManyTimes(AxisEdge x, AxisEdge y) {
        for (int round = 0; round < TestScale.of(2, 4, 6); round++) {
            compareLines(new Bounds(0, 0, 1, 1, x, y), round);
        }
    }

    private static void compareLines(Bounds bounds, int round) {
        Random random = new Random(round);
        float acrossX = 0.5f * (round & 1);
        float acrossY = 0.5f * (round >> 1 & 1);
        try (JvmWorld world = new JvmWorld(bounds, 2)) {
            double more = round == 0 ? 0 : 40 * random.nextDouble();
            SparseArena.line(
                    900,
                    90 * round + more,
                    1,
                    1,
                    (px, py, r, mass, e, vx, vy) -> world.add(
                            around(px + acrossX, bounds.edgeX()),
                            around(py + acrossY, bounds.edgeY()),
                            r * (round < 3 ? 1 : 0.25f + 2 * random.nextFloat()),
                            random.nextInt(4) == 0 ? Float.POSITIVE_INFINITY : 1,
                            0.5f,
                            600 * r * (random.nextFloat() - 0.5f) * (random.nextInt(4) == 0 ? 8 : 0),
                            600 * r * (random.nextFloat() - 0.5f)));
            SparseArena.ring(
                    300,
                    1,
                    (px, py, r, mass, e, vx, vy) ->
                            world.add(around(px + acrossX, bounds.edgeX()), py, r, mass, e, r, -r));
            for (int k = 0; k < 3; k++) {
                compareOneStep(world);
                assertThat(world.pipeline.contacts()).isGreaterThan(300);
            }
        }
    }

    /** Where hardly anything moves, pairs are kept from step to step. What comes, goes, moves or grows there is found all the same. */
    @Test
    void findsThePairsOfAHeapThatHardlyMoves() {
        for (int threads = 1; threads <= 3; threads += 2) {
            Random random = new Random(threads);
            try (JvmWorld world = new JvmWorld(new Bounds(0, 0, 1, 1), threads)) {
                for (int i = 0; i < 1600; i++) {
                    float speed = i == 800 ? 0.6f : 0.003f;
                    world.add(
                            0.02f + 0.0203f * (i % 40),
                            0.02f + 0.0203f * (i / 40),
                            0.01f * (0.97f + 0.03f * random.nextFloat()),
                            1,
                            0,
                            speed * (random.nextFloat() - 0.5f),
                            speed * (random.nextFloat() - 0.5f));
                }
                int kept = 0;
                for (int k = 0; k < 120; k++) {
                    if (k % 3 == 2) {
                        change(world, random);
                    }
                    compareOneStep(world);
                    // if all cells are looked at, about seven pairs are tested for each circle
                    kept += world.pipeline.candidatePairs() < 4L * 1600 ? 1 : 0;
                }
                assertThat(kept).isGreaterThan(20);
            }
        }
    }

    private static void change(JvmWorld world, Random random) {
        long[] handles = world.handles();
        long circle = handles[random.nextInt(handles.length)];
        float x = 0.02f + 0.8f * random.nextFloat();
        float y = 0.02f + 0.8f * random.nextFloat();
        switch (random.nextInt(6)) {
            case 0 -> world.simulation.circles.remove(circle);
            case 1 -> world.add(x, y, 0.008f, 1, 0, 0, 0);
            case 2 -> world.simulation.circles.set(Commands.POSITION, circle, x, y);
            case 3 -> world.simulation.circles.set(Commands.VELOCITY, circle, 6 * x - 3, 6 * y - 3);
            case 4 -> world.simulation.circles.set(Commands.RADIUS, circle, 0.007f + 0.003f * random.nextFloat(), 0);
            default ->
                world.simulation.circles.set(
                        Commands.MASS, circle, random.nextBoolean() ? Float.POSITIVE_INFINITY : 1, 0);
        }
    }

    private static float around(float x, AxisEdge edge) {
        return edge == AxisEdge.WRAP && x >= 1 ? x - 1 : edge == AxisEdge.WALL ? Math.min(x, 1) : x;
    }

    private static void compareOneStep(JvmWorld world) {
        SavedState before = world.save();
        world.step(1);
        List<Long> expected = AllPairs.of(before, world.pipeline);
        List<Long> found = new ArrayList<>();
        for (int c = 0; c < world.pipeline.contacts(); c++) {
            found.add(world.pipeline.contacts.ids(c));
        }
        Collections.sort(found);
        assertThat(found).isEqualTo(expected);
    }
}
