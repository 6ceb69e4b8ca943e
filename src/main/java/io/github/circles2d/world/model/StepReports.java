package io.github.circles2d.world.model;

/** What a step reports; no step depends on it. */
public final class StepReports {
    /** Contacts, walls and pieces of terrain. */
    public boolean recording;

    /** Pieces of terrain, those that only sense among them. */
    public boolean pieces;

    /** Pairs that are only sensed. */
    public boolean sensing;

    /** Pairs of static circles. */
    public boolean statics;

    /** Pairs of static circles and pieces of bodies. */
    public boolean bodies;

    /** Bits by kind, whether it asks for those; null if none does. */
    public long[] asking;

    /** By pair of kinds, who looks for whom: {@link SensorRule}. */
    public int[] seeking;

    public int seekingVersion;

    /** The bits are read during the step. */
    public void setStatics(boolean ofCircles, boolean ofBodies, long[] kinds) {
        statics = ofCircles;
        bodies = ofBodies;
        asking = kinds;
    }

    /** Whether static circles of a kind sense others, too. */
    public static boolean asks(long[] kinds, int kind) {
        return (kinds[kind / Long.SIZE] >>> kind & 1L) != 0;
    }

    /** The table is read during the step. */
    public void set(boolean records, boolean ofPieces, boolean senses, int[] table, int version) {
        recording = records;
        pieces = ofPieces;
        sensing = senses;
        seeking = table;
        seekingVersion = version;
    }
}
