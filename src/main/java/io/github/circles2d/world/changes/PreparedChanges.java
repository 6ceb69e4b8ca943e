package io.github.circles2d.world.changes;

import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.circles.KindTable;
import io.github.circles2d.world.joints.JointTables;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.shared.CallLog;
import io.github.circles2d.world.shared.Copies;
import io.github.circles2d.world.shared.Guard;
import io.github.circles2d.world.shared.Needs;
import io.github.circles2d.world.shared.PendingWork;
import io.github.circles2d.world.shared.WorldSettings;

/**
 * The changes of one call, which are made all at once or not at all. Each is checked and copied into the room behind the records of
 * {@link Commands}; {@link #make} then records them and changes what the host knows. So a call for one circle and a call for many follow
 * the same rules.
 */
public final class PreparedChanges {
    private final Guard guard;
    private final HandleTable handles;
    private final Commands commands;
    private final CallLog log;
    private final PendingWork pending;
    private final Copies copies;
    private final WorldSettings settings;
    private final Kinds kinds;
    private final Travels travelling;
    private final JointTables joints;
    private final Needs needs;
    private int count;

    /** Positions of static circles, which travel there. */
    private int travels;

    /** The circles that are to be removed. Only valid if the call removes circles. */
    private final IdSet leaving = new IdSet();

    public PreparedChanges(
            Guard guard,
            HandleTable handles,
            Commands commands,
            CallLog log,
            PendingWork pending,
            Copies copies,
            WorldSettings settings,
            Kinds kinds,
            Travels travelling,
            JointTables joints,
            Needs needs) {
        this.guard = guard;
        this.handles = handles;
        this.commands = commands;
        this.log = log;
        this.pending = pending;
        this.copies = copies;
        this.settings = settings;
        this.kinds = kinds;
        this.travelling = travelling;
        this.joints = joints;
        this.needs = needs;
    }

    void checkValues(int operation, float a, float b) {
        switch (operation) {
            case Commands.POSITION -> Limits.position(a, b, settings.bounds());
            case Commands.VELOCITY -> Limits.velocity(a, b);
            case Commands.RADIUS -> Limits.radius(a, settings.bounds());
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
        pending.expect(changes);
        count = 0;
        travels = 0;
    }

    void set(int operation, int id, float a, float b) {
        checkValues(operation, a, b);
        setChecked(operation, id, a, b);
    }

    /** Prepares an operation whose values are in range. */
    void setChecked(int operation, int id, float a, float b) {
        commands.prepareChange(count++, operation, id, a, b);
    }

    /** Prepares a new angle, in units of a turn's 2^-32. */
    void setAngle(int id, int units) {
        commands.prepareInt(count++, Commands.ANGLE, id, units);
    }

    /** Prepares a new angular velocity. There is one zero. */
    void setAngularVelocity(int id, float velocity) {
        set(Commands.ANGULAR_VELOCITY, id, velocity + 0f, 0);
    }

    /** Prepares a new position. A static circle travels there. */
    void move(int id, float x, float y) {
        checkValues(Commands.POSITION, x, y);
        setChecked(
                Commands.POSITION,
                id,
                settings.bounds().placeX(x),
                settings.bounds().placeY(y));
        if (handles.isStatic(id)) {
            travelling.ensure(id, travels++);
        }
    }

    void setForce(int id, float x, float y) {
        Limits.force(x, y);
        setField(CircleField.FORCE_X, id, Forces.bits(x));
        setField(CircleField.FORCE_Y, id, Forces.bits(y));
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
        handles.fields().ensure(field, id + 1);
        commands.prepareField(count++, field, id, value);
    }

    /** Prepares that a circle goes. Returns false if this has been prepared already. */
    boolean remove(int id) {
        if (count == 0) {
            leaving.begin(handles.end());
        }
        if (!leaving.add(id)) {
            return false;
        }
        setChecked(Commands.REMOVE, id, 0, 0);
        return true;
    }

    /** Reads are forgotten by the operation; {@link Commands#FIELD} also if some are of restitutions. */
    void make(int operation) {
        if (operation == Commands.REMOVE && joints.isThere()) {
            makeRoomForJoints();
        }
        if (travels < count) {
            copies.forgetBy(operation);
        } else {
            copies.forgetSaved(); // reads give the old places
        }
        if (travels > 0) {
            recordTravels();
        }
        boolean turns = Commands.turns(operation);
        boolean ofPipelines = turns || operation == Commands.VELOCITY || operation == Commands.IMPULSE;
        guard.changing = true;
        if (turns && count > 0) {
            needs.askToTurn();
        }
        commands.admitChanges(ofPipelines ? count : changeAll());
        guard.changing = false;
    }

    /** Joints go with their circles. */
    private void makeRoomForJoints() {
        pending.settleJoints();
        int leavingToo = 0;
        for (int k = 0; k < count; k++) {
            leavingToo += joints.departures().countOf(commands.preparedId(k));
        }
        joints.departures().ensure(leavingToo);
    }

    /** Changes what the host knows. Returns how many changes a pipeline has to know too; these come first then. */
    private int changeAll() {
        int recorded = 0;
        for (int k = 0; k < count; k++) {
            if (change(k)) {
                commands.advancePrepared(k, recorded++);
            }
        }
        return recorded;
    }

    private void recordTravels() {
        for (int k = 0; k < count; k++) {
            if (isTravel(k)) {
                log.travel(commands.preparedId(k), commands.preparedFirst(k), commands.preparedSecond(k));
            }
        }
    }

    private boolean isTravel(int k) {
        return commands.preparedOperation(k) == Commands.POSITION && handles.isStatic(commands.preparedId(k));
    }

    /** Makes one change likewise. Returns whether a pipeline has to know it too. */
    private boolean change(int k) {
        int id = commands.preparedId(k);
        switch (commands.preparedOperation(k)) {
            case Commands.POSITION -> {
                if (handles.isStatic(id)) {
                    travelling.set(id, commands.preparedFirst(k), commands.preparedSecond(k));
                    return false;
                }
            }
            case Commands.REMOVE -> {
                joints.departures().removeOfCircle(id);
                handles.remove(id);
            }
            case Commands.RESTITUTION -> handles.setRestitution(id, commands.preparedFirst(k));
            case Commands.FIELD -> handles.fields().set(commands.preparedField(k), id, commands.preparedValue(k));
            default ->
                throw new IllegalStateException(
                        "no change of the host's is operation " + commands.preparedOperation(k));
        }
        return true;
    }
}
