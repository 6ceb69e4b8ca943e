package io.github.circles2d.toy;

import io.github.circles2d.Backend;
import io.github.circles2d.Edge;
import io.github.circles2d.World;
import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.SceneLoader;
import io.github.circles2d.scenes.Scenes;

/** Scenes whose hashes are on record for the JVM. */
final class SameBits {
    private SameBits() {}

    /** Runs a scene for some steps, and returns its hash as 16 hexadecimal digits. */
    static String hash(String name, int steps) {
        Scene scene = scene(name);
        World.Builder builder = World.builder().backend(Backend.JVM);
        if (name.equals("wrapped")) {
            builder.edges(Edge.WRAP, Edge.WRAP);
        }
        SceneLoader.parameters(scene, builder::bounds, builder::gravity, builder::restitution, builder::capacity);
        try (World world = builder.build()) {
            SceneLoader.circles(scene, world::add, world::setRestitution);
            world.step(scene.timeStep(), steps);
            String digits = Long.toHexString(world.hash());
            return "0".repeat(16 - digits.length()) + digits;
        }
    }

    private static Scene scene(String name) {
        return switch (name) {
            case "thesis" -> Scenes.thesis(1250, Scenes.SEED);
            case "gas", "wrapped" -> Scenes.gas(2_500, Scenes.SEED);
            case "barrel" -> Scenes.barrel(Scenes.SEED);
            case "balls2" -> Scenes.balls2();
            case "no-collide" -> Scenes.noCollide();
            case "billiards" -> Scenes.billiards(20);
            case "mixed-100" -> Scenes.mixed(10_000, 100, Scenes.SEED);
            case "boulder" -> Scenes.boulder(10_000, Scenes.SEED);
            default -> throw new IllegalArgumentException("there is no scene " + name);
        };
    }
}
