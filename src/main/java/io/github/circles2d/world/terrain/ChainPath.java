package io.github.circles2d.world.terrain;

import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.model.Rotation;
import io.github.circles2d.world.model.TerrainLimits;
import java.util.Arrays;

/** Points in a row, and what joins them: lines, and arcs. It only grows, so a thread that reads a part of it finds that part whole. */
public final class ChainPath {
    /** Of an arc. */
    private static final int MOST_LINES = 4096;

    private int pieces;
    private boolean closed;

    /** By point: x and y. Piece k goes from point k to point k + 1. */
    private float[] points = new float[8];

    /** By piece: x and y of the centre of an arc. */
    private float[] centres = new float[8];

    /** By piece: how far an arc turns around its centre, in units of an angle, positive anticlockwise; 0 of a line. */
    private long[] turns = new long[4];

    public ChainPath(float x, float y) {
        check(0, x, y);
        points[0] = x;
        points[1] = y;
    }

    public int pieces() {
        return pieces;
    }

    public boolean isClosed() {
        return closed;
    }

    public float x(int point) {
        return points[2 * point];
    }

    public float y(int point) {
        return points[2 * point + 1];
    }

    public float centreX(int piece) {
        return centres[2 * piece];
    }

    public float centreY(int piece) {
        return centres[2 * piece + 1];
    }

    /** Of an arc. */
    float radius(int piece) {
        return (float) TerrainLimits.distance(x(piece), y(piece), centreX(piece), centreY(piece));
    }

    public long turn(int piece) {
        return turns[piece];
    }

    /** Checks the extents of the first pieces, of which there are so many. */
    public void check(int count, Bounds bounds) {
        for (int k = 0; k < count; k++) {
            try {
                if (turns[k] == 0) {
                    TerrainLimits.extent(TerrainLimits.distance(x(k), y(k), x(k + 1), y(k + 1)), bounds);
                } else {
                    TerrainLimits.extent(
                            TerrainLimits.extentOfArc(radius(k), (int) (Math.abs(turns[k]) >>> 1)), bounds);
                }
            } catch (IllegalArgumentException e) {
                throw new IllegalArgumentException("piece " + k + " of the chain: " + e.getMessage(), e);
            }
        }
    }

    private static void check(int point, float x, float y) {
        if (!(Math.abs(x) <= Limits.COORDINATE && Math.abs(y) <= Limits.COORDINATE)) {
            throw new IllegalArgumentException("point " + point + " of the chain is " + x + ", " + y
                    + ", but coordinates must be from " + -Limits.COORDINATE + " to " + Limits.COORDINATE);
        }
    }

    private void checkNotClosed() {
        if (closed) {
            throw new IllegalStateException("the chain has been closed");
        }
    }

    /** Refuses one more piece of a chain that is closed, or has as many as it may have. */
    private void checkOpen() {
        checkNotClosed();
        if (pieces >= TerrainLimits.PIECES) {
            throw new IllegalArgumentException("a chain has at most " + TerrainLimits.PIECES + " pieces");
        }
    }

    public void lineTo(float x, float y) {
        checkOpen();
        int point = pieces + 1;
        check(point, x, y);
        if (!isFar(x, y)) {
            throw new IllegalArgumentException("point " + point + " of the chain is " + x + ", " + y
                    + ", which is the point before it, or too near to it");
        }
        append(x, y, 0f, 0f, 0);
    }

    /** Whether a line may go to a point: it is not the last one. */
    public boolean isFar(float x, float y) {
        return !TerrainLimits.isTooShort(x(pieces), y(pieces), x, y);
    }

    public void arcTo(float centreX, float centreY, float angle) {
        arcBy(
                centreX,
                centreY,
                TerrainLimits.opening("the angle of the arc to point " + (pieces + 1) + " of the chain", angle));
    }

    /** By an angle in units. */
    public void arcBy(float centreX, float centreY, long turn) {
        checkOpen();
        int point = pieces + 1;
        if (!TerrainLimits.isOpening(turn)) {
            throw new IllegalArgumentException("the arc to point " + point + " of the chain turns by " + turn
                    + " units of an angle, but must turn by at least 2, and a turn at most");
        }
        if (!(Math.abs(centreX) <= Limits.COORDINATE && Math.abs(centreY) <= Limits.COORDINATE)) {
            throw new IllegalArgumentException("the centre of the arc to point " + point + " of the chain is " + centreX
                    + ", " + centreY + ", but coordinates must be from " + -Limits.COORDINATE + " to "
                    + Limits.COORDINATE);
        }
        if (TerrainLimits.isTooShort(x(pieces), y(pieces), centreX, centreY)) {
            throw new IllegalArgumentException("the centre of the arc to point " + point + " of the chain is " + centreX
                    + ", " + centreY + ", which is the point before it, or too near to it");
        }
        double radius = TerrainLimits.distance(x(pieces), y(pieces), centreX, centreY);
        if (radius > Limits.COORDINATE) {
            throw new IllegalArgumentException("the radius of the arc to point " + point + " of the chain is " + radius
                    + ", but must be at most " + Limits.COORDINATE);
        }
        appendArc(centreX, centreY, turn);
    }

    private void appendArc(float centreX, float centreY, long turn) {
        int point = pieces + 1;
        double dx = (double) x(pieces) - centreX;
        double dy = (double) y(pieces) - centreY;
        double cos = Rotation.cos((int) turn);
        double sin = Rotation.sin((int) turn);
        float x = (float) (centreX + (cos * dx - sin * dy));
        float y = (float) (centreY + (sin * dx + cos * dy));
        check(point, x, y);
        append(x, y, centreX, centreY, turn);
    }

    private void append(float x, float y, float centreX, float centreY, long turn) {
        int next = pieces + 1;
        if (next >= turns.length) {
            points = Arrays.copyOf(points, 4 * turns.length);
            centres = Arrays.copyOf(centres, 4 * turns.length);
            turns = Arrays.copyOf(turns, 2 * turns.length);
        }
        points[2 * next] = x;
        points[2 * next + 1] = y;
        centres[2 * pieces] = centreX;
        centres[2 * pieces + 1] = centreY;
        turns[pieces] = turn;
        pieces = next;
    }

    /** The same outline from its end to its start. Arcs end where they are computed to end, as those of a log do. */
    public ChainPath reversed() {
        ChainPath back = new ChainPath(x(pieces), y(pieces));
        for (int k = pieces - 1; k >= 0; k--) {
            if (turns[k] == 0) {
                back.lineTo(x(k), y(k));
            } else {
                back.arcBy(centreX(k), centreY(k), -turns[k]);
            }
        }
        if (closed) {
            back.close();
        }
        return back;
    }

    /** x and y of points on the outline, between which lines are at most so far from it. */
    public float[] points(float tolerance) {
        int count = 1;
        for (int k = 0; k < pieces; k++) {
            count += lines(k, tolerance);
        }
        float[] to = new float[2 * count];
        int at = 0;
        for (int k = 0; k < pieces; k++) {
            int lines = lines(k, tolerance);
            for (int line = 0; line < lines; line++) {
                to[at] = x(k);
                to[at + 1] = y(k);
                if (line > 0) {
                    int turned = (int) Rotation.nearest((double) turns[k] * line / lines);
                    double dx = (double) x(k) - centreX(k);
                    double dy = (double) y(k) - centreY(k);
                    to[at] = (float) (centreX(k) + (Rotation.cos(turned) * dx - Rotation.sin(turned) * dy));
                    to[at + 1] = (float) (centreY(k) + (Rotation.sin(turned) * dx + Rotation.cos(turned) * dy));
                }
                at += 2;
            }
        }
        to[at] = x(pieces);
        to[at + 1] = y(pieces);
        return to;
    }

    /** Lines in place of a piece: over an angle a the middle of a chord is less than r a^2 / 8 from the arc. */
    private int lines(int piece, float tolerance) {
        double angle = Math.abs(turns[piece]) * Rotation.RADIANS_PER_UNIT;
        double lines = Math.ceil(angle * Math.sqrt(radius(piece) / (8.0 * tolerance)));
        return turns[piece] == 0 ? 1 : (int) Math.max(1, Math.min(MOST_LINES, lines));
    }

    /** Joins the last point to the first, by a line unless they are one point but for rounding. */
    public void close() {
        checkNotClosed();
        if (pieces < 1) {
            throw new IllegalStateException("the chain has 1 point, but must have 2 to be closed");
        }
        if (!isBack()) {
            checkOpen();
            append(x(0), y(0), 0f, 0f, 0);
        } else if (pieces == 1 && Math.abs(turns[0]) < Rotation.TURN) {
            throw new IllegalStateException("the chain has but one point");
        }
        closed = true;
    }

    /** Whether the last point is the first but for rounding: that of its coordinates, or that of the chain, which may be much larger. */
    private boolean isBack() {
        if (TerrainLimits.isTooShort(x(pieces), y(pieces), x(0), y(0))) {
            return true;
        }
        double extent = 0;
        for (int k = 0; k < pieces; k++) {
            extent = Math.max(extent, TerrainLimits.distance(x(0), y(0), x(k), y(k)));
            if (Math.abs(turns[k]) >= Rotation.TURN / 2) { // else its ends are about as far apart as it is large
                extent = Math.max(extent, radius(k));
            }
        }
        return TerrainLimits.isTooShort(TerrainLimits.distance(x(pieces), y(pieces), x(0), y(0)), extent);
    }
}
