package io.github.circles2d.reference;

/** Sine and cosine of angles in parts of a turn of which it has 2^32, by polynomials on eighths of a turn (fdlibm). */
final class Angles {
    static final double UNIT = Math.PI / (1L << 31);

    private static final double[] SINE = {
        -1.66666666666666324348e-01,
        8.33333333332248946124e-03,
        -1.98412698298579493134e-04,
        2.75573137070700676789e-06,
        -2.50507602534068634195e-08,
        1.58969099521155010221e-10
    };
    private static final double[] COSINE = {
        4.16666666666666019037e-02,
        -1.38888888888741095749e-03,
        2.48015872894767294178e-05,
        -2.75573143513906633035e-07,
        2.08757232129817482790e-09,
        -1.13596475577881948265e-11
    };

    private Angles() {}

    /** An angle in radians. */
    static long units(double radians) {
        return Math.round(radians / UNIT);
    }

    static double sin(int units) {
        return sin(units, 0);
    }

    static double cos(int units) {
        return sin(units, 1);
    }

    /** Of an angle and so many quarters of a turn. */
    private static double sin(int units, int quarters) {
        int quarter = (int) Math.floor(units / 0x1p30 + 0.5);
        double x = (units - quarter * 0x1p30) * UNIT;
        return switch (Math.floorMod(quarter + quarters, 4)) {
            case 0 -> near(x);
            case 1 -> far(x);
            case 2 -> -near(x);
            default -> -far(x);
        };
    }

    /** The sine of at most an eighth of a turn. */
    private static double near(double x) {
        double z = x * x;
        return x + x * z * sum(SINE, z);
    }

    /** The cosine of at most an eighth of a turn. */
    private static double far(double x) {
        double z = x * x;
        return 1 - (0.5 * z - z * z * sum(COSINE, z));
    }

    /** Of a polynomial, by Horner's rule. */
    private static double sum(double[] factors, double z) {
        double sum = factors[factors.length - 1];
        for (int k = factors.length - 2; k >= 0; k--) {
            sum = factors[k] + z * sum;
        }
        return sum;
    }
}
