package io.github.circles2d;

/**
 * A disc of radius 0.5 and mass 1 on a floor, in a world in which all surfaces are alike. A slope is a floor under gravity that leans.
 * Speeds along the floor are positive to the right, turning anticlockwise. So a disc that rolls to the right turns with a negative speed.
 */
final class SurfaceBall extends Ball {
    private SurfaceBall(World world, float y, int kind) {
        super(world, 0, y, 1, kind);
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
        return new SurfaceBall(builder.build(), y, kind);
    }

    void throwWith(double vx, double vy, double surfaceSpeed) {
        world.setVelocity(handle, (float) vx, (float) vy);
        world.setAngularVelocity(handle, (float) (surfaceSpeed / R));
    }
}
