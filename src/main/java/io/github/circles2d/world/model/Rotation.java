package io.github.circles2d.world.model;

/**
 * Sine and cosine of angles in units of a turn's 2^-32. They take only sums, products and quotients, which all platforms round alike;
 * they are off by 2e-16 at most. The polynomials are those of fdlibm.
 */
public final class Rotation {
    public static final double RADIANS_PER_UNIT = Math.PI / (1L << 31);

    /** Units of a turn. */
    public static final long TURN = 1L << 32;

    private static final int QUARTER_LOG = 30;
    private static final int EIGHTH = 1 << 29;

    private Rotation() {}

    public static double sin(int units) {
        int quarter = quarter(units);
        double x = fromQuarter(units, quarter);
        double value = (quarter & 1) == 0 ? sinOfEighth(x) : cosOfEighth(x);
        return (quarter & 2) == 0 ? value : -1 * value; // -value loses the sign of a zero on some platforms
    }

    public static double cos(int units) {
        return sin(units + (1 << QUARTER_LOG));
    }

    /** The quarter of a turn that is nearest, from 0 to 3. */
    public static int quarter(int units) {
        return units + EIGHTH >>> QUARTER_LOG;
    }

    /** By how much an angle is beyond its quarter, in radians: an eighth of a turn at most. */
    public static double fromQuarter(int units, int quarter) {
        return (units - (quarter << QUARTER_LOG)) * RADIANS_PER_UNIT;
    }

    public static double sinOfEighth(double x) {
        double z = x * x;
        double sum = 2.75573137070700676789e-06 + z * (-2.50507602534068634195e-08 + z * 1.58969099521155010221e-10);
        sum = 8.33333333332248946124e-03 + z * (-1.98412698298579493134e-04 + z * sum);
        return x + x * z * (-1.66666666666666324348e-01 + z * sum);
    }

    public static double cosOfEighth(double x) {
        double z = x * x;
        double sum = -2.75573143513906633035e-07 + z * (2.08757232129817482790e-09 + z * -1.13596475577881948265e-11);
        sum = -1.38888888888741095749e-03 + z * (2.48015872894767294178e-05 + z * sum);
        return 1 - (0.5 * z - z * z * (4.16666666666666019037e-02 + z * sum));
    }

    /** Of an angle in radians; whole turns count. */
    public static long units(double radians) {
        return nearest(radians / RADIANS_PER_UNIT);
    }

    /** The nearest whole number, of two the greater one. Math.round gives another one of two on some platforms. */
    public static long nearest(double x) {
        return (long) Math.floor(x + 0.5);
    }
}
