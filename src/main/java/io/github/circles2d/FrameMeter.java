package io.github.circles2d;

import io.github.circles2d.calibration.Crowd;
import io.github.circles2d.calibration.FrameTimes;
import io.github.circles2d.opencl.Device;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Arrays;
import java.util.HashSet;
import java.util.Optional;
import java.util.Random;
import java.util.Set;

/**
 * Times frames of a crowd that fills 0.62 of the unit square and settles: the circles of the thesis's test program, in scale, or
 * circles of mixed radii.
 */
final class FrameMeter implements Meter {
    /** Frames of World that are timed, and before them those in which the crowd begins to settle. */
    private static final int WORLD_FRAMES = 30;

    private static final int WORLD_WARM_UP = 50;

    /** In all, what a budget of time is made by. */
    static final int WORLD_FRAMES_IN_ALL = WORLD_WARM_UP + WORLD_FRAMES;

    private static final int LOOPS = 7;
    private static final int LOOP_WARM_UP = 3;
    static final int LOOPS_IN_ALL = LOOP_WARM_UP + LOOPS;

    /** Short frames are repeated for so long. Clocks and compilers need it to come up to speed. */
    private static final long WARM_UP_NANOS = 200_000_000;

    private static final long TIMED_NANOS = 100_000_000;

    /** The first time that a JVM makes steps, its compiler is not yet done with them for about as long. */
    private static final long FIRST_WARM_UP_NANOS = 1_500_000_000;

    private static final float STEP = 1 / 60f;
    private static final float GRAVITY = -0.01f;
    private static final float RESTITUTION = 0.5f;
    private static final int THESIS_SIZE = 1250;
    private static final double FILL = 0.62;

    /** Mass over square of the radius in a crowd of mixed radii: about that of the thesis's circles. */
    private static final double MASS = 1e5;

    /** Whether the JVM has made steps of like radii, and of mixed ones, for which it has other code. */
    private final Set<Boolean> compiled = new HashSet<>();

    @Override
    public FrameTimes world(Optional<Device> device, Crowd crowd) {
        World.Builder builder = World.builder()
                .gravity(0, GRAVITY)
                .restitution(RESTITUTION)
                .capacity(crowd.circles())
                .waitForPlans();
        device.ifPresentOrElse(builder::device, () -> builder.backend(Backend.JVM));
        try (World world = builder.build()) {
            float[] circles = crowd.isMixed() ? mixed(crowd) : like(crowd.circles());
            world.addAll(circles, null);
            Runnable frame = () -> {
                world.step(STEP);
                world.read(circles);
            };
            if (device.isEmpty() && compiled.add(crowd.isMixed())) {
                repeat(frame, 0, FIRST_WARM_UP_NANOS);
            }
            repeat(frame, WORLD_WARM_UP, WARM_UP_NANOS);
            return repeat(frame, WORLD_FRAMES, TIMED_NANOS);
        }
    }

    @Override
    public FrameTimes loop(Device device, PairIndexing indexing, int circles) {
        try (Circles2D engine = new Circles2D(device)) {
            float[] crowd = like(circles);
            for (int i = 0; i < circles; i++) {
                engine.addCircle(crowd[4 * i], crowd[4 * i + 1], crowd[4 * i + 2], crowd[4 * i + 3]);
            }
            engine.init(STEP, indexing, RESTITUTION, new float[] {0, GRAVITY});
            repeat(engine::loop, LOOP_WARM_UP, WARM_UP_NANOS);
            return repeat(engine::loop, LOOPS, TIMED_NANOS);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Runs at least so many frames for at least so long, and says what they took. */
    private static FrameTimes repeat(Runnable frame, int frames, long nanos) {
        long[] times = new long[Math.max(frames, 16)];
        int count = 0;
        long start = System.nanoTime();
        long last = start;
        while (count < frames || last - start < nanos) {
            frame.run();
            long now = System.nanoTime();
            if (count == times.length) {
                times = Arrays.copyOf(times, 2 * count);
            }
            times[count++] = now - last;
            last = now;
        }
        return FrameTimes.of(times, count);
    }

    /** x, y, radius and mass of each: the same circles every time. */
    private static float[] like(int circles) {
        Random random = new Random(THESIS_SIZE);
        float scale = (float) Math.sqrt((double) THESIS_SIZE / circles);
        float[] crowd = new float[4 * circles];
        for (int i = 0; i < circles; i++) {
            crowd[4 * i] = 0.1f + 0.8f * random.nextFloat();
            crowd[4 * i + 1] = 0.1f + 0.8f * random.nextFloat();
            crowd[4 * i + 2] = (0.01f + 0.005f * random.nextFloat()) * scale;
            crowd[4 * i + 3] = 1 + 9 * random.nextFloat();
        }
        return crowd;
    }

    /**
     * x, y, radius and mass of each: the same circles every time. The logarithms of radii are spread evenly, and masses go by area. As
     * in the other crowd circles overlap at first, so that they have about as many contacts as in a pile.
     */
    static float[] mixed(Crowd crowd) {
        Random random = new Random(THESIS_SIZE);
        double[] radii = new double[crowd.circles()];
        double squares = 0;
        double greatest = 0;
        for (int i = 0; i < radii.length; i++) {
            radii[i] = StrictMath.pow(crowd.ratio(), random.nextDouble());
            squares += radii[i] * radii[i];
            greatest = Math.max(greatest, radii[i]);
        }
        double scale = Math.sqrt(FILL / (Math.PI * squares));
        double margin = Math.max(0.1, scale * greatest);
        float[] circles = new float[4 * radii.length];
        for (int i = 0; i < radii.length; i++) {
            double radius = scale * radii[i];
            circles[4 * i] = (float) (margin + (1 - 2 * margin) * random.nextDouble());
            circles[4 * i + 1] = (float) (margin + (1 - 2 * margin) * random.nextDouble());
            circles[4 * i + 2] = (float) radius;
            circles[4 * i + 3] = (float) (MASS * radius * radius);
        }
        return circles;
    }
}
