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

    // of a circle or a body
    private float dx;

    private float dy;
    private float impulseX;
    private float impulseY;

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
        float share = share(CircleMath.max(distance - circles[row + CircleRow.RADIUS], 0f));
        if (share < 0f || distance == 0f || CircleMath.inverseMass(circles[row + CircleRow.MASS]) == 0f) {
            return false;
        }
        impulseX = impulse * share * (dx / distance);
        impulseY = impulse * share * (dy / distance);
        return true;
    }

    /**
     * Whether a body gets {@link #impulseX} and {@link #impulseY} at the nearest point of its outline, which is so far away, negative if the explosion is
     * inside. The normal leads out of the body there.
     */
    public boolean reaches(float distance, float pointX, float pointY, float normalX, float normalY) {
        dx = pointX - x;
        dy = pointY - y;
        float share = share(CircleMath.max(distance, 0f));
        impulseX = impulse * share * (0f - normalX);
        impulseY = impulse * share * (0f - normalY);
        return share >= 0f;
    }

    /** Of the impulse; negative if an edge so far away gets none. */
    private float share(float gap) {
        float reach = radius + falloff;
        if (gap <= radius) {
            return 1f;
        }
        return gap < reach ? CircleMath.min((reach - gap) / falloff, 1f) : -1f;
    }

    /** No edge farther away gets an impulse. */
    public float reach() {
        return radius + falloff;
    }

    public float x() {
        return x;
    }

    public float y() {
        return y;
    }

    /** How far from it the centre of the circle is, or the point of the outline. */
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
