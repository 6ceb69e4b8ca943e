package io.github.circles2d.playground;

import io.github.circles2d.Rewind;
import io.github.circles2d.World;

/** The last steps of a world, to go back to, in so much memory. */
final class Timeline {
    /** Fifteen seconds. */
    private static final int STEPS = 900;

    private static final int LEAST_STEPS = 8;
    private static final long GREATEST_BYTES = 256L << 20;

    private final World world;
    private final long budget;
    private int steps = STEPS;
    private Rewind rewind;

    Timeline(World world) {
        this(world, Math.min(GREATEST_BYTES, Runtime.getRuntime().maxMemory() / 4));
    }

    Timeline(World world, long budget) {
        this.world = world;
        this.budget = budget;
        rewind = new Rewind(world, steps);
    }

    /** Saves the world as it is after so many steps. */
    void save(int step) {
        if (rewind.bytes() > budget && steps > LEAST_STEPS) {
            steps = Math.max(LEAST_STEPS, Math.min(rewind.size(), steps) / 2);
            rewind = new Rewind(world, steps);
        }
        rewind.save(step);
    }

    /**
     * Goes back by a step.
     *
     * @param step how many steps the world has made
     * @return how many it has made now; as many if there is no way back
     */
    int back(int step) {
        if (!rewind.has(step - 1)) {
            return step;
        }
        rewind.restore(step - 1);
        return step - 1;
    }

    /** Memory of the past. */
    long bytes() {
        return rewind.bytes();
    }

    /** How many steps there are to go back by. */
    int stepsBefore(int step) {
        return rewind.has(step - 1) ? step - rewind.oldest() : 0;
    }
}
