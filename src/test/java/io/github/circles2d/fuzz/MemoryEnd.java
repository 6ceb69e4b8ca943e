package io.github.circles2d.fuzz;

import java.util.Random;

/** Lets memory end in calls. */
interface MemoryEnd {
    /** Lets memory end in the call that is made next, or does not: at later attempts at one call, it ends later, and at last not at all. */
    void begin(Random random, int attempt);

    /** There is memory again; returns whether it may have ended. */
    boolean end();
}
