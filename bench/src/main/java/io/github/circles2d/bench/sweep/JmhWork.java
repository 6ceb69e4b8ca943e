package io.github.circles2d.bench.sweep;

import io.github.circles2d.bench.engines.Engines;
import io.github.circles2d.bench.results.Numbers;
import io.github.circles2d.bench.results.ResultsFolder;
import io.github.circles2d.bench.results.Statistics;
import io.github.circles2d.bench.results.Table;
import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.Map;

/** A JMH run within its share of the time. */
final class JmhWork implements Work {
    /** How long a run may take. */
    enum Effort {
        QUICK(20, 3, 3, 1),
        BRISK(90, 5, 3, 10),
        FULL(300, 5, 5, 10);

        /** From here on an iteration is long. */
        private static final double LONG_SECONDS = 2;

        final double maxSeconds;
        final int mostWarmups;
        private final int wantedRuns;
        private final int wantedLongRuns;

        Effort(double maxSeconds, int wantedRuns, int wantedLongRuns, int mostWarmups) {
            this.maxSeconds = maxSeconds;
            this.wantedRuns = wantedRuns;
            this.wantedLongRuns = wantedLongRuns;
            this.mostWarmups = mostWarmups;
        }

        /** How many iterations should count. */
        int wantedRuns(double iterationSeconds) {
            return iterationSeconds > LONG_SECONDS ? wantedLongRuns : wantedRuns;
        }
    }

    /** With fewer there is no standard error. */
    private static final int MIN_RUNS = 2;

    /** An iteration as long as this, its set-up not counted, needs no other before it to warm up. */
    private static final double WARM_SECONDS = 5;

    /** Short iterations are repeated for about so long before they count: the JVM compiles meanwhile. */
    private static final double WARM_UP_SECONDS = 0.5;

    /** The counters of the benchmarks and the columns that they go to. */
    private static final Map<String, String> COLUMN_OF = columns();

    private final Task task;
    private final Effort effort;
    private final ResultsFolder folder;
    private final Map<String, String> hopeless;

    /**
     * Creates the work.
     *
     * @param hopeless why larger sizes of a series need not be tried, by series; shared by all work
     */
    JmhWork(Task task, Effort effort, ResultsFolder folder, Map<String, String> hopeless) {
        this.task = task;
        this.effort = effort;
        this.folder = folder;
        this.hopeless = hopeless;
    }

    private static Map<String, String> columns() {
        Map<String, String> columns = new LinkedHashMap<>();
        columns.put("updateMicros", "update_us");
        columns.put("detectMicros", "detect_us");
        columns.put("resolveMicros", "resolve_us");
        columns.put("meanDepth", "mean_depth");
        columns.put("maxDepth", "max_depth");
        columns.put("overlappingPairs", "overlapping_pairs");
        columns.put("deepPairs", "deep_pairs");
        columns.put("kineticEnergy", "kinetic_energy");
        columns.put("gridMicros", "grid_us");
        columns.put("scanMicros", "scan_us");
        columns.put("sweepMicros", "sweep_us");
        columns.put("contactsMicros", "contacts_us");
        columns.put("solverMicros", "solver_us");
        columns.put("residentMicros", "resident_us");
        columns.put("otherMicros", "other_us");
        columns.put("contacts", "contacts");
        columns.put("candidatePairs", "candidate_pairs");
        columns.put("bytesHeld", "bytes_held");
        columns.put("allocatedBytes", "allocated_bytes");
        columns.put("peakResidentMiB", "peak_rss_mib");
        return columns;
    }

    @Override
    public String label() {
        return task.label();
    }

    @Override
    public double seconds(Pace pace) {
        double wanted = pace.seconds(task, warmups(pace) + effort.wantedRuns(pace.iterationSeconds(task)));
        double least = pace.seconds(task, MIN_RUNS);
        return least > effort.maxSeconds ? 0 : Math.min(wanted, effort.maxSeconds);
    }

    @Override
    public String run(Pace pace, double secondsLeft) throws IOException {
        if (hopeless.containsKey(task.series())) {
            return without(hopeless.get(task.series()));
        }
        double limit = Math.min(secondsLeft, effort.maxSeconds);
        double iteration = pace.iterationSeconds(task);
        int warmups = warmups(pace);
        int affordable =
                (int) Math.min(effort.wantedRuns(iteration), (limit - pace.seconds(task, warmups)) / iteration);
        if (affordable < MIN_RUNS) {
            return leaveOut(pace.seconds(task, warmups + MIN_RUNS), limit);
        }
        // A guess may be wrong, a budget must hold.
        double patience = Math.min(30 + 3 * pace.seconds(task, warmups + affordable), 15 + secondsLeft);
        return measure(pace, warmups, affordable, (long) patience);
    }

    private int warmups(Pace pace) {
        double iteration = pace.iterationSeconds(task);
        return iteration - task.setUpSeconds() > WARM_SECONDS
                ? 0
                : (int) Math.max(1, Math.min(effort.mostWarmups, Math.ceil(WARM_UP_SECONDS / iteration)));
    }

    /** A figure that is there from an earlier sweep stays. */
    private String leaveOut(double needed, double limit) throws IOException {
        String status = limit <= 0
                ? "left out: the time was up"
                : "left out: it would take about " + Numbers.brief(needed) + " s, " + Numbers.brief(limit)
                        + " s are there for it";
        return folder.hasFigure(task.kind(), task.key()) ? status + "; the earlier figure stays" : without(status);
    }

    private String without(String status) throws IOException {
        folder.put(task.kind(), task.row(status));
        return status;
    }

    private String measure(Pace pace, int warmups, int runs, long timeout) throws IOException {
        long before = System.nanoTime();
        JmhRun run = JmhRun.of(task, warmups, runs, timeout);
        if (!run.succeeded()) {
            return explain(run.failure());
        }
        Statistics millis = run.millis();
        pace.learn(task, millis.median(), (System.nanoTime() - before) / 1e9, warmups + runs);
        folder.put(run.result());
        folder.put(task.kind(), row(run, millis));
        return Numbers.brief(millis.mean()) + " ms +/- " + Numbers.brief(millis.standardError());
    }

    private String explain(String failure) throws IOException {
        if (failure.startsWith("DeviceMemoryException")) {
            hopeless.put(task.series(), ResultsFolder.SMALLER_DOES_NOT_FIT);
            return without("does not fit: " + failure);
        }
        if (failure.startsWith(JmhRun.GIVEN_UP)) {
            hopeless.put(task.series(), "left out: a smaller size was given up");
        }
        return without("failed: " + failure);
    }

    private Map<String, String> row(JmhRun run, Statistics millis) {
        Table table = folder.table(task.kind());
        Map<String, String> row = task.row("ok");
        row.put("runs", Integer.toString(millis.runs()));
        row.put("mean_ms", Numbers.exact(millis.mean()));
        row.put("se_ms", Numbers.exact(millis.standardError()));
        row.put("min_ms", Numbers.exact(millis.min()));
        row.put("median_ms", Numbers.exact(millis.median()));
        COLUMN_OF.forEach((counter, column) -> {
            if (table.has(column)) {
                row.put(column, Numbers.exact(run.counter(counter)));
            }
        });
        extra(row, run, millis);
        return row;
    }

    private void extra(Map<String, String> row, JmhRun run, Statistics millis) {
        switch (task.kind()) {
            case COPY:
                row.put("gb_per_s", Numbers.exact(2 * task.n() / millis.median() / 1e6));
                break;
            case STRATEGIES:
                row.put("indexing", task.parameters().get("indexing"));
                row.put("steps", Integer.toString(task.steps()));
                PairTraffic traffic = PairTraffic.of(row.get("indexing"), task.n());
                row.put("collision_bytes", Long.toString(traffic.collisionBytes()));
                row.put("table_bytes", Long.toString(traffic.tableBytes()));
                break;
            case PEERS:
                row.put("skipped", Integer.toString(task.skipped()));
                row.put("remarks", Engines.remarks(row.get("engine")));
                break;
            case TRANSFER:
                row.put("gb_per_s", Numbers.exact(task.n() / millis.median() / 1e6));
                break;
            case WORLD:
                row.put("skipped", task.parameters().get("skipped"));
                row.put("steps", Integer.toString(task.steps()));
                row.put("state_hash", hash(run.counter("hashHigh"), run.counter("hashLow")));
                break;
            default:
                throw new AssertionError(task.kind());
        }
    }

    /** JMH's counters are doubles, which hold half a hash without loss. */
    static String hash(double high, double low) {
        return String.format("%08x%08x", (long) high, (long) low);
    }
}
