package io.github.circles2d.world.model;

/**
 * A damped spring, as joints need it. A spring that is slow against a sub-step follows the exact map of the damped oscillator, once a sub-step: its
 * frequency and its damping are right whatever the step, and under gravity it sags as far as it should. A faster one is an implicit
 * spring, as {@link Softness}, and at most as stiff as steps of this length bear.
 *
 * <p>With w = 2 pi frequency, z the damping ratio and h a sub-step, x'' = -2 z w x' - w^2 x + g has the map v' = a v - b x + c g h,
 * x' = x + h v', with a = exp(-2 z w h), b = (1 + a - 2 exp(-z w h) cos(w h sqrt(1 - z^2))) / h, c = b / (w^2 h).
 */
public final class JointSpring {
    public static final int STRIDE = 4;

    // an exact spring: what it takes of the speed now, and of that as the sub-step began; of the way
    public static final int NOW = 0;
    public static final int BEGUN = 1;
    public static final int WAY = 2;

    // an implicit spring
    public static final int MASS_SCALE = 0;
    public static final int BIAS_RATE = 1;
    public static final int IMPULSE_SCALE = 2;

    /** Of an exact spring: how much of the share of a split joint counts, more than 0 and at most 1; 0 if it is implicit. */
    public static final int EXACT = 3;

    private static final double LEAST_SPLIT = 1e-6;

    /** Angular frequency times h up to which a spring is exact: several that are not damped and faster, at one circle, burst. */
    private static final double MOST_EXACT = 0.55;

    /** Angular frequency times h of the stiffest spring, for the same reason. */
    private static final double STIFFEST = 1;

    private static final double LN_2 = 0.6931471805599453;
    private static final double TURN = 6.283185307179586;

    private JointSpring() {}

    public static int of(int spring) {
        return STRIDE * spring;
    }

    /** Fills a row; in double precision, and by sums, products, quotients and roots alone, which are the same on all platforms. */
    public static void fill(float[] rows, int spring, float frequency, float dampingRatio, float h) {
        int row = of(spring);
        double w = Math.min(TURN * frequency * h, STIFFEST);
        double z = dampingRatio;
        if (w > MOST_EXACT) {
            double a2 = w * (2 * z + w);
            rows[row + MASS_SCALE] = (float) (a2 / (1 + a2));
            rows[row + BIAS_RATE] = (float) (w / (2 * z + w) / h);
            rows[row + IMPULSE_SCALE] = (float) (1 / (1 + a2));
            rows[row + EXACT] = 0f;
            return;
        }
        double a = exp(-2 * z * w);
        double bh = z < 1 ? under(a, z, w) : over(a, z, w);
        double c = w > 1e-6 ? bh / (w * w) : 1;
        rows[row + NOW] = (float) (1 - c);
        rows[row + BEGUN] = (float) (c - a);
        rows[row + WAY] = (float) (bh / h);
        // what it takes of the speed in a sub-step: so many springs, divided by that, are stable at one circle
        rows[row + EXACT] = (float) Math.max(LEAST_SPLIT, Math.min(bh + (1 - a), 1));
    }

    private static double under(double a, double z, double w) {
        double x = w * Math.sqrt(1 - z * z);
        double half = sin(0.5 * x);
        double e = exp(-z * w);
        return (1 - e) * (1 - e) + 4 * e * half * half; // 1 + a - 2 e cos x, without what it would lose
    }

    private static double over(double a, double z, double w) {
        double x = w * Math.sqrt(z * z - 1);
        double slow = exp(x - z * w);
        double fast = exp(-x - z * w);
        return (1 - slow) * (1 - fast);
    }

    /** Of an angle up to 1. */
    private static double sin(double x) {
        double z = x * x;
        double sum = 1;
        for (int k = 17; k > 1; k -= 2) {
            sum = 1 - z * sum / (k * (k - 1));
        }
        return x * sum;
    }

    /** Of a number that is not positive. */
    static double exp(double x) {
        if (x < -700) {
            return 0;
        }
        int halvings = (int) (-x / LN_2 + 0.5);
        double rest = x + halvings * LN_2;
        double sum = 1;
        for (int k = 16; k > 0; k--) {
            sum = 1 + rest * sum / k;
        }
        for (int k = 0; k < halvings; k++) {
            sum *= 0.5;
        }
        return sum;
    }
}
