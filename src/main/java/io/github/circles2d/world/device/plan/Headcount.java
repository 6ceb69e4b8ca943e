package io.github.circles2d.world.device.plan;

/**
 * How many work-groups make steps together if other programs want the processors, too. Work-groups that wait for one without a
 * processor keep their own busy, and the system takes turns with them: a step may take a hundred times as long. One work-group
 * waits for nobody. So when waiting takes much of the time, half as many are tried, and kept if steps take less time so. After a
 * pause twice as many are tried again. While nobody waits for long, nothing is tried.
 */
final class Headcount {
    /** How long is measured before a decision: a few time slices of a system. In the kernels' unit, {@code UNIT_LOG}: 20 ms. */
    static final long WINDOW = 1 << 10;

    /** Waiting matters from this share of the time on: one in so many parts. */
    private static final int WAITING_SHARE = 4;

    /** A pause is so many times as long as the last trial took. */
    private static final int LEAST_PAUSE = 4;

    /** A pause grows up to this factor while trials fail, so that they cost hardly anything. */
    private static final int MOST_PAUSE = 64;

    private final int greatest;
    private int most;

    /** The number before the trial that runs, 0 if there is none; and what a step took with it. */
    private int former;

    private double formerCost;

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
        if (former != 0) {
            end(cost);
        } else if (pause > 0) {
            pause -= took;
        } else if (hindered && groups > 1) {
            begin(groups / 2, cost);
        } else if (groups == most && most < Math.min(greatest, useful)) {
            begin(Math.min(greatest, 2 * most), cost);
        }
        steps = 0;
        took = 0;
        waited = 0;
    }

    private void begin(int next, double cost) {
        former = most;
        formerCost = cost;
        most = next;
    }

    private void end(double cost) {
        boolean better = cost < formerCost;
        boolean more = most > former;
        if (!better) {
            most = former;
        }
        pauseFactor = better ? LEAST_PAUSE : Math.min(MOST_PAUSE, 2 * pauseFactor);
        pause = better && more ? 0 : pauseFactor * took;
        former = 0;
    }
}
