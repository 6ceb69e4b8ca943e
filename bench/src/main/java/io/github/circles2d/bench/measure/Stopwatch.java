package io.github.circles2d.bench.measure;

import io.github.circles2d.bench.engines.Engine;
import io.github.circles2d.bench.engines.Motion;
import io.github.circles2d.bench.results.Numbers;
import io.github.circles2d.bench.results.Statistics;
import io.github.circles2d.bench.results.Table;
import io.github.circles2d.scenes.Scene;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Measures one engine on one scene. A run loads the scene, makes the steps that do not count, then those that do, with a wait after
 * each, and takes their median. There are several runs, the first of which warm the JVM up; the least median counts, and all runs
 * must end in the same state.
 */
final class Stopwatch {
    /** At least so many runs, if the patience lasts. */
    static final int RUNS = 5;

    private static final int MOST_RUNS = 40;

    /** Short runs are repeated for so long: the JVM compiles meanwhile. */
    private static final double SECONDS = 2;

    /** After this share of the patience, and this many seconds, the first run says whether it can end in time. */
    private static final double TRIAL = 0.4;

    private static final double TRIAL_SECONDS = 3;

    /** The first run may take so many times the patience. */
    private static final double ALLOWANCE = 1.5;

    private static final int TRIAL_STEPS = 3;

    private final Series series;
    private final Scene scene;
    private final Engine engine;
    private final double patience;
    private final long start = System.nanoTime();

    private Stopwatch(Series series, int n, Engine engine, double patience) {
        this.series = series;
        this.engine = engine;
        this.patience = patience;
        scene = series.scene(n);
    }

    /**
     * Measures.
     *
     * @param patience seconds after which no further run begins; a first run that would take much longer is given up
     * @return columns of the table, a status among them
     * @throws IllegalStateException if a run ends in another state than the one before it, or in none
     */
    static Map<String, String> measure(Series series, int n, Engine engine, double patience) {
        return new Stopwatch(series, n, engine, patience).measure();
    }

    private Map<String, String> measure() {
        List<Double> medians = new ArrayList<>();
        double mean = Double.POSITIVE_INFINITY;
        Long hash = null;
        Motion end = new Motion(scene.size());
        double before;
        double last;
        do {
            before = elapsed();
            double[] millis = run(medians.isEmpty());
            if (millis.length < Series.STEPS) {
                return givenUp(millis.length == 0 ? 0 : millis[0]);
            }
            Statistics run = Statistics.of(millis);
            medians.add(run.median());
            mean = Math.min(mean, run.mean());
            engine.read(end);
            if (hash != null && hash != end.hash() && engine.repeatable()) {
                throw new IllegalStateException("the same run ended in another state");
            }
            hash = end.hash();
            last = elapsed() - before;
        } while (another(medians.size(), last));
        Map<String, String> row = new LinkedHashMap<>();
        EndState.put(row, scene, end);
        putTimes(row, medians, mean);
        row.put("state_hash", engine.repeatable() ? String.format("%016x", hash) : "");
        row.put("status", "ok");
        return row;
    }

    /** Puts what the medians of some runs come to. */
    static void putTimes(Map<String, String> row, List<Double> medians, double leastMean) {
        Statistics runs =
                Statistics.of(medians.stream().mapToDouble(Double::doubleValue).toArray());
        row.put("runs", Integer.toString(runs.runs()));
        row.put("median_ms", Numbers.exact(runs.min()));
        row.put("middle_median_ms", Numbers.exact(runs.median()));
        row.put("mean_ms", Numbers.exact(leastMean));
    }

    private boolean another(int runs, double last) {
        boolean wanted = runs < RUNS || elapsed() < SECONDS && runs < MOST_RUNS;
        return wanted && elapsed() + last < patience;
    }

    /** Ms of each step that counts; fewer if the run was given up: the mean of those that were made, or none. */
    private double[] run(boolean first) {
        engine.load(scene);
        engine.finish();
        int all = series.skipped + Series.STEPS;
        double[] millis = new double[Series.STEPS];
        double fastest = Double.POSITIVE_INFINITY;
        long begun = System.nanoTime();
        for (int step = 0; step < all; step++) {
            long from = System.nanoTime();
            engine.step();
            engine.finish();
            long to = System.nanoTime();
            if (step >= series.skipped) {
                millis[step - series.skipped] = (to - from) / 1e6;
            }
            double seconds = (to - begun) / 1e9;
            fastest = Math.min(fastest, (to - from) / 1e9);
            if (first && step + 1 < all && hopeless(step + 1, all, seconds, fastest)) {
                return new double[] {1e3 * seconds / (step + 1)};
            }
        }
        return millis;
    }

    /**
     * By the fastest step so far: the first ones take longer, since overlaps come apart and the JVM compiles, which can be ten
     * times as long.
     */
    private boolean hopeless(int done, int all, double seconds, double fastest) {
        double most = ALLOWANCE * patience;
        boolean tried = done >= TRIAL_STEPS && seconds > Math.max(TRIAL_SECONDS, TRIAL * patience);
        return tried && seconds + (all - done) * fastest > most || seconds > most;
    }

    private Map<String, String> givenUp(double millis) {
        return Table.columns(
                "mean_ms",
                Numbers.exact(millis),
                "status",
                "left out: " + (series.skipped + Series.STEPS) + " steps of about " + Numbers.brief(millis)
                        + " ms would take longer than the " + Numbers.brief(patience) + " s that they have");
    }

    private double elapsed() {
        return (System.nanoTime() - start) / 1e9;
    }
}
