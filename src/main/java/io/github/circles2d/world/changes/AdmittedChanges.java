package io.github.circles2d.world.changes;

import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.shared.Call;
import io.github.circles2d.world.shared.WorldParts;

/** Makes what {@link PreparedChanges} has checked and prepared: records it in {@link Commands}, and changes what the host knows. */
public final class AdmittedChanges {
    private final WorldParts world;
    private final Travels travelling;

    public AdmittedChanges(WorldParts world, Travels travelling) {
        this.world = world;
        this.travelling = travelling;
    }

    /** Makes so many changes, some of which are travels. Reads are forgotten by the operation. */
    void make(int operation, int count, int travels) {
        if (travels < count) {
            world.copies.forgetBy(operation);
        } else {
            world.copies.forgetSaved(); // reads give the old places
        }
        for (int k = 0; k < count; k++) {
            writeToLog(k);
        }
        boolean turns = Commands.turns(operation);
        boolean ofPipelines = turns || operation == Commands.VELOCITY || operation == Commands.IMPULSE;
        world.guard.changing = true;
        if (turns && count > 0) {
            world.needs.askToTurn();
        }
        world.commands.admitChanges(ofPipelines ? count : changeAll(count));
        world.guard.changing = false;
    }

    /** Changes what the host knows. Returns how many changes a pipeline has to know too; these come first then. */
    private int changeAll(int count) {
        int recorded = 0;
        for (int k = 0; k < count; k++) {
            if (change(k)) {
                world.commands.advancePrepared(k, recorded++);
            }
        }
        return recorded;
    }

    private void writeToLog(int k) {
        int operation = world.commands.preparedOperation(k);
        if (operation == Commands.FIELD) {
            world.log.writeField(
                    world.commands.preparedField(k), world.commands.preparedId(k), world.commands.preparedValue(k));
        } else {
            world.log.writeRecord(isTravel(k) ? Call.TRAVEL : Call.of(operation), world.commands.count() + k);
        }
    }

    private boolean isTravel(int k) {
        return world.commands.preparedOperation(k) == Commands.POSITION
                && world.handles.isStatic(world.commands.preparedId(k));
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
