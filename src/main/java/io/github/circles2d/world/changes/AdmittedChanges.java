package io.github.circles2d.world.changes;

import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.joints.JointTables;
import io.github.circles2d.world.shared.CallLog;
import io.github.circles2d.world.shared.Copies;
import io.github.circles2d.world.shared.Guard;
import io.github.circles2d.world.shared.Needs;

/** Makes what {@link PreparedChanges} has checked and prepared: records it in {@link Commands}, and changes what the host knows. */
public final class AdmittedChanges {
    private final Guard guard;
    private final HandleTable handles;
    private final Commands commands;
    private final CallLog log;
    private final Copies copies;
    private final Travels travelling;
    private final JointTables joints;
    private final Needs needs;

    public AdmittedChanges(
            Guard guard,
            HandleTable handles,
            Commands commands,
            CallLog log,
            Copies copies,
            Travels travelling,
            JointTables joints,
            Needs needs) {
        this.guard = guard;
        this.handles = handles;
        this.commands = commands;
        this.log = log;
        this.copies = copies;
        this.travelling = travelling;
        this.joints = joints;
        this.needs = needs;
    }

    /** Makes so many changes, some of which are travels. Reads are forgotten by the operation. */
    void make(int operation, int count, int travels) {
        if (travels < count) {
            copies.forgetBy(operation);
        } else {
            copies.forgetSaved(); // reads give the old places
        }
        if (travels > 0) {
            recordTravels(count);
        }
        boolean turns = Commands.turns(operation);
        boolean ofPipelines = turns || operation == Commands.VELOCITY || operation == Commands.IMPULSE;
        guard.changing = true;
        if (turns && count > 0) {
            needs.askToTurn();
        }
        commands.admitChanges(ofPipelines ? count : changeAll(count));
        guard.changing = false;
    }

    /** Changes what the host knows. Returns how many changes a pipeline has to know too; these come first then. */
    private int changeAll(int count) {
        int recorded = 0;
        for (int k = 0; k < count; k++) {
            if (change(k)) {
                commands.advancePrepared(k, recorded++);
            }
        }
        return recorded;
    }

    private void recordTravels(int count) {
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
