package io.github.circles2d.world.model;

/** What decides whether circles of a kind fall asleep: a row of floats a kind. Meaningless unless {@link StepConstants#sleeping}. */
public final class KindSleep {
    /** 1/s */
    public static final int DAMPING = 0;

    /** Not 0 if they never do. */
    public static final int AWAKE = 1;

    public static final int STRIDE = 2;

    public final float[] rows = new float[of(PairTable.KINDS)];

    public int version;

    private int kindsVersion = -1;

    public static int of(int kind) {
        return STRIDE * kind;
    }

    /** Does nothing if nothing has changed. */
    public void update(KindField.Values kinds, int ofVersion) {
        if (kindsVersion == ofVersion) {
            return;
        }
        for (int kind = 0; kind < PairTable.KINDS; kind++) {
            rows[of(kind) + DAMPING] = kinds.getFloat(KindField.DAMPING, kind);
            rows[of(kind) + AWAKE] = kinds.get(KindField.AWAKE, kind);
        }
        kindsVersion = ofVersion;
        version++;
    }
}
