package io.github.circles2d.world.jvm.bodies;

/** A line or an arc of a {@link SensedShape}, where the shape is. An arc goes anticlockwise, by half a turn at most. */
final class SensedEdge {
    // as the shape lies unturned, around its place
    private double ownFromX;
    private double ownFromY;
    private double ownToX;
    private double ownToY;
    private double ownCentreX;
    private double ownCentreY;

    double fromX;
    double fromY;
    double toX;
    double toY;
    double centreX;
    double centreY;

    /** 0 of a line. */
    double radius;

    /** Half of the chord: the edge lies in the circle over that. */
    double half;

    void set(double sx, double sy, double ex, double ey, double cx, double cy, double r) {
        ownFromX = sx;
        ownFromY = sy;
        ownToX = ex;
        ownToY = ey;
        ownCentreX = cx;
        ownCentreY = cy;
        radius = r;
        half = 0.5 * SensedGap.length(ex - sx, ey - sy);
    }

    /** Brings it to where the shape is now. */
    void put(double x, double y, double cos, double sin) {
        fromX = x + (cos * ownFromX - sin * ownFromY);
        fromY = y + (sin * ownFromX + cos * ownFromY);
        toX = x + (cos * ownToX - sin * ownToY);
        toY = y + (sin * ownToX + cos * ownToY);
        centreX = x + (cos * ownCentreX - sin * ownCentreY);
        centreY = y + (sin * ownCentreX + cos * ownCentreY);
    }

    boolean isArc() {
        return radius > 0;
    }

    /** Whether a direction from the centre of an arc is in its opening. */
    boolean opens(double dx, double dy) {
        double sx = fromX - centreX;
        double sy = fromY - centreY;
        double ex = toX - centreX;
        double ey = toY - centreY;
        return sx * dy - sy * dx >= 0 && dx * ey - dy * ex >= 0;
    }

    /** Whether the ends of a line are on different sides of it, which is a line, too. */
    boolean divides(SensedEdge line) {
        double ux = toX - fromX;
        double uy = toY - fromY;
        double from = ux * (line.fromY - fromY) - uy * (line.fromX - fromX);
        double to = ux * (line.toY - fromY) - uy * (line.toX - fromX);
        return from < 0 && to > 0 || from > 0 && to < 0;
    }
}
