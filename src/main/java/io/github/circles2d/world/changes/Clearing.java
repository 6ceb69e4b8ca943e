package io.github.circles2d.world.changes;

import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.circles.SavedState;
import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.joints.JointTables;
import io.github.circles2d.world.shared.CallLog;
import io.github.circles2d.world.shared.Copies;
import io.github.circles2d.world.shared.Guard;
import io.github.circles2d.world.shared.LoggedCall;
import io.github.circles2d.world.shared.Needs;
import io.github.circles2d.world.shared.PendingWork;
import io.github.circles2d.world.shared.Pipeline;
import io.github.circles2d.world.shared.StepFigures;

/**
 * Removes all circles, and with them all joints. The pipeline loads a state without circles, which takes no command for each. If events are reported, a command for
 * each removes them as any other call does, so that their ends are reported.
 */
public final class Clearing {
    // The functions of the calls. They are linked before memory, or the stack, may end in a call.
    private static final Guard.Change<Clearing> CLEAR = Clearing::removeAll;

    private final Pipeline pipeline;
    private final Guard guard;
    private final HandleTable handles;
    private final Commands commands;
    private final ContactEvents events;
    private final CallLog log;
    private final PendingWork pending;
    private final Copies copies;
    private final StepFigures figures;
    private final JointTables joints;
    private final Needs needs;

    /** A state without circles. */
    private final SavedState empty = new SavedState();

    public Clearing(
            Pipeline pipeline,
            Guard guard,
            HandleTable handles,
            Commands commands,
            ContactEvents events,
            CallLog log,
            PendingWork pending,
            Copies copies,
            StepFigures figures,
            JointTables joints,
            Needs needs) {
        this.pipeline = pipeline;
        this.guard = guard;
        this.handles = handles;
        this.commands = commands;
        this.events = events;
        this.log = log;
        this.pending = pending;
        this.copies = copies;
        this.figures = figures;
        this.joints = joints;
        this.needs = needs;
    }

    /** Removes all circles. */
    public void clear() {
        guard.change(this, CLEAR);
    }

    private void removeAll() {
        pending.settleJoints();
        joints.departures().ensure(joints.table.ids.size());
        if (events.isOn()) {
            pending.expect(handles.size());
        } else {
            pending.finish();
            empty.ids = handles.end();
            pipeline.makeRoom(empty);
        }
        copies.forget();
        log.call(LoggedCall.CLEAR, 0, 0);
        guard.changing = true;
        joints.departures().removeOfCircles();
        if (events.isOn()) {
            removeEach();
        } else {
            removeAtOnce();
        }
        figures.forget();
        guard.changing = false;
    }

    /** Records the removals, which wait as those of any call; the log has the call in their place. */
    private void removeEach() {
        for (int id = 0; id < handles.end(); id++) {
            if (handles.lives(id)) {
                commands.set(Commands.REMOVE, id, 0, 0);
            }
        }
        log.skipCommands();
        handles.removeAll();
    }

    /** Changes that wait are of circles that go, or that the pipeline never learns of. */
    private void removeAtOnce() {
        pending.drop();
        handles.removeAll();
        pipeline.load(empty);
        needs.cleared();
    }
}
