package io.github.circles2d.world.changes;

import static java.lang.Float.floatToRawIntBits;

import io.github.circles2d.world.bodies.OutlineShape;
import io.github.circles2d.world.bodies.RigidLimits;
import io.github.circles2d.world.bodies.RigidTable;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.shared.Call;
import io.github.circles2d.world.shared.WorldParts;
import java.util.Arrays;

/**
 * The calls that add or change many rigid bodies at once, all of them or none. What they come to is checked and copied as words of the calls for one
 * body; then these are made.
 */
public final class RigidBulk {
    /** Values of a new body: x, y, angle, mass. */
    private static final int NEW = 4;

    private static final Call[] REMOVE = {Call.REMOVE_RIGID};
    private static final Call[] TELEPORT = {Call.TELEPORT_RIGID};
    private static final Call[] VELOCITY = {Call.RIGID_VELOCITY, Call.RIGID_ANGULAR_VELOCITY};
    private static final Call[] IMPULSE = {Call.RIGID_IMPULSE};
    private static final Call[] FORCE = {Call.RIGID_LASTING_FORCE, Call.RIGID_LASTING_TORQUE};
    private static final Call[] KIND = {Call.RIGID_KIND};

    private final WorldParts world;
    private final RigidTable table;
    private final RigidCalls single;
    private final int[] words = new int[Call.MOST_WORDS];

    /** The words of the calls to make. */
    private int[] prepared = new int[0];

    private int preparedWords;

    /** The bodies that are to be removed. */
    private final IdSet leaving = new IdSet();

    public RigidBulk(WorldParts world, RigidCalls single) {
        this.world = world;
        this.single = single;
        table = world.rigids;
    }

    // ---- many come

    /**
     * Adds bodies at rest, four elements each: x, y, angle in radians, mass. All have the first outline if there is but one. Without kinds they are
     * of kind 0; the handles are optional, too.
     */
    public void addAll(OutlineShape[] outlines, boolean areEach, float[] bodies, int[] kinds, long[] to) {
        world.guard.enter();
        try (world.guard) {
            int n = Limits.notNull("bodies", bodies).length / NEW;
            checkLengths(n, areEach ? outlines.length : n, bodies, kinds, to);
            RigidLimits.room(table.ids.size(), n);
            preparedWords = 0;
            for (int i = 0; i < n; i++) {
                prepare(i, outlines[areEach ? i : 0], bodies, kinds == null ? 0 : kinds[i]);
            }
            makeAll(n, outlines, areEach, to);
        }
    }

    /** Reads each element once: another thread may write to the arrays. */
    private void prepare(int i, OutlineShape outline, float[] bodies, int kind) {
        words[0] = 0;
        words[1] = kind;
        for (int k = 0; k < NEW; k++) {
            words[2 + k] = floatToRawIntBits(bodies[NEW * i + k]);
        }
        try {
            Call.RIGID.check(words, world.settings);
            RigidLimits.reach(outline, world.settings.bounds());
        } catch (IllegalArgumentException e) {
            throw ofBody(i, e);
        }
        prepare(Call.RIGID);
    }

    private void makeAll(int n, OutlineShape[] outlines, boolean areEach, long[] to) {
        try {
            if (n > 0 && !table.isThere()) {
                world.needs.prepareRigids();
            }
            table.ensure(n);
            single.makeRoomToWake(n);
            for (int i = 0; i < n; i++) {
                table.prepare(outlines[areEach ? i : 0]);
            }
            int at = 0;
            for (int i = 0; i < n; i++) {
                at = take(Call.RIGID, at);
                long handle = single.addPrepared(outlines[areEach ? i : 0], words);
                if (to != null) {
                    to[i] = handle;
                }
            }
            world.calls.end();
        } catch (RuntimeException | Error e) {
            throw world.guard.failed(e);
        }
    }

    private static void checkLengths(int n, int outlines, float[] bodies, int[] kinds, long[] to) {
        if (bodies.length % NEW != 0) {
            throw new IllegalArgumentException("bodies has " + bodies.length + " elements, but must have four a body");
        }
        if (outlines != n) {
            throw new IllegalArgumentException(
                    "outlines has " + outlines + " elements, but must have one for each of " + n);
        }
        BulkChanges.checkKinds(kinds, n);
        BulkChanges.checkHandles(to, n, "bodies");
    }

    // ---- many change

    /** Removes bodies. Returns the number of handles that were left out, as all calls here do. */
    public int remove(long[] bodies, int count, boolean skipStale) {
        return change(REMOVE, null, 0, bodies, count, null, null, skipStale);
    }

    /** Puts bodies somewhere else at once: x, y and the angle in radians of each. */
    public int teleport(long[] bodies, int count, float[] values, boolean skipStale) {
        return change(TELEPORT, "poses", 3, bodies, count, values, null, skipStale);
    }

    /** Both velocities: vx, vy and radians a second of each. */
    public int setVelocities(long[] bodies, int count, float[] values, boolean skipStale) {
        return change(VELOCITY, "velocities", 3, bodies, count, values, null, skipStale);
    }

    /** Impulses at the centroids. */
    public int applyImpulses(long[] bodies, int count, float[] values, boolean skipStale) {
        return change(IMPULSE, "impulses", 2, bodies, count, values, null, skipStale);
    }

    /** Forces and torques that last: x, y and the torque of each. */
    public int setForces(long[] bodies, int count, float[] values, boolean skipStale) {
        return change(FORCE, "forces", 3, bodies, count, values, null, skipStale);
    }

    public int setKinds(long[] bodies, int count, int[] kinds, boolean skipStale) {
        return change(KIND, "kinds", 1, bodies, count, null, kinds, skipStale);
    }

    /**
     * Makes some calls about each body, in the order of the handles. There are so many values for each, of the name: floats, or kinds if they are not
     * null. Refuses stale handles, or leaves them out, and returns how many.
     */
    private int change(
            Call[] calls,
            String name,
            int each,
            long[] bodies,
            int count,
            float[] values,
            int[] kinds,
            boolean skipStale) {
        world.guard.enter();
        try (world.guard) {
            BulkChanges.checkCount(bodies, count);
            if (each > 0) {
                int length = kinds != null ? kinds.length : Limits.notNull(name, values).length;
                BulkChanges.checkLength(name, each, length, count);
            }
            preparedWords = 0;
            leaving.begin(table.ids.end());
            int left = 0;
            for (int i = 0; i < count; i++) {
                int id = find(bodies, i, calls == REMOVE, skipStale);
                if (id < 0) {
                    left++;
                } else {
                    prepare(calls, id, each, values, kinds, i);
                }
            }
            make(calls);
            return left;
        }
    }

    /** The id of handle i; -1 if it is stale, or will be by an earlier one, and left out. Each element is read once, as above. */
    private int find(long[] bodies, int i, boolean leaves, boolean skipStale) {
        long handle = bodies[i];
        int id = table.ids.find(handle);
        if (id < 0 && !skipStale) {
            throw new IllegalArgumentException("handle " + i + ": " + WorldParts.goneRigid(handle));
        }
        if (id >= 0 && leaves && !leaving.add(id)) {
            if (!skipStale) {
                throw new IllegalArgumentException(
                        "handle " + i + ": the body with the handle " + handle + " occurs twice");
            }
            return -1;
        }
        return id;
    }

    private void prepare(Call[] calls, int id, int each, float[] values, int[] kinds, int i) {
        int value = each * i;
        for (Call call : calls) {
            words[0] = id;
            if (call == Call.RIGID_IMPULSE) {
                words[3] = floatToRawIntBits(table.step.x[id]);
                words[4] = floatToRawIntBits(table.step.y[id]);
            }
            int given = call == Call.RIGID_IMPULSE ? each : call.words - 1;
            for (int k = 1; k <= given; k++) {
                words[k] = kinds == null ? floatToRawIntBits(values[value]) : kinds[value];
                value++;
            }
            try {
                call.check(words, world.settings);
            } catch (IllegalArgumentException e) {
                throw ofBody(i, e);
            }
            prepare(call);
        }
    }

    private static IllegalArgumentException ofBody(int i, IllegalArgumentException e) {
        return new IllegalArgumentException("body " + i + ": " + e.getMessage(), e);
    }

    /** Puts the words of a call behind those that are prepared. */
    private void prepare(Call call) {
        if (prepared.length < preparedWords + call.words) {
            prepared = Arrays.copyOf(prepared, Math.max(64, 2 * (preparedWords + call.words)));
        }
        System.arraycopy(words, 0, prepared, preparedWords, call.words);
        preparedWords += call.words;
    }

    /** Gives the words of a prepared call back, and returns where those of the next one are. */
    private int take(Call call, int at) {
        System.arraycopy(prepared, at, words, 0, call.words);
        return at + call.words;
    }

    /** Makes the calls that are prepared, over and over. */
    private void make(Call[] calls) {
        try {
            if (preparedWords > 0) {
                single.makeRoom(calls[0], preparedWords / calls[0].words);
            }
            int at = 0;
            while (at < preparedWords) {
                for (Call call : calls) {
                    at = take(call, at);
                    world.calls.begin(call, words);
                    single.change(call, words);
                }
            }
            world.calls.end();
        } catch (RuntimeException | Error e) {
            throw world.guard.failed(e);
        }
    }
}
