package io.github.circles2d.world.terrain;

import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.PieceRow;
import io.github.circles2d.world.model.Rotation;

/** Fills the rows of pieces: where they are if their body has a pose. */
final class PieceRows {
    /** Above the rounding of a distance. */
    private static final double MARGIN = 1 + 0x1p-20;

    /** Above the rounding of the cosine of an opening. */
    private static final double SPREAD_MARGIN = 1e-6;

    private final PieceTable pieces;

    /** The unit direction in which a piece leaves its start, or comes to its end, in the frame of its body. */
    double tangentX;

    double tangentY;

    // the pose
    private double pivotX;
    private double pivotY;
    private double cos = 1;
    private double sin;

    private Bounds bounds;

    // ends of an arc against its centre, and its box
    private double leastX;
    private double leastY;
    private double greatestX;
    private double greatestY;

    PieceRows(PieceTable pieces) {
        this.pieces = pieces;
    }

    /** Where axes that wrap begin and end. */
    void setBounds(Bounds to) {
        bounds = to;
    }

    void setPose(BodyTable bodies, int body) {
        setPose(bodies.x[body], bodies.y[body], bodies.angle[body]);
    }

    void setPose(double x, double y, int angle) {
        pivotX = x;
        pivotY = y;
        cos = Rotation.cos(angle);
        sin = Rotation.sin(angle);
    }

    /** Fills the row of a piece that does not move in the step, in the pose that was set; marks it as changed. */
    void fill(int piece) {
        fill(piece, 0, 0, 0);
    }

    /** row: of its body. way: how far the pivot goes in the step; turn: how far the body turns, in radians. */
    void fill(int piece, int row, double way, double turn) {
        int at = PieceRow.of(piece);
        float[] rows = pieces.rows;
        write(piece, rows, at);
        tangentOfNext(piece);
        rows[at + PieceRow.NEXT_X] = (float) (cos * tangentX - sin * tangentY);
        rows[at + PieceRow.NEXT_Y] = (float) (sin * tangentX + cos * tangentY);
        // a point at a distance d from the pivot comes no farther than 2 d from where it was
        rows[at + PieceRow.MOST] = row == 0 ? 0f : (float) ((way + farthest(piece) * Math.min(turn, 2)) * MARGIN);
        pieces.traits[PieceRow.traits(piece) + PieceRow.MOTION] = row;
        pieces.changed(piece);
    }

    /** Writes what a row has of the form of a piece, and of the pose. */
    void write(int piece, float[] rows, int at) {
        if (pieces.isArc(piece)) {
            writeArc(piece, rows, at);
        } else {
            writeLine(piece, rows, at);
        }
    }

    private void tangentOfNext(int piece) {
        int next = pieces.after[piece];
        if (next >= 0) {
            takeTangent(next, -1);
        } else {
            tangentX = 0;
            tangentY = 0;
        }
    }

    /** Works out the tangent of a piece at its start, -1, or at its end, 1. */
    void takeTangent(int piece, int end) {
        int at = PieceTable.FORM * piece;
        float[] form = pieces.form;
        if (!pieces.isArc(piece)) {
            double dx = (double) form[at + PieceTable.X2] - form[at + PieceTable.X];
            double dy = (double) form[at + PieceTable.Y2] - form[at + PieceTable.Y];
            double length = Math.sqrt(dx * dx + dy * dy);
            tangentX = dx / length;
            tangentY = dy / length;
            return;
        }
        // from the centre to that end, turned anticlockwise, or clockwise if the arc goes so
        int way = pieces.isSolidOutside(piece) ? -1 : 1;
        double cosHalf = Rotation.cos(pieces.half[piece]);
        double sinHalf = way * end * Rotation.sin(pieces.half[piece]);
        double middleX = form[at + PieceTable.MIDDLE_X];
        double middleY = form[at + PieceTable.MIDDLE_Y];
        tangentX = way * (-1 * (middleY * cosHalf + middleX * sinHalf));
        tangentY = way * (middleX * cosHalf - middleY * sinHalf);
    }

    private double worldX(double x, double y) {
        return pivotX + (cos * x - sin * y);
    }

    private double worldY(double x, double y) {
        return pivotY + (sin * x + cos * y);
    }

    private void writeLine(int piece, float[] rows, int at) {
        int from = PieceTable.FORM * piece;
        double localX1 = pieces.form[from + PieceTable.X];
        double localY1 = pieces.form[from + PieceTable.Y];
        double localX2 = pieces.form[from + PieceTable.X2];
        double localY2 = pieces.form[from + PieceTable.Y2];
        double thickness = pieces.form[from + PieceTable.THICKNESS];
        double dx = localX2 - localX1;
        double dy = localY2 - localY1;
        double length = Math.sqrt(dx * dx + dy * dy);
        double x1 = worldX(localX1, localY1);
        double y1 = worldY(localX1, localY1);
        double x2 = worldX(localX2, localY2);
        double y2 = worldY(localX2, localY2);
        double backX = lapsX(0.5 * (x1 + x2));
        double backY = lapsY(0.5 * (y1 + y2));
        float x = (float) (x1 - backX);
        float y = (float) (y1 - backY);
        rows[at + PieceRow.X] = x;
        rows[at + PieceRow.Y] = y;
        rows[at + PieceRow.TX] = (float) ((cos * dx - sin * dy) / length);
        rows[at + PieceRow.TY] = (float) ((sin * dx + cos * dy) / length);
        rows[at + PieceRow.LENGTH] = (float) length;
        rows[at + PieceRow.SPREAD] = 0f;
        rows[at + PieceRow.THICKNESS] = (float) thickness;
        rows[at + PieceRow.START_X] = 0f;
        rows[at + PieceRow.START_Y] = 0f;
        rows[at + PieceRow.PIVOT_X] = (float) (pivotX - backX) - x;
        rows[at + PieceRow.PIVOT_Y] = (float) (pivotY - backY) - y;
        rows[at + PieceRow.END_X] = (float) (x2 - backX - x);
        rows[at + PieceRow.END_Y] = (float) (y2 - backY - y);
        rows[at + PieceRow.MID_X] = (float) (0.5 * (x1 + x2) - backX);
        rows[at + PieceRow.MID_Y] = (float) (0.5 * (y1 + y2) - backY);
        rows[at + PieceRow.HALF_X] = (float) (0.5 * Math.abs(x2 - x1) + thickness);
        rows[at + PieceRow.HALF_Y] = (float) (0.5 * Math.abs(y2 - y1) + thickness);
    }

    private void writeArc(int piece, float[] rows, int at) {
        int from = PieceTable.FORM * piece;
        double localX = pieces.form[from + PieceTable.X];
        double localY = pieces.form[from + PieceTable.Y];
        double radius = pieces.form[from + PieceTable.RADIUS];
        double localTx = pieces.form[from + PieceTable.MIDDLE_X];
        double localTy = pieces.form[from + PieceTable.MIDDLE_Y];
        double unit = 1 / Math.sqrt(localTx * localTx + localTy * localTy);
        double tx = (cos * localTx - sin * localTy) * unit;
        double ty = (sin * localTx + cos * localTy) * unit;
        double spread = pieces.isAllAround(piece) ? PieceRow.ALL_AROUND : Rotation.cos(pieces.half[piece]);
        double cosHalf = Rotation.cos(pieces.half[piece]);
        double sinHalf = Rotation.sin(pieces.half[piece]);
        double rightX = radius * (tx * cosHalf + ty * sinHalf);
        double rightY = radius * (ty * cosHalf - tx * sinHalf);
        double leftX = radius * (tx * cosHalf - ty * sinHalf);
        double leftY = radius * (ty * cosHalf + tx * sinHalf);
        boolean outside = pieces.isSolidOutside(piece);
        double startX = outside ? leftX : rightX;
        double startY = outside ? leftY : rightY;
        double endX = outside ? rightX : leftX;
        double endY = outside ? rightY : leftY;
        double open = spread - SPREAD_MARGIN;
        leastX = -tx >= open ? -radius : Math.min(startX, endX);
        greatestX = tx >= open ? radius : Math.max(startX, endX);
        leastY = -ty >= open ? -radius : Math.min(startY, endY);
        greatestY = ty >= open ? radius : Math.max(startY, endY);
        double x = worldX(localX, localY);
        double y = worldY(localX, localY);
        double midX = x + 0.5 * (leastX + greatestX);
        double midY = y + 0.5 * (leastY + greatestY);
        double backX = lapsX(midX);
        double backY = lapsY(midY);
        rows[at + PieceRow.X] = (float) (x - backX);
        rows[at + PieceRow.Y] = (float) (y - backY);
        rows[at + PieceRow.PIVOT_X] = (float) (pivotX - backX) - rows[at + PieceRow.X];
        rows[at + PieceRow.PIVOT_Y] = (float) (pivotY - backY) - rows[at + PieceRow.Y];
        rows[at + PieceRow.TX] = (float) tx;
        rows[at + PieceRow.TY] = (float) ty;
        rows[at + PieceRow.LENGTH] = (float) radius;
        rows[at + PieceRow.SPREAD] = (float) spread;
        rows[at + PieceRow.THICKNESS] = 0f;
        rows[at + PieceRow.START_X] = (float) startX;
        rows[at + PieceRow.START_Y] = (float) startY;
        rows[at + PieceRow.END_X] = (float) endX;
        rows[at + PieceRow.END_Y] = (float) endY;
        rows[at + PieceRow.MID_X] = (float) (midX - backX);
        rows[at + PieceRow.MID_Y] = (float) (midY - backY);
        rows[at + PieceRow.HALF_X] = (float) (0.5 * (greatestX - leastX));
        rows[at + PieceRow.HALF_Y] = (float) (0.5 * (greatestY - leastY));
    }

    /** What brings the middle of a piece inside an axis that wraps. */
    private double lapsX(double middle) {
        return laps(middle, bounds.minX(), bounds.periodX());
    }

    private double lapsY(double middle) {
        return laps(middle, bounds.minY(), bounds.periodY());
    }

    private static double laps(double middle, double min, double period) {
        return period == Double.POSITIVE_INFINITY ? 0 : Math.floor((middle - min) / period) * period;
    }

    /** More than the distance of any point of a piece from the pivot. */
    private double farthest(int piece) {
        int at = PieceTable.FORM * piece;
        float[] form = pieces.form;
        double start = distance(form[at + PieceTable.X], form[at + PieceTable.Y]);
        return pieces.isArc(piece)
                ? start + form[at + PieceTable.RADIUS]
                : Math.max(start, distance(form[at + PieceTable.X2], form[at + PieceTable.Y2]))
                        + form[at + PieceTable.THICKNESS];
    }

    private static double distance(double x, double y) {
        return Math.sqrt(x * x + y * y);
    }
}
