package io.github.circles2d.world.model;

/** A row of floats a kind. A kind as at first has the world's, so its circles move to the bit as without kinds. */
public final class KindMotion {
    /** Speed by gravity in a sub-step. */
    public static final int GAIN_X = 0;

    public static final int GAIN_Y = 1;

    /** Share of velocity that a sub-step leaves. */
    public static final int DAMPING_FACTOR = 2;

    public static final int GREATEST_SPEED = 3;

    /** Path per velocity. */
    public static final int TIME = 4;

    /** How often a sub-step's gain moves a circle in a step. */
    public static final int FALLS = 5;

    /** Kernels read it; the passes of the JVM compute it. */
    private static final int LONGEST_PATH = 6;

    public static final int STRIDE = 8;

    /** Meaningless unless {@link StepConstants#driving}. */
    public final float[] rows = new float[of(PairTable.KINDS)];

    public int version;

    // what the rows follow from
    private float dt;
    private int subSteps;
    private float gravityX;
    private float gravityY;
    private int kindsVersion = -1;

    public static int of(int kind) {
        return STRIDE * kind;
    }

    /** Does nothing if nothing has changed. */
    public void update(StepConstants k, KindField.Values kinds, int ofVersion) {
        if (kindsVersion == ofVersion
                && dt == k.dt
                && subSteps == k.subSteps
                && Float.floatToRawIntBits(gravityX) == Float.floatToRawIntBits(k.gravityX)
                && Float.floatToRawIntBits(gravityY) == Float.floatToRawIntBits(k.gravityY)) {
            return;
        }
        for (int kind = 0; kind < PairTable.KINDS; kind++) {
            set(
                    kind,
                    k,
                    kinds.getFloat(KindField.GRAVITY_SCALE, kind),
                    kinds.getFloat(KindField.DAMPING, kind),
                    kinds.getFloat(KindField.GREATEST_SPEED, kind));
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
        float factor = Velocity.dampingFactor(damping, k.h);
        rows[row + GAIN_X] = Velocity.gravityGain(k.gravityX, gravityScale, k.h);
        rows[row + GAIN_Y] = Velocity.gravityGain(k.gravityY, gravityScale, k.h);
        rows[row + DAMPING_FACTOR] = factor;
        rows[row + GREATEST_SPEED] = greatestSpeed;
        rows[row + TIME] = Velocity.dampedTime(factor, k.subSteps, k.h, k.dt);
        rows[row + FALLS] = Velocity.dampedFalls(factor, k.subSteps);
        rows[row + LONGEST_PATH] = greatestSpeed * k.dt;
    }
}
