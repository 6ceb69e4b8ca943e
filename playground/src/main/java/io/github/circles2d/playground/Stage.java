package io.github.circles2d.playground;

import io.github.circles2d.World;
import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.SceneLoader;
import java.nio.ByteBuffer;
import java.util.function.Consumer;
import java.util.function.Supplier;

/**
 * What a world is at first.
 *
 * @param name      what a person calls it
 * @param published whether its numbers are published ones
 * @param builder   describes the world
 * @param circles   puts the circles into it
 */
record Stage(String name, boolean published, Supplier<World.Builder> builder, Consumer<World> circles) {

    /** A scene with published numbers, which is made when it is needed. */
    static Stage of(String name, Supplier<Scene> scene) {
        return new Stage(name, true, () -> builder(scene.get()), world -> fill(world, scene.get()));
    }

    /** A world that was saved. */
    static Stage saved(String name, byte[] snapshot) {
        return new Stage(name, false, World::builder, world -> world.restore(ByteBuffer.wrap(snapshot)));
    }

    private static World.Builder builder(Scene scene) {
        World.Builder builder = World.builder();
        SceneLoader.parameters(scene, builder::bounds, builder::gravity, builder::restitution, builder::capacity);
        return builder;
    }

    private static void fill(World world, Scene scene) {
        SceneLoader.circles(scene, world::add, world::setRestitution);
    }
}
