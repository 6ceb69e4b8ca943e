package io.github.circles2d.world.joints;

import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.JointState;

/** How hard joints push and pull in a step of a length: from the sums of their impulses. Forces are those on the first circle. */
public final class JointLoads {
    private JointLoads() {}

    public static float forceX(SavedJointStates states, int joint, float dt) {
        return rate(-1f * states.rows[JointState.of(joint) + JointState.SUM_X], dt);
    }

    public static float forceY(SavedJointStates states, int joint, float dt) {
        return rate(-1f * states.rows[JointState.of(joint) + JointState.SUM_Y], dt);
    }

    /** Not negative. */
    public static float force(SavedJointStates states, int joint, float dt) {
        return CircleMath.length(forceX(states, joint, dt), forceY(states, joint, dt));
    }

    public static float torque(SavedJointStates states, int joint, float dt) {
        return rate(states.rows[JointState.of(joint) + JointState.SUM_ANGULAR], dt);
    }

    /** There is one zero; 0 before the first step, also in a world that was restored to then. */
    private static float rate(float sum, float dt) {
        return dt > 0f ? sum / dt + 0f : 0f;
    }
}
