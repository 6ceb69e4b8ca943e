package io.github.circles2d.reference;

/**
 * What the walls of a world touch circles with, and what circles have of which neither they nor their kinds say more.
 *
 * @param friction of circles
 * @param rollingResistance of circles
 * @param walls left, right, lower, upper: the friction, the rolling resistance and the speed of the belt of each
 */
public record Surfaces(float friction, float rollingResistance, float[][] walls) {
    /** Nothing grips. */
    public static final Surfaces NONE = new Surfaces(0f, 0f, new float[4][3]);

    float wallFriction(int wall) {
        return walls[wall][0];
    }

    float wallRollingResistance(int wall) {
        return walls[wall][1];
    }

    /** Positive towards greater coordinates. */
    float belt(int wall) {
        return walls[wall][2];
    }
}
