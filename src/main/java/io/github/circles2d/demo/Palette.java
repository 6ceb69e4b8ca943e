package io.github.circles2d.demo;

import java.awt.Color;

/** The colours of discs by mass: one hue, the brighter the heavier. */
final class Palette {
    /** The masses of the thesis's scene; lighter and heavier circles get the colour of the nearer end. */
    private static final float LIGHTEST = 1;

    private static final float HEAVIEST = 10;

    private static final int SHADES = 256;
    private static final int STEPS = 8;
    private static final float RIM = 0.55f;
    private static final int[][] RAMPS = ramps();

    private Palette() {}

    /** 0 for the lightest circle, 255 for the heaviest. */
    static int shade(float mass) {
        float share = (mass - LIGHTEST) / (HEAVIEST - LIGHTEST);
        return (int) (Math.min(Math.max(share, 0), 1) * (SHADES - 1) + 0.5f);
    }

    /**
     * The colours of a disc of this mass from its rim, which is darker so that discs on top of each other can be told
     * apart, inwards; not to be written.
     */
    static int[] ramp(float mass) {
        return RAMPS[shade(mass)];
    }

    private static int[][] ramps() {
        int[][] ramps = new int[SHADES][STEPS + 1];
        for (int shade = 0; shade < SHADES; shade++) {
            float share = shade / (SHADES - 1f);
            for (int k = 0; k <= STEPS; k++) {
                float dimming = RIM + (1 - RIM) * k / STEPS;
                ramps[shade][k] =
                        Color.HSBtoRGB(0.56f, 0.55f - 0.4f * share, dimming * (0.28f + 0.72f * share)) & 0xffffff;
            }
        }
        return ramps;
    }
}
