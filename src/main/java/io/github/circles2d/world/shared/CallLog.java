package io.github.circles2d.world.shared;

import io.github.circles2d.world.bodies.OutlineShape;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.joints.JointForm;
import io.github.circles2d.world.log.LogWriter;
import io.github.circles2d.world.snapshots.SavedState;
import io.github.circles2d.world.snapshots.SnapshotCodec;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.HashMap;
import java.util.Map;

/** Tells a log of the calls that change the world, while there is one. Without a log, a call costs a comparison. */
public final class CallLog {
    private final WorldParts world;

    /** Null while nothing is recorded. */
    private LogWriter log;

    private int hashEvery;
    private long sinceHash;

    /** Whether a step is in the log and is being made. If it stays true, the step was not made. */
    private boolean stepping;

    /** Room for a snapshot on its way. */
    private ByteBuffer snapshot = ByteBuffer.allocate(0).order(ByteOrder.LITTLE_ENDIAN);

    /** The outlines that the log has told of, and their numbers. */
    private final Map<OutlineShape, Integer> outlines = new HashMap<>();

    CallLog(WorldParts world) {
        this.world = world;
    }

    /** Whether there is a log. */
    public boolean isOn() {
        return log != null;
    }

    /** The log; null while there is none. */
    public LogWriter writer() {
        return log;
    }

    /** Begins a log that has its head and its first snapshot. */
    public void begin(LogWriter writer, int every) {
        hashEvery = every;
        sinceHash = 0;
        stepping = false;
        outlines.clear();
        log = writer;
        writeHash();
    }

    public void end() {
        log = null;
        outlines.clear();
    }

    /** A call is to change the world. */
    public void write(Call call, int[] words) {
        if (log != null) {
            begin(call);
            for (int k = 0; k < call.words; k++) {
                log.word(words[k]);
            }
            log.end();
        }
    }

    /** A call of at most four words is to be made, or to change the world. */
    public void write(Call call, int a, int b, int c, int d) {
        if (log != null) {
            begin(call);
            for (int k = 0; k < call.words; k++) {
                log.word(k == 0 ? a : k == 1 ? b : k == 2 ? c : d);
            }
            log.end();
        }
    }

    /** A call is to make a record of {@link Commands}. */
    public void writeRecord(Call call, int record) {
        if (log != null) {
            begin(call);
            int at = Commands.STRIDE * record + Commands.ID;
            for (int k = 0; k < call.words; k++) {
                log.word(world.commands.records()[at + k]);
            }
            log.end();
        }
    }

    /** The first circle that is prepared in {@link Commands} is to come, with a kind. */
    public void writeAdd(int kind) {
        if (log != null) {
            begin(Call.ADD);
            int at = Commands.STRIDE * world.commands.count();
            for (int k = Commands.ADD_X; k <= Commands.ADD_VY; k++) {
                if (k != Commands.ADD_RESTITUTION) { // that of the kind, else the world's
                    log.word(world.commands.records()[at + k]);
                }
            }
            log.word(kind);
            log.end();
        }
    }

    private void begin(Call call) {
        if (stepping) {
            log.fail(new IllegalStateException("a step in it could not be made"));
        }
        log.begin(call.number, call.words);
    }

    /** Joints of a form are to come, until there is another one. */
    public void joints(JointForm form) {
        if (log != null) {
            begin(Call.JOINT_FORM);
            for (int k = 0; k < JointForm.WORDS; k++) {
                log.word(form.word(k));
            }
            log.end();
        }
    }

    /** A body of an outline is to come: tells of the outline once, and returns its number in the log; 0 without a log. */
    public int outline(OutlineShape shape) {
        if (log == null) {
            return 0;
        }
        Integer known = outlines.get(shape);
        if (known != null) {
            return known;
        }
        int number = outlines.size();
        outlines.put(shape, number);
        int[] words = shape.words();
        int at = Call.OUTLINE.words - 1;
        begin(Call.OUTLINE);
        log.word(words.length);
        writeWords(words, 0, at);
        for (; at < words.length; at += Call.OUTLINE_WORDS.words) {
            begin(Call.OUTLINE_WORDS);
            writeWords(words, at, Call.OUTLINE_WORDS.words);
        }
        return number;
    }

    /** So many words from a place on, with zeros behind the last one; ends the call. */
    private void writeWords(int[] words, int from, int count) {
        for (int k = from; k < from + count; k++) {
            log.word(k < words.length ? words[k] : 0);
        }
        log.end();
    }

    /** A saved state is to take the place of all that is, and of what a step that was not made would have led to. */
    public void restore(SavedState state) {
        if (log != null) {
            stepping = false;
            write(state, log);
        }
    }

    public void write(SavedState state, LogWriter to) {
        snapshot = SnapshotCodec.encode(state, snapshot);
        SnapshotCodec.addCheck(snapshot);
        to.snapshot(snapshot.array(), snapshot.limit());
    }

    /** Steps are to be made. If they cannot be made, the log ends. */
    public void step(float timeStep, int count) {
        if (log != null) {
            write(Call.STEP, Float.floatToRawIntBits(timeStep), count, 0, 0);
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
            long now = world.copies.hash();
            write(Call.HASH, (int) now, (int) (now >> Integer.SIZE), 0, 0);
        } catch (RuntimeException | Error e) {
            if (!world.guard.holds()) {
                throw e;
            }
            log.fail(e);
        }
    }
}
