package io.github.circles2d.world.joints;

import io.github.circles2d.world.bodies.RigidPoses;
import io.github.circles2d.world.terrain.BodyPoses;
import java.nio.FloatBuffer;

/** Where circles and bodies are drawn, which is between two steps. */
public final class DrawnPlaces {
    final BodyPoses before;
    final BodyPoses after;
    final BodyPoses between;
    final RigidPoses rigidsBefore;
    final RigidPoses rigidsAfter;

    /** x and y by id; NaN, or nothing, of a circle that is new. */
    FloatBuffer positions;

    float alpha;

    /** Takes the poses of bodies of terrain before a step and after it, and memory for those between them; and poses of bodies that are pushed. */
    public DrawnPlaces(
            BodyPoses before, BodyPoses after, BodyPoses between, RigidPoses rigidsBefore, RigidPoses rigidsAfter) {
        this.before = before;
        this.after = after;
        this.between = between;
        this.rigidsBefore = rigidsBefore;
        this.rigidsAfter = rigidsAfter;
    }

    /** Takes x and y of circles by id, and how far bodies are on their way, 0 to 1. */
    public DrawnPlaces at(FloatBuffer xy, float part) {
        positions = xy;
        alpha = part;
        return this;
    }
}
