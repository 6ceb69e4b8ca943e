package io.github.circles2d;

import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;

/** The bodies of a world as polygons of many points, and what queries are to find of them, by a look at each. */
final class SolidBodies {
    /** How far the polygons may be from the outlines. */
    static final float TOLERANCE = 5e-5f;

    /** What a walk along a path does not find, or finds too close to tell. */
    static final double NONE = Double.POSITIVE_INFINITY;

    private static final double CLEAR = 1e-3;

    /** A body, or its image beyond a seam. */
    record Solid(long handle, int category, double x, double y, double reach, double[] points) {
        /** The distance of the outline from a disc, negative inside; for discs far away less than that. */
        private double gap(double px, double py, double radius) {
            double far = farAway(px, py) - radius;
            return far > 0.5 ? far : distance(px, py) - radius;
        }

        /** No point of it is nearer. */
        double farAway(double px, double py) {
            return Math.hypot(px - x, py - y) - reach;
        }

        double distance(double px, double py) {
            double least = NONE;
            boolean inside = false;
            int n = points.length;
            for (int k = 0; k < n; k += 2) {
                double ax = points[k];
                double ay = points[k + 1];
                double bx = points[(k + 2) % n];
                double by = points[(k + 3) % n];
                least = Math.min(least, Line2D.ptSegDistSq(ax, ay, bx, by, px, py));
                if (ay > py != by > py && px < ax + (py - ay) / (by - ay) * (bx - ax)) {
                    inside = !inside;
                }
            }
            return inside ? -Math.sqrt(least) : Math.sqrt(least);
        }

        /** Whether it overlaps a box: true, false, or null if that is too close to tell. */
        Boolean meets(double minX, double minY, double maxX, double maxY) {
            int larger = meetsExactly(minX - CLEAR, minY - CLEAR, maxX + CLEAR, maxY + CLEAR) ? 1 : 0;
            boolean less = maxX - minX > 2 * CLEAR
                    && maxY - minY > 2 * CLEAR
                    && meetsExactly(minX + CLEAR, minY + CLEAR, maxX - CLEAR, maxY - CLEAR);
            return less ? Boolean.TRUE : larger == 0 ? Boolean.FALSE : null;
        }

        private boolean meetsExactly(double minX, double minY, double maxX, double maxY) {
            if (distance(minX, minY) <= 0) {
                return true;
            }
            Rectangle2D box = new Rectangle2D.Double(minX, minY, maxX - minX, maxY - minY);
            int n = points.length;
            for (int k = 0; k < n; k += 2) {
                if (box.intersectsLine(points[k], points[k + 1], points[(k + 2) % n], points[(k + 3) % n])) {
                    return true;
                }
            }
            return false;
        }

        /**
         * How far a disc of a radius comes along a unit vector until it touches the body, by steps that are no longer than it is far away; {@link
         * #NONE} if it does not within the length, NaN if it grazes the body or ends close to it.
         */
        double walk(double px, double py, double radius, double ux, double uy, double length) {
            if (Line2D.ptSegDist(px, py, px + length * ux, py + length * uy, x, y) > reach + radius + CLEAR) {
                return NONE;
            }
            double t = 0;
            double least = NONE;
            while (t <= length) {
                double d = gap(px + t * ux, py + t * uy, radius);
                least = Math.min(least, d);
                if (d <= 2 * TOLERANCE) {
                    boolean deepens = gap(px + (t + CLEAR) * ux, py + (t + CLEAR) * uy, radius) < -0.1 * CLEAR;
                    boolean clearly = t == 0 ? d < -2 * TOLERANCE : deepens && length - t > CLEAR;
                    return clearly ? t : Double.NaN;
                }
                t += d;
            }
            double atEnd = gap(px + length * ux, py + length * uy, radius);
            return least < CLEAR || atEnd < CLEAR ? Double.NaN : NONE;
        }
    }

    final List<Solid> solids = new ArrayList<>();

    /** Images: how many periods to each side there are any. */
    SolidBodies(World world, double periodX, double periodY) {
        Bodies bodies = world.bodies();
        for (int id = 0; id < bodies.idLimit(); id++) {
            long body = bodies.handle(id);
            if (body != 0) {
                for (int i = periodX > 0 ? -1 : 0; i <= (periodX > 0 ? 1 : 0); i++) {
                    for (int j = periodY > 0 ? -1 : 0; j <= (periodY > 0 ? 1 : 0); j++) {
                        add(world, body, i * periodX, j * periodY);
                    }
                }
            }
        }
    }

    private void add(World world, long body, double byX, double byY) {
        Bodies bodies = world.bodies();
        float[] outline = bodies.outline(body).points(TOLERANCE);
        double[] points = new double[outline.length];
        double cos = Math.cos(bodies.angle(body));
        double sin = Math.sin(bodies.angle(body));
        double x = bodies.x(body) + byX;
        double y = bodies.y(body) + byY;
        double reach = 0;
        for (int k = 0; k < points.length; k += 2) {
            points[k] = x + cos * outline[k] - sin * outline[k + 1];
            points[k + 1] = y + sin * outline[k] + cos * outline[k + 1];
            reach = Math.max(reach, Math.hypot(outline[k], outline[k + 1]));
        }
        solids.add(new Solid(body, world.kind(bodies.kindOf(body)).category(), x, y, reach + TOLERANCE, points));
    }
}
