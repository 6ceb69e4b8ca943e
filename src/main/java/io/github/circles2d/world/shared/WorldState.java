package io.github.circles2d.world.shared;

import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.circles.KindTable;
import io.github.circles2d.world.circles.SavedJointStates;
import io.github.circles2d.world.circles.SavedJoints;
import io.github.circles2d.world.circles.SavedPieceContacts;
import io.github.circles2d.world.circles.SavedState;
import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.joints.JointTables;
import io.github.circles2d.world.terrain.TerrainTables;

/**
 * The state of a world, which its parts keep: saves it, hashes it, and puts another one in its place. The caller makes all changes that
 * wait, and all steps, before.
 */
public final class WorldState {
    private final Pipeline pipeline;
    private final HandleTable handles;
    private final KindTable kinds;
    private final ContactEvents events;
    private final WorldSettings settings;
    private final TerrainTables terrain;
    private final JointTables joints;
    private final Needs needs;
    private final StepFigures figures = new StepFigures();

    // what the hash reads
    private final SavedPieceContacts contacts = new SavedPieceContacts();
    private final SavedJoints savedJoints = new SavedJoints();
    private final SavedJointStates jointStates = new SavedJointStates();

    /** A state without circles. */
    private final SavedState empty = new SavedState();

    public WorldState(
            Pipeline pipeline,
            HandleTable handles,
            KindTable kinds,
            ContactEvents events,
            WorldSettings settings,
            TerrainTables terrain,
            JointTables joints,
            Needs needs) {
        this.pipeline = pipeline;
        this.handles = handles;
        this.kinds = kinds;
        this.events = events;
        this.settings = settings;
        this.terrain = terrain;
        this.joints = joints;
        this.needs = needs;
    }

    /** Whether the pipeline's figures are those of this state. */
    public StepFigures figures() {
        return figures;
    }

    /** Copies it. */
    void save(SavedState into) {
        handles.save(into);
        pipeline.save(into);
        terrain.save(into.terrain);
        savePieceContacts(into.pieceContacts);
        saveJoints(into.joints, into.jointStates);
        events.save(into.touches);
        into.setParameters(settings.parameters());
        into.kinds.copy(kinds);
    }

    private void savePieceContacts(SavedPieceContacts into) {
        into.clear();
        if (terrain.isThere()) {
            pipeline.savePieceContacts(into);
            terrain.keepPresent(into);
        }
    }

    private void saveJoints(SavedJoints into, SavedJointStates states) {
        joints.saves.save(into);
        states.begin(0);
        if (joints.isThere()) {
            pipeline.saveJoints(states);
        }
        joints.saves.keepPresent(states);
    }

    long hash() {
        savePieceContacts(contacts);
        saveJoints(savedJoints, jointStates);
        return pipeline.hash()
                + handles.fields().hash()
                + kinds.hash()
                + settings.hash()
                + terrain.hash()
                + contacts.hash()
                + savedJoints.hash(jointStates);
    }

    /** Makes room for {@link #load}. If that fails, nothing has changed. */
    public void makeRoom(SavedState saved) {
        handles.makeRoom(saved);
        terrain.makeRoom(saved.terrain);
        joints.makeRoom(saved);
        needs.prepare(saved); // first, since the room depends on it
        pipeline.makeRoom(saved);
        events.makeRoom(saved.touches, saved.ids, saved.terrain.pieceIds);
    }

    /** A saved state, for which there is room, takes the place of this one. */
    public void load(SavedState saved) {
        handles.load(saved);
        kinds.copy(saved.kinds);
        terrain.load(saved.terrain, saved.parameters().bounds(), saved.pieceContacts);
        joints.load(saved);
        pipeline.load(saved);
        settings.set(saved.parameters());
        needs.restored(saved);
        figures.forget();
        events.load(saved.touches, handles);
    }

    /** Makes room for {@link #removeCircles}. If that fails, nothing has changed. */
    public void makeRoomToRemoveCircles() {
        empty.ids = handles.end();
        pipeline.makeRoom(empty);
    }

    /** All circles go at once: the pipeline gets a state without circles, which takes no command for each. */
    public void removeCircles() {
        handles.removeAll();
        pipeline.load(empty);
        needs.cleared();
    }
}
