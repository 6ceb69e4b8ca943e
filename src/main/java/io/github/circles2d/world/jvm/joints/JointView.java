package io.github.circles2d.world.jvm.joints;

import static io.github.circles2d.world.jvm.joints.JointWork.BASE_X;
import static io.github.circles2d.world.jvm.joints.JointWork.BASE_Y;
import static io.github.circles2d.world.jvm.joints.JointWork.DIRECTION;
import static io.github.circles2d.world.jvm.joints.JointWork.DISTANCE;
import static io.github.circles2d.world.jvm.joints.JointWork.INV_INERTIA_A;
import static io.github.circles2d.world.jvm.joints.JointWork.INV_INERTIA_B;
import static io.github.circles2d.world.jvm.joints.JointWork.INV_MASS_A;
import static io.github.circles2d.world.jvm.joints.JointWork.INV_MASS_B;
import static io.github.circles2d.world.jvm.joints.JointWork.NORMAL_X;
import static io.github.circles2d.world.jvm.joints.JointWork.NORMAL_Y;
import static io.github.circles2d.world.jvm.joints.JointWork.PUSH;
import static io.github.circles2d.world.jvm.joints.JointWork.SHARE_A;
import static io.github.circles2d.world.jvm.joints.JointWork.SHARE_B;
import static io.github.circles2d.world.model.CircleRow.BEFORE_X;
import static io.github.circles2d.world.model.CircleRow.BEFORE_Y;
import static io.github.circles2d.world.model.CircleRow.DX;
import static io.github.circles2d.world.model.CircleRow.DY;
import static io.github.circles2d.world.model.CircleRow.INVERSE_INERTIA;
import static io.github.circles2d.world.model.CircleRow.INVERSE_MASS;
import static io.github.circles2d.world.model.CircleRow.RADIUS;
import static io.github.circles2d.world.model.CircleRow.SURFACE_SPEED;
import static io.github.circles2d.world.model.CircleRow.TURNED;
import static io.github.circles2d.world.model.CircleRow.VX;
import static io.github.circles2d.world.model.CircleRow.VY;
import static io.github.circles2d.world.model.CircleRow.X;
import static io.github.circles2d.world.model.CircleRow.Y;

import io.github.circles2d.world.jvm.state.JointStates;
import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.model.AnchorRow;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.JointMath;
import io.github.circles2d.world.model.JointRow;
import io.github.circles2d.world.model.JointSpring;
import io.github.circles2d.world.model.JointStep;
import io.github.circles2d.world.model.StepConstants;

/** The joint of a visit: what it is, where its ends are, and how they move. */
final class JointView extends VisitedJoint {
    private final State state;

    /** By place in the order, {@link JointWork}. */
    float[] work;

    private int[] slots;

    // ---- rows of the joint and of its circles

    int o;
    int a;

    /** Negative if it has none. */
    int b;

    private int still;

    /** Angular velocities of both, and what an angular impulse adds to them, as the visit sees them. */
    float omegaA;

    float omegaB;
    float turnA;
    float turnB;

    JointView(State state) {
        this.state = state;
    }

    void begin(JointStep step, JointStates itsStates, StepConstants constants, float[] itsWork, int[] itsSlots) {
        begin(step, itsStates, constants);
        work = itsWork;
        slots = itsSlots;
    }

    void take(int place) {
        takeJoint(joints.order[place]);
        o = JointWork.of(place);
        a = CircleRow.of(slots[JointWork.slots(place) + JointWork.A]);
        b = CircleRow.of(slots[JointWork.slots(place) + JointWork.B]);
        still = slots[JointWork.slots(place) + JointWork.STILL];
    }

    /** What stays as it is in a step. */
    void measureFirst() {
        work[o + INV_MASS_A] = state.traits[a + INVERSE_MASS];
        work[o + INV_MASS_B] = hasB() ? state.traits[b + INVERSE_MASS] : 0f;
        work[o + INV_INERTIA_A] = k.turning ? state.turning.spin[a + INVERSE_INERTIA] : 0f;
        work[o + INV_INERTIA_B] = k.turning && hasB() ? state.turning.spin[b + INVERSE_INERTIA] : 0f;
        if (still != 0) {
            takeOwnMasses();
        }
        work[o + NORMAL_X] = 1f;
        work[o + NORMAL_Y] = 0f;
        float radius = state.circle[a + RADIUS];
        if (hasB()) {
            work[o + BASE_X] = state.differenceX(CircleRow.slot(a), CircleRow.slot(b));
            work[o + BASE_Y] = state.differenceY(CircleRow.slot(a), CircleRow.slot(b));
            radius = CircleMath.min(radius, state.circle[b + RADIUS]);
        } else {
            work[o + BASE_X] = across(value(JointRow.ANCHOR_X) - state.circle[a + X], state.periodX);
            work[o + BASE_Y] = across(value(JointRow.ANCHOR_Y) - state.circle[a + Y], state.periodY);
        }
        work[o + PUSH] = JointMath.greatestPush(radius, k.inverseH);
    }

    /** A circle that sleeps is pulled as if it would give way. */
    private void takeOwnMasses() {
        if ((still & JointWork.STILL_A) != 0) {
            work[o + INV_MASS_A] = state.ownInverseMass(CircleRow.slot(a));
            work[o + INV_INERTIA_A] = k.turning ? state.turning.ownInverseInertia(CircleRow.slot(a)) : 0f;
        }
        if ((still & JointWork.STILL_B) != 0) {
            work[o + INV_MASS_B] = state.ownInverseMass(CircleRow.slot(b));
            work[o + INV_INERTIA_B] = k.turning ? state.turning.ownInverseInertia(CircleRow.slot(b)) : 0f;
        }
    }

    /** By how much an impulse moves A: 0 if it sleeps. */
    float givenMassA() {
        return (still & JointWork.STILL_A) != 0 ? 0f : work[o + INV_MASS_A];
    }

    /** By how much it moves B: 0 if it sleeps, or is an anchor. */
    float givenMassB() {
        return (still & JointWork.STILL_B) != 0 ? 0f : work[o + INV_MASS_B];
    }

    private float across(float d, float period) {
        return state.wraps ? CircleMath.shortWay(d, period) : d;
    }

    // ---- what it is

    boolean hasB() {
        return b >= 0;
    }

    /** Whether it turns circles. */
    boolean turns() {
        return angular() != 0 || has(JointRow.ACROSS);
    }

    /** Whether its linear part is an exact spring, whose impulses are not kept. */
    boolean isLinearExact() {
        return has(JointRow.ELASTIC) && hasExactSpring();
    }

    /** The same of the angular part. */
    boolean isAngularExact() {
        return angular() == JointRow.TURN_ANGLE && hasExactSpring();
    }

    /** Whether it does something without bias: exact springs alone do not. */
    boolean relaxes() {
        return has(JointRow.RIGID | JointRow.LOWER | JointRow.UPPER | JointRow.ACROSS)
                || has(JointRow.ELASTIC) && !hasExactSpring()
                || linear() == JointRow.DRAG
                || angular() != 0 && !isAngularExact();
    }

    // ---- where its ends are

    private int anchor(int boundary) {
        return AnchorRow.of(joints.traits[traits + JointRow.ANCHOR], boundary, k.subSteps);
    }

    /** Measures where B is from A; at the boundary of sub-steps for anchors that move. */
    void measure(int boundary) {
        float[] m = state.motion;
        float toX = hasB() ? m[b + DX] : joints.anchors[anchor(boundary) + AnchorRow.DX];
        float toY = hasB() ? m[b + DY] : joints.anchors[anchor(boundary) + AnchorRow.DY];
        float x = CircleMath.difference(work[o + BASE_X], m[a + DX], toX);
        float y = CircleMath.difference(work[o + BASE_Y], m[a + DY], toY);
        if (linear() == JointRow.POINT) {
            work[o + NORMAL_X] = x;
            work[o + NORMAL_Y] = y;
            return;
        }
        float d = CircleMath.length(x, y);
        work[o + DISTANCE] = d;
        if (d > 0f) {
            work[o + NORMAL_X] = x / d;
            work[o + NORMAL_Y] = y / d;
        }
        if (has(JointRow.ACROSS)) {
            work[o + DIRECTION] = lean(x, y);
        }
    }

    private float lean(float x, float y) {
        int turn = JointMath.meanTurn(
                angle(a),
                joints.traits[traits + JointRow.REFERENCE_A],
                turned(a),
                angle(b),
                joints.traits[traits + JointRow.REFERENCE_B],
                turned(b));
        float cos = JointMath.cosOfUnits(turn);
        float sin = JointMath.sinOfUnits(turn);
        float directionX = value(JointRow.DIRECTION_X);
        float directionY = value(JointRow.DIRECTION_Y);
        return (cos * directionX - sin * directionY) * y - (sin * directionX + cos * directionY) * x;
    }

    /** How far A has turned against B, in radians. */
    float turnedAway() {
        return turnedAway(angle(a), turned(a), angle(b), turned(b));
    }

    private int angle(int circle) {
        return circle < 0 ? 0 : state.turning.angle[CircleRow.slot(circle)];
    }

    /** In this step, in radians. */
    private float turned(int circle) {
        return circle < 0 ? 0f : state.turning.spin[circle + TURNED] * k.h / state.circle[circle + RADIUS];
    }

    float radius(int circle) {
        return circle < 0 ? 1f : state.circle[circle + RADIUS];
    }

    /** How far it is from what it is to keep, as measured last; springs keep nothing. */
    float strain() {
        if (linear() == JointRow.POINT) {
            return has(JointRow.RIGID) ? CircleMath.length(work[o + NORMAL_X], work[o + NORMAL_Y]) : 0f;
        }
        return strain(work[o + DISTANCE]);
    }

    // ---- how they move

    /** Takes the velocities of both. */
    void look(int boundary) {
        float[] m = state.motion;
        float ofX = hasB() ? m[b + VX] : joints.anchors[anchor(boundary) + AnchorRow.VX];
        float ofY = hasB() ? m[b + VY] : joints.anchors[anchor(boundary) + AnchorRow.VY];
        vx = ofX - m[a + VX];
        vy = ofY - m[a + VY];
        inverse = work[o + SHARE_A] * work[o + INV_MASS_A] + work[o + SHARE_B] * work[o + INV_MASS_B];
        mass = JointMath.jointMass(inverse);
        if (turns()) {
            float rA = radius(a);
            float rB = radius(b);
            omegaA = surfaceSpeed(a) / rA;
            omegaB = surfaceSpeed(b) / rB;
            turnA = work[o + SHARE_A] * (work[o + INV_INERTIA_A] / (rA * rA));
            turnB = work[o + SHARE_B] * (work[o + INV_INERTIA_B] / (rB * rB));
        }
    }

    private float surfaceSpeed(int circle) {
        return circle < 0 ? 0f : state.turning.spin[circle + SURFACE_SPEED];
    }

    /** Takes the velocity of B against A as the sub-step began: without gravity and all impulses. */
    void lookBack(int boundary) {
        float[] load = state.load;
        int slotA = CircleRow.slot(a);
        float ofX;
        float ofY;
        if (hasB()) {
            int slotB = CircleRow.slot(b);
            ofX = load[b + BEFORE_X] - state.fallX(slotB, k);
            ofY = load[b + BEFORE_Y] - state.fallY(slotB, k);
        } else {
            ofX = joints.anchors[anchor(boundary) + AnchorRow.VX];
            ofY = joints.anchors[anchor(boundary) + AnchorRow.VY];
        }
        begunX = ofX - (load[a + BEFORE_X] - state.fallX(slotA, k));
        begunY = ofY - (load[a + BEFORE_Y] - state.fallY(slotA, k));
    }

    /** The effective mass for an exact spring, which a hub must not make weaker than it has to. */
    float springMass() {
        float split = ofSpring(JointSpring.EXACT);
        return JointMath.jointMass(JointMath.springShare(work[o + SHARE_A], split) * work[o + INV_MASS_A]
                + JointMath.springShare(work[o + SHARE_B], split) * work[o + INV_MASS_B]);
    }

    /** One over what an impulse across changes of the speed across. */
    float acrossMass() {
        float arm = 0.5f * work[o + DISTANCE];
        return JointMath.jointMass(inverse + arm * arm * (turnA + turnB));
    }

    /** Speed of B across, against the direction that turns with both. */
    float speedAcross() {
        float along = CircleMath.dot(-1f * work[o + NORMAL_Y], work[o + NORMAL_X], vx, vy);
        return along - 0.5f * work[o + DISTANCE] * (omegaA + omegaB);
    }
}
