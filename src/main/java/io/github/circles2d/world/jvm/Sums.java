package io.github.circles2d.world.jvm;

import io.github.circles2d.world.jvm.threads.Team;

/** Turns counts into starts by an exclusive running sum; each worker takes a part. */
public final class Sums {
    /** Longs from the total of one worker to that of the next, so that they lie in different cache lines. */
    private static final int APART = 16;

    private final Team team;

    /** By worker: what its part adds up to. */
    private final long[] totals;

    Sums(Team team) {
        this.team = team;
        totals = new long[APART * team.most()];
    }

    /** Sums up counts [0, n) in place, and writes the total to element n. Counts have been synchronized before. */
    void sumUp(int worker, int[] counts, int n) {
        int from = team.part(n, worker);
        int to = team.part(n, worker + 1);
        int sum = 0;
        if (team.size() > 1) {
            for (int k = from; k < to; k++) {
                sum += counts[k];
            }
            totals[APART * worker] = sum;
            team.sync(worker);
            sum = 0;
            for (int w = 0; w < worker; w++) {
                sum += (int) totals[APART * w];
            }
        }
        for (int k = from; k < to; k++) {
            int count = counts[k];
            counts[k] = sum;
            sum += count;
        }
        if (worker == team.size() - 1) {
            counts[n] = sum;
        }
        team.sync(worker);
    }
}
