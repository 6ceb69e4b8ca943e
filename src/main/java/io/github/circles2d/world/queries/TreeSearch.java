package io.github.circles2d.world.queries;

import io.github.circles2d.world.model.Bounds;
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
}
