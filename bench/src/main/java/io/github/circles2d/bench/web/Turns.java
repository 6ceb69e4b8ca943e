package io.github.circles2d.bench.web;

import io.github.circles2d.bench.engines.Motion;
import io.github.circles2d.bench.measure.EndState;
import io.github.circles2d.bench.measure.SceneFiles;
import io.github.circles2d.bench.measure.Series;
import io.github.circles2d.bench.results.Numbers;
import io.github.circles2d.bench.results.Statistics;
import io.github.circles2d.scenes.Scene;
import java.io.IOException;
import java.nio.file.Path;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/** The runs of an entrant on a scene: one a turn. */
final class Turns implements AutoCloseable {
    static final int MOST_RUNS = 40;

    /** At least so many runs, if the patience lasts, and for so many seconds: an engine is compiled meanwhile. */
    private static final int RUNS = 7;

    private static final double SECONDS = 4;

    /** A run is not begun that would end later. */
    private static final double PATIENCE = 25;

    /** A run that would take longer is given up. */
    private static final double LIMIT = 45;

    private final Entrant entrant;
    private final Scene scene;
    private final Path state;
    private final int mostRuns;
    private final Runner runner;
    private final List<Double> medians = new ArrayList<>();
    private double leastMean = Double.POSITIVE_INFINITY;
    private double spent;
    private double last;
    private boolean givenUp;
    private Motion end;

    Turns(Entrant entrant, Scene scene, List<String> command, Path state, int mostRuns) throws IOException {
        this.entrant = entrant;
        this.scene = scene;
        this.state = state;
        this.mostRuns = mostRuns;
        runner = new Runner(command);
    }

    Entrant entrant() {
        return entrant;
    }

    /** Makes a run, unless there were enough; says if it did. */
    boolean take() throws IOException {
        boolean wanted = medians.size() < RUNS || spent < SECONDS;
        boolean fits = medians.isEmpty() || spent + last < PATIENCE;
        if (givenUp || medians.size() >= mostRuns || !wanted || !fits) {
            return false;
        }
        long before = System.nanoTime();
        Runner.Figures figures = runner.run(LIMIT);
        last = (System.nanoTime() - before) / 1e9;
        spent += last;
        leastMean = Math.min(leastMean, figures.mean());
        givenUp = !figures.ended();
        if (figures.ended()) {
            medians.add(figures.median());
            end = SceneFiles.endState(state, scene.size());
        }
        return true;
    }

    /** Changes with any bit of the state in which the last run ended. */
    String hash() {
        return end == null ? "" : String.format("%016x", end.hash());
    }

    Map<String, String> row() {
        Map<String, String> row = entrant.key(scene.size());
        row.put("skipped", Integer.toString(WebBench.SERIES.skipped));
        row.put("steps", Integer.toString(Series.STEPS));
        row.put("mean_us", Numbers.exact(leastMean));
        row.put("date", LocalDate.now(ZoneOffset.UTC).toString());
        row.put("remarks", runner.description());
        if (medians.isEmpty()) {
            row.put("status", "left out: a run would take longer than " + Numbers.brief(LIMIT) + " s");
            return row;
        }
        Statistics runs =
                Statistics.of(medians.stream().mapToDouble(Double::doubleValue).toArray());
        row.put("runs", Integer.toString(runs.runs()));
        row.put("median_us", Numbers.exact(runs.min()));
        row.put("middle_median_us", Numbers.exact(runs.median()));
        EndState.put(row, scene, end);
        row.put("state_hash", entrant.isWorld() ? hash() : "");
        row.put("status", "ok");
        return row;
    }

    @Override
    public void close() {
        runner.close();
    }

    @Override
    public String toString() {
        Map<String, String> row = row();
        String figure = row.get("status").equals("ok")
                ? Numbers.brief(row.get("median_us")) + " us, mean depth " + Numbers.brief(row.get("mean_depth"))
                : row.get("status");
        return entrant + ", n = " + Numbers.whole(scene.size()) + ": " + figure;
    }
}
