package io.github.circles2d.world.shared;

import io.github.circles2d.world.circles.BrokenJoints;
import io.github.circles2d.world.circles.SavedJointStates;
import io.github.circles2d.world.joints.JointLoads;
import io.github.circles2d.world.joints.JointTables;

/** Takes joints away that have broken in the steps that have been made. All these steps are of one length if a joint may break. */
public final class Breaking {
    private final Pipeline pipeline;
    private final Guard guard;
    private final JointTables joints;
    private final WorldSettings settings;

    /** Those of which the pipeline has told; kept if memory ends before they are away. */
    private final BrokenJoints broken = new BrokenJoints();

    private final SavedJointStates states = new SavedJointStates();

    public Breaking(Pipeline pipeline, Guard guard, JointTables joints, WorldSettings settings) {
        this.pipeline = pipeline;
        this.guard = guard;
        this.joints = joints;
        this.settings = settings;
    }

    /** Whether a joint may have broken in steps. */
    boolean mayHappen() {
        return joints.table.breaks();
    }

    /** All steps have been made. */
    void take() {
        if (broken.count == 0 && mayHappen()) {
            pipeline.takeBroken(broken);
        }
        if (broken.count > 0) {
            takeAway();
        }
    }

    private void takeAway() {
        boolean reports = joints.departures().reports();
        if (reports) {
            pipeline.saveJoints(states);
            joints.departures().ensure(broken.count);
        }
        guard.changing = true;
        for (int k = 0; k < broken.count; k++) {
            int joint = broken.id(k);
            float force = reports ? JointLoads.force(states, joint, settings.lastStep()) : 0f;
            float torque = reports ? JointLoads.torque(states, joint, settings.lastStep()) : 0f;
            joints.departures().breakJoint(joint, force, torque);
        }
        broken.count = 0;
        guard.changing = false;
    }

    /** Another state has taken the place of all that was. */
    void forget() {
        broken.count = 0;
    }
}
