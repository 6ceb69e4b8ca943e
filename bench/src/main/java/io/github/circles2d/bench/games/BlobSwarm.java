package io.github.circles2d.bench.games;

import io.github.circles2d.Backend;
import io.github.circles2d.World;
import java.io.PrintStream;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/**
 * How many soft blobs of 24 circles keep 60 frames a second: each frame makes a step and takes the positions of all circles to draw them. The
 * main method prints a line of a CSV file for each number.
 *
 * <p>This class, {@link JointCosts} and {@link InTurn} need the library and no other class, so that they run on a machine with nothing but
 * a JVM and the library.
 */
public final class BlobSwarm {
    static final String HEADER = "machine,blobs,circles,joints,ms,longest_ms,frames_a_second";
    private static final double FRAME = 1000.0 / 60;
    private static final List<Integer> USUAL = List.of(250, 500, 1000, 2000, 4000, 8000, 16000);
    private static final int SETTLING = 300;
    private static final int FRAMES = 300;

    private BlobSwarm() {}

    /**
     * Prints how long frames take, with more and more blobs, until they take longer than they may.
     *
     * @param arguments as {@link #run}
     */
    public static void main(String[] arguments) {
        InTurn.main(arguments, BlobSwarm::run);
    }

    /**
     * Prints how long frames take, with more and more blobs, until they take longer than they may.
     *
     * @param arguments a name of {@link Backend} and numbers of blobs from 100 on; by default JVM, and 250 to 16000
     * @param out takes the lines of a CSV file
     * @throws IllegalArgumentException where the arguments are others
     */
    public static void run(List<String> arguments, PrintStream out) {
        InTurn.Arguments asked = InTurn.Arguments.read(arguments, 0, List.of());
        out.println(HEADER);
        for (int blobs : asked.sizes().get(0) == 0 ? USUAL : asked.sizes()) {
            if (measure(asked.backend(), blobs, SETTLING, FRAMES, out) > FRAME) {
                break;
            }
        }
    }

    /** Gives the median of ms a frame. */
    static double measure(Backend backend, int blobs, int settling, int frames, PrintStream out) {
        try (World world = JointCosts.blobs(backend, blobs, true)) {
            world.step(InTurn.TIME_STEP, settling);
            world.finish();
            double[] ms = new double[frames];
            for (int k = 0; k < frames; k++) {
                long from = System.nanoTime();
                world.step(InTurn.TIME_STEP);
                world.positions();
                ms[k] = (System.nanoTime() - from) / 1e6;
            }
            Arrays.sort(ms);
            double median = ms[frames / 2];
            out.printf(
                    Locale.ROOT,
                    "\"%s\",%d,%d,%d,%.3f,%.3f,%.0f%n",
                    world.stats().device(),
                    blobs,
                    world.size(),
                    world.joints().size(),
                    median,
                    ms[frames - 1],
                    1000 / median);
            out.flush();
            return median;
        }
    }
}
