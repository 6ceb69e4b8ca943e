package io.github.circles2d.fuzz;

import io.github.circles2d.AllocationLimit;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Random;

/** Ends memory at allocations of calls. {@code AllocationLimitLoader} loads it, so that the library asks {@link AllocationLimit}. */
public final class MemoryLimits {
    /** Programs that load all classes first: memory that ends as one is loaded ends it for good. */
    private static final int WARM_UP = 2;

    private final Api api = new Api();
    private final Counts counts = new Counts();
    private final List<String> wrong = new ArrayList<>();

    private MemoryLimits() {
        for (int seed = 1; seed <= WARM_UP; seed++) {
            Program each = Program.ofEachCall(seed);
            for (int line = each.built; line < each.lines.size(); line++) {
                run(each, only(each, line), 1, MemorySession.NEVER);
            }
            run(new Program(seed), new Program(seed).all(), 2, MemorySession.NEVER);
        }
    }

    /**
     * Makes each call of the tables in some worlds; memory ends at an allocation of it, then at a later one, until the call has enough. Returns
     * what is wrong.
     *
     * @param stride 1 for each allocation, else the distance of those that are tried
     */
    public static List<String> each(int threads, int worlds, int stride) {
        MemoryLimits run = new MemoryLimits();
        for (int seed = 1; seed <= worlds; seed++) {
            Program program = Program.ofEachCall(seed);
            for (int line = program.built; line < program.lines.size(); line++) {
                if (threads == 1
                        || MemorySession.isStep(program.lines.get(line))) { // other threads work in steps alone
                    run.each(program, line, threads, stride);
                }
            }
        }
        return run.end();
    }

    private void each(Program program, int line, int threads, int stride) {
        Later limit = new Later((int) (program.seed + line) % stride, stride);
        long stopped;
        do { // a world that a step has lost makes room for another, where memory ends later
            stopped = counts.stopped;
            run(program, only(program, line), threads, limit);
        } while (counts.stopped > stopped);
    }

    /** A line behind those that build up the world. */
    private static BitSet only(Program program, int line) {
        BitSet lines = new BitSet();
        lines.set(0, program.built);
        lines.set(line);
        return lines;
    }

    /** Makes programs of any calls, at some of which memory ends at any allocation. Returns what is wrong. */
    public static List<String> programs(int first, int count) {
        MemoryLimits run = new MemoryLimits();
        for (int seed = first; seed < first + count; seed++) {
            Program program = new Program(seed);
            run.run(program, program.all(), seed % 4 == 0 ? 2 : 1, new Anywhere());
        }
        return run.end();
    }

    /** Memory that ends after some allocations, for good or once. */
    private abstract static class Limit implements MemoryEnd {
        static void after(int allocations) {
            if (allocations % 3 == 0) {
                AllocationLimit.onceAfter(allocations);
            } else {
                AllocationLimit.after(allocations);
            }
        }

        @Override
        public final boolean end() {
            return AllocationLimit.end();
        }
    }

    /** Later in each attempt. */
    private static final class Later extends Limit {
        private final int stride;
        private int next;

        Later(int first, int stride) {
            next = first;
            this.stride = stride;
        }

        @Override
        public void begin(Random random, int attempt) {
            after(next);
            next += stride;
        }
    }

    /** At a few of all calls, early or late. */
    private static final class Anywhere extends Limit {
        @Override
        public void begin(Random random, int attempt) {
            if (attempt == 0 && random.nextInt(3) > 0) {
                after(random.nextInt(1 << random.nextInt(6)));
            }
        }
    }

    private void run(Program program, BitSet lines, int threads, MemoryEnd end) {
        try (MemorySession session = new MemorySession(api, program, end, threads, counts)) {
            Mismatch mismatch = session.failure(lines);
            if (mismatch != null) {
                wrong.add("seed " + program.seed + ", line " + mismatch.line() + ": " + mismatch.getMessage());
            }
        } catch (Throwable e) {
            wrong.add("seed " + program.seed + ": " + e);
        }
    }

    /** No test passes since nothing fails. */
    private List<String> end() {
        if (counts.ended == 0) {
            wrong.add("memory has never ended");
        }
        return wrong;
    }
}
