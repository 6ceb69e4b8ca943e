package io.github.circles2d;

import io.github.circles2d.scenes.Quality;
import io.github.circles2d.scenes.Scene;

/** Worlds made of scenes, for tests. */
public final class WorldScenes {
    private WorldScenes() {}

    /** A builder for the JVM back end, which all others are compared with. */
    public static World.Builder jvm() {
        return World.builder().backend(Backend.JVM);
    }

    /** A builder with a scene's parameters, for the JVM back end. */
    public static World.Builder builder(Scene scene) {
        return jvm().bounds(scene.minX(), scene.minY(), scene.maxX(), scene.maxY())
                .gravity(scene.gravityX(), scene.gravityY())
                .restitution(scene.restitution())
                .capacity(scene.size());
    }

    /** A world with a scene's circles, in the scene's order. */
    public static World world(Scene scene, World.Builder builder) {
        World world = builder.build();
        addAll(scene, WorldCalls.of(world));
        return world;
    }

    /** Adds a scene's circles to a world that has the scene's restitution, in the scene's order. */
    static void addAll(Scene scene, WorldCalls world) {
        for (int i = 0; i < scene.size(); i++) {
            long handle = world.add(
                    scene.x(i),
                    scene.y(i),
                    scene.radius(i),
                    scene.fixed(i) ? Float.POSITIVE_INFINITY : scene.mass(i),
                    scene.vx(i),
                    scene.vy(i));
            if (scene.restitution(i) != scene.restitution()) {
                world.setRestitution(handle, scene.restitution(i));
            }
        }
    }

    /** The measures of quality of a world. Fixed circles at rest count as circles without energy. */
    public static Quality quality(World world) {
        int n = world.size();
        float[] circles = new float[4 * n];
        float[] velocities = new float[2 * n];
        world.read(circles);
        world.readVelocities(velocities);
        float[][] parts = new float[6][n];
        for (int i = 0; i < n; i++) {
            for (int d = 0; d < 4; d++) {
                parts[d][i] = circles[4 * i + d];
            }
            parts[4][i] = velocities[2 * i];
            parts[5][i] = velocities[2 * i + 1];
        }
        return Quality.of(parts[0], parts[1], parts[2], parts[3], parts[4], parts[5], n);
    }
}
