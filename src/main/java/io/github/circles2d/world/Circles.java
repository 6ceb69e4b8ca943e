package io.github.circles2d.world;

import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.circles.KindTable;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.Limits;

/**
 * The calls on circles: they come, go and change. A change waits as a record in {@link Commands} until the next step or read; what
 * only calls change is in {@link HandleTable} at once. A call checks its arguments and makes room before it changes the state.
 */
public final class Circles {
    private final Simulation simulation;
    private final Guard guard;
    private final HandleTable handles;
    private final Commands commands;
    private final LastReading last;
    private final PreparedChanges changes;

    /** The kinds of the circles that a call adds. */
    private int[] newKinds = new int[0];

    Circles(Simulation simulation) {
        this.simulation = simulation;
        guard = simulation.guard;
        handles = simulation.handles;
        commands = simulation.commands;
        last = simulation.last;
        changes = simulation.changes;
    }

    /** Adds a circle of kind 0 and returns its handle. */
    public long add(float x, float y, float radius, float mass, float vx, float vy) {
        return add(x, y, radius, mass, vx, vy, 0);
    }

    /** Adds a circle, with the restitution of its kind, else the world's, and returns its handle. */
    public long add(float x, float y, float radius, float mass, float vx, float vy, int kind) {
        guard.enter();
        try {
            checkRoom(1);
            check(x, y, radius, mass, vx, vy);
            KindTable.check(kind);
            simulation.expect(2);
            handles.ensure(1);
            if (kind != 0) {
                handles.fields().ensure(CircleField.KIND, handles.end() + 1);
            }
            float restitution = newRestitution(kind);
            commands.prepare(
                    0, simulation.bounds.placeX(x), simulation.bounds.placeY(y), radius, mass, restitution, vx, vy);
            simulation.changed();
            guard.changing = true;
            long handle = admit();
            if (kind != 0) {
                enter(CircleField.KIND, (int) handle, kind);
            }
            guard.changing = false;
            return handle;
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** Adds circles, four elements each. Without velocities they are at rest, without kinds of kind 0; the handles are optional, too. */
    public void addAll(float[] circles, float[] velocities, int[] kinds, long[] to) {
        guard.enter();
        try {
            Limits.notNull("circles", circles);
            int n = circles.length / CircleRow.STRIDE;
            checkLengths(n, circles, velocities, kinds, to);
            checkRoom(n);
            simulation.expect(kinds == null ? n : 2 * n);
            handles.ensure(n);
            int[] own = kinds == null ? null : copy(kinds);
            for (int i = 0; i < n; i++) {
                prepare(i, circles, velocities, own == null ? 0 : own[i]);
            }
            simulation.changed();
            guard.changing = true;
            int first = commands.count();
            for (int i = 0; i < n; i++) {
                long handle = admit();
                if (to != null) {
                    to[i] = handle;
                }
            }
            for (int i = 0; own != null && i < n; i++) {
                if (own[i] != 0) {
                    enter(CircleField.KIND, commands.id(first + i), own[i]);
                }
            }
            guard.changing = false;
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
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

    /** Copies the kinds of circles that are to be added, and makes room for them. Another thread may write to the caller's array. */
    private int[] copy(int[] kinds) {
        if (newKinds.length < kinds.length) {
            newKinds = new int[kinds.length];
        }
        System.arraycopy(kinds, 0, newKinds, 0, kinds.length);
        handles.fields().ensure(CircleField.KIND, handles.end() + kinds.length);
        return newKinds;
    }

    /** Checks circle i of many and prepares it. Each element is read once: another thread may write to the arrays. */
    private void prepare(int i, float[] circles, float[] velocities, int kind) {
        float x = circles[CircleRow.STRIDE * i + CircleRow.X];
        float y = circles[CircleRow.STRIDE * i + CircleRow.Y];
        float radius = circles[CircleRow.STRIDE * i + CircleRow.RADIUS];
        float mass = circles[CircleRow.STRIDE * i + CircleRow.MASS];
        float vx = velocities == null ? 0 : velocities[2 * i];
        float vy = velocities == null ? 0 : velocities[2 * i + 1];
        try {
            check(x, y, radius, mass, vx, vy);
            KindTable.check(kind);
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException("circle " + i + ": " + e.getMessage(), e);
        }
        commands.prepare(
                i,
                simulation.bounds.placeX(x),
                simulation.bounds.placeY(y),
                radius,
                mass,
                newRestitution(kind),
                vx,
                vy);
    }

    private void checkRoom(int more) {
        if (more > Limits.CIRCLES - handles.size()) {
            throw new IllegalArgumentException(
                    "a world has at most " + Limits.CIRCLES + " circles, not " + ((long) handles.size() + more));
        }
    }

    private void check(float x, float y, float radius, float mass, float vx, float vy) {
        Limits.position(x, y, simulation.bounds);
        Limits.radius(radius, simulation.bounds);
        Limits.mass(mass);
        Limits.velocity(vx, vy);
    }

    /** The restitution of a new circle of a kind. */
    private float newRestitution(int kind) {
        return simulation.kinds().restitution(kind, simulation.defaultRestitution);
    }

    /** Gives the first circle that is prepared its id, and returns its handle. */
    private long admit() {
        int id = handles.add(commands.preparedRadius());
        handles.setRestitution(id, commands.preparedRestitution());
        handles.setMass(id, commands.preparedMass());
        commands.admit(id);
        return handles.handle(id);
    }

    /** Removes a circle. */
    public void remove(long handle) {
        guard.enter();
        try {
            int id = find(handle);
            changes.begin(1);
            changes.setChecked(Commands.REMOVE, id, 0, 0);
            changes.make(Commands.REMOVE);
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** Whether a handle is that of a circle. */
    public boolean contains(long handle) {
        guard.enter();
        try {
            return handles.find(handle) >= 0;
        } finally {
            guard.user = null;
        }
    }

    /** One more than the greatest id that a circle has had. */
    public int idLimit() {
        guard.enter();
        try {
            return handles.end();
        } finally {
            guard.user = null;
        }
    }

    /** The handle of the circle that has an id; 0 if there is none. */
    public long handle(int id) {
        guard.enter();
        try {
            if (id < 0 || id >= handles.end()) {
                throw new IllegalArgumentException(
                        "the id is " + id + ", but must be at least 0 and less than " + handles.end());
            }
            return handles.lives(id) ? handles.handle(id) : 0;
        } finally {
            guard.user = null;
        }
    }

    /** The number of circles. */
    public int size() {
        guard.enter();
        try {
            return handles.size();
        } finally {
            guard.user = null;
        }
    }

    /**
     * Changes a circle.
     *
     * @param operation an operation of {@link Commands} that changes a circle
     * @param handle the circle
     * @param a first value of the operation
     * @param b second value; of no meaning if the operation has one
     */
    public void set(int operation, long handle, float a, float b) {
        guard.enter();
        try {
            int id = find(handle);
            checkValues(operation, a, b);
            simulation.expect(2);
            forget(operation);
            guard.changing = true;
            if (operation == Commands.MASS) {
                setMass(id, a);
            }
            boolean places = operation == Commands.POSITION;
            commands.set(
                    operation, id, places ? simulation.bounds.placeX(a) : a, places ? simulation.bounds.placeY(b) : b);
            if (places) {
                simulation.travels.forget(id);
            } else if (operation == Commands.RADIUS) {
                handles.setRadius(id, a);
                simulation.growth.forget(id);
            } else if (operation == Commands.RESTITUTION) {
                handles.setRestitution(id, a);
            }
            guard.changing = false;
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    private void setMass(int id, float mass) {
        if (mass != Float.POSITIVE_INFINITY && simulation.travels.travels(id)) {
            simulation.travels.end(id);
        }
        handles.setMass(id, mass);
    }

    /**
     * Puts a circle somewhere else. A static one is to travel there in the next step.
     *
     * @param handle the circle
     * @param x x of the place
     * @param y y of the place
     */
    public void move(long handle, float x, float y) {
        guard.enter();
        try {
            int id = find(handle);
            changes.begin(1);
            changes.move(id, x, y);
            changes.make(Commands.POSITION);
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /**
     * Changes a field of a circle.
     *
     * @param field what changes
     * @param handle the circle
     * @param value the new value
     */
    public void set(CircleField field, long handle, long value) {
        guard.enter();
        try {
            int id = find(handle);
            field.check(value);
            simulation.expect(1);
            handles.fields().ensure(field, id + 1);
            simulation.snapshots().forget();
            if (!field.isOfSteps()) {
                simulation.journal.field(field, id, value);
            }
            guard.changing = true;
            enter(field, id, value);
            guard.changing = false;
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** Gives a circle another kind, and the restitution of the kind if it has one. */
    public void setKind(long handle, int kind) {
        guard.enter();
        try {
            int id = find(handle);
            changes.begin(2);
            changes.setKind(id, kind);
            changes.make(Commands.FIELD);
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** Sets the force on a circle. */
    public void setForce(long handle, float x, float y) {
        guard.enter();
        try {
            int id = find(handle);
            changes.begin(2);
            changes.setForce(id, x, y);
            changes.make(Commands.FIELD);
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** Applies a force to a circle in the next step. */
    public void applyForce(long handle, float x, float y) {
        guard.enter();
        try {
            int id = find(handle);
            Limits.force(x, y);
            simulation.forces.ensure();
            handles.fields().ensure(CircleField.APPLIED_X, id + 1);
            handles.fields().ensure(CircleField.APPLIED_Y, id + 1);
            simulation.journal.force(id, x, y);
            simulation.snapshots().forget();
            guard.changing = true;
            simulation.forces.apply(id, x, y);
            guard.changing = false;
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** A component of the force that is set for a circle: {@link CircleField#FORCE_X} or {@code FORCE_Y}. */
    public float force(CircleField component, long handle) {
        return Float.intBitsToFloat((int) get(component, handle));
    }

    /** Takes down the value of a field, for which there is room. */
    private void enter(CircleField field, int id, long value) {
        handles.fields().set(field, id, value);
        if (field.isOfSteps()) {
            commands.setField(field, id, (int) value);
        }
    }

    /** A field of a circle. */
    public long get(CircleField field, long handle) {
        guard.enter();
        try {
            return handles.fields().get(field, find(handle));
        } finally {
            guard.user = null;
        }
    }

    /** An operation makes what was read or saved out of date. */
    void forget(int operation) {
        switch (operation) {
            case Commands.VELOCITY, Commands.IMPULSE -> last.forgetVelocities();
            case Commands.REMOVE -> simulation.changed();
            case Commands.RESTITUTION, Commands.FIELD -> {
                // no read has them
            }
            default -> last.forgetCircles();
        }
        simulation.snapshots().forget();
    }

    void checkValues(int operation, float a, float b) {
        switch (operation) {
            case Commands.POSITION -> Limits.position(a, b, simulation.bounds);
            case Commands.VELOCITY -> Limits.velocity(a, b);
            case Commands.RADIUS -> Limits.radius(a, simulation.bounds);
            case Commands.MASS -> Limits.mass(a);
            case Commands.RESTITUTION -> Limits.restitution(a);
            case Commands.IMPULSE -> Limits.impulse(a, b);
            default -> throw new IllegalArgumentException("operation " + operation + " changes no circle");
        }
    }

    int find(long handle) {
        int id = handles.find(handle);
        if (id < 0) {
            throw new IllegalArgumentException(
                    "no circle has the handle " + handle + ": it was removed, or is none of this world's");
        }
        return id;
    }

    /** The restitution of one circle. */
    public float restitution(long handle) {
        guard.enter();
        try {
            return handles.restitution(find(handle));
        } finally {
            guard.user = null;
        }
    }
}
