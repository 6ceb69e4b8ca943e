package io.github.circles2d.world.model;

/** What the circles of two kinds do to each other in a step. */
public final class PairResponses {
    /** A table of {@link PairTable}; read during the step. */
    public int[] table;

    public int version;

    public void set(int[] responses, int ofVersion) {
        table = responses;
        version = ofVersion;
    }
}
