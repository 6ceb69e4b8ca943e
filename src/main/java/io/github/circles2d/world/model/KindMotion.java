package io.github.circles2d.world.model;

/**
 * What moves the circles of a kind in a step: a row of floats each. A kind as at first has the numbers of the world, so its circles
 * move to the bit as without kinds.
 */
public final class KindMotion {
    /** Element: gain of speed by gravity in a sub-step. */
    public static final int GAIN_X = 0;

    public static final int GAIN_Y = 1;

    /** Element: what a sub-step leaves of a velocity. */
    public static final int DAMPING_FACTOR = 2;

    public static final int GREATEST_SPEED = 3;

    /** Element: path per velocity; the length of the step without damping. */
    public static final int TIME = 4;

    /** Element: how often the gain of a sub-step moves a circle in a step. */
    public static final int FALLS = 5;

    public static final int LONGEST_PATH = 6;

    public static final int STRIDE = 8;

    /** Of no meaning in a step that does not read them. */
    public final float[] rows = new float[of(PairTable.KINDS)];

    public int version;

    // What the rows have been computed from.
    private float dt;
    private int subSteps;
    private float gravityX;
    private float gravityY;
    private int kindsVersion = -1;

    public interface Values {
        float gravityScale(int kind);

        /** 1/s */
        float damping(int kind);

        /** May be infinite. */
        float greatestSpeed(int kind);
    }

    public static int of(int kind) {
        return STRIDE * kind;
    }

    /** Does nothing if what the rows follow from is the same. */
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
