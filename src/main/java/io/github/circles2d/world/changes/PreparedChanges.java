package io.github.circles2d.world.changes;

import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.KindTable;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.shared.WorldParts;

/**
 * The changes of one call, which are made all at once or not at all. Each is checked and copied into the room behind the records of
 * {@link Commands}; {@link AdmittedChanges} then makes them. So a call for one circle and a call for many follow the same rules.
 */
public final class PreparedChanges {
    private final WorldParts world;
    private final Kinds kinds;
    private final Travels travelling;
    private final AdmittedChanges admitted;
    private int count;

    /** Positions of static circles, which travel there. */
    private int travels;

    /** The circles that are to be removed. Only valid if the call removes circles. */
    private final IdSet leaving = new IdSet();

    public PreparedChanges(WorldParts world, Kinds kinds, Travels travelling, AdmittedChanges admitted) {
        this.world = world;
        this.kinds = kinds;
        this.travelling = travelling;
        this.admitted = admitted;
    }

    void checkValues(int operation, float a, float b) {
        switch (operation) {
            case Commands.POSITION -> Limits.position(a, b, world.settings.bounds());
            case Commands.VELOCITY -> Limits.velocity(a, b);
            case Commands.RADIUS -> Limits.radius(a, world.settings.bounds());
            case Commands.MASS -> Limits.mass(a);
            case Commands.RESTITUTION -> Limits.restitution(a);
            case Commands.IMPULSE -> Limits.impulse(a, b);
            case Commands.ANGULAR_VELOCITY ->
                Limits.within("angular velocity", a, -Limits.ANGULAR_VELOCITY, Limits.ANGULAR_VELOCITY);
            case Commands.ANGULAR_IMPULSE -> {
                Limits.within("angular impulse", a, -Limits.ANGULAR_IMPULSE, Limits.ANGULAR_IMPULSE);
                Limits.within("the inverse inertia by inverse mass", b, 0, 2);
            }
            default -> throw new IllegalArgumentException("operation " + operation + " changes no circle");
        }
    }

    /** Begins a call of about so many changes. */
    void begin(int changes) {
        world.pending.expect(changes);
        count = 0;
        travels = 0;
    }

    void set(int operation, int id, float a, float b) {
        checkValues(operation, a, b);
        setChecked(operation, id, a, b);
    }

    /** Prepares an operation whose values are in range. */
    void setChecked(int operation, int id, float a, float b) {
        world.commands.prepareChange(count++, operation, id, a, b);
    }

    /** Prepares a new angle, in units of a turn's 2^-32. */
    void setAngle(int id, int units) {
        world.commands.prepareInt(count++, Commands.ANGLE, id, units);
    }

    /** Prepares a new angular velocity. There is one zero. */
    void setAngularVelocity(int id, float velocity) {
        set(Commands.ANGULAR_VELOCITY, id, velocity + 0f, 0);
    }

    /** Prepares an angular impulse. The inverse inertia by inverse mass is that of the circle's kind if it is NaN. */
    void pushAround(int id, float impulse, float inertia) {
        float ofKind = kinds.inertia(world.handles.fields().getInt(CircleField.KIND, id));
        set(Commands.ANGULAR_IMPULSE, id, impulse, Float.isNaN(inertia) ? ofKind : inertia);
    }

    /** Prepares a new position. A static circle travels there. */
    void move(int id, float x, float y) {
        checkValues(Commands.POSITION, x, y);
        setChecked(
                Commands.POSITION,
                id,
                world.settings.bounds().placeX(x),
                world.settings.bounds().placeY(y));
        if (world.handles.isStatic(id)) {
            travelling.ensure(id, travels++);
        }
    }

    void setForce(int id, float x, float y) {
        Limits.force(x, y);
        setField(CircleField.FORCE_X, id, CircleField.bits(x));
        setField(CircleField.FORCE_Y, id, CircleField.bits(y));
    }

    /** Prepares another kind, and the restitution of the kind if it has one. */
    void setKind(int id, int kind) {
        setField(CircleField.KIND, id, KindTable.check(kind));
        float restitution = kinds.restitution(kind, Float.NaN);
        if (!Float.isNaN(restitution)) {
            setChecked(Commands.RESTITUTION, id, restitution, 0);
        }
    }

    private void setField(CircleField field, int id, int value) {
        world.handles.fields().ensure(field, id + 1);
        world.commands.prepareField(count++, field, id, value);
    }

    /** Prepares that a circle goes. Returns false if this has been prepared already. */
    boolean remove(int id) {
        if (count == 0) {
            leaving.begin(world.handles.end());
        }
        if (!leaving.add(id)) {
            return false;
        }
        setChecked(Commands.REMOVE, id, 0, 0);
        return true;
    }

    /** Makes what has been prepared, by one operation; {@link Commands#FIELD} also if some changes are of restitutions. */
    void make(int operation) {
        if (operation == Commands.REMOVE && world.joints.isThere()) {
            makeRoomForJoints();
        }
        admitted.make(operation, count, travels);
    }

    /** Joints go with their circles. */
    private void makeRoomForJoints() {
        world.pending.settleJoints();
        int leavingToo = 0;
        for (int k = 0; k < count; k++) {
            leavingToo += world.joints.departures().countOf(world.commands.preparedId(k));
        }
        world.joints.departures().ensure(leavingToo);
    }
}
