package io.github.circles2d.world.joints;

import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.model.JointRow;
import io.github.circles2d.world.terrain.TerrainTables;

/** Where the two ends of a joint are drawn: with their circles and bodies of terrain. A circle that is new is where it is now. */
public final class DrawnJointEnds extends JointEnds {
    private final JointTables joints;
    private final TerrainTables terrain;
    private DrawnPlaces drawn;

    DrawnJointEnds(JointTables joints, HandleTable handles, TerrainTables terrain) {
        super(joints, handles, terrain);
        this.joints = joints;
        this.terrain = terrain;
    }

    /** Takes where circles and bodies are drawn. */
    public DrawnJointEnds look(DrawnPlaces places) {
        drawn = places;
        if (joints.table.places.count() > 0) {
            drawn.between.keepBetween(drawn.before, drawn.after, drawn.alpha, terrain.bodies, terrain.bounds());
        }
        return this;
    }

    /** Whether circles as of now are needed for a joint. */
    public boolean hasNewCircle(int joint) {
        int other = joints.table.b(joint);
        return isNew(joints.table.a(joint)) || other != JointRow.NONE && isNew(other);
    }

    private boolean isNew(int circle) {
        return 2 * circle >= drawn.positions.limit() || Float.isNaN(drawn.positions.get(2 * circle));
    }

    @Override
    float circleX(int circle) {
        return isNew(circle) ? super.circleX(circle) : drawn.positions.get(2 * circle);
    }

    @Override
    float circleY(int circle) {
        return isNew(circle) ? super.circleY(circle) : drawn.positions.get(2 * circle + 1);
    }

    @Override
    float anchorX(int joint) {
        return joints.anchorX(joint, drawn.between);
    }

    @Override
    float anchorY(int joint) {
        return joints.anchorY(joint, drawn.between);
    }
}
