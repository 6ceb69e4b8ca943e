package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.ByteBuffer;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Walls that setBounds moves: they travel to their new place within the next step, and push what they meet. */
class WorldWallsTest {
    private static final float DT = 1 / 60f;
    private static final float R = 0.5f;

    private static World.Builder world(float width, float height) {
        return WorldScenes.jvm().bounds(0, 0, width, height).threads(1);
    }

    /** The deepest pair, in radii {@link #R}. */
    private static float deepest(World world) {
        float[] c = new float[4 * world.size()];
        world.read(c);
        double deepest = 0;
        for (int i = 0; i < world.size(); i++) {
            for (int j = 0; j < i; j++) {
                double distance = Math.hypot(c[4 * i] - c[4 * j], c[4 * i + 1] - c[4 * j + 1]);
                deepest = Math.max(deepest, c[4 * i + 2] + c[4 * j + 2] - distance);
            }
        }
        return (float) deepest / R;
    }

    /** A thousand circles at a fill of 0.4 relax; then the left and the right wall close at 6 radii a second. */
    @Test
    @Tag("long")
    void wallsThatCloseDoNotPressCirclesDeepIntoEachOther() {
        float area = (float) (1000 * Math.PI * R * R);
        float height = (float) Math.sqrt(area / 0.75);
        float open = area / 0.4f / height;
        float closed = area / 0.75f / height;
        try (World world = world(open, height).build()) {
            Random random = new Random(1);
            for (int i = 0; i < 1000; i++) {
                float r = 0.4f + 0.2f * random.nextFloat();
                world.add(
                        R + random.nextFloat() * (open - 2 * R),
                        R + random.nextFloat() * (height - 2 * R),
                        r,
                        4 * r * r);
            }
            world.step(DT, 600);
            float deepest = 0;
            for (int step = 1; step * 3 * DT < open - closed; step++) {
                world.setBounds(step * 1.5f * DT, 0, open - step * 1.5f * DT, height);
                world.step(DT);
                deepest = Math.max(deepest, deepest(world));
            }
            assertThat(deepest).isLessThan(0.1f);
        }
    }

    /** 100 circles lie on a floor that rises for a second, at 0.01 to 0.8 radii a step. From 0.5 on some fly ahead of it. */
    @ParameterizedTest
    @CsvSource({"0.01, 0.01", "0.05, 0.01", "0.2, 0.1", "0.5, 0.3", "0.8, 0.3"})
    void aFloorThatRisesLiftsWhatLiesOnIt(float perStep, float error) {
        try (World world = world(10, 300).gravity(0, -10).restitution(0).build()) {
            for (int i = 0; i < 100; i++) {
                world.add(R + i % 10 * 0.99f * 2 * R * 0.909f, R + i / 10 * 2.2f * R, R * 0.9f, 1);
            }
            world.step(DT, 600);
            float before = centre(world);
            for (int step = 1; step <= 60; step++) {
                world.setBounds(0, step * perStep * R, 10, 300);
                world.step(DT);
            }
            float way = 60 * perStep * R;
            assertThat(centre(world) - before).isCloseTo(way, within(error * way));
            assertThat(meanVy(world)).isCloseTo(perStep * R / DT, within(error * perStep * R / DT));
        }
    }

    /** A step after the other, the floor comes up under one circle, which takes its place at the end of the first. */
    @ParameterizedTest
    @ValueSource(floats = {0.3f, 1f})
    void aStepBringsACircleToTheWallAndGivesItTheWallsSpeed(float way) {
        try (World world = world(10, 10).restitution(0).build()) {
            long ball = world.add(5, R, R, 1);
            world.setBounds(0, way * R, 10, 10);
            assertThat(world.y(ball)).isEqualTo(R);
            world.step(DT);
            assertThat(world.y(ball)).isCloseTo(R + way * R, within(1e-5f));
            assertThat(world.vy(ball)).isCloseTo(way * R / DT, within(1e-3f));
            world.step(DT);
            assertThat(world.y(ball)).isCloseTo(R + 2 * way * R, within(1e-4f));
        }
    }

    @Test
    void aJumpOfAWallBringsCirclesInsideAndGivesThemNoSpeed() {
        try (World world = world(10, 10).restitution(0.5f).build()) {
            long small = world.add(5, R, R, 1);
            world.setBounds(0, 1.01f * R, 10, 10);
            assertThat(world.y(small)).isEqualTo(2.01f * R);
            // the way is no jump for this one
            long large = world.add(2, 4 * R, 3 * R, 1);
            world.setBounds(0, 1.01f * R + 1.5f * R, 10, 10);
            assertThat(world.y(small)).isEqualTo(3.51f * R);
            assertThat(world.y(large)).isEqualTo(4 * R);
            world.step(DT);
            assertThat(world.vy(small)).isZero();
            assertThat(world.y(large)).isCloseTo(5.51f * R, within(1e-5f));
            assertThat(world.vy(large)).isGreaterThan(1.4f * R / DT);
        }
    }

    @Test
    void wallsMoveInTheFirstOfSeveralStepsAlone() {
        try (World one = gas();
                World several = gas()) {
            for (World world : new World[] {one, several}) {
                world.step(DT);
                world.setBounds(0.3f, 0.1f, 19.7f, 19.8f);
            }
            several.step(DT, 3);
            for (int k = 0; k < 3; k++) {
                one.step(DT);
                one.setBounds(0.3f, 0.1f, 19.7f, 19.8f);
            }
            assertThat(several.hash()).isEqualTo(one.hash());
        }
    }

    @Test
    void wallsThatAreToMoveAreStateUntilTheStep() {
        try (World world = gas();
                World other = gas()) {
            world.step(DT);
            long before = world.hash();
            int bytes = world.snapshotBytes();
            world.setBounds(0.3f, 0.1f, 19.7f, 19.8f);
            assertThat(world.hash()).isNotEqualTo(before);
            assertThat(world.snapshotBytes()).isGreaterThan(bytes);
            ByteBuffer snapshot = ByteBuffer.allocate(world.snapshotBytes());
            world.snapshot(snapshot);
            other.restore(snapshot.flip());
            assertThat(other.hash()).isEqualTo(world.hash());
            world.step(DT);
            other.step(DT);
            assertThat(other.hash()).isEqualTo(world.hash());
            world.setBounds(0, 0, 20, 20);
            world.setBounds(0.3f, 0.1f, 19.7f, 19.8f);
            assertThat(world.hash()).as("moved to and fro").isEqualTo(other.hash());
        }
    }

    @Test
    void aWallThatMovesStopsFastCirclesWhereItMeetsThem() {
        try (World world = world(100, 10).restitution(1).build()) {
            long ball = world.add(20, 5, R, 1, -10 * R / DT, 0);
            for (int step = 1; step <= 10; step++) {
                world.setBounds(0.4f * R * step, 0, 100, 10);
                world.step(DT);
                assertThat(world.x(ball)).isGreaterThanOrEqualTo(0.4f * R * step + R);
            }
            assertThat(world.vx(ball)).isCloseTo(10.8f * R / DT, within(0.01f * R / DT));
        }
    }

    private static World gas() {
        World world = world(20, 20).gravity(0, -5).build();
        Random random = new Random(3);
        for (int i = 0; i < 150; i++) {
            world.add(
                    1 + 18 * random.nextFloat(),
                    1 + 18 * random.nextFloat(),
                    0.3f + 0.3f * random.nextFloat(),
                    1,
                    4 * random.nextFloat() - 2,
                    4 * random.nextFloat() - 2);
        }
        return world;
    }

    private static float meanVy(World world) {
        float[] v = new float[2 * world.size()];
        world.readVelocities(v);
        double sum = 0;
        for (int i = 1; i < v.length; i += 2) {
            sum += v[i];
        }
        return (float) (sum / world.size());
    }

    private static float centre(World world) {
        float[] c = new float[4 * world.size()];
        world.read(c);
        double sum = 0;
        for (int i = 1; i < c.length; i += 4) {
            sum += c[i];
        }
        return (float) (sum / world.size());
    }

    /** Walls that close at 1 m/s on an elastic ball. It bounces some times. */
    @ParameterizedTest
    @CsvSource({"5, 1", "2, 0.5", "40, 1", "20, 5", "5, -0.5", "20, -2"})
    void anElasticBallGainsTwiceTheSpeedOfTheWall(float speed, float wall) {
        try (World world = world(40, 10).restitution(1).build()) {
            long ball = world.add(10, 5, R, 1, speed, 0);
            float last = speed;
            int bounces = 0;
            for (int step = 1; step <= 1000 && bounces < 5; step++) {
                float in = step * wall * DT;
                if (40 - 2 * in < 6) {
                    break;
                }
                world.setBounds(in, 0, 40 - in, 10);
                world.step(DT);
                float now = world.vx(ball);
                if (now * last < 0) {
                    assertThat(Math.abs(now) - Math.abs(last)).isCloseTo(2 * wall, within(0.05f * Math.abs(wall)));
                    bounces++;
                }
                last = now;
            }
            assertThat(bounces).isGreaterThan(0);
        }
    }
}
