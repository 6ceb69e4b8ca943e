package io.github.circles2d.world.jvm.bodies;

import static io.github.circles2d.world.jvm.bodies.SensedShape.CENTRE_X;
import static io.github.circles2d.world.jvm.bodies.SensedShape.CENTRE_Y;
import static io.github.circles2d.world.jvm.bodies.SensedShape.FROM_X;
import static io.github.circles2d.world.jvm.bodies.SensedShape.FROM_Y;
import static io.github.circles2d.world.jvm.bodies.SensedShape.HALF;
import static io.github.circles2d.world.jvm.bodies.SensedShape.RADIUS;
import static io.github.circles2d.world.jvm.bodies.SensedShape.STRIDE;
import static io.github.circles2d.world.jvm.bodies.SensedShape.TO_X;
import static io.github.circles2d.world.jvm.bodies.SensedShape.TO_Y;

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
        isApart = !b.contains(a.edges[FROM_X], a.edges[FROM_Y]) && !a.contains(b.edges[FROM_X], b.edges[FROM_Y]);
        for (int e = 0; isApart && e < a.end; e += STRIDE) {
            for (int f = 0; isApart && f < b.end; f += STRIDE) {
                measure(e, f);
            }
        }
        return isApart ? least - (a.thickness + b.thickness) : 0;
    }

    private void measure(int e, int f) {
        if (isFarther(e, f)) {
            return;
        }
        if (cross(e, f)) {
            isApart = false;
            return;
        }
        offerA(a.edges[e + FROM_X], a.edges[e + FROM_Y], f);
        offerA(a.edges[e + TO_X], a.edges[e + TO_Y], f);
        offerB(b.edges[f + FROM_X], b.edges[f + FROM_Y], e);
        offerB(b.edges[f + TO_X], b.edges[f + TO_Y], e);
        boolean isArc = a.edges[e + RADIUS] > 0;
        boolean isArcToo = b.edges[f + RADIUS] > 0;
        if (isArcToo) {
            near(b.edges[f + CENTRE_X], b.edges[f + CENTRE_Y], a, e);
            offerA(x, y, f);
        }
        if (isArc) {
            near(a.edges[e + CENTRE_X], a.edges[e + CENTRE_Y], b, f);
            offerB(x, y, e);
        }
        if (isArc && isArcToo) {
            offerFarSides(e, f);
        }
    }

    /** Whether two edges are surely farther apart than the nearest ones so far. */
    private boolean isFarther(int e, int f) {
        double[] p = a.edges;
        double[] q = b.edges;
        double dx = 0.5 * ((p[e + FROM_X] + p[e + TO_X]) - (q[f + FROM_X] + q[f + TO_X]));
        double dy = 0.5 * ((p[e + FROM_Y] + p[e + TO_Y]) - (q[f + FROM_Y] + q[f + TO_Y]));
        double far = least + (p[e + HALF] + q[f + HALF]);
        return dx * dx + dy * dy >= far * far;
    }

    /** Of arcs of which one is in the circle of the other: the points that the other's centre is farthest from. */
    private void offerFarSides(int e, int f) {
        double dx = a.edges[e + CENTRE_X] - b.edges[f + CENTRE_X];
        double dy = a.edges[e + CENTRE_Y] - b.edges[f + CENTRE_Y];
        double d = length(dx, dy);
        if (d > 0 && a.opens(e, dx, dy)) {
            double r = a.edges[e + RADIUS] / d;
            offerA(a.edges[e + CENTRE_X] + r * dx, a.edges[e + CENTRE_Y] + r * dy, f);
        }
        if (d > 0 && b.opens(f, -dx, -dy)) {
            double r = b.edges[f + RADIUS] / d;
            offerB(b.edges[f + CENTRE_X] - r * dx, b.edges[f + CENTRE_Y] - r * dy, e);
        }
    }

    /** A point of the first shape, and an edge of the second one. */
    private void offerA(double px, double py, int f) {
        near(px, py, b, f);
        offer(px, py, x, y);
    }

    private void offerB(double px, double py, int e) {
        near(px, py, a, e);
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
    private void near(double px, double py, SensedShape of, int e) {
        double[] edges = of.edges;
        double fromX = edges[e + FROM_X];
        double fromY = edges[e + FROM_Y];
        double toX = edges[e + TO_X];
        double toY = edges[e + TO_Y];
        double radius = edges[e + RADIUS];
        if (radius > 0) {
            double dx = px - edges[e + CENTRE_X];
            double dy = py - edges[e + CENTRE_Y];
            double d = length(dx, dy);
            if (d > 0 && of.opens(e, dx, dy)) {
                x = edges[e + CENTRE_X] + dx * (radius / d);
                y = edges[e + CENTRE_Y] + dy * (radius / d);
            } else {
                boolean first = length(px - fromX, py - fromY) <= length(px - toX, py - toY);
                x = first ? fromX : toX;
                y = first ? fromY : toY;
            }
            return;
        }
        double ux = toX - fromX;
        double uy = toY - fromY;
        double square = ux * ux + uy * uy;
        double along = square > 0 ? ((px - fromX) * ux + (py - fromY) * uy) / square : 0;
        double share = Math.min(Math.max(along, 0), 1);
        x = fromX + share * ux;
        y = fromY + share * uy;
    }

    /** The point of the second shape that is nearest to the place of the first one becomes that of both that is nearest. */
    void nearToPlace() {
        least = Double.POSITIVE_INFINITY;
        for (int f = 0; f < b.end; f += STRIDE) {
            offerA(a.nowX, a.nowY, f);
        }
    }

    // ---- crossings

    private boolean cross(int e, int f) {
        boolean isArc = a.edges[e + RADIUS] > 0;
        boolean isArcToo = b.edges[f + RADIUS] > 0;
        if (isArc && isArcToo) {
            return arcsCross(e, f);
        }
        return isArc ? lineCrossesArc(b, f, a, e) : isArcToo ? lineCrossesArc(a, e, b, f) : linesCross(e, f);
    }

    private boolean linesCross(int e, int f) {
        double[] p = a.edges;
        double[] q = b.edges;
        return areDivided(p, e, q, f) && areDivided(q, f, p, e);
    }

    /** Whether the ends of a line are on different sides of another one. */
    private static boolean areDivided(double[] p, int e, double[] q, int f) {
        double ux = q[f + TO_X] - q[f + FROM_X];
        double uy = q[f + TO_Y] - q[f + FROM_Y];
        double from = ux * (p[e + FROM_Y] - q[f + FROM_Y]) - uy * (p[e + FROM_X] - q[f + FROM_X]);
        double to = ux * (p[e + TO_Y] - q[f + FROM_Y]) - uy * (p[e + TO_X] - q[f + FROM_X]);
        return from < 0 && to > 0 || from > 0 && to < 0;
    }

    private static boolean lineCrossesArc(SensedShape ofLine, int line, SensedShape ofArc, int arc) {
        double[] p = ofLine.edges;
        double[] q = ofArc.edges;
        double ux = p[line + TO_X] - p[line + FROM_X];
        double uy = p[line + TO_Y] - p[line + FROM_Y];
        double ox = p[line + FROM_X] - q[arc + CENTRE_X];
        double oy = p[line + FROM_Y] - q[arc + CENTRE_Y];
        double square = ux * ux + uy * uy;
        double half = ox * ux + oy * uy;
        double disc = half * half - square * (ox * ox + oy * oy - q[arc + RADIUS] * q[arc + RADIUS]);
        if (!(disc >= 0) || !(square > 0)) {
            return false;
        }
        double root = Math.sqrt(disc);
        double one = (-half - root) / square;
        double two = (root - half) / square;
        return one >= 0 && one <= 1 && ofArc.opens(arc, ox + one * ux, oy + one * uy)
                || two >= 0 && two <= 1 && ofArc.opens(arc, ox + two * ux, oy + two * uy);
    }

    private boolean arcsCross(int e, int f) {
        double r = a.edges[e + RADIUS];
        double other = b.edges[f + RADIUS];
        double dx = b.edges[f + CENTRE_X] - a.edges[e + CENTRE_X];
        double dy = b.edges[f + CENTRE_Y] - a.edges[e + CENTRE_Y];
        double d = length(dx, dy);
        if (!(d > 0) || d > r + other || d < Math.abs(r - other)) {
            return false;
        }
        double ux = dx / d;
        double uy = dy / d;
        double along = (d * d + r * r - other * other) / (2 * d);
        double across = Math.sqrt(Math.max(r * r - along * along, 0));
        return arcsCrossAt(e, f, along * ux - across * uy, along * uy + across * ux, dx, dy)
                || arcsCrossAt(e, f, along * ux + across * uy, along * uy - across * ux, dx, dy);
    }

    private boolean arcsCrossAt(int e, int f, double px, double py, double dx, double dy) {
        return a.opens(e, px, py) && b.opens(f, px - dx, py - dy);
    }

    private static double length(double dx, double dy) {
        return Math.sqrt(dx * dx + dy * dy);
    }
}
