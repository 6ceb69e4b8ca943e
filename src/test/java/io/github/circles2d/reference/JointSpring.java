package io.github.circles2d.reference;

/**
 * A spring of a joint, for sub-steps of a length: an exact one, or an implicit one.
 *
 * @param exact whether it is exact
 * @param now of an exact one, what the speed counts
 * @param begun what the speed counts with which the sub-step began
 * @param way what the way counts
 * @param split of an exact one, how much of the share of a split joint counts
 * @param soft an implicit one
 */
record JointSpring(boolean exact, float now, float begun, float way, float split, JointSoftness soft) {
    private static final double FULL_TURN = 6.283185307179586;
    private static final double LN_2 = 0.6931471805599453;
    private static final double GREATEST_EXACT = 0.55;

    static JointSpring of(float frequency, float damping, float h) {
        double w = Math.min(FULL_TURN * frequency * h, 1);
        double z = damping;
        if (w > GREATEST_EXACT) {
            double a2 = w * (2 * z + w);
            float rate = (float) (w / (2 * z + w) / h);
            JointSoftness soft = new JointSoftness((float) (a2 / (1 + a2)), rate, (float) (1 / (1 + a2)));
            return new JointSpring(false, 0f, 0f, 0f, 0f, soft);
        }
        double a = exp(-2 * z * w);
        double b;
        if (z < 1) {
            double e = exp(-z * w);
            double half = sine(0.5 * (w * Math.sqrt(1 - z * z)));
            b = (1 - e) * (1 - e) + 4 * e * half * half;
        } else {
            double x = w * Math.sqrt(z * z - 1);
            b = (1 - exp(x - z * w)) * (1 - exp(-x - z * w));
        }
        double c = w > 1e-6 ? b / (w * w) : 1;
        float split = (float) Math.max(1e-6, Math.min(b + (1 - a), 1));
        return new JointSpring(true, (float) (1 - c), (float) (c - a), (float) (b / h), split, null);
    }

    /** Nine terms of the series. */
    private static double sine(double x) {
        double sum = 1;
        for (int n = 17; n >= 3; n -= 2) {
            sum = 1 - x * x * sum / (n * (n - 1));
        }
        return x * sum;
    }

    /** Sixteen terms of the series for what is left of whole powers of two. */
    private static double exp(double x) {
        if (x < -700) {
            return 0;
        }
        int halvings = (int) Math.floor(0.5 - x / LN_2);
        double rest = x + halvings * LN_2;
        double sum = 1;
        for (int n = 16; n >= 1; n--) {
            sum = 1 + rest * sum / n;
        }
        return Math.scalb(sum, -halvings);
    }
}
