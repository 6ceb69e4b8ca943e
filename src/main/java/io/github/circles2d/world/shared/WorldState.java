package io.github.circles2d.world.shared;

import io.github.circles2d.world.bodies.SavedRigids;
import io.github.circles2d.world.joints.SavedJointStates;
import io.github.circles2d.world.joints.SavedJoints;
import io.github.circles2d.world.snapshots.SavedState;
import io.github.circles2d.world.terrain.SavedPieceContacts;

/**
 * The state of a world, which its parts keep: saves it, hashes it, and puts another one in its place. The caller makes all changes that
 * wait, and all steps, before.
 */
public final class WorldState {
    private final WorldParts world;

    // what the hash reads
    private final SavedPieceContacts contacts = new SavedPieceContacts();
    private final SavedJoints savedJoints = new SavedJoints();
    private final SavedJointStates jointStates = new SavedJointStates();
    private final SavedRigids savedRigids = new SavedRigids();

    /** Whether the pipeline's figures are those of the last step. */
    private boolean figuresHold;

    /** A state without circles. */
    private final SavedState empty = new SavedState();

    WorldState(WorldParts world) {
        this.world = world;
    }

    /** A step is to be made: without circles the pipeline makes none, and its figures do not hold. */
    public void stepped(boolean byPipeline) {
        figuresHold = byPipeline;
    }

    /** The pipeline's figures are of circles that are gone. */
    public void forgetFigures() {
        figuresHold = false;
    }

    /** Whether the pipeline's figures are those of the last step, and of this state. */
    public boolean figuresHold() {
        return figuresHold;
    }

    /** Copies it. */
    void save(SavedState into) {
        world.handles.save(into);
        world.pipeline.save(into);
        world.terrain.save(into.terrain);
        savePieceContacts(into.pieceContacts);
        saveJoints(into.joints, into.jointStates);
        world.rigids.save(into.rigids);
        world.events.save(into.touches);
        into.setParameters(world.settings.parameters());
        into.kinds.copy(world.kinds);
    }

    /** Copies what the pipeline holds, for another one: without the changes that wait. */
    void carry(SavedState into) {
        into.setParameters(world.settings.parameters());
        into.setIds(world.handles.end());
        into.fields.copy(world.handles.fields());
        world.pipeline.saveIds(into);
        world.pipeline.save(into);
        into.turns &= world.needs.turns(); // else no circle has turned since there were none
        savePieceContacts(into.pieceContacts);
        saveJointStates(into.jointStates);
        into.jointStates.joints =
                world.joints.table.ids.end(); // a pipeline has room for more, and room for that would be made
    }

    private void savePieceContacts(SavedPieceContacts into) {
        into.clear();
        if (world.terrain.isThere()) {
            world.pipeline.savePieceContacts(into);
            world.terrain.keepPresent(into);
        }
    }

    private void saveJoints(SavedJoints into, SavedJointStates states) {
        world.joints.saves.save(into);
        saveJointStates(states);
    }

    private void saveJointStates(SavedJointStates states) {
        states.begin(0);
        if (world.joints.isThere()) {
            world.pipeline.saveJoints(states);
        }
        world.joints.saves.keepPresent(states);
    }

    long hash() {
        savePieceContacts(contacts);
        saveJoints(savedJoints, jointStates);
        world.rigids.save(savedRigids);
        return world.pipeline.hash()
                + world.handles.fields().hash()
                + world.kinds.hash()
                + world.settings.hash()
                + world.terrain.hash()
                + contacts.hash()
                + savedJoints.hash(jointStates)
                + savedRigids.hash();
    }

    /** Makes room for {@link #load}. If that fails, nothing has changed. */
    public void makeRoom(SavedState saved) {
        world.handles.makeRoom(saved);
        world.terrain.makeRoom(saved.terrain);
        world.joints.makeRoom(saved.joints, saved.ids);
        world.rigids.makeRoom(saved.rigids);
        world.needs.prepare(saved); // first, since the room depends on it
        makePipelineRoom(saved);
        world.events.makeRoom(saved.touches, saved.ids, saved.terrain.pieceIds);
    }

    /** A saved state, for which there is room, takes the place of this one. */
    public void load(SavedState saved) {
        world.handles.load(saved);
        world.kinds.copy(saved.kinds);
        world.terrain.load(saved.terrain, saved.parameters().bounds(), saved.pieceContacts);
        world.joints.load(saved.joints, saved.jointStates);
        world.rigids.load(saved.rigids);
        world.pipeline.load(saved);
        world.settings.set(saved.parameters());
        world.needs.restored(saved);
        forgetFigures();
        world.events.load(saved.touches, world.handles);
    }

    /** Makes room for {@link #removeCircles}. If that fails, nothing has changed. */
    public void makeRoomToRemoveCircles() {
        empty.ids = world.handles.end();
        empty.jointStates.begin(0);
        if (world.joints.table.rigid.count() > 0) {
            saveJointStates(empty.jointStates); // those between bodies stay
        }
        makePipelineRoom(empty);
    }

    private void makePipelineRoom(SavedState saved) {
        try {
            world.pipeline.makeRoom(saved);
        } catch (RuntimeException e) {
            world.moves.goHome(e);
            world.pipeline.makeRoom(saved);
        }
    }

    /** All circles go at once: the pipeline gets a state without circles, which takes no command for each. */
    public void removeCircles() {
        world.handles.removeAll();
        world.pipeline.load(empty);
        world.needs.cleared();
    }
}
