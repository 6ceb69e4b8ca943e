package io.github.circles2d.bench.jmh;

import io.github.circles2d.WorldStats;
import io.github.circles2d.scenes.Quality;
import org.openjdk.jmh.annotations.AuxCounters;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.State;

/** What JMH reports of World beside the time: the end state and what the run took. */
@AuxCounters(AuxCounters.Type.EVENTS)
@State(Scope.Thread)
public class WorldOutcome {
    /** Contacts of the last step. */
    public double contacts;

    /** Pairs whose distance the last step tested. */
    public double candidatePairs;

    /** Bytes that the engine holds, on the device where there is one. */
    public double bytesHeld;

    /** Mean depth of the overlapping pairs, in mean radii. */
    public double meanDepth;

    /** Depth of the deepest pair, in mean radii. */
    public double maxDepth;

    /** Pairs deeper than 0.1 mean radii. */
    public double deepPairs;

    /** Mean kinetic energy of a circle. */
    public double kineticEnergy;

    /** Upper half of the hash of the end state. */
    public double hashHigh;

    /** Lower half of the hash of the end state. */
    public double hashLow;

    /** Bytes allocated on the Java heap, a step. */
    public double allocatedBytes;

    /** Greatest resident memory of the process, MiB. */
    public double peakResidentMiB;

    void set(WorldStats stats, long hash, Quality quality, double allocatedBytesPerStep) {
        contacts = stats.contacts();
        candidatePairs = stats.candidatePairs();
        bytesHeld = stats.bytesHeld();
        hashHigh = hash >>> 32;
        hashLow = hash & 0xFFFF_FFFFL;
        meanDepth = quality.meanDepth();
        maxDepth = quality.maxDepth();
        deepPairs = quality.deep();
        kineticEnergy = quality.kineticEnergyPerCircle();
        allocatedBytes = allocatedBytesPerStep;
        peakResidentMiB = Usage.peakResidentMiB();
    }
}
