package io.github.circles2d.bench.broadphase;

import io.github.circles2d.bench.results.Statistics;
import java.util.ArrayList;
import java.util.List;

/**
 * What a broad phase takes for a step of a track. A round starts from nothing, goes through the first steps untimed, so that
 * boxes and lists are as old as they get, and times the others together. The first round counts.
 *
 * @param millis of a step; each value is the mean of a round
 * @param work of the timed steps together
 * @param steps timed steps of a round
 * @param pairs of the timed steps together
 * @param checksum of the pairs of all timed steps
 */
record Measurement(Statistics millis, Counts work, int steps, long pairs, long checksum) {
    /** Rounds at the least, so that a median tells something, and at most. */
    private static final int LEAST_ROUNDS = 3;

    private static final int MOST_ROUNDS = 2000;

    /** If the first round takes longer, it is the only one: such a broad phase is compiled long before its end. */
    private static final long SLOW_NANOS = 2_000_000_000L;

    /**
     * Measures.
     *
     * @param untimed steps at the beginning of the track, at least one
     * @param seconds processor time to spend; the rounds of its first half, in which the JVM compiles, do not count
     */
    static Measurement of(BroadPhases kind, Track track, int untimed, double seconds) {
        PairList pairs = new PairList();
        long first = Clock.nanos();
        Round counted = new Round(kind, track, untimed, pairs, true);
        int steps = track.steps() - untimed;
        if (Clock.nanos() - first > SLOW_NANOS) {
            return new Measurement(Statistics.of(counted.millis), counted.work, steps, counted.found, counted.checksum);
        }
        long begin = Clock.nanos();
        List<Double> early = new ArrayList<>();
        List<Double> late = new ArrayList<>();
        double spent = 0;
        do {
            double millis = new Round(kind, track, untimed, pairs, false).millis;
            (spent < 0.5 * seconds ? early : late).add(millis);
            spent = (Clock.nanos() - begin) * 1e-9;
        } while (late.size() < LEAST_ROUNDS && spent < 6 * seconds || spent < seconds && late.size() < MOST_ROUNDS);
        // A round that is longer than the time there is counts alone.
        List<Double> rounds = late.isEmpty() ? early.subList(early.size() - 1, early.size()) : late;
        Statistics statistics =
                Statistics.of(rounds.stream().mapToDouble(Double::doubleValue).toArray());
        return new Measurement(statistics, counted.work, steps, counted.found, counted.checksum);
    }

    private static final class Round {
        private final double millis;
        private Counts work;
        private long found;
        private long checksum;

        private Round(BroadPhases kind, Track track, int untimed, PairList pairs, boolean counts) {
            BroadPhase phase = kind.create();
            phase.start(track.reach);
            // A broad phase that keeps nothing needs one step only, for its arrays.
            for (int step = phase.isIncremental() ? 0 : untimed - 1; step < untimed; step++) {
                pairs.clear();
                phase.findPairs(track.x[step], track.y[step], pairs);
            }
            Counts before = counts ? phase.counts().copy() : null;
            long spent = 0;
            long begin = Clock.nanos();
            for (int step = untimed; step < track.steps(); step++) {
                pairs.clear();
                phase.findPairs(track.x[step], track.y[step], pairs);
                if (counts) {
                    spent += Clock.nanos() - begin;
                    found += pairs.size();
                    checksum = 31 * checksum + pairs.checksum();
                    begin = Clock.nanos();
                }
            }
            millis = (spent + Clock.nanos() - begin) * 1e-6 / (track.steps() - untimed);
            if (counts) {
                work = phase.counts().since(before);
            }
        }
    }
}
