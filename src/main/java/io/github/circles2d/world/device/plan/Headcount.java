package io.github.circles2d.world.device.plan;

/**
 * How many work-groups make steps together if other programs want the processors, too. Work-groups that wait for one without a
 * processor keep their own busy, and the system takes turns with them: a step may take a hundred times as long. One work-group
 * waits for nobody. So when waiting takes much of the time, half as many are tried, and half of these, until nobody waits for
 * long; the number with the shortest steps stays. After a pause twice as many are tried again. While nobody waits for long,
 * nothing is tried.
 */
final class Headcount {
    /** How long is measured before a decision: a few time slices of a system. In the kernels' unit, {@code UNIT_LOG}: 20 ms. */
    static final int WINDOW = 1 << 10;

    /** Waiting matters from this share of the time on: one in so many parts. */
    private static final int WAITING_SHARE = 4;

    /** A pause is so many times as long as the last trial took. */
    private static final int LEAST_PAUSE = 4;

    /** A pause grows up to this factor while trials fail, so that they cost hardly anything. */
    private static final int MOST_PAUSE = 64;

    private final int greatest;
    private int most;

    /** Whether other numbers are tried, and the number before that. */
    private boolean trying;

    private int before;

    /** The number with the shortest steps so far, what a step takes with it, and how long the trial has taken. */
    private int best;

    private double bestCost;
    private long trialTime;

    /** Time until the next trial, and the factor of the next pause. */
    private long pause;

    private int pauseFactor = LEAST_PAUSE;

    /** Sums since the last decision. */
    private int steps;

    private long took;
    private long waited;

    /**
     * All work-groups that there can be.
     *
     * @param greatest how many
     */
    Headcount(int greatest) {
        this.greatest = greatest;
        most = greatest;
    }

    /** How many work-groups to take at most. */
    int most() {
        return most;
    }

    /**
     * Takes note of steps.
     *
     * @param groups how many work-groups made them
     * @param useful how many would be of use if nobody else wanted the processors
     * @param made number of steps
     * @param time how long the work-groups took, added up
     * @param waiting how much of it they waited for others without a processor
     */
    void learn(int groups, int useful, int made, long time, long waiting) {
        steps += made;
        took += time / groups;
        waited += waiting / groups;
        if (took < WINDOW || steps == 0) {
            return;
        }
        double cost = (double) took / steps;
        boolean hindered = waited > took / WAITING_SHARE;
        if (trying) {
            trialTime += took;
            if (cost < bestCost) {
                best = most;
                bestCost = cost;
            }
            if (most < before && hindered && groups > 1) {
                most = groups / 2;
            } else {
                decide();
            }
        } else if (pause > 0) {
            pause -= took;
        } else if (hindered && groups > 1) {
            tryInstead(groups / 2, cost);
        } else if (groups == most && most < Math.min(greatest, useful)) {
            tryInstead(Math.min(greatest, 2 * most), cost);
        }
        steps = 0;
        took = 0;
        waited = 0;
    }

    private void tryInstead(int other, double cost) {
        trying = true;
        before = most;
        best = most;
        bestCost = cost;
        trialTime = 0;
        most = other;
    }

    private void decide() {
        trying = false;
        most = best;
        pauseFactor = best == before ? Math.min(MOST_PAUSE, 2 * pauseFactor) : LEAST_PAUSE;
        pause = best > before ? 0 : pauseFactor * trialTime;
    }
}
