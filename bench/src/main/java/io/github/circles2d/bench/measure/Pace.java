package io.github.circles2d.bench.measure;

import io.github.circles2d.bench.results.Numbers;
import io.github.circles2d.bench.results.ResultsFolder;
import io.github.circles2d.bench.results.ResultsFolder.Kind;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** Foretells how long a task takes from those that ran. */
final class Pace {
    private final Map<String, Long> sizes = new HashMap<>();
    private final Map<String, Double> costs = new HashMap<>();
    private double forkSeconds = 2;
    private int forks;

    /** Learns from a run. */
    void learn(Task task, double msPerStep, double wallSeconds, int iterations) {
        remember(task.family(), task.n(), msPerStep);
        double overhead = wallSeconds - iterations * iterationSeconds(task);
        // A mean over the forks so far, begun by one at the first guess.
        forks++;
        forkSeconds += (Math.max(0.3, overhead) - forkSeconds) / (forks + 1);
    }

    /** Takes what earlier measurements have left in the folder about how long things take. */
    void remember(ResultsFolder folder) {
        for (Kind kind : List.of(Kind.STRATEGIES, Kind.PEERS, Kind.WORLD, Kind.SERIES)) {
            folder.table(kind).rows("status", "ok").stream()
                    .filter(row -> !row.get("mean_ms").isEmpty())
                    .sorted(Comparator.comparingLong(row -> Long.parseLong(row.get("n"))))
                    .forEach(row -> remember(
                            Task.family(kind, row), Long.parseLong(row.get("n")), Numbers.parse(row.get("mean_ms"))));
        }
    }

    private void remember(String family, long n, double msPerStep) {
        sizes.put(family, n);
        costs.put(family, msPerStep);
    }

    /** Ms a step. */
    double stepMillis(Task task) {
        Double cost = costs.get(task.family());
        if (cost == null) {
            return task.firstGuess();
        }
        return cost * Math.pow(task.n() / (double) sizes.get(task.family()), task.growth());
    }

    /** Seconds of an iteration. */
    double iterationSeconds(Task task) {
        return task.setUpSeconds() + stepMillis(task) * (task.skipped() + task.steps() + 1) / 1000;
    }

    /** Seconds of a run with a number of iterations. */
    double seconds(Task task, int iterations) {
        return forkSeconds + iterations * iterationSeconds(task);
    }
}
