package io.github.circles2d.toy;

import io.github.circles2d.Edge;
import io.github.circles2d.World;

/**
 * What is usual in a world: tools and colours take their measures from it.
 *
 * @param radius    the mean radius of circles that are not static, or the nearest of which the world takes somewhat larger and smaller ones
 * @param density   mass over the square of the radius, on an average
 * @param highSpeed a speed that is high in this world
 */
record Grain(float radius, float density, float highSpeed) {
    /** The size of circles in a world that has none, as a part of its extent. */
    private static final double PART = 1 / 180.0;

    // Of the extent of the world.
    private static final float LEAST = 0x1p-19f;
    private static final float MOST = 1 / 16f;

    static Grain of(World world, View view) {
        float[] circles = new float[4 * world.size()];
        float[] velocities = new float[2 * world.size()];
        world.read(circles);
        world.readVelocities(velocities);
        double radii = 0;
        double masses = 0;
        double squares = 0;
        double speeds = 0;
        int count = 0;
        int moving = 0;
        for (int k = 0; k < world.size(); k++) {
            float radius = circles[4 * k + 2];
            float mass = circles[4 * k + 3];
            if (mass < Float.POSITIVE_INFINITY) {
                radii += radius;
                masses += mass;
                squares += (double) radius * radius;
                double speed = Math.hypot(velocities[2 * k], velocities[2 * k + 1]);
                speeds += speed;
                moving += speed > 0 ? 1 : 0;
                count++;
            }
        }
        double extent = Math.max((double) view.maxX() - view.minX(), (double) view.maxY() - view.minY());
        double fall = Math.sqrt(2 * extent * Math.hypot(world.gravityX(), world.gravityY()));
        double high = moving == 0 ? fall : Math.max(fall, 2 * speeds / moving);
        return new Grain(
                allowed(world, (float) (count == 0 ? extent * PART : radii / count)),
                (float) (count == 0 ? 1 : masses / squares),
                (float) (high > 0 ? high : extent / 4));
    }

    private static float allowed(World world, float radius) {
        float width = world.maxX() - world.minX();
        float height = world.maxY() - world.minY();
        float x = Math.max(Math.abs(world.minX()), Math.abs(world.maxX()));
        float y = Math.max(Math.abs(world.minY()), Math.abs(world.maxY()));
        float least = Math.max(Math.max(x, y), Math.max(width, height)) * LEAST;
        float most = Math.min(
                world.edgeX() == Edge.OPEN ? Float.POSITIVE_INFINITY : width * MOST,
                world.edgeY() == Edge.OPEN ? Float.POSITIVE_INFINITY : height * MOST);
        return Math.max(least, Math.min(radius, most));
    }

    /** The mass of a circle of this world's stuff. */
    float mass(float ofRadius) {
        return Math.min(Math.max(density * ofRadius * ofRadius, 1e-9f), 1e9f);
    }
}
