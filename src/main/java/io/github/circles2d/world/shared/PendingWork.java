package io.github.circles2d.world.shared;

import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.joints.BrokenJoints;
import io.github.circles2d.world.joints.SavedJointStates;

/** What is not done yet: changes that wait for the pipeline, and steps that the pipeline makes. */
public final class PendingWork {
    private final WorldParts world;
    private final Commands commands;

    /** Joints that have broken, as the pipeline has told; kept if memory ends before they are away. */
    private final BrokenJoints broken = new BrokenJoints();

    private final SavedJointStates jointStates = new SavedJointStates();

    PendingWork(WorldParts world) {
        this.world = world;
        commands = world.commands;
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
        boolean changes = !world.commands.isEmpty();
        boolean learns = world.events.isOn() && !world.events.knowsPieces();
        if (changes || learns) {
            world.clock.begin();
            finish();
            makeRoom(changes);
            world.guard.changing = true;
            try {
                if (changes) {
                    applyCommands();
                }
                if (learns) {
                    world.events.learnPieces();
                }
            } catch (RuntimeException | Error e) {
                throw world.guard.failed(e);
            }
            world.guard.changing = false;
            world.clock.end();
        }
    }

    /** Makes room for all that {@link #apply} does. If there is none, nothing has changed. */
    private void makeRoom(boolean changes) {
        if (changes) {
            prepareNeeds();
            try {
                world.pipeline.makeRoom(world.commands);
            } catch (RuntimeException e) {
                world.moves.goHome(e);
                world.pipeline.makeRoom(world.commands);
            }
        }
        if (world.events.isOn()) {
            world.events.makeRoom(world.commands);
        }
    }

    private void applyCommands() {
        if (world.events.isOn()) {
            world.events.apply(world.commands, world.handles);
        }
        world.pipeline.apply(world.commands);
        drop();
    }

    /** Makes the pipeline ready for the features that the world has begun to need. */
    public void prepareNeeds() {
        if (world.needs.begins()) {
            finish();
            world.needs.prepare();
        }
    }

    /** Drops the changes that wait. */
    public void drop() {
        world.commands.clear();
    }

    /** Records that each circle goes, for which there is room. */
    public void recordRemovals() {
        for (int id = 0; id < world.handles.end(); id++) {
            if (world.handles.lives(id)) {
                world.commands.set(Commands.REMOVE, id, 0, 0);
            }
        }
    }

    /** Waits for all steps, and is told if one has failed. Joints that have broken go. */
    public void finish() {
        world.clock.begin();
        world.guard.changing = true;
        try {
            world.pipeline.finish();
        } catch (RuntimeException | Error e) {
            throw world.guard.failed(e);
        }
        world.guard.changing = false;
        takeBroken();
        world.clock.end();
    }

    /** All these steps are of one length if a joint may break. */
    private void takeBroken() {
        if (broken.count == 0 && world.joints.table.breaks()) {
            world.pipeline.takeBroken(broken);
        }
        if (broken.count > 0) {
            takeAwayBroken();
        }
    }

    private void takeAwayBroken() {
        boolean reports = world.joints.departures.reports();
        if (reports) {
            world.pipeline.saveJoints(jointStates);
            world.joints.departures.ensure(broken.count);
        }
        world.guard.changing = true;
        for (int k = 0; k < broken.count; k++) {
            int joint = broken.id(k);
            float force = reports ? jointStates.force(joint, world.settings.lastStep()) : 0f;
            float torque = reports ? jointStates.torque(joint, world.settings.lastStep()) : 0f;
            world.joints.departures.breakJoint(joint, force, torque);
        }
        broken.count = 0;
        world.guard.changing = false;
    }

    /** Another state has taken the place of all that was, and of all changes that wait. */
    public void restored() {
        drop();
        broken.count = 0;
    }

    /** Makes the state what calls have led to, so that reading it changes nothing. */
    public void settle() {
        apply();
        finish();
    }

    /** Makes joints what steps have led to, if any may have broken: before a call that looks at joints or changes them. */
    public void settleJoints() {
        if (world.joints.table.breaks()) {
            finish();
        }
    }
}
