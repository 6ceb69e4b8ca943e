package io.github.circles2d.bench.jmh;

import io.github.circles2d.scenes.Quality;
import org.openjdk.jmh.annotations.AuxCounters;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.State;

/** What JMH reports beside the time: the quality of the end state, and what the run took of the process. */
@AuxCounters(AuxCounters.Type.EVENTS)
@State(Scope.Thread)
public class Outcome {
    /** Mean depth of the overlapping pairs, in mean radii. */
    public double meanDepth;

    /** Depth of the deepest pair, in mean radii. */
    public double maxDepth;

    /** Pairs deeper than 0.1 mean radii. */
    public double deepPairs;

    /** All overlapping pairs. */
    public double overlappingPairs;

    /** Mean kinetic energy of a circle. */
    public double kineticEnergy;

    /** Bytes allocated on the Java heap, a step. */
    public double allocatedBytes;

    /** Greatest resident memory of the process, MiB. */
    public double peakResidentMiB;

    void set(Quality quality, double allocatedBytesPerStep) {
        meanDepth = quality.meanDepth();
        maxDepth = quality.maxDepth();
        deepPairs = quality.deep();
        overlappingPairs = quality.overlapping();
        kineticEnergy = quality.kineticEnergyPerCircle();
        allocatedBytes = allocatedBytesPerStep;
        peakResidentMiB = Usage.peakResidentMiB();
    }
}
