package io.github.circles2d.world.replay;

import static java.lang.Float.intBitsToFloat;

import io.github.circles2d.world.Simulation;
import io.github.circles2d.world.log.LogReader;
import io.github.circles2d.world.shared.Call;
import java.io.IOException;
import java.io.InputStream;

/**
 * Makes the calls of a log again, step by step, and compares hashes. Calls are checked as any others, so a log may come from anywhere.
 */
public final class LogPlayer {
    private final Simulation simulation;
    private final LogReader log;
    private final int[] words = new int[Call.MOST_WORDS];
    private float timeStep;

    /** Steps of the call that is being made that are still to come. */
    private int stepsLeft;

    private boolean hasEnded;
    private long steps;
    private long equalUpTo;
    private long differsAt = -1;
    private long recordedHash;
    private long hash;

    /** Reads the head of a log, and makes the world what it was when the log began. Does not close the stream. */
    public LogPlayer(InputStream in, Simulation simulation) throws IOException {
        this.simulation = simulation;
        simulation.check();
        log = new LogReader(in, LogPlayer::words);
        try {
            if (log.next() != LogReader.Next.SNAPSHOT) {
                throw LogReader.refused("it does not begin with a snapshot");
            }
            restore();
            simulation.rigids.forgetOutlines();
        } catch (IllegalArgumentException e) {
            throw placed(e);
        }
    }

    /** What is thrown for a log, also if a call or a snapshot in it is refused, with the step up to which it was played. */
    private IllegalArgumentException placed(IllegalArgumentException e) {
        String message = LogReader.isOfLog(e)
                ? e.getMessage()
                : LogReader.refused(e.getMessage()).getMessage();
        return new IllegalArgumentException(message + ", after step " + steps, e);
    }

    /** The number of ints of a call; negative if there is no such call. */
    private static int words(int number) {
        Call call = Call.of(number);
        return call == null ? -1 : call.words;
    }

    public long steps() {
        return steps;
    }

    /** The step after which the hashes differed for the first time; -1 if none has. */
    public long differsAt() {
        return differsAt;
    }

    /** The last step before that after which the hashes were equal. */
    public long equalUpTo() {
        return equalUpTo;
    }

    /** The hash in the log, where it differed. */
    public long recordedHash() {
        return recordedHash;
    }

    /** The hash that was found instead. */
    public long hash() {
        return hash;
    }

    /** Makes the calls up to the next step. Returns whether there is a step. */
    public boolean makeChanges() throws IOException {
        try {
            while (stepsLeft == 0 && !hasEnded) {
                hasEnded = !call();
            }
            return !hasEnded;
        } catch (IllegalArgumentException e) {
            throw placed(e);
        }
    }

    /** Makes the step that {@link #makeChanges} has found, and the comparison behind it. */
    public void makeStep() throws IOException {
        try {
            simulation.step(timeStep, 1);
            steps++;
            stepsLeft--;
            while (stepsLeft == 0 && log.next() == LogReader.Next.CALL && log.number() == Call.HASH.number) {
                call();
            }
        } catch (IllegalArgumentException e) {
            throw placed(e);
        }
    }

    /** Whether the end of the log has been read, and no step is left. */
    public boolean hasEnded() {
        return hasEnded;
    }

    /** Whether this is the world that is played in. */
    public boolean plays(Simulation other) {
        return simulation == other;
    }

    private boolean call() throws IOException {
        switch (log.next()) {
            case END -> {
                return false;
            }
            case SNAPSHOT -> restore();
            default -> make(Call.of(log.call(words)));
        }
        return true;
    }

    private void restore() {
        simulation.snapshots.restore(log.snapshot());
        simulation.pieces.forgetParts();
        simulation.joints.forgetForm();
    }

    private void make(Call call) {
        switch (call) {
            case STEP -> {
                timeStep = intBitsToFloat(words[0]);
                stepsLeft = words[1];
                if (stepsLeft < 1) {
                    throw LogReader.refused("a number of steps is " + stepsLeft);
                }
            }
            case HASH -> compare(Call.value(words[0], words[1]));
            default -> simulation.calls.repeat(call, words);
        }
    }

    private void compare(long expected) {
        long found = simulation.hash();
        if (found == expected && differsAt < 0) {
            equalUpTo = steps;
        } else if (differsAt < 0) {
            differsAt = steps;
            recordedHash = expected;
            hash = found;
        }
    }
}
