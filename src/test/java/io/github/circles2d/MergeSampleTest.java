package io.github.circles2d;

import static io.github.circles2d.WorldScenes.snapshot;
import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.Constructor;
import java.lang.reflect.Field;
import java.lang.reflect.Method;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * The sample game Merge while it plays by itself: a ball that grows hardly overlaps others, and throws none. In a game balls drop,
 * bounce and fall into holes besides, so each merge is made twice from one state: with the growth and without. Balls that move
 * fast as it begins are left out of both.
 */
class MergeSampleTest {
    private static final int GAMES = 3;
    private static final int FRAMES = 3_000;
    private static final float STEP = 1 / 60f;

    /** The greatest overlap that is allowed, in radii of the ball that grows. */
    private static final float DEEPEST = 0.15f;

    /** The greatest speed upwards of a ball that is thrown, in its radii a second. */
    private static final float FASTEST = 2;

    /** Of so many merges, at most one throws a ball: a small one that two large ones squeeze out. */
    private static final int MERGES_OF_ONE_THROW = 100;

    /** Frames behind a merge: those of the growth, and some more. */
    private static final int WATCHED = 60;

    /** A ball that touched the growing one so many frames ago may be thrown by it. */
    private static final int RECENT = 10;

    @TempDir
    static Path classes;

    @Test
    void ballsThatGrowInTheGameHardlyOverlapOthersAndThrowNone() throws Exception {
        int merges = 0;
        int throwing = 0;
        try (URLClassLoader loader = compiled();
                World branch = WorldScenes.jvm().build()) {
            for (long seed = 1; seed <= GAMES; seed++) {
                Game game = new Game(loader, seed);
                for (int frame = 0; frame < FRAMES && !game.isOver(); frame++) {
                    for (long grown : game.play()) {
                        ByteBuffer state = snapshot(game.world);
                        merges++;
                        if (fastest(branch, state, grown, true) > FASTEST
                                && fastest(branch, state, grown, false) <= FASTEST) {
                            throwing++;
                        }
                    }
                    game.world.step(STEP);
                    assertThat(game.deepestOverlap())
                            .as("game %d, frame %d", seed, frame)
                            .isLessThan(DEEPEST);
                }
                game.world.close();
            }
        }
        assertThat(merges).isGreaterThan(50 * GAMES);
        assertThat(throwing).isLessThanOrEqualTo(merges / MERGES_OF_ONE_THROW);
    }

    /** The rules alone, which draw nothing. */
    private static URLClassLoader compiled() throws Exception {
        String source = "samples/merge/src/main/java/com/example/merge/Merge.java";
        int status = ToolProvider.getSystemJavaCompiler()
                .run(null, null, null, "-d", classes.toString(), "-cp", System.getProperty("java.class.path"), source);
        assertThat(status).isZero();
        return new URLClassLoader(new URL[] {classes.toUri().toURL()}, MergeSampleTest.class.getClassLoader());
    }

    /** The greatest speed upwards of a ball in the air: behind a growth, of those that have just touched the ball that grew. */
    private static float fastest(World world, ByteBuffer state, long grown, boolean grows) {
        world.restore(state.duplicate());
        removeFastOnes(world, grown);
        if (!grows) {
            world.grow(grown, world.radius(grown), 1);
        }
        int ids = world.idLimit();
        int[] sinceTouch = new int[ids];
        Arrays.fill(sinceTouch, grows ? WATCHED : 0);
        float[] circles = new float[4 * ids];
        float[] velocities = new float[2 * ids];
        float fastest = 0;
        for (int step = 0; step < WATCHED; step++) {
            world.step(STEP);
            world.readById(circles, null);
            world.readVelocitiesById(velocities, null);
            for (int id = 0; id < ids; id++) {
                if (world.handle(id) == 0) {
                    continue;
                }
                float r = circles[4 * id + 2];
                if (grows) {
                    boolean touches =
                            id == World.id(grown) || WorldMergeTest.gap(circles, id, World.id(grown)) <= 0.01f * r;
                    sinceTouch[id] = touches ? 0 : sinceTouch[id] + 1;
                }
                if (sinceTouch[id] <= RECENT && gap(world, circles, id) > 0.02f * r) {
                    fastest = Math.max(fastest, velocities[2 * id + 1] / r);
                }
            }
        }
        return fastest;
    }

    private static void removeFastOnes(World world, long but) {
        for (int id = 0; id < world.idLimit(); id++) {
            long handle = world.handle(id);
            if (handle != 0
                    && handle != but
                    && Math.hypot(world.vx(handle), world.vy(handle)) > FASTEST * world.radius(handle)) {
                world.remove(handle);
            }
        }
    }

    /** From a ball to what is nearest: another one, the floor or a wall. */
    private static float gap(World world, float[] circles, int id) {
        float x = circles[4 * id];
        float least = Math.min(circles[4 * id + 1], Math.min(x, MergeGame.WIDTH - x)) - circles[4 * id + 2];
        for (int other = 0; other < circles.length / 4; other++) {
            if (other != id && world.handle(other) != 0) {
                least = Math.min(least, WorldMergeTest.gap(circles, id, other));
            }
        }
        return least;
    }

    /** The sample's own class, whose package nobody else is in. */
    private static final class Game {
        private static final int GROWTH_STEPS = 45;

        /** Frames in which a ball is new: those of its growth, and a second. */
        private static final int NEW = GROWTH_STEPS + 60;

        private final Object rules;
        private final Method playAlone;
        private final Method isOver;
        private final World world;

        /** By handle of a ball that has grown: the frame in which it began. */
        private final Map<Long, Integer> newcomers = new HashMap<>();

        private int frame;

        Game(ClassLoader loader, long seed) throws ReflectiveOperationException {
            Class<?> type = loader.loadClass("com.example.merge.Merge");
            Constructor<?> constructor = type.getDeclaredConstructor(Backend.class, long.class);
            constructor.setAccessible(true);
            rules = constructor.newInstance(Backend.JVM, seed);
            playAlone = type.getDeclaredMethod("playAlone");
            playAlone.setAccessible(true);
            isOver = type.getDeclaredMethod("isOver");
            isOver.setAccessible(true);
            Field field = type.getDeclaredField("world");
            field.setAccessible(true);
            world = (World) field.get(rules);
        }

        boolean isOver() throws ReflectiveOperationException {
            return (boolean) isOver.invoke(rules);
        }

        /** Makes the changes of a frame, and returns the balls that begin to grow. */
        List<Long> play() throws ReflectiveOperationException {
            playAlone.invoke(rules);
            List<Long> before = growing();
            ((Runnable) rules).run();
            List<Long> begun = growing();
            begun.removeIf(handle -> before.contains(handle) && world.growthSteps(handle) < GROWTH_STEPS);
            frame++;
            begun.forEach(handle -> newcomers.put(handle, frame));
            newcomers.entrySet().removeIf(each -> !world.contains(each.getKey()) || frame - each.getValue() > NEW);
            return begun;
        }

        private List<Long> growing() {
            List<Long> handles = new ArrayList<>();
            for (int id = 0; id < world.idLimit(); id++) {
                long handle = world.handle(id);
                if (handle != 0 && world.growthSteps(handle) > 0) {
                    handles.add(handle);
                }
            }
            return handles;
        }

        /** How deep others are in balls that have just grown or still grow, in radii of these. */
        float deepestOverlap() {
            float[] circles = new float[4 * world.idLimit()];
            world.readById(circles, null);
            float deepest = 0;
            for (long newcomer : newcomers.keySet()) {
                int id = World.id(newcomer);
                for (int other = 0; other < world.idLimit(); other++) {
                    if (other != id && world.handle(other) != 0) {
                        deepest = Math.max(deepest, -WorldMergeTest.gap(circles, id, other) / circles[4 * id + 2]);
                    }
                }
            }
            return deepest;
        }
    }
}
