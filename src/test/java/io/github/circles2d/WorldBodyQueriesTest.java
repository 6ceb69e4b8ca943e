package io.github.circles2d;

import static io.github.circles2d.Refusals.assertIllegalArgument;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import io.github.circles2d.SolidBodies.Solid;
import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;

/** Queries of a world find the bodies that are pushed where they are now, as a look at the points of each outline does. */
class WorldBodyQueriesTest {
    private static final float DT = 1 / 60f;
    private static final int STRIDE = Queries.HIT_STRIDE;
    private static final float PI = (float) Math.PI;
    private static final int MOST = 400;

    private final Random random = new Random(8);
    private final long[] found = new long[MOST];
    private final float[] hits = new float[STRIDE * MOST];
    private final float[] hit = new float[STRIDE];

    private static World world() {
        return WorldScenes.jvm()
                .bounds(-50, -50, 50, 50)
                .gravity(0, 0)
                .threads(1)
                .build();
    }

    private float between(float least, float greatest) {
        return least + (greatest - least) * random.nextFloat();
    }

    private Outline outline() {
        float a = between(1, 6);
        float b = between(0.4f, 3);
        return switch (random.nextInt(9)) {
            case 0 -> Outline.box(a, b);
            case 1 -> Outline.box(a, b).round(0.45f * Math.min(a, b));
            case 2 -> Outline.capsule(a, b);
            case 3 -> Outline.polygon(0, 0, a, 0, between(0, a), a);
            case 4 -> Outline.polygon(0, 0, 4, 0, 4, 1, 1, 1, 1, 4, 0, 4); // an L
            case 5 -> star(5 + random.nextInt(8), a);
            case 6 -> Outline.of(Chain.from(a, 0).arcTo(0, 0, 2 * PI).close()); // a disc
            case 7 -> Outline.of(Chain.from(a, 0).arcTo(0, 0, PI).close()); // half of it, with sharp corners
            default -> // a U with round ends
                Outline.of(Chain.from(0, 0)
                        .lineTo(4, 0)
                        .lineTo(4, 3)
                        .arcTo(3.5f, 3, PI)
                        .lineTo(3, 1)
                        .lineTo(1, 1)
                        .lineTo(1, 3)
                        .arcTo(0.5f, 3, PI)
                        .close());
        };
    }

    private static Outline star(int points, float size) {
        float[] corners = new float[4 * points];
        for (int k = 0; k < 2 * points; k++) {
            double angle = Math.PI * k / points;
            double r = k % 2 == 0 ? size : 0.5 * size;
            corners[2 * k] = (float) (r * Math.cos(angle));
            corners[2 * k + 1] = (float) (r * Math.sin(angle));
        }
        return Outline.polygon(corners);
    }

    private void fill(World world, int n) {
        for (int k = 0; k < n; k++) {
            int kind = random.nextInt(4);
            long body = world.bodies().add(outline(), between(-50, 50), between(-50, 50), between(-3, 3), 1, kind);
            world.bodies().setVelocity(body, between(-3, 3), between(-3, 3));
            world.bodies().setAngularVelocity(body, between(-2, 2));
        }
        for (int kind = 0; kind < 4; kind++) {
            world.kind(kind).setCategory(1 << kind);
            world.kind(kind).setMask(0); // they pass each other, so that they overlap
        }
    }

    // ---- a look at each body

    @Test
    void theyFindWhatALookAtEachBodyFinds() {
        int count = 0;
        for (int scene = 0; scene < 6; scene++) {
            try (World world = world()) {
                fill(world, scene == 0 ? 1 : 20 * scene);
                count += compare(world, 0, 100);
                world.step(DT, 20);
                count += compare(world, 0, 100);
                for (int k = 0; k < 3 && scene > 0; k++) { // seen by no step
                    Bodies bodies = world.bodies();
                    bodies.remove(bodies.handle(2 * k));
                    bodies.teleport(bodies.handle(2 * k + 1), between(-50, 50), between(-50, 50), between(-3, 3));
                }
                fill(world, 2);
                count += compare(world, 0, 200);
            }
        }
        assertThat(count).isGreaterThan(2000);
    }

    @Test
    void acrossSeamsTheyFindEachBodyOnceAndWhatAPathMeetsOnItsWay() {
        try (World world = WorldScenes.jvm()
                .bounds(-50, -50, 50, 50)
                .gravity(0, 0)
                .edges(Edge.WRAP, Edge.WRAP)
                .threads(1)
                .build()) {
            fill(world, 60);
            assertThat(compare(world, 100, 300)).isGreaterThan(250);
            world.step(DT, 30);
            assertThat(compare(world, 100, 300)).isGreaterThan(250);
        }
    }

    private int compare(World world, double period, int queries) {
        SolidBodies all = new SolidBodies(world, period, period);
        int count = 0;
        for (int q = 0; q < queries; q++) {
            int mask = random.nextInt(3) == 0 ? random.nextInt(16) : -1;
            long left = random.nextInt(3) == 0
                    ? all.solids.get(random.nextInt(all.solids.size())).handle()
                    : 0;
            BodyQueries some = random.nextBoolean()
                    ? world.queries().withMask(mask).bodies()
                    : bodies(world).withMask(mask);
            some = some.without(left);
            Solid[] solids = all.solids.stream()
                    .filter(solid -> (solid.category() & mask) != 0 && solid.handle() != left)
                    .toArray(Solid[]::new);
            float x = between(-50, 50);
            float y = between(-50, 50);
            float size = random.nextInt(4) == 0 ? 0 : between(0, 5);
            count += comparePlaces(some, solids, x, y, size);
            float angle = between(-PI, PI);
            float length = random.nextInt(8) == 0 ? 0 : between(0, 49);
            count += comparePaths(
                    some, solids, x, y, 0, length * (float) Math.cos(angle), length * (float) Math.sin(angle));
            count += comparePaths(
                    some, solids, x, y, size, length * (float) Math.cos(angle), length * (float) Math.sin(angle));
        }
        return count;
    }

    private static BodyQueries bodies(World world) {
        return world.queries().bodies();
    }

    private int comparePlaces(BodyQueries some, Solid[] solids, float x, float y, float size) {
        Set<Long> sure = new LinkedHashSet<>();
        Set<Long> maybe = new LinkedHashSet<>();
        Set<Long> inBox = new LinkedHashSet<>();
        Set<Long> maybeInBox = new LinkedHashSet<>();
        double nearest = Double.POSITIVE_INFINITY;
        for (Solid solid : solids) {
            if (solid.farAway(x, y) > Math.max(nearest, 2 * size + 1)) {
                continue;
            }
            double d = solid.distance(x, y);
            nearest = Math.min(nearest, d);
            if (d <= size - 1e-4) {
                sure.add(solid.handle());
            }
            if (d <= size + 1e-4) {
                maybe.add(solid.handle());
            }
            Boolean meets = solid.meets(x, y, x + size, y + 0.5 * size);
            if (meets == null || meets) {
                maybeInBox.add(solid.handle());
            }
            if (Boolean.TRUE.equals(meets)) {
                inBox.add(solid.handle());
            }
        }
        requireAll(some.overlapCircle(x, y, size, found), sure, maybe);
        requireAll(some.overlapBox(x, y, x + size, y + 0.5f * size, found), inBox, maybeInBox);

        int n = some.nearest(x, y, Float.POSITIVE_INFINITY, 5, found, hits);
        Set<Long> handles = new LinkedHashSet<>();
        for (Solid solid : solids) {
            handles.add(solid.handle());
        }
        assertThat(n).isEqualTo(Math.min(5, handles.size()));
        assertThat(n == 0 || Math.abs(hits[0] - nearest) < 1e-4).isTrue();
        for (int k = 0; k < n; k++) {
            requireNearest(solids, found[k], x, y, STRIDE * k);
            assertThat(k == 0 || hits[STRIDE * k] >= hits[STRIDE * (k - 1)]).isTrue();
        }
        long picked = some.pick(x, y);
        if (Math.abs(nearest) > 1e-4) {
            assertThat(picked).isEqualTo(nearest < 0 ? found[0] : 0);
        }
        int near = some.nearest(x, y, size, MOST, found, null);
        assertThat(near).isBetween(sure.size(), maybe.size());
        return maybe.size() + maybeInBox.size();
    }

    private void requireAll(int count, Set<Long> sure, Set<Long> maybe) {
        Set<Long> all = new LinkedHashSet<>();
        for (int k = 0; k < count; k++) {
            assertThat(all.add(found[k])).as("once").isTrue();
            assertThat(k == 0 || Bodies.id(found[k]) > Bodies.id(found[k - 1])).isTrue();
        }
        assertThat(all).containsAll(sure);
        assertThat(maybe).containsAll(all);
    }

    /** The hit that begins at an element has the distance, a point of the outline, and a normal that leads out there. */
    private void requireNearest(Solid[] solids, long handle, float x, float y, int at) {
        Solid nearest = null;
        for (Solid solid : solids) {
            if (solid.handle() == handle && (nearest == null || solid.distance(x, y) < nearest.distance(x, y))) {
                nearest = solid;
            }
        }
        float sx = hits[at + Queries.X];
        float sy = hits[at + Queries.Y];
        float nx = hits[at + Queries.NORMAL_X];
        float ny = hits[at + Queries.NORMAL_Y];
        double d = nearest.distance(x, y);
        assertThat(hits[at + Queries.DISTANCE]).isCloseTo((float) d, within(1e-4f));
        assertThat(nearest.distance(sx, sy)).isCloseTo(0, within(1e-4));
        assertThat(Math.hypot(sx - x, sy - y)).isCloseTo(Math.abs(d), within(1e-4));
        assertThat(Math.hypot(nx, ny)).isCloseTo(1, within(1e-6));
        if (Math.abs(d) > 0.01) {
            assertThat(sx + d * nx).isCloseTo(x, within(1e-3));
            assertThat(sy + d * ny).isCloseTo(y, within(1e-3));
        }
    }

    private int comparePaths(BodyQueries some, Solid[] solids, float x, float y, float size, float dx, float dy) {
        double length = Math.hypot(dx, dy);
        double ux = length == 0 ? 0 : dx / length;
        double uy = length == 0 ? 0 : dy / length;
        int n = size == 0
                ? some.rayCastAll(x, y, dx, dy, found, hits)
                : some.circleCastAll(x, y, size, dx, dy, found, hits);
        long first = size == 0 ? some.rayCast(x, y, dx, dy, hit) : some.circleCast(x, y, size, dx, dy, hit);
        assertThat(first).isEqualTo(n == 0 ? 0 : found[0]);
        if (n == 0) {
            assertThat(hit[Queries.DISTANCE]).isCloseTo((float) length, within(1e-4f));
            assertThat(hit[Queries.NORMAL_X]).isZero();
        } else {
            assertThat(hit).isEqualTo(Arrays.copyOf(hits, STRIDE));
        }
        boolean[] seen = new boolean[n];
        for (Solid solid : solids) {
            double truth = solid.walk(x, y, size, ux, uy, length);
            int k = 0;
            while (k < n && !(found[k] == solid.handle() && !seen[k] && isNear(hits[STRIDE * k], truth))) {
                k++;
            }
            if (k < n) {
                seen[k] = true;
            }
            assertThat(k < n || Double.isNaN(truth) || truth == SolidBodies.NONE)
                    .as(
                            "%s after %s from %s %s by %s, %s with %s; found %s %s",
                            solid.handle(),
                            truth,
                            x,
                            y,
                            dx,
                            dy,
                            size,
                            Arrays.toString(Arrays.copyOf(found, n)),
                            Arrays.toString(Arrays.copyOf(hits, STRIDE * n)))
                    .isTrue();
        }
        for (int k = 0; k < n; k++) {
            assertThat(seen[k]).as("found %s", found[k]).isTrue();
            requireHit(solids, found[k], size, STRIDE * k, ux, uy);
        }
        return n;
    }

    private static boolean isNear(float distance, double truth) {
        return Double.isNaN(truth) || Math.abs(distance - truth) < 2e-3;
    }

    /** Where a path has come to, the outline is as far as the radius, and the normal leads out of it, against the path. */
    private void requireHit(Solid[] solids, long handle, float size, int at, double ux, double uy) {
        float x = hits[at + Queries.X];
        float y = hits[at + Queries.Y];
        float nx = hits[at + Queries.NORMAL_X];
        float ny = hits[at + Queries.NORMAL_Y];
        assertThat(Math.hypot(nx, ny)).isCloseTo(1, within(1e-6));
        double gap = Double.POSITIVE_INFINITY;
        double touched = Double.POSITIVE_INFINITY;
        double out = Double.POSITIVE_INFINITY;
        for (Solid solid : solids) {
            if (solid.handle() == handle) {
                gap = Math.min(gap, solid.distance(x, y));
                touched = Math.min(touched, Math.abs(solid.distance(x - size * nx, y - size * ny)));
                out = Math.min(out, solid.distance(x + 3e-4 * nx, y + 3e-4 * ny));
            }
        }
        if (hits[at + Queries.DISTANCE] > 0) {
            assertThat(gap).isCloseTo(size, within(1e-3));
            assertThat(touched).as("the disc touches it there").isCloseTo(0, within(1e-3));
            assertThat(size > 0 || out > 0).as("it leads out").isTrue();
            assertThat(nx * ux + ny * uy).isLessThan(1e-3);
        } else {
            assertThat(gap).isLessThan(size + 1e-4);
        }
    }

    // ---- single cases

    @Test
    void cornersAreRoundAndEdgesAreExact() {
        try (World world = world()) {
            long box = world.bodies().add(Outline.box(4, 2).round(0.5f), 10, 10, 0, 1);
            BodyQueries queries = bodies(world);
            assertThat(queries.pick(12, 10)).as("on the edge").isEqualTo(box);
            assertThat(queries.pick(Math.nextUp(12f), 10)).isZero();
            assertThat(queries.pick(11.9f, 10.9f)).as("outside the arc").isZero();
            assertThat(queries.pick(11.8f, 10.8f)).isEqualTo(box);
            assertThat(queries.overlapCircle(14, 10, 2, found)).isOne();
            assertThat(queries.overlapCircle(14, 10, Math.nextDown(2f), found)).isZero();
            assertThat(queries.overlapBox(12, 0, 20, 20, found)).isOne();
            assertThat(queries.overlapBox(11.9f, 10.9f, 20, 20, found)).isZero();
            assertThat(queries.overlapBox(10, 10, 10, 10, found)).as("within").isOne();
            assertThat(queries.overlapBox(-20, -20, 20, 20, found)).as("around").isOne();
            assertThat(queries.rayCast(0, 10, 20, 0, hit)).isEqualTo(box);
            assertThat(hit).containsExactly(8, 8, 10, -1, 0);
            assertThat(queries.rayCast(0, 10, 8, 0, hit)).as("it ends there").isEqualTo(box);
            assertThat(queries.rayCast(0, 10, Math.nextDown(8f), 0, hit)).isZero();
            assertThat(queries.circleCast(10, 20, 1, 0, -30, hit)).isEqualTo(box);
            assertThat(hit).containsExactly(8, 10, 12, 0, 1);
            float far = (float) Math.sqrt(0.5);
            assertThat(queries.rayCast(14, 13, -5, -5, hit)).isEqualTo(box);
            assertThat(hit[Queries.NORMAL_X]).isCloseTo(far, within(1e-3f));
            assertThat(queries.nearest(10, 13, 9, 1, found, hit)).isOne();
            assertThat(hit).containsExactly(2, 10, 11, 0, 1);
            assertThat(queries.nearest(10, 10.75f, 9, 1, found, hit)).isOne();
            assertThat(hit).as("inside").containsExactly(-0.25f, 10, 11, 0, 1);
            assertThat(queries.nearest(10, 11, 9, 1, found, hit)).isOne();
            assertThat(hit).as("on the edge").containsExactly(0, 10, 11, 0, 1);
        }
    }

    @Test
    void aPathThatBeginsInsideMeetsTheBodyThere() {
        try (World world = world()) {
            long box = world.bodies().add(Outline.box(4, 2), 10, 10, 0, 1);
            BodyQueries queries = bodies(world);
            assertThat(queries.rayCast(11.5f, 10, -20, 0, hit)).isEqualTo(box);
            assertThat(hit).containsExactly(0, 11.5f, 10, 1, 0);
            assertThat(queries.rayCast(11.5f, 10, 0, 0, hit)).as("no length").isEqualTo(box);
            assertThat(hit).containsExactly(0, 11.5f, 10, 1, 0);
            assertThat(queries.circleCast(13, 10, 1, 5, 0, hit))
                    .as("it touches")
                    .isEqualTo(box);
            assertThat(hit).containsExactly(0, 13, 10, 1, 0);
            assertThat(queries.rayCast(13, 10, 0, 0, hit)).isZero();
            assertThat(hit).containsExactly(0, 13, 10, 0, 0);
            assertThat(queries.rayCast(13, 0, 0, 20, hit)).as("beside").isZero();
        }
    }

    @Test
    void aHollowIsOutside() {
        try (World world = world()) {
            Outline u = Outline.polygon(0, 0, 5, 0, 5, 4, 4, 4, 4, 1, 1, 1, 1, 4, 0, 4);
            long body = world.bodies().add(u, u.centroidX(), u.centroidY(), 0, 1);
            BodyQueries queries = bodies(world);
            assertThat(queries.pick(2.5f, 2)).isZero();
            assertThat(queries.overlapCircle(2.5f, 3, 1.25f, found)).isZero();
            assertThat(queries.overlapCircle(2.5f, 3, 1.75f, found)).isOne();
            assertThat(queries.overlapBox(1.5f, 1.5f, 3.5f, 9, found)).isZero();
            assertThat(queries.rayCast(2.5f, 9, 0, -20, hit)).isEqualTo(body);
            assertThat(hit[Queries.DISTANCE]).isCloseTo(8, within(1e-5f));
            assertThat(queries.rayCast(2.5f, 2, 20, 0, hit)).isEqualTo(body);
            assertThat(hit[Queries.DISTANCE]).isCloseTo(1.5f, within(1e-5f));
            assertThat(hit[Queries.NORMAL_X]).isEqualTo(-1);
            assertThat(queries.rayCastAll(-5, 3, 20, 0, found, hits)).as("once").isOne();
        }
    }

    @Test
    void ofSeveralAtAPointTheDeepestIsPicked() {
        try (World world = world()) {
            long wide = world.bodies().add(Outline.box(8, 8), 0, 0, 0, 1);
            long small = world.bodies().add(Outline.box(2, 2), 3.5f, 0, 0, 1);
            BodyQueries queries = bodies(world);
            assertThat(queries.pick(3.5f, 0)).isEqualTo(small);
            assertThat(queries.pick(2.75f, 0)).isEqualTo(wide);
            assertThat(queries.without(wide).pick(2.75f, 0)).isEqualTo(small);
            assertThat(queries.without(wide).withMask(2).pick(2.75f, 0)).isZero();
            long twin = world.bodies().add(Outline.box(2, 2), 3.5f, 0, 0, 1);
            assertThat(queries.pick(3.5f, 0)).isEqualTo(small);
            assertThat(queries.without(small).pick(3.5f, 0)).isEqualTo(twin);
        }
    }

    @Test
    void noRaySlipsThroughACorner() {
        try (World world = world()) {
            for (int points = 3; points < 40; points++) {
                world.bodies().clear();
                Outline star = points % 2 == 0 ? star(points, 3) : Outline.box(points, 3);
                long body = world.bodies().add(star, between(-9, 9), between(-9, 9), between(-3, 3), 1);
                BodyQueries queries = bodies(world);
                double cos = Math.cos(world.bodies().angle(body));
                double sin = Math.sin(world.bodies().angle(body));
                float[] corners = star.points(0.1f);
                for (int k = 0; k < corners.length; k += 2) {
                    double x = cos * corners[k] - sin * corners[k + 1];
                    double y = sin * corners[k] + cos * corners[k + 1];
                    float startX = (float) (world.bodies().x(body) + 5 * x);
                    float startY = (float) (world.bodies().y(body) + 5 * y);
                    float dx = world.bodies().x(body) - startX;
                    float dy = world.bodies().y(body) - startY;
                    assertThat(queries.rayCast(startX, startY, dx, dy, hit)).isEqualTo(body);
                    assertThat(hit[Queries.NORMAL_X] * dx + hit[Queries.NORMAL_Y] * dy)
                            .isNegative();
                }
            }
        }
    }

    @Test
    void farAwayTheyAreAsExactAsFloats() {
        try (World world = WorldScenes.jvm()
                .bounds(0, 0, 10, 10)
                .edges(Edge.OPEN, Edge.OPEN)
                .threads(1)
                .build()) {
            long body = world.bodies().add(Outline.box(4, 4), 8e8f, -8e8f, 0, 1);
            BodyQueries queries = bodies(world);
            assertThat(queries.pick(8e8f, -8e8f)).isEqualTo(body);
            assertThat(queries.overlapCircle(8e8f, -8e8f, 1, found)).isOne();
            assertThat(queries.rayCast(0, -8e8f, 1e9f, 0, hit)).isEqualTo(body);
            assertThat(hit[Queries.DISTANCE]).isEqualTo(8e8f);
            assertThat(hit[Queries.NORMAL_X]).isEqualTo(-1);
            assertThat(queries.rayCast(Float.MAX_VALUE, 0, Float.MAX_VALUE, 0, hit))
                    .isZero();
            assertThat(queries.nearest(-Float.MAX_VALUE, 0, Float.POSITIVE_INFINITY, 1, found, hit))
                    .isOne();
            assertThat(hit[Queries.DISTANCE]).isEqualTo(Float.MAX_VALUE);
        }
    }

    @Test
    void bodiesOnASeamAreFoundOnBothSides() {
        try (World world = WorldScenes.jvm()
                .bounds(0, 0, 100, 100)
                .edges(Edge.WRAP, Edge.WALL)
                .threads(1)
                .build()) {
            long body = world.bodies().add(Outline.box(6, 2), 99, 50, 0, 1);
            BodyQueries queries = bodies(world);
            assertThat(queries.pick(97, 50)).isEqualTo(body);
            assertThat(queries.pick(1, 50)).isEqualTo(body);
            assertThat(queries.pick(3, 50)).isZero();
            assertThat(queries.pick(101, 50)).as("the same place as 1").isEqualTo(body);
            assertThat(queries.nearest(4, 50, 9, 5, found, hits)).isOne();
            assertThat(Arrays.copyOf(hits, STRIDE)).containsExactly(2, 2, 50, 1, 0);
            assertThat(queries.rayCast(10, 50, -20, 0, hit)).isEqualTo(body);
            assertThat(hit).containsExactly(8, 2, 50, 1, 0);
            assertThat(queries.rayCast(90, 50, 120, 0, hit)).isEqualTo(body);
            assertThat(hit[Queries.DISTANCE]).isEqualTo(6);
            assertThat(queries.overlapBox(0, 40, 100, 60, found)).as("once").isOne();
        }
    }

    @Test
    void batchesAnswerAsSingleCallsDo() {
        try (World world = world()) {
            fill(world, 50);
            BodyQueries queries = bodies(world);
            int n = 200;
            float[] numbers = new float[5 * n];
            for (int k = 0; k < numbers.length; k++) {
                numbers[k] = k % 5 == 2 ? between(0, 5) : between(-40, 40);
            }
            long[] firsts = new long[n];
            float[] firstHits = new float[STRIDE * n];
            int[] ends = new int[n];
            long[] many = new long[50 * n];
            float[] manyHits = new float[STRIDE * 50 * n];
            int total = 0;
            assertThat(queries.circleCast(numbers, n, firsts, firstHits)).isPositive();
            queries.circleCastAll(numbers, n, ends, many, manyHits);
            for (int q = 0; q < n; q++) {
                int at = 5 * q;
                float radius = numbers[at + 2];
                long first =
                        queries.circleCast(numbers[at], numbers[at + 1], radius, numbers[at + 3], numbers[at + 4], hit);
                assertThat(firsts[q]).isEqualTo(first);
                assertThat(Arrays.copyOfRange(firstHits, STRIDE * q, STRIDE * (q + 1)))
                        .isEqualTo(hit);
                int count = queries.circleCastAll(
                        numbers[at], numbers[at + 1], radius, numbers[at + 3], numbers[at + 4], found, hits);
                assertThat(Arrays.copyOfRange(many, total, total + count)).isEqualTo(Arrays.copyOf(found, count));
                assertThat(Arrays.copyOfRange(manyHits, STRIDE * total, STRIDE * (total + count)))
                        .isEqualTo(Arrays.copyOf(hits, STRIDE * count));
                total += count;
                assertThat(ends[q]).isEqualTo(total);
            }
            int picked = queries.pick(numbers, n, firsts);
            assertThat(Arrays.stream(firsts).filter(handle -> handle != 0)).hasSize(picked);
            assertThat(firsts[7]).isEqualTo(queries.pick(numbers[14], numbers[15]));
            queries.nearest(numbers, n, 3, 2, many, manyHits);
            int near = queries.nearest(numbers[14], numbers[15], 3, 2, found, hits);
            assertThat(many[14]).isEqualTo(near == 0 ? 0 : found[0]);
        }
    }

    @Test
    void handlesOfOtherThingsAndNumbersThatAreNoneAreRefused() {
        try (World world = world()) {
            long circle = world.add(5, 5, 1, 1);
            long body = world.bodies().add(Outline.box(2, 2), 0, 0, 0, 1);
            BodyQueries queries = bodies(world);
            assertThat(world.queries().bodies()).isSameAs(queries);
            assertThat(world.queries().without(circle).bodies()).isSameAs(queries);
            assertThat(world.queries().pick(0, 0)).as("no circle").isZero();
            assertThat(queries.pick(5, 5)).as("no body").isZero();
            assertThat(world.queries().terrain().pick(0, 0, 9)).as("no piece").isZero();
            assertThat(queries.without(0).pick(0, 0)).isEqualTo(body);
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> queries.without(circle))
                    .withMessage("no body has the handle " + circle + ": it is of a circle, or of nothing");
            assertIllegalArgument("x", () -> queries.pick(Float.NaN, 0));
            assertIllegalArgument("radius", () -> queries.overlapCircle(0, 0, -1, found));
            assertIllegalArgument("dy", () -> queries.rayCast(0, 0, 1, Float.POSITIVE_INFINITY, hit));
            assertIllegalArgument("within", () -> queries.nearest(0, 0, -1, 1, found, hits));
            BodyQueries others = queries.without(body);
            assertThat(others.pick(0, 0)).isZero();
            world.bodies().remove(body);
            assertThat(queries.pick(0, 0)).isZero();
            long next = world.bodies().add(Outline.box(2, 2), 0, 0, 0, 1);
            assertThat(others.pick(0, 0)).as("another body with its id").isEqualTo(next);
            world.bodies().clear();
            assertThat(queries.nearest(0, 0, Float.POSITIVE_INFINITY, 9, found, hits))
                    .isZero();
        }
    }

    // ---- states

    private float[] answers(World world) {
        float[] rays = new float[4 * 60];
        Random places = new Random(1);
        for (int k = 0; k < rays.length; k++) {
            rays[k] = 80 * places.nextFloat() - 40;
        }
        float[] answers = new float[2 * STRIDE * 60];
        BodyQueries queries = bodies(world);
        long[] handles = new long[60];
        queries.rayCast(rays, 60, handles, answers);
        for (int k = 0; k < 60; k++) {
            Arrays.fill(hit, 0);
            queries.nearest(rays[4 * k], rays[4 * k + 1], 20, 1, found, hit);
            System.arraycopy(hit, 0, answers, STRIDE * (60 + k), STRIDE);
        }
        return answers;
    }

    @Test
    void theyAreTheSameForAnyThreadsAndAfterStatesComeBack() {
        float[][] late = new float[2][];
        for (int k = 0; k < 2; k++) {
            try (World world = WorldScenes.jvm()
                            .bounds(-50, -50, 50, 50)
                            .gravity(0, -10)
                            .threads(1 + 2 * k)
                            .build();
                    World other = world()) {
                random.setSeed(3);
                fill(world, 60);
                for (int kind = 0; kind < 4; kind++) {
                    world.kind(kind).setMask(-1);
                }
                Rewind rewind = new Rewind(world, 4);
                world.step(DT, 30);
                float[] before = answers(world);
                ByteBuffer state = ByteBuffer.allocate(world.snapshotBytes());
                world.snapshot(state);
                rewind.save(30);
                world.step(DT, 30);
                late[k] = answers(world);
                assertThat(late[k]).isNotEqualTo(before);
                world.restore(state.flip());
                assertThat(answers(world)).isEqualTo(before);
                world.step(DT, 30);
                assertThat(answers(world)).isEqualTo(late[k]);
                rewind.restore(30);
                assertThat(answers(world)).isEqualTo(before);
                answers(other);
                other.restore(state.rewind());
                assertThat(answers(other)).isEqualTo(before);
            }
        }
        assertThat(late[1]).isEqualTo(late[0]);
    }
}
