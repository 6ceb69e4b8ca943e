package io.github.circles2d.world.model;

/**
 * When a circle that moves evenly touches a piece of terrain, as a share of its motion; more than 1 if it does not, or gets no deeper than a graze.
 * o and u are its centre, as in {@link PieceGap}, and its motion.
 */
public final class PieceSweep {
    private static final float NEVER = 2f;

    private PieceSweep() {}

    public static float time(
            float[] rows, int row, int shape, float ox, float oy, float ux, float uy, float r, float side) {
        float reach = r + rows[row + PieceRow.THICKNESS];
        float face = PieceRow.form(shape) == PieceRow.ARC
                ? timeOfArc(rows, row, shape, ox, oy, ux, uy, r)
                : timeOfLine(rows, row, shape, ox, oy, ux, uy, reach, side);
        int start = PieceRow.startJoint(shape);
        int end = PieceRow.endJoint(shape);
        float t = face;
        if (start == PieceRow.FREE) {
            float dx = rows[row + PieceRow.START_X] - ox;
            float dy = rows[row + PieceRow.START_Y] - oy;
            t = CircleMath.min(TimeOfImpact.timeOfImpact(dx, dy, ux, uy, reach), t);
        }
        if (end == PieceRow.FREE || end == PieceRow.CONVEX) {
            float dx = rows[row + PieceRow.END_X] - ox;
            float dy = rows[row + PieceRow.END_Y] - oy;
            t = CircleMath.min(TimeOfImpact.timeOfImpact(dx, dy, ux, uy, reach), t);
        }
        return t;
    }

    private static float timeOfLine(
            float[] rows, int row, int shape, float ox, float oy, float ux, float uy, float reach, float side) {
        float tx = rows[row + PieceRow.TX];
        float ty = rows[row + PieceRow.TY];
        float height = side * (ox * ty - oy * tx);
        float sinks = -(side * (ux * ty - uy * tx));
        float deep = height - (reach - Tuning.GRAZE * reach);
        if (!(sinks > 0f) || !(deep < sinks)) {
            return NEVER;
        }
        float t = CircleMath.max((height - reach) / sinks, 0f);
        float along = (ox * tx + oy * ty) + t * (ux * tx + uy * ty);
        boolean meets = (along >= 0f || PieceRow.startJoint(shape) == PieceRow.CONCAVE)
                && (along <= rows[row + PieceRow.LENGTH] || PieceRow.endJoint(shape) == PieceRow.CONCAVE);
        return meets ? t : NEVER;
    }

    private static float timeOfArc(float[] rows, int row, int shape, float ox, float oy, float ux, float uy, float r) {
        float length = rows[row + PieceRow.LENGTH];
        float t = (shape & PieceRow.SOLID_OUTSIDE) != 0
                ? timeFromInside(ox, oy, ux, uy, length - r, Tuning.GRAZE * r)
                : TimeOfImpact.timeOfImpact(-ox, -oy, ux, uy, length + r);
        if (!(t < 1f)) {
            return NEVER;
        }
        float x = ox + t * ux;
        float y = oy + t * uy;
        float cos = x * rows[row + PieceRow.TX] + y * rows[row + PieceRow.TY];
        return cos >= rows[row + PieceRow.SPREAD] * CircleMath.length(x, y) ? t : NEVER;
    }

    /** When a point leaves a circle around 0, unless it gets no farther than a graze. */
    private static float timeFromInside(float ox, float oy, float ux, float uy, float radius, float graze) {
        float b = ox * ux + oy * uy;
        float a = ux * ux + uy * uy;
        float c = radius * radius - (ox * ox + oy * oy);
        if (!CircleMath.isLonger(ox + ux, oy + uy, radius + graze) || !(radius > 0f)) {
            return NEVER;
        }
        if (!(c > 0f)) {
            return b > 0f ? 0f : NEVER;
        }
        // the root that loses no digits
        float root = (float) Math.sqrt(b * b + a * c);
        return b > 0f ? c / (b + root) : (root - b) / a;
    }
}
