package io.github.circles2d.world.changes;

import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.circles.KindTable;
import io.github.circles2d.world.joints.JointTable;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.JointRow;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.shared.Call;
import io.github.circles2d.world.shared.WorldParts;
import java.util.Arrays;

/**
 * The changes of circles by one call, which are made all at once or not at all. Each is checked and copied into the room behind the records of
 * {@link Commands}. So a call for one circle, a call for many and a log follow the same rules.
 */
public final class PreparedChanges {
    private final WorldParts world;
    private final HandleTable handles;
    private final Commands commands;
    private final Kinds kinds;
    private final Travels travels;
    private int count;

    /** Positions of static circles, which travel there. */
    private int travelling;

    /** Ids of circles that joints held to those that go. */
    private int[] partner = new int[0];

    private int partners;

    /** The circles that are to be removed. Only valid if the call removes circles. */
    private final IdSet leaving = new IdSet();

    public PreparedChanges(WorldParts world, Kinds kinds, Travels travels) {
        this.world = world;
        this.kinds = kinds;
        handles = world.handles;
        commands = world.commands;
        this.travels = travels;
    }

    /** Begins a call of about so many changes. */
    void begin(int changes) {
        world.pending.expect(changes);
        count = 0;
        travelling = 0;
    }

    void setVelocity(int id, float x, float y) {
        Limits.velocity(x, y);
        setChecked(Commands.VELOCITY, id, x, y);
    }

    void push(int id, float x, float y) {
        Limits.impulse(x, y);
        setChecked(Commands.IMPULSE, id, x, y);
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
        Limits.within("angular velocity", velocity, -Limits.ANGULAR_VELOCITY, Limits.ANGULAR_VELOCITY);
        setChecked(Commands.ANGULAR_VELOCITY, id, velocity + 0f, 0);
    }

    void pushAround(int id, float impulse) {
        Limits.within("angular impulse", impulse, -Limits.ANGULAR_IMPULSE, Limits.ANGULAR_IMPULSE);
        float inertia = kinds.inertia(handles.fields().getInt(CircleField.KIND, id));
        setChecked(Commands.ANGULAR_IMPULSE, id, impulse, inertia);
    }

    /** Prepares a new position. A static circle travels there. */
    void move(int id, float x, float y) {
        Bounds bounds = world.settings.bounds();
        Limits.position(x, y, bounds);
        setChecked(Commands.POSITION, id, bounds.placeX(x), bounds.placeY(y));
        if (handles.isStatic(id)) {
            travels.ensure(id, travelling++);
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

    /** Makes what has been prepared, by one operation; {@link Commands#FIELD} also if some changes are of restitutions. */
    void make(int operation) {
        partners = 0;
        boolean holds = world.joints.isThere();
        if (holds && operation == Commands.REMOVE) {
            makeRoomForJoints();
        } else if (holds && (operation == Commands.POSITION || operation == Commands.ANGLE)) {
            for (int k = 0; k < count && world.settings.sleeps(); k++) {
                if (operation == Commands.ANGLE || !handles.isStatic(commands.preparedId(k))) { // else it travels
                    noteHeld(commands.preparedId(k), count);
                }
            }
        }
        if (world.log.isOn()) {
            for (int k = 0; k < count; k++) {
                writeToLog(k);
            }
        }
        if (travelling < count) {
            world.copies.forgetBy(operation);
        } else {
            world.copies.forgetSaved(); // reads give the old places
        }
        boolean turns = Commands.turns(operation);
        world.guard.changing = true;
        if (turns && count > 0) {
            world.needs.askToTurn();
        }
        boolean ofPipelines = turns || operation == Commands.VELOCITY || operation == Commands.IMPULSE;
        commands.admitChanges(ofPipelines ? count : changeAll());
        wakePartners();
        world.guard.changing = false;
    }

    /** Joints go with their circles. */
    private void makeRoomForJoints() {
        world.pending.settleJoints();
        int leavingToo = 0;
        for (int k = 0; k < count; k++) {
            leavingToo += world.joints.departures.countOf(commands.preparedId(k));
        }
        world.joints.departures.ensure(leavingToo);
        if (world.settings.sleeps()) {
            commands.ensure(count + leavingToo);
            makeRoomForPartners(leavingToo);
        }
    }

    private void makeRoomForPartners(int many) {
        if (partner.length < many) {
            partner = Arrays.copyOf(partner, many + (many >> 1));
        }
    }

    /** Takes note of those that joints hold to a circle that is put somewhere else, or turned. Makes room for more commands besides. */
    private void noteHeld(int id, int more) {
        world.pending.settleJoints();
        makeRoomForPartners(partners + world.joints.departures.countOf(id));
        findPartners(id);
        commands.ensure(more + partners);
    }

    /** The same of one circle that no prepared change is of. */
    void beginHeld(int id) {
        partners = 0;
        if (world.settings.sleeps() && world.joints.isThere()) {
            noteHeld(id, 2);
        }
    }

    /** Takes note of those that joints hold to a circle. */
    private void findPartners(int id) {
        JointTable table = world.joints.table;
        for (int place = table.firstOfCircle(id); place >= 0; place = table.nextOfCircle(place)) {
            int joint = JointTable.jointAt(place);
            int other = table.a(joint) == id ? table.b(joint) : table.a(joint);
            if (other != JointRow.NONE) {
                partner[partners++] = other;
            }
        }
    }

    void wakePartners() {
        for (int k = 0; k < partners; k++) {
            if (handles.lives(partner[k])) {
                commands.set(Commands.WAKE, partner[k], 0, 0);
            }
        }
    }

    private void writeToLog(int k) {
        int operation = commands.preparedOperation(k);
        if (operation == Commands.FIELD) {
            int value = commands.preparedValue(k);
            int number = commands.preparedField(k).number();
            world.log.write(Call.FIELD, commands.preparedId(k), number, value, value >> Integer.SIZE - 1);
        } else {
            world.log.writeRecord(
                    operation == Commands.POSITION ? Call.MOVE : Call.of(operation), commands.count() + k);
        }
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

    /** Makes one change likewise. Returns whether a pipeline has to know it too. */
    private boolean change(int k) {
        int id = commands.preparedId(k);
        switch (commands.preparedOperation(k)) {
            case Commands.POSITION -> {
                if (handles.isStatic(id)) {
                    travels.set(id, commands.preparedFirst(k), commands.preparedSecond(k));
                    return false;
                }
            }
            case Commands.REMOVE -> {
                if (world.settings.sleeps()) {
                    findPartners(id);
                }
                world.joints.departures.removeOfCircle(id);
                world.rigids.circleGoes(id);
                handles.remove(id);
            }
            case Commands.RESTITUTION -> handles.setRestitution(id, commands.preparedFirst(k));
            case Commands.FIELD -> handles.setField(commands.preparedField(k), id, commands.preparedValue(k));
            default ->
                throw new IllegalStateException(
                        "no change of the host's is operation " + commands.preparedOperation(k));
        }
        return true;
    }
}
