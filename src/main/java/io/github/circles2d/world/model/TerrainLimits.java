package io.github.circles2d.world.model;

/** The values that terrain takes. */
public final class TerrainLimits {
    public static final int PIECES = 1 << 20;

    /** With the ground. */
    public static final int BODIES = 1 << 20;

    /** Of the length of a piece and of its radius: a share of its coordinates, above their rounding. */
    private static final double LEAST_SHARE = 0x1p-20;

    private static final double LEAST_LENGTH = 0x1p-40;

    /** In units of an angle: an opening that differs from a turn by less is one, since angles in floats are no better. */
    private static final int SLACK = 1 << 14;

    /** In units of an angle: half of it is one. */
    private static final int LEAST_OPENING = 2;

    private static final int QUARTER = 1 << 30;

    /** Radians. */
    private static final double MORE_THAN_A_TURN = 7;

    private TerrainLimits() {}

    public static double distance(float x1, float y1, float x2, float y2) {
        double dx = (double) x2 - x1;
        double dy = (double) y2 - y1;
        return Math.sqrt(dx * dx + dy * dy);
    }

    private static double leastLength(double coordinate) {
        return Math.max(LEAST_SHARE * coordinate, LEAST_LENGTH);
    }

    public static boolean isTooShort(float x1, float y1, float x2, float y2) {
        double most = Math.max(Math.max(Math.abs(x1), Math.abs(y1)), Math.max(Math.abs(x2), Math.abs(y2)));
        return isTooShort(distance(x1, y1, x2, y2), most);
    }

    /** Whether a length is nothing but rounding, among coordinates or extents of a size. */
    public static boolean isTooShort(double length, double size) {
        return !(length > leastLength(size));
    }

    /** The units of an angle between the ends of an arc, at most a turn, which is a circle. */
    public static long opening(String what, double angle) {
        long units = Rotation.units(angle);
        if (!(Math.abs(angle) < MORE_THAN_A_TURN) || Math.abs(units) > Rotation.TURN + SLACK) {
            throw new IllegalArgumentException(what + " is " + angle + ", but must be from -2 pi to 2 pi, in radians");
        }
        if (Math.abs(units) < LEAST_OPENING) {
            throw new IllegalArgumentException(what + " is " + angle + ", which is 0, or too near to it");
        }
        return Math.abs(units) > Rotation.TURN - SLACK ? units < 0 ? -Rotation.TURN : Rotation.TURN : units;
    }

    public static void coordinate(String what, float value) {
        Limits.within(what, value, -Limits.COORDINATE, Limits.COORDINATE);
    }

    /** Whether an arc may open so far, in units of an angle. */
    public static boolean isOpening(long units) {
        return units >= -Rotation.TURN && units <= Rotation.TURN && (units >= LEAST_OPENING || units <= -LEAST_OPENING);
    }

    /** The units of the opening of an arc, anticlockwise between two angles. */
    public static long opening(float from, float to) {
        double angle = (double) to - from;
        if (!(angle > 0)) {
            throw new IllegalArgumentException("the arc goes from " + from + " to " + to
                    + ", but must go anticlockwise: `to` must be greater than `from`, by 2 pi at most");
        }
        return opening("the angle between `from` and `to`", angle);
    }

    public static void segment(float x1, float y1, float x2, float y2, float thickness, Bounds bounds) {
        coordinate("x1", x1);
        coordinate("y1", y1);
        coordinate("x2", x2);
        coordinate("y2", y2);
        Limits.within("thickness", thickness, 0f, Limits.COORDINATE);
        if (isTooShort(x1, y1, x2, y2)) {
            throw new IllegalArgumentException("the segment goes from " + x1 + ", " + y1 + " to " + x2 + ", " + y2
                    + ", but must be longer than 2^-20 of its coordinates");
        }
        extent(distance(x1, y1, x2, y2) + 2.0 * thickness, bounds);
    }

    /** half: of the opening, in units of an angle without sign. */
    public static void arc(float x, float y, float radius, int half, Bounds bounds) {
        coordinate("x", x);
        coordinate("y", y);
        Limits.within("radius", radius, 0f, Limits.COORDINATE);
        if (!(radius >= leastLength(Math.max(Math.abs(x), Math.abs(y))))) { // a chain's radius may be rounded to it
            throw new IllegalArgumentException(
                    "the radius is " + radius + ", but must be at least 2^-20 of the coordinates of the centre");
        }
        extent(extentOfArc(radius, half), bounds);
    }

    /** Of the box around an arc, in any direction. */
    public static double extentOfArc(float radius, int half) {
        return 2.0 * radius * (half >= 0 && half < QUARTER ? Rotation.sin(half) : 1);
    }

    /** A piece is at most half as long as an axis that wraps, so there is one short way to it. */
    public static void extent(double extent, Bounds bounds) {
        float period = Math.min(bounds.periodX(), bounds.periodY());
        if (extent > 0.5 * period) {
            throw new IllegalArgumentException("a piece is " + (float) extent
                    + " long, but where an axis wraps it must be at most half of it, " + 0.5f * period);
        }
    }
}
