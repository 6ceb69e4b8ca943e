package io.github.circles2d.world.jvm.state;

import io.github.circles2d.world.jvm.threads.Team;

/** Turns counts into starts by an exclusive running sum; each worker takes a part. */
public final class Sums {
    /** Longs from the total of one worker to that of the next, so that they lie in different cache lines. */
    private static final int APART = 16;

    private final Team team;

    /** By worker: what its part adds up to. */
    private final long[] totals;

    private final Team.Work addUp = this::addUp;
    private final Team.Work setStarts = this::setStarts;

    private int[] counts;
    private int n;

    public Sums(Team team) {
        this.team = team;
        totals = new long[APART * team.most()];
    }

    /** Sums up counts [0, length) in place, and writes the total to the element behind them. */
    public void sumUp(int[] of, int length) {
        counts = of;
        n = length;
        if (team.size() > 1) {
            team.all(addUp);
        }
        team.all(setStarts);
    }

    private void addUp(int worker) {
        int to = team.part(n, worker + 1);
        int sum = 0;
        for (int k = team.part(n, worker); k < to; k++) {
            sum += counts[k];
        }
        totals[APART * worker] = sum;
    }

    private void setStarts(int worker) {
        int sum = 0;
        for (int w = 0; w < worker; w++) {
            sum += (int) totals[APART * w];
        }
        int to = team.part(n, worker + 1);
        for (int k = team.part(n, worker); k < to; k++) {
            int count = counts[k];
            counts[k] = sum;
            sum += count;
        }
        if (worker == team.size() - 1) {
            counts[n] = sum;
        }
    }
}
