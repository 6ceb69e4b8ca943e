package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.world.queries.BruteForce;
import java.util.Arrays;
import java.util.List;
import java.util.function.IntPredicate;

/** Compares the queries of a world with a look at every circle that it reads. */
final class QueryComparison {
    private static final int ROOM = 5;

    private final Queries queries;
    private final long[] handles;
    private final BruteForce truth;

    /** Of all circles. */
    QueryComparison(World world) {
        this(world, world.queries(), kind -> true);
    }

    /** Of the circles that a mask admits. */
    QueryComparison(World world, int mask) {
        this(world, world.queries().withMask(mask), kind -> (world.kind(kind).category() & mask) != 0);
    }

    private QueryComparison(World world, Queries queries, IntPredicate kinds) {
        this.queries = queries;
        long[] all = new long[world.size()];
        world.readHandles(all);
        float[] circles = new float[4 * all.length];
        world.read(circles);
        int n = 0;
        for (int k = 0; k < all.length; k++) {
            if (kinds.test(world.kindOf(all[k]))) {
                System.arraycopy(circles, 4 * k, circles, 4 * n, 4);
                all[n++] = all[k];
            }
        }
        handles = Arrays.copyOf(all, n);
        truth = new BruteForce(circles, n);
    }

    /** Makes each single query, in a box or on a path from one point to another; returns how many circles it has compared. */
    int compare(float x, float y, float radius, float toX, float toY) {
        long[] all = new long[handles.length];
        long[] few = new long[ROOM];
        long[] disc = handles(truth.disc(x, y, radius));
        assertFound(disc, queries.overlapCircle(x, y, radius, all), all);
        assertFound(disc, queries.overlapCircle(x, y, radius, few), few);
        float minX = Math.min(x, toX);
        float minY = Math.min(y, toY);
        float maxX = Math.max(x, toX);
        float maxY = Math.max(y, toY);
        long[] box = handles(truth.box(minX, minY, maxX, maxY));
        assertFound(box, queries.overlapBox(minX, minY, maxX, maxY, all), all);
        assertFound(box, queries.overlapBox(minX, minY, maxX, maxY, few), few);
        int pick = truth.pick(x, y);
        assertThat(queries.pick(x, y)).isEqualTo(pick < 0 ? 0 : handles[pick]);
        compareNearest(x, y, radius);
        compareNearest(x, y, Float.POSITIVE_INFINITY);
        int hits = compareCasts(x, y, 0, toX - x, toY - y) + compareCasts(x, y, radius, toX - x, toY - y);
        return disc.length + box.length + hits;
    }

    private void compareNearest(float x, float y, float within) {
        List<BruteForce.Hit> nearest = truth.nearest(x, y, within, ROOM);
        long[] found = new long[ROOM];
        float[] distances = new float[ROOM];
        assertThat(queries.nearest(x, y, within, ROOM, found, distances)).isEqualTo(nearest.size());
        for (int k = 0; k < ROOM; k++) {
            boolean there = k < nearest.size();
            assertThat(found[k]).isEqualTo(there ? handles[nearest.get(k).circle()] : 0);
            assertThat(distances[k]).isEqualTo(there ? (float) nearest.get(k).distance() : 0);
        }
    }

    private int compareCasts(float x, float y, float radius, float dx, float dy) {
        List<BruteForce.Hit> hits = truth.cast(x, y, radius, dx, dy);
        long[] circles = handles(hits.stream().mapToInt(BruteForce.Hit::circle).toArray());
        float[] hit = new float[Queries.HIT_STRIDE];
        long first = radius == 0 ? queries.rayCast(x, y, dx, dy, hit) : queries.circleCast(x, y, radius, dx, dy, hit);
        assertThat(first).isEqualTo(hits.isEmpty() ? 0 : circles[0]);
        assertThat(hit)
                .isEqualTo(
                        hits.isEmpty()
                                ? BruteForce.miss(x, y, dx, dy)
                                : hits.get(0).row());
        long[] found = new long[ROOM];
        float[] rows = new float[Queries.HIT_STRIDE * ROOM];
        int count = radius == 0
                ? queries.rayCastAll(x, y, dx, dy, found, rows)
                : queries.circleCastAll(x, y, radius, dx, dy, found, rows);
        assertFound(circles, count, found);
        for (int k = 0; k < Math.min(ROOM, count); k++) {
            int at = Queries.HIT_STRIDE * k;
            assertThat(Arrays.copyOfRange(rows, at, at + Queries.HIT_STRIDE))
                    .isEqualTo(hits.get(k).row());
        }
        return count;
    }

    private static void assertFound(long[] expected, int count, long[] found) {
        assertThat(count).isEqualTo(expected.length);
        int there = Math.min(count, found.length);
        assertThat(Arrays.copyOf(found, there)).isEqualTo(Arrays.copyOf(expected, there));
    }

    private long[] handles(int[] circles) {
        return Arrays.stream(circles).mapToLong(i -> handles[i]).toArray();
    }
}
