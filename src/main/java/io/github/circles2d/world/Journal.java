package io.github.circles2d.world;

import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.SavedState;
import io.github.circles2d.world.circles.SnapshotCodec;
import io.github.circles2d.world.log.LogWriter;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.Buffer;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/**
 * Tells a log what changes the world, while there is one. The waiting {@link Commands} are written as they are, whatever call has made
 * them; all other calls write a row of {@link LoggedCall} before they change the state. Without a log, a call costs a comparison.
 */
public final class Journal {
    /** How far a log has come, also when it has ended. */
    public static final class Progress {
        private final LogWriter log;

        Progress(LogWriter log) {
            this.log = log;
        }

        /** Steps in the log. */
        public long steps() {
            return log.steps();
        }

        /** Bytes of the log. */
        public long bytes() {
            return log.bytes();
        }

        /** Whether the log could not be written on. */
        public boolean hasFailed() {
            return log.failure() != null;
        }
    }

    private final Simulation simulation;
    private final Guard guard;
    private final Commands commands;

    /** Null while nothing is recorded. */
    private LogWriter log;

    private int hashEvery;
    private long sinceHash;

    /** Whether a step is in the log and is being made. If it stays true, the step was not made. */
    private boolean stepping;

    /** How many of the waiting commands are in the log. Whoever clears them sets it to 0. */
    int logged;

    /** Room for a snapshot on its way. */
    private ByteBuffer snapshot = ByteBuffer.allocate(0);

    Journal(Simulation simulation) {
        this.simulation = simulation;
        guard = simulation.guard;
        commands = simulation.commands;
    }

    /**
     * Begins a log with a snapshot of now.
     *
     * @param out where to; is not closed
     * @param every steps between two hashes
     * @return tells how far the log has come; {@link #stop} ends it
     */
    public Progress start(OutputStream out, int every) throws IOException {
        guard.enter();
        try {
            if (log != null) {
                throw new IllegalStateException("this World is being recorded already");
            }
            SavedState now = simulation.snapshots().now();
            LogWriter writer = new LogWriter(out, every);
            write(now, writer);
            writer.requireWritten("the log cannot begin");
            hashEvery = every;
            sinceHash = 0;
            logged = 0;
            stepping = false;
            log = writer;
            writeHash();
            return new Progress(writer);
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** Ends the log, with a last hash if the state is there. Also if the simulation has been closed. */
    public void stop() throws IOException {
        guard.takeTurn();
        try {
            LogWriter last = log;
            if (last != null) {
                try {
                    if (guard.holds()) {
                        simulation.applyCommands();
                        writeHash();
                    }
                } finally {
                    log = null;
                    last.close();
                }
            }
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** Closes the stream that a log has been written to. */
    public static void closeStream(OutputStream out) throws IOException {
        try {
            out.close();
        } catch (IOException | RuntimeException e) {
            throw LogWriter.failed("the stream of the log cannot be closed", e);
        }
    }

    /** Writes the commands that wait and are not in the log. */
    void writeCommands() {
        if (log != null) {
            while (logged < commands.count()) {
                write(logged);
                logged++;
            }
        }
    }

    private void write(int record) {
        int at = Commands.STRIDE * record;
        int operation = commands.operation(record);
        int id = commands.id(record);
        if (operation == Commands.FIELD) {
            CircleField field = CircleField.OF_STEPS.get(commands.records()[at + Commands.FIRST]);
            writeField(field, id, commands.records()[at + Commands.SECOND]);
            return;
        }
        int values = Commands.values(operation);
        log.begin(operation, 1 + values);
        log.word(id);
        for (int k = 0; k < values; k++) {
            log.word(commands.records()[at + Commands.FIRST + k]);
        }
        log.end();
    }

    private void writeField(CircleField field, int id, long value) {
        log.begin(LoggedCall.FIELD.number, LoggedCall.FIELD.words);
        log.word(field.number());
        log.word(id);
        log.word((int) value);
        log.word((int) (value >> Integer.SIZE));
        log.end();
    }

    /** A field that steps do not read, and which is no command, is to change. */
    void field(CircleField field, int id, long value) {
        if (log != null) {
            writeCommands();
            writeField(field, id, value);
        }
    }

    /** A static circle is to travel. */
    void travel(int id, float x, float y) {
        call(LoggedCall.TRAVEL, id, Float.floatToRawIntBits(x), Float.floatToRawIntBits(y), 0);
    }

    /** A force is to act in the next step. */
    void force(int id, float x, float y) {
        call(LoggedCall.FORCE, id, Float.floatToRawIntBits(x), Float.floatToRawIntBits(y), 0);
    }

    /** The commands that wait are not to be in the log: a replay makes them, too. */
    void skipCommands() {
        logged = commands.count();
    }

    /** A call of two words is to change the world. */
    void call(LoggedCall call, int a, int b) {
        call(call, a, b, 0, 0);
    }

    /** A call of up to four words is to change the world. */
    void call(LoggedCall call, int a, int b, int c, int d) {
        if (log != null) {
            writeCommands();
            if (stepping) {
                log.fail(new IllegalStateException("a step in it could not be made"));
            }
            log.begin(call.number, call.words);
            for (int k = 0; k < call.words; k++) {
                log.word(k == 0 ? a : k == 1 ? b : k == 2 ? c : d);
            }
            log.end();
        }
    }

    /** A call of floats is to change the world. */
    void call(LoggedCall call, float a, float b, float c, float d) {
        call(
                call,
                Float.floatToRawIntBits(a),
                Float.floatToRawIntBits(b),
                Float.floatToRawIntBits(c),
                Float.floatToRawIntBits(d));
    }

    /** A saved state is to take the place of all that is, and of the commands that wait. */
    void restore(SavedState state) {
        if (log != null) {
            write(state, log);
        }
    }

    private void write(SavedState state, LogWriter to) {
        int length = SnapshotCodec.bytes(state);
        if (snapshot.capacity() < length) {
            snapshot = ByteBuffer.allocate(length).order(ByteOrder.LITTLE_ENDIAN);
        }
        ((Buffer) snapshot).clear();
        SnapshotCodec.writeAtStart(state, snapshot);
        to.snapshot(snapshot.array(), length);
    }

    /** Steps are to be made. If they cannot be made, the log ends. */
    void step(float timeStep, int count) {
        if (log != null) {
            call(LoggedCall.STEP, Float.floatToRawIntBits(timeStep), count);
            stepping = true;
        }
    }

    /** Steps have been made. */
    void stepped(int count) {
        if (log != null) {
            stepping = false;
            log.countSteps(count);
            sinceHash += count;
            if (sinceHash >= hashEvery) {
                writeHash();
            }
        }
    }

    /** Writes the hash of now. A read that lacks memory ends the log, and not the step that it follows. */
    private void writeHash() {
        sinceHash = 0;
        try {
            long hash = simulation.currentHash();
            call(LoggedCall.HASH, (int) hash, (int) (hash >> Integer.SIZE));
        } catch (RuntimeException | Error e) {
            if (guard.changing || simulation.pipeline.isLostBy(e)) {
                throw e;
            }
            log.fail(e);
        }
    }
}
