package io.github.circles2d.world.jvm.bodies;

import io.github.circles2d.world.bodies.OutlineShape;
import io.github.circles2d.world.model.PieceRow;
import io.github.circles2d.world.model.Rotation;
import java.util.Arrays;

/**
 * What a body senses, and what it is to others that sense it: lines and arcs, perhaps thick, around a place. In a step the place goes evenly, and
 * the shape turns evenly. Numbers are doubles, so that rounding decides nothing.
 */
final class SensedShape {
    /** A line or an arc of a {@link SensedShape}, where the shape is. An arc goes anticlockwise, by half a turn at most. */
    static final class Edge {
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
        boolean divides(Edge line) {
            double ux = toX - fromX;
            double uy = toY - fromY;
            double from = ux * (line.fromY - fromY) - uy * (line.fromX - fromX);
            double to = ux * (line.toY - fromY) - uy * (line.toX - fromX);
            return from < 0 && to > 0 || from > 0 && to < 0;
        }
    }

    Edge[] edges = {};
    int count;

    double thickness;

    /** Whether edges go around what is inside. */
    boolean isSolid;

    /** How far from its place a point is at most. */
    double reach;

    /** The place as the step begins, and its way. */
    double x;

    double y;
    double goX;
    double goY;

    /** The angle as the step begins, and by how many units it turns. */
    private int angle;

    double turn;

    /** The place at the share that has been set last. */
    double nowX;

    double nowY;

    SensedShape() {}

    /** Brings it to a place, for a step. */
    void put(double atX, double atY, double wayX, double wayY, int itsAngle, double itsTurn) {
        x = atX;
        y = atY;
        goX = wayX;
        goY = wayY;
        angle = itsAngle;
        turn = itsTurn;
    }

    void takeBody(OutlineShape outline) {
        double[] from = outline.edges();
        begin(0, true, outline.reach());
        for (int e = 0; e < from.length; e += OutlineShape.EDGE_STRIDE) {
            int next = e + OutlineShape.EDGE_STRIDE == from.length ? 0 : e + OutlineShape.EDGE_STRIDE;
            add(
                    from[e],
                    from[e + 1],
                    from[next],
                    from[next + 1],
                    from[e + OutlineShape.CENTRE_X],
                    from[e + OutlineShape.CENTRE_Y],
                    from[e + OutlineShape.EDGE_RADIUS]);
        }
    }

    void takeDisc(double radius) {
        begin(radius, false, radius);
        add(0, 0, 0, 0, 0, 0, 0);
    }

    /** A piece of terrain, around a place that is (px, py) away from the one that its row counts from. */
    void takePiece(float[] rows, int row, int shape, double px, double py) {
        double sx = rows[row + PieceRow.START_X] - px;
        double sy = rows[row + PieceRow.START_Y] - py;
        double ex = rows[row + PieceRow.END_X] - px;
        double ey = rows[row + PieceRow.END_Y] - py;
        if (PieceRow.form(shape) != PieceRow.ARC) {
            begin(rows[row + PieceRow.THICKNESS], false, Math.sqrt(Math.max(sx * sx + sy * sy, ex * ex + ey * ey)));
            add(sx, sy, ex, ey, 0, 0, 0);
            return;
        }
        double r = rows[row + PieceRow.LENGTH];
        double cx = 0 - px;
        double cy = 0 - py;
        begin(0, false, r + Math.sqrt(cx * cx + cy * cy));
        if (rows[row + PieceRow.SPREAD] == PieceRow.ALL_AROUND) {
            add(cx + r, cy, cx - r, cy, cx, cy, r);
            add(cx - r, cy, cx + r, cy, cx, cy, r);
            return;
        }
        boolean hollow = (shape & PieceRow.SOLID_OUTSIDE) != 0; // goes clockwise
        double mx = cx + r * rows[row + PieceRow.TX];
        double my = cy + r * rows[row + PieceRow.TY];
        add(hollow ? ex : sx, hollow ? ey : sy, mx, my, cx, cy, r);
        add(mx, my, hollow ? sx : ex, hollow ? sy : ey, cx, cy, r);
    }

    private void begin(double thick, boolean solid, double far) {
        count = 0;
        thickness = thick;
        isSolid = solid;
        reach = far;
    }

    private void add(
            double fromX, double fromY, double toX, double toY, double centreX, double centreY, double radius) {
        if (count == edges.length) {
            Edge[] more = Arrays.copyOf(edges, Math.max(8, 2 * count));
            for (int k = count; k < more.length; k++) {
                more[k] = new Edge();
            }
            edges = more;
        }
        edges[count++].set(fromX, fromY, toX, toY, centreX, centreY, radius);
    }

    /** Brings it to where it is after a share of the step. */
    void setShare(double share) {
        int now = angle + (int) Rotation.nearest(share * turn);
        double cos = Rotation.cos(now);
        double sin = Rotation.sin(now);
        nowX = x + share * goX;
        nowY = y + share * goY;
        for (int k = 0; k < count; k++) {
            edges[k].put(nowX, nowY, cos, sin);
        }
    }

    /** Whether the edges go around a point: around it go the polygon of their ends, and the segments between arcs and chords. */
    boolean contains(double px, double py) {
        int around = 0;
        for (int k = 0; isSolid && k < count; k++) {
            Edge e = edges[k];
            double fromX = e.fromX - px;
            double fromY = e.fromY - py;
            double toX = e.toX - px;
            double toY = e.toY - py;
            double side = fromX * toY - fromY * toX;
            if (fromY <= 0 && toY > 0 && side > 0) {
                around++;
            } else if (toY <= 0 && fromY > 0 && side < 0) {
                around--;
            }
            if (e.isArc() && side <= 0) {
                double dx = px - e.centreX;
                double dy = py - e.centreY;
                around += dx * dx + dy * dy <= e.radius * e.radius ? 1 : 0;
            }
        }
        return around > 0;
    }

    long bytes() {
        return 132L * edges.length;
    }
}
