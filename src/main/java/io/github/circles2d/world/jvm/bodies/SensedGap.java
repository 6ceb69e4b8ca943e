package io.github.circles2d.world.jvm.bodies;

import io.github.circles2d.world.model.Rotation;

/** How far two shapes are apart, and when in a step they come together. */
final class SensedGap {
    /** A pair of points is nearer than another one only by more than this share of a length. */
    private static final double SAME = 1e-10;

    /** How often the search for the time looks at most. */
    private static final int LOOKS = 32;

    /** Parts of a step, by whole ones of which the search goes on: so no rounding grows from look to look. */
    private static final double PARTS = 1 << 24;

    private SensedShape a;
    private SensedShape b;
    private double same;

    /** Whether neither crosses the other, nor has it inside. */
    boolean isApart;

    /** How far the edges are apart, without their thickness, and the points of both that are nearest. */
    double least;

    double ax;
    double ay;
    double bx;
    double by;

    // the point of an edge that was nearest to the last one
    private double x;
    private double y;

    SensedGap() {}

    /**
     * Whether two shapes come so near to each other in a step; they are left where they first do. No point comes faster than both places and
     * turns together, so that they may go on by the gap each time.
     *
     * @param length by which lengths are measured
     */
    boolean findTouch(SensedShape first, SensedShape second, double tolerance, double length) {
        double ways = length(first.goX - second.goX, first.goY - second.goY) + turned(first) + turned(second);
        double share = 0;
        for (int look = 0; look < LOOKS; look++) {
            first.setShare(share);
            second.setShare(share);
            double gap = measure(first, second, length);
            if (gap <= tolerance) {
                return true;
            }
            share += Math.max(Math.floor((gap - 0.5 * tolerance) / ways * PARTS), 1) / PARTS;
            if (!(share <= 1)) {
                return false;
            }
        }
        return false;
    }

    /** How far a point comes at most by turning. */
    private static double turned(SensedShape of) {
        return of.turn == 0 ? 0 : Math.abs(of.turn) * Rotation.RADIANS_PER_UNIT * of.reach;
    }

    /** The gap of two shapes where they are; 0 if they are not apart. */
    double measure(SensedShape first, SensedShape second, double length) {
        a = first;
        b = second;
        same = SAME * length;
        least = Double.POSITIVE_INFINITY;
        isApart = !b.contains(a.edges[0].fromX, a.edges[0].fromY) && !a.contains(b.edges[0].fromX, b.edges[0].fromY);
        for (int m = 0; isApart && m < a.count; m++) {
            for (int n = 0; isApart && n < b.count; n++) {
                measure(a.edges[m], b.edges[n]);
            }
        }
        return isApart ? least - (a.thickness + b.thickness) : 0;
    }

    private void measure(SensedShape.Edge e, SensedShape.Edge f) {
        if (isFarther(e, f)) {
            return;
        }
        if (cross(e, f)) {
            isApart = false;
            return;
        }
        offerA(e.fromX, e.fromY, f);
        offerA(e.toX, e.toY, f);
        offerB(f.fromX, f.fromY, e);
        offerB(f.toX, f.toY, e);
        if (f.isArc()) {
            near(f.centreX, f.centreY, e);
            offerA(x, y, f);
        }
        if (e.isArc()) {
            near(e.centreX, e.centreY, f);
            offerB(x, y, e);
        }
        if (e.isArc() && f.isArc()) {
            offerFarSides(e, f);
        }
    }

    /** Whether two edges are surely farther apart than the nearest ones so far. */
    private boolean isFarther(SensedShape.Edge e, SensedShape.Edge f) {
        double dx = 0.5 * ((e.fromX + e.toX) - (f.fromX + f.toX));
        double dy = 0.5 * ((e.fromY + e.toY) - (f.fromY + f.toY));
        double far = least + (e.half + f.half);
        return dx * dx + dy * dy >= far * far;
    }

    /** Of arcs of which one is in the circle of the other: the points that the other's centre is farthest from. */
    private void offerFarSides(SensedShape.Edge e, SensedShape.Edge f) {
        double dx = e.centreX - f.centreX;
        double dy = e.centreY - f.centreY;
        double d = length(dx, dy);
        if (d > 0 && e.opens(dx, dy)) {
            double r = e.radius / d;
            offerA(e.centreX + r * dx, e.centreY + r * dy, f);
        }
        if (d > 0 && f.opens(-dx, -dy)) {
            double r = f.radius / d;
            offerB(f.centreX - r * dx, f.centreY - r * dy, e);
        }
    }

    /** A point of the first shape, and an edge of the second one. */
    private void offerA(double px, double py, SensedShape.Edge f) {
        near(px, py, f);
        offer(px, py, x, y);
    }

    private void offerB(double px, double py, SensedShape.Edge e) {
        near(px, py, e);
        offer(x, y, px, py);
    }

    private void offer(double fromX, double fromY, double toX, double toY) {
        double d = length(toX - fromX, toY - fromY);
        if (d < least - same) {
            least = d;
            ax = fromX;
            ay = fromY;
            bx = toX;
            by = toY;
        }
    }

    /** Finds the point of an edge that is nearest to another one. */
    private void near(double px, double py, SensedShape.Edge e) {
        if (e.isArc()) {
            double dx = px - e.centreX;
            double dy = py - e.centreY;
            double d = length(dx, dy);
            if (d > 0 && e.opens(dx, dy)) {
                x = e.centreX + dx * (e.radius / d);
                y = e.centreY + dy * (e.radius / d);
            } else {
                boolean first = length(px - e.fromX, py - e.fromY) <= length(px - e.toX, py - e.toY);
                x = first ? e.fromX : e.toX;
                y = first ? e.fromY : e.toY;
            }
            return;
        }
        double ux = e.toX - e.fromX;
        double uy = e.toY - e.fromY;
        double square = ux * ux + uy * uy;
        double along = square > 0 ? ((px - e.fromX) * ux + (py - e.fromY) * uy) / square : 0;
        double share = Math.min(Math.max(along, 0), 1);
        x = e.fromX + share * ux;
        y = e.fromY + share * uy;
    }

    /** The point of the second shape that is nearest to the place of the first one becomes that of both that is nearest. */
    void nearToPlace() {
        least = Double.POSITIVE_INFINITY;
        for (int n = 0; n < b.count; n++) {
            offerA(a.nowX, a.nowY, b.edges[n]);
        }
    }

    // ---- crossings

    private static boolean cross(SensedShape.Edge e, SensedShape.Edge f) {
        if (e.isArc() && f.isArc()) {
            return arcsCross(e, f);
        }
        return e.isArc() ? lineCrossesArc(f, e) : f.isArc() ? lineCrossesArc(e, f) : f.divides(e) && e.divides(f);
    }

    private static boolean lineCrossesArc(SensedShape.Edge line, SensedShape.Edge arc) {
        double ux = line.toX - line.fromX;
        double uy = line.toY - line.fromY;
        double ox = line.fromX - arc.centreX;
        double oy = line.fromY - arc.centreY;
        double square = ux * ux + uy * uy;
        double half = ox * ux + oy * uy;
        double disc = half * half - square * (ox * ox + oy * oy - arc.radius * arc.radius);
        if (!(disc >= 0) || !(square > 0)) {
            return false;
        }
        double root = Math.sqrt(disc);
        double one = (-half - root) / square;
        double two = (root - half) / square;
        return one >= 0 && one <= 1 && arc.opens(ox + one * ux, oy + one * uy)
                || two >= 0 && two <= 1 && arc.opens(ox + two * ux, oy + two * uy);
    }

    private static boolean arcsCross(SensedShape.Edge e, SensedShape.Edge f) {
        double dx = f.centreX - e.centreX;
        double dy = f.centreY - e.centreY;
        double d = length(dx, dy);
        if (!(d > 0) || d > e.radius + f.radius || d < Math.abs(e.radius - f.radius)) {
            return false;
        }
        double ux = dx / d;
        double uy = dy / d;
        double along = (d * d + e.radius * e.radius - f.radius * f.radius) / (2 * d);
        double across = Math.sqrt(Math.max(e.radius * e.radius - along * along, 0));
        return arcsCrossAt(e, f, along * ux - across * uy, along * uy + across * ux, dx, dy)
                || arcsCrossAt(e, f, along * ux + across * uy, along * uy - across * ux, dx, dy);
    }

    private static boolean arcsCrossAt(
            SensedShape.Edge e, SensedShape.Edge f, double px, double py, double dx, double dy) {
        return e.opens(px, py) && f.opens(px - dx, py - dy);
    }

    static double length(double dx, double dy) {
        return Math.sqrt(dx * dx + dy * dy);
    }
}
