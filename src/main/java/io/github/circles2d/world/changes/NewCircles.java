package io.github.circles2d.world.changes;

import static io.github.circles2d.world.shared.Call.real;
import static java.lang.Float.floatToRawIntBits;

import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.shared.Call;
import io.github.circles2d.world.shared.Calls;
import io.github.circles2d.world.shared.WorldParts;

/** The calls that add circles, one or many. */
public final class NewCircles implements Calls.Effects {
    private final WorldParts world;
    private final Kinds kinds;

    /** The kinds of the circles that a call adds. */
    private int[] newKinds = new int[0];

    /** Those of a circle of many. */
    private final int[] words = new int[Call.MOST_WORDS];

    public NewCircles(WorldParts world, Kinds kinds) {
        this.world = world;
        this.kinds = kinds;
        world.calls.define(this, Call.ADD);
    }

    /** Adds a circle of kind 0 and returns its handle. */
    public long add(float x, float y, float radius, float mass, float vx, float vy) {
        return add(x, y, radius, mass, vx, vy, 0);
    }

    /** Adds a circle, with the restitution of its kind, else the world's, and returns its handle. */
    public long add(float x, float y, float radius, float mass, float vx, float vy, int kind) {
        return world.calls.make(
                Call.ADD,
                floatToRawIntBits(x),
                floatToRawIntBits(y),
                floatToRawIntBits(radius),
                floatToRawIntBits(mass),
                floatToRawIntBits(vx),
                floatToRawIntBits(vy),
                kind);
    }

    @Override
    public void prepare(Call call, int[] w) {
        checkRoom(1);
        world.pending.expect(2);
        world.handles.ensure(1);
        if (w[6] != 0) {
            world.handles.fields().ensure(CircleField.KIND, world.handles.end() + 1);
        }
        prepare(0, w);
        world.copies.forget();
    }

    /** Prepares a circle behind those ahead. */
    private void prepare(int ahead, int[] w) {
        Bounds bounds = world.settings.bounds();
        world.commands.prepare(
                ahead,
                bounds.placeX(real(w[0])),
                bounds.placeY(real(w[1])),
                real(w[2]),
                real(w[3]),
                kinds.newRestitution(w[6]),
                real(w[4]),
                real(w[5]));
    }

    @Override
    public long apply(Call call, int[] w) {
        long handle = admit();
        if (w[6] != 0) {
            setKind((int) handle, w[6]);
        }
        return handle;
    }

    /**
     * Adds circles, four elements each. Without velocities they are at rest, without kinds of kind 0; the handles are optional,
     * too.
     */
    public void addAll(float[] circles, float[] velocities, int[] kinds, long[] to) {
        world.guard.enter();
        try {
            Limits.notNull("circles", circles);
            int n = circles.length / CircleRow.STRIDE;
            checkLengths(n, circles, velocities, kinds, to);
            int[] own = prepareAll(n, circles, velocities, kinds);
            world.copies.forget();
            world.guard.changing = true;
            admitAll(n, own, to);
            world.guard.changing = false;
        } catch (RuntimeException | Error e) {
            throw world.guard.failed(e);
        } finally {
            world.guard.user = null;
        }
    }

    /** Checks circles and prepares them, so that {@link #admitAll} cannot fail. Returns their kinds; null if kinds is. */
    int[] prepareAll(int n, float[] circles, float[] velocities, int[] kinds) {
        checkRoom(n);
        world.pending.expect(kinds == null ? n : 2 * n);
        world.handles.ensure(n);
        int[] own = kinds == null ? null : copy(kinds);
        for (int i = 0; i < n; i++) {
            prepare(i, circles, velocities, own == null ? 0 : own[i]);
        }
        return own;
    }

    /** Adds the circles that are prepared; the handles are optional. */
    void admitAll(int n, int[] own, long[] to) {
        int first = world.commands.count();
        for (int i = 0; i < n; i++) {
            if (world.log.writer() != null) {
                writeToLog(own == null ? 0 : own[i]);
            }
            long handle = admit();
            if (to != null) {
                to[i] = handle;
            }
        }
        for (int i = 0; own != null && i < n; i++) {
            if (own[i] != 0) {
                setKind(world.commands.id(first + i), own[i]);
            }
        }
    }

    private static void checkLengths(int n, float[] circles, float[] velocities, int[] kinds, long[] to) {
        if (circles.length % CircleRow.STRIDE != 0) {
            throw new IllegalArgumentException(
                    "circles has " + circles.length + " elements, but must have four a circle");
        }
        if (velocities != null && velocities.length != 2 * n) {
            throw new IllegalArgumentException(
                    "velocities has " + velocities.length + " elements, but must have two for each of " + n);
        }
        if (kinds != null && kinds.length != n) {
            throw new IllegalArgumentException(
                    "kinds has " + kinds.length + " elements, but must have one for each of " + n);
        }
        if (to != null && to.length < n) {
            throw new IllegalArgumentException(
                    "handles has " + to.length + " elements, but there are " + n + " circles");
        }
    }

    /**
     * Copies the kinds of circles that are to be added, and makes room for them. Another thread may write to the caller's array.
     */
    private int[] copy(int[] kinds) {
        if (newKinds.length < kinds.length) {
            newKinds = new int[kinds.length];
        }
        System.arraycopy(kinds, 0, newKinds, 0, kinds.length);
        world.handles.fields().ensure(CircleField.KIND, world.handles.end() + kinds.length);
        return newKinds;
    }

    /** Checks circle i of many and prepares it. Each element is read once: another thread may write to the arrays. */
    private void prepare(int i, float[] circles, float[] velocities, int kind) {
        for (int k = 0; k < CircleRow.STRIDE; k++) {
            words[k] = floatToRawIntBits(circles[CircleRow.STRIDE * i + k]);
        }
        words[4] = velocities == null ? 0 : floatToRawIntBits(velocities[2 * i]);
        words[5] = velocities == null ? 0 : floatToRawIntBits(velocities[2 * i + 1]);
        words[6] = kind;
        try {
            Call.ADD.check(words, world.settings);
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException("circle " + i + ": " + e.getMessage(), e);
        }
        prepare(i, words);
    }

    /** The first circle that is prepared is to come. */
    private void writeToLog(int kind) {
        int at = Commands.STRIDE * world.commands.count();
        for (int k = 0; k < CircleRow.STRIDE; k++) {
            words[k] = world.commands.records()[at + Commands.ADD_X + k];
        }
        words[4] = world.commands.records()[at + Commands.ADD_VX];
        words[5] = world.commands.records()[at + Commands.ADD_VY];
        words[6] = kind;
        world.log.write(Call.ADD, words);
    }

    private void checkRoom(int more) {
        if (more > Limits.CIRCLES - world.handles.size()) {
            throw new IllegalArgumentException(
                    "a world has at most " + Limits.CIRCLES + " circles, not " + ((long) world.handles.size() + more));
        }
    }

    /** Gives the first circle that is prepared its id, and returns its handle. */
    private long admit() {
        int id = world.handles.add(world.commands.preparedRadius());
        world.handles.setRestitution(id, world.commands.preparedRestitution());
        world.handles.setMass(id, world.commands.preparedMass());
        world.commands.admit(id);
        return world.handles.handle(id);
    }

    /** Takes down the kind of a circle, for which there is room. */
    private void setKind(int id, int kind) {
        world.handles.fields().set(CircleField.KIND, id, kind);
        world.commands.setField(CircleField.KIND, id, kind);
    }
}
