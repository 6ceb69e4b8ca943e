package io.github.circles2d;

/** A disc of radius 0.5 and mass 1, without walls; terrain has the friction and the restitution that the disc has. */
final class TerrainBall extends Ball {
    private TerrainBall(World world, double x, double y, double mass, int kind) {
        super(world, x, y, mass, kind);
    }

    /** A builder for worlds in which everything has these surfaces. */
    static World.Builder builder(double gravity, double friction, double restitution) {
        return WorldScenes.jvm()
                .bounds(-100, -100, 500, 100)
                .edges(Edge.OPEN, Edge.OPEN)
                .gravity(0, (float) -gravity)
                .restitution((float) restitution)
                .friction((float) friction);
    }

    static TerrainBall at(double x, double y, World.Builder builder) {
        return of(x, y, 1, 0, builder);
    }

    static TerrainBall of(double x, double y, double mass, int kind, World.Builder builder) {
        return new TerrainBall(builder.build(), x, y, mass, kind);
    }

    /** A ground, by the ends of its lines from right to left: a chain, or loose segments. */
    TerrainBall on(boolean chain, float... points) {
        ground(world, chain, points);
        return this;
    }

    static void ground(World world, boolean chain, float... points) {
        if (chain) {
            world.terrain().addChain(Chain.of(points));
            return;
        }
        for (int k = 0; k + 3 < points.length; k += 2) {
            world.terrain().addSegment(points[k], points[k + 1], points[k + 2], points[k + 3]);
        }
    }

    /** Rolls along the ground. */
    TerrainBall roll(double v) {
        return slide(v, -v / R);
    }

    TerrainBall slide(double v, double angularVelocity) {
        world.setVelocity(handle, (float) v, 0);
        world.setAngularVelocity(handle, (float) angularVelocity);
        return this;
    }

    /** Of the motion and of the turning. */
    double kineticEnergy() {
        return 0.5 * speed() * speed() + 0.25 * surfaceSpeed() * surfaceSpeed();
    }
}
