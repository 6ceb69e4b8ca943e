package io.github.circles2d.world.queries;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** The searches find what a look at every circle finds, to the bit, wherever circles lie. */
class SearchTest {
    private static final int QUERIES = 60;
    private static final int[] SIZES = {0, 1, 2, 7, 8, 9, 33, 200, 3000};

    /** How circles and queries lie. */
    enum Crowd {
        LIKE {
            @Override
            float[] circle(Random random) {
                return row(random.nextFloat() * 100, random.nextFloat() * 100, 0.4f + random.nextFloat() * 0.4f);
            }
        },
        MIXED {
            @Override
            float[] circle(Random random) {
                float r = (float) (0.01 * StrictMath.pow(1000, random.nextDouble()));
                return row(random.nextFloat() * 100, random.nextFloat() * 100, r);
            }
        },
        ONE_POINT {
            @Override
            float[] circle(Random random) {
                return row(50, 50, random.nextInt(4) == 0 ? 2 : 1);
            }
        },
        /** Coordinates that are exact, so that circles touch exactly and are equally far from points. */
        LATTICE {
            @Override
            float[] circle(Random random) {
                return row(random.nextInt(40) * 2.5f, random.nextInt(40) * 2.5f, 0.25f * (1 + random.nextInt(5)));
            }
        },
        /** On one line, so that the box around the centres has no height. */
        LINE {
            @Override
            float[] circle(Random random) {
                return row(random.nextFloat() * 100, 50, 0.5f);
            }
        },
        /** A dense crowd, and a few circles as far away as they can be. */
        OUTLIERS {
            @Override
            float[] circle(Random random) {
                return random.nextInt(50) == 0
                        ? row(random.nextInt(3) * 1e9f - 1e9f, random.nextInt(3) * 1e9f - 1e9f, 2000)
                        : row(random.nextFloat() * 100, random.nextFloat() * 100, 0.5f);
            }
        },
        /** Where a coordinate has no bits left for a small radius. */
        ROUNDED {
            @Override
            float[] circle(Random random) {
                return row(
                        9e8f + random.nextFloat() * 1e5f, -9e8f + random.nextFloat() * 1e5f, 1000 * random.nextFloat());
            }

            @Override
            float[] point(Random random) {
                return circle(random);
            }
        };

        abstract float[] circle(Random random);

        /** A place for a query, and a length. */
        float[] point(Random random) {
            return switch (random.nextInt(6)) {
                case 0 -> circle(random);
                case 1 -> row(random.nextInt(41) * 2.5f, random.nextInt(41) * 2.5f, 0.25f * random.nextInt(12));
                case 2 -> row(random.nextFloat() * 400 - 150, random.nextFloat() * 400 - 150, random.nextFloat() * 200);
                case 3 -> row(random.nextFloat() * 100, random.nextFloat() * 100, 0);
                default -> row(random.nextFloat() * 100, random.nextFloat() * 100, random.nextFloat() * 3);
            };
        }

        private static float[] row(float x, float y, float radius) {
            return new float[] {x, y, radius};
        }
    }

    private final CircleTree tree = new CircleTree();
    private final OverlapSearch overlaps = new OverlapSearch(tree);
    private final NearestSearch nearest = new NearestSearch(tree);
    private final CastSearch casts = new CastSearch(tree);

    @ParameterizedTest
    @EnumSource
    void theyFindWhatALookAtEveryCircleFinds(Crowd crowd) {
        Random random = new Random(crowd.ordinal());
        int found = 0;
        for (int n : SIZES) {
            float[] circles = circles(crowd, n, random);
            tree.build(circles, ids(n, 1), n);
            BruteForce truth = new BruteForce(circles, n);
            for (int q = 0; q < QUERIES; q++) {
                found += compare(truth, crowd.point(random), crowd.point(random), 1 + random.nextInt(12));
            }
        }
        assertThat(found).isGreaterThan(50);
    }

    @Test
    void queriesFromFarAwayAndOfNoLengthFindTheSameToo() {
        Random random = new Random(7);
        float[] lengths = {0, -0f, Float.MIN_VALUE, 1e-20f, 1, 50, 1e9f, 1e20f, Float.MAX_VALUE, -Float.MAX_VALUE};
        for (Crowd crowd : Crowd.values()) {
            int n = 300;
            float[] circles = circles(crowd, n, random);
            tree.build(circles, ids(n, 1), n);
            BruteForce truth = new BruteForce(circles, n);
            for (float dx : lengths) {
                for (float dy : lengths) {
                    float[] from = crowd.point(random);
                    compareCasts(truth, from[0], from[1], 0, dx, dy);
                    compareCasts(truth, from[0], from[1], Math.abs(dx), dy, dx);
                    compareCasts(truth, dx, dy, from[2], from[0] - dx, from[1] - dy);
                    assertThat(disc(dx, dy, Math.abs(dy))).isEqualTo(truth.disc(dx, dy, Math.abs(dy)));
                    compareNearest(truth, dx, dy, Math.abs(dx), 9);
                    compareNearest(truth, dx, dy, Float.POSITIVE_INFINITY, 9);
                }
            }
        }
    }

    /** Boxes have sides in floats, but doubles decide whether circles touch. */
    @Test
    void whetherCirclesTouchIsNotLeftToTheRoundingOfBoxes() {
        Random random = new Random(11);
        int touching = 0;
        for (int k = 0; k < 20_000; k++) {
            float[] circle = {100 * random.nextFloat(), 100 * random.nextFloat(), 10 * random.nextFloat(), 1};
            tree.build(circle, new int[1], 1);
            BruteForce truth = new BruteForce(circle, 1);
            float radius = 10 * random.nextFloat();
            float x = (float) ((double) circle[0] + circle[2] + radius);
            int[] disc = truth.disc(x, circle[1], radius);
            assertThat(disc(x, circle[1], radius)).isEqualTo(disc);
            compareNearest(truth, x, circle[1], radius, 1);
            compareCasts(truth, x, circle[1] - 50, radius, 0, 100);
            touching += disc.length;
        }
        assertThat(touching).isBetween(5_000, 15_000);
    }

    private int compare(BruteForce truth, float[] p, float[] q, int most) {
        int[] disc = truth.disc(p[0], p[1], p[2]);
        assertThat(disc(p[0], p[1], p[2])).isEqualTo(disc);
        float minX = Math.min(p[0], q[0]);
        float minY = Math.min(p[1], q[1]);
        float maxX = Math.max(p[0], q[0]);
        float maxY = Math.max(p[1], q[1]);
        assertThat(ids(overlaps.box(minX, minY, maxX, maxY, null))).isEqualTo(truth.box(minX, minY, maxX, maxY));
        assertThat(ids(overlaps.box(p[0], p[1], p[0], p[1], null))).isEqualTo(truth.box(p[0], p[1], p[0], p[1]));
        assertThat(overlaps.pick(p[0], p[1], null)).isEqualTo(truth.pick(p[0], p[1]));
        compareNearest(truth, p[0], p[1], p[2], most);
        compareNearest(truth, q[0], q[1], Float.POSITIVE_INFINITY, most);
        compareCasts(truth, p[0], p[1], 0, q[0] - p[0], q[1] - p[1]);
        compareCasts(truth, p[0], p[1], q[2], q[0] - p[0], q[1] - p[1]);
        compareCasts(truth, p[0], p[1], 0, q[0] - p[0], 0);
        compareCasts(truth, p[0], p[1], q[2], 0, q[1] - p[1]);
        return disc.length;
    }

    private void compareNearest(BruteForce truth, float x, float y, float within, int most) {
        List<BruteForce.Hit> hits = truth.nearest(x, y, within, most);
        assertThat(nearest.find(x, y, within, most, null)).isEqualTo(hits.size());
        for (int k = 0; k < hits.size(); k++) {
            assertThat(nearest.id(k)).isEqualTo(hits.get(k).circle());
            assertThat(nearest.distance(k)).isEqualTo(hits.get(k).distance());
        }
    }

    private void compareCasts(BruteForce truth, float x, float y, float radius, float dx, float dy) {
        List<BruteForce.Hit> hits = truth.cast(x, y, radius, dx, dy);
        casts.aim(x, y, radius, dx, dy);
        float[] row = new float[7];
        assertThat(casts.first(null)).isEqualTo(!hits.isEmpty());
        if (!hits.isEmpty()) {
            assertThat(casts.id(0)).isEqualTo(hits.get(0).circle());
            casts.writeHit(0, row, 1);
            assertThat(Arrays.copyOfRange(row, 1, 6)).isEqualTo(hits.get(0).row());
            assertThat(row[0] + row[6]).isZero();
        } else {
            casts.writeMiss(row, 2);
            assertThat(Arrays.copyOfRange(row, 2, 7)).isEqualTo(BruteForce.miss(x, y, dx, dy));
        }
        assertThat(casts.all(null)).isEqualTo(hits.size());
        for (int k = 0; k < hits.size(); k++) {
            assertThat(casts.id(k)).isEqualTo(hits.get(k).circle());
            casts.writeHit(k, row, 0);
            assertThat(Arrays.copyOf(row, 5)).isEqualTo(hits.get(k).row());
        }
    }

    @Test
    void idsNeedNotBeDenseAndAFilterLeavesCirclesOut() {
        Random random = new Random(3);
        int n = 500;
        float[] circles = circles(Crowd.MIXED, n, random);
        tree.build(circles, ids(n, 7), n);
        float[] odd = new float[4 * n / 2]; // of the circles with odd ids: 7, 21, 35 ...
        for (int i = 0; i < n / 2; i++) {
            System.arraycopy(circles, 4 * (2 * i + 1), odd, 4 * i, 4);
        }
        IntPredicate filter = id -> id % 2 == 1;
        BruteForce truth = new BruteForce(odd, n / 2);
        for (int q = 0; q < 200; q++) {
            float[] p = Crowd.MIXED.point(random);
            float[] d = Crowd.MIXED.point(random);
            assertThat(ids(overlaps.disc(p[0], p[1], p[2], filter))).isEqualTo(oddIds(truth.disc(p[0], p[1], p[2])));
            assertThat(ids(overlaps.box(p[0], p[1], p[0] + d[2], p[1] + d[2], filter)))
                    .isEqualTo(oddIds(truth.box(p[0], p[1], p[0] + d[2], p[1] + d[2])));
            int pick = truth.pick(p[0], p[1]);
            assertThat(overlaps.pick(p[0], p[1], filter)).isEqualTo(pick < 0 ? -1 : oddId(pick));
            int count = nearest.find(p[0], p[1], Float.POSITIVE_INFINITY, 5, filter);
            assertThat(IntStream.range(0, count).map(nearest::id).toArray())
                    .isEqualTo(oddIds(circles(truth.nearest(p[0], p[1], Float.POSITIVE_INFINITY, 5))));
            int[] hits = circles(truth.cast(p[0], p[1], p[2], d[0], d[1]));
            casts.aim(p[0], p[1], p[2], d[0], d[1]);
            assertThat(casts.first(filter)).isEqualTo(hits.length > 0);
            assertThat(hits.length == 0 || casts.id(0) == oddId(hits[0])).isTrue();
            count = casts.all(filter);
            assertThat(IntStream.range(0, count).map(casts::id).toArray()).isEqualTo(oddIds(hits));
        }
    }

    private static int oddId(int circle) {
        return 7 * (2 * circle + 1);
    }

    private static int[] oddIds(int[] circles) {
        return IntStream.of(circles).map(SearchTest::oddId).toArray();
    }

    private static int[] circles(List<BruteForce.Hit> hits) {
        return hits.stream().mapToInt(BruteForce.Hit::circle).toArray();
    }

    @Test
    void aTreeMayBeBuiltAgainWithMoreOrFewerCircles() {
        Random random = new Random(5);
        for (int n : new int[] {5, 1000, 0, 40, 1, 4097}) {
            float[] circles = circles(Crowd.LIKE, n, random);
            tree.build(circles, ids(n, 1), n);
            assertThat(disc(50, 50, 1000)).hasSize(n);
            assertThat(disc(50, 50, 20)).isEqualTo(new BruteForce(circles, n).disc(50, 50, 20));
        }
    }

    @Test
    void aBoulderInTheSandOrOneFarAwayDoesNotMakeASearchLookAtAll() {
        Random random = new Random(9);
        int n = 20_000;
        float[] sand = circles(Crowd.LIKE, n, random);
        long alone = work(sand, n);
        float[] mixed = sand.clone();
        for (int boulder = 0; boulder < 20; boulder++) {
            mixed[4 * 1000 * boulder + 2] = 40;
        }
        float[] outlying = sand.clone();
        outlying[0] = 1e9f;
        assertThat(alone).isLessThan(100L * 200);
        assertThat(work(mixed, n)).isLessThan(alone + 100L * 20 * 8);
        assertThat(work(outlying, n)).isLessThan(2 * n * 100L / 40);
    }

    /** How many circles a filter that admits none is asked about, and boxes are looked at, by a hundred searches. */
    private long work(float[] circles, int n) {
        tree.build(circles, ids(n, 1), n);
        Random random = new Random(1);
        long sum = 0;
        for (int q = 0; q < 100; q++) {
            sum += overlaps.circlesNear(random.nextFloat() * 100, random.nextFloat() * 100, 0.5f);
        }
        return sum;
    }

    private int[] disc(float x, float y, float radius) {
        return ids(overlaps.disc(x, y, radius, null));
    }

    private int[] ids(int count) {
        return IntStream.range(0, count).map(overlaps::id).toArray();
    }

    private static int[] ids(int n, int distance) {
        return IntStream.range(0, n).map(i -> distance * i).toArray();
    }

    private static float[] circles(Crowd crowd, int n, Random random) {
        float[] circles = new float[4 * n];
        for (int i = 0; i < n; i++) {
            System.arraycopy(crowd.circle(random), 0, circles, 4 * i, 3);
            circles[4 * i + 3] = 1;
        }
        return circles;
    }
}
