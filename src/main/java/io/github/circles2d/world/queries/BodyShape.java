package io.github.circles2d.world.queries;

import io.github.circles2d.world.bodies.OutlineShape;
import io.github.circles2d.world.model.Rotation;

/**
 * A body that is pushed, and the exact tests that decide what a search finds. Its surface is the outline, the rounded corners as arcs; all that the
 * outline goes around is inside. Points are turned to how the outline lies, boxes are met by the outline as it is turned.
 */
final class BodyShape extends ThingShape {
    /** More than what tests lose by rounding, by its share of coordinates: a path meets an edge so far beyond its ends. */
    private static final double JOINT = 0x1p-44;

    /** The same by which a point that a path comes to may be off the surface. */
    private static final double SURFACE = 0x1p-32;

    private final PieceShape edge = new PieceShape();
    private double[] edges;
    private double reach;

    // where the centroid is, and the angle
    private double x;
    private double y;
    private double cos;
    private double sin;

    // the last point, as the outline lies, how far the outline is from it, on which edge, and whether it is inside
    private double localX;
    private double localY;
    private double gap;
    private int nearest;
    private boolean isInside;

    BodyShape() {}

    /** Takes a body at a place. */
    void take(OutlineShape outline, double atX, double atY, int angle) {
        edges = outline.edges();
        reach = outline.reach();
        x = atX;
        y = atY;
        cos = Rotation.cos(angle);
        sin = Rotation.sin(angle);
    }

    /** Takes an edge, which begins at an element, as the outline lies. */
    private void takeEdge(int e, double slack) {
        int next = next(e);
        edge.take(
                edges[e + OutlineShape.CENTRE_X],
                edges[e + OutlineShape.CENTRE_Y],
                edges[e + OutlineShape.EDGE_RADIUS],
                edges[e],
                edges[e + 1],
                edges[next],
                edges[next + 1],
                slack);
    }

    private int next(int e) {
        return e + OutlineShape.EDGE_STRIDE == edges.length ? 0 : e + OutlineShape.EDGE_STRIDE;
    }

    private double worldX(double lx, double ly) {
        return cos * lx - sin * ly;
    }

    private double worldY(double lx, double ly) {
        return sin * lx + cos * ly;
    }

    private void turn(double px, double py) {
        double dx = px - x;
        double dy = py - y;
        localX = cos * dx + sin * dy;
        localY = cos * dy - sin * dx;
    }

    /**
     * Whether the outline goes around the point: around it go the polygon of the ends of the edges, and the segments between arcs and their
     * chords. Both take the side of a chord from one product, so that no point lies between them.
     */
    private boolean contains(double px, double py) {
        int around = 0;
        for (int e = 0; e < edges.length; e += OutlineShape.EDGE_STRIDE) {
            int next = next(e);
            double side =
                    (edges[next] - edges[e]) * (py - edges[e + 1]) - (edges[next + 1] - edges[e + 1]) * (px - edges[e]);
            boolean starts = edges[e + 1] <= py;
            boolean ends = edges[next + 1] <= py;
            if (starts && !ends && side > 0) {
                around++;
            } else if (ends && !starts && side < 0) {
                around--;
            }
            double radius = edges[e + OutlineShape.EDGE_RADIUS];
            if (radius > 0 && side <= 0) {
                double dx = px - edges[e + OutlineShape.CENTRE_X];
                double dy = py - edges[e + OutlineShape.CENTRE_Y];
                around += dx * dx + dy * dy <= radius * radius ? 1 : 0;
            }
        }
        return around > 0;
    }

    // ---- overlaps
    // ----------------------------------------------------------------------------------------------------

    @Override
    boolean overlapsDisc(double px, double py, double radius) {
        turn(px, py);
        return overlapsDisc(radius);
    }

    private boolean overlapsDisc(double radius) {
        if (contains(localX, localY)) {
            return true;
        }
        for (int e = 0; e < edges.length; e += OutlineShape.EDGE_STRIDE) {
            takeEdge(e, 0);
            if (edge.overlapsDisc(localX, localY, radius)) {
                return true;
            }
        }
        return false;
    }

    @Override
    boolean overlapsBox(double minX, double minY, double maxX, double maxY) {
        turn(minX, minY);
        if (contains(localX, localY)) {
            return true;
        }
        for (int e = 0; e < edges.length; e += OutlineShape.EDGE_STRIDE) {
            int next = next(e);
            double cx = edges[e + OutlineShape.CENTRE_X];
            double cy = edges[e + OutlineShape.CENTRE_Y];
            edge.take(
                    worldX(cx, cy),
                    worldY(cx, cy),
                    edges[e + OutlineShape.EDGE_RADIUS],
                    worldX(edges[e], edges[e + 1]),
                    worldY(edges[e], edges[e + 1]),
                    worldX(edges[next], edges[next + 1]),
                    worldY(edges[next], edges[next + 1]),
                    0);
            if (edge.overlapsBox(minX - x, minY - y, maxX - x, maxY - y)) {
                return true;
            }
        }
        return false;
    }

    // ---- the nearest
    // -------------------------------------------------------------------------------------------------

    @Override
    double distance(double px, double py) {
        findNearest(px, py, 0, 0, 0);
        return isInside ? -1 * gap : gap;
    }

    /** Of edges that are as near but for a slack the one that faces the direction most. */
    private void findNearest(double px, double py, double slack, double ux, double uy) {
        turn(px, py);
        isInside = contains(localX, localY);
        gap = Double.POSITIVE_INFINITY;
        for (int e = 0; e < edges.length; e += OutlineShape.EDGE_STRIDE) {
            takeEdge(e, 0);
            double d = edge.distance(localX, localY);
            if (d < gap) {
                gap = d;
                nearest = e;
            }
        }
        double along = Double.POSITIVE_INFINITY;
        for (int e = 0; slack > 0 && gap <= slack && e < edges.length; e += OutlineShape.EDGE_STRIDE) {
            takeEdge(e, 0);
            if (edge.distance(localX, localY) <= slack) {
                double faces = worldX(edge.faceX(), edge.faceY()) * ux + worldY(edge.faceX(), edge.faceY()) * uy;
                if (faces < along) {
                    along = faces;
                    nearest = e;
                }
            }
        }
    }

    // ---- casts
    // -------------------------------------------------------------------------------------------------------

    @Override
    double castDistance(double px, double py, double radius, double ux, double uy, double most) {
        turn(px, py);
        if (overlapsDisc(radius)) {
            return 0;
        }
        double alongX = cos * ux + sin * uy;
        double alongY = cos * uy - sin * ux;
        double slack = (reach + Math.abs(localX) + Math.abs(localY)) * JOINT;
        double first = Double.POSITIVE_INFINITY;
        for (int e = 0; e < edges.length; e += OutlineShape.EDGE_STRIDE) {
            takeEdge(e, slack);
            double d = edge.castDistance(localX, localY, radius, alongX, alongY, most);
            if (d != CircleTests.NONE && d < first) {
                first = d;
            }
        }
        return first < Double.POSITIVE_INFINITY ? first : CircleTests.NONE;
    }

    // ---- normals
    // -----------------------------------------------------------------------------------------------------

    /** The normal leads out of the body. */
    @Override
    void normalAt(double px, double py, double radius, double ux, double uy) {
        double slack = (reach + Math.abs(px - x) + Math.abs(py - y)) * SURFACE;
        findNearest(px, py, slack, ux, uy);
        takeEdge(nearest, 0);
        edge.normalFrom(localX, localY);
        double nearX = edge.nearestX();
        double nearY = edge.nearestY();
        double nx = edge.faceX();
        double ny = edge.faceY();
        if (gap > slack) {
            double out = isInside ? -1 / gap : 1 / gap;
            nx = out * (localX - nearX);
            ny = out * (localY - nearY);
        }
        normalX = worldX(nx, ny) + 0.0; // no negative zeros
        normalY = worldY(nx, ny) + 0.0;
        surfaceX = x + worldX(nearX, nearY);
        surfaceY = y + worldY(nearX, nearY);
    }

    @Override
    void normalFrom(double px, double py) {
        normalAt(px, py, 0, 0, 0);
    }
}
