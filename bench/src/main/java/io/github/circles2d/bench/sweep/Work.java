package io.github.circles2d.bench.sweep;

import java.io.IOException;

/** One entry of a sweep's list. */
interface Work {
    /** For the progress line. */
    String label();

    /** About how many seconds it will take. */
    double seconds(Pace pace);

    /**
     * Does it, or leaves it out and says so in the results where it does not fit into the time.
     *
     * @param secondsLeft until the sweep is to end
     * @return a sentence on the outcome
     */
    String run(Pace pace, double secondsLeft) throws IOException;
}
