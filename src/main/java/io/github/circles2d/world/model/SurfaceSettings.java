package io.github.circles2d.world.model;

import java.util.Arrays;

/**
 * The friction and rolling resistance of circles that have none of their own, nor by their kind, and the surfaces of walls. A value; {@link
 * WallMotion#of} numbers the walls.
 */
public final class SurfaceSettings {
    /** Nothing grips. */
    public static final SurfaceSettings NONE = new SurfaceSettings(0f, 0f, new float[3 * WallMotion.COUNT]);

    /** Floats: two of circles, then three of each wall. */
    public static final int VALUES = 2 + 3 * WallMotion.COUNT;

    /** Of circles that have none of their own, nor by their kind. */
    public final float friction;

    public final float rollingResistance;

    /** By wall: friction, rolling resistance, belt speed. */
    private final float[] walls;

    private SurfaceSettings(float friction, float rollingResistance, float[] walls) {
        this.friction = Limits.friction(friction) + 0f; // one zero, since bits are compared
        this.rollingResistance = Limits.rollingResistance(rollingResistance) + 0f;
        this.walls = walls;
    }

    public float wallFriction(int wall) {
        return walls[3 * wall];
    }

    public float wallRollingResistance(int wall) {
        return walls[3 * wall + 1];
    }

    /** Of the surface, along the axis that the wall runs along; positive towards greater coordinates. */
    public float wallBelt(int wall) {
        return walls[3 * wall + 2];
    }

    public SurfaceSettings ofCircles(float itsFriction, float itsRollingResistance) {
        return new SurfaceSettings(itsFriction, itsRollingResistance, walls);
    }

    public SurfaceSettings withWall(int wall, float itsFriction, float itsRollingResistance, float belt) {
        float[] next = walls.clone();
        next[3 * wall] = Limits.friction(itsFriction) + 0f;
        next[3 * wall + 1] = Limits.rollingResistance(itsRollingResistance) + 0f;
        next[3 * wall + 2] = Limits.beltSpeed(belt) + 0f;
        return new SurfaceSettings(friction, rollingResistance, next);
    }

    /** Value number k of {@link #VALUES}. */
    public float value(int k) {
        return k == 0 ? friction : k == 1 ? rollingResistance : walls[k - 2];
    }

    /** By bits; no {@code equals}, as {@link Bounds#differs}. */
    public boolean differs(SurfaceSettings other) {
        return Float.floatToRawIntBits(friction) != Float.floatToRawIntBits(other.friction)
                || Float.floatToRawIntBits(rollingResistance) != Float.floatToRawIntBits(other.rollingResistance)
                || !Arrays.equals(walls, other.walls);
    }

    /** Whether circles may grip, roll or be carried by what is set here. */
    public boolean any() {
        return differs(NONE);
    }

    /**
     * The sign of the belt of circles and pieces of a kind. Callers give the speed to the right of the surface's normal, so that a floor carries to
     * greater x. The engine, its snapshots and its logs have that of kinds anticlockwise, as angular velocities, and that of walls towards greater
     * coordinates. This and {@link #beltOfWall} are their own inverses, and have no -0, since bits are compared.
     */
    public static float beltOfKind(float speed) {
        return 0f - Limits.beltSpeed(speed);
    }

    /** The same of a wall, by {@link WallMotion#of}: the right of the normal of the left and of the upper one is towards lesser coordinates. */
    public static float beltOfWall(int wall, float speed) {
        return wall == 0 || wall == 3 ? 0f - Limits.beltSpeed(speed) : Limits.beltSpeed(speed) + 0f;
    }
}
