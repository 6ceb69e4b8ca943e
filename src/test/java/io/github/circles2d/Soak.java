package io.github.circles2d;

import java.util.Locale;
import java.util.concurrent.TimeUnit;

/**
 * A main class that runs one engine for minutes or hours, prints once a minute what the process holds, and fails if that
 * grows without bound or a result differs from a control.
 *
 * <p>Arguments: {@code world-jvm}, {@code world-cpu} (World on the JVM or by OpenCL on a processor) or {@code circles2d}
 * (Circles2D by OpenCL on a processor); minutes. Exit status: 0 if all went well, 1 if not.
 */
final class Soak {
    /** A shorter run prints more often, so that there is something to compare. */
    private static final int LEAST_SAMPLES = 18;

    private Soak() {}

    /** What is run. */
    interface Soaked extends AutoCloseable {
        /** Goes on for some hundred steps; throws an AssertionError if something differs from the control. */
        void round() throws Exception;

        long steps();

        long engines();

        /** Bytes that the engine holds now. */
        long bytes() throws Exception;

        @Override
        void close();
    }

    static Soaked soaked(String name) throws Exception {
        return switch (name) {
            case "world-jvm" -> new SoakedWorld(Backend.JVM);
            case "world-cpu" -> new SoakedWorld(Backend.OPENCL_CPU);
            case "circles2d" -> new SoakedCircles2D();
            default -> throw new IllegalArgumentException("world-jvm, world-cpu or circles2d, not " + name);
        };
    }

    public static void main(String[] arguments) {
        try {
            System.exit(run(arguments[0], Double.parseDouble(arguments[1])) ? 0 : 1);
        } catch (Throwable e) {
            e.printStackTrace();
            System.exit(1);
        }
    }

    private static boolean run(String name, double minutes) throws Exception {
        SoakSamples samples = new SoakSamples();
        System.out.println(SoakSamples.HEADER);
        long total = (long) (minutes * TimeUnit.MINUTES.toNanos(1));
        long period = Math.min(TimeUnit.MINUTES.toNanos(1), total / LEAST_SAMPLES);
        long start = System.nanoTime();
        try (Soaked soaked = soaked(name)) {
            for (long next = period; next <= total; next += period) {
                do {
                    soaked.round();
                } while (System.nanoTime() - start < next);
                double now = (System.nanoTime() - start) / (double) TimeUnit.MINUTES.toNanos(1);
                System.out.println(String.format(Locale.ROOT, "%.2f,%d,", now, soaked.steps())
                        + samples.take(soaked.bytes(), soaked.engines()));
            }
        }
        samples.growth().forEach(System.out::println);
        return samples.growth().isEmpty();
    }
}
