package io.github.circles2d.bench.jmh;

import java.util.Map;
import org.openjdk.jmh.annotations.AuxCounters;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.State;

/**
 * Time of World's stages in microseconds a step: device time from the driver's profiling events, or a thread's own clock on the
 * JVM. What World counts for its statistics is in it once an iteration, not once a step.
 */
@AuxCounters(AuxCounters.Type.EVENTS)
@State(Scope.Thread)
public class StageTimes {
    /** Of the sort into the cells of the grid. */
    public double gridMicros;

    /** Of the prefix sums that sort and contact list share, where they are kernels of their own. */
    public double scanMicros;

    /** Of the look-out of fast circles. */
    public double sweepMicros;

    /** Of the contact list. */
    public double contactsMicros;

    /** Of the sub-steps. */
    public double solverMicros;

    /** Of whole steps that are one launch. */
    public double residentMicros;

    /** Of everything else. */
    public double otherMicros;

    void set(Map<String, Double> millisBefore, Map<String, Double> millisAfter, int steps) {
        gridMicros = 0;
        scanMicros = 0;
        sweepMicros = 0;
        contactsMicros = 0;
        solverMicros = 0;
        residentMicros = 0;
        otherMicros = 0;
        millisAfter.forEach(
                (stage, millis) -> add(stage, 1000 * (millis - millisBefore.getOrDefault(stage, 0.0)) / steps));
    }

    private void add(String stage, double micros) {
        switch (stage) {
            case "Grid":
                gridMicros += micros;
                break;
            case "Scan":
                scanMicros += micros;
                break;
            case "ContinuousCollision":
                sweepMicros += micros;
                break;
            case "Contacts":
                contactsMicros += micros;
                break;
            case "Solver":
                solverMicros += micros;
                break;
            case "PersistentGpu":
                residentMicros += micros;
                break;
            default:
                otherMicros += micros;
        }
    }
}
