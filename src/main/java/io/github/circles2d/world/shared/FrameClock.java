package io.github.circles2d.world.shared;

/**
 * Adds up how long a world's calls take from one call of step to the next: steps, reads, and waiting for a device; calls that look into tables of
 * the host are left out. It stands unless somebody wants to know. A call that fails leaves its time out.
 */
public final class FrameClock {
    private boolean on;

    /** Calls that are within each other. */
    private int depth;

    private long begun;
    private long sum;

    /** Steps of the last call of step. */
    private int steps;

    void turnOn() {
        on = true;
    }

    /** A call of step begins, within which all others are. */
    public void beginStep() {
        depth = 0;
        begin();
    }

    public void begin() {
        if (on && depth++ == 0) {
            begun = System.nanoTime();
        }
    }

    public void end() {
        if (on && --depth == 0) {
            sum += System.nanoTime() - begun;
        }
    }

    /** Ends a frame within a call of step: returns its time for a step, 0 if it is not known, and begins another with so many steps. */
    double endFrame(int nextSteps) {
        long now = System.nanoTime();
        double nanos = steps == 0 ? 0 : (double) (sum + now - begun) / steps;
        begun = now;
        sum = 0;
        steps = nextSteps;
        return nanos;
    }
}
