package io.github.circles2d.world.queries;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.circles2d.world.model.AxisEdge;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.KindTerrain;
import io.github.circles2d.world.model.PieceRow;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Random;
import java.util.function.IntPredicate;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Searches among pieces find what a look at every piece finds, and pieces are met where a walk along the path comes to them. */
class TerrainSearchTest {
    private static final Bounds WALLED = new Bounds(0, 0, 100, 100);
    private static final int ONE_WAY_KIND = 3;

    private final TerrainSearch search = new TerrainSearch();
    private final Random random = new Random(1);

    private record Hit(int piece, double distance) {}

    private static final Comparator<Hit> ORDER =
            Comparator.comparingDouble(Hit::distance).thenComparingInt(Hit::piece);

    private PieceRows pieces(int n, float size) {
        PieceRows rows = new PieceRows();
        rows.step.kinds.rows[KindTerrain.of(ONE_WAY_KIND) + KindTerrain.ONE_WAY] = 1;
        for (int k = 0; k < n; k++) {
            float x = random.nextInt(3) == 0 ? random.nextInt(101) : 100 * random.nextFloat();
            float y = random.nextInt(3) == 0 ? random.nextInt(101) : 100 * random.nextFloat();
            float dx = size * (random.nextFloat() - 0.5f);
            float dy = random.nextInt(4) == 0 ? 0 : size * (random.nextFloat() - 0.5f);
            double from = 7 * random.nextDouble() - 3.5;
            double opening = random.nextInt(4) == 0 ? 2 * Math.PI : 2 * Math.PI * random.nextDouble();
            switch (random.nextInt(5)) {
                case 0 -> rows.line(PieceRow.SEGMENT, x, y, x + dx, y + dy, 0);
                case 1 -> rows.line(PieceRow.SEGMENT, x, y, x + dx, y + dy, 0.1f * size * random.nextFloat());
                case 2 -> rows.line(PieceRow.LINE, x, y, x + dx, y + dy, 0);
                default ->
                    rows.arc(
                            random.nextBoolean(),
                            x,
                            y,
                            size * (0.05f + 0.3f * random.nextFloat()),
                            from,
                            from + opening);
            }
            rows.setKind(k, random.nextInt(5));
        }
        rows.build();
        return rows;
    }

    /** The piece, moved by so many periods. */
    private static PieceShape shape(PieceRows rows, int piece, double shiftX, double shiftY) {
        PieceShape shape = new PieceShape();
        shape.take(rows.step.rows, rows.step.traits, piece, isOneSided(rows, piece), shiftX, shiftY);
        return shape;
    }

    private static PieceShape shape(PieceRows rows, int piece) {
        return shape(rows, piece, 0, 0);
    }

    private static boolean isOneSided(PieceRows rows, int piece) {
        return PieceRow.form(rows.step.traits[PieceRow.traits(piece)]) != PieceRow.SEGMENT
                || rows.step.traits[PieceRow.traits(piece) + PieceRow.KIND] == ONE_WAY_KIND;
    }

    private float coordinate() {
        return random.nextInt(3) == 0 ? random.nextInt(101) : 120 * random.nextFloat() - 10;
    }

    private float length() {
        return random.nextInt(4) == 0 ? 0 : (float) (100 * Math.pow(random.nextFloat() - 0.5, 3));
    }

    // ---- the tree

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 9, 40, 600})
    void theyFindWhatALookAtEveryPieceFinds(int n) {
        int found = 0;
        for (int scene = 0; scene < 6; scene++) {
            PieceRows rows = pieces(n, scene % 2 == 0 ? 10 : 60);
            search.show(rows.step, WALLED);
            IntPredicate filter = scene < 3 ? null : id -> id % 3 != 0;
            for (int q = 0; q < 40; q++) {
                found += compare(rows, filter, 0, 0);
            }
        }
        assertThat(found).isGreaterThanOrEqualTo(5 * n);
    }

    @Test
    void acrossSeamsTheyFindEachPieceOnceAndWhatAPathMeetsOnItsWay() {
        Bounds wrapping = new Bounds(0, 0, 100, 100).with(AxisEdge.WRAP, AxisEdge.WRAP);
        int found = 0;
        for (int scene = 0; scene < 4; scene++) {
            PieceRows rows = pieces(120, 40);
            search.show(rows.step, wrapping);
            for (int q = 0; q < 40; q++) {
                found += compare(rows, null, 100, 100);
            }
        }
        assertThat(found).isGreaterThan(500);
    }

    private int compare(PieceRows rows, IntPredicate filter, float periodX, float periodY) {
        float x = Math.min(Math.max(coordinate(), 0), 99);
        float y = Math.min(Math.max(coordinate(), 0), 99);
        float size = Math.abs(length());
        float dx = 10 * length();
        float dy = 10 * length();
        int found = 0;
        int mostImages = periodX > 0 ? 1 : 0;
        List<Integer> discs = new ArrayList<>();
        List<Integer> boxes = new ArrayList<>();
        List<Hit> near = new ArrayList<>();
        List<Hit> rays = new ArrayList<>();
        List<Hit> casts = new ArrayList<>();
        double length = Math.sqrt((double) dx * dx + (double) dy * dy);
        double ux = length == 0 ? 0 : dx / length;
        double uy = length == 0 ? 0 : dy / length;
        for (int p = 0; p < rows.count(); p++) {
            boolean disc = false;
            boolean box = false;
            double least = Double.POSITIVE_INFINITY;
            for (int i = -mostImages; i <= mostImages && (filter == null || filter.test(p)); i++) {
                for (int j = -mostImages; j <= mostImages; j++) {
                    PieceShape shape = shape(rows, p, i * periodX, j * periodY);
                    disc |= shape.overlapsDisc(x, y, size);
                    box |= shape.overlapsBox(x, y, (double) x + size, (double) y + 2 * size);
                    least = Math.min(least, shape.distance(x, y));
                    addCast(rays, p, shape.castDistance(x, y, 0, ux, uy, length), x, y, ux, uy, periodX);
                    addCast(casts, p, shape.castDistance(x, y, size, ux, uy, length), x, y, ux, uy, periodX);
                }
            }
            if (disc) {
                discs.add(p);
            }
            if (box) {
                boxes.add(p);
            }
            if (least < Double.POSITIVE_INFINITY) {
                near.add(new Hit(p, least));
            }
        }
        assertThat(overlaps(QueryShape.DISC, filter, x, y, size)).isEqualTo(discs);
        assertThat(overlaps(QueryShape.BOX, filter, x, y, x + size, y + 2 * size))
                .as("the box %s %s, %s", x, y, size)
                .hasSizeBetween(boxes.size() - 1, boxes.size() + 1);
        found += discs.size() + boxes.size();

        near.sort(ORDER);
        int most = 1 + random.nextInt(7);
        compareHits(near.subList(0, Math.min(most, near.size())), nearest(x, y, Float.POSITIVE_INFINITY, most, filter));
        near.removeIf(hit -> !(hit.distance <= size));
        compareHits(near, nearest(x, y, size, rows.count() + 1, filter));

        found += comparePaths(QueryShape.RAY, rays, filter, x, y, dx, dy);
        found += comparePaths(QueryShape.DISC_CAST, casts, filter, x, y, size, dx, dy);
        return found;
    }

    /** Paths end half a period beyond the bounds. */
    private static void addCast(List<Hit> to, int p, double d, double x, double y, double ux, double uy, float period) {
        boolean isNear = period == 0
                || Math.abs(x + d * ux - 0.5 * period) <= period && Math.abs(y + d * uy - 0.5 * period) <= period;
        if (d != CircleTests.NONE && isNear) {
            to.add(new Hit(p, d));
        }
    }

    private int comparePaths(QueryShape shape, List<Hit> truth, IntPredicate filter, float... query) {
        truth.sort(ORDER);
        int count = search.all(shape, query, filter);
        List<Hit> all = new ArrayList<>();
        float[] hit = new float[CastSearch.HIT_STRIDE];
        for (int k = 0; k < count; k++) {
            search.writeHit(k, hit, 0);
            all.add(new Hit(search.id(shape, k), hit[CastSearch.DISTANCE]));
            assertThat(Math.hypot(hit[CastSearch.NORMAL_X], hit[CastSearch.NORMAL_Y]))
                    .isEqualTo(1, within(1e-6));
        }
        compareHits(truth, all);
        int first = search.first(shape, query, filter, hit, 0);
        assertThat(first).isEqualTo(truth.isEmpty() ? -1 : truth.get(0).piece);
        if (first >= 0) {
            assertThat(hit[CastSearch.DISTANCE]).isEqualTo((float) truth.get(0).distance);
        } else {
            float[] end = {query[0] + query[query.length - 2], query[1] + query[query.length - 1]};
            assertThat(new float[] {hit[CastSearch.X], hit[CastSearch.Y]})
                    .usingComparatorWithPrecision(1e-5f)
                    .containsExactly(end);
        }
        return truth.size();
    }

    private static void compareHits(List<Hit> truth, List<Hit> all) {
        assertThat(all).hasSameSizeAs(truth);
        for (int k = 0; k < all.size(); k++) {
            assertThat(all.get(k).piece).isEqualTo(truth.get(k).piece);
            assertThat((float) all.get(k).distance).isEqualTo((float) truth.get(k).distance);
        }
    }

    private List<Integer> overlaps(QueryShape shape, IntPredicate filter, float... query) {
        int count = search.all(shape, query, filter);
        List<Integer> all = new ArrayList<>();
        for (int k = 0; k < count; k++) {
            all.add(search.id(shape, k));
        }
        return all;
    }

    private List<Hit> nearest(float x, float y, float within, int most, IntPredicate filter) {
        int count = search.nearest(x, y, within, most, filter);
        List<Hit> all = new ArrayList<>();
        float[] hit = new float[CastSearch.HIT_STRIDE];
        for (int k = 0; k < count; k++) {
            search.writeNearest(k, hit, 0);
            all.add(new Hit(search.nearestId(k), hit[CastSearch.DISTANCE]));
        }
        return all;
    }

    // ---- the tests of a piece

    /** The distance from a point to a piece, by another formula. */
    private static double distance(PieceRows rows, int piece, double px, double py) {
        float[] r = rows.step.rows;
        int row = PieceRow.of(piece);
        int shape = rows.step.traits[PieceRow.traits(piece)];
        double x = r[row + PieceRow.X];
        double y = r[row + PieceRow.Y];
        if (PieceRow.form(shape) != PieceRow.ARC) {
            return java.awt.geom.Line2D.ptSegDist(
                            x, y, x + r[row + PieceRow.END_X], y + r[row + PieceRow.END_Y], px, py)
                    - r[row + PieceRow.THICKNESS];
        }
        double radius = r[row + PieceRow.LENGTH];
        double turned = Math.atan2(py - y, px - x) - Math.atan2(r[row + PieceRow.TY], r[row + PieceRow.TX]);
        double half = r[row + PieceRow.SPREAD] == PieceRow.ALL_AROUND ? Math.PI : Math.acos(r[row + PieceRow.SPREAD]);
        double off = Math.abs(Math.IEEEremainder(turned, 2 * Math.PI));
        double d = Math.hypot(px - x, py - y);
        double beyond = Math.max(off - half, 0); // the law of cosines
        return Math.sqrt(Math.max(d * d + radius * radius - 2 * d * radius * Math.cos(beyond), 0));
    }

    /** How far a point is in front. */
    private static double height(PieceRows rows, int piece, double px, double py) {
        float[] r = rows.step.rows;
        int row = PieceRow.of(piece);
        int shape = rows.step.traits[PieceRow.traits(piece)];
        double ox = px - r[row + PieceRow.X];
        double oy = py - r[row + PieceRow.Y];
        if (PieceRow.form(shape) != PieceRow.ARC) {
            return ox * r[row + PieceRow.TY] - oy * r[row + PieceRow.TX];
        }
        double out = Math.hypot(ox, oy) - r[row + PieceRow.LENGTH];
        return (shape & PieceRow.SOLID_OUTSIDE) != 0 ? -out : out;
    }

    @Test
    void distancesAndNearestPointsAreThoseOfAnotherFormula() {
        PieceRows rows = pieces(400, 30);
        for (int k = 0; k < 20_000; k++) {
            int piece = random.nextInt(rows.count());
            double x = coordinate();
            double y = coordinate();
            PieceShape shape = shape(rows, piece);
            double truth = distance(rows, piece, x, y);
            assertThat(shape.distance(x, y)).isEqualTo(truth, within(2e-3));
            shape.normalFrom(x, y);
            assertThat(distance(rows, piece, shape.surfaceX, shape.surfaceY)).isEqualTo(0, within(2e-3));
            assertThat(Math.hypot(shape.surfaceX - x, shape.surfaceY - y)).isEqualTo(Math.abs(truth), within(2e-3));
        }
    }

    @Test
    void aPathMeetsAPieceWhereAWalkAlongItComesToItFromItsFreeSide() {
        PieceRows rows = pieces(400, 30);
        int met = 0;
        int passed = 0;
        for (int k = 0; k < 20_000; k++) {
            int piece = random.nextInt(rows.count());
            double x = coordinate();
            double y = coordinate();
            double reach = random.nextBoolean() ? 0 : 5 * random.nextDouble();
            double angle = 7 * random.nextDouble();
            double ux = Math.cos(angle);
            double uy = Math.sin(angle);
            double length = 150 * random.nextDouble();
            double d = shape(rows, piece).castDistance(x, y, reach, ux, uy, length);
            double truth = walk(rows, piece, x, y, reach, ux, uy, length);
            if (Double.isNaN(truth)) {
                continue; // too close to tell
            }
            if (truth == CircleTests.NONE) {
                assertThat(d)
                        .as("piece %d from %s %s along %s", piece, x, y, angle)
                        .isEqualTo(CircleTests.NONE);
                passed++;
            } else {
                assertThat(d)
                        .as("piece %d from %s %s along %s", piece, x, y, angle)
                        .isEqualTo(truth, within(2e-2));
                met++;
            }
        }
        assertThat(met).isGreaterThan(400);
        assertThat(passed).isGreaterThan(5000);
    }

    /** NaN if the path grazes the piece, or comes to where its front ends. */
    private static double walk(
            PieceRows rows, int piece, double x, double y, double reach, double ux, double uy, double length) {
        double close = 1e-6;
        double clear = 2e-3;
        boolean oneSided = isOneSided(rows, piece);
        boolean isArc = PieceRow.form(rows.step.traits[PieceRow.traits(piece)]) == PieceRow.ARC;
        double t = 0;
        boolean wasBehind = false;
        double least = Double.POSITIVE_INFINITY;
        while (t <= length + clear) {
            double gap = distance(rows, piece, x + t * ux, y + t * uy) - reach;
            least = Math.min(least, gap);
            if (gap > close) {
                t += gap;
                wasBehind = false;
                continue;
            }
            double height = height(rows, piece, x + t * ux, y + t * uy);
            if (reach == 0 && t > 0) { // it lies on the piece: where it came from decides
                height = height(rows, piece, x + (t - 1e-4) * ux, y + (t - 1e-4) * uy);
            }
            if (oneSided && Math.abs(height) < (reach == 0 ? 1e-7 : clear) || Math.abs(t - length) < clear) {
                return Double.NaN;
            }
            if (!oneSided || height > 0 && !wasBehind) {
                double deeper = distance(rows, piece, x + (t + clear) * ux, y + (t + clear) * uy) - reach;
                double after = height(rows, piece, x + (t + clear) * ux, y + (t + clear) * uy);
                boolean through = reach == 0 && after * height < 0;
                return t == 0 || deeper < -clear / 100 || through ? t : Double.NaN;
            }
            if (!isArc) {
                return CircleTests.NONE;
            }
            wasBehind = true;
            t += 1e-3;
        }
        return least < clear && !(least < -clear) && !wasBehind && least > close ? Double.NaN : CircleTests.NONE;
    }

    @Test
    void aBoxOverlapsAPieceIfAPointOfItIsInside() {
        PieceRows rows = pieces(300, 30);
        int overlapping = 0;
        for (int k = 0; k < 4000; k++) {
            int piece = random.nextInt(rows.count());
            double x = coordinate();
            double y = coordinate();
            double wide = 30 * random.nextDouble();
            double high = 30 * random.nextDouble();
            double least = Double.POSITIVE_INFINITY;
            for (int i = 0; i <= 40; i++) {
                for (int j = 0; j <= 40; j++) {
                    least = Math.min(least, distance(rows, piece, x + i * wide / 40, y + j * high / 40));
                }
            }
            double cell = Math.hypot(wide, high) / 80;
            boolean overlaps = shape(rows, piece).overlapsBox(x, y, x + wide, y + high);
            if (overlaps) {
                assertThat(least).isLessThanOrEqualTo(cell + 2e-3);
                overlapping++;
            } else {
                assertThat(least).isGreaterThan(0);
            }
        }
        assertThat(overlapping).isGreaterThan(100);
    }

    @Test
    void noRaySlipsBetweenThePiecesOfAChain() {
        for (int corners = 3; corners < 60; corners++) {
            PieceRows rows = new PieceRows();
            float[] xs = new float[corners + 1];
            float[] ys = new float[corners + 1];
            float middle = 1000 * random.nextFloat();
            for (int c = 0; c <= corners; c++) {
                double angle = -2 * Math.PI * (c % corners) / corners;
                xs[c] = (float) (middle + 7 * Math.cos(angle));
                ys[c] = (float) (middle + 7 * Math.sin(angle));
            }
            for (int c = 0; c < corners; c++) { // clockwise: its right is inside
                rows.line(PieceRow.LINE, xs[c], ys[c], xs[c + 1], ys[c + 1], 0);
                rows.join(c, PieceRow.CONCAVE, PieceRow.CONCAVE);
            }
            rows.build();
            search.show(rows.step, WALLED);
            for (int c = 0; c < corners; c++) {
                for (int k = 0; k < 20; k++) {
                    float x = middle + random.nextFloat() - 0.5f;
                    float y = middle + random.nextFloat() - 0.5f;
                    float[] ray = {x, y, 2 * (xs[c] - x), 2 * (ys[c] - y)};
                    assertThat(search.first(QueryShape.RAY, ray, null, null, 0)).isNotNegative();
                    float side = 1.01f * (0.5f * xs[c] + 0.5f * xs[c + 1] - middle);
                    float up = 1.01f * (0.5f * ys[c] + 0.5f * ys[c + 1] - middle);
                    float[] inwards = {middle + side, middle + up, -side, -up};
                    assertThat(search.first(QueryShape.RAY, inwards, null, null, 0))
                            .as("from behind it passes")
                            .isNegative();
                }
            }
        }
    }

    @Test
    void whatTouchesExactlyCounts() {
        PieceRows rows = new PieceRows();
        rows.line(PieceRow.SEGMENT, 2, 5, 8, 5, 0.5f);
        rows.line(PieceRow.LINE, 18, 5, 12, 5, 0);
        rows.arc(false, 25, 5, 2, 0, 2 * Math.PI);
        rows.arc(true, 25, 5, 4, 0, 2 * Math.PI);
        rows.build();
        search.show(rows.step, WALLED);
        assertThat(overlaps(QueryShape.DISC, null, 4, 7, 1.5f)).containsExactly(0);
        assertThat(overlaps(QueryShape.DISC, null, 4, 7, Math.nextDown(1.5f))).isEmpty();
        assertThat(overlaps(QueryShape.BOX, null, 4, 5.5f, 5, 9)).containsExactly(0);
        assertThat(overlaps(QueryShape.BOX, null, 18, 5, 19, 6)).containsExactly(1);
        assertThat(overlaps(QueryShape.BOX, null, 24, 7, 26, 8)).containsExactly(2);
        assertThat(overlaps(QueryShape.BOX, null, 29, 4, 30, 6)).containsExactly(3);
        float[] hit = new float[CastSearch.HIT_STRIDE];
        assertThat(search.first(QueryShape.RAY, new float[] {5, 9, 0, -3.5f}, null, hit, 0))
                .isZero();
        assertThat(hit).containsExactly(3.5f, 5, 5.5f, 0, 1);
        assertThat(search.first(QueryShape.RAY, new float[] {15, 9, 0, -8}, null, hit, 0))
                .isOne();
        assertThat(hit).containsExactly(4, 15, 5, 0, 1);
        assertThat(search.first(QueryShape.RAY, new float[] {15, 1, 0, 8}, null, hit, 0))
                .isNegative();
        assertThat(hit).containsExactly(8, 15, 9, 0, 0);
        assertThat(search.first(QueryShape.DISC_CAST, new float[] {25, 10, 0.5f, 0, -4}, null, hit, 0))
                .isEqualTo(2);
        assertThat(hit).containsExactly(2.5f, 25, 7.5f, 0, 1);
        assertThat(search.first(QueryShape.DISC_CAST, new float[] {25, 7.5f, 0.25f, 0, 4}, null, hit, 0))
                .isEqualTo(3);
        assertThat(hit).containsExactly(1.25f, 25, 8.75f, 0, -1);
    }

    @Test
    void aRayIsBlockedByWhatItMeetsBehindItsStart() {
        PieceRows rows = new PieceRows();
        rows.line(PieceRow.SEGMENT, 2, 5, 8, 5, 0);
        rows.line(PieceRow.LINE, 18, 5, 12, 5, 0);
        rows.build();
        search.show(rows.step, WALLED);
        assertThat(search.isBlocked(4, 4, 0, 2, null)).isTrue();
        assertThat(search.isBlocked(4, 5, 0, 2, null)).isFalse();
        assertThat(search.isBlocked(4, 4, 0, 2, id -> id != 0)).isFalse();
        assertThat(search.isBlocked(14, 4, 0, 2, null)).isFalse();
        assertThat(search.isBlocked(14, 6, 0, -2, null)).isTrue();
        float[] ray = {4, 5, 0, 2};
        assertThat(search.first(QueryShape.RAY, ray, null, null, 0)).isZero();
    }
}
