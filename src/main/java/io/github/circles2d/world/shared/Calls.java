package io.github.circles2d.world.shared;

import static java.lang.Float.floatToRawIntBits;

import java.util.EnumSet;

/**
 * Makes the calls of {@link Call}. A log has them as words, and so come those of the API that games make seldom. Those on single circles, of
 * which a frame has thousands, are methods of numbers, which a log's words call too.
 */
public final class Calls {
    /** What some calls do. */
    public interface Effects {
        /**
         * Makes a call whose words are in the ranges of its row. Refuses what cannot be, and makes room; then {@linkplain Calls#begin begins},
         * and changes the world, which does not fail. Returns the handle of what comes by the call, else 0.
         */
        long make(Call call, int[] words);
    }

    private final WorldParts world;
    private final CallLog log;

    /** By call. */
    private final Effects[] effects = new Effects[Call.values().length];

    /** Those of a call of the API. */
    private final int[] words = new int[Call.MOST_WORDS];

    Calls(WorldParts world) {
        this.world = world;
        log = world.log;
    }

    /** Says what calls do. */
    public void define(Effects what, Call... calls) {
        for (Call call : calls) {
            effects[call.ordinal()] = what;
        }
    }

    /** Says what the calls from one row of the table to another do. */
    public void defineAll(Effects what, Call first, Call last) {
        for (Call call : EnumSet.range(first, last)) {
            effects[call.ordinal()] = what;
        }
    }

    /** Makes a call without words. */
    public void make(Call call) {
        make(call, 0, 0, 0, 0);
    }

    /** Makes a call about nothing that has a handle. */
    public long make(Call call, int a, int b, int c, int d) {
        return make(call, 0, a, b, c, d, 0, 0, 0, 0);
    }

    /** The same with floats. */
    public long makeOfFloats(Call call, float a, float b, float c, float d) {
        return make(call, floatToRawIntBits(a), floatToRawIntBits(b), floatToRawIntBits(c), floatToRawIntBits(d));
    }

    /** Makes a call about what has a handle, without further words. */
    public void change(Call call, long handle) {
        change(call, handle, 0, 0, 0);
    }

    /** The same with words that follow. */
    public long change(Call call, long handle, int b, int c, int d) {
        return make(call, handle, 0, b, c, d, 0, 0, 0, 0);
    }

    /** The same with floats. */
    public void changeByFloats(Call call, long handle, float b, float c, float d, float e) {
        int fifth = floatToRawIntBits(e);
        change(call, handle, floatToRawIntBits(b), floatToRawIntBits(c), floatToRawIntBits(d), fifth, 0, 0, 0);
    }

    /** The same with more words. */
    public long change(Call call, long handle, int b, int c, int d, int e, int f, int g, int h) {
        return make(call, handle, 0, b, c, d, e, f, g, h);
    }

    private long make(Call call, long handle, int a, int b, int c, int d, int e, int f, int g, int h) {
        world.guard.enter();
        try (world.guard) {
            words[0] = call.named == Call.Named.NOTHING ? a : id(call.named, handle);
            words[1] = b;
            words[2] = c;
            words[3] = d;
            words[4] = e;
            words[5] = f;
            words[6] = g;
            words[7] = h;
            return execute(call, words);
        }
    }

    /** Makes a call of a log, which may come from anywhere. */
    public void repeat(Call call, int[] ofLog) {
        world.guard.enter();
        try (world.guard) {
            requireId(call.named, ofLog[0]);
            execute(call, ofLog);
        }
    }

    private long execute(Call call, int[] w) {
        call.check(w, world.settings);
        try {
            long handle = effects[call.ordinal()].make(call, w);
            end();
            return handle;
        } catch (RuntimeException | Error e) {
            throw world.guard.failed(e);
        }
    }

    /**
     * A call has been checked, and there is room: writes it to the log, and begins to change the world. A call that is refused, or lacks memory
     * before, has changed nothing and is not in the log.
     */
    public void begin(Call call, int[] w) {
        begin(call, w, true);
    }

    /** The same; changes: whether the world is another one behind the call, which wakes nobody else. */
    public void begin(Call call, int[] w, boolean changes) {
        world.copies.forgetSaved();
        log.write(call, w);
        world.guard.changing = true;
        if (changes && call.wakes() && world.settings.sleeps()) {
            world.commands.wakeAll();
        }
    }

    /** The same of a call of at most four words, which has made what reads know out of date itself. */
    public void begin(Call call, int a, int b, int c, int d) {
        log.write(call, a, b, c, d);
        world.guard.changing = true;
    }

    /** A call has changed the world. */
    public void end() {
        world.guard.changing = false;
    }

    private int id(Call.Named what, long handle) {
        switch (what) {
            case CIRCLE -> {
                return world.circle(handle);
            }
            case PIECE -> {
                return world.piece(handle);
            }
            case BODY -> {
                return world.body(handle);
            }
            case RIGID -> {
                return world.rigid(handle);
            }
            default -> {
                world.pending.settleJoints();
                return world.joint(handle);
            }
        }
    }

    /** Refuses the id of a log that nothing has. */
    public void requireId(Call.Named what, int id) {
        switch (what) {
            case CIRCLE -> require(id >= 0 && id < world.handles.end() && world.handles.lives(id), "circle", id);
            case PIECE -> require(world.terrain.pieces.ids.has(id), "piece of terrain", id);
            case BODY -> require(world.terrain.bodies.ids.has(id), "body of terrain", id);
            case RIGID -> require(world.rigids.ids.has(id), "body", id);
            case JOINT -> {
                world.pending.settleJoints();
                require(world.joints.table.ids.has(id), "joint", id);
            }
            default -> {
                // the first word is no id
            }
        }
    }

    private static void require(boolean isThere, String what, int id) {
        if (!isThere) {
            throw new IllegalArgumentException("no " + what + " has the id " + id);
        }
    }
}
