package io.github.circles2d;

import io.github.circles2d.reference.Surfaces;
import io.github.circles2d.scenes.Quality;
import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.SceneLoader;
import io.github.circles2d.world.jvm.JvmPipeline;
import java.nio.ByteBuffer;

/** Worlds made of scenes, for tests. */
public final class WorldScenes {
    private WorldScenes() {}

    /** A builder for the JVM back end, which all others are compared with. */
    public static World.Builder jvm() {
        return World.builder().backend(Backend.JVM);
    }

    /** A builder with a scene's parameters, for the JVM back end. */
    public static World.Builder builder(Scene scene) {
        World.Builder builder = jvm();
        SceneLoader.parameters(scene, builder::bounds, builder::gravity, builder::restitution, builder::capacity);
        return builder;
    }

    /** The same builder, for worlds with such surfaces. */
    static World.Builder with(Surfaces surfaces, World.Builder builder) {
        for (Wall wall : Wall.values()) {
            float[] its = surfaces.walls()[wall.ordinal()];
            builder.wallSurface(wall, its[0], its[1], surfaces.beltAsCalled(wall.ordinal()));
        }
        return builder.friction(surfaces.friction()).rollingResistance(surfaces.rollingResistance());
    }

    /** A world with a scene's circles, in the scene's order. */
    public static World world(Scene scene, World.Builder builder) {
        return load(scene, builder.build());
    }

    /** Adds a scene's circles to a world that has the scene's restitution, in the scene's order. */
    static World load(Scene scene, World world) {
        SceneLoader.circles(scene, world::add, world::setRestitution);
        return world;
    }

    /**
     * A world on the JVM whose steps are made by so many threads, however few circles there are.
     *
     * @param builder bounds, gravity, restitution and sub-steps
     */
    static World onThreads(int threads, boolean profiling, World.Builder builder) {
        return new World(builder, new BackendChoice(Backend.JVM, new JvmPipeline(threads, 1, 0, profiling), "a test"));
    }

    /** A world like that, without profiling. */
    static World onThreads(int threads, World.Builder builder) {
        return onThreads(threads, false, builder);
    }

    /** A world's state, to be restored. */
    public static ByteBuffer snapshot(World world) {
        ByteBuffer bytes = ByteBuffer.allocate(world.snapshotBytes());
        world.snapshot(bytes);
        return bytes.flip();
    }

    /** The measures of quality of a world. Static circles at rest count as circles without energy. */
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
