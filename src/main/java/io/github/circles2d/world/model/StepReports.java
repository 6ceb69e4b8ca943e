package io.github.circles2d.world.model;

/** What a step reports; no step depends on it. */
public final class StepReports {
    /** Contacts, walls and pieces of terrain. */
    public boolean recording;

    /** Pieces of terrain, those that only sense among them. */
    public boolean pieces;

    /** Pairs that are only sensed. */
    public boolean sensing;

    /** By pair of kinds, who looks for whom: {@link SensorRule}. */
    public int[] seeking;

    public int seekingVersion;

    /** The table is read during the step. */
    public void set(boolean records, boolean ofPieces, boolean senses, int[] table, int version) {
        recording = records;
        pieces = ofPieces;
        sensing = senses;
        seeking = table;
        seekingVersion = version;
    }
}
