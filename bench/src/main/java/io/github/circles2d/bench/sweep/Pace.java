package io.github.circles2d.bench.sweep;

import java.util.HashMap;
import java.util.Map;

/** Foretells how long a task takes from those that ran. */
final class Pace {
    private final Map<String, Long> sizes = new HashMap<>();
    private final Map<String, Double> costs = new HashMap<>();
    private double forkSeconds = 2;
    private int forks;

    /** Learns from a run. */
    void learn(Task task, double msPerStep, double wallSeconds, int iterations) {
        remember(task.series(), task.n(), msPerStep);
        double overhead = wallSeconds - iterations * iterationSeconds(task);
        // A mean over the forks so far, begun by one at the first guess.
        forks++;
        forkSeconds += (Math.max(0.3, overhead) - forkSeconds) / (forks + 1);
    }

    /** Takes a series' cost from an earlier sweep. Call it in the order of the sizes. */
    void remember(String series, long n, double msPerStep) {
        sizes.put(series, n);
        costs.put(series, msPerStep);
    }

    /** Ms a step. */
    double stepMillis(Task task) {
        Double cost = costs.get(task.series());
        if (cost == null) {
            return task.firstGuess();
        }
        return cost * Math.pow(task.n() / (double) sizes.get(task.series()), task.growth());
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
