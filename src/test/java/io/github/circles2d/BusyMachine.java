package io.github.circles2d;

import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/**
 * A main class that measures how long steps take on a machine that is idle but for them, and with as many other busy threads as
 * processors. The fair share of a step is then twice its time on an idle machine.
 *
 * <p>Arguments: a back end; numbers of circles.
 */
final class BusyMachine {
    private static final int ROUNDS = 5;
    private static final long ROUND_NANOS = 1_000_000_000L;

    private BusyMachine() {}

    /**
     * The steps of a second.
     *
     * @param sorted milliseconds by step, sorted
     */
    record Round(double[] sorted) {
        double mean() {
            return Arrays.stream(sorted).average().orElseThrow();
        }

        double quantile(double part) {
            return sorted[(int) (part * (sorted.length - 1))];
        }
    }

    /** Busy threads, until they are stopped. */
    static final class Others {
        private final List<Thread> threads = new ArrayList<>();

        Others(int count) {
            for (int k = 0; k < count; k++) {
                Thread thread = new Thread(Others::spin, "busy-" + k);
                thread.setDaemon(true);
                thread.start();
                threads.add(thread);
            }
        }

        private static void spin() {
            while (!Thread.currentThread().isInterrupted()) {
                Thread.onSpinWait();
            }
        }

        void stop() {
            threads.forEach(Thread::interrupt);
        }
    }

    /** A second of steps, with some other threads that are busy. */
    static Round round(World world, float timeStep, int others) {
        Others besides = new Others(others);
        try {
            double[] millis = new double[1 << 20];
            int steps = 0;
            long start = System.nanoTime();
            for (long before = start; before - start < ROUND_NANOS && steps < millis.length; steps++) {
                world.step(timeStep);
                world.positions();
                long now = System.nanoTime();
                millis[steps] = (now - before) * 1e-6;
                before = now;
            }
            double[] sorted = Arrays.copyOf(millis, steps);
            Arrays.sort(sorted);
            return new Round(sorted);
        } finally {
            besides.stop();
        }
    }

    public static void main(String[] arguments) {
        Backend backend = Backend.valueOf(arguments[0]);
        int processors = Runtime.getRuntime().availableProcessors();
        System.out.println("ms per step: mean, median, 95th percentile; by busy threads besides");
        for (String circles : Arrays.asList(arguments).subList(1, arguments.length)) {
            Scene scene = Scenes.packed(Integer.parseInt(circles), 1);
            try (World world =
                    WorldScenes.world(scene, WorldScenes.builder(scene).backend(backend))) {
                round(world, scene.timeStep(), 0);
                for (int round = 0; round < ROUNDS; round++) {
                    for (int others : new int[] {0, processors}) {
                        Round made = round(world, scene.timeStep(), others);
                        System.out.printf(
                                Locale.ROOT,
                                "%s %s circles, %d busy: %.3f, %.3f, %.3f%n",
                                backend,
                                circles,
                                others,
                                made.mean(),
                                made.quantile(0.5),
                                made.quantile(0.95));
                    }
                }
            }
        }
    }
}
