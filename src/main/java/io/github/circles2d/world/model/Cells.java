package io.github.circles2d.world.model;

public final class Cells {
    /** Of an axis. No place inside of walls is so far; differences and counts of cells stay ints. */
    static final float MOST = 0x1p30f;

    private Cells() {}

    /** Class k has radii in (rmax / 2^(k+1), rmax / 2^k], the last all smaller ones. */
    public static int sizeClass(float r, float rmax) {
        int k = 0;
        float half = rmax * 0.5f;
        while (r <= half && k < GridLevels.COUNT - 1) {
            k++;
            half *= 0.5f;
        }
        return k;
    }

    /** Never falls where x grows. */
    public static int cell(float x, float min, float inverseEdge) {
        return (int) CircleMath.clamp((x - min) * inverseEdge, 0f, MOST);
    }

    private static int mixBits(int h) {
        h = (h ^ (h >>> 16)) * 0x85ebca6b;
        h = (h ^ (h >>> 13)) * 0xc2b2ae35;
        return h ^ (h >>> 16);
    }

    /** The finalizer of MurmurHash3, twice. */
    public static int pairHash(int lo, int hi) {
        return mixBits(mixBits(lo) + hi);
    }

    /** Contacts grow with the circles in a point, not with their square. */
    public static boolean keeps(int hash, int fewer) {
        return fewer <= Tuning.CROWD || (hash >>> 16) * (long) fewer < (long) Tuning.CROWD << 16;
    }

    /** Of circles with one centre; not of unit length, never zero. */
    public static float partingX(int hash) {
        return (float) (hash & 1023) - 511.5f;
    }

    public static float partingY(int hash) {
        return (float) ((hash >>> 10) & 1023) - 511.5f;
    }
}
