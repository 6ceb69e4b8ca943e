package io.github.circles2d.world.queries;

import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.CircleRow;
import java.util.function.IntPredicate;

/** The searches in a tree of circles. */
public final class TreeSearch implements Search {
    private final CircleTree tree = new CircleTree();
    private final Images images = new Images();
    private final OverlapSearch overlaps = new OverlapSearch(tree);
    private final NearestSearch nearest = new NearestSearch(tree);
    private final CastSearch casts = new CastSearch(tree);

    /** As {@link CircleTree#build}; if the arena wraps, circles have images beyond it. */
    public void build(float[] circles, int[] ids, int n, Bounds bounds) {
        if (bounds.wraps()) {
            images.make(circles, ids, n, bounds);
            tree.build(images, n == 0 ? 0 : ids[n - 1] + 1, bounds);
        } else {
            tree.build(circles, ids, n);
        }
    }

    @Override
    public int all(QueryShape shape, float[] query, IntPredicate filter) {
        return switch (shape) {
            case DISC -> overlaps.disc(query[0], query[1], query[2], filter);
            case BOX -> overlaps.box(query[0], query[1], query[2], query[3], filter);
            case RAY, DISC_CAST -> {
                casts.aim(shape, query, 0);
                yield casts.all(filter);
            }
            default -> throw new IllegalArgumentException(shape + " does not find all");
        };
    }

    @Override
    public int id(QueryShape shape, int k) {
        return shape.isCast() ? casts.id(k) : overlaps.id(k);
    }

    @Override
    public void writeHit(int k, float[] to, int at) {
        casts.writeHit(k, to, at);
    }

    @Override
    public int first(QueryShape shape, float[] query, IntPredicate filter, float[] hits, int to) {
        return shape == QueryShape.POINT
                ? overlaps.pick(query[0], query[1], filter)
                : casts.first(shape, query, filter, hits, to);
    }

    @Override
    public int nearest(float x, float y, float within, int most, IntPredicate filter) {
        return nearest.find(x, y, within, most, filter);
    }

    @Override
    public int nearestId(int k) {
        return nearest.id(k);
    }

    @Override
    public double nearestDistance(int k) {
        return nearest.distance(k);
    }

    @Override
    public void writeNearest(int k, float[] to, int at) {
        throw new IllegalStateException("no query asks for hits of the nearest circles");
    }

    /**
     * The circles of a world of which an axis wraps, and their images: each circle is also a period farther to either side, where that is
     * no more than half a period beyond the bounds. So whatever is nearest to a place inside the bounds, the short way round, is there.
     */
    static final class Images {
        private float[] circles = new float[0];
        private int[] ids = new int[0];
        private int count;

        /** Takes rows of circles and their ids, and makes their images. */
        public void make(float[] rows, int[] ofRows, int n, Bounds bounds) {
            boolean x = bounds.periodX() < Float.POSITIVE_INFINITY;
            boolean y = bounds.periodY() < Float.POSITIVE_INFINITY;
            int most = Math.multiplyExact(n, (x ? 2 : 1) * (y ? 2 : 1));
            if (ids.length < most) {
                int c = Capacity.atLeast(most, ids.length);
                circles = new float[Math.multiplyExact(CircleRow.STRIDE, c)];
                ids = new int[c];
            }
            System.arraycopy(rows, 0, circles, 0, CircleRow.STRIDE * n);
            System.arraycopy(ofRows, 0, ids, 0, n);
            count = n;
            if (x) {
                add(CircleRow.X, bounds.periodX(), 0.5f * bounds.minX() + 0.5f * bounds.maxX());
            }
            if (y) {
                add(CircleRow.Y, bounds.periodY(), 0.5f * bounds.minY() + 0.5f * bounds.maxY());
            }
        }

        /** Adds an image of each that there is: to the right of those in the lower half, to the left of those in the upper. */
        private void add(int coordinate, float period, float middle) {
            int before = count;
            for (int k = 0; k < before; k++) {
                int from = CircleRow.of(k);
                int to = CircleRow.of(count);
                System.arraycopy(circles, from, circles, to, CircleRow.STRIDE);
                circles[to + coordinate] += circles[from + coordinate] < middle ? period : -period;
                ids[count++] = ids[k];
            }
        }

        /** Rows of all. */
        public float[] circles() {
            return circles;
        }

        /** The id of each. */
        public int[] ids() {
            return ids;
        }

        /** Their number. */
        public int count() {
            return count;
        }
    }
}
