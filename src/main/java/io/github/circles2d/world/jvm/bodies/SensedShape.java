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
    // the numbers of an edge; an arc goes anticlockwise, by half a turn at most
    static final int FROM_X = 0;
    static final int FROM_Y = 1;
    static final int TO_X = 2;
    static final int TO_Y = 3;
    static final int CENTRE_X = 4;
    static final int CENTRE_Y = 5;

    /** 0 of a line. */
    static final int RADIUS = 6;

    /** Half of the chord: an edge lies in the circle over that. */
    static final int HALF = 7;

    static final int STRIDE = 8;

    /** As it lies unturned, around its place. */
    private double[] own = new double[8 * STRIDE];

    /** Edges at the share of the step that has been set last. */
    double[] edges = new double[8 * STRIDE];

    /** Numbers of all edges. */
    int end;

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
        end = 0;
        thickness = thick;
        isSolid = solid;
        reach = far;
    }

    private void add(
            double fromX, double fromY, double toX, double toY, double centreX, double centreY, double radius) {
        if (end == own.length) {
            own = Arrays.copyOf(own, 2 * end);
            edges = new double[2 * end];
        }
        own[end + FROM_X] = fromX;
        own[end + FROM_Y] = fromY;
        own[end + TO_X] = toX;
        own[end + TO_Y] = toY;
        own[end + CENTRE_X] = centreX;
        own[end + CENTRE_Y] = centreY;
        own[end + RADIUS] = radius;
        own[end + HALF] = 0.5 * Math.sqrt((toX - fromX) * (toX - fromX) + (toY - fromY) * (toY - fromY));
        end += STRIDE;
    }

    /** Brings it to where it is after a share of the step. */
    void setShare(double share) {
        int now = angle + (int) Rotation.nearest(share * turn);
        double cos = Rotation.cos(now);
        double sin = Rotation.sin(now);
        nowX = x + share * goX;
        nowY = y + share * goY;
        for (int e = 0; e < end; e += STRIDE) {
            for (int p = e; p < e + RADIUS; p += 2) {
                edges[p] = nowX + (cos * own[p] - sin * own[p + 1]);
                edges[p + 1] = nowY + (sin * own[p] + cos * own[p + 1]);
            }
            edges[e + RADIUS] = own[e + RADIUS];
            edges[e + HALF] = own[e + HALF];
        }
    }

    /** Whether the edges go around a point: around it go the polygon of their ends, and the segments between arcs and chords. */
    boolean contains(double px, double py) {
        int around = 0;
        for (int e = 0; isSolid && e < end; e += STRIDE) {
            double fromX = edges[e + FROM_X] - px;
            double fromY = edges[e + FROM_Y] - py;
            double toX = edges[e + TO_X] - px;
            double toY = edges[e + TO_Y] - py;
            double side = fromX * toY - fromY * toX;
            if (fromY <= 0 && toY > 0 && side > 0) {
                around++;
            } else if (toY <= 0 && fromY > 0 && side < 0) {
                around--;
            }
            double radius = edges[e + RADIUS];
            if (radius > 0 && side <= 0) {
                double dx = px - edges[e + CENTRE_X];
                double dy = py - edges[e + CENTRE_Y];
                around += dx * dx + dy * dy <= radius * radius ? 1 : 0;
            }
        }
        return around > 0;
    }

    /** Whether a direction from the centre of an arc is in its opening. */
    boolean opens(int e, double dx, double dy) {
        double fromX = edges[e + FROM_X] - edges[e + CENTRE_X];
        double fromY = edges[e + FROM_Y] - edges[e + CENTRE_Y];
        double toX = edges[e + TO_X] - edges[e + CENTRE_X];
        double toY = edges[e + TO_Y] - edges[e + CENTRE_Y];
        return fromX * dy - fromY * dx >= 0 && dx * toY - dy * toX >= 0;
    }

    long bytes() {
        return 16L * own.length;
    }
}
