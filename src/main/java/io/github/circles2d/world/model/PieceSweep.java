package io.github.circles2d.world.model;

/**
 * When a circle that moves evenly touches a piece of terrain, as a share of its motion; more than 1 if it does not, or gets no deeper than a graze.
 * o and u are its centre, as in {@link PieceGap}, and its motion.
 */
public final class PieceSweep {
    private static final float NEVER = 2f;

    private PieceSweep() {}

    private static float timeOfLine(
            float[] rows,
            int row,
            int shape,
            float ox,
            float oy,
            float ux,
            float uy,
            float r,
            float reach,
            float side) {
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
        float length = rows[row + PieceRow.LENGTH];
        boolean meets = (along >= 0f || PieceRow.startJoint(shape) == PieceRow.CONCAVE)
                && (along <= length || PieceRow.endJoint(shape) == PieceRow.CONCAVE)
                && PieceGap.goesOn(along, length, r);
        return meets ? t : NEVER;
    }

    /** When a point leaves a circle around 0, unless it gets no farther than a graze. */
    private static float timeFromInside(float ox, float oy, float ux, float uy, float radius, float graze) {
        float b = ox * ux + oy * uy;
        float a = ux * ux + uy * uy;
        float c = radius * radius - (ox * ox + oy * oy);
        if (!CircleMath.isLonger(ox + ux, oy + uy, radius + graze) || !(radius > 0f)) {
            return NEVER;
        }
        if (b > 0f) {
            // the root that loses no digits
            return c > 0f ? c / (b + (float) Math.sqrt(b * b + a * c)) : 0f;
        }
        // a chord, also of a point that starts a little outside; one that never comes in stops where it is nearest
        float disc = CircleMath.max(b * b + a * c, 0f);
        return ((float) Math.sqrt(disc) - b) / a;
    }

    static boolean isInOpening(float[] rows, int row, float x, float y) {
        float cos = x * rows[row + PieceRow.TX] + y * rows[row + PieceRow.TY];
        return cos >= rows[row + PieceRow.SPREAD] * CircleMath.length(x, y);
    }

    /** When a point comes, after a share of its motion, from beside an arc to the radius of its end e, in front of the arc. */
    private static float timeOfEnd(
            float ex, float ey, float ox, float oy, float ux, float uy, float after, float length) {
        float t = (ey * ox - ex * oy) / (ex * uy - ey * ux);
        if (!(t >= after && t < 1f)) {
            return NEVER;
        }
        float x = ox + t * ux;
        float y = oy + t * uy;
        return x * ex + y * ey > 0f && !CircleMath.isLonger(x, y, length) ? t : NEVER;
    }

    private static float timeOfArc(float[] rows, int row, int shape, float ox, float oy, float ux, float uy, float r) {
        float length = rows[row + PieceRow.LENGTH];
        boolean inner = (shape & PieceRow.SOLID_OUTSIDE) != 0;
        float t = inner
                ? timeFromInside(ox, oy, ux, uy, length - r, Tuning.GRAZE * r)
                : TimeOfImpact.timeOfImpact(-ox, -oy, ux, uy, length + r);
        if (!(t < 1f)) {
            return NEVER;
        }
        if (isInOpening(rows, row, ox + t * ux, oy + t * uy)) {
            return t;
        }
        if (!inner || !isInOpening(rows, row, ox + ux, oy + uy)) {
            return NEVER;
        }
        // it has left the whole circle beside the arc: along a line that is joined to the arc, say
        float start = timeOfEnd(rows[row + PieceRow.START_X], rows[row + PieceRow.START_Y], ox, oy, ux, uy, t, length);
        float end = timeOfEnd(rows[row + PieceRow.END_X], rows[row + PieceRow.END_Y], ox, oy, ux, uy, t, length);
        return CircleMath.min(end, start);
    }

    public static float timeOfFace(
            float[] rows, int row, int shape, float ox, float oy, float ux, float uy, float r, float side) {
        float reach = r + rows[row + PieceRow.THICKNESS];
        return PieceRow.form(shape) == PieceRow.ARC
                ? timeOfArc(rows, row, shape, ox, oy, ux, uy, r)
                : timeOfLine(rows, row, shape, ox, oy, ux, uy, r, reach, side);
    }

    /** Of an end that is not concave. Of a tip, who comes from behind the piece that ends there is in front of the one that starts. */
    public static float timeOfVertex(
            float[] rows, int row, int shape, boolean start, float ox, float oy, float ux, float uy, float r) {
        if ((start ? PieceRow.startJoint(shape) : PieceRow.endJoint(shape)) == PieceRow.CONCAVE) {
            return NEVER;
        }
        float dx = rows[row + (start ? PieceRow.START_X : PieceRow.END_X)] - ox;
        float dy = rows[row + (start ? PieceRow.START_Y : PieceRow.END_Y)] - oy;
        return TimeOfImpact.timeOfImpact(dx, dy, ux, uy, r + rows[row + PieceRow.THICKNESS]);
    }
}
