package io.github.circles2d.playground;

/** Colours between given ones, by a number from 0 to 1, and the darker colours of their rims. */
final class Ramp {
    private static final int SHADES = 256;
    private static final double RIM = 0.62;
    private static final double MARK = 0.3;

    private final int[] colours = new int[SHADES];

    Ramp(int... stops) {
        for (int k = 0; k < SHADES; k++) {
            double place = (double) k / (SHADES - 1) * (stops.length - 1);
            int stop = Math.min((int) place, stops.length - 2);
            colours[k] = mix(stops[stop], stops[stop + 1], place - stop);
        }
    }

    /** The colour of a number; those below 0 and above 1 have the colours of the ends, and NaN that of 0. */
    int colour(double share) {
        return colours[(int) (Math.min(Math.max(share, 0), 1) * (SHADES - 1) + 0.5)];
    }

    static int rim(int rgb) {
        return mix(0, rgb, RIM);
    }

    /** The colour of a mark on a circle. */
    static int mark(int rgb) {
        return mix(0, rgb, MARK);
    }

    static int mix(int from, int to, double share) {
        int mixed = 0;
        for (int shift = 0; shift <= 16; shift += 8) {
            int a = from >> shift & 0xff;
            int b = to >> shift & 0xff;
            mixed |= (int) Math.round(a + (b - a) * share) << shift;
        }
        return mixed;
    }
}
