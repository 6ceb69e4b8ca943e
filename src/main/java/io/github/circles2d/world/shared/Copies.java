package io.github.circles2d.world.shared;

import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.circles.KindTable;
import io.github.circles2d.world.circles.SavedJointStates;
import io.github.circles2d.world.circles.SavedJoints;
import io.github.circles2d.world.circles.SavedPieceContacts;
import io.github.circles2d.world.circles.SavedState;
import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.joints.JointTables;
import io.github.circles2d.world.terrain.TerrainTables;

/** The copies of the state that hold until it changes: the last bulk reading, and the saved state. Also its hash. */
public final class Copies {
    private final Pipeline pipeline;
    private final PendingWork pending;
    private final HandleTable handles;
    private final KindTable kinds;
    private final ContactEvents events;
    private final WorldSettings settings;
    private final TerrainTables terrain;
    private final JointTables joints;
    private final LastReading last;
    private final SavedState saved = new SavedState();
    private final SavedPieceContacts contacts = new SavedPieceContacts();
    private final SavedJoints savedJoints = new SavedJoints();
    private final SavedJointStates jointStates = new SavedJointStates();

    /** Whether {@link #saved} is the state as it is now. */
    private boolean savedCurrent;

    public Copies(
            Pipeline pipeline,
            PendingWork pending,
            HandleTable handles,
            KindTable kinds,
            ContactEvents events,
            WorldSettings settings,
            TerrainTables terrain,
            JointTables joints,
            Needs needs) {
        this.pipeline = pipeline;
        this.pending = pending;
        this.handles = handles;
        this.kinds = kinds;
        this.events = events;
        this.settings = settings;
        this.terrain = terrain;
        this.joints = joints;
        last = new LastReading(pipeline, handles, pending, needs);
    }

    public LastReading last() {
        return last;
    }

    /** Circles have changed, and all that was read or saved of them is out of date. */
    public void forget() {
        last.forgetCircles();
        last.forgetVelocities();
        last.forgetTurns();
        last.forgetJoints();
        savedCurrent = false;
    }

    /** Something has changed that no read has. */
    public void forgetSaved() {
        savedCurrent = false;
    }

    /** An operation of {@link Commands} makes what was read or saved out of date. */
    public void forgetBy(int operation) {
        switch (operation) {
            case Commands.VELOCITY, Commands.IMPULSE -> last.forgetVelocities();
            case Commands.ANGLE, Commands.ANGULAR_VELOCITY, Commands.ANGULAR_IMPULSE -> last.forgetTurns();
            case Commands.REMOVE -> forget();
            case Commands.RESTITUTION, Commands.FIELD -> {
                // no read has them
            }
            default -> last.forgetCircles();
        }
        savedCurrent = false;
    }

    /** The state as of now; valid until the next change. */
    public SavedState saved() {
        if (!savedCurrent) {
            pending.settle();
            handles.save(saved);
            pipeline.save(saved);
            saveTerrain();
            saveJoints(saved.joints, saved.jointStates);
            events.save(saved.touches);
            saved.setParameters(settings.parameters());
            saved.kinds.copy(kinds);
            savedCurrent = true;
        }
        return saved;
    }

    private void saveTerrain() {
        terrain.save(saved.terrain);
        savePieceContacts(saved.pieceContacts);
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

    /** The same object, which the caller fills with another state: it is none of now. */
    public SavedState other() {
        savedCurrent = false;
        return saved;
    }

    /** The hash of the state as of now. */
    public long hash() {
        pending.settle();
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
}
