package io.github.circles2d;

import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.SceneLoader;
import io.github.circles2d.scenes.Scenes;
import java.util.List;
import java.util.SplittableRandom;

/**
 * A scene whose hashes are on record, and what a caller does to it while it runs.
 *
 * @param name the name on record
 * @param scene the start
 * @param churned whether circles come, go and are pushed every few steps
 */
record GoldenScene(String name, Scene scene, boolean churned) {
    private static final int STEPS_BETWEEN_CHANGES = 7;

    static List<GoldenScene> all() {
        return List.of(
                new GoldenScene("thesis", Scenes.thesis(1250, Scenes.SEED), false),
                new GoldenScene("packed-100000", Scenes.packed(100_000, Scenes.SEED), false),
                new GoldenScene("packed-5000-churned", Scenes.packed(5_000, Scenes.SEED), true),
                new GoldenScene("gas", Scenes.gas(2_500, Scenes.SEED), false),
                new GoldenScene("barrel", Scenes.barrel(Scenes.SEED), false),
                new GoldenScene("balls2", Scenes.balls2(), false),
                new GoldenScene("mixed-churned", Scenes.mixed(4_000, Scenes.SEED), true),
                new GoldenScene("no-collide", Scenes.noCollide(), false),
                new GoldenScene("billiards", Scenes.billiards(20), false),
                new GoldenScene("bouncy-churned", Scenes.bouncy(Scenes.SEED), true),
                new GoldenScene("one-point", Scenes.onePoint(2_000, Scenes.SEED), false));
    }

    /** A run of the scene in a world that was built by {@link #builder} and has no circles. */
    Run start(World empty) {
        World world = WorldScenes.load(scene, empty);
        return new Run(world, WorldCalls.of(world));
    }

    /** A run of the scene in a world that has its gravity, restitution and bounds, and no circles; there is no World then. */
    Run start(WorldCalls empty) {
        SceneLoader.circles(scene, empty::add, empty::setRestitution);
        return new Run(null, empty);
    }

    World.Builder builder() {
        return WorldScenes.builder(scene);
    }

    @Override
    public String toString() {
        return name;
    }

    final class Run implements AutoCloseable {
        private final World owned;
        private final WorldCalls world;
        private final SplittableRandom random = new SplittableRandom(Scenes.SEED);
        private long[] handles = new long[0];
        private float[] circles = new float[0];
        private int steps;

        private Run(World owned, WorldCalls world) {
            this.owned = owned;
            this.world = world;
        }

        World world() {
            return owned;
        }

        long hash() {
            return world.hash();
        }

        int steps() {
            return steps;
        }

        /** Goes on until so many steps have been made since the start. */
        void advanceTo(int target) {
            while (steps < target) {
                int next = target;
                if (churned) {
                    if (steps > 0 && steps % STEPS_BETWEEN_CHANGES == 0) {
                        change();
                    }
                    next = Math.min(target, steps - steps % STEPS_BETWEEN_CHANGES + STEPS_BETWEEN_CHANGES);
                }
                world.step(scene.timeStep(), next - steps);
                steps = next;
            }
        }

        /** Some circles go, as many come, some are pushed, moved, resized or get another restitution. */
        private void change() {
            int n = world.size();
            if (handles.length < n) {
                handles = new long[n];
                circles = new float[4 * n];
            }
            world.readHandles(handles);
            world.read(circles);
            float width = scene.maxX() - scene.minX();
            float height = scene.maxY() - scene.minY();
            for (int k = 0; k < 5; k++) {
                int gone = random.nextInt(n);
                if (world.contains(handles[gone])) {
                    world.remove(handles[gone]);
                    float x = scene.minX() + unit() * width;
                    float y = scene.minY() + unit() * height;
                    world.add(x, y, circles[4 * gone + 2], circles[4 * gone + 3], 0, 0);
                }
            }
            int some = random.nextInt(n);
            if (world.contains(handles[some])) {
                float mass = circles[4 * some + 3];
                world.applyImpulse(handles[some], 0.1f * (unit() - 0.5f) * mass, 0.1f * unit() * mass);
            }
            some = random.nextInt(n);
            if (world.contains(handles[some])) {
                world.setPosition(handles[some], scene.minX() + unit() * width, scene.minY() + unit() * height);
                world.setVelocity(handles[some], 0.5f * width * (unit() - 0.5f), 0.5f * height * (unit() - 0.5f));
            }
            some = random.nextInt(n);
            if (world.contains(handles[some])) {
                world.setRadius(handles[some], circles[4 * some + 2] * (0.75f + 0.25f * unit()));
                world.setMass(handles[some], 0.5f * circles[4 * some + 3]);
                world.setRestitution(handles[some], unit());
            }
        }

        private float unit() {
            return random.nextInt(1 << 24) * 0x1p-24f;
        }

        @Override
        public void close() {
            if (owned != null) {
                owned.close();
            }
        }
    }
}
