package io.github.circles2d.playground;

/** The figures that a frame shows: times of steps, energies, and the hash of the state. */
final class Gauges {
    /** The hash needs a look at the whole state, so a world that runs has one every so many steps. */
    private static final int HASH_STEPS = 30;

    /** Weight of the newest time in the mean. */
    private static final double NEWEST = 0.1;

    private final History stepTimes = new History();
    private final History stepMoves = new History();
    private final History energies = new History();
    private double stepMillis;
    private long hash;
    private int hashStep = -1;

    /** Steps have been made, each of which took so long; before one of them the world may have moved to another back end. */
    void noteStep(double millis, boolean moved) {
        stepMillis = stepMillis == 0 ? millis : stepMillis + NEWEST * (millis - stepMillis);
        stepTimes.add(millis);
        stepMoves.add(moved ? 1 : 0);
    }

    void noteEnergy(double energy) {
        energies.add(energy);
    }

    /** Milliseconds a step, a running mean; 0 before the first. */
    double stepMillis() {
        return stepMillis;
    }

    /** Takes the hash if it is time: now and then while the world runs, at once if it has been changed by hand. */
    void rehash(Sandbox sandbox, boolean stepped, boolean touched) {
        int step = sandbox.step();
        boolean due = stepped ? step >= hashStep + HASH_STEPS || step < hashStep : touched;
        if (due || hashStep < 0) {
            hashNow(sandbox);
        }
    }

    /** Takes the hash, and gives it. */
    long hashNow(Sandbox sandbox) {
        hash = sandbox.world().hash();
        hashStep = sandbox.step();
        return hash;
    }

    /** Steps take another time from now on. */
    void forgetTimes() {
        stepTimes.clear();
        stepMoves.clear();
        stepMillis = 0;
    }

    /** Another world has come. */
    void forget() {
        forgetTimes();
        energies.clear();
        hashStep = -1;
    }

    void show(Frame frame) {
        frame.hash = hash;
        frame.hashStep = hashStep;
        frame.stepMillis = stepMillis;
        frame.stepTimes = stepTimes.values();
        frame.stepMoves = stepMoves.values();
        frame.energies = energies.values();
    }
}
