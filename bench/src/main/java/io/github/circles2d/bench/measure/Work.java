package io.github.circles2d.bench.measure;

import java.io.IOException;

/** One entry of the list of what is measured. */
interface Work {
    /** For the progress line. */
    String label();

    /** About how many seconds it will take. */
    double seconds(Pace pace);

    /**
     * Does it, or leaves it out and says so in the results if it does not fit into the time.
     *
     * @param secondsLeft until all is to end
     * @return a sentence on the outcome
     */
    String run(Pace pace, double secondsLeft) throws IOException;
}
