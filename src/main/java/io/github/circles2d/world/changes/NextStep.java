package io.github.circles2d.world.changes;

import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.shared.WorldParts;
import io.github.circles2d.world.snapshots.SavedState;

/**
 * What calls have asked of circles in the next step alone: forces that act once, static circles that travel, and circles that grow. The
 * step itself knows nothing of this: commands before it and after it make such a step.
 */
public final class NextStep {
    private final WorldParts world;
    final Forces forces;
    final Travels travels;
    final Growth growth;

    /** Commands that waited before those of the step. */
    private int before;

    public NextStep(WorldParts world, Forces forces, Travels travels, Growth growth) {
        this.world = world;
        this.forces = forces;
        this.travels = travels;
        this.growth = growth;
    }

    /** Whether it is a step as any other. */
    public boolean isEmpty() {
        return forces.isEmpty() && travels.isEmpty() && growth.isEmpty();
    }

    /** Refuses bounds in which a circle has no room at the end of its growth. */
    public void requireRoom(Bounds bounds) {
        growth.requireRoom(bounds);
    }

    /** Brings what circles travel to inside new bounds. */
    public void confine(Bounds bounds) {
        travels.confine(bounds);
    }

    /** Makes room for {@link #begin}. If there is none, nothing has changed. */
    public void makeRoom() {
        world.commands.ensure(forces.most() + growth.count() + travels.count());
        growth.makeRoom();
        travels.makeRoom();
    }

    /** Before the step. */
    public void begin(float timeStep, Bounds bounds) {
        before = world.commands.count();
        forces.begin();
        growth.begin();
        travels.depart(timeStep, bounds);
    }

    /** What a pipeline has of the step alone, for another one. */
    public void carry(SavedState into) {
        forces.carry(into.fields);
    }

    /** The step has not begun for want of memory: all is as before {@link #begin}, and its commands are taken back. */
    public void undo() {
        world.commands.drop(world.commands.count() - before);
        forces.undo();
        travels.stay();
        growth.undo();
    }

    /** After the step. */
    public void end() {
        growth.end();
        travels.arrive();
        forces.end();
    }

    /** Makes room for what is asked in a saved state. */
    public void makeRoom(SavedState from) {
        forces.makeRoom(from);
        travels.makeRoom(from);
        growth.makeRoom(from);
    }

    /** A saved state, for which there is room, has taken the place of all that was. */
    public void restored(SavedState from) {
        forces.restored(from);
        travels.restored();
        growth.restored();
    }
}
