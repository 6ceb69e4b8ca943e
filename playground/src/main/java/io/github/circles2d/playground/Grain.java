package io.github.circles2d.playground;

import io.github.circles2d.World;

/**
 * What is usual in a world: tools and colours take their measures from it.
 *
 * @param radius    the mean radius of circles that are not static
 * @param density   mass over the square of the radius, on an average
 * @param highSpeed a speed that is high in this world
 */
record Grain(float radius, float density, float highSpeed) {
    /** The size of circles in a world that has none, as a part of its extent. */
    private static final double PART = 1 / 110.0;

    static Grain of(World world) {
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
            float r = circles[4 * k + 2];
            float m = circles[4 * k + 3];
            if (m < Float.POSITIVE_INFINITY) {
                radii += r;
                masses += m;
                squares += (double) r * r;
                double speed = Math.hypot(velocities[2 * k], velocities[2 * k + 1]);
                speeds += speed;
                moving += speed > 0 ? 1 : 0;
                count++;
            }
        }
        Arena arena = Arena.of(world);
        double extent = Math.min(arena.width(), arena.height());
        double gravity = Math.hypot(world.gravityX(), world.gravityY());
        double fall = Math.sqrt(2 * gravity * extent);
        double high = Math.max(fall, moving == 0 ? 0 : 2 * speeds / moving);
        return new Grain(
                (float) (count == 0 ? extent * PART : radii / count),
                (float) (count == 0 ? 1 : masses / squares),
                (float) (high > 0 ? high : extent / 4));
    }

    /** The mass of a circle of this world's stuff. */
    float mass(float ofRadius) {
        return within(density * ofRadius * ofRadius);
    }

    /** The mass of a body of it. */
    float massOf(float area) {
        return within(density * area / (float) Math.PI);
    }

    private static float within(float mass) {
        return Math.min(Math.max(mass, 1e-9f), 1e9f);
    }
}
