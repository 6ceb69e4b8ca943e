package io.github.circles2d.world.bodies;

import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.Rotation;

/** Where points of rigid bodies are in the world, and the other way round. The last one that was looked at is kept. */
public final class RigidPlaces {
    private final RigidStep step;
    private final RigidTable table;
    private final RigidPoses.Pose pose = new RigidPoses.Pose();

    private float x;
    private float y;

    RigidPlaces(RigidTable table) {
        this.table = table;
        step = table.step;
    }

    public float x() {
        return x;
    }

    public float y() {
        return y;
    }

    /** Looks at a point of a body, in the body's coordinates, as it is now in the world. */
    public void of(int body, float localX, float localY, Bounds bounds) {
        turn(step.angle[body], localX, localY);
        x = bounds.placeX(step.x[body] + x);
        y = bounds.placeY(step.y[body] + y);
    }

    /** The same as the body is drawn on the way from before a step to after it. */
    public void of(
            RigidPoses before, RigidPoses after, float alpha, int body, float localX, float localY, Bounds bounds) {
        RigidPoses.between(before, after, alpha, table, body, bounds, pose);
        turn(pose.angle, localX, localY);
        x = bounds.placeX(pose.x + x);
        y = bounds.placeY(pose.y + y);
    }

    /** Looks at a place of the world in the coordinates of a body, the short way from its centroid. */
    public void look(int body, float worldX, float worldY, Bounds bounds) {
        turn(
                -step.angle[body],
                CircleMath.shortWay(bounds.placeX(worldX) - step.x[body], bounds.periodX()),
                CircleMath.shortWay(bounds.placeY(worldY) - step.y[body], bounds.periodY()));
    }

    private void turn(int units, float fromX, float fromY) {
        double cos = Rotation.cos(units);
        double sin = Rotation.sin(units);
        x = (float) (cos * fromX - sin * fromY);
        y = (float) (sin * fromX + cos * fromY);
    }
}
