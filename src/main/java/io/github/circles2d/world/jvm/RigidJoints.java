package io.github.circles2d.world.jvm;

import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.JointMath;
import io.github.circles2d.world.model.JointRow;
import io.github.circles2d.world.model.JointStep;
import io.github.circles2d.world.model.StepConstants;
import java.util.Arrays;

/**
 * The passes over joints that hold rigid bodies, one after the other in the order of their ids, before those over the contacts of bodies: so contacts
 * win. {@link RigidJointVisits} has a visit, {@link RigidJointEnds} what is at both ends.
 */
final class RigidJoints {
    // numbers of a joint within a step
    static final int BASE_X = 0; // from the base of A to that of B
    static final int BASE_Y = 1;
    static final int NORMAL_X = 2; // from A to B, as measured last
    static final int NORMAL_Y = 3;
    static final int DISTANCE = 4;
    static final int PUSH = 5; // the greatest speed by which it corrects where its ends are
    private static final int STRIDE = 6;

    private final RigidPartners partners;
    private final RigidJointEnds ends;
    private final RigidJointVisits visits;

    /** Those that act in the step, and {@link #STRIDE} numbers of each. */
    private int[] acting = new int[0];

    private int count;
    private float[] work = new float[0];

    // within a step; null if no joint holds a body
    private JointStep joints;
    private JointStates states;

    RigidJoints(State state, RigidPairs pairs) {
        partners = pairs.partners;
        ends = new RigidJointEnds(state, pairs);
        visits = new RigidJointVisits(ends);
    }

    /** Begins the joints of a step, and finds what does not collide. */
    void findPartners(JointStep step, JointStates itsStates) {
        joints = step;
        states = itsStates;
        count = 0;
        partners.clear();
        if (step == null) {
            return;
        }
        if (acting.length < step.rigidCount) {
            int c = step.rigidCount + (step.rigidCount >> 1);
            work = Arrays.copyOf(work, STRIDE * c);
            acting = Arrays.copyOf(acting, c);
        }
        for (int n = 0; n < step.rigidCount; n++) {
            int joint = step.rigidOrder[n];
            if (itsStates.begin(joint, step)) {
                acting[count++] = joint;
                if ((step.traits[JointRow.traits(joint) + JointRow.FORM] & JointRow.COLLIDE) == 0) {
                    part(joint);
                }
            }
        }
        partners.sort();
    }

    private void part(int joint) {
        int bodyA = joints.rigidBodies[2 * joint];
        int bodyB = joints.rigidBodies[2 * joint + 1];
        int circleA = joints.traits[JointRow.traits(joint) + JointRow.A];
        int circleB = joints.traits[JointRow.traits(joint) + JointRow.B];
        if (bodyA != JointRow.NONE && bodyB != JointRow.NONE) {
            partners.addBodies(bodyA, bodyB);
        } else if (bodyA != JointRow.NONE && circleB != JointRow.NONE) {
            partners.addCircle(bodyA, circleB);
        } else if (bodyB != JointRow.NONE) {
            partners.addCircle(bodyB, circleA);
        }
    }

    /** Measures the joints for the first time; bodies are things. */
    void begin(StepConstants k) {
        if (count == 0) {
            return;
        }
        visits.begin(joints, states, k);
        ends.begin(joints, k);
        for (int n = 0; n < count; n++) {
            int joint = acting[n];
            int e = 2 * n;
            int o = STRIDE * n;
            ends.find(e, joint, 0);
            ends.find(e + 1, joint, 1);
            work[o + BASE_X] = ends.baseX(e, joint);
            work[o + BASE_Y] = ends.baseY(e, joint);
            work[o + NORMAL_X] = 1f;
            work[o + NORMAL_Y] = 0f;
            work[o + DISTANCE] = 0f;
            float size = CircleMath.min(ends.size(e), ends.size(e + 1));
            work[o + PUSH] = size < Float.POSITIVE_INFINITY ? JointMath.greatestPush(size, k.inverseH) : 0f;
            visits.take(joint, e);
            visits.scale();
            visits.measure(0, work, o);
            visits.all(work, o);
            visits.giveNext();
        }
    }

    /** What bodies keep acts again; on circles it has acted before. */
    void warmStart() {
        for (int n = 0; n < count; n++) {
            visits.take(acting[n], 2 * n);
            visits.all(work, STRIDE * n);
            visits.giveToBodies();
        }
    }

    void solve(int sub) {
        for (int n = 0; n < count; n++) {
            visits.take(acting[n], 2 * n);
            visits.measure(sub, work, STRIDE * n);
            visits.solve(sub, work, STRIDE * n);
        }
    }

    void relax(int sub, boolean last) {
        for (int n = 0; n < count; n++) {
            int o = STRIDE * n;
            visits.take(acting[n], 2 * n);
            visits.measure(sub + 1, work, o);
            visits.relax(sub, work, o);
            visits.all(work, o);
            visits.addToSums();
            if (!last) {
                visits.giveNext();
            }
        }
    }

    /** Ends the step: joints break. */
    void end() {
        for (int n = 0; n < count && joints.breakable; n++) {
            visits.take(acting[n], 2 * n);
            if (visits.breaks()) {
                states.breakJoint(acting[n]);
            }
        }
        joints = null;
        states = null;
    }

    long bytes() {
        return ends.bytes() + 4L * (acting.length + work.length);
    }
}
