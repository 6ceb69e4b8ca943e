package io.github.circles2d.world.model;

/**
 * Where a circle stands to a piece of terrain; it leaves its results in the fields. o is the circle's centre against (X, Y) of the {@link PieceRow},
 * in the frame of the start of the step. The side is 1 or -1 for a segment, and 1 for a piece that has a front.
 */
public final class PieceGap {
    /** The piece is no constraint there. */
    public static final int NONE = 0;

    public static final int FACE = 1;
    public static final int AT_START = 2;
    public static final int AT_END = 3;

    /** Which of these the circle is at. */
    public int feature;

    /** Unit normal towards the circle. */
    public float nx;

    public float ny;

    public float gap;

    /** How the way at this gap curves towards the circle, 1/length. */
    public float curve;

    /** Of a line: of the centre, over the front. */
    public float height;

    public void measure(float[] rows, int row, int shape, float ox, float oy, float r, float side) {
        if (PieceRow.form(shape) == PieceRow.ARC) {
            arc(rows, row, shape, ox, oy, r);
        } else {
            line(rows, row, shape, ox, oy, r, side);
        }
    }

    /** Of a line: how far a centre is along it. */
    public static float along(float tx, float ty, float ox, float oy) {
        return ox * tx + oy * ty;
    }

    /** Of a line: how far a centre is over its front. */
    public static float height(float tx, float ty, float ox, float oy) {
        return ox * ty - oy * tx;
    }

    /** Of a line, over its face; reach: the radius and its thickness. */
    public static float faceGap(float side, float height, float reach) {
        return side * height - reach;
    }

    private void line(float[] rows, int row, int shape, float ox, float oy, float r, float side) {
        float tx = rows[row + PieceRow.TX];
        float ty = rows[row + PieceRow.TY];
        float t = along(tx, ty, ox, oy);
        height = height(tx, ty, ox, oy);
        float reach = r + rows[row + PieceRow.THICKNESS];
        boolean before = t < 0f;
        boolean behind = t > rows[row + PieceRow.LENGTH];
        int joint = before ? PieceRow.startJoint(shape) : PieceRow.endJoint(shape);
        if (!before && !behind || joint == PieceRow.CONCAVE) {
            feature = FACE;
            nx = side * ty;
            ny = side * -tx;
            gap = faceGap(side, height, reach);
            curve = 0f;
        } else {
            atVertex(rows, row, before, joint, ox, oy, reach, side * ty, side * -tx);
        }
    }

    private void arc(float[] rows, int row, int shape, float ox, float oy, float r) {
        float tx = rows[row + PieceRow.TX];
        float ty = rows[row + PieceRow.TY];
        float length = rows[row + PieceRow.LENGTH];
        float out = (shape & PieceRow.SOLID_OUTSIDE) != 0 ? -1f : 1f;
        float d = CircleMath.length(ox, oy);
        float cos = ox * tx + oy * ty;
        if (cos >= rows[row + PieceRow.SPREAD] * d) {
            boolean central = d == 0f;
            feature = FACE;
            nx = central ? out * tx : out * (ox / d);
            ny = central ? out * ty : out * (oy / d);
            gap = out * (d - length) - r;
            curve = central ? 0f : -out / d;
        } else {
            boolean left = tx * oy - ty * ox > 0f;
            boolean before = left == out < 0f;
            int joint = before ? PieceRow.startJoint(shape) : PieceRow.endJoint(shape);
            atVertex(rows, row, before, joint, ox, oy, r, out * tx, out * ty);
        }
    }

    /** Beyond an end; (nx, ny) is for a centre in the end itself. */
    private void atVertex(
            float[] rows, int row, boolean before, int joint, float ox, float oy, float reach, float nx, float ny) {
        float ex = ox - rows[row + (before ? PieceRow.START_X : PieceRow.END_X)];
        float ey = oy - rows[row + (before ? PieceRow.START_Y : PieceRow.END_Y)];
        float d = CircleMath.length(ex, ey);
        boolean central = d == 0f;
        this.nx = central ? nx : ex / d;
        this.ny = central ? ny : ey / d;
        gap = d - reach;
        curve = central ? 0f : -1f / d;
        // a joint belongs to the piece that ends there, up to where the next one begins
        boolean claims = joint == PieceRow.FREE
                || joint == PieceRow.CONVEX
                        && !before
                        && ex * rows[row + PieceRow.NEXT_X] + ey * rows[row + PieceRow.NEXT_Y] < 0f;
        feature = !claims ? NONE : before ? AT_START : AT_END;
    }

    /** How fast a way that curves turns away from a straight one on average, in a time h, at a speed along it; never faster than that. */
    public static float turned(float curve, float along, float h) {
        float most = Math.abs(along);
        return CircleMath.clamp(0.5f * curve * along * along * h, -most, most);
    }

    /** Whether a centre is in front of a piece. */
    public static boolean isInFront(float[] rows, int row, int shape, float ox, float oy) {
        if (PieceRow.form(shape) != PieceRow.ARC) {
            return ox * rows[row + PieceRow.TY] - oy * rows[row + PieceRow.TX] >= 0f;
        }
        float d = CircleMath.length(ox, oy);
        float length = rows[row + PieceRow.LENGTH];
        return (shape & PieceRow.SOLID_OUTSIDE) != 0 ? d <= length : d >= length;
    }

    /** Of a centre and the nearest point of a piece with its thickness; joints do not matter. */
    public static float distance(float[] rows, int row, int shape, float ox, float oy) {
        float tx = rows[row + PieceRow.TX];
        float ty = rows[row + PieceRow.TY];
        float length = rows[row + PieceRow.LENGTH];
        float cos = ox * tx + oy * ty;
        if (PieceRow.form(shape) != PieceRow.ARC) {
            float t = CircleMath.clamp(cos, 0f, length);
            return CircleMath.length(ox - t * tx, oy - t * ty) - rows[row + PieceRow.THICKNESS];
        }
        float d = CircleMath.length(ox, oy);
        if (cos >= rows[row + PieceRow.SPREAD] * d) {
            return Math.abs(d - length);
        }
        float start = CircleMath.length(ox - rows[row + PieceRow.START_X], oy - rows[row + PieceRow.START_Y]);
        float end = CircleMath.length(ox - rows[row + PieceRow.END_X], oy - rows[row + PieceRow.END_Y]);
        return CircleMath.min(start, end);
    }

    /** Whether a vertex, at o and as thick as its piece, is no higher than a slack over the face of a piece, between its ends. */
    public static boolean covers(
            float[] rows, int row, int shape, float side, float ox, float oy, float thickness, float slack) {
        float tx = rows[row + PieceRow.TX];
        float ty = rows[row + PieceRow.TY];
        float length = rows[row + PieceRow.LENGTH];
        float cos = ox * tx + oy * ty;
        if (PieceRow.form(shape) != PieceRow.ARC) {
            float height = side * (ox * ty - oy * tx) - rows[row + PieceRow.THICKNESS];
            return cos >= -slack && cos <= length + slack && height + thickness <= slack;
        }
        float d = CircleMath.length(ox, oy);
        float out = (shape & PieceRow.SOLID_OUTSIDE) != 0 ? -1f : 1f;
        return cos >= rows[row + PieceRow.SPREAD] * d - slack && out * (d - length) + thickness <= slack;
    }
}
