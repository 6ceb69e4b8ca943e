package io.github.circles2d.world.shared;

import io.github.circles2d.world.joints.BrokenJoints;
import io.github.circles2d.world.joints.JointLoads;
import io.github.circles2d.world.joints.SavedJointStates;

/** Takes joints away that have broken in the steps that have been made. All these steps are of one length if a joint may break. */
public final class Breaking {
    private final WorldParts world;

    /** Those of which the pipeline has told; kept if memory ends before they are away. */
    private final BrokenJoints broken = new BrokenJoints();

    private final SavedJointStates states = new SavedJointStates();

    Breaking(WorldParts world) {
        this.world = world;
    }

    /** Whether a joint may have broken in steps. */
    boolean mayHappen() {
        return world.joints.table.breaks();
    }

    /** All steps have been made. */
    void take() {
        if (broken.count == 0 && mayHappen()) {
            world.pipeline.takeBroken(broken);
        }
        if (broken.count > 0) {
            takeAway();
        }
    }

    private void takeAway() {
        boolean reports = world.joints.departures().reports();
        if (reports) {
            world.pipeline.saveJoints(states);
            world.joints.departures().ensure(broken.count);
        }
        world.guard.changing = true;
        for (int k = 0; k < broken.count; k++) {
            int joint = broken.id(k);
            float force = reports ? JointLoads.force(states, joint, world.settings.lastStep()) : 0f;
            float torque = reports ? JointLoads.torque(states, joint, world.settings.lastStep()) : 0f;
            world.joints.departures().breakJoint(joint, force, torque);
        }
        broken.count = 0;
        world.guard.changing = false;
    }

    /** Another state has taken the place of all that was. */
    void forget() {
        broken.count = 0;
    }
}
