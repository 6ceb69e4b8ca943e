package io.github.circles2d.world.bodies;

import io.github.circles2d.world.terrain.ChainPath;

/** Which paths are outlines. */
final class OutlineChecks {
    /** Of the extent: how far lines may be from an arc where the path is taken for a polygon. */
    private static final double TOLERANCE = 1e-3;

    private OutlineChecks() {}

    static void closed(ChainPath path) {
        if (!path.isClosed()) {
            throw new IllegalArgumentException("the chain of an outline must be closed");
        }
        if (path.pieces() > OutlineShape.PIECES) {
            throw new IllegalArgumentException(
                    "the outline has " + path.pieces() + " pieces, but may have at most " + OutlineShape.PIECES);
        }
    }

    /** Of the polygon through the points of a path, positive if it goes anticlockwise. */
    static double area(ChainPath path) {
        float[] p = polygon(path);
        double sum = 0;
        for (int k = 0, n = p.length / 2 - 1; k < n; k++) {
            sum += ((double) p[2 * k] - p[0]) * ((double) p[2 * k + 3] - p[1])
                    - ((double) p[2 * k + 1] - p[1]) * ((double) p[2 * k + 2] - p[0]);
        }
        return sum / 2;
    }

    /** The diagonal of its box. */
    static double extent(ChainPath path) {
        return diagonal(path.points(Float.POSITIVE_INFINITY), path);
    }

    private static double diagonal(float[] p, ChainPath path) {
        double minX = p[0];
        double maxX = minX;
        double minY = p[1];
        double maxY = minY;
        for (int k = 0; k < p.length; k += 2) {
            minX = Math.min(minX, p[k]);
            maxX = Math.max(maxX, p[k]);
            minY = Math.min(minY, p[k + 1]);
            maxY = Math.max(maxY, p[k + 1]);
        }
        for (int k = 0; k < path.pieces(); k++) {
            if (path.turn(k) != 0) {
                // a point on the other side is as far as the centre at least
                minX = Math.min(minX, path.centreX(k));
                maxX = Math.max(maxX, path.centreX(k));
                minY = Math.min(minY, path.centreY(k));
                maxY = Math.max(maxY, path.centreY(k));
            }
        }
        return Math.sqrt((maxX - minX) * (maxX - minX) + (maxY - minY) * (maxY - minY));
    }

    private static float[] polygon(ChainPath path) {
        float tolerance = (float) (TOLERANCE * extent(path));
        return path.points(Math.max(tolerance, Float.MIN_NORMAL));
    }

    /** The greatest distance of two of its points. */
    static double length(ChainPath path) {
        float[] p = polygon(path);
        double most = 0;
        for (int k = 0; k < p.length; k += 2) {
            for (int to = k + 2; to < p.length; to += 2) {
                double dx = (double) p[to] - p[k];
                double dy = (double) p[to + 1] - p[k + 1];
                most = Math.max(most, dx * dx + dy * dy);
            }
        }
        return Math.sqrt(most);
    }

    /** The least width of its hull. */
    static double leastWidth(ChainPath path) {
        float[] p = polygon(path);
        double least = Double.POSITIVE_INFINITY;
        int n = p.length / 2 - 1;
        for (int k = 0; k < n; k++) {
            for (int to = k + 1; to < n; to++) {
                double dx = (double) p[2 * to] - p[2 * k];
                double dy = (double) p[2 * to + 1] - p[2 * k + 1];
                double length = Math.sqrt(dx * dx + dy * dy);
                if (length > 0 && isOnHull(p, n, k, to)) {
                    least = Math.min(least, width(p, n, dy / length, -dx / length));
                }
            }
        }
        return least;
    }

    /** Whether all points lie on one side of the line through two. */
    private static boolean isOnHull(float[] p, int n, int a, int b) {
        double dx = (double) p[2 * b] - p[2 * a];
        double dy = (double) p[2 * b + 1] - p[2 * a + 1];
        boolean left = false;
        boolean right = false;
        for (int k = 0; k < n && !(left && right); k++) {
            double side = dx * ((double) p[2 * k + 1] - p[2 * a + 1]) - dy * ((double) p[2 * k] - p[2 * a]);
            left |= side > 0;
            right |= side < 0;
        }
        return !(left && right);
    }

    private static double width(float[] p, int n, double nx, double ny) {
        double low = Double.POSITIVE_INFINITY;
        double high = Double.NEGATIVE_INFINITY;
        for (int k = 0; k < n; k++) {
            double at = nx * ((double) p[2 * k] - p[0]) + ny * ((double) p[2 * k + 1] - p[1]);
            low = Math.min(low, at);
            high = Math.max(high, at);
        }
        return high - low;
    }

    private static String ends(ChainPath path, int piece) {
        return "between (" + path.x(piece) + ", " + path.y(piece) + ") and (" + path.x(piece + 1) + ", "
                + path.y(piece + 1) + ")";
    }

    /** Refuses a path that meets itself. Reversed: it is not as it was drawn. */
    static void simple(ChainPath path, boolean reversed) {
        float tolerance = (float) (TOLERANCE * extent(path));
        int pieces = path.pieces();
        float[][] lines = new float[pieces][];
        for (int k = 0; k < pieces; k++) {
            lines[k] = pointsOf(path, k, Math.max(tolerance, Float.MIN_NORMAL));
        }
        for (int a = 0; a < pieces; a++) {
            for (int b = a; b < pieces; b++) {
                if (meet(lines[a], lines[b], a == b, b == a + 1 || pieces == 2, a == 0 && b == pieces - 1)) {
                    int one = reversed ? pieces - 1 - b : a;
                    int other = reversed ? pieces - 1 - a : b;
                    throw new IllegalArgumentException("pieces " + one + " and " + other + " of the outline, "
                            + ends(path, reversed ? b : a) + " and " + ends(path, reversed ? a : b)
                            + ", meet, but an outline must not cross itself");
                }
            }
        }
    }

    private static float[] pointsOf(ChainPath path, int k, float tolerance) {
        ChainPath alone = new ChainPath(path.x(k), path.y(k));
        if (path.turn(k) == 0) {
            alone.lineTo(path.x(k + 1), path.y(k + 1));
        } else {
            alone.arcBy(path.centreX(k), path.centreY(k), path.turn(k));
        }
        return alone.points(tolerance);
    }

    /** follows: b begins where a ends; leads: a begins where b ends. */
    private static boolean meet(float[] a, float[] b, boolean same, boolean follows, boolean leads) {
        int linesA = a.length / 2 - 1;
        int linesB = b.length / 2 - 1;
        for (int i = 0; i < linesA; i++) {
            for (int k = same ? i + 1 : 0; k < linesB; k++) {
                boolean afterA = same ? k == i + 1 : follows && i == linesA - 1 && k == 0;
                boolean beforeA = (same || leads) && i == 0 && k == linesB - 1;
                if (afterA || beforeA ? turnsBack(a, i, b, k, afterA) : cross(a, i, b, k)) {
                    return true;
                }
            }
        }
        return false;
    }

    /** Of two lines that share a point. */
    private static boolean turnsBack(float[] a, int i, float[] b, int k, boolean afterA) {
        double ax = (double) a[2 * i + 2] - a[2 * i];
        double ay = (double) a[2 * i + 3] - a[2 * i + 1];
        double bx = (double) b[2 * k + 2] - b[2 * k];
        double by = (double) b[2 * k + 3] - b[2 * k + 1];
        double cross = ax * by - ay * bx;
        double lengths = Math.sqrt((ax * ax + ay * ay) * (bx * bx + by * by));
        return ax * bx + ay * by < 0 && Math.abs(cross) < 1e-6 * lengths;
    }

    private static boolean cross(float[] a, int i, float[] b, int k) {
        double p = side(a, i, b[2 * k], b[2 * k + 1]);
        double q = side(a, i, b[2 * k + 2], b[2 * k + 3]);
        double s = side(b, k, a[2 * i], a[2 * i + 1]);
        double t = side(b, k, a[2 * i + 2], a[2 * i + 3]);
        if (p == 0 && q == 0) {
            return overlap(a[2 * i], a[2 * i + 2], b[2 * k], b[2 * k + 2])
                    && overlap(a[2 * i + 1], a[2 * i + 3], b[2 * k + 1], b[2 * k + 3]);
        }
        return !(p > 0 && q > 0 || p < 0 && q < 0) && !(s > 0 && t > 0 || s < 0 && t < 0);
    }

    private static boolean overlap(float a, float b, float c, float d) {
        return Math.min(a, b) <= Math.max(c, d) && Math.min(c, d) <= Math.max(a, b);
    }

    private static double side(float[] line, int k, float x, float y) {
        double dx = (double) line[2 * k + 2] - line[2 * k];
        double dy = (double) line[2 * k + 3] - line[2 * k + 1];
        return dx * ((double) y - line[2 * k + 1]) - dy * ((double) x - line[2 * k]);
    }
}
