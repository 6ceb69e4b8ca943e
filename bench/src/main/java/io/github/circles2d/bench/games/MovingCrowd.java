package io.github.circles2d.bench.games;

import io.github.circles2d.Backend;
import io.github.circles2d.World;
import io.github.circles2d.WorldStats;
import io.github.circles2d.opencl.OpenClException;
import java.io.PrintStream;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;

/**
 * A crowd that grows and shrinks by a hundredth every few frames, in three worlds that make each frame in turn: one of AUTO, one on the JVM and one on
 * a GPU. A frame adds or removes circles, makes a step and reads all circles.
 */
public final class MovingCrowd {
    static final String HEADER =
            "frame,frames,circles,auto_ms,jvm_ms,gpu_ms,auto_longest_ms,jvm_longest_ms,gpu_longest_ms,where,moves";

    private static final List<Backend> BACKENDS = List.of(Backend.AUTO, Backend.JVM, Backend.OPENCL_GPU);

    /** Frames of a row. */
    private static final int ROW = 40;

    private static final int LEAST = 500;
    private static final int MOST = 200_000;

    /** Frames between two changes of the crowd. */
    private static final int FRAMES = 4;

    private static final float PITCH = 1.2f;

    private final int most;
    private final int row;
    private final int[] cells;
    private final float[] read;

    private MovingCrowd(int most) {
        this.most = most;
        row = (int) Math.ceil(Math.sqrt(most));
        cells = cells(most);
        read = new float[4 * most];
    }

    /**
     * Prints the rows.
     *
     * @param arguments none, or the least and the greatest number of circles
     * @param out takes them
     * @throws IllegalArgumentException if there is no GPU
     */
    public static void run(List<String> arguments, PrintStream out) {
        int least = arguments.isEmpty() ? LEAST : Integer.parseInt(arguments.get(0));
        int most = arguments.size() < 2 ? MOST : Integer.parseInt(arguments.get(1));
        try {
            measure(least, most, BACKENDS, out);
        } catch (OpenClException e) {
            throw new IllegalArgumentException("a world that moves is measured on a GPU: " + e.getMessage(), e);
        }
    }

    /** The back ends are those of the three columns. */
    static void measure(int least, int most, List<Backend> backends, PrintStream out) {
        MovingCrowd crowd = new MovingCrowd(most);
        Run[] runs = new Run[backends.size()];
        try {
            for (int k = 0; k < runs.length; k++) {
                runs[k] = new Run(crowd.builder().backend(backends.get(k)).build(), most);
            }
            out.println(HEADER);
            crowd.frames(least, runs, out);
            for (Run run : runs) {
                if (run.world.hash() != runs[0].world.hash()) {
                    throw new IllegalStateException("the worlds end differently");
                }
            }
        } finally {
            for (Run run : runs) {
                if (run != null) {
                    run.world.close();
                }
            }
        }
    }

    private World.Builder builder() {
        float side = PITCH * row;
        return World.builder().bounds(0, 0, side, side);
    }

    private void frames(int least, Run[] runs, PrintStream out) {
        int target = least;
        boolean grows = true;
        int frame = 0;
        int first = 0;
        while (target >= least) {
            for (Run run : runs) {
                frame(run, target);
            }
            frame++;
            if (frame - first == ROW) {
                print(first, frame - first, target, runs, out);
                first = frame;
            }
            if (frame % FRAMES == 0) {
                int change = Math.max(1, target / 100);
                grows &= target < most;
                target = grows ? Math.min(most, target + change) : target - change;
            }
        }
        if (frame > first) {
            print(first, frame - first, least, runs, out);
        }
    }

    private void frame(Run run, int target) {
        long begin = System.nanoTime();
        for (int k = run.living; k < target; k++) {
            float x = PITCH * (cells[k] % row) + PITCH / 2;
            float y = PITCH * (cells[k] / row) + PITCH / 2;
            run.handles[k] = run.world.add(x, y, 0.45f, 1, k % 7 - 3, k % 5 - 2);
        }
        for (int k = run.living - 1; k >= target; k--) {
            run.world.remove(run.handles[k]);
        }
        run.living = target;
        run.world.step(1 / 60f);
        run.world.read(read);
        run.note((System.nanoTime() - begin) * 1e-6);
    }

    private static void print(int first, int frames, int circles, Run[] runs, PrintStream out) {
        WorldStats auto = runs[0].world.stats();
        StringBuilder line = new StringBuilder(String.format(Locale.ROOT, "%d,%d,%d", first, frames, circles));
        for (Run run : runs) {
            line.append(String.format(Locale.ROOT, ",%.3f", run.sum / frames));
        }
        for (Run run : runs) {
            line.append(String.format(Locale.ROOT, ",%.3f", run.longest));
            run.sum = 0;
            run.longest = 0;
        }
        out.println(line.append(',').append(auto.backend()).append(',').append(auto.moves()));
    }

    /** The cells of a square in which circles come, one after the other. */
    private static int[] cells(int most) {
        int[] cells = new int[most];
        SplittableRandom random = new SplittableRandom(1);
        for (int k = 0; k < most; k++) {
            int other = random.nextInt(k + 1);
            cells[k] = cells[other];
            cells[other] = k;
        }
        return cells;
    }

    /** A world, and what its frames since the last row have taken. */
    private static final class Run {
        final World world;
        final long[] handles;
        int living;
        double sum;
        double longest;

        Run(World world, int most) {
            this.world = world;
            handles = new long[most];
        }

        void note(double millis) {
            sum += millis;
            longest = Math.max(longest, millis);
        }
    }
}
