package io.github.circles2d.world.jvm.bodies;

/**
 * A corner of a {@link RigidThing}, against the place of that: a radius around a core, which is a point or an arc, and a cone of normals, anticlockwise from
 * the first to the second one.
 */
final class RigidCorner {
    // ends of the cone; 0 if a normal is in it
    private static final int FROM = 1;
    private static final int TO = 2;

    /** Its number among those of the thing. */
    final int number;

    // as the thing lies unturned
    private float ownX;
    private float ownY;
    private float ownFromX;
    private float ownFromY;
    private float ownToX;
    private float ownToY;

    float radius;

    /** 0 if the core is a point; else the core is an arc so far from the place. */
    float bend;

    // as the thing has turned
    float x;
    float y;
    private float fromX;
    private float fromY;
    private float toX;
    private float toY;

    RigidCorner(int number) {
        this.number = number;
    }

    void set(float px, float py, float r, float sx, float sy, float ex, float ey, float bent) {
        ownX = px;
        ownY = py;
        radius = r;
        ownFromX = sx;
        ownFromY = sy;
        ownToX = ex;
        ownToY = ey;
        bend = bent;
    }

    /** Turns it; within a step only what measures look at: not the cone if it is not bent. */
    void turn(float cos, float sin, boolean all) {
        x = cos * ownX - sin * ownY;
        y = sin * ownX + cos * ownY;
        if (all || bend > 0f) {
            fromX = cos * ownFromX - sin * ownFromY;
            fromY = sin * ownFromX + cos * ownFromY;
            toX = cos * ownToX - sin * ownToY;
            toY = sin * ownToX + cos * ownToY;
        }
    }

    boolean isBent() {
        return bend > 0f;
    }

    boolean isRound() {
        return ownFromX == 0f && ownFromY == 0f;
    }

    /** Whether a direction is in the cone, within a tolerance. */
    boolean isInCone(float nx, float ny, float tolerance) {
        // the cone is half a turn at most: then its middle is 0
        return isRound()
                || fromX * ny - fromY * nx >= -tolerance
                        && toX * ny - toY * nx <= tolerance
                        && (fromX + toX) * nx + (fromY + toY) * ny >= -Math.abs(tolerance);
    }

    /** The end of the cone that is nearer to a direction beyond it; 0 if the cone has the direction. */
    int endOf(float nx, float ny) {
        if (isInCone(nx, ny, 0f)) {
            return 0;
        }
        return fromX * nx + fromY * ny > toX * nx + toY * ny ? FROM : TO;
    }

    /** The normal at an end of the cone. */
    float endX(int end) {
        return end == FROM ? fromX : toX;
    }

    float endY(int end) {
        return end == FROM ? fromY : toY;
    }

    /** The point of the core that is farthest in a direction, which is a unit: by how much its x differs from that of the corner. */
    float bentX(float nx, float ny) {
        if (!isBent()) {
            return 0f;
        }
        int end = endOf(nx, ny);
        return bend * (end == 0 ? nx : endX(end));
    }

    float bentY(float nx, float ny) {
        if (!isBent()) {
            return 0f;
        }
        int end = endOf(nx, ny);
        return bend * (end == 0 ? ny : endY(end));
    }

    /** Whether it goes on at the begin of its cone as an arc, which ends there. */
    boolean comesFrom(RigidCorner arc) {
        return goesOnAs(arc) && ownFromX == arc.ownToX && ownFromY == arc.ownToY;
    }

    /** The same at the end of its cone. */
    boolean goesTo(RigidCorner arc) {
        return goesOnAs(arc) && ownToX == arc.ownFromX && ownToY == arc.ownFromY;
    }

    /** Whether it may be an end of an arc, or a part of it. */
    private boolean goesOnAs(RigidCorner arc) {
        return arc.isBent() && arc != this && (bend + radius == 0f || ownX == arc.ownX && ownY == arc.ownY);
    }
}
