package io.github.circles2d.world.jvm.state;

/** By how much the images of a thing are away from it: a period to either side along an axis that wraps, or not at all. */
public final class WrapImages {
    private static final int MOST = 9;

    /** The thing itself is one of them. */
    public int count = 1;

    public final float[] x = new float[MOST];
    public final float[] y = new float[MOST];

    /** Periods are infinite along axes that do not wrap. */
    void set(float periodX, float periodY) {
        int timesX = periodX < Float.POSITIVE_INFINITY ? 1 : 0;
        int timesY = periodY < Float.POSITIVE_INFINITY ? 1 : 0;
        count = 0;
        for (int u = -timesX; u <= timesX; u++) {
            for (int v = -timesY; v <= timesY; v++) {
                x[count] = u == 0 ? 0f : u * periodX;
                y[count++] = v == 0 ? 0f : v * periodY;
            }
        }
    }

    /** How far an image may lie beside its place along an axis, by a rounding. */
    public static float rounding(float way, float place) {
        return way == 0f ? 0f : (Math.abs(place + way) + Math.abs(way)) * 0x1p-22f;
    }
}
