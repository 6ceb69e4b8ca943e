package io.github.circles2d;

/** A disc of radius 0.5 in a world that is there for it. */
class Ball implements AutoCloseable {
    static final float R = 0.5f;
    static final double G = 10;
    static final double DT = 1 / 60.0;

    /** The kind of circles that do not turn. */
    static final int LOCKED = 1;

    final World world;
    final long handle;

    /** A disc at rest. */
    Ball(World world, double x, double y, double mass, int kind) {
        this.world = world;
        world.kind(LOCKED).setInertia(Inertia.NONE);
        handle = world.add((float) x, (float) y, R, (float) mass, 0, 0, kind);
    }

    void step(int steps) {
        world.step((float) DT, steps);
    }

    double x() {
        return world.x(handle);
    }

    double y() {
        return world.y(handle);
    }

    double vx() {
        return world.vx(handle);
    }

    double vy() {
        return world.vy(handle);
    }

    double speed() {
        return Math.hypot(vx(), vy());
    }

    /** The speed of the surface against the centre, positive anticlockwise. */
    double surfaceSpeed() {
        return world.angularVelocity(handle) * R;
    }

    @Override
    public void close() {
        world.close();
    }
}
