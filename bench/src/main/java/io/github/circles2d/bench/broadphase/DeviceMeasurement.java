package io.github.circles2d.bench.broadphase;

import io.github.circles2d.bench.results.Statistics;
import io.github.circles2d.opencl.Device;

/**
 * What {@link DeviceSweep} takes for a step of a track, by the time on the wall: positions are on the device before, and pairs
 * stay there. The pairs of the last step are compared with those of the JVM.
 *
 * @param millis of a step
 * @param pairs of a step
 */
record DeviceMeasurement(Statistics millis, double pairs) {
    private static final int ROUNDS = 5;

    static DeviceMeasurement of(Device device, Track track) {
        int steps = track.steps();
        double[] millis = new double[ROUNDS];
        long pairs = 0;
        try (DeviceSweep sweep = new DeviceSweep(device, track.reach)) {
            // The first round warms up: a driver compiles when a kernel first runs.
            for (int round = -1; round < ROUNDS; round++) {
                long spent = 0;
                pairs = 0;
                for (int step = 0; step < steps; step++) {
                    sweep.move(track.x[step], track.y[step]);
                    long begin = System.nanoTime();
                    pairs += sweep.findPairs();
                    spent += System.nanoTime() - begin;
                }
                if (round >= 0) {
                    millis[round] = spent * 1e-6 / steps;
                }
            }
            requireSamePairs(sweep, track);
        }
        return new DeviceMeasurement(Statistics.of(millis), (double) pairs / steps);
    }

    private static void requireSamePairs(DeviceSweep sweep, Track track) {
        PairList found = new PairList();
        sweep.read(found);
        BroadPhase grid = new HierarchicalGrid();
        grid.start(track.reach);
        PairList wanted = new PairList();
        grid.findPairs(track.x[track.steps() - 1], track.y[track.steps() - 1], wanted);
        if (found.size() != wanted.size() || found.checksum() != wanted.checksum()) {
            throw new IllegalStateException(
                    "the device finds " + found.size() + " pairs, not the " + wanted.size() + " of the JVM");
        }
    }
}
