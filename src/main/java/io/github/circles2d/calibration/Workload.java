package io.github.circles2d.calibration;

/** What is timed. */
public enum Workload {
    /** A frame of World: a step, and a read of all circles. */
    WORLD(1),
    /** A loop of Circles2D: a step, and a read of all circles. */
    CIRCLES2D(2);

    /** The power of the number of circles that the time of a large crowd grows by. */
    final int growth;

    Workload(int growth) {
        this.growth = growth;
    }
}
