package io.github.circles2d;

import static io.github.circles2d.Refusals.assertIllegalArgument;
import static io.github.circles2d.WorldScenes.snapshot;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Axes that are open or wrap. */
class WorldEdgesTest {
    private static final float STEP = 1 / 60f;

    private static World.Builder wrapped() {
        return WorldScenes.jvm().bounds(-1, 2, 3, 5).edges(Edge.WRAP, Edge.WRAP).restitution(1);
    }

    private static World.Builder open() {
        return WorldScenes.jvm()
                .bounds(0, 0, 10, 10)
                .edges(Edge.OPEN, Edge.OPEN)
                .restitution(1);
    }

    // ---- wrapped

    @ParameterizedTest
    @CsvSource({"1, 0", "-1, 0", "0, 1", "0, -1", "-1.3, 0.7", "17, -23"})
    void aCircleThatCrossesTheSeamAHundredTimesIsWhereItShouldBe(float vx, float vy) {
        try (World world = wrapped().build()) {
            long circle = world.add(1, 3, 0.1f, 1, vx, vy);
            int seams = 0;
            double expectedX = 1;
            double expectedY = 3;
            for (int k = 1; seams < 100; k++) {
                float x = world.x(circle);
                float y = world.y(circle);
                world.step(STEP);
                boolean crossed = Math.abs(world.x(circle) - x) > 2 || Math.abs(world.y(circle) - y) > 1.5f;
                seams += crossed ? 1 : 0;
                expectedX = -1 + mod(2 + (double) k * STEP * vx, 4);
                expectedY = 2 + mod(1 + (double) k * STEP * vy, 3);
                assertThat(world.x(circle)).isBetween(-1f, Math.nextDown(3f));
                assertThat(world.y(circle)).isBetween(2f, Math.nextDown(5f));
            }
            assertThat(Math.abs(Math.IEEEremainder(world.x(circle) - expectedX, 4)))
                    .isLessThan(1e-3);
            assertThat(Math.abs(Math.IEEEremainder(world.y(circle) - expectedY, 3)))
                    .isLessThan(1e-3);
            assertThat(world.vx(circle)).isEqualTo(vx);
            assertThat(world.vy(circle)).isEqualTo(vy);
        }
    }

    private static double mod(double a, double b) {
        return a - Math.floor(a / b) * b;
    }

    @ParameterizedTest
    @CsvSource({"0.3", "1", "3"})
    void circlesThatMeetAtTheCornerOfTheSeamExchangeTheirVelocities(float speed) {
        try (World world = wrapped().build()) {
            long a = world.add(3 - 0.4f, 5 - 0.4f, 0.1f, 1, speed, speed);
            long b = world.add(-1 + 0.4f, 2 + 0.4f, 0.1f, 1, -speed, -speed);
            world.step(STEP, (int) (60 / speed));
            assertThat(world.vx(a)).isCloseTo(-speed, within(1e-4f * speed));
            assertThat(world.vy(a)).isCloseTo(-speed, within(1e-4f * speed));
            assertThat(world.vx(b)).isCloseTo(speed, within(1e-4f * speed));
            assertThat(world.vy(b)).isCloseTo(speed, within(1e-4f * speed));
        }
    }

    /** A blow goes round the torus, from circle to circle, and comes back to where it began. */
    @Test
    void aChainRoundTheTorusHandsABlowOn() {
        int circles = 16;
        try (World world = wrapped().build()) {
            long[] chain = new long[circles];
            for (int k = 0; k < circles; k++) {
                chain[k] = world.add(-1 + 0.25f * k, 2, 0.115f, 1, 0, 0);
            }
            world.setVelocity(chain[3], 2, 0);
            boolean[] moved = new boolean[circles];
            for (int step = 0; step < 600; step++) {
                world.step(STEP);
                float momentum = 0;
                for (int k = 0; k < circles; k++) {
                    double way = Math.IEEEremainder(world.x(chain[k]) - (-1 + 0.25 * k), 4);
                    moved[k] |= way > 0.015;
                    momentum += world.vx(chain[k]);
                }
                assertThat(momentum).isCloseTo(2, within(1e-3f));
            }
            assertThat(moved).containsOnly(true);
        }
    }

    /** A gas that has no walls keeps momentum and energy; radii differ by ten, so levels of the grid meet at the seam too. */
    @ParameterizedTest
    @CsvSource({"1", "10"})
    void anElasticGasKeepsMomentumAndEnergy(float ratio) {
        SplittableRandom random = new SplittableRandom(5);
        try (World world = wrapped().build()) {
            int n = 300;
            for (int k = 0; k < n; k++) {
                float r = k % 10 == 0 ? 0.1f : 0.1f / ratio * (ratio == 1 ? 0.4f : 1);
                world.add(
                        -1 + 0.2f * (k % 20) + 0.01f * random.nextInt(2),
                        2 + 0.2f * (k / 20),
                        0.9f * r,
                        r * r * 100,
                        2 * (float) random.nextDouble() - 1,
                        2 * (float) random.nextDouble() - 1);
            }
            double[] before = totals(world, n);
            int contacts = 0;
            for (int k = 0; k < 40; k++) {
                world.step(STEP, 50);
                contacts += world.stats().contacts();
            }
            double[] after = totals(world, n);
            assertThat(contacts).isPositive();
            assertThat((after[0] - before[0]) / before[3]).isCloseTo(0, within(1e-5));
            assertThat((after[1] - before[1]) / before[3]).isCloseTo(0, within(1e-5));
            assertThat(after[2] / before[2]).isCloseTo(1, within(1e-3));
        }
    }

    /** Momentum along x and y, energy, and the sum of the magnitudes of all momenta. */
    private static double[] totals(World world, int n) {
        float[] circles = new float[4 * n];
        float[] velocities = new float[2 * n];
        world.read(circles);
        world.readVelocities(velocities);
        double[] sum = new double[4];
        for (int k = 0; k < n; k++) {
            double mass = circles[4 * k + 3];
            double vx = velocities[2 * k];
            double vy = velocities[2 * k + 1];
            sum[0] += mass * vx;
            sum[1] += mass * vy;
            sum[2] += mass * (vx * vx + vy * vy) / 2;
            sum[3] += mass * Math.sqrt(vx * vx + vy * vy);
        }
        return sum;
    }

    /** A pile of small circles rests on a large static one that lies across the seam, and none falls through. */
    @ParameterizedTest
    @CsvSource({"0", "2"})
    void aPileLiesAcrossTheSeam(float middle) {
        try (World world = WorldScenes.jvm()
                .bounds(0, 0, 4, 3)
                .edges(Edge.WRAP, Edge.WALL)
                .gravity(0, -10)
                .restitution(0)
                .build()) {
            world.add(middle, 0, 0.3f, Float.POSITIVE_INFINITY, 0, 0);
            SplittableRandom random = new SplittableRandom(1);
            for (int k = 0; k < 400; k++) {
                world.add(
                        middle + 4 * (float) random.nextDouble(), 1 + 2 * (float) random.nextDouble(), 0.03f, 1, 0, 0);
            }
            world.step(STEP, 600);
            Quality quality = new Quality(world);
            assertThat(quality.greatestSpeed).isLessThan(0.2);
            assertThat(quality.deepest).isLessThan(0.25);
            assertThat(quality.pairsAcrossTheSeam).isPositive();
        }
    }

    /** What a look at all pairs, the short way round, says of circles in a world that wraps. */
    private static final class Quality {
        private double greatestSpeed;
        private double deepest;
        private int pairsAcrossTheSeam;

        Quality(World world) {
            int n = world.size();
            float[] circles = new float[4 * n];
            float[] velocities = new float[2 * n];
            world.read(circles);
            world.readVelocities(velocities);
            double width = world.maxX() - world.minX();
            for (int a = 0; a < n; a++) {
                greatestSpeed = Math.max(greatestSpeed, Math.hypot(velocities[2 * a], velocities[2 * a + 1]));
                for (int b = 0; b < a; b++) {
                    double dx = circles[4 * a] - circles[4 * b];
                    double shortest = Math.IEEEremainder(dx, width);
                    double d = Math.hypot(shortest, circles[4 * a + 1] - circles[4 * b + 1]);
                    double radii = circles[4 * a + 2] + circles[4 * b + 2];
                    deepest = Math.max(deepest, (radii - d) / radii);
                    pairsAcrossTheSeam += Math.abs(dx) > width / 2 && d < 1.02 * radii ? 1 : 0;
                }
            }
        }
    }

    @ParameterizedTest
    @CsvSource({"10", "50", "200", "1000"})
    void noFastCircleFliesThroughAFenceAtTheSeam(float speed) {
        try (World world = wrapped().restitution(1).build()) {
            for (int k = 0; k < 30; k++) {
                world.add(-1, 2 + 0.1f * k, 0.06f, Float.POSITIVE_INFINITY, 0, 0);
            }
            SplittableRandom random = new SplittableRandom(3);
            int n = 40;
            long[] flying = new long[n];
            for (int k = 0; k < n; k++) {
                flying[k] = world.add(
                        1, 2.05f + 0.07f * k, 0.02f, 1, k % 2 == 0 ? speed : -speed, (float) random.nextDouble());
            }
            for (int step = 0; step < 300; step++) {
                float[] before = xs(world, flying);
                world.step(STEP);
                float[] after = xs(world, flying);
                for (int k = 0; k < n; k++) {
                    assertThat(Math.abs(after[k] - before[k]))
                            .as("circle %d in step %d", k, step)
                            .isLessThan(2f);
                }
            }
        }
    }

    private static float[] xs(World world, long[] handles) {
        float[] x = new float[handles.length];
        for (int k = 0; k < x.length; k++) {
            x[k] = world.x(handles[k]);
        }
        return x;
    }

    @Test
    void placesThatACallerGivesAreBroughtInside() {
        try (World world = wrapped().build()) {
            long circle = world.add(7.5f, -4, 0.1f, 1, 0, 0);
            assertThat(world.x(circle)).isEqualTo(-0.5f);
            assertThat(world.y(circle)).isEqualTo(2f);
            world.setPosition(circle, 3, 5);
            assertThat(world.x(circle)).isEqualTo(-1f);
            assertThat(world.y(circle)).isEqualTo(2f);
            world.teleport(circle, Math.nextDown(-1f), 1e9f);
            assertThat(world.x(circle)).isEqualTo(Math.nextDown(3f));
            assertThat(world.y(circle)).isBetween(2f, Math.nextDown(5f));
            assertThatThrownBy(() -> world.setPosition(circle, 2e9f, 3)).hasMessageContaining("x is 2.0E9");
        }
    }

    /** At the seam, and in the middle of the bounds. */
    @ParameterizedTest
    @CsvSource({"3", "1"})
    void staticCirclesTravelTheShortWayAndTakeAlongWhatTheyMeet(float where) {
        try (World world = wrapped().restitution(0).build()) {
            long paddle = world.add(where - 0.2f, 3, 0.1f, Float.POSITIVE_INFINITY, 0, 0);
            long ball = world.add(where + 0.1f, 3, 0.05f, 1, 0, 0);
            world.setPosition(paddle, where + 0.2f, 3);
            world.step(STEP);
            assertThat(wayX(world, paddle, where)).isCloseTo(0.2, within(1e-6));
            assertThat(wayX(world, ball, where)).isCloseTo(0.35, within(1e-2));
            world.setPosition(paddle, where - 0.2f, 3);
            world.step(STEP);
            assertThat(wayX(world, paddle, where)).isCloseTo(-0.2, within(1e-6));
            assertThat(wayX(world, ball, where)).isGreaterThan(0.3);
        }
    }

    private static double wayX(World world, long handle, float from) {
        return Math.IEEEremainder(world.x(handle) - from, 4);
    }

    @Test
    void explosionsPushTheShortWay() {
        try (World world = wrapped().build()) {
            long right = world.add(-0.9f, 3, 0.05f, 1, 0, 0);
            long left = world.add(2.7f, 3, 0.05f, 1, 0, 0);
            long far = world.add(1, 3, 0.05f, 1, 0, 0);
            assertThat(world.explode(2.95f, 3, 0.5f, 4, 0)).isEqualTo(2);
            assertThat(world.vx(right)).isEqualTo(4f);
            assertThat(world.vx(left)).isEqualTo(-4f);
            assertThat(world.vx(far)).isZero();
        }
    }

    @Test
    void eventsAreToldInsideTheBoundsAndOfNoWall() {
        try (World world = WorldScenes.jvm()
                .bounds(-1, 2, 3, 5)
                .edges(Edge.WRAP, Edge.WALL)
                .restitution(1)
                .build()) {
            world.report(Events.BEGIN | Events.HIT | Events.END | Events.WALL);
            for (int k = 0; k < 20; k++) {
                world.add(2.9f - 0.2f * k, 2.2f + 0.11f * k, 0.05f, 1, 3, 1);
                world.add(-0.9f, 2.2f + 0.11f * k, 0.05f, 1, -3, 1);
            }
            Events events = world.events();
            int pairs = 0;
            int walls = 0;
            for (int step = 0; step < 200; step++) {
                world.step(STEP);
                events = world.events();
                for (int e = 0; e < events.size(); e++) {
                    boolean atWall = events.side(e) != null;
                    pairs += atWall ? 0 : 1;
                    walls += atWall ? 1 : 0;
                    assertThat(events.side(e)).isNotIn(Events.Side.LEFT, Events.Side.RIGHT);
                    if (events.type(e) != Events.END) {
                        assertThat(events.x(e)).isBetween(-1f, Math.nextDown(3f));
                    }
                }
            }
            assertThat(pairs).isPositive();
            assertThat(walls).isPositive();
        }
    }

    @Test
    void interpolatedPositionsDoNotRunBackAcrossTheScreen() {
        try (World world = wrapped().build()) {
            long circle = world.add(2.9f, 4.9f, 0.05f, 1, 4, 4);
            FixedStep loop = new FixedStep(world, STEP);
            float lastX = 2.9f;
            for (int frame = 0; frame < 200; frame++) {
                loop.advance(STEP / 3, null);
                FloatBuffer positions = loop.positions(null);
                float x = positions.get(2 * World.id(circle));
                float way = (float) Math.IEEEremainder(x - lastX, 4);
                assertThat(x).isBetween(-1f, Math.nextDown(3f));
                assertThat(way).isBetween(-0.001f, 0.07f);
                lastX = x;
            }
        }
    }

    @Test
    void queriesFindTheSameAsALookAtAllCirclesTheShortWay() {
        SplittableRandom random = new SplittableRandom(11);
        try (World world = wrapped().build()) {
            int n = 300;
            for (int k = 0; k < n; k++) {
                world.add(value(random, -1, 3), value(random, 2, 5), value(random, 0.01f, 0.1f), 1, 0, 0);
            }
            float[] circles = new float[4 * n];
            long[] handles = new long[n];
            world.read(circles);
            world.readHandles(handles);
            long[] found = new long[n];
            float[] distances = new float[n];
            for (int k = 0; k < 300; k++) {
                float x = value(random, -6, 6);
                float y = value(random, -1, 9);
                float r = value(random, 0, k % 10 == 0 ? 3 : 0.4f);
                double[] distance = distances(circles, x, y);
                long[] expected = java.util.stream.IntStream.range(0, n)
                        .filter(i -> distance[i] <= r)
                        .mapToLong(i -> handles[i])
                        .toArray();
                int count = world.queries().overlapCircle(x, y, r, found);
                assertThat(Arrays.copyOf(found, count)).isEqualTo(expected);
                count = world.queries().nearest(x, y, 10, n, found, distances);
                assertThat(count).isEqualTo(n);
                double[] sorted = distance.clone();
                Arrays.sort(sorted);
                for (int i = 0; i < n; i++) {
                    assertThat(distances[i]).isCloseTo((float) sorted[i], within(1e-5f));
                }
                assertThat(Arrays.stream(found).distinct().count()).isEqualTo(n);
                assertThat(world.queries().pick(x, y) != 0)
                        .isEqualTo(Arrays.stream(distance).anyMatch(d -> d <= 0));
                count = world.queries().overlapBox(x - r, y - 0.5f * r, x + r, y + 0.5f * r, found);
                assertThat(Arrays.copyOf(found, count)).isEqualTo(inBox(circles, handles, x, y, r, 0.5f * r));
            }
        }
    }

    private static double[] distances(float[] circles, double x, double y) {
        double[] d = new double[circles.length / 4];
        for (int k = 0; k < d.length; k++) {
            double dx = Math.IEEEremainder(circles[4 * k] - x, 4);
            double dy = Math.IEEEremainder(circles[4 * k + 1] - y, 3);
            d[k] = Math.hypot(dx, dy) - circles[4 * k + 2];
        }
        return d;
    }

    private static long[] inBox(float[] circles, long[] handles, double x, double y, double w, double h) {
        return java.util.stream.IntStream.range(0, handles.length)
                .filter(k -> {
                    double dx = Math.max(Math.abs(Math.IEEEremainder(circles[4 * k] - x, 4)) - w, 0);
                    double dy = Math.max(Math.abs(Math.IEEEremainder(circles[4 * k + 1] - y, 3)) - h, 0);
                    return Math.hypot(dx, dy) <= circles[4 * k + 2];
                })
                .mapToLong(k -> handles[k])
                .toArray();
    }

    private static float value(SplittableRandom random, float low, float high) {
        return low + (high - low) * (float) random.nextDouble();
    }

    @Test
    void raysGoOnBeyondTheSeam() {
        try (World world = wrapped().build()) {
            long circle = world.add(-0.5f, 3, 0.25f, 1, 0, 0);
            float[] hit = new float[Queries.HIT_STRIDE];
            assertThat(world.queries().rayCast(2.5f, 3, 1, 0, hit)).isEqualTo(circle);
            assertThat(hit[Queries.DISTANCE]).isEqualTo(0.75f);
            assertThat(world.queries().circleCast(2.5f, 3, 0.1f, 0.5f, 0, hit)).isZero();
        }
    }

    // ---- open

    @Test
    void circlesGoOnBeyondTheBoundsAndMeetThere() {
        try (World world = open().build()) {
            long a = world.add(9, 5, 0.5f, 1, 10, 0);
            long b = world.add(60, 5, 0.5f, 1, 0, 0);
            long c = world.add(-500, -700, 0.5f, 1, 1, 1);
            long d = world.add(-490, -690, 0.5f, 1, -1, -1);
            world.step(STEP, 600);
            assertThat(world.x(a)).isCloseTo(59, within(0.1f));
            assertThat(world.vx(b)).isCloseTo(10, within(1e-3f));
            assertThat(world.x(b)).isGreaterThan(100f);
            assertThat(world.vx(c)).isCloseTo(-1, within(1e-3f));
            assertThat(world.vy(d)).isCloseTo(1, within(1e-3f));
        }
    }

    /** Two circles of one radius side by side bounce as exactly a million radii out as at home; farther, nothing breaks. */
    @ParameterizedTest
    @CsvSource({"0", "1e3", "-3e4", "1e5"})
    void collisionsFarOutAreLikeThoseAtHome(float where) {
        try (World world = open().build()) {
            long a = world.add(where - 2, where, 1, 1, 1, 0);
            long b = world.add(where + 2, where, 1, 1, -1, 0);
            world.step(STEP, 180);
            assertThat(world.vx(a)).isCloseTo(-1, within(1e-2f));
            assertThat(world.vx(b)).isCloseTo(1, within(1e-2f));
        }
    }

    @Test
    void circlesStopWhereCoordinatesEndAndStayFinite() {
        try (World world = open().build()) {
            world.report(Events.BEGIN | Events.HIT | Events.END | Events.WALL);
            SplittableRandom random = new SplittableRandom(2);
            int n = 200;
            for (int k = 0; k < n; k++) {
                float far = k % 4 == 0 ? 1e9f : k % 4 == 1 ? -1e9f : k % 4 == 2 ? 5e8f : 3;
                world.add(
                        far,
                        k % 3 == 0 ? far : 2,
                        k % 7 == 0 ? 1000 : value(random, 0.01f, 1),
                        k % 5 == 0 ? Float.POSITIVE_INFINITY : 1,
                        value(random, -1e9f, 1e9f),
                        value(random, -1e9f, 1e9f));
            }
            for (int k = 0; k < 40; k++) {
                world.step(k % 2 == 0 ? 1 : STEP);
                Events events = world.events();
                for (int e = 0; e < events.size(); e++) {
                    assertThat(events.side(e)).isNull();
                }
            }
            float[] circles = new float[4 * n];
            world.read(circles);
            for (int k = 0; k < n; k++) {
                assertThat(circles[4 * k]).isBetween(-1e9f, 1e9f);
                assertThat(circles[4 * k + 1]).isBetween(-1e9f, 1e9f);
            }
        }
    }

    @Test
    void boundsOfAnOpenAxisMayBeMovedAndMoveNoCircle() {
        try (World world = open().build()) {
            long circle = world.add(9, 9, 0.5f, 1, 0, 0);
            world.setBounds(0, 0, 5, 5);
            world.step(STEP, 10);
            assertThat(world.x(circle)).isEqualTo(9f);
            assertThat(world.y(circle)).isEqualTo(9f);
        }
    }

    // ---- both

    @Test
    void theBoundsOfAnAxisThatWrapsCannotBeMoved() {
        try (World world =
                WorldScenes.jvm().bounds(0, 0, 4, 4).edges(Edge.WRAP, Edge.WALL).build()) {
            world.setBounds(0, -1, 4, 5);
            assertThat(world.maxY()).isEqualTo(5f);
            assertIllegalArgument("an axis that wraps keeps its own", () -> world.setBounds(0, 0, 5, 4));
            assertThat(world.maxX()).isEqualTo(4f);
        }
    }

    @Test
    void circlesThatAreTooLargeForThePeriodAreRefused() {
        try (World world = wrapped().build()) {
            assertIllegalArgument("radius is 0.28, but must be from", () -> world.add(0, 3, 0.28f, 1, 0, 0));
            world.add(0, 3, 3 / 11f, 1, 0, 0);
            world.step(STEP);
        }
    }

    @Test
    void aPeriodThatIsTooShortForItsCoordinatesIsRefused() {
        World.Builder builder = WorldScenes.jvm().bounds(1e6f, 0, 1e6f + 10, 10);
        builder.edges(Edge.OPEN, Edge.WALL).build().close();
        assertIllegalArgument("an axis that wraps must have at least 61.03", () -> builder.edges(Edge.WRAP, Edge.WALL)
                .build());
        assertThatThrownBy(() -> builder.edges(null, Edge.WALL)).isInstanceOf(NullPointerException.class);
    }

    @Test
    void aSnapshotCarriesTheEdges() {
        try (World world = wrapped().build();
                World other = WorldScenes.jvm().build()) {
            world.add(2.9f, 4.9f, 0.1f, 1, 1, 1);
            world.add(-0.9f, 2.1f, 0.1f, 1, -1, -1);
            world.step(STEP, 5);
            ByteBuffer snapshot = ByteBuffer.allocate(world.snapshotBytes());
            world.snapshot(snapshot);
            other.restore(snapshot.flip());
            assertThat(other.edgeX()).isEqualTo(Edge.WRAP);
            assertThat(other.edgeY()).isEqualTo(Edge.WRAP);
            assertThat(other.hash()).isEqualTo(world.hash());
            world.step(STEP, 50);
            other.step(STEP, 50);
            assertThat(other.hash()).isEqualTo(world.hash());
        }
    }

    /** So close below a seam at 0 that the quotient by the period is 0, a step leaves a circle where it is. */
    @ParameterizedTest
    @CsvSource({"0, -1e-42", "-1e-45, 0"})
    void aSnapshotTakesACircleThatIsTheLeastBitBelowASeamAtZero(float x, float vx) {
        try (World world = WorldScenes.jvm()
                .bounds(0, 0, 100, 100)
                .edges(Edge.WRAP, Edge.WRAP)
                .build()) {
            long circle = world.add(x, x, 1, 1, vx, vx);
            world.step(STEP);
            assertThat(world.x(circle)).isNegative();
            long hash = world.hash();
            ByteBuffer snapshot = snapshot(world);
            world.clear();
            world.restore(snapshot);
            assertThat(world.hash()).isEqualTo(hash);
        }
    }

    @Test
    void aRecordingCarriesTheEdges() throws IOException {
        ByteArrayOutputStream log = new ByteArrayOutputStream();
        try (World world = wrapped().build();
                World player = WorldScenes.jvm().build()) {
            long paddle = world.add(2.9f, 4.9f, 0.1f, Float.POSITIVE_INFINITY, 1, 1);
            try (Recording recording = new Recording(world, log, 1)) {
                for (int k = 0; k < 20; k++) {
                    world.add(7 + 0.2f * k, 2, 0.05f, 1, 3, -k);
                    world.setPosition(paddle, 2.9f + 0.3f * k, 8);
                    world.step(STEP, 2);
                    world.explode(3, 5, 0.2f, 1, 0.3f);
                }
                assertThat(recording.steps()).isEqualTo(40);
            }
            Replay replay = new Replay(new ByteArrayInputStream(log.toByteArray()), player).run();
            assertThat(replay.equalUpTo()).isEqualTo(replay.steps()).isEqualTo(40);
            assertThat(player.hash()).isEqualTo(world.hash());
        }
    }

    @Test
    void worldsThatDifferInTheirEdgesAloneHaveOtherHashes() {
        long[] hashes = new long[9];
        for (int k = 0; k < 9; k++) {
            try (World world = WorldScenes.jvm()
                    .edges(Edge.values()[k % 3], Edge.values()[k / 3])
                    .build()) {
                world.add(0.5f, 0.5f, 0.01f, 1, 0, 0);
                hashes[k] = world.hash();
            }
        }
        assertThat(Arrays.stream(hashes).distinct().count()).isEqualTo(9);
    }
}
