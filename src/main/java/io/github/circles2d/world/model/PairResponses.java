package io.github.circles2d.world.model;

/** What circles do to each other, by kinds. */
public final class PairResponses {
    /** A table of {@link PairTable}; read during the step. */
    public int[] table;

    public int version;

    public void set(int[] responses, int ofVersion) {
        table = responses;
        version = ofVersion;
    }
}
