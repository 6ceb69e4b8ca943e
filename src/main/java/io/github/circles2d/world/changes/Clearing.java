package io.github.circles2d.world.changes;

import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.joints.JointTables;
import io.github.circles2d.world.shared.CallLog;
import io.github.circles2d.world.shared.Copies;
import io.github.circles2d.world.shared.Guard;
import io.github.circles2d.world.shared.LoggedCall;
import io.github.circles2d.world.shared.PendingWork;
import io.github.circles2d.world.shared.WorldState;

/**
 * Removes all circles, and with them all joints. The pipeline loads a state without circles, which takes no command for each. If events are reported, a command for
 * each removes them as any other call does, so that their ends are reported.
 */
public final class Clearing {
    private final Guard guard;
    private final HandleTable handles;
    private final ContactEvents events;
    private final CallLog log;
    private final PendingWork pending;
    private final Copies copies;
    private final JointTables joints;
    private final WorldState state;

    public Clearing(
            Guard guard,
            HandleTable handles,
            ContactEvents events,
            CallLog log,
            PendingWork pending,
            Copies copies,
            JointTables joints,
            WorldState state) {
        this.guard = guard;
        this.handles = handles;
        this.events = events;
        this.log = log;
        this.pending = pending;
        this.copies = copies;
        this.joints = joints;
        this.state = state;
    }

    /** Removes all circles. */
    public void clear() {
        guard.enter();
        try {
            pending.settleJoints();
            joints.departures().ensure(joints.table.ids.size());
            if (events.isOn()) {
                pending.expect(handles.size());
            } else {
                pending.finish();
                state.makeRoomToRemoveCircles();
            }
            copies.forget();
            log.call(LoggedCall.CLEAR, 0, 0);
            guard.changing = true;
            joints.departures().removeOfCircles();
            if (events.isOn()) {
                pending.recordRemovals();
                handles.removeAll();
            } else {
                pending.drop(); // changes that wait are of circles that go, or that the pipeline never learns of
                state.removeCircles();
            }
            state.figures().forget();
            guard.changing = false;
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }
}
