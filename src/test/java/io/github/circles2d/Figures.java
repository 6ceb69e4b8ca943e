package io.github.circles2d;

import com.sun.management.ThreadMXBean;
import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.SceneLoader;
import io.github.circles2d.scenes.Scenes;
import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.Locale;

/**
 * Prints what {@code .ci/gate} compares: for each crowd and number of circles the median time of a step, the bytes that a step leaves as
 * garbage, and those of a snapshot. It calls the public API alone, so that the classes of one version measure another.
 *
 * <p>The JVM back end gets one thread, and its time is processor time, which other work on the machine hardly changes.
 */
final class Figures {
    private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    private static final float STEP = 1 / 60f;

    /** Steps of a round on a device; the JVM makes as many, but at least two, as it makes of 150,000 circles. */
    private static final int STEPS = 60;

    private static final int CIRCLE_STEPS_OF_ROUND = 150_000;
    private static final int SETTLING = 60;
    private static final int WARM_ROUNDS = 5;
    private static final int ROUNDS = 21;

    private Figures() {}

    /** Arguments: a name of {@link Backend}, and numbers of circles. */
    public static void main(String[] arguments) {
        Backend backend = Backend.valueOf(arguments[0]);
        for (int k = 1; k < arguments.length; k++) {
            int n = Integer.parseInt(arguments[k]);
            print("like " + n, backend, Scenes.packed(n, Scenes.SEED), 0);
            print("1:10 " + n, backend, Scenes.mixed(n, 10, Scenes.SEED), 0);
            print("friction " + n, backend, Scenes.packed(n, Scenes.SEED), 0.6f);
        }
    }

    private static void print(String name, Backend backend, Scene scene, float friction) {
        boolean onJvm = backend == Backend.JVM;
        int steps = onJvm ? Math.max(2, Math.min(STEPS, CIRCLE_STEPS_OF_ROUND / scene.size())) : STEPS;
        double[] ms = new double[ROUNDS];
        long garbage = Long.MAX_VALUE;
        try (World world = world(backend, scene, friction)) {
            world.step(STEP, SETTLING);
            world.finish();
            for (int round = -WARM_ROUNDS; round < ROUNDS; round++) {
                long bytes = THREADS.getCurrentThreadAllocatedBytes();
                long from = onJvm ? THREADS.getCurrentThreadCpuTime() : System.nanoTime();
                world.step(STEP, steps);
                world.finish();
                long to = onJvm ? THREADS.getCurrentThreadCpuTime() : System.nanoTime();
                garbage = Math.min(garbage, THREADS.getCurrentThreadAllocatedBytes() - bytes);
                if (round >= 0) {
                    ms[round] = (to - from) / 1e6 / steps;
                }
            }
            Arrays.sort(ms);
            System.out.printf(Locale.ROOT, "ms %s %.5f%n", name, ms[ROUNDS / 2]);
            System.out.printf("garbage %s %d%n", name, garbage / steps);
            System.out.printf("snapshot %s %d%n", name, world.snapshotBytes());
        }
    }

    private static World world(Backend backend, Scene scene, float friction) {
        World.Builder builder = World.builder().backend(backend).friction(friction);
        if (backend == Backend.JVM) {
            builder.threads(1);
        }
        SceneLoader.parameters(scene, builder::bounds, builder::gravity, builder::restitution, builder::capacity);
        World world = builder.build();
        SceneLoader.circles(scene, world::add, world::setRestitution);
        return world;
    }
}
