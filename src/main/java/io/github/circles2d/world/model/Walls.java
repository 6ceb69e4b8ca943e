package io.github.circles2d.world.model;

/** A side is 1 for the lower wall of an axis, -1 for the upper. */
public final class Walls {
    private Walls() {}

    /** Of the nearer wall. */
    public static float wallSide(float x, float min, float max) {
        return x - min <= max - x ? 1f : -1f;
    }

    public static float wallGap(float base, float displacement, float r, float side, float min, float max) {
        return side > 0f ? ((base - min) - r) + displacement : ((max - base) - r) - displacement;
    }

    /** Circles larger than a wall's way are left to the step. */
    public static float marginAtWall(float from, float to, float margin) {
        return from == to || Math.abs(to - from) > margin ? margin : 0f;
    }

    public static float wallImpulse(float signed, float side) {
        return CircleMath.max(side * signed, 0f);
    }

    /** Only the nearer wall is a constraint; in a narrow tube a circle is at both. */
    public static float stopAtFarWall(float v, float displacement, float kept, float side) {
        return (side > 0f ? kept < displacement : kept > displacement) ? 0f : v;
    }

    /** The part of the tangent along a wall. */
    public static float tangentAlong(int axis, float side) {
        return axis == 0 ? side : -side;
    }
}
