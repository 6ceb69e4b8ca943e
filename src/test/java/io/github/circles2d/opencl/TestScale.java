package io.github.circles2d.opencl;

/**
 * How much a test tries: little in each build, and all if the profile {@code exhaustive} is on. So one test proves a promise on both
 * scales, and an exhaustive run repeats nothing.
 */
public final class TestScale {
    /** Whether tests may take minutes. */
    public static final boolean EXHAUSTIVE = Boolean.getBoolean("circles2d.exhaustive");

    private TestScale() {}

    /** A number of rounds, seeds or steps. */
    public static int of(int few, int all) {
        return EXHAUSTIVE ? all : few;
    }
}
