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

    /** All walls and circles with the same. */
    public static Surfaces of(float friction, float rollingResistance) {
        float[] wall = {friction, rollingResistance, 0f};
        return new Surfaces(friction, rollingResistance, new float[][] {wall, wall, wall, wall});
    }

    private static final long SURFACES = 0x7375726661636573L;

    /** The world's part of the hash; 0 if nothing grips. */
    long hash() {
        long h = ReferenceWorld.absorb(SURFACES, friction, rollingResistance);
        float sum = friction + rollingResistance;
        for (float[] wall : walls) {
            h = ReferenceWorld.absorb(h, wall);
            sum += wall[0] + wall[1] + Math.abs(wall[2]);
        }
        return sum == 0f ? 0 : h;
    }

    public Surfaces withWall(int wall, float itsFriction, float itsRollingResistance, float belt) {
        float[][] next = walls.clone();
        next[wall] = new float[] {itsFriction, itsRollingResistance, belt};
        return new Surfaces(friction, rollingResistance, next);
    }

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

    /** As calls take it: to the right of the wall's normal. */
    public float beltAsCalled(int wall) {
        return turned(wall, walls[wall][2]);
    }

    /** From the sign of calls to that of the state, or back: the left and the upper wall have their right towards lesser coordinates. */
    static float turned(int wall, float belt) {
        return wall == 0 || wall == 3 ? 0f - belt : belt;
    }
}
