package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Boxes that lie flush are as smooth as one long line; what sticks out of them is felt. */
class WorldTerrainTilesTest {
    private static final float STEP = 1 / 60f;

    /** A row of boxes, turned around a place, with its upper side along the x axis before. */
    private record Row(double degrees, double x, double y, int boxes, double width) {
        private double cos() {
            return Math.cos(Math.toRadians(degrees));
        }

        private double sin() {
            return Math.sin(Math.toRadians(degrees));
        }

        private float worldX(double along, double up) {
            return (float) (x + cos() * along - sin() * up);
        }

        private float worldY(double along, double up) {
            return (float) (y + sin() * along + cos() * up);
        }

        private double along(World world, long ball) {
            return cos() * (world.x(ball) - x) + sin() * (world.y(ball) - y);
        }

        private double up(World world, long ball) {
            return cos() * (world.y(ball) - y) - sin() * (world.x(ball) - x);
        }

        private World.Builder world(double restitution, double friction) {
            return TerrainBall.builder(10, friction, restitution).gravity((float) (10 * sin()), (float) (-10 * cos()));
        }

        /** Clockwise boxes are hollow: circles are inside. */
        private Chain box(int k, double high) {
            double[] along = {k * width, (k + 1) * width, (k + 1) * width, k * width};
            double[] up = {-1, -1, high, high};
            float[] points = new float[8];
            for (int i = 0; i < 4; i++) {
                points[2 * i] = worldX(along[i], up[i]);
                points[2 * i + 1] = worldY(along[i], up[i]);
            }
            return Chain.of(points).close();
        }

        private void build(Terrain terrain) {
            for (int k = 0; k < boxes; k++) {
                terrain.addChain(box(k, 0));
            }
        }

        private long ball(World world, float r, double at, double v) {
            long ball = world.add(worldX(at, r), worldY(at, r), r, 1, (float) (cos() * v), (float) (sin() * v));
            world.setAngularVelocity(ball, (float) (-v / r));
            return ball;
        }

        /** A ball lies on the boxes, and goes along them to half a radius before their end: so fast, and no higher or lower. */
        private void runsSmoothly(World world, float r, double v, double slackOfSpeed, double slackOfHeight) {
            long ball = ball(world, r, r, v);
            for (int step = 0; along(world, ball) < boxes * width - v * STEP - 0.5 * r; step++) {
                world.step(STEP);
                double speed = cos() * world.vx(ball) + sin() * world.vy(ball);
                assertThat(speed).as("speed after step %d", step).isCloseTo(v, within(slackOfSpeed));
                assertThat(up(world, ball)).as("height after step %d", step).isCloseTo(r, within(slackOfHeight));
            }
        }
    }

    private static Row level(int boxes, double width) {
        return new Row(0, 0, 0, boxes, width);
    }

    /** Of fast ones, the stops let none be caught. */
    @ParameterizedTest
    @CsvSource({
        "60, 1, 0.5, 20, 0.5",
        "60, 1, 0.5, 20, 0",
        "60, 1, 0.5, 0.5, 1",
        "60, 1, 0.5, 3, 1",
        "60, 1, 0.5, 200, 0.5",
        "120, 0.5, 0.5, 20, 0.5",
        "300, 0.1, 0.5, 20, 0.5",
        "10, 6, 0.5, 20, 0.5",
        "10, 6, 0.05, 200, 1"
    })
    void aBallSlidesOverBoxesAsOverALine(int boxes, double width, float r, double v, double restitution) {
        try (World world = level(boxes, width).world(restitution, 0).build()) {
            level(boxes, width).build(world.terrain());
            level(boxes, width).runsSmoothly(world, r, v, 1e-4 * v, 1e-5);
        }
    }

    @Test
    void aBallRollsOverBoxes() {
        try (World world = level(60, 1).world(0.5, 0.6).build()) {
            level(60, 1).build(world.terrain());
            level(60, 1).runsSmoothly(world, 0.5f, 20, 0.002, 1e-5);
        }
    }

    /** The points of boxes are off by a rounding. */
    @ParameterizedTest
    @CsvSource({"30, 0, 0, 20", "30, 0, 0, 3", "30, 0, 0, 200", "137, 300, -900, 20"})
    void boxesMayBeTurnedAndFarAway(double degrees, double x, double y, double v) {
        Row row = new Row(degrees, x, y, 60, 1);
        try (World world = row.world(0.5, 0)
                .bounds((float) x - 100, (float) y - 100, (float) x + 100, (float) y + 100)
                .build()) {
            row.build(world.terrain());
            row.runsSmoothly(world, 0.5f, v, 0.002 + 1e-4 * v, 5e-4);
        }
    }

    @Test
    void boxesMayBeUnderAFloorAndOneWay() {
        try (World world = level(60, 1).world(0.5, 0).build()) {
            level(60, 1).build(world.terrain());
            world.terrain().addSegment(-10, 0, 70, 0);
            level(60, 1).runsSmoothly(world, 0.5f, 20, 0.002, 1e-5);
        }
        try (World world = level(60, 1).world(0.5, 0).build()) {
            world.kind(2).setOneWay(true);
            for (int k = 0; k < 60; k++) {
                world.terrain().addChain(level(60, 1).box(k, 0), 2, null);
            }
            level(60, 1).runsSmoothly(world, 0.5f, 20, 0.002, 1e-5);
        }
    }

    /** Boxes of two bodies, one of them turned by a quarter, are flush with those of the ground, and go along it, in and out of its boxes. */
    @ParameterizedTest
    @ValueSource(floats = {0, 0.05f})
    void aLiftMayBeFlushWithItsGround(float speed) {
        try (World world = level(60, 1).world(0.5, 0).gravity(0, -10).build()) {
            TerrainBody lift = world.terrain().addBody(3, -7, 0);
            TerrainBody other = world.terrain().addBody(-5, 9, (float) (Math.PI / 2));
            for (int k = 0; k < 60; k++) {
                float x = k;
                if (k % 3 == 0) {
                    world.terrain().addChain(level(60, 1).box(k, 0));
                } else if (k % 3 == 1) {
                    lift.addChain(Chain.of(x - 3.2f, 6, x - 1.8f, 6, x - 1.8f, 7, x - 3.2f, 7)
                            .close());
                } else {
                    // turned by a quarter anticlockwise: (x, y) is at (-5 - y, 9 + x)
                    other.addChain(Chain.of(-10, -4.8f - x, -10, -6.2f - x, -9, -6.2f - x, -9, -4.8f - x)
                            .close());
                }
            }
            lift.setVelocity(speed, 0);
            other.setVelocity(-speed, 0);
            level(60, 1).runsSmoothly(world, 0.5f, 20, 0.002, 5e-4);
        }
    }

    /** A ball falls along a wall of bricks that presses it, or that it bounces off. */
    @ParameterizedTest
    @CsvSource({"0.5, 1", "3, 0.25", "20, 1", "200, 1"})
    void aWallOfBricksIsSmooth(double v, double height) {
        for (double restitution : new double[] {0, 0.5, 1}) {
            try (World world = bricks(restitution, height)) {
                world.setGravity(-10, 0);
                long ball = world.add(0.5f, 20.3f, 0.5f, 1, 0, (float) -v);
                for (int step = 0; step < 60 && world.y(ball) > -10; step++) {
                    world.step(STEP);
                    assertThat(world.vy(ball)).isCloseTo((float) -v, within((float) (1e-4 * v)));
                    assertThat(world.x(ball)).isCloseTo(0.5f, within(1e-5f));
                }
            }
        }
    }

    @ParameterizedTest
    @CsvSource({"0, 0.3", "0.5, 0.3", "3, 1", "20, 20", "7, 0.3", "60, 3"})
    void elasticBallsLeaveWallsOfBricksAsTheyCame(double v, double vn) {
        for (double height : new double[] {0.1, 0.25, 1}) {
            for (int k = 0; k < 20; k++) {
                try (World world = bricks(1, height)) {
                    long ball = world.add(0.55f, 20 + 0.0713f * k, 0.5f, 1, (float) -vn, (float) -v);
                    int steps = (int) (0.1 / vn * 60) + 3;
                    world.step(STEP, steps);
                    assertThat(world.vx(ball)).as("shot %d", k).isCloseTo((float) vn, within(1e-3f));
                    assertThat(world.vy(ball)).as("shot %d", k).isCloseTo((float) -v, within(1e-3f));
                }
            }
        }
    }

    private static World bricks(double restitution, double height) {
        World world = TerrainBall.builder(0, 0, restitution).build();
        for (int k = 0; k < 50 / height; k++) {
            float y = (float) (k * height - 20);
            float high = (float) ((k + 1) * height - 20);
            float x = k % 2 == 0 ? -1 : -1.5f;
            world.terrain().addChain(Chain.of(x, y, 0, y, 0, high, x, high).close());
        }
        return world;
    }

    // ---- what sticks out is felt

    /** A ball that slides over the last edge falls around it as if there were one box. */
    @ParameterizedTest
    @ValueSource(doubles = {0.2, 1, 3, 20})
    void theLastEdgeIsExact(double v) {
        List<Float> alone = edge(
                v,
                terrain -> terrain.addChain(Chain.of(-9, -1, 0, -1, 0, 0, -9, 0).close()));
        List<Float> tiles = edge(v, terrain -> {
            for (int k = -9; k < 0; k++) {
                terrain.addChain(Chain.of(k, -1, k + 1, -1, k + 1, 0, k, 0).close());
                terrain.addChain(Chain.of(k, -2, k + 1, -2, k + 1, -1, k, -1).close());
            }
        });
        assertThat(tiles).isEqualTo(alone);
    }

    private static List<Float> edge(double v, Consumer<Terrain> build) {
        List<Float> way = new ArrayList<>();
        try (World world = TerrainBall.builder(10, 0, 0.5).build()) {
            build.accept(world.terrain());
            long ball = world.add(-0.45f, 0.5f, 0.5f, 1, (float) v, 0);
            for (int step = 0; step < 240 && world.y(ball) > -0.2f; step++) {
                world.step(STEP);
                way.add(world.x(ball));
                way.add(world.y(ball));
                way.add(world.vx(ball));
            }
        }
        return way;
    }

    /** Between two boxes is a gap: a ball lies in it, on both corners. */
    @ParameterizedTest
    @CsvSource({"0.2", "0.6", "0.9"})
    void aGapHasCorners(float gap) {
        try (World world = TerrainBall.builder(10, 0, 0).build()) {
            world.terrain().addChain(Chain.of(-5, -1, 0, -1, 0, 0, -5, 0).close());
            world.terrain().addChain(Chain.of(gap, -1, 5, -1, 5, 0, gap, 0).close());
            long ball = world.add(0.5f * gap, 0.6f, 0.5f, 1, 0, 0);
            world.step(STEP, 300);
            assertThat(world.x(ball)).isCloseTo(0.5f * gap, within(1e-3f));
            assertThat(world.y(ball)).isCloseTo((float) Math.sqrt(0.25 - 0.25 * gap * gap), within(2e-3f));
        }
    }

    /** A step of a hundredth of a radius in a chain's box is a corner, not a bump that a ball sinks into. */
    @Test
    void aSmallStepIsFelt() {
        try (World world = level(20, 1).world(0, 0).build()) {
            level(10, 1).build(world.terrain());
            for (int k = 10; k < 20; k++) {
                world.terrain().addChain(level(20, 1).box(k, 0.005));
            }
            long ball = level(20, 1).ball(world, 0.5f, 5, 3);
            double deepest = 0;
            for (int step = 0; step < 120; step++) {
                world.step(STEP);
                double x = world.x(ball);
                double up = x > 10 ? 0.005 : x > 9.92 ? 0.005 - 0.5 + Math.sqrt(0.25 - (10 - x) * (10 - x)) : 0;
                deepest = Math.max(deepest, 0.5 + up - world.y(ball));
            }
            assertThat(world.x(ball)).isGreaterThan(10.5f);
            assertThat(deepest).isLessThan(1e-3);
        }
    }
}
