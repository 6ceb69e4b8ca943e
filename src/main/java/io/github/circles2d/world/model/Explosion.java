package io.github.circles2d.world.model;

/** The host alone computes explosions. */
public final class Explosion {
    private float x;
    private float y;
    private float radius;
    private float impulse;
    private float falloff;
    private float periodX;
    private float periodY;

    // of a circle
    private float dx;

    private float dy;
    private float impulseX;
    private float impulseY;

    public Explosion() {}

    /** Impulses are whole up to a distance within of a circle's edge, and fall to 0 over beyond. */
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

    /** Whether a circle gets {@link #impulseX} and {@link #impulseY}. */
    public boolean reaches(float[] circles, int row) {
        dx = CircleMath.shortWay(circles[row + CircleRow.X] - x, periodX);
        dy = CircleMath.shortWay(circles[row + CircleRow.Y] - y, periodY);
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

    public float x() {
        return x;
    }

    public float y() {
        return y;
    }

    /** How far from it the centre of the circle is. */
    public float dx() {
        return dx;
    }

    public float dy() {
        return dy;
    }

    public float impulseX() {
        return impulseX;
    }

    public float impulseY() {
        return impulseY;
    }
}
