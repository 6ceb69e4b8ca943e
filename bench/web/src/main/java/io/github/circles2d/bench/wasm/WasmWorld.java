package io.github.circles2d.bench.wasm;

import io.github.circles2d.Backend;
import io.github.circles2d.World;
import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.SceneLoader;
import io.github.circles2d.scenes.Scenes;
import org.teavm.jso.JSExport;
import org.teavm.jso.typedarrays.Float32Array;

/** The calls of the benchmark in JavaScript. */
public final class WasmWorld {
    private static World world;
    private static float timeStep;

    private WasmWorld() {}

    /** Nothing runs unless it is called. */
    public static void main(String[] arguments) {}

    /** Opens the scene packed-similar with n circles, in place of the world that is open. */
    @JSExport
    public static void load(int n) {
        if (world != null) {
            world.close();
        }
        Scene scene = Scenes.packedSimilar(n, Scenes.SEED);
        World.Builder builder = World.builder().backend(Backend.JVM);
        SceneLoader.parameters(scene, builder::bounds, builder::gravity, builder::restitution, builder::capacity);
        world = builder.build();
        SceneLoader.circles(scene, world::add, world::setRestitution);
        timeStep = scene.timeStep();
    }

    /** Makes a step. */
    @JSExport
    public static void step() {
        world.step(timeStep);
    }

    /** Four numbers a circle: x, y, vx and vy. */
    @JSExport
    public static Float32Array state() {
        int n = world.size();
        float[] circles = new float[4 * n];
        float[] velocities = new float[2 * n];
        world.read(circles);
        world.readVelocities(velocities);
        for (int i = 0; i < n; i++) {
            circles[4 * i + 2] = velocities[2 * i];
            circles[4 * i + 3] = velocities[2 * i + 1];
        }
        return Float32Array.copyFromJavaArray(circles);
    }
}
