package io.github.circles2d.bench.physics;

/**
 * How much of a row is run.
 *
 * @param seeds runs of a case that draws random numbers
 * @param share share of the full number of steps, samples and variants
 */
record Effort(int seeds, double share) {
    static final Effort FULL = new Effort(3, 1);

    /** What the tests run: one seed, at full length. */
    static final Effort TEST = new Effort(1, 1);

    /** For a look: a figure of fewer steps may lie elsewhere. */
    static final Effort QUICK = new Effort(1, 0.25);

    /** The number of steps, or samples, to run instead of the full number. */
    int of(int full) {
        return (int) Math.ceil(full * share);
    }
}
