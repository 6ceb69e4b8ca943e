package io.github.circles2d.world.queries;

import io.github.circles2d.world.model.Bounds;

/** The searches in a tree of circles, by the shape of the query. */
public final class TreeSearch {
    private final CircleTree tree = new CircleTree();
    private final Images images = new Images();
    private final OverlapSearch overlaps = new OverlapSearch(tree);
    private final NearestSearch nearest = new NearestSearch(tree);
    private final CastSearch casts = new CastSearch(tree);

    /** No circles. */
    public TreeSearch() {}

    /** As {@link CircleTree#build}; if the arena wraps, circles have images beyond it. */
    public void build(float[] circles, int[] ids, int n, Bounds bounds) {
        if (bounds.wraps()) {
            images.make(circles, ids, n, bounds);
            tree.build(images, n == 0 ? 0 : ids[n - 1] + 1, bounds);
        } else {
            tree.build(circles, ids, n);
        }
    }

    /** Finds all circles of a checked query, what overlaps by id, what a path meets by distance, then by id, and returns how many. */
    public int all(QueryShape shape, float[] query, IdFilter filter) {
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

    /** The circle with a number from 0 to those that {@link #all} has found. */
    public int id(QueryShape shape, int k) {
        return shape.isCast() ? casts.id(k) : overlaps.id(k);
    }

    /** Writes the hit with a number from 0 to those that {@link #all} has found. */
    public void writeHit(int k, float[] to, int at) {
        casts.writeHit(k, to, at);
    }

    /** Finds the circle at a point; -1 if there is none. */
    public int pick(float[] query, IdFilter filter) {
        return overlaps.pick(query[0], query[1], filter);
    }

    /** The first circle that a path meets, or -1; hits takes the hit, or the end of the path, or is null. */
    public int first(QueryShape shape, float[] query, IdFilter filter, float[] hits, int to) {
        casts.aim(shape, query, 0);
        boolean hit = casts.first(filter);
        if (hits != null && hit) {
            casts.writeHit(0, hits, to);
        } else if (hits != null) {
            casts.writeMiss(hits, to);
        }
        return hit ? casts.id(0) : -1;
    }

    /** {@link #nearestId} and {@link #nearestDistance} tell of the circles. */
    public int nearest(float[] query, float within, int most, IdFilter filter) {
        return nearest.find(query[0], query[1], within, most, filter);
    }

    /** The circle with a number from 0 to those that {@link #nearest} has found. */
    public int nearestId(int k) {
        return nearest.id(k);
    }

    public double nearestDistance(int k) {
        return nearest.distance(k);
    }
}
