package io.github.circles2d.world.changes;

import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.KindTable;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.shared.Call;
import io.github.circles2d.world.shared.WorldParts;

/**
 * The changes of one call, which are made all at once or not at all. Each is checked and copied into the room behind the records of
 * {@link Commands}. So a call for one circle and a call for many follow the same rules.
 */
public final class PreparedChanges {
    private final WorldParts world;
    private final Kinds kinds;
    private final Travels travelling;
    private int count;

    /** Positions of static circles, which travel there. */
    private int travels;

    /** Those of a change that is checked. */
    private final int[] words = new int[Call.MOST_WORDS];

    /** The circles that are to be removed. Only valid if the call removes circles. */
    private final IdSet leaving = new IdSet();

    public PreparedChanges(WorldParts world, Kinds kinds, Travels travelling) {
        this.world = world;
        this.kinds = kinds;
        this.travelling = travelling;
    }

    /** Begins a call of about so many changes. */
    void begin(int changes) {
        world.pending.expect(changes);
        count = 0;
        travels = 0;
    }

    void set(Call call, int id, float a, float b) {
        words[1] = Float.floatToRawIntBits(a);
        words[2] = Float.floatToRawIntBits(b);
        call.check(words, world.settings);
        setChecked(call.number, id, a, b);
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
        set(Call.ANGULAR_VELOCITY, id, velocity + 0f, 0);
    }

    /** Prepares an angular impulse, which is in range. */
    void pushAround(int id, float impulse) {
        float inertia = kinds.inertia(world.handles.fields().getInt(CircleField.KIND, id));
        setChecked(Commands.ANGULAR_IMPULSE, id, impulse, inertia);
    }

    /** Prepares a new position. A static circle travels there. */
    void move(int id, float x, float y) {
        Bounds bounds = world.settings.bounds();
        Limits.position(x, y, bounds);
        setChecked(Commands.POSITION, id, bounds.placeX(x), bounds.placeY(y));
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

    /** Makes the last room for what has been prepared. */
    void makeRoom(int operation) {
        if (operation == Commands.REMOVE && world.joints.isThere()) {
            makeRoomForJoints();
        }
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

    /** Writes a row for each prepared change to the log, for a call of many circles, which has no row. */
    void writeToLog() {
        if (world.log.writer() == null) {
            return;
        }
        for (int k = 0; k < count; k++) {
            writeToLog(k);
        }
    }

    private void writeToLog(int k) {
        int operation = world.commands.preparedOperation(k);
        if (operation == Commands.FIELD) {
            world.log.writeField(
                    world.commands.preparedField(k), world.commands.preparedId(k), world.commands.preparedValue(k));
        } else {
            world.log.writeRecord(
                    operation == Commands.POSITION ? Call.MOVE : Call.of(operation), world.commands.count() + k);
        }
    }

    /** Makes what has been prepared, by one operation; {@link Commands#FIELD} also if some changes are of restitutions. There is room. */
    void make(int operation) {
        if (travels < count) {
            world.copies.forgetBy(operation);
        } else {
            world.copies.forgetSaved(); // reads give the old places
        }
        boolean turns = Commands.turns(operation);
        boolean ofPipelines = turns || operation == Commands.VELOCITY || operation == Commands.IMPULSE;
        world.guard.changing = true;
        if (turns && count > 0) {
            world.needs.askToTurn();
        }
        world.commands.admitChanges(ofPipelines ? count : changeAll());
        world.guard.changing = false;
    }

    /** Changes what the host knows. Returns how many changes a pipeline has to know too; these come first then. */
    private int changeAll() {
        int recorded = 0;
        for (int k = 0; k < count; k++) {
            if (change(k)) {
                world.commands.advancePrepared(k, recorded++);
            }
        }
        return recorded;
    }

    /** Makes one change likewise. Returns whether a pipeline has to know it too. */
    private boolean change(int k) {
        int id = world.commands.preparedId(k);
        switch (world.commands.preparedOperation(k)) {
            case Commands.POSITION -> {
                if (world.handles.isStatic(id)) {
                    travelling.set(id, world.commands.preparedFirst(k), world.commands.preparedSecond(k));
                    return false;
                }
            }
            case Commands.REMOVE -> {
                world.joints.departures().removeOfCircle(id);
                world.handles.remove(id);
            }
            case Commands.RESTITUTION -> world.handles.setRestitution(id, world.commands.preparedFirst(k));
            case Commands.FIELD ->
                world.handles.fields().set(world.commands.preparedField(k), id, world.commands.preparedValue(k));
            default ->
                throw new IllegalStateException(
                        "no change of the host's is operation " + world.commands.preparedOperation(k));
        }
        return true;
    }
}
