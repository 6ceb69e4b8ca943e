package io.github.circles2d.world.changes;

import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.circles.KindField;
import io.github.circles2d.world.circles.KindTable;
import io.github.circles2d.world.joints.JointTable;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.model.Surface;
import io.github.circles2d.world.shared.CallLog;
import io.github.circles2d.world.shared.Copies;
import io.github.circles2d.world.shared.Guard;
import io.github.circles2d.world.shared.Needs;
import io.github.circles2d.world.shared.PendingWork;
import io.github.circles2d.world.shared.WorldSettings;

/**
 * The calls on circles: they come, go and change. A change waits as a record in {@link Commands} until the next step or read; what
 * only calls change is in {@link HandleTable} at once. A call checks its arguments and makes room before it changes the state.
 */
public final class Circles {
    // The functions of the calls. They are linked before memory, or the stack, may end in a call.
    private static final Guard.FloatsChange<Circles> ADD = Circles::addOne;
    private static final Guard.CircleChange<Circles> REMOVE = (circles, h, n, a, b) -> circles.removeOne(h);
    private static final Guard.Numbers<Circles, Void> CONTAINS = (circles, none, h, n) -> circles.handles.find(h);
    private static final Guard.Numbers<Circles, Void> HANDLE = (circles, none, i, n) -> circles.handleOf((int) i);
    private static final Guard.CircleChange<Circles> SET = Circles::setOne;
    private static final Guard.CircleChange<Circles> MOVE = (circles, h, n, a, b) -> circles.moveOne(h, a, b);
    private static final Guard.Numbers<Circles, CircleField> SET_FIELD = Circles::setField;
    private static final Guard.CircleChange<Circles> SET_KIND = (circles, h, k, a, b) -> circles.setKindOf(h, k);
    private static final Guard.CircleChange<Circles> SET_FORCE = (circles, h, n, a, b) -> circles.setForceOn(h, a, b);
    private static final Guard.CircleChange<Circles> APPLY_FORCE =
            (circles, h, n, a, b) -> circles.applyForceTo(h, a, b);
    private static final Guard.CircleChange<Circles> APPLY_TORQUE =
            (circles, h, n, torque, none) -> circles.applyTorqueTo(h, torque);
    private static final Guard.CircleChange<Circles> SET_ANGLE = (circles, h, units, a, b) -> circles.turn(h, units);
    private static final Guard.CircleChange<Circles> SET_ANGULAR_VELOCITY =
            (circles, h, n, velocity, none) -> circles.setAngularVelocityOf(h, velocity);
    private static final Guard.CircleChange<Circles> APPLY_ANGULAR_IMPULSE =
            (circles, h, n, impulse, inertia) -> circles.pushAround(h, impulse, inertia);
    private static final Guard.Numbers<Circles, Void> FRICTION = (circles, none, h, n) ->
            circles.surfaceBits(h, CircleField.FRICTION, KindField.FRICTION, circles.settings.surfaces().friction);
    private static final Guard.Numbers<Circles, Void> ROLLING_RESISTANCE = (circles, none, h, n) -> circles.surfaceBits(
            h,
            CircleField.ROLLING_RESISTANCE,
            KindField.ROLLING_RESISTANCE,
            circles.settings.surfaces().rollingResistance);
    private static final Guard.Numbers<Circles, CircleField> GET =
            (circles, f, h, n) -> circles.handles.fields().get(f, circles.find(h));
    private static final Guard.Numbers<Circles, Void> RESTITUTION =
            (circles, none, h, n) -> Float.floatToRawIntBits(circles.handles.restitution(circles.find(h)));

    private final Guard guard;
    private final HandleTable handles;
    private final Commands commands;
    private final CallLog log;
    private final PendingWork pending;
    private final Copies copies;
    private final WorldSettings settings;
    private final Kinds kinds;
    private final Forces forces;
    private final Travels travels;
    private final Growth growth;
    private final PreparedChanges changes;
    private final Needs needs;

    /** The kinds of the circles that a call adds. */
    private int[] newKinds = new int[0];

    public Circles(
            Guard guard,
            HandleTable handles,
            Commands commands,
            CallLog log,
            PendingWork pending,
            Copies copies,
            WorldSettings settings,
            Kinds kinds,
            Forces forces,
            Travels travels,
            Growth growth,
            PreparedChanges changes,
            Needs needs) {
        this.guard = guard;
        this.handles = handles;
        this.commands = commands;
        this.log = log;
        this.pending = pending;
        this.copies = copies;
        this.settings = settings;
        this.kinds = kinds;
        this.forces = forces;
        this.travels = travels;
        this.growth = growth;
        this.changes = changes;
        this.needs = needs;
    }

    /** Adds a circle of kind 0 and returns its handle. */
    public long add(float x, float y, float radius, float mass, float vx, float vy) {
        return add(x, y, radius, mass, vx, vy, 0);
    }

    /** Adds a circle, with the restitution of its kind, else the world's, and returns its handle. */
    public long add(float x, float y, float radius, float mass, float vx, float vy, int kind) {
        return guard.change(this, kind, x, y, radius, mass, vx, vy, ADD);
    }

    private long addOne(int kind, float x, float y, float radius, float mass, float vx, float vy) {
        checkRoom(1);
        check(x, y, radius, mass, vx, vy);
        KindTable.check(kind);
        pending.expect(2);
        handles.ensure(1);
        if (kind != 0) {
            handles.fields().ensure(CircleField.KIND, handles.end() + 1);
        }
        float restitution = newRestitution(kind);
        commands.prepare(
                0, settings.bounds().placeX(x), settings.bounds().placeY(y), radius, mass, restitution, vx, vy);
        copies.forget();
        guard.changing = true;
        long handle = admit();
        if (kind != 0) {
            enter(CircleField.KIND, (int) handle, kind);
        }
        guard.changing = false;
        return handle;
    }

    /**
     * Adds circles, four elements each. Without velocities they are at rest, without kinds of kind 0; the handles are optional,
     * too.
     */
    public void addAll(float[] circles, float[] velocities, int[] kinds, long[] to) {
        guard.enter();
        try {
            Limits.notNull("circles", circles);
            int n = circles.length / CircleRow.STRIDE;
            checkLengths(n, circles, velocities, kinds, to);
            checkRoom(n);
            pending.expect(kinds == null ? n : 2 * n);
            handles.ensure(n);
            int[] own = kinds == null ? null : copy(kinds);
            for (int i = 0; i < n; i++) {
                prepare(i, circles, velocities, own == null ? 0 : own[i]);
            }
            copies.forget();
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

    /**
     * Copies the kinds of circles that are to be added, and makes room for them. Another thread may write to the caller's array.
     */
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
                settings.bounds().placeX(x),
                settings.bounds().placeY(y),
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
        Limits.position(x, y, settings.bounds());
        Limits.radius(radius, settings.bounds());
        Limits.mass(mass);
        Limits.velocity(vx, vy);
    }

    /** The restitution of a new circle of a kind. */
    private float newRestitution(int kind) {
        return kinds.restitution(kind, settings.defaultRestitution());
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
        guard.change(this, handle, 0, 0, 0, REMOVE);
    }

    private void removeOne(long handle) {
        int id = find(handle);
        changes.begin(1);
        changes.setChecked(Commands.REMOVE, id, 0, 0);
        changes.make(Commands.REMOVE);
    }

    /** Whether a handle is that of a circle. */
    public boolean contains(long handle) {
        return guard.read(this, null, handle, 0, CONTAINS) >= 0;
    }

    /** One more than the greatest id that a circle has had. */
    public int idLimit() {
        guard.check();
        return handles.end();
    }

    /** The handle of the circle that has an id; 0 if there is none. */
    public long handle(int id) {
        return guard.read(this, null, id, 0, HANDLE);
    }

    private long handleOf(int id) {
        if (id < 0 || id >= handles.end()) {
            throw new IllegalArgumentException(
                    "the id is " + id + ", but must be at least 0 and less than " + handles.end());
        }
        return handles.lives(id) ? handles.handle(id) : 0;
    }

    /** The number of circles. */
    public int size() {
        guard.check();
        return handles.size();
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
        guard.change(this, handle, operation, a, b, SET);
    }

    private void setOne(long handle, int operation, float a, float b) {
        int id = find(handle);
        changes.checkValues(operation, a, b);
        pending.expect(2);
        copies.forgetBy(operation);
        guard.changing = true;
        if (operation == Commands.MASS) {
            setMass(id, a);
        }
        boolean places = operation == Commands.POSITION;
        commands.set(
                operation,
                id,
                places ? settings.bounds().placeX(a) : a,
                places ? settings.bounds().placeY(b) : b);
        if (places) {
            travels.forget(id);
        } else if (operation == Commands.RADIUS) {
            handles.setRadius(id, a);
            growth.forget(id);
        } else if (operation == Commands.RESTITUTION) {
            handles.setRestitution(id, a);
        }
        guard.changing = false;
    }

    private void setMass(int id, float mass) {
        if (mass != Float.POSITIVE_INFINITY && travels.travels(id)) {
            travels.end(id);
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
        guard.change(this, handle, 0, x, y, MOVE);
    }

    private void moveOne(long handle, float x, float y) {
        int id = find(handle);
        changes.begin(1);
        changes.move(id, x, y);
        changes.make(Commands.POSITION);
    }

    /**
     * Changes a field of a circle.
     *
     * @param field what changes
     * @param handle the circle
     * @param value the new value
     */
    public void set(CircleField field, long handle, long value) {
        guard.read(this, field, handle, value, SET_FIELD);
    }

    private long setField(CircleField field, long handle, long value) {
        int id = find(handle);
        field.check(value);
        pending.expect(1);
        handles.fields().ensure(field, id + 1);
        copies.forgetSaved();
        if (!field.isOfSteps()) {
            log.field(field, id, value);
        }
        guard.changing = true;
        if (field.isOfTurning() && value != field.initial()) {
            needs.askToTurn();
        }
        enter(field, id, value);
        guard.changing = false;
        return 0;
    }

    /** Gives a circle friction of its own, or takes it away. */
    public void setFriction(long handle, float friction) {
        set(CircleField.FRICTION, handle, Float.isNaN(friction) ? CircleField.NONE : bits(Limits.friction(friction)));
    }

    /** Gives a circle rolling resistance of its own, or takes it away. */
    public void setRollingResistance(long handle, float resistance) {
        set(
                CircleField.ROLLING_RESISTANCE,
                handle,
                Float.isNaN(resistance) ? CircleField.NONE : bits(Limits.rollingResistance(resistance)));
    }

    /** There is one zero. */
    private static int bits(float value) {
        return Float.floatToRawIntBits(value + 0f);
    }

    /** The friction of a circle: its own, else that of its kind, else the world's. */
    public float friction(long handle) {
        return Float.intBitsToFloat((int) guard.read(this, null, handle, 0, FRICTION));
    }

    /** Likewise. */
    public float rollingResistance(long handle) {
        return Float.intBitsToFloat((int) guard.read(this, null, handle, 0, ROLLING_RESISTANCE));
    }

    private int surfaceBits(long handle, CircleField field, KindField ofKind, float ofWorld) {
        int id = find(handle);
        float own = handles.fields().getFloat(field, id);
        int kind = handles.fields().getInt(CircleField.KIND, id);
        return Float.floatToRawIntBits(Float.isNaN(own) ? kinds.own(ofKind, kind, ofWorld) : own);
    }

    /** Turns a circle to an angle in radians. */
    public void setAngle(long handle, float angle) {
        Limits.within("angle", angle, -Limits.ANGLE, Limits.ANGLE);
        turnTo(handle, Surface.units(angle));
    }

    /** Turns a circle to an angle in units of a turn's 2^-32. */
    public void turnTo(long handle, int units) {
        guard.change(this, handle, units, 0, 0, SET_ANGLE);
    }

    private void turn(long handle, int units) {
        int id = find(handle);
        changes.begin(1);
        changes.setAngle(id, units);
        changes.make(Commands.ANGLE);
    }

    public void setAngularVelocity(long handle, float velocity) {
        guard.change(this, handle, 0, velocity, 0, SET_ANGULAR_VELOCITY);
    }

    private void setAngularVelocityOf(long handle, float velocity) {
        int id = find(handle);
        changes.begin(1);
        changes.setAngularVelocity(id, velocity);
        changes.make(Commands.ANGULAR_VELOCITY);
    }

    /** Applies an angular impulse to a circle of its kind. */
    public void applyAngularImpulse(long handle, float impulse) {
        applyAngularImpulse(handle, impulse, Float.NaN);
    }

    /** Applies an angular impulse. The inverse inertia by inverse mass is that of the circle's kind if it is NaN. */
    public void applyAngularImpulse(long handle, float impulse, float inertia) {
        guard.change(this, handle, 0, impulse, inertia, APPLY_ANGULAR_IMPULSE);
    }

    private void pushAround(long handle, float impulse, float inertia) {
        int id = find(handle);
        float ofKind = kinds.inertia(handles.fields().getInt(CircleField.KIND, id));
        changes.begin(1);
        changes.set(Commands.ANGULAR_IMPULSE, id, impulse, Float.isNaN(inertia) ? ofKind : inertia);
        changes.make(Commands.ANGULAR_IMPULSE);
    }

    /** Gives a circle another kind, and the restitution of the kind if it has one. */
    public void setKind(long handle, int kind) {
        guard.change(this, handle, kind, 0, 0, SET_KIND);
    }

    private void setKindOf(long handle, int kind) {
        int id = find(handle);
        changes.begin(2);
        changes.setKind(id, kind);
        changes.make(Commands.FIELD);
    }

    /** Sets the force on a circle. */
    public void setForce(long handle, float x, float y) {
        guard.change(this, handle, 0, x, y, SET_FORCE);
    }

    private void setForceOn(long handle, float x, float y) {
        int id = find(handle);
        changes.begin(2);
        changes.setForce(id, x, y);
        changes.make(Commands.FIELD);
    }

    /** Applies a force to a circle in the next step. */
    public void applyForce(long handle, float x, float y) {
        guard.change(this, handle, 0, x, y, APPLY_FORCE);
    }

    private void applyForceTo(long handle, float x, float y) {
        int id = find(handle);
        Limits.force(x, y);
        forces.ensure();
        handles.fields().ensure(CircleField.APPLIED_X, id + 1);
        handles.fields().ensure(CircleField.APPLIED_Y, id + 1);
        log.force(id, x, y);
        copies.forgetSaved();
        guard.changing = true;
        forces.apply(id, x, y);
        guard.changing = false;
    }

    /** Sets the torque on a circle. */
    public void setTorque(long handle, float torque) {
        set(CircleField.TORQUE, handle, Forces.bits(torque));
    }

    /** Applies a torque to a circle in the next step. */
    public void applyTorque(long handle, float torque) {
        guard.change(this, handle, 0, torque, 0, APPLY_TORQUE);
    }

    private void applyTorqueTo(long handle, float torque) {
        int id = find(handle);
        Limits.within("torque", torque, -Limits.TORQUE, Limits.TORQUE);
        forces.ensure();
        handles.fields().ensure(CircleField.APPLIED_TORQUE, id + 1);
        log.torque(id, torque);
        copies.forgetSaved();
        guard.changing = true;
        needs.askToTurn();
        forces.applyTorque(id, torque);
        guard.changing = false;
    }

    /** What is set for a circle: {@link CircleField#FORCE_X}, {@code FORCE_Y} or {@code TORQUE}. */
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
        return guard.read(this, field, handle, 0, GET);
    }

    private int find(long handle) {
        return find(handles, handle);
    }

    /** The id of the circle that has a handle. */
    public static int find(HandleTable handles, long handle) {
        int id = handles.find(handle);
        if (id < 0) {
            throw new IllegalArgumentException(gone(handle));
        }
        return id;
    }

    /** Why a handle is refused. */
    static String gone(long handle) {
        return "no circle has the handle " + handle
                + (JointTable.isMarked(handle) ? ": it is of a joint" : ": it was removed, or is none of this world's");
    }

    /** The restitution of one circle. */
    public float restitution(long handle) {
        return Float.intBitsToFloat((int) guard.read(this, null, handle, 0, RESTITUTION));
    }
}
