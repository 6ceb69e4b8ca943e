package io.github.circles2d;

import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.locks.LockSupport;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;

/**
 * A main class that measures how long steps take beside other work, with one thread and with the default number, in turn.
 *
 * <p>Arguments: numbers of circles. It prints a line of a CSV file for each of them and for each kind of other work: medians of {@value #ROUNDS} rounds of
 * a median, and of a mean, in ms a step; the median and the greatest of the rounds' ratios.
 */
final class BusyMachine {
    private static final int ROUNDS = 5;
    private static final long ROUND_NANOS = 500_000_000L;

    /** The default number of threads. */
    static final int DEFAULT = 0;

    private BusyMachine() {}

    /** What runs beside the steps. */
    enum Beside {
        NOTHING,
        /** As many threads that only compute as there are processors. */
        BUSY,
        TWICE_AS_BUSY,
        /** A window that is drawn 60 times a second, and takes about half of the time of a processor. */
        WINDOW,
        /** Garbage, so that the collector runs. */
        GARBAGE;

        private Runnable work() {
            return switch (this) {
                case NOTHING -> () -> {};
                case BUSY, TWICE_AS_BUSY -> Others::compute;
                case WINDOW -> Others::draw;
                case GARBAGE -> Others::litter;
            };
        }

        private int threads() {
            int processors = Runtime.getRuntime().availableProcessors();
            return switch (this) {
                case NOTHING -> 0;
                case BUSY -> processors;
                case TWICE_AS_BUSY -> 2 * processors;
                case WINDOW, GARBAGE -> 1;
            };
        }
    }

    /** Other threads, until they are stopped. */
    static final class Others {
        private static final long FRAME_NANOS = 1_000_000_000L / 60;

        private final List<Thread> threads = new ArrayList<>();

        Others(Beside beside) {
            for (int k = 0; k < beside.threads(); k++) {
                Thread thread = new Thread(beside.work(), "busy-" + k);
                thread.setDaemon(true);
                thread.start();
                threads.add(thread);
            }
        }

        private static boolean runs() {
            return !Thread.currentThread().isInterrupted();
        }

        private static void compute() {
            while (runs()) {
                Thread.onSpinWait();
            }
        }

        private static void draw() {
            BufferedImage image = new BufferedImage(1280, 720, BufferedImage.TYPE_INT_RGB);
            Graphics2D graphics = image.createGraphics();
            graphics.setColor(Color.RED);
            for (long next = System.nanoTime(); runs(); next += FRAME_NANOS) {
                long end = System.nanoTime() + FRAME_NANOS / 2;
                for (int k = 0; System.nanoTime() < end; k++) {
                    graphics.fillOval(7 * k % 1280, 11 * k % 720, 20, 20);
                }
                LockSupport.parkNanos(next - System.nanoTime());
            }
            graphics.dispose();
        }

        private static void litter() {
            byte[][] live = new byte[4096][];
            for (int k = 0; runs(); k = (k + 1) % live.length) {
                live[k] = new byte[16 << 10];
                if (k % 64 == 0) {
                    LockSupport.parkNanos(1_000_000);
                }
            }
        }

        void stop() {
            threads.forEach(Thread::interrupt);
            for (Thread thread : threads) {
                try {
                    thread.join();
                } catch (InterruptedException e) {
                    throw new IllegalStateException(e);
                }
            }
        }
    }

    /**
     * The steps of a round.
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

        double median() {
            return quantile(0.5);
        }
    }

    static World world(Scene scene, int threads) {
        World.Builder builder = WorldScenes.builder(scene).backend(Backend.JVM);
        return WorldScenes.world(scene, threads == DEFAULT ? builder : builder.threads(threads));
    }

    static Round round(World world, float timeStep, Beside beside) {
        Others others = new Others(beside);
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
            others.stop();
        }
    }

    private static void print(String circles, Beside beside, List<Round> ofOne, List<Round> ofAll) {
        double[] ratios = IntStream.range(0, ROUNDS)
                .mapToDouble(k -> ofAll.get(k).median() / ofOne.get(k).median())
                .sorted()
                .toArray();
        System.out.printf(
                Locale.ROOT,
                "%s,%s,%.3f,%.3f,%.2f,%.2f,%.3f,%.3f,%s%n",
                circles,
                beside.name().toLowerCase(Locale.ROOT).replace('_', ' '),
                middle(ofOne, Round::median),
                middle(ofAll, Round::median),
                ratios[ROUNDS / 2],
                ratios[ROUNDS - 1],
                middle(ofOne, Round::mean),
                middle(ofAll, Round::mean),
                "1.5");
    }

    private static double middle(List<Round> rounds, ToDoubleFunction<Round> of) {
        return rounds.stream().mapToDouble(of).sorted().toArray()[ROUNDS / 2];
    }

    public static void main(String[] arguments) {
        System.out.println("n,beside,one_ms,default_ms,ratio,worst_ratio,one_mean_ms,default_mean_ms,asked");
        for (String circles : arguments) {
            Scene scene = Scenes.packed(Integer.parseInt(circles), 1);
            try (World one = world(scene, 1);
                    World all = world(scene, DEFAULT)) {
                for (int warm = 0; warm < 4; warm++) {
                    round(one, scene.timeStep(), Beside.NOTHING);
                    round(all, scene.timeStep(), Beside.NOTHING);
                }
                for (Beside beside : Beside.values()) {
                    List<Round> ofOne = new ArrayList<>();
                    List<Round> ofAll = new ArrayList<>();
                    for (int round = 0; round < ROUNDS; round++) {
                        ofOne.add(round(one, scene.timeStep(), beside));
                        ofAll.add(round(all, scene.timeStep(), beside));
                    }
                    print(circles, beside, ofOne, ofAll);
                }
            }
        }
    }
}
