package io.github.circles2d.world.changes;

import static io.github.circles2d.world.shared.Call.real;

import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.circles.KindTable;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.shared.Call;
import io.github.circles2d.world.shared.Calls;
import io.github.circles2d.world.shared.WorldParts;

/** The calls that add circles, one or many. */
public final class NewCircles implements Calls.Effects {
    private final WorldParts world;
    private final HandleTable handles;
    private final Commands commands;
    private final Kinds kinds;

    /** The kinds of the circles that a call adds. */
    private int[] newKinds = new int[0];

    public NewCircles(WorldParts world, Kinds kinds) {
        this.world = world;
        this.kinds = kinds;
        handles = world.handles;
        commands = world.commands;
        world.calls.define(this, Call.ADD);
    }

    @Override
    public long make(Call call, int[] w) {
        return addOne(real(w[0]), real(w[1]), real(w[2]), real(w[3]), real(w[4]), real(w[5]), w[6]);
    }

    /** Adds a circle, with the restitution of its kind, else the world's, and returns its handle. */
    public long add(float x, float y, float radius, float mass, float vx, float vy, int kind) {
        world.guard.enter();
        try (world.guard) {
            return addOne(x, y, radius, mass, vx, vy, kind);
        }
    }

    private long addOne(float x, float y, float radius, float mass, float vx, float vy, int kind) {
        makeRoom(1, kind != 0);
        prepare(0, x, y, radius, mass, vx, vy, kind);
        world.copies.forget();
        world.guard.changing = true;
        long handle = admit(kind);
        if (kind != 0) {
            setKind((int) handle, kind);
        }
        world.guard.changing = false;
        return handle;
    }

    /**
     * Adds circles, four elements each. Without velocities they are at rest, without kinds of kind 0; the handles are optional,
     * too.
     */
    public void addAll(float[] circles, float[] velocities, int[] kinds, long[] to) {
        world.guard.enter();
        try (world.guard) {
            Limits.notNull("circles", circles);
            int n = circles.length / CircleRow.STRIDE;
            checkLengths(n, circles, velocities, kinds, to);
            int[] own = prepareAll(n, circles, velocities, kinds);
            world.copies.forget();
            world.guard.changing = true;
            admitAll(n, own, to);
            world.guard.changing = false;
        }
    }

    /** Checks circles and prepares them, so that {@link #admitAll} cannot fail. Returns their kinds; null if kinds is. */
    int[] prepareAll(int n, float[] circles, float[] velocities, int[] kinds) {
        makeRoom(n, kinds != null);
        int[] own = kinds == null ? null : copy(kinds);
        for (int i = 0; i < n; i++) {
            prepare(i, circles, velocities, own == null ? 0 : own[i]);
        }
        return own;
    }

    private void makeRoom(int more, boolean withKinds) {
        if (more > Limits.CIRCLES - handles.size()) {
            throw new IllegalArgumentException(
                    "a world has at most " + Limits.CIRCLES + " circles, not " + ((long) handles.size() + more));
        }
        world.pending.expect(withKinds ? 2 * more : more);
        handles.ensure(more);
        if (withKinds) {
            handles.fields().ensure(CircleField.KIND, handles.end() + more);
        }
    }

    /** Checks circle i of many and prepares it. Each element is read once: another thread may write to the arrays. */
    private void prepare(int i, float[] circles, float[] velocities, int kind) {
        int at = CircleRow.STRIDE * i;
        try {
            prepare(
                    i,
                    circles[at + CircleRow.X],
                    circles[at + CircleRow.Y],
                    circles[at + CircleRow.RADIUS],
                    circles[at + CircleRow.MASS],
                    velocities == null ? 0 : velocities[2 * i],
                    velocities == null ? 0 : velocities[2 * i + 1],
                    kind);
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException("circle " + i + ": " + e.getMessage(), e);
        }
    }

    /** Checks a circle and prepares it behind those ahead. */
    private void prepare(int ahead, float x, float y, float radius, float mass, float vx, float vy, int kind) {
        Bounds bounds = world.settings.bounds();
        Limits.position(x, y, bounds);
        Limits.radius(radius, bounds);
        Limits.mass(mass);
        Limits.velocity(vx, vy);
        KindTable.check(kind);
        float restitution = kinds.newRestitution(kind);
        commands.prepare(ahead, bounds.placeX(x), bounds.placeY(y), radius, mass, restitution, vx, vy);
    }

    /** Adds the circles that are prepared; the handles are optional. */
    void admitAll(int n, int[] own, long[] to) {
        int first = commands.count();
        for (int i = 0; i < n; i++) {
            long handle = admit(own == null ? 0 : own[i]);
            if (to != null) {
                to[i] = handle;
            }
        }
        for (int i = 0; own != null && i < n; i++) {
            if (own[i] != 0) {
                setKind(commands.id(first + i), own[i]);
            }
        }
    }

    /** Gives the first circle that is prepared its id, and returns its handle. A log gets its kind. */
    private long admit(int kind) {
        world.log.writeAdd(kind);
        int id = handles.add(commands.preparedRadius());
        handles.setRestitution(id, commands.preparedRestitution());
        handles.setMass(id, commands.preparedMass());
        commands.admit(id);
        return handles.handle(id);
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
        BulkChanges.checkKinds(kinds, n);
        BulkChanges.checkHandles(to, n, "circles");
    }

    /** Another thread may write to the caller's array. */
    private int[] copy(int[] kinds) {
        if (newKinds.length < kinds.length) {
            newKinds = new int[kinds.length];
        }
        System.arraycopy(kinds, 0, newKinds, 0, kinds.length);
        return newKinds;
    }

    /** Takes down the kind of a circle, for which there is room. */
    private void setKind(int id, int kind) {
        handles.setField(CircleField.KIND, id, kind);
        commands.setField(CircleField.KIND, id, kind);
    }
}
