package io.github.circles2d.world.shared;

import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.events.ContactEvents;

/** What is not done yet: changes that wait for the pipeline, and steps that the pipeline makes. */
public final class PendingWork {
    private final Pipeline pipeline;
    private final Guard guard;
    private final HandleTable handles;
    private final Commands commands;
    private final ContactEvents events;
    private final CallLog log;
    private final Breaking breaking;
    private final Needs needs;

    public PendingWork(
            Pipeline pipeline,
            Guard guard,
            HandleTable handles,
            Commands commands,
            ContactEvents events,
            CallLog log,
            Breaking breaking,
            Needs needs) {
        this.pipeline = pipeline;
        this.guard = guard;
        this.handles = handles;
        this.commands = commands;
        this.events = events;
        this.log = log;
        this.breaking = breaking;
        this.needs = needs;
    }

    /** Makes room for changes to come, so that none fails half-way. */
    public void expect(int more) {
        if (commands.count() >= Commands.MANY) {
            apply();
        }
        commands.ensure(more);
    }

    /** Hands the changes that wait to the pipeline. */
    public void apply() {
        boolean changes = commands.count() > 0;
        boolean learns = events.isOn() && !events.knowsPieces();
        if (changes || learns) {
            log.writeCommands();
            finish();
            makeRoom(changes);
            guard.changing = true;
            if (changes) {
                applyCommands();
            }
            if (learns) {
                events.learnPieces();
            }
            guard.changing = false;
        }
    }

    /** Makes room for all that {@link #apply} does. If there is none, nothing has changed. */
    private void makeRoom(boolean changes) {
        if (changes) {
            prepareNeeds();
            pipeline.makeRoom(commands);
        }
        if (events.isOn()) {
            events.makeRoom(commands);
        }
    }

    private void applyCommands() {
        if (events.isOn()) {
            events.apply(commands, handles);
        }
        pipeline.apply(commands);
        drop();
    }

    /** Makes the pipeline ready for circles that turn, for terrain or for joints, if the world has begun to need that. */
    public void prepareNeeds() {
        if (needs.begins()) {
            finish();
            needs.prepare();
        }
    }

    /** Drops the changes that wait. */
    public void drop() {
        commands.clear();
        log.logged = 0;
    }

    /** Records that each circle goes, for which there is room. The log has the call in place of the records. */
    public void recordRemovals() {
        for (int id = 0; id < handles.end(); id++) {
            if (handles.lives(id)) {
                commands.set(Commands.REMOVE, id, 0, 0);
            }
        }
        log.skipCommands();
    }

    /** Waits for all steps, and is told if one has failed. Joints that have broken go. */
    public void finish() {
        guard.changing = true;
        pipeline.finish();
        guard.changing = false;
        breaking.take();
    }

    /** Another state has taken the place of all that was, and of all changes that wait. */
    public void restored() {
        drop();
        breaking.forget();
    }

    /** Makes the state what calls have led to, so that reading it changes nothing. */
    public void settle() {
        apply();
        finish();
    }

    /** Makes joints what steps have led to, if any may have broken: before a call that looks at joints or changes them. */
    public void settleJoints() {
        if (breaking.mayHappen()) {
            finish();
        }
    }

    /** Waits for the events of all steps so far. */
    public void finishEvents() {
        guard.changing = true;
        pipeline.finishEvents();
        guard.changing = false;
    }

    /** Asks for the events of all steps so far. */
    public void requestEvents() {
        guard.changing = true;
        pipeline.requestEvents();
        guard.changing = false;
    }

    public void finishRequestedEvents() {
        guard.changing = true;
        pipeline.finishRequestedEvents();
        guard.changing = false;
    }
}
