package io.github.circles2d.world.snapshots;

import io.github.circles2d.world.bodies.SavedRigids;
import io.github.circles2d.world.circles.KindTable;
import io.github.circles2d.world.circles.SavedCircles;
import io.github.circles2d.world.circles.WorldParameters;
import io.github.circles2d.world.events.SavedTouches;
import io.github.circles2d.world.joints.SavedJointStates;
import io.github.circles2d.world.joints.SavedJoints;
import io.github.circles2d.world.terrain.SavedPieceContacts;
import io.github.circles2d.world.terrain.SavedTerrain;

/** A whole state in plain arrays, by id: circles, and what each feature saves. Snapshots are written from it and read into it. */
public final class SavedState extends SavedCircles {
    private WorldParameters parameters;

    public final KindTable kinds = new KindTable();

    /** What events go on from. */
    public final SavedTouches touches = new SavedTouches();

    public final SavedTerrain terrain = new SavedTerrain();

    public final SavedJoints joints = new SavedJoints();

    /** Of {@link #joints}. */
    public final SavedJointStates jointStates = new SavedJointStates();

    public final SavedRigids rigids = new SavedRigids();

    /** Of circles with pieces of terrain. */
    public final SavedPieceContacts pieceContacts = new SavedPieceContacts();

    public WorldParameters parameters() {
        return parameters;
    }

    public void setParameters(WorldParameters p) {
        parameters = p;
    }
}
