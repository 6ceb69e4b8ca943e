package io.github.circles2d.world.queries;

import io.github.circles2d.world.model.Bounds;
import java.util.Arrays;
import java.util.function.IntPredicate;

/**
 * The searches among things in a tree of boxes, by the shape of the query: pieces of terrain, or bodies. Where an axis wraps, each thing has an
 * image a period farther to either side.
 */
public abstract class BoxSearch<S extends ThingShape> extends PathSearch implements Search {
    /** More than what boxes and ends lose by rounding, by its share of coordinates. */
    private static final double MARGIN = 0x1p-21;

    /** Most images of a thing, itself among them: three along each axis. */
    private static final int IMAGES = 9;

    private static final int BOX = 4;

    final S shape;
    private final FoundIds overlaps = new FoundIds();

    // what is searched, as BoxTree has it, and the greatest id of a thing, and 1
    private int nodes;
    private float[] boxes;
    private int[] links;
    private int things;
    private final double[] shiftX = new double[IMAGES];
    private final double[] shiftY = new double[IMAGES];
    private int images;

    /** Where a path ends at last, along axes that wrap. */
    private double lowX;

    private double lowY;
    private double highX;
    private double highY;

    /** The greatest coordinate of a thing. */
    private double span;

    // nodes that a search has still to look at, the nearest of those with one parent first
    private int[] node = new int[Capacity.atLeast(0, 0)];
    private double[] nodeDistance = new double[node.length];
    private int waiting;

    /** Whether what it meets at its start does not count. */
    private boolean leavesStart;

    // the point that the nearest are searched for, or the area
    private boolean isBox;
    private double minX;
    private double minY;
    private double maxX;
    private double maxY;

    BoxSearch(S shape) {
        this.shape = shape;
    }

    /** Makes the shape that of a thing, moved by so much. */
    abstract void take(int thing, double byX, double byY);

    /** Says which things the searches to come look at. */
    final void show(int itsNodes, float[] itsBoxes, int[] itsLinks, int itsThings, Bounds bounds) {
        nodes = itsNodes;
        boxes = itsBoxes;
        links = itsLinks;
        things = itsThings;
        double periodX = bounds.periodX();
        double periodY = bounds.periodY();
        boolean wrapsX = periodX < Double.POSITIVE_INFINITY;
        boolean wrapsY = periodY < Double.POSITIVE_INFINITY;
        images = 0;
        for (int i = wrapsX ? -1 : 0; i <= (wrapsX ? 1 : 0); i++) {
            for (int j = wrapsY ? -1 : 0; j <= (wrapsY ? 1 : 0); j++) {
                shiftX[images] = i == 0 ? 0 : i * periodX;
                shiftY[images++] = j == 0 ? 0 : j * periodY;
            }
        }
        double none = Double.POSITIVE_INFINITY;
        lowX = wrapsX ? bounds.minX() - 0.5 * periodX : -none;
        highX = wrapsX ? bounds.maxX() + 0.5 * periodX : none;
        lowY = wrapsY ? bounds.minY() - 0.5 * periodY : -none;
        highY = wrapsY ? bounds.maxY() + 0.5 * periodY : none;
        span = 0;
        for (int root = 0; root < nodes; root = links[2 * root]) {
            for (int k = 0; k < BOX; k++) {
                span = Math.max(span, Math.abs(boxes[BOX * root + k]));
            }
        }
        span += Math.max(Math.abs(shiftX[0]), Math.abs(shiftY[0]));
    }

    private void take(int thing, int image) {
        take(thing, shiftX[image], shiftY[image]);
    }

    // ---- overlaps

    @Override
    public int all(QueryShape what, float[] query, IntPredicate filter) {
        switch (what) {
            case DISC -> disc(query[0], query[1], query[2]);
            case BOX -> box(query[0], query[1], query[2], query[3]);
            case RAY, DISC_CAST -> {
                aim(what, query, 0);
                return all(filter);
            }
            default -> throw new IllegalArgumentException(what + " does not find all");
        }
        return overlap(filter);
    }

    private void disc(double x, double y, double radius) {
        isBox = false;
        startX = x;
        startY = y;
        reach = radius;
        minX = x - radius;
        minY = y - radius;
        maxX = x + radius;
        maxY = y + radius;
    }

    private void box(double left, double below, double right, double above) {
        isBox = true;
        minX = left;
        minY = below;
        maxX = right;
        maxY = above;
    }

    private int overlap(IntPredicate filter) {
        overlaps.clear();
        double x = Math.max(Math.abs(minX), Math.abs(maxX));
        double margin = (span + Math.max(x, Math.max(Math.abs(minY), Math.abs(maxY)))) * MARGIN;
        for (int image = 0; image < images; image++) {
            double left = minX - margin - shiftX[image];
            double below = minY - margin - shiftY[image];
            double right = maxX + margin - shiftX[image];
            double above = maxY + margin - shiftY[image];
            int i = 0;
            while (i < nodes) {
                int at = BOX * i;
                if (boxes[at] <= right && boxes[at + 1] <= above && boxes[at + 2] >= left && boxes[at + 3] >= below) {
                    int thing = links[2 * i + 1];
                    if (thing >= 0 && isFirstOverlap(thing, image) && (filter == null || filter.test(thing))) {
                        overlaps.add(thing);
                    }
                    i++;
                } else {
                    i = links[2 * i];
                }
            }
        }
        overlaps.sort(things);
        return overlaps.count();
    }

    /** Whether an image overlaps, and none before it. */
    private boolean isFirstOverlap(int thing, int image) {
        for (int before = 0; before < image; before++) {
            if (overlapsImage(thing, before)) {
                return false;
            }
        }
        return overlapsImage(thing, image);
    }

    private boolean overlapsImage(int thing, int image) {
        take(thing, image);
        return isBox ? shape.overlapsBox(minX, minY, maxX, maxY) : shape.overlapsDisc(startX, startY, reach);
    }

    @Override
    public int id(QueryShape what, int k) {
        return what.isCast() ? found.id(k) : overlaps.id(k);
    }

    // ---- paths

    /** How far a path goes until it is half a period beyond the bounds. */
    private double most() {
        double x = unitX > 0 ? (highX - startX) / unitX : unitX < 0 ? (lowX - startX) / unitX : length;
        double y = unitY > 0 ? (highY - startY) / unitY : unitY < 0 ? (lowY - startY) / unitY : length;
        return Math.min(length, Math.min(x, y));
    }

    @Override
    void search(int most, IntPredicate filter) {
        found.clear();
        double way = most();
        double far = Math.max(Math.abs(startX), Math.abs(startY)) + reach;
        double margin = reach + (span + far) * MARGIN;
        for (int image = 0; image < images; image++) {
            waiting = 0;
            pushOnPath(0, nodes, image, margin, Math.min(way, found.last(most)));
            while (--waiting >= 0) {
                int i = node[waiting];
                double limit = Math.min(way, found.last(most));
                if (nodeDistance[waiting] > limit) {
                    continue;
                }
                int thing = links[2 * i + 1];
                if (thing < 0) {
                    pushOnPath(i + 1, links[2 * i], image, margin, limit);
                } else {
                    meet(thing, image, way, most, filter);
                }
            }
        }
    }

    private void meet(int thing, int image, double way, int most, IntPredicate filter) {
        take(thing, image);
        double d = shape.castDistance(startX, startY, reach, unitX, unitY, way);
        if (d != CircleTests.NONE && !(leavesStart && d == 0) && (filter == null || filter.test(thing))) {
            found.offer(d, thing, image, most);
        }
    }

    /** Adds those of a row of siblings that the path meets up to a limit. */
    private void pushOnPath(int from, int to, int image, double margin, double limit) {
        int base = waiting;
        double inverseX = 1 / unitX;
        double inverseY = 1 / unitY;
        double x = startX - shiftX[image];
        double y = startY - shiftY[image];
        for (int i = from; i < to; i = links[2 * i]) {
            int at = BOX * i;
            double leftIn = (boxes[at] - margin - x) * inverseX;
            double rightIn = (boxes[at + 2] + margin - x) * inverseX;
            double lowIn = (boxes[at + 1] - margin - y) * inverseY;
            double highIn = (boxes[at + 3] + margin - y) * inverseY;
            double enter = Math.max(Math.max(Math.min(leftIn, rightIn), Math.min(lowIn, highIn)), 0);
            double leave = Math.min(Math.min(Math.max(leftIn, rightIn), Math.max(lowIn, highIn)), limit);
            if (!(enter > leave)) {
                push(base, i, enter);
            }
        }
    }

    private void push(int base, int i, double distance) {
        if (waiting == node.length) {
            nodeDistance = Arrays.copyOf(nodeDistance, Capacity.atLeast(waiting + 1, waiting));
            node = Arrays.copyOf(node, nodeDistance.length);
        }
        int k = waiting++;
        while (k > base && nodeDistance[k - 1] < distance) {
            node[k] = node[k - 1];
            nodeDistance[k] = nodeDistance[k - 1];
            k--;
        }
        node[k] = i;
        nodeDistance[k] = distance;
    }

    /** Whether a ray meets a thing that it does not begin at. */
    public boolean isBlocked(float x, float y, float dx, float dy, IntPredicate filter) {
        aim(x, y, 0, dx, dy);
        leavesStart = true;
        try {
            return first(filter);
        } finally {
            leavesStart = false;
        }
    }

    @Override
    public void writeHit(int k, float[] to, int at) {
        take(found.id(k), found.place(k));
        double distance = found.distance(k);
        double x = startX + unitX * distance;
        double y = startY + unitY * distance;
        shape.normalAt(x, y, reach, unitX, unitY);
        CastSearch.write(to, at, distance, x, y, shape.normalX, shape.normalY);
    }

    // ---- the nearest

    @Override
    public int nearest(float x, float y, float within, int most, IntPredicate filter) {
        found.clear();
        startX = x;
        startY = y;
        double margin = (span + Math.max(Math.abs(startX), Math.abs(startY))) * MARGIN;
        for (int image = 0; image < images; image++) {
            waiting = 0;
            pushNear(0, nodes, image, margin, Math.min(within, found.last(most)));
            while (--waiting >= 0) {
                int i = node[waiting];
                double limit = Math.min(within, found.last(most));
                if (nodeDistance[waiting] > limit) {
                    continue;
                }
                int thing = links[2 * i + 1];
                if (thing < 0) {
                    pushNear(i + 1, links[2 * i], image, margin, limit);
                } else if (isNearestImage(thing, image) && (filter == null || filter.test(thing))) {
                    take(thing, image);
                    double d = shape.distance(startX, startY);
                    if (d <= within) {
                        found.offer(d, thing, image, most);
                    }
                }
            }
        }
        found.sort();
        return found.count();
    }

    private boolean isNearestImage(int thing, int image) {
        if (images == 1) {
            return true;
        }
        take(thing, image);
        double own = shape.distance(startX, startY);
        for (int other = 0; other < images; other++) {
            take(thing, other);
            double d = shape.distance(startX, startY);
            if (d < own || d == own && other < image) {
                return false;
            }
        }
        return true;
    }

    private void pushNear(int from, int to, int image, double margin, double limit) {
        int base = waiting;
        double x = startX - shiftX[image];
        double y = startY - shiftY[image];
        for (int i = from; i < to; i = links[2 * i]) {
            int at = BOX * i;
            double dx = Math.max(boxes[at] - x, x - boxes[at + 2]);
            double dy = Math.max(boxes[at + 1] - y, y - boxes[at + 3]);
            double least = (dx <= 0 || dy <= 0 ? Math.max(dx, dy) : Math.sqrt(dx * dx + dy * dy)) - margin;
            if (least <= limit) {
                push(base, i, least);
            }
        }
    }

    @Override
    public int nearestId(int k) {
        return found.id(k);
    }

    @Override
    public double nearestDistance(int k) {
        return found.distance(k);
    }

    @Override
    public void writeNearest(int k, float[] to, int at) {
        take(found.id(k), found.place(k));
        shape.normalFrom(startX, startY);
        CastSearch.write(to, at, found.distance(k), shape.surfaceX, shape.surfaceY, shape.normalX, shape.normalY);
    }
}
