package io.github.circles2d;

import io.github.circles2d.calibration.FrameTimes;
import io.github.circles2d.opencl.Device;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Arrays;
import java.util.Random;

/** Times loops of a crowd that fills 0.62 of the unit square and settles: the circles of the thesis's test program, in scale. */
final class FrameMeter implements Calibration.Meter {
    private static final int LOOPS = 7;
    private static final int LOOP_WARM_UP = 3;

    /** In all, what a budget of time is made by. */
    static final int LOOPS_IN_ALL = LOOP_WARM_UP + LOOPS;

    /** Short loops are repeated for so long. Clocks and compilers need it to come up to speed. */
    private static final long WARM_UP_NANOS = 200_000_000;

    private static final long TIMED_NANOS = 100_000_000;

    private static final float STEP = 1 / 60f;
    private static final float GRAVITY = -0.01f;
    private static final float RESTITUTION = 0.5f;
    private static final int THESIS_SIZE = 1250;

    @Override
    public FrameTimes loop(Device device, PairIndexing indexing, int circles) {
        try (Circles2D engine = new Circles2D(device)) {
            float[] crowd = crowd(circles);
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

    /** Runs at least so many loops for at least so long, and says what they took. */
    private static FrameTimes repeat(Runnable loop, int loops, long nanos) {
        long[] times = new long[Math.max(loops, 16)];
        int count = 0;
        long start = System.nanoTime();
        long last = start;
        while (count < loops || last - start < nanos) {
            loop.run();
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
    private static float[] crowd(int circles) {
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
}
