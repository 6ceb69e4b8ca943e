package io.github.circles2d.world.jvm;

import static io.github.circles2d.world.jvm.JointWork.BASE_X;
import static io.github.circles2d.world.jvm.JointWork.BASE_Y;
import static io.github.circles2d.world.jvm.JointWork.DIRECTION;
import static io.github.circles2d.world.jvm.JointWork.DISTANCE;
import static io.github.circles2d.world.jvm.JointWork.INV_INERTIA_A;
import static io.github.circles2d.world.jvm.JointWork.INV_INERTIA_B;
import static io.github.circles2d.world.jvm.JointWork.INV_MASS_A;
import static io.github.circles2d.world.jvm.JointWork.INV_MASS_B;
import static io.github.circles2d.world.jvm.JointWork.NORMAL_X;
import static io.github.circles2d.world.jvm.JointWork.NORMAL_Y;
import static io.github.circles2d.world.jvm.JointWork.SHARE_A;
import static io.github.circles2d.world.jvm.JointWork.SHARE_B;
import static io.github.circles2d.world.model.CircleRow.BEFORE_X;
import static io.github.circles2d.world.model.CircleRow.BEFORE_Y;
import static io.github.circles2d.world.model.CircleRow.DX;
import static io.github.circles2d.world.model.CircleRow.DY;
import static io.github.circles2d.world.model.CircleRow.IMPULSE_X;
import static io.github.circles2d.world.model.CircleRow.IMPULSE_Y;
import static io.github.circles2d.world.model.CircleRow.INVERSE_INERTIA;
import static io.github.circles2d.world.model.CircleRow.INVERSE_MASS;
import static io.github.circles2d.world.model.CircleRow.LOADED_NEXT;
import static io.github.circles2d.world.model.CircleRow.RADIUS;
import static io.github.circles2d.world.model.CircleRow.SPIN_IMPULSE;
import static io.github.circles2d.world.model.CircleRow.SURFACE_SPEED;
import static io.github.circles2d.world.model.CircleRow.TURNED;
import static io.github.circles2d.world.model.CircleRow.VX;
import static io.github.circles2d.world.model.CircleRow.VY;
import static io.github.circles2d.world.model.CircleRow.X;
import static io.github.circles2d.world.model.CircleRow.Y;

import io.github.circles2d.world.model.AnchorRow;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.JointMath;
import io.github.circles2d.world.model.JointRow;
import io.github.circles2d.world.model.JointSpring;
import io.github.circles2d.world.model.JointState;
import io.github.circles2d.world.model.JointStep;
import io.github.circles2d.world.model.Softness;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.Wrapping;

/**
 * The visits of joints: a joint at a time, which knows all of its two ends. {@link JointMath} has the formulas, {@link JointPasses} the order.
 * A visit leaves what it changes of the two circles in the fields, for {@link #give}. {@code JointVisit.cl} does the same.
 */
final class JointVisits {
    private final State state;
    private final JointStates states;
    private JointStep joints;
    private StepConstants k;

    /** By place in the order, {@link JointWork}. */
    private float[] work;

    private int[] slots;

    // ---- the joint of the visit

    private int o;
    private int row;
    private int traits;
    private int kept;
    private int form;
    private int a;
    private int b;

    /** Velocity of B against A, and that as the sub-step began. */
    private float vx;

    private float vy;
    private float begunX;
    private float begunY;

    /** Inverse masses of both, as the visit sees them, and the effective mass. */
    private float inverse;

    private float mass;

    /** Angular velocities of both, and what an angular impulse adds to them, as the visit sees them. */
    private float omegaA;

    private float omegaB;
    private float turnA;
    private float turnB;

    /** What the visit gives: impulses on B, and an angular impulse on A; what both surfaces get besides. */
    float pushX;

    float pushY;
    float twist;
    float both;

    JointVisits(State state, JointStates states) {
        this.state = state;
        this.states = states;
    }

    void begin(JointStep step, StepConstants constants, float[] itsWork, int[] itsSlots) {
        joints = step;
        k = constants;
        work = itsWork;
        slots = itsSlots;
    }

    // ---- the step begins
    // -----------------------------------------------------------------------------------------------------

    /**
     * Begins the step of a joint: it scales the impulses of the step before. False if the joint has broken. A step begins its joints once, even if it
     * lists its contacts twice.
     */
    boolean begin(int place) {
        int joint = joints.order[place];
        if (!states.begin(joint, joints)) {
            slots[JointWork.slots(place) + JointWork.A] = JointWork.NONE;
            return false;
        }
        slots[JointWork.slots(place) + JointWork.A] = state.slotOf[joints.traits[JointRow.traits(joint) + JointRow.A]];
        int idB = joints.traits[JointRow.traits(joint) + JointRow.B];
        slots[JointWork.slots(place) + JointWork.B] = idB == JointRow.NONE ? JointWork.NONE : state.slotOf[idB];
        work[JointWork.of(place) + SHARE_A] = 1f;
        work[JointWork.of(place) + SHARE_B] = 1f;
        float[] q = states.rows;
        int at = JointState.of(joint);
        float warm = k.warmScale;
        q[at + JointState.AXIAL] *= warm;
        q[at + JointState.ACROSS] *= warm;
        q[at + JointState.LOWER] *= warm;
        q[at + JointState.UPPER] *= warm;
        q[at + JointState.ANGULAR] *= warm;
        q[at + JointState.SUM_X] = 0f;
        q[at + JointState.SUM_Y] = 0f;
        q[at + JointState.SUM_ANGULAR] = 0f;
        return true;
    }

    /** Whether the joint of a place does something in this step. */
    boolean acts(int place) {
        return slots[JointWork.slots(place) + JointWork.A] >= 0;
    }

    /** Measures a joint for the first time, and pushes with the impulses that it has. */
    void prepare(int place) {
        take(place, joints.order[place]);
        work[o + INV_MASS_A] = state.traits[a + INVERSE_MASS];
        work[o + INV_MASS_B] = hasB() ? state.traits[b + INVERSE_MASS] : 0f;
        work[o + INV_INERTIA_A] = k.turning ? state.turning.spin[a + INVERSE_INERTIA] : 0f;
        work[o + INV_INERTIA_B] = k.turning && hasB() ? state.turning.spin[b + INVERSE_INERTIA] : 0f;
        work[o + NORMAL_X] = 1f;
        work[o + NORMAL_Y] = 0f;
        if (hasB()) {
            work[o + BASE_X] = state.differenceX(CircleRow.slot(a), CircleRow.slot(b));
            work[o + BASE_Y] = state.differenceY(CircleRow.slot(a), CircleRow.slot(b));
        } else {
            work[o + BASE_X] = across(joints.rows[row + JointRow.ANCHOR_X] - state.circle[a + X], state.periodX);
            work[o + BASE_Y] = across(joints.rows[row + JointRow.ANCHOR_Y] - state.circle[a + Y], state.periodY);
        }
        measure(0);
        markLoaded();
        all();
    }

    /**
     * Marks circles that the joint cannot bring to where they should be as loaded in the next sub-step: its impulses throw them at what holds them, and
     * off that they must not bounce.
     */
    private void markLoaded() {
        float strain = strain();
        if (work[o + INV_MASS_A] != 0f && JointMath.loads(strain, state.circle[a + RADIUS])) {
            state.load[a + LOADED_NEXT] = 1f;
        }
        if (work[o + INV_MASS_B] != 0f && JointMath.loads(strain, state.circle[b + RADIUS])) {
            state.load[b + LOADED_NEXT] = 1f;
        }
    }

    /** How far it is from what it is to keep, as measured last; springs keep nothing. */
    private float strain() {
        if (linear() == JointRow.POINT) {
            return has(JointRow.RIGID) ? CircleMath.length(work[o + NORMAL_X], work[o + NORMAL_Y]) : 0f;
        }
        float d = work[o + DISTANCE];
        float strain = has(JointRow.RIGID) ? Math.abs(d - joints.rows[row + JointRow.LENGTH]) : 0f;
        strain = has(JointRow.LOWER) ? CircleMath.max(joints.rows[row + JointRow.MIN_LENGTH] - d, strain) : strain;
        return has(JointRow.UPPER) ? CircleMath.max(d - joints.rows[row + JointRow.MAX_LENGTH], strain) : strain;
    }

    private float across(float d, float period) {
        return state.wraps ? Wrapping.shortWay(d, period) : d;
    }

    // ---- what all passes do
    // --------------------------------------------------------------------------------------------------

    private void take(int place, int joint) {
        o = JointWork.of(place);
        row = JointRow.of(joint);
        traits = JointRow.traits(joint);
        kept = JointState.of(joint);
        form = joints.traits[traits + JointRow.FORM];
        a = CircleRow.of(slots[JointWork.slots(place) + JointWork.A]);
        b = CircleRow.of(slots[JointWork.slots(place) + JointWork.B]); // negative for NONE
        pushX = 0f;
        pushY = 0f;
        twist = 0f;
        both = 0f;
    }

    private boolean hasB() {
        return b >= 0;
    }

    private int linear() {
        return form & JointRow.LINEAR;
    }

    private int angular() {
        return form & JointRow.ANGULAR;
    }

    private boolean has(int flag) {
        return (form & flag) != 0;
    }

    private int anchor(int boundary) {
        return AnchorRow.of(joints.traits[traits + JointRow.ANCHOR], boundary, k.subSteps);
    }

    /** Measures where B is from A; at the boundary of sub-steps for anchors that move. */
    private void measure(int boundary) {
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
            int turn = JointMath.meanTurn(
                    angle(a),
                    joints.traits[traits + JointRow.REFERENCE_A],
                    turned(a),
                    angle(b),
                    joints.traits[traits + JointRow.REFERENCE_B],
                    turned(b));
            float cos = JointMath.cos(turn);
            float sin = JointMath.sin(turn);
            float directionX = joints.rows[row + JointRow.DIRECTION_X];
            float directionY = joints.rows[row + JointRow.DIRECTION_Y];
            work[o + DIRECTION] = (cos * directionX - sin * directionY) * y - (sin * directionX + cos * directionY) * x;
        }
    }

    private int angle(int circle) {
        return circle < 0 ? 0 : state.turning.angle[CircleRow.slot(circle)];
    }

    /** In this step, in radians. */
    private float turned(int circle) {
        return circle < 0 ? 0f : state.turning.spin[circle + TURNED] * k.h / state.circle[circle + RADIUS];
    }

    private float radius(int circle) {
        return circle < 0 ? 1f : state.circle[circle + RADIUS];
    }

    private float surfaceSpeed(int circle) {
        return circle < 0 ? 0f : state.turning.spin[circle + SURFACE_SPEED];
    }

    /** Takes the velocities of both. */
    private void look(int boundary) {
        float[] m = state.motion;
        float ofX = hasB() ? m[b + VX] : joints.anchors[anchor(boundary) + AnchorRow.VX];
        float ofY = hasB() ? m[b + VY] : joints.anchors[anchor(boundary) + AnchorRow.VY];
        vx = ofX - m[a + VX];
        vy = ofY - m[a + VY];
        inverse = work[o + SHARE_A] * work[o + INV_MASS_A] + work[o + SHARE_B] * work[o + INV_MASS_B];
        mass = JointMath.mass(inverse);
        if (angular() != 0 || has(JointRow.ACROSS)) {
            float rA = radius(a);
            float rB = radius(b);
            omegaA = surfaceSpeed(a) / rA;
            omegaB = surfaceSpeed(b) / rB;
            turnA = work[o + SHARE_A] * (work[o + INV_INERTIA_A] / (rA * rA));
            turnB = work[o + SHARE_B] * (work[o + INV_INERTIA_B] / (rB * rB));
        }
    }

    /** Takes the velocity of B against A as the sub-step began: without gravity and all impulses. */
    private void lookBack(int boundary) {
        float[] load = state.load;
        int slotA = CircleRow.slot(a);
        float ofX;
        float ofY;
        if (hasB()) {
            int slotB = CircleRow.slot(b);
            ofX = load[b + BEFORE_X] - fallX(slotB);
            ofY = load[b + BEFORE_Y] - fallY(slotB);
        } else {
            ofX = joints.anchors[anchor(boundary) + AnchorRow.VX];
            ofY = joints.anchors[anchor(boundary) + AnchorRow.VY];
        }
        begunX = ofX - (load[a + BEFORE_X] - fallX(slotA));
        begunY = ofY - (load[a + BEFORE_Y] - fallY(slotA));
    }

    private float fallX(int slot) {
        return state.isStatic(slot) ? 0f : state.gainX(slot, k);
    }

    private float fallY(int slot) {
        return state.isStatic(slot) ? 0f : state.gainY(slot, k);
    }

    /** All impulses of the joint, as what is to be given. */
    private void all() {
        float[] q = states.rows;
        if (linear() == JointRow.AXIAL) {
            float nx = work[o + NORMAL_X];
            float ny = work[o + NORMAL_Y];
            float along = (q[kept + JointState.AXIAL] + q[kept + JointState.LOWER]) - q[kept + JointState.UPPER];
            float across = q[kept + JointState.ACROSS];
            pushX = nx * along - ny * across;
            pushY = ny * along + nx * across;
            both = has(JointRow.ACROSS) ? -0.5f * work[o + DISTANCE] * across : 0f;
        } else {
            pushX = q[kept + JointState.AXIAL];
            pushY = q[kept + JointState.ACROSS];
        }
        twist = q[kept + JointState.ANGULAR];
    }

    // ---- the biased pass
    // -----------------------------------------------------------------------------------------------------

    void solve(int place, int sub) {
        take(place, joints.order[place]);
        measure(sub);
        look(sub);
        if (has(JointRow.ELASTIC)) {
            lookBack(sub);
        }
        solveTurning();
        if (linear() == JointRow.AXIAL) {
            solveAlong();
        } else if (linear() == JointRow.POINT) {
            solvePoint();
        }
    }

    private void solveAlong() {
        float[] q = states.rows;
        Softness soft = k.jointSoftness;
        float nx = work[o + NORMAL_X];
        float ny = work[o + NORMAL_Y];
        float d = work[o + DISTANCE];
        float v = CircleMath.dot(nx, ny, vx, vy);
        float push = 0f;
        if (has(JointRow.RIGID | JointRow.ELASTIC)) {
            float begun = CircleMath.dot(nx, ny, begunX, begunY);
            float change = solveAxis(JointState.AXIAL, v, begun, d - joints.rows[row + JointRow.LENGTH]);
            push += change;
            v += inverse * change;
        }
        if (has(JointRow.LOWER)) {
            float before = q[kept + JointState.LOWER];
            float gap = d - joints.rows[row + JointRow.MIN_LENGTH];
            float next = JointMath.solveLimit(before, mass, v, gap, k.inverseH, soft);
            q[kept + JointState.LOWER] = next;
            push += next - before;
            v += inverse * (next - before);
        }
        if (has(JointRow.UPPER)) {
            float before = q[kept + JointState.UPPER];
            float gap = joints.rows[row + JointRow.MAX_LENGTH] - d;
            float next = JointMath.solveLimit(before, mass, -1f * v, gap, k.inverseH, soft);
            q[kept + JointState.UPPER] = next;
            push -= next - before;
        }
        pushX = nx * push;
        pushY = ny * push;
        if (has(JointRow.ACROSS)) {
            float before = q[kept + JointState.ACROSS];
            float next = JointMath.solve(
                    before,
                    acrossMass(),
                    speedAcross(),
                    work[o + DIRECTION],
                    soft.massScale,
                    soft.biasRate,
                    soft.impulseScale);
            giveAcross(before, next);
        }
    }

    /** One over what an impulse across changes of the speed across. */
    private float acrossMass() {
        float arm = 0.5f * work[o + DISTANCE];
        return JointMath.mass(inverse + arm * arm * (turnA + turnB));
    }

    /** Speed of B across, against the direction that turns with both. */
    private float speedAcross() {
        float along = CircleMath.dot(-1f * work[o + NORMAL_Y], work[o + NORMAL_X], vx, vy);
        return along - 0.5f * work[o + DISTANCE] * (omegaA + omegaB);
    }

    private void giveAcross(float before, float next) {
        states.rows[kept + JointState.ACROSS] = next;
        float change = next - before;
        pushX -= work[o + NORMAL_Y] * change;
        pushY += work[o + NORMAL_X] * change;
        both = -0.5f * work[o + DISTANCE] * change;
    }

    /** One axis with bias; returns how much its impulse has changed. */
    private float solveAxis(int which, float v, float begun, float c) {
        float before = states.rows[kept + which];
        float next;
        if (has(JointRow.RIGID)) {
            Softness soft = k.jointSoftness;
            next = JointMath.solve(before, mass, v, c, soft.massScale, soft.biasRate, soft.impulseScale);
        } else {
            next = spring(before, isExact() ? springMass() : mass, v, begun, c);
        }
        states.rows[kept + which] = next;
        return next - before;
    }

    /** As {@link #mass}, but of an exact spring, which a hub must not make weaker than it has to. */
    private float springMass() {
        float split = joints.springs[JointSpring.of(joints.traits[traits + JointRow.SPRING]) + JointSpring.EXACT];
        return JointMath.mass(JointMath.springShare(work[o + SHARE_A], split) * work[o + INV_MASS_A]
                + JointMath.springShare(work[o + SHARE_B], split) * work[o + INV_MASS_B]);
    }

    private boolean isExact() {
        return joints.springs[JointSpring.of(joints.traits[traits + JointRow.SPRING]) + JointSpring.EXACT] != 0f;
    }

    private float spring(float before, float m, float v, float begun, float c) {
        float[] s = joints.springs;
        int at = JointSpring.of(joints.traits[traits + JointRow.SPRING]);
        return isExact()
                ? JointMath.spring(
                        m, v, begun, c, s[at + JointSpring.NOW], s[at + JointSpring.BEGUN], s[at + JointSpring.WAY])
                : JointMath.solve(
                        before,
                        m,
                        v,
                        c,
                        s[at + JointSpring.MASS_SCALE],
                        s[at + JointSpring.BIAS_RATE],
                        s[at + JointSpring.IMPULSE_SCALE]);
    }

    private void solvePoint() {
        float beforeX = states.rows[kept + JointState.AXIAL];
        float beforeY = states.rows[kept + JointState.ACROSS];
        solveAxis(JointState.AXIAL, vx, begunX, work[o + NORMAL_X]);
        solveAxis(JointState.ACROSS, vy, begunY, work[o + NORMAL_Y]);
        keepWithin(beforeX, beforeY);
    }

    /** Cuts a force that is too great, and gives the change. */
    private void keepWithin(float beforeX, float beforeY) {
        float[] q = states.rows;
        float limit = joints.rows[row + JointRow.MAX_FORCE] * k.h;
        float share = JointMath.shareWithin(q[kept + JointState.AXIAL], q[kept + JointState.ACROSS], limit);
        q[kept + JointState.AXIAL] *= share;
        q[kept + JointState.ACROSS] *= share;
        pushX = q[kept + JointState.AXIAL] - beforeX;
        pushY = q[kept + JointState.ACROSS] - beforeY;
    }

    private void solveTurning() {
        if (angular() == 0 || angular() == JointRow.TURN_SPEED) {
            return;
        }
        float away = JointMath.turnedAway(
                angle(a),
                joints.traits[traits + JointRow.REFERENCE_A],
                turned(a),
                angle(b),
                joints.traits[traits + JointRow.REFERENCE_B],
                turned(b));
        float before = states.rows[kept + JointState.ANGULAR];
        Softness soft = k.jointSoftness;
        float turnMass = JointMath.mass(turnA + turnB);
        float omega = omegaA - omegaB;
        float next = angular() == JointRow.TURN_RIGID
                ? JointMath.solve(before, turnMass, omega, away, soft.massScale, soft.biasRate, soft.impulseScale)
                : spring(before, turnMass, omega, omega, away);
        giveTwist(before, next);
    }

    private void giveTwist(float before, float next) {
        float limit = joints.rows[row + JointRow.MAX_TORQUE] * k.h;
        float held = CircleMath.clamp(next, -limit, limit);
        states.rows[kept + JointState.ANGULAR] = held;
        twist = held - before;
        omegaA += turnA * twist;
        omegaB -= turnB * twist;
    }

    // ---- the relaxing pass
    // ---------------------------------------------------------------------------------------------------

    void relax(int place, int sub) {
        take(place, joints.order[place]);
        measure(sub + 1);
        look(sub + 1);
        relaxTurning();
        if (linear() == JointRow.AXIAL) {
            relaxAlong();
        } else if (linear() == JointRow.DRAG || linear() == JointRow.POINT && has(JointRow.RIGID)) {
            float beforeX = states.rows[kept + JointState.AXIAL];
            float beforeY = states.rows[kept + JointState.ACROSS];
            states.rows[kept + JointState.AXIAL] = JointMath.relax(beforeX, mass, vx);
            states.rows[kept + JointState.ACROSS] = JointMath.relax(beforeY, mass, vy);
            keepWithin(beforeX, beforeY);
        }
    }

    private void relaxTurning() {
        if (angular() == 0) {
            return;
        }
        float before = states.rows[kept + JointState.ANGULAR];
        float turnMass = JointMath.mass(turnA + turnB);
        float omega = omegaA - omegaB;
        if (angular() == JointRow.TURN_RIGID) {
            giveTwist(before, JointMath.relax(before, turnMass, omega));
        } else if (angular() == JointRow.TURN_SPEED) {
            giveTwist(before, JointMath.relax(before, turnMass, omega - joints.rows[row + JointRow.SPEED]));
        }
    }

    private void relaxAlong() {
        float[] q = states.rows;
        float nx = work[o + NORMAL_X];
        float ny = work[o + NORMAL_Y];
        float d = work[o + DISTANCE];
        float v = CircleMath.dot(nx, ny, vx, vy);
        float push = 0f;
        if (has(JointRow.RIGID)) {
            float before = q[kept + JointState.AXIAL];
            float next = JointMath.relax(before, mass, v);
            q[kept + JointState.AXIAL] = next;
            push += next - before;
            v += inverse * (next - before);
        }
        if (has(JointRow.LOWER)) {
            float before = q[kept + JointState.LOWER];
            float gap = d - joints.rows[row + JointRow.MIN_LENGTH];
            float next = JointMath.relaxLimit(before, mass, v, gap, k.inverseH);
            q[kept + JointState.LOWER] = next;
            push += next - before;
            v += inverse * (next - before);
        }
        if (has(JointRow.UPPER)) {
            float before = q[kept + JointState.UPPER];
            float gap = joints.rows[row + JointRow.MAX_LENGTH] - d;
            float next = JointMath.relaxLimit(before, mass, -1f * v, gap, k.inverseH);
            q[kept + JointState.UPPER] = next;
            push -= next - before;
        }
        pushX = nx * push;
        pushY = ny * push;
        if (has(JointRow.ACROSS)) {
            float before = q[kept + JointState.ACROSS];
            giveAcross(before, JointMath.relax(before, acrossMass(), speedAcross()));
        }
    }

    /** Behind the relaxing pass of a joint: adds up its impulses, and makes ready what the next sub-step begins with. */
    void end(int place) {
        take(place, joints.order[place]);
        float[] q = states.rows;
        markLoaded();
        all();
        q[kept + JointState.SUM_X] += pushX;
        q[kept + JointState.SUM_Y] += pushY;
        q[kept + JointState.SUM_ANGULAR] += twist;
        if (has(JointRow.ELASTIC) && isExact()) {
            q[kept + JointState.AXIAL] = 0f;
            q[kept + JointState.ACROSS] = linear() == JointRow.POINT ? 0f : q[kept + JointState.ACROSS];
            q[kept + JointState.ANGULAR] = angular() == JointRow.TURN_ANGLE ? 0f : q[kept + JointState.ANGULAR];
            all();
        }
    }

    /** Whether a joint breaks by what it did in the step. */
    boolean breaks(int place) {
        take(place, joints.order[place]);
        float[] q = states.rows;
        float force = CircleMath.length(q[kept + JointState.SUM_X], q[kept + JointState.SUM_Y]);
        float torque = Math.abs(q[kept + JointState.SUM_ANGULAR]);
        return has(JointRow.BREAKABLE)
                && (force > joints.rows[row + JointRow.BREAK_FORCE] * k.dt
                        || torque > joints.rows[row + JointRow.BREAK_TORQUE] * k.dt);
    }

    // ---- what becomes of it
    // --------------------------------------------------------------------------------------------------

    private boolean turns() {
        return angular() != 0 || has(JointRow.ACROSS);
    }

    /** Gives it to the velocities. */
    void give() {
        float[] m = state.motion;
        float wA = work[o + INV_MASS_A];
        float wB = work[o + INV_MASS_B];
        if (wA != 0f) {
            m[a + VX] -= wA * pushX;
            m[a + VY] -= wA * pushY;
        }
        if (wB != 0f) {
            m[b + VX] += wB * pushX;
            m[b + VY] += wB * pushY;
        }
        if (turns()) {
            if (wA != 0f) {
                state.turning.spin[a + SURFACE_SPEED] += work[o + INV_INERTIA_A] * spinOfA();
            }
            if (wB != 0f) {
                state.turning.spin[b + SURFACE_SPEED] += work[o + INV_INERTIA_B] * spinOfB();
            }
        }
    }

    /** Impulses along the surfaces. */
    float spinOfA() {
        return (twist + both) / radius(a);
    }

    float spinOfB() {
        return (both - twist) / radius(b);
    }

    /** Gives it to the sums that the circles begin the next sub-step with. */
    void giveToSums() {
        float[] load = state.load;
        if (work[o + INV_MASS_A] != 0f) {
            load[a + IMPULSE_X] -= pushX;
            load[a + IMPULSE_Y] -= pushY;
            if (turns()) {
                state.turning.spin[a + SPIN_IMPULSE] += spinOfA();
            }
        }
        if (work[o + INV_MASS_B] != 0f) {
            load[b + IMPULSE_X] += pushX;
            load[b + IMPULSE_Y] += pushY;
            if (turns()) {
                state.turning.spin[b + SPIN_IMPULSE] += spinOfB();
            }
        }
    }
}
