package io.github.circles2d.bench.measure;

import io.github.circles2d.bench.engines.Engines;
import io.github.circles2d.bench.results.Numbers;
import io.github.circles2d.bench.results.ResultsFolder;
import io.github.circles2d.bench.results.Statistics;
import java.io.IOException;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Pattern;

/**
 * A JMH run within its share of the time.
 *
 * @param hopeless why larger sizes of a family need not be tried, by family; shared by all work
 */
record JmhWork(Task task, Effort effort, ResultsFolder folder, Map<String, String> hopeless) implements Work {
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
        if (hopeless.containsKey(task.family())) {
            return without(hopeless.get(task.family()));
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
        if (run.result() == null) {
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
            hopeless.put(task.family(), ResultsFolder.SMALLER_DOES_NOT_FIT);
            return without("does not fit: " + failure);
        }
        if (failure.startsWith(JmhRun.GIVEN_UP)) {
            hopeless.put(task.family(), "left out: a smaller size was given up");
        }
        return without("failed: " + failure);
    }

    private Map<String, String> row(JmhRun run, Statistics millis) {
        Map<String, String> row = task.row("ok");
        row.put("runs", Integer.toString(millis.runs()));
        row.put("mean_ms", Numbers.exact(millis.mean()));
        row.put("se_ms", Numbers.exact(millis.standardError()));
        row.put("min_ms", Numbers.exact(millis.min()));
        row.put("median_ms", Numbers.exact(millis.median()));
        for (String column : folder.table(task.kind()).columns()) {
            double value = run.counter(counter(column));
            if (Double.isFinite(value)) {
                row.put(column, Numbers.exact(value));
            }
        }
        extra(row, run, millis);
        return row;
    }

    /** The counter of a benchmark that goes to a column. */
    private static String counter(String column) {
        if (column.equals("peak_rss_mib")) {
            return "peakResidentMiB";
        }
        return Pattern.compile("_([a-z])")
                .matcher(column.replace("_us", "_micros"))
                .replaceAll(letter -> letter.group(1).toUpperCase(Locale.ROOT));
    }

    private void extra(Map<String, String> row, JmhRun run, Statistics millis) {
        if (folder.table(task.kind()).columns().contains("steps")) {
            row.put("steps", Integer.toString(task.steps()));
        }
        switch (task.kind()) {
            case COPY -> row.put("gb_per_s", Numbers.exact(2 * task.n() / millis.median() / 1e6));
            case TRANSFER -> row.put("gb_per_s", Numbers.exact(task.n() / millis.median() / 1e6));
            case STRATEGIES -> {
                row.put("indexing", task.parameters().get("indexing"));
                PairTraffic traffic = PairTraffic.of(row.get("indexing"), task.n());
                row.put("collision_bytes", Long.toString(traffic.collisionBytes()));
                row.put("table_bytes", Long.toString(traffic.tableBytes()));
            }
            case PEERS -> {
                row.put("skipped", Integer.toString(task.skipped()));
                row.put("remarks", Engines.remarks(row.get("engine")));
            }
            case WORLD -> {
                row.put("skipped", task.parameters().get("skipped"));
                row.put("state_hash", hash(run.counter("hashHigh"), run.counter("hashLow")));
            }
            default -> throw new AssertionError(task.kind());
        }
    }

    /** JMH's counters are doubles, which hold half a hash without loss. */
    static String hash(double high, double low) {
        return String.format("%08x%08x", (long) high, (long) low);
    }
}
