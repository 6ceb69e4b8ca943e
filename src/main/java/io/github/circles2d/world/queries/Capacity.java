package io.github.circles2d.world.queries;

/** How arrays grow: by half at least, so that a crowd that grows one by one leaves little garbage. */
final class Capacity {
    private static final int LEAST = 16;

    private Capacity() {}

    static int atLeast(int n, int held) {
        return Math.max(Math.max(n, LEAST), held + (held >> 1));
    }
}
