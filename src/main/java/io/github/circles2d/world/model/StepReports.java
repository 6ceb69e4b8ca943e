package io.github.circles2d.world.model;

/** What a step reports; no step depends on it. */
public final class StepReports {
    /** Contacts and walls. */
    public boolean recording;

    /** Pairs that are only sensed. */
    public boolean sensing;

    /** By pair of kinds, who looks for whom: {@link SensorRule}. */
    public int[] seeking;

    public int seekingVersion;

    /** The table is read during the step. */
    public void set(boolean records, boolean senses, int[] table, int version) {
        recording = records;
        sensing = senses;
        seeking = table;
        seekingVersion = version;
    }
}
