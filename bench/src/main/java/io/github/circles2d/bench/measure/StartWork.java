package io.github.circles2d.bench.measure;

import io.github.circles2d.bench.engines.Starts;
import io.github.circles2d.bench.results.Numbers;
import io.github.circles2d.opencl.OpenClException;
import java.io.IOException;

/**
 * Makes the state that World's runs of a size start from. If that fails, each of them makes it for itself.
 *
 * @param first the first run of the size, whose engine makes the state
 * @param skipped steps before the state
 */
record StartWork(Task first, int skipped) implements Work {
    @Override
    public String label() {
        return "start of packed " + first.n();
    }

    @Override
    public double seconds(Pace pace) {
        return 0.5 + 2e-6 * first.n() + skipped * pace.stepMillis(first) / 1000;
    }

    @Override
    public String run(Pace pace, double secondsLeft) {
        if (seconds(pace) > secondsLeft) {
            return "left out: it would take about " + Numbers.brief(seconds(pace)) + " s";
        }
        try {
            Starts.keep(first.key().get("engine"), (int) first.n(), skipped);
            return "the state after " + skipped + " steps";
        } catch (IOException | OpenClException | OutOfMemoryError e) {
            return "failed: " + e.getMessage();
        }
    }
}
