package io.github.circles2d.world.queries;

/**
 * The exact tests, which decide what a search finds. They compute in double precision, from the floats that a read gives, in the
 * order in which they are written. What touches exactly counts.
 */
final class CircleTests {
    /** No hit. */
    static final double NONE = -1;

    private CircleTests() {}

    /** Whether a disc of radius reach around (px, py) overlaps or touches a circle. */
    static boolean overlapsDisc(double px, double py, double reach, float x, float y, float radius) {
        double s = radius + reach;
        return squaredDistance(px, py, x, y) <= s * s;
    }

    static double squaredDistance(double px, double py, float x, float y) {
        double dx = x - px;
        double dy = y - py;
        return dx * dx + dy * dy;
    }

    static boolean overlapsBox(double minX, double minY, double maxX, double maxY, float x, float y, float radius) {
        double dx = Math.max(Math.max(minX - x, x - maxX), 0);
        double dy = Math.max(Math.max(minY - y, y - maxY), 0);
        return dx * dx + dy * dy <= (double) radius * radius;
    }

    /** The distance from a point to the edge of a circle; negative inside. */
    static double edgeDistance(double px, double py, float x, float y, float radius) {
        return Math.sqrt(squaredDistance(px, py, x, y)) - radius;
    }

    /**
     * How far a disc of radius reach moves from (px, py) along the unit vector (ux, uy) until it touches a circle: 0 if it overlaps
     * or touches it at the start, {@link #NONE} if it does not within the length. The vector may be 0, if the length is 0.
     */
    static double castDistance(
            double px, double py, double reach, double ux, double uy, double length, float x, float y, float radius) {
        double dx = x - px;
        double dy = y - py;
        double s = radius + reach;
        if (dx * dx + dy * dy <= s * s) {
            return 0;
        }
        double along = dx * ux + dy * uy;
        double across = dx * uy - dy * ux;
        double square = s * s - across * across;
        if (along <= 0 || square < 0) {
            return NONE;
        }
        double distance = Math.max(along - Math.sqrt(square), 0);
        return distance <= length ? distance : NONE;
    }
}
