package io.github.circles2d;

/**
 * A disc of radius 0.5 and mass 1 on a floor, in a world in which all surfaces are alike. A slope is a floor under gravity that leans.
 * Speeds along the floor are positive to the right, turning anticlockwise. So a disc that rolls to the right turns with a negative speed.
 */
final class SurfaceBall implements AutoCloseable {
    static final float R = 0.5f;
    static final double G = 10;
    static final double DT = 1 / 60.0;

    /** The kind of circles that do not turn. */
    static final int LOCKED = 1;

    final World world;
    final long handle;

    private SurfaceBall(World world, long handle) {
        this.world = world;
        this.handle = handle;
    }

    /** A builder for worlds in which everything has these surfaces; long enough for what rolls to the right. */
    static World.Builder builder(double friction, double rollingResistance, double restitution) {
        World.Builder builder = WorldScenes.jvm()
                .bounds(-100, 0, 500, 60)
                .gravity(0, (float) -G)
                .restitution((float) restitution)
                .friction((float) friction)
                .rollingResistance((float) rollingResistance);
        for (Wall wall : Wall.values()) {
            builder.wallSurface(wall, (float) friction, (float) rollingResistance, 0);
        }
        return builder;
    }

    /** A disc at rest on the floor. */
    static SurfaceBall on(World.Builder builder) {
        return at(builder, R, 0);
    }

    static SurfaceBall at(World.Builder builder, float y, int kind) {
        World world = builder.build();
        world.kind(LOCKED).setInertia(Inertia.NONE);
        return new SurfaceBall(world, world.add(0, y, R, 1, 0, 0, kind));
    }

    void throwWith(double vx, double vy, double surfaceSpeed) {
        world.setVelocity(handle, (float) vx, (float) vy);
        world.setAngularVelocity(handle, (float) (surfaceSpeed / R));
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
