package io.github.circles2d.world.model;

/**
 * What moves the circles of a kind in a step: a row of floats for each kind. The host computes the rows once, and every back end gets
 * the bits. A kind that is as at first has the numbers of the world, so its circles move to the bit as if there were no kinds.
 */
public final class KindMotion {
    /** Element: gain of speed by gravity in a sub-step, along x. */
    public static final int GAIN_X = 0;

    /** Element: the same along y. */
    public static final int GAIN_Y = 1;

    /** Element: what is left of a velocity after the damping of a sub-step, as a factor. */
    public static final int DAMPING_FACTOR = 2;

    /** Element: greatest speed. */
    public static final int GREATEST_SPEED = 3;

    /** Element: the time in which a velocity makes its part of a path; the length of the step without damping. */
    public static final int TIME = 4;

    /** Element: how many times a gain of a sub-step moves a circle in a step. */
    public static final int FALLS = 5;

    /** Element: longest path. */
    public static final int LONGEST_PATH = 6;

    /** Floats of a row; the last one is of no meaning. */
    public static final int STRIDE = 8;

    private KindMotion() {}

    /** Where the row of a kind begins. */
    public static int of(int kind) {
        return STRIDE * kind;
    }

    /**
     * Sets the row of a kind.
     *
     * @param to the rows
     * @param kind its number
     * @param k the numbers of the step without kinds
     * @param gravityX gravity
     * @param gravityY gravity
     * @param gravityScale of the kind
     * @param damping of the kind, 1/s
     * @param greatestSpeed of the kind
     */
    static void set(
            float[] to,
            int kind,
            StepConstants k,
            float gravityX,
            float gravityY,
            float gravityScale,
            float damping,
            float greatestSpeed) {
        int row = of(kind);
        float factor = 1f / (1f + damping * k.h);
        to[row + GAIN_X] = CircleMath.limitSpeed(gravityX * gravityScale) * k.h;
        to[row + GAIN_Y] = CircleMath.limitSpeed(gravityY * gravityScale) * k.h;
        to[row + DAMPING_FACTOR] = factor;
        to[row + GREATEST_SPEED] = greatestSpeed;
        to[row + TIME] = k.dt;
        to[row + FALLS] = StepConstants.falls(k.subSteps);
        to[row + LONGEST_PATH] = greatestSpeed * k.dt;
        if (factor != 1f) {
            float power = 1f;
            float powers = 0f;
            float falls = 0f;
            for (int subStep = 0; subStep < k.subSteps; subStep++) {
                power *= factor;
                powers += power;
                falls += powers;
            }
            to[row + TIME] = k.h * powers;
            to[row + FALLS] = falls;
        }
    }
}
