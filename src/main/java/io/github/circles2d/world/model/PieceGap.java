package io.github.circles2d.world.model;

/**
 * Where a circle stands to a piece of terrain; it leaves its results in the fields. Code of terrain writes -1 * x for -x, which loses the sign of a
 * zero in WebAssembly. o is the circle's centre against (X, Y) of the {@link PieceRow},
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

    /** Of the centre, over the front. */
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
            feature = goesOn(t, rows[row + PieceRow.LENGTH], r) ? FACE : NONE;
            nx = side * ty;
            ny = side * (-1f * tx);
            gap = faceGap(side, height, reach);
            curve = 0f;
        } else {
            atVertex(rows, row, before, joint, ox, oy, reach, side * ty, side * (-1f * tx));
        }
    }

    /** At a concave joint a line goes on, so that no circle slips in: not behind what follows there. */
    static boolean goesOn(float t, float length, float r) {
        float more = Tuning.CORNER * r;
        return t >= -more && t <= length + more;
    }

    /** Whether a circle that was beyond an end has come behind the piece: around that end, since no circle passes a face. */
    public boolean isAround(int featureBefore, float side) {
        return feature == FACE && featureBefore != FACE && side * height < 0f;
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
            height = out * (d - length);
            gap = height - r;
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
        return CircleMath.clamp(0.5f * curve * along * along * h, -1f * most, most);
    }

    /**
     * Whether a centre is in front of a piece, or at the tip of it and the next piece in front of that one. Beside an arc its tangents at the ends
     * decide: who comes from there has not passed it.
     */
    public static boolean isInFront(float[] rows, int row, int shape, float ox, float oy) {
        float tx = rows[row + PieceRow.TX];
        float ty = rows[row + PieceRow.TY];
        float length = rows[row + PieceRow.LENGTH];
        float cos = ox * tx + oy * ty;
        float ex = ox - rows[row + PieceRow.END_X];
        float ey = oy - rows[row + PieceRow.END_Y];
        boolean front;
        boolean beyond;
        if (PieceRow.form(shape) == PieceRow.ARC) {
            boolean inner = (shape & PieceRow.SOLID_OUTSIDE) != 0;
            float d = CircleMath.length(ox, oy);
            float height = d - length;
            beyond = false;
            if (!(cos >= rows[row + PieceRow.SPREAD] * d)) {
                beyond = tx * oy - ty * ox > 0f == !inner;
                int e = row + (beyond ? PieceRow.END_X : PieceRow.START_X);
                height = rows[e] * (ox - rows[e]) + rows[e + 1] * (oy - rows[e + 1]);
            }
            front = inner ? height <= 0f : height >= 0f;
        } else {
            front = ox * ty - oy * tx >= 0f;
            beyond = cos > length;
        }
        return front
                || beyond
                        && PieceRow.endJoint(shape) == PieceRow.CONVEX
                        && ex * rows[row + PieceRow.NEXT_Y] - ey * rows[row + PieceRow.NEXT_X] >= 0f;
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

    /**
     * Whether the face of a piece hides a vertex from a circle in front of it: it is no higher than a slack over the face, between its ends, and not at the end that the
     * circle is beyond. (x, y) is the vertex, as thick as its piece, against (X, Y) of the piece that may cover it. A free end is drawn by hand; the
     * joint of a chain (free: false) has to be flush but for rounding, since what it is higher is a step.
     */
    public static boolean covers(
            float[] rows,
            int row,
            int shape,
            float ox,
            float oy,
            float side,
            float x,
            float y,
            float thickness,
            boolean free,
            float r) {
        float slack = Tuning.COVER * r;
        float tx = rows[row + PieceRow.TX];
        float ty = rows[row + PieceRow.TY];
        float length = rows[row + PieceRow.LENGTH];
        if (PieceRow.form(shape) == PieceRow.ARC) {
            float spread = rows[row + PieceRow.SPREAD];
            float far = CircleMath.length(ox, oy);
            float d = CircleMath.length(x, y);
            float out = (shape & PieceRow.SOLID_OUTSIDE) != 0 ? -1f : 1f;
            return ox * tx + oy * ty >= spread * far
                    && out * (far - length) >= 0f
                    && x * tx + y * ty >= spread * d - slack
                    && out * (d - length) + thickness <= step(rows, row, free, r, slack);
        }
        // nearly all are not between the ends
        float t = along(tx, ty, x, y);
        if (!(t >= -slack && t <= length + slack) || !(side * height(tx, ty, ox, oy) >= 0f)) {
            return false;
        }
        float higher = (side * height(tx, ty, x, y) - rows[row + PieceRow.THICKNESS]) + thickness;
        if (!(higher <= step(rows, row, free, r, slack))) {
            return false;
        }
        float at = along(tx, ty, ox, oy);
        if (at < 0f && PieceRow.startJoint(shape) != PieceRow.CONCAVE) {
            return t > slack;
        }
        if (at > length && PieceRow.endJoint(shape) != PieceRow.CONCAVE) {
            return t < length - slack;
        }
        return true;
    }

    private static float step(float[] rows, int row, boolean free, float r, float slack) {
        float rounded = Tuning.ROUNDED * (Math.abs(rows[row + PieceRow.X]) + Math.abs(rows[row + PieceRow.Y]));
        return free ? slack : CircleMath.clamp(rounded, Tuning.FLUSH * r, slack);
    }
}
