package io.github.circles2d.world.model;

/** What pieces of each kind have besides their surface: a row of floats a kind. */
public final class KindTerrain {
    /** Of the kind, or 0. */
    public static final int RESTITUTION = 0;

    /** 1 if circles pass from behind. */
    public static final int ONE_WAY = 1;

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
            float restitution = kinds.getFloat(KindField.RESTITUTION, kind);
            rows[of(kind) + RESTITUTION] = restitution > 0f ? restitution : 0f;
            rows[of(kind) + ONE_WAY] = kinds.get(KindField.ONE_WAY, kind);
        }
        kindsVersion = ofVersion;
        version++;
    }
}
