package io.github.circles2d.bench.broadphase;

import io.github.circles2d.Backend;
import io.github.circles2d.World;

/**
 * Circles at the start, in the unit square.
 *
 * @param circles x, y, radius and mass of each, as World takes them
 * @param velocities vx and vy of each
 * @param gravity along y
 */
record Crowd(float[] circles, float[] velocities, float gravity, float restitution) {
    int size() {
        return velocities.length / 2;
    }

    /** A world on one thread of the JVM, which measures its stages. */
    World world() {
        World world = World.builder()
                .backend(Backend.JVM)
                .threads(1)
                .profiling(true)
                .bounds(0, 0, 1, 1)
                .gravity(0, gravity)
                .restitution(restitution)
                .capacity(size())
                .build();
        world.addAll(circles, velocities, new long[size()]);
        return world;
    }
}
