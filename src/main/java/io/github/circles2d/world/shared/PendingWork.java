package io.github.circles2d.world.shared;

import io.github.circles2d.world.circles.Commands;

/** What is not done yet: changes that wait for the pipeline, and steps that the pipeline makes. */
public final class PendingWork {
    private final WorldParts world;
    private final Commands commands;

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
        boolean changes = world.commands.count() > 0;
        boolean learns = world.events.isOn() && !world.events.knowsPieces();
        if (changes || learns) {
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
        }
    }

    /** Makes room for all that {@link #apply} does. If there is none, nothing has changed. */
    private void makeRoom(boolean changes) {
        if (changes) {
            prepareNeeds();
            world.pipeline.makeRoom(world.commands);
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

    /** Makes the pipeline ready for circles that turn, for terrain or for joints, if the world has begun to need that. */
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
        world.guard.changing = true;
        try {
            world.pipeline.finish();
        } catch (RuntimeException | Error e) {
            throw world.guard.failed(e);
        }
        world.guard.changing = false;
        world.breaking.take();
    }

    /** Another state has taken the place of all that was, and of all changes that wait. */
    public void restored() {
        drop();
        world.breaking.forget();
    }

    /** Makes the state what calls have led to, so that reading it changes nothing. */
    public void settle() {
        apply();
        finish();
    }

    /** Makes joints what steps have led to, if any may have broken: before a call that looks at joints or changes them. */
    public void settleJoints() {
        if (world.breaking.mayHappen()) {
            finish();
        }
    }
}
