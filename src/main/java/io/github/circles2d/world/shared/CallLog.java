package io.github.circles2d.world.shared;

import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.SavedState;
import io.github.circles2d.world.circles.SnapshotCodec;
import io.github.circles2d.world.joints.JointForm;
import io.github.circles2d.world.log.LogWriter;
import io.github.circles2d.world.terrain.ChainPath;
import java.nio.Buffer;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.function.LongSupplier;

/**
 * Tells a log what changes the world, while there is one. The waiting {@link Commands} are written as they are, whatever call has made
 * them; all other calls write a row of {@link LoggedCall} before they change the state. Without a log, a call costs a comparison.
 */
public final class CallLog {
    private final Pipeline pipeline;
    private final Guard guard;
    private final Commands commands;

    /** Null while nothing is recorded. */
    private LogWriter log;

    /** Gives the hash of the state as of now. */
    private LongSupplier hash;

    private int hashEvery;
    private long sinceHash;

    /** Whether a step is in the log and is being made. If it stays true, the step was not made. */
    private boolean stepping;

    /** How many of the waiting commands are in the log. */
    int logged;

    /** Room for a snapshot on its way. */
    private ByteBuffer snapshot = ByteBuffer.allocate(0);

    public CallLog(Pipeline pipeline, Guard guard, Commands commands) {
        this.pipeline = pipeline;
        this.guard = guard;
        this.commands = commands;
    }

    /** The log; null while there is none. */
    public LogWriter writer() {
        return log;
    }

    /** Begins a log that has its head and its first snapshot. */
    public void begin(LogWriter writer, int every, LongSupplier hashOfNow) {
        hash = hashOfNow;
        hashEvery = every;
        sinceHash = 0;
        logged = 0;
        stepping = false;
        log = writer;
        writeHash();
    }

    public void end() {
        log = null;
    }

    /** Commands have been taken back: the log may have no more of them than there are. */
    public void commandsDropped() {
        logged = Math.min(logged, commands.count());
    }

    public void writeCommands() {
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
    public void field(CircleField field, int id, long value) {
        if (log != null) {
            writeCommands();
            writeField(field, id, value);
        }
    }

    /** A static circle is to travel. */
    public void travel(int id, float x, float y) {
        call(LoggedCall.TRAVEL, id, Float.floatToRawIntBits(x), Float.floatToRawIntBits(y), 0);
    }

    /** A force is to act in the next step. */
    public void force(int id, float x, float y) {
        call(LoggedCall.FORCE, id, Float.floatToRawIntBits(x), Float.floatToRawIntBits(y), 0);
    }

    /** A torque is to act in the next step. */
    public void torque(int id, float torque) {
        call(LoggedCall.TORQUE, id, Float.floatToRawIntBits(torque));
    }

    /** The commands that wait are not to be in the log: a replay makes them, too. */
    public void skipCommands() {
        logged = commands.count();
    }

    /** A call of two words is to change the world. */
    public void call(LoggedCall call, int a, int b) {
        call(call, a, b, 0, 0);
    }

    /** A call of up to four words is to change the world. */
    public void call(LoggedCall call, int a, int b, int c, int d) {
        if (log != null) {
            begin(call);
            for (int k = 0; k < call.words; k++) {
                log.word(k == 0 ? a : k == 1 ? b : k == 2 ? c : d);
            }
            log.end();
        }
    }

    private void begin(LoggedCall call) {
        writeCommands();
        if (stepping) {
            log.fail(new IllegalStateException("a step in it could not be made"));
        }
        log.begin(call.number, call.words);
    }

    /** A segment is to be added to a body of terrain. */
    public void segment(int body, int kind, float x1, float y1, float x2, float y2, float thickness) {
        if (log != null) {
            begin(LoggedCall.SEGMENT);
            log.word(body);
            log.word(kind);
            word(x1);
            word(y1);
            word(x2);
            word(y2);
            word(thickness);
            log.end();
        }
    }

    /** An arc is to be added to a body of terrain. */
    public void arc(int body, int kind, float x, float y, float radius, float from, float to, boolean inside) {
        if (log != null) {
            begin(LoggedCall.ARC);
            log.word(body);
            log.word(kind);
            word(x);
            word(y);
            word(radius);
            word(from);
            word(to);
            log.word(inside ? 1 : 0);
            log.end();
        }
    }

    /** The first pieces of a chain, so many, are to be added to a body of terrain. */
    public void chain(int body, int kind, ChainPath chain, int count, boolean closed) {
        if (log != null) {
            call(LoggedCall.CHAIN_START, chain.x(0), chain.y(0), 0, 0);
            for (int k = 0; k < count; k++) {
                long turn = chain.turn(k);
                if (turn == 0) {
                    call(LoggedCall.CHAIN_LINE, chain.x(k + 1), chain.y(k + 1), 0, 0);
                } else {
                    call(
                            LoggedCall.CHAIN_ARC,
                            Float.floatToRawIntBits(chain.centreX(k)),
                            Float.floatToRawIntBits(chain.centreY(k)),
                            (int) turn,
                            (int) (turn >> Integer.SIZE));
                }
            }
            call(LoggedCall.CHAIN, body, kind, closed ? 1 : 0, 0);
        }
    }

    /** Joints of a form are to come, until there is another one. */
    public void joints(JointForm form) {
        if (log != null) {
            begin(LoggedCall.JOINT_FORM);
            for (int k = 0; k < JointForm.WORDS; k++) {
                log.word(form.word(k));
            }
            log.end();
        }
    }

    private void word(float value) {
        log.word(Float.floatToRawIntBits(value));
    }

    /** A call of floats is to change the world. */
    public void call(LoggedCall call, float a, float b, float c, float d) {
        call(
                call,
                Float.floatToRawIntBits(a),
                Float.floatToRawIntBits(b),
                Float.floatToRawIntBits(c),
                Float.floatToRawIntBits(d));
    }

    /**
     * A saved state is to take the place of all that is, and of the commands that wait. These are written, too: if a read had come before,
     * they would not wait any more, and no byte of a log depends on reads.
     */
    public void restore(SavedState state) {
        if (log != null) {
            writeCommands();
            write(state, log);
        }
    }

    public void write(SavedState state, LogWriter to) {
        int length = SnapshotCodec.bytes(state);
        if (snapshot.capacity() < length) {
            snapshot = ByteBuffer.allocate(length).order(ByteOrder.LITTLE_ENDIAN);
        }
        ((Buffer) snapshot).clear();
        SnapshotCodec.writeAtStart(state, snapshot);
        to.snapshot(snapshot.array(), length);
    }

    /** Steps are to be made. If they cannot be made, the log ends. */
    public void step(float timeStep, int count) {
        if (log != null) {
            call(LoggedCall.STEP, Float.floatToRawIntBits(timeStep), count);
            stepping = true;
        }
    }

    /** Steps have been made. */
    public void stepped(int count) {
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
    public void writeHash() {
        sinceHash = 0;
        try {
            long now = hash.getAsLong();
            call(LoggedCall.HASH, (int) now, (int) (now >> Integer.SIZE));
        } catch (RuntimeException | Error e) {
            if (guard.changing || pipeline.isLostBy(e)) {
                throw e;
            }
            log.fail(e);
        }
    }
}
