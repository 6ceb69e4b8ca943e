package io.github.circles2d.world.jvm.bodies;

import io.github.circles2d.world.bodies.RigidStep;
import io.github.circles2d.world.jvm.state.JointStates;
import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.JointRow;
import io.github.circles2d.world.model.JointState;
import io.github.circles2d.world.model.JointStep;
import io.github.circles2d.world.model.Sleep;
import io.github.circles2d.world.model.StepConstants;
import java.util.Arrays;

/**
 * The passes over joints that hold rigid bodies, one after the other in the order of their ids, before those over the contacts of bodies: so contacts
 * win. {@link RigidJoint} has a visit.
 */
final class RigidJoints {
    private final State state;
    private final RigidPairs pairs;
    private final RigidThings things;

    /** Those that act in the step. */
    private RigidJoint[] acting = {};

    private int count;

    // within a step; null if no joint holds a body
    private RigidStep rigids;
    private JointStep joints;
    private JointStates states;
    private StepConstants k;

    RigidJoints(State state, RigidPairs pairs) {
        this.state = state;
        this.pairs = pairs;
        things = pairs.things;
    }

    /** Begins the joints of a step, and finds what does not collide. */
    void findPartners(RigidStep bodies, JointStep step, JointStates itsStates) {
        rigids = bodies;
        joints = step;
        states = itsStates;
        count = 0;
        RigidKeys ofBodies = pairs.partners[RigidStep.BODY_BODY];
        RigidKeys ofCircles = pairs.partners[RigidStep.BODY_CIRCLE];
        ofBodies.count = 0;
        ofCircles.count = 0;
        if (step == null) {
            return;
        }
        if (acting.length < step.rigidCount) {
            int before = acting.length;
            RigidJoint[] grown = Arrays.copyOf(acting, step.rigidCount + (step.rigidCount >> 1));
            for (int n = before; n < grown.length; n++) {
                grown[n] = new RigidJoint(state, pairs);
            }
            acting = grown;
        }
        for (int n = 0; n < step.rigidCount; n++) {
            int joint = step.rigidOrder[n];
            if (itsStates.begin(joint, step) && !rests(joint)) {
                acting[count++].id = joint;
                if ((step.traits[JointRow.traits(joint) + JointRow.FORM] & JointRow.COLLIDE) == 0) {
                    part(joint);
                }
            }
        }
        ofBodies.sort();
        ofCircles.sort();
    }

    private void part(int joint) {
        int bodyA = joints.rigidBodies[2 * joint];
        int bodyB = joints.rigidBodies[2 * joint + 1];
        int circleA = joints.traits[JointRow.traits(joint) + JointRow.A];
        int circleB = joints.traits[JointRow.traits(joint) + JointRow.B];
        if (bodyA != JointRow.NONE && bodyB != JointRow.NONE) {
            pairs.partners[RigidStep.BODY_BODY].add(Math.min(bodyA, bodyB), Math.max(bodyA, bodyB));
        } else if (bodyA != JointRow.NONE && circleB != JointRow.NONE) {
            pairs.partners[RigidStep.BODY_CIRCLE].add(bodyA, circleB);
        } else if (bodyB != JointRow.NONE) {
            pairs.partners[RigidStep.BODY_CIRCLE].add(bodyB, circleA);
        }
    }

    /** Measures the joints for the first time; bodies are things. */
    void begin(StepConstants constants) {
        k = constants;
        scaleResting();
        for (int n = 0; n < count; n++) {
            acting[n].beginStep(joints, states, k);
        }
    }

    void warmStart() {
        for (int n = 0; n < count; n++) {
            acting[n].warmStart();
        }
    }

    void solve(int sub) {
        for (int n = 0; n < count; n++) {
            acting[n].solve(sub);
        }
    }

    void relax(int sub, boolean last) {
        for (int n = 0; n < count; n++) {
            acting[n].relax(sub, last);
        }
    }

    /** Ends the step: joints break. Returns whether one has. */
    boolean end() {
        boolean some = false;
        for (int n = 0; n < count && joints.breakable; n++) {
            if (acting[n].breaks()) {
                states.breakJoint(acting[n].id);
                some = true;
            }
        }
        joints = null;
        states = null;
        return some;
    }

    // ---- sleep

    private int body(int joint, int side) {
        return joints.rigidBodies[2 * joint + side];
    }

    /** The thing of a body at a side of a joint, or null. */
    private RigidThing thing(int joint, int side) {
        return body(joint, side) == JointRow.NONE ? null : pairs.bodyThing(body(joint, side));
    }

    private boolean holdsCircle(int joint) {
        int traits = JointRow.traits(joint);
        return joints.traits[traits + JointRow.A] != JointRow.NONE
                || joints.traits[traits + JointRow.B] != JointRow.NONE;
    }

    private boolean isThere(int joint) {
        return states.serial[joint] == joints.traits[JointRow.traits(joint) + JointRow.SERIAL];
    }

    /** Whether all bodies of a joint sleep: it keeps its impulses. */
    private boolean rests(int joint) {
        return !holdsCircle(joint)
                && (body(joint, 0) == JointRow.NONE || rigids.isAsleep(body(joint, 0)))
                && (body(joint, 1) == JointRow.NONE || rigids.isAsleep(body(joint, 1)));
    }

    /** Whether a joint moves its bodies whatever they do. Circles know nothing of what bodies do by joints: these keep both awake. */
    private boolean drives(int joint) {
        int row = JointRow.of(joint);
        int traits = JointRow.traits(joint);
        return holdsCircle(joint)
                || Sleep.drives(
                        joints.traits[traits + JointRow.FORM] & JointRow.ANGULAR,
                        joints.rows[row + JointRow.SPEED],
                        joints.rows[row + JointRow.MAX_TORQUE],
                        joints.traits[traits + JointRow.ANCHOR]);
    }

    /** Another length of steps takes other impulses, also of joints that rest. */
    private void scaleResting() {
        for (int n = 0; joints != null && k.warmScale != 1f && n < joints.rigidCount; n++) {
            int joint = joints.rigidOrder[n];
            if (isThere(joint) && rests(joint)) {
                for (int at = JointState.of(joint); at < JointState.of(joint + 1); at++) {
                    states.rows[at] *= k.warmScale;
                }
            }
        }
    }

    /** Another number once joints are others. */
    long version() {
        return joints == null ? -1 : (long) joints.orderVersion << 32 | joints.version & 0xFFFFFFFFL;
    }

    boolean areThere() {
        return joints != null;
    }

    /** Before bodies wake, with the numbers of the step. */
    void look(StepConstants constants, WakingByBodies waking) {
        k = constants;
        for (int n = 0; joints != null && n < joints.rigidCount; n++) {
            int joint = joints.rigidOrder[n];
            if (isThere(joint)) {
                look(joint, 0, waking);
                look(joint, 1, waking);
            }
        }
        for (int t = 0; joints != null && t < things.bodies; t++) {
            if (things.all[t].asleep && waking.isLookedAt(things.all[t])) {
                press(things.all[t], waking);
            }
        }
    }

    private void look(int joint, int side, WakingByBodies waking) {
        RigidThing t = thing(joint, side);
        if (t == null || !t.asleep) {
            return;
        }
        if (drives(joint)) {
            waking.drive(t);
        }
        RigidThing other = thing(joint, 1 - side);
        if (other != null && !other.asleep) {
            float armX = armX(joint, 1 - side, other);
            float armY = armY(joint, 1 - side, other);
            float speed = CircleMath.length(other.vx - other.omega * armY, other.vy + other.omega * armX);
            waking.move(t, other.ownW, speed, load(joint));
        }
    }

    private float armX(int joint, int side, RigidThing t) {
        float x = joints.rigidPoints[4 * joint + 2 * side];
        return t.cos * x - t.sin * joints.rigidPoints[4 * joint + 2 * side + 1];
    }

    private float armY(int joint, int side, RigidThing t) {
        float x = joints.rigidPoints[4 * joint + 2 * side];
        return t.sin * x + t.cos * joints.rigidPoints[4 * joint + 2 * side + 1];
    }

    private float sum(int joint, int which) {
        return Sleep.ofSubStep(states.rows[JointState.of(joint) + which], k.warmScale, k.subSteps);
    }

    private float load(int joint) {
        boolean elastic = (joints.traits[JointRow.traits(joint) + JointRow.FORM] & JointRow.ELASTIC) != 0;
        return Sleep.loadOfJoint(sum(joint, JointState.SUM_X), sum(joint, JointState.SUM_Y), elastic);
    }

    /** The first end behind another one where a joint holds a body, as twice a place in the order and the side; -1 if there is none. */
    private int nextEnd(int after, int body) {
        for (int end = after + 1; joints != null && end < 2 * joints.rigidCount; end++) {
            int joint = joints.rigidOrder[end >> 1];
            if (body(joint, end & 1) == body && isThere(joint)) {
                return end;
            }
        }
        return -1;
    }

    /** Adds what joints give a body to what presses it. */
    void press(RigidThing t, WakingByBodies waking) {
        for (int end = nextEnd(-1, t.id); end >= 0; end = nextEnd(end, t.id)) {
            int joint = joints.rigidOrder[end >> 1];
            int side = end & 1;
            float sign = side == 0 ? -1f : 1f;
            waking.pull(
                    t,
                    sign * sum(joint, JointState.SUM_X),
                    sign * sum(joint, JointState.SUM_Y),
                    armX(joint, side, t),
                    armY(joint, side, t),
                    -sign * sum(joint, JointState.SUM_ANGULAR),
                    load(joint));
        }
    }

    /** What woke a body reaches those that joints hold to it. */
    void passOn(RigidThing t, float speed, WakingByBodies waking) {
        for (int end = nextEnd(-1, t.id); end >= 0; end = nextEnd(end, t.id)) {
            int joint = joints.rigidOrder[end >> 1];
            RigidThing other = thing(joint, 1 - (end & 1));
            if (other != null) {
                waking.passOn(other, speed, load(joint), 0f, other.ownW, t.ownW);
            }
        }
    }

    /** Whether a joint drives a body. */
    boolean drive(int body) {
        boolean drive = false;
        for (int end = nextEnd(-1, body); !drive && end >= 0; end = nextEnd(end, body)) {
            drive = drives(joints.rigidOrder[end >> 1]);
        }
        return drive;
    }

    long bytes() {
        return 316L * acting.length;
    }
}
