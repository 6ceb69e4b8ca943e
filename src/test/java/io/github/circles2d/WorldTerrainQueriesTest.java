package io.github.circles2d;

import static io.github.circles2d.Refusals.assertIllegalArgument;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.geom.Line2D;
import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Queries of a world find the pieces of its terrain where they are now. */
class WorldTerrainQueriesTest {
    private static final float DT = 1 / 60f;
    private static final int STRIDE = Queries.HIT_STRIDE;

    private final World world = WorldScenes.jvm().bounds(-100, -100, 100, 100).build();
    private final Terrain terrain = world.terrain();
    private final TerrainQueries queries = world.queries().terrain();
    private final Random random = new Random(5);

    @AfterEach
    void close() {
        world.close();
    }

    private float coordinate() {
        return 200 * random.nextFloat() - 100;
    }

    /** Segments on the ground and on bodies that turn, and their ends as the world reads them. */
    @Test
    void segmentsAreFoundWhereTheirBodiesHaveBroughtThem() {
        world.add(0, 0, 1, 1);
        for (int k = 0; k < 100; k++) {
            float x = coordinate();
            float y = coordinate();
            terrain.addSegment(x, y, x + 10 * random.nextFloat(), y + 5);
        }
        for (int k = 0; k < 20; k++) {
            TerrainBody body = terrain.addBody(coordinate(), coordinate(), random.nextFloat());
            body.addSegment(-4, 0, 4, 0);
            body.addSegment(0, -3, 0, 3, 0.5f, 0);
            body.setVelocity(3 * random.nextFloat(), 2);
            body.setAngularVelocity(random.nextFloat());
        }
        for (int round = 0; round < 5; round++) {
            compareSegments();
            world.step(DT, 20);
        }
        terrain.remove(terrain.handle(7));
        terrain.addSegment(0, 0, 50, 50);
        compareSegments();
    }

    private void compareSegments() {
        int n = terrain.size();
        float[] pieces = new float[Terrain.PIECE_STRIDE * n];
        long[] handles = new long[n];
        terrain.readPieces(pieces, handles);
        for (int q = 0; q < 100; q++) {
            float x = coordinate();
            float y = coordinate();
            float radius = 20 * random.nextFloat();
            float dx = coordinate();
            float dy = coordinate();
            long[] overlapping = new long[n];
            int count = 0;
            double nearest = Double.POSITIVE_INFINITY;
            int rays = 0;
            for (int k = 0; k < n; k++) {
                int at = Terrain.PIECE_STRIDE * k;
                double d = Line2D.ptSegDist(
                                pieces[at + Terrain.X1],
                                pieces[at + Terrain.Y1],
                                pieces[at + Terrain.X2],
                                pieces[at + Terrain.Y2],
                                x,
                                y)
                        - pieces[at + Terrain.THICKNESS];
                if (d <= radius) {
                    overlapping[count++] = handles[k];
                }
                nearest = Math.min(nearest, d);
                double far = Math.sqrt(squared(pieces, at, x, y, dx, dy));
                rays += far <= pieces[at + Terrain.THICKNESS] ? 1 : 0;
            }
            long[] found = new long[n];
            assertThat(queries.overlapCircle(x, y, radius, found)).isEqualTo(count);
            assertThat(found).isEqualTo(overlapping);
            float[] hit = new float[STRIDE];
            assertThat(queries.nearest(x, y, Float.POSITIVE_INFINITY, 1, found, hit))
                    .isEqualTo(1);
            assertThat(hit[Queries.DISTANCE]).isCloseTo((float) nearest, within(1e-3f));
            assertThat(queries.pick(x, y, Float.POSITIVE_INFINITY)).isEqualTo(found[0]);
            assertThat(queries.pick(x, y, (float) Math.max(nearest - 0.01, 0))).isEqualTo(nearest < 0 ? found[0] : 0);
            int met = queries.rayCastAll(x, y, dx, dy, found, null);
            assertThat(met).isEqualTo(rays);
            assertThat(queries.rayCast(x, y, dx, dy, hit)).isEqualTo(met == 0 ? 0 : found[0]);
        }
    }

    /** The square of the distance of two segments. */
    private static double squared(float[] pieces, int at, float x, float y, float dx, float dy) {
        double ax = pieces[at + Terrain.X1];
        double ay = pieces[at + Terrain.Y1];
        double bx = pieces[at + Terrain.X2];
        double by = pieces[at + Terrain.Y2];
        double toX = (double) x + dx;
        double toY = (double) y + dy;
        if (Line2D.linesIntersect(ax, ay, bx, by, x, y, toX, toY)) {
            return 0;
        }
        return Math.min(
                Math.min(Line2D.ptSegDistSq(ax, ay, bx, by, x, y), Line2D.ptSegDistSq(ax, ay, bx, by, toX, toY)),
                Math.min(Line2D.ptSegDistSq(x, y, toX, toY, ax, ay), Line2D.ptSegDistSq(x, y, toX, toY, bx, by)));
    }

    private void fill() {
        for (int k = 0; k < 60; k++) {
            float x = coordinate();
            float y = coordinate();
            terrain.addChain(Chain.of(x, y, x - 5, y + 1, x - 9, y - 2), k % 3, null);
            terrain.addArc(y, x, 2 + 4 * random.nextFloat(), random.nextFloat(), 4, ArcSide.OUTER, k % 3);
            terrain.addArc(y, -x, 2 + 9 * random.nextFloat(), random.nextFloat(), 4, ArcSide.INNER);
        }
    }

    @Test
    void batchesAnswerAsSingleQueriesDo() {
        fill();
        int n = 50;
        float[] numbers = new float[5 * n];
        for (int k = 0; k < numbers.length; k++) {
            numbers[k] = k % 5 == 2 ? 8 * random.nextFloat() : coordinate();
        }
        float[] points = Arrays.copyOf(numbers, 2 * n);
        float[] discs = new float[3 * n];
        float[] boxes = new float[4 * n];
        for (int q = 0; q < n; q++) {
            System.arraycopy(numbers, 5 * q, discs, 3 * q, 3);
            boxes[4 * q] = numbers[5 * q];
            boxes[4 * q + 1] = numbers[5 * q + 1];
            boxes[4 * q + 2] = numbers[5 * q] + 12;
            boxes[4 * q + 3] = numbers[5 * q + 1] + 20;
        }
        int[] ends = new int[n];
        long[] all = new long[10_000];
        float[] hits = new float[STRIDE * all.length];
        long[] one = new long[400];
        float[] hit = new float[STRIDE * one.length];
        int from = 0;
        assertThat(queries.overlapCircle(discs, n, ends, all)).isPositive();
        for (int q = 0; q < n; q++) {
            int count = queries.overlapCircle(discs[3 * q], discs[3 * q + 1], discs[3 * q + 2], one);
            from = compare(one, count, all, from, ends[q]);
        }
        from = 0;
        assertThat(queries.overlapBox(boxes, n, ends, all)).isPositive();
        for (int q = 0; q < n; q++) {
            int b = 4 * q;
            from = compare(
                    one,
                    queries.overlapBox(boxes[b], boxes[b + 1], boxes[b + 2], boxes[b + 3], one),
                    all,
                    from,
                    ends[q]);
        }
        from = 0;
        assertThat(queries.circleCastAll(numbers, n, ends, all, hits)).isPositive();
        for (int q = 0; q < n; q++) {
            int c = 5 * q;
            int count = queries.circleCastAll(
                    numbers[c], numbers[c + 1], numbers[c + 2], numbers[c + 3], numbers[c + 4], one, hit);
            assertThat(Arrays.copyOf(hit, STRIDE * count))
                    .isEqualTo(Arrays.copyOfRange(hits, STRIDE * from, STRIDE * ends[q]));
            from = compare(one, count, all, from, ends[q]);
        }
        from = 0;
        assertThat(queries.rayCastAll(boxes, n, ends, all, hits)).isPositive();
        for (int q = 0; q < n; q++) {
            int b = 4 * q;
            int count = queries.rayCastAll(boxes[b], boxes[b + 1], boxes[b + 2], boxes[b + 3], one, hit);
            from = compare(one, count, all, from, ends[q]);
        }
        assertThat(queries.circleCast(numbers, n, all, hits)).isPositive();
        for (int q = 0; q < n; q++) {
            int c = 5 * q;
            assertThat(queries.circleCast(
                            numbers[c], numbers[c + 1], numbers[c + 2], numbers[c + 3], numbers[c + 4], hit))
                    .isEqualTo(all[q]);
            assertThat(Arrays.copyOf(hit, STRIDE)).isEqualTo(Arrays.copyOfRange(hits, STRIDE * q, STRIDE * q + STRIDE));
        }
        assertThat(queries.rayCast(boxes, n, all, null)).isPositive();
        for (int q = 0; q < n; q++) {
            int b = 4 * q;
            assertThat(queries.rayCast(boxes[b], boxes[b + 1], boxes[b + 2], boxes[b + 3], null))
                    .isEqualTo(all[q]);
        }
        int near = queries.nearest(points, n, 6, 3, all, hits);
        assertThat(near).isBetween(1, 3 * n - 1);
        for (int q = 0; q < n; q++) {
            int count = queries.nearest(points[2 * q], points[2 * q + 1], 6, 3, one, hit);
            compare(one, count, all, 3 * q, 3 * q + count);
            for (int k = count; k < 3; k++) {
                assertThat(all[3 * q + k]).isZero();
                assertThat(hits[STRIDE * (3 * q + k)]).isEqualTo(Float.POSITIVE_INFINITY);
            }
        }
        queries.pick(points, n, 6, all);
        for (int q = 0; q < n; q++) {
            assertThat(queries.pick(points[2 * q], points[2 * q + 1], 6)).isEqualTo(all[q]);
        }
    }

    private static int compare(long[] one, int count, long[] all, int from, int end) {
        assertThat(Arrays.copyOf(one, count)).isEqualTo(Arrays.copyOfRange(all, from, end));
        return end;
    }

    @Test
    void aMaskLeavesPiecesOfOtherCategoriesOut() {
        world.kind(1).setCategory(2);
        world.kind(2).setCategory(4);
        fill();
        TerrainQueries some = world.queries().withMask(2).terrain();
        TerrainQueries others = queries.withMask(4 | 2);
        long[] handles = new long[400];
        int ofOne = some.overlapBox(-200, -200, 200, 200, handles);
        for (int k = 0; k < ofOne; k++) {
            assertThat(terrain.kindOf(handles[k])).isEqualTo(1);
        }
        assertThat(ofOne).isEqualTo(3 * 20);
        assertThat(others.overlapBox(-200, -200, 200, 200, handles)).isEqualTo(2 * 3 * 20);
        assertThat(queries.overlapBox(-200, -200, 200, 200, handles)).isEqualTo(terrain.size());
        terrain.setKind(handles[0], 1);
        assertThat(some.overlapBox(-200, -200, 200, 200, handles)).isEqualTo(ofOne + 1);
        assertThat(world.queries().overlapBox(-200, -200, 200, 200, handles))
                .as("queries of circles find no terrain")
                .isZero();
    }

    @Test
    void oneWayPiecesAreMetFromTheirFrontAlone() {
        long platform = terrain.addSegment(10, 0, -10, 0, 0, 4);
        float[] hit = new float[STRIDE];
        assertThat(queries.rayCast(0, -5, 0, 10, hit)).isEqualTo(platform);
        assertThat(hit).containsExactly(5, 0, 0, 0, -1);
        world.kind(4).setOneWay(true);
        assertThat(queries.rayCast(0, -5, 0, 10, hit)).isZero();
        assertThat(hit).containsExactly(10, 0, 5, 0, 0);
        assertThat(queries.rayCast(0, 5, 0, -10, hit)).isEqualTo(platform);
        assertThat(hit).containsExactly(5, 0, 0, 0, 1);
        assertThat(queries.circleCast(0, 5, 1, 0, -10, hit)).isEqualTo(platform);
        assertThat(hit).containsExactly(4, 0, 1, 0, 1);
    }

    @Test
    void whatIsRefusedNamesTheValue() {
        terrain.addSegment(0, 0, 1, 0);
        assertIllegalArgument("y", () -> queries.rayCast(0, Float.NaN, 1, 0, null));
        assertIllegalArgument("10", () -> queries.nearest(0, 0, 1, 2, new long[2], new float[9]));
        assertIllegalArgument("query 1", () -> queries.pick(new float[] {0, 0, 0, Float.NaN}, 2, 1, new long[2]));
        assertIllegalArgument("radius", () -> queries.circleCast(0, 0, -1, 1, 0, null));
    }

    @Test
    void anExplosionPushesWhatIsInSight() {
        terrain.addSegment(-10, 0, 10, 0, 0, 3);
        world.kind(3).setCategory(8);
        long above = world.add(0, 3, 1, 1);
        long below = world.add(0, -3, 1, 1);
        long ghost = world.add(5, -3, 1, 1);
        world.setKind(ghost, 6);
        world.setResponse(6, 3, Response.IGNORE);
        assertThat(world.explode(0, 1, 20, 1, 0)).isEqualTo(3);
        world.setVelocity(above, 0, 0);
        world.setVelocity(below, 0, 0);
        world.setVelocity(ghost, 0, 0);
        assertThat(world.explodeInSight(0, 1, 20, 1, 0)).isEqualTo(2);
        assertThat(world.vy(above)).isPositive();
        assertThat(world.vy(below)).isZero();
        assertThat(world.vy(ghost)).as("the piece does not stop it").isNegative();
        assertThat(world.explodeInSight(0, 1, 20, 1, 0, 2)).isZero();
        assertThat(world.explodeInSight(0, 0, 20, 1, 0))
                .as("a piece at the point hides nobody")
                .isEqualTo(3);
        terrain.clear();
        assertThat(world.explodeInSight(0, 1, 20, 1, 0)).isEqualTo(3);
    }

    @Test
    void acrossASeamPiecesAreFoundTheShortWay() {
        try (World ring = WorldScenes.jvm()
                .bounds(-50, -50, 50, 50)
                .edges(Edge.WRAP, Edge.WALL)
                .build()) {
            long segment = ring.terrain().addSegment(40, 0, 60, 0);
            TerrainQueries around = ring.queries().terrain();
            long[] handles = new long[4];
            assertThat(around.overlapCircle(-45, 2, 2, handles)).isEqualTo(1);
            assertThat(around.overlapCircle(45, 2, 2, handles)).isEqualTo(1);
            assertThat(around.overlapCircle(-35, 2, 2, handles)).isZero();
            assertThat(around.overlapBox(-60, -1, -35, 1, handles)).isEqualTo(1);
            assertThat(around.pick(-41, 1, 1)).isEqualTo(segment);
            float[] hit = new float[STRIDE];
            assertThat(around.rayCast(-45, 5, 0, -10, hit)).isEqualTo(segment);
            assertThat(hit).containsExactly(5, -45, 0, 0, 1);
            assertThat(around.rayCast(30, 5, 20, -10, hit)).isEqualTo(segment);
            assertThat(around.rayCast(30, 5, 40, -6, hit)).as("beyond the seam").isZero();
            assertThat(around.rayCast(35, 5, 24, -6, hit)).isEqualTo(segment);
            assertThat(hit[Queries.X]).isEqualTo(55, within(1e-4f));
        }
    }
}
