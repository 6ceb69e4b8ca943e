package io.github.circles2d.fuzz;

import io.github.circles2d.Backend;
import java.util.Arrays;
import java.util.BitSet;
import java.util.HashSet;
import java.util.Set;

/**
 * Runs programs from a seed on, for some seconds, in a JVM of its own: a fault may end it. It prints each seed before the program, and of each
 * failure a program that is as short as it can make it.
 */
public final class FuzzRun {
    /** The exit status if a program has failed. */
    static final int FAILED = 3;

    private static final int SHRINKING_SECONDS = Integer.getInteger("circles2d.fuzz.shrink", 60);
    private static final int MOST_FAILURES = 20;
    private static final int WARM_UP = 6;
    private static final int[] THREADS = Arrays.stream(
                    System.getProperty("circles2d.fuzz.threads", "1,2,3,7").split(","))
            .mapToInt(Integer::parseInt)
            .toArray();

    private final Api api = new Api();
    private final Counts counts = new Counts();
    private final Backend[] devices;
    private final Ready ready;

    /** Fills the heap if memory is to end; else null. */
    private final Ballast ballast;

    private final Set<String> found = new HashSet<>();

    private FuzzRun(Backend[] devices, Ready ready, Ballast ballast) {
        this.devices = devices;
        this.ready = ready;
        this.ballast = ballast;
    }

    /**
     * Runs programs.
     *
     * @param arguments the first seed; seconds; "ready" if worlds share their kernels, "needed" if they compile those that they need, or
     *     "memory" if memory ends; the lines of the one program, as numbers with commas or "each", or "all" for program after program; and
     *     the back ends beside the JVM
     */
    public static void main(String[] arguments) throws Throwable {
        long seed = Long.parseLong(arguments[0]);
        Ready ready = arguments[2].equals("ready") ? Ready.FOR_ALL : Ready.AS_NEEDED;
        Ballast ballast = arguments[2].equals("memory") ? new Ballast() : null;
        Backend[] devices =
                Arrays.stream(arguments).skip(4).map(Backend::valueOf).toArray(Backend[]::new);
        FuzzRun run = new FuzzRun(devices, ready, ballast);
        if (ballast != null) {
            for (long each = 1; each <= WARM_UP; each++) {
                run.memoryFailure(new Program(-each), new Program(-each).all(), MemorySession.NEVER);
            }
            ballast.fill(0);
            ballast.end();
        }
        if (arguments[3].equals("all")) {
            run.many(seed, Integer.parseInt(arguments[1]));
        } else {
            run.one(seed, lines(seed, arguments[3]));
        }
        System.exit(run.found.isEmpty() ? 0 : FAILED);
    }

    private static BitSet lines(long seed, String text) {
        if (text.equals("each")) {
            return new Program(seed).all();
        }
        BitSet lines = new BitSet();
        Arrays.stream(text.split(",")).mapToInt(Integer::parseInt).forEach(lines::set);
        return lines;
    }

    private void one(long seed, BitSet lines) {
        System.out.println(new Program(seed).text(lines));
        Mismatch mismatch = failure(seed, lines);
        if (mismatch != null) {
            found.add(mismatch.what());
            mismatch.printStackTrace(System.out);
        }
    }

    private void many(long seed, int seconds) {
        long end = System.nanoTime() + seconds * 1_000_000_000L;
        for (long each = seed; System.nanoTime() < end && found.size() < MOST_FAILURES; each++) {
            System.out.println("seed " + each);
            BitSet all = new Program(each).all();
            Mismatch mismatch = failure(each, all);
            counts.programs++;
            if (mismatch != null && found.add(mismatch.what())) {
                tell(each, all, mismatch);
            }
        }
        System.out.println(counts);
        System.out.println("missing " + api.missing());
    }

    private void tell(long seed, BitSet all, Mismatch mismatch) {
        System.out.println("FAILED: seed " + seed + ", " + mismatch.getMessage());
        mismatch.printStackTrace(System.out);
        BitSet least = new Shrinker(SHRINKING_SECONDS, lines -> {
                    Mismatch shorter = failure(seed, lines);
                    return shorter != null && shorter.what().equals(mismatch.what());
                })
                .shrink(all.get(0, mismatch.line() + 1));
        System.out.println(
                "lines " + least.toString().replaceAll("[{} ]", "") + " of " + new Program(seed).text(least));
        Mismatch shorter = failure(seed, least);
        System.out.println("which ends in: " + (shorter == null ? "nothing now" : shorter.getMessage()));
    }

    /** Runs some lines of a program; returns what is wrong, or null. */
    private Mismatch failure(long seed, BitSet lines) {
        Program program = new Program(seed);
        if (ballast != null) {
            return memoryFailure(program, lines, ballast);
        }
        try (Session session = new Session(api, program, THREADS, devices, ready, counts)) {
            return session.failure(lines);
        } catch (Throwable e) {
            return new Mismatch("an exception before or behind the calls", e).at(program.lines.size());
        }
    }

    private Mismatch memoryFailure(Program program, BitSet lines, MemoryEnd memory) {
        int threads = program.seed % 3 == 0 ? 2 : 1;
        try (MemorySession session = new MemorySession(api, program, memory, threads, counts)) {
            return session.failure(lines);
        } catch (Throwable e) {
            return new Mismatch("an exception before or behind the calls", e).at(program.lines.size());
        }
    }
}
