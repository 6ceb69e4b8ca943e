package io.github.circles2d.world.model;

/** Which part of a step is reported. It changes nothing in the step. */
public final class StepReports {
    /** Whether what contacts or walls do is reported. */
    public boolean recording;

    /** Whether some pairs that are only sensed are reported. */
    public boolean sensing;

    /** By pair of kinds, which of two circles looks for the other, if the pair is sensed and reported: by {@link SensorRule}. */
    public int[] seeking;

    /** Counts the changes of {@link #seeking}. */
    public int seekingVersion;

    /** Sets all of it; the table is read during the step. */
    public void set(boolean records, boolean senses, int[] table, int version) {
        recording = records;
        sensing = senses;
        seeking = table;
        seekingVersion = version;
    }
}
