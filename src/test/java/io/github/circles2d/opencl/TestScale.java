package io.github.circles2d.opencl;

/**
 * How much a test tries: little in each build, more if the profile {@code long} is on, and all if {@code exhaustive} is. So one test proves
 * a promise on each scale, and a longer run repeats nothing.
 */
public final class TestScale {
    /** Whether tests may take minutes. */
    public static final boolean EXHAUSTIVE = Boolean.getBoolean("circles2d.exhaustive");

    /** Whether tests may take ten seconds, or build programs that no other test needs: in CI for each commit, and in an exhaustive run. */
    public static final boolean LONG = EXHAUSTIVE || Boolean.getBoolean("circles2d.long");

    private TestScale() {}

    /** A number of rounds, seeds or steps. */
    public static int of(int few, int all) {
        return EXHAUSTIVE ? all : few;
    }

    /** The same, of which each build makes the fewest. */
    public static int of(int fewest, int few, int all) {
        return LONG ? of(few, all) : fewest;
    }
}
