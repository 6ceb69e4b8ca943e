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

    public interface Values {
        /** 1/s */
        float damping(int kind);

        boolean sleeps(int kind);
    }

    public static int of(int kind) {
        return STRIDE * kind;
    }

    /** Does nothing if nothing has changed. */
    public void update(Values kinds, int ofVersion) {
        if (kindsVersion == ofVersion) {
            return;
        }
        for (int kind = 0; kind < PairTable.KINDS; kind++) {
            rows[of(kind) + DAMPING] = kinds.damping(kind);
            rows[of(kind) + AWAKE] = kinds.sleeps(kind) ? 0f : 1f;
        }
        kindsVersion = ofVersion;
        version++;
    }
}
