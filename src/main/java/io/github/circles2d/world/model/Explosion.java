package io.github.circles2d.world.model;

/**
 * Impulses away from a point. The host alone computes them, from positions that are the same everywhere, so they have no second text
 * in OpenCL C.
 */
public final class Explosion {
    private float x;
    private float y;
    private float radius;
    private float impulse;
    private float falloff;
    private float periodX;
    private float periodY;
    private float impulseX;
    private float impulseY;

    /** Without an impulse. */
    public Explosion() {}

    /**
     * Checks and takes the numbers of an explosion.
     *
     * @param px x of the point
     * @param py y of the point
     * @param within how far from the point a circle's edge may be for the whole impulse
     * @param strength the impulse
     * @param beyond over which distance the impulse then falls to 0
     * @param bounds the arena: where an axis wraps, impulses go the short way round
     */
    public void set(float px, float py, float within, float strength, float beyond, Bounds bounds) {
        Limits.within("x of the explosion", px, -Limits.COORDINATE, Limits.COORDINATE);
        Limits.within("y of the explosion", py, -Limits.COORDINATE, Limits.COORDINATE);
        Limits.within("radius of the explosion", within, 0, Limits.EXPLOSION);
        Limits.within("impulse of the explosion", strength, -Limits.IMPULSE, Limits.IMPULSE);
        Limits.within("falloff of the explosion", beyond, 0, Limits.EXPLOSION);
        x = bounds.placeX(px);
        y = bounds.placeY(py);
        periodX = bounds.periodX();
        periodY = bounds.periodY();
        radius = within;
        impulse = strength;
        falloff = beyond;
    }

    /**
     * Whether a circle gets an impulse; then {@link #impulseX} and {@link #impulseY} have it.
     *
     * @param circles rows of x, y, radius and mass
     * @param row where the circle's row begins
     * @return false for circles out of reach, for static ones, and if the centre is the point itself
     */
    public boolean reaches(float[] circles, int row) {
        float dx = Wrapping.shortWay(circles[row + CircleRow.X] - x, periodX);
        float dy = Wrapping.shortWay(circles[row + CircleRow.Y] - y, periodY);
        float distance = CircleMath.length(dx, dy);
        float gap = CircleMath.max(distance - circles[row + CircleRow.RADIUS], 0f);
        float reach = radius + falloff;
        boolean whole = gap <= radius;
        if (!whole && !(gap < reach) || distance == 0f || CircleMath.inverseMass(circles[row + CircleRow.MASS]) == 0f) {
            return false;
        }
        float share = whole ? 1f : CircleMath.min((reach - gap) / falloff, 1f);
        impulseX = impulse * share * (dx / distance);
        impulseY = impulse * share * (dy / distance);
        return true;
    }

    /** The impulse along x of the circle that was asked about last. */
    public float impulseX() {
        return impulseX;
    }

    /** The impulse along y of the circle that was asked about last. */
    public float impulseY() {
        return impulseY;
    }
}
