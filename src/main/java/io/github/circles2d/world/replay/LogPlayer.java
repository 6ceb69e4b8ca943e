package io.github.circles2d.world.replay;

import static java.lang.Float.intBitsToFloat;

import io.github.circles2d.world.Simulation;
import io.github.circles2d.world.changes.Circles;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.log.LogReader;
import io.github.circles2d.world.shared.LoggedCall;
import java.io.IOException;
import java.io.InputStream;

/**
 * Makes the calls of a log again, step by step, and compares hashes. Calls are checked as any others, so a log may come from anywhere.
 */
public final class LogPlayer {
    private final Simulation simulation;
    private final RepeatedCalls calls;
    private final LogReader log;
    private final int[] words = new int[LoggedCall.MOST_WORDS];
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
        calls = new RepeatedCalls(simulation);
        simulation.check();
        log = new LogReader(in, LogPlayer::words);
        try {
            if (log.next() != LogReader.Next.SNAPSHOT) {
                throw LogReader.refused("it does not begin with a snapshot");
            }
            restore();
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
        if (number < LoggedCall.FIRST) {
            return number == Commands.FIELD ? -1 : Commands.values(number) < 0 ? -1 : 1 + Commands.values(number);
        }
        LoggedCall call = LoggedCall.of(number);
        return call == null ? -1 : call.words;
    }

    /** Steps between two hashes. */
    public int hashEvery() {
        return log.hashEvery();
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
            while (stepsLeft == 0 && log.next() == LogReader.Next.CALL && log.number() == LoggedCall.HASH.number) {
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
            default -> make(log.call(words));
        }
        return true;
    }

    private void restore() {
        simulation.snapshots().restore(log.snapshot());
    }

    private void make(int number) {
        if (number < LoggedCall.FIRST) {
            makeCommand(number);
        } else if (number == LoggedCall.STEP.number) {
            timeStep = intBitsToFloat(words[0]);
            stepsLeft = words[1];
            if (stepsLeft < 1) {
                throw LogReader.refused("a number of steps is " + stepsLeft);
            }
        } else if (number == LoggedCall.HASH.number) {
            compare(LoggedCall.value(words[0], words[1]));
        } else {
            calls.repeat(LoggedCall.of(number), words);
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

    private void makeCommand(int operation) {
        int id = words[0];
        Circles circles = simulation.circles();
        if (operation == Commands.ADD) {
            long handle = simulation
                    .newCircles()
                    .add(
                            value(Commands.ADD_X),
                            value(Commands.ADD_Y),
                            value(Commands.ADD_RADIUS),
                            value(Commands.ADD_MASS),
                            value(Commands.ADD_VX),
                            value(Commands.ADD_VY));
            if ((int) handle != id) {
                throw LogReader.refused("a new circle has the id " + id + ", and not the lowest free one");
            }
            float restitution = value(Commands.ADD_RESTITUTION);
            if (Float.floatToRawIntBits(restitution) != Float.floatToRawIntBits(circles.restitution(handle))) {
                circles.set(Commands.RESTITUTION, handle, restitution, 0);
            }
        } else if (operation == Commands.REMOVE) {
            circles.remove(calls.handle(id));
        } else if (operation == Commands.ANGLE) {
            circles.turnTo(calls.handle(id), words[1]);
        } else if (operation == Commands.ANGULAR_VELOCITY) {
            circles.setAngularVelocity(calls.handle(id), value(Commands.FIRST));
        } else if (operation == Commands.ANGULAR_IMPULSE) {
            circles.applyAngularImpulse(calls.handle(id), value(Commands.FIRST), value(Commands.SECOND));
        } else {
            circles.set(operation, calls.handle(id), value(Commands.FIRST), value(Commands.SECOND));
        }
    }

    /** A value of a command, by its place in a record of {@link Commands}. */
    private float value(int place) {
        return intBitsToFloat(words[1 + place - Commands.FIRST]);
    }
}
