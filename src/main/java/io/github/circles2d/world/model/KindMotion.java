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

    /** The rows of all kinds; set by {@link #update}, and of no meaning in a step that does not read them. */
    public final float[] rows = new float[of(PairTable.KINDS)];

    /** Counts the changes of {@link #rows}. */
    public int version;

    // What the rows have been computed from.
    private float dt;
    private int subSteps;
    private float gravityX;
    private float gravityY;
    private int kindsVersion = -1;

    /** What the kinds say of the motion of their circles. */
    public interface Values {
        /** What gravity is multiplied by. */
        float gravityScale(int kind);

        /** Damping, 1/s. */
        float damping(int kind);

        /** Greatest speed, which may be infinite. */
        float greatestSpeed(int kind);
    }

    /** Where the row of a kind begins. */
    public static int of(int kind) {
        return STRIDE * kind;
    }

    /** Computes the rows, unless they are of the same constants and the same version of the kinds. */
    public void update(StepConstants k, Values kinds, int ofVersion) {
        if (kindsVersion == ofVersion
                && dt == k.dt
                && subSteps == k.subSteps
                && Float.floatToRawIntBits(gravityX) == Float.floatToRawIntBits(k.gravityX)
                && Float.floatToRawIntBits(gravityY) == Float.floatToRawIntBits(k.gravityY)) {
            return;
        }
        for (int kind = 0; kind < PairTable.KINDS; kind++) {
            set(kind, k, kinds.gravityScale(kind), kinds.damping(kind), kinds.greatestSpeed(kind));
        }
        dt = k.dt;
        subSteps = k.subSteps;
        gravityX = k.gravityX;
        gravityY = k.gravityY;
        kindsVersion = ofVersion;
        version++;
    }

    private void set(int kind, StepConstants k, float gravityScale, float damping, float greatestSpeed) {
        int row = of(kind);
        float factor = 1f / (1f + damping * k.h);
        rows[row + GAIN_X] = Motion.limitSpeed(k.gravityX * gravityScale) * k.h;
        rows[row + GAIN_Y] = Motion.limitSpeed(k.gravityY * gravityScale) * k.h;
        rows[row + DAMPING_FACTOR] = factor;
        rows[row + GREATEST_SPEED] = greatestSpeed;
        rows[row + TIME] = k.dt;
        rows[row + FALLS] = StepConstants.falls(k.subSteps);
        rows[row + LONGEST_PATH] = greatestSpeed * k.dt;
        if (factor != 1f) {
            float power = 1f;
            float powers = 0f;
            float falls = 0f;
            for (int subStep = 0; subStep < k.subSteps; subStep++) {
                power *= factor;
                powers += power;
                falls += powers;
            }
            rows[row + TIME] = k.h * powers;
            rows[row + FALLS] = falls;
        }
    }
}
