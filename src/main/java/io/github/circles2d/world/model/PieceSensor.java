package io.github.circles2d.world.model;

/**
 * When a circle that moves evenly touches a piece of terrain that only senses it, as a share of its motion; more than 1 if it does not. o and u
 * are its centre, as in {@link PieceGap}, and its motion. Unlike {@link PieceSweep}, a graze counts, and so do joints and both sides.
 */
public final class PieceSensor {
    private static final float NEVER = 2f;

    private PieceSensor() {}

    private static float timeAtLine(float[] rows, int row, float ox, float oy, float ux, float uy, float reach) {
        float tx = rows[row + PieceRow.TX];
        float ty = rows[row + PieceRow.TY];
        float height = ox * ty - oy * tx;
        float side = height >= 0f ? 1f : -1f;
        float sinks = -(side * (ux * ty - uy * tx));
        float gap = side * height - reach;
        if (!(sinks > 0f) || !(gap > 0f)) {
            return NEVER; // beyond an end, perhaps
        }
        float t = gap / sinks;
        float along = (ox * tx + oy * ty) + t * (ux * tx + uy * ty);
        return along >= 0f && along <= rows[row + PieceRow.LENGTH] ? t : NEVER;
    }

    /** When a point leaves a circle around 0, perhaps after it has come into it. */
    private static float timeOfLeaving(float ox, float oy, float ux, float uy, float radius) {
        float a = ux * ux + uy * uy;
        float b = ox * ux + oy * uy;
        float c = radius * radius - (ox * ox + oy * oy);
        float disc = b * b + a * c;
        if (!(radius > 0f) || !(disc >= 0f) || !(a > 0f) || !(c > 0f) && !(b < 0f)) {
            return NEVER;
        }
        // the root that loses no digits
        float root = (float) Math.sqrt(disc);
        return b > 0f ? c / (b + root) : (root - b) / a;
    }

    /** On its outer side from outside, or on its inner side from within. */
    private static float timeAtArc(float[] rows, int row, float ox, float oy, float ux, float uy, float r) {
        float length = rows[row + PieceRow.LENGTH];
        boolean outside = CircleMath.isLonger(ox, oy, length + r);
        float outer = outside ? TimeOfImpact.timeOfTouch(-ox, -oy, ux, uy, length + r) : NEVER;
        float inner = timeOfLeaving(ox, oy, ux, uy, length - r);
        float t = PieceSweep.isInOpening(rows, row, ox + outer * ux, oy + outer * uy) ? outer : NEVER;
        return inner < t && PieceSweep.isInOpening(rows, row, ox + inner * ux, oy + inner * uy) ? inner : t;
    }

    public static float timeOfSensing(
            float[] rows, int row, int shape, float ox, float oy, float ux, float uy, float r) {
        if (PieceGap.distance(rows, row, shape, ox, oy) <= r) {
            return 0f;
        }
        float reach = r + rows[row + PieceRow.THICKNESS];
        boolean isArc = PieceRow.form(shape) == PieceRow.ARC;
        float t = isArc ? timeAtArc(rows, row, ox, oy, ux, uy, r) : timeAtLine(rows, row, ox, oy, ux, uy, reach);
        if (isArc && rows[row + PieceRow.SPREAD] == PieceRow.ALL_AROUND) {
            return t;
        }
        float startX = rows[row + PieceRow.START_X] - ox;
        float startY = rows[row + PieceRow.START_Y] - oy;
        float endX = rows[row + PieceRow.END_X] - ox;
        float endY = rows[row + PieceRow.END_Y] - oy;
        float atStart = TimeOfImpact.timeOfTouch(startX, startY, ux, uy, reach);
        float atEnd = TimeOfImpact.timeOfTouch(endX, endY, ux, uy, reach);
        return CircleMath.min(CircleMath.min(atStart, atEnd), t);
    }

    /** Of a circle that comes from behind a piece with a front: right through a bowl it comes to the front within its motion. */
    public static float timeOfReturn(
            float[] rows, int row, int shape, float ox, float oy, float ux, float uy, float r) {
        if (PieceRow.form(shape) != PieceRow.ARC || (shape & PieceRow.SOLID_OUTSIDE) == 0) {
            return NEVER;
        }
        float t = timeOfLeaving(ox, oy, ux, uy, rows[row + PieceRow.LENGTH] - r);
        return PieceSweep.isInOpening(rows, row, ox + t * ux, oy + t * uy) ? t : NEVER;
    }
}
