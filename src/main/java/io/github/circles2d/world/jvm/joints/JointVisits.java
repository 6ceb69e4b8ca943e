package io.github.circles2d.world.jvm.joints;

import static io.github.circles2d.world.jvm.joints.JointWork.DIRECTION;
import static io.github.circles2d.world.jvm.joints.JointWork.DISTANCE;
import static io.github.circles2d.world.jvm.joints.JointWork.NORMAL_X;
import static io.github.circles2d.world.jvm.joints.JointWork.NORMAL_Y;
import static io.github.circles2d.world.jvm.joints.JointWork.PUSH;
import static io.github.circles2d.world.model.JointState.ACROSS;
import static io.github.circles2d.world.model.JointState.ANGULAR;
import static io.github.circles2d.world.model.JointState.AXIAL;
import static io.github.circles2d.world.model.JointState.LOWER;
import static io.github.circles2d.world.model.JointState.SUM_ANGULAR;
import static io.github.circles2d.world.model.JointState.SUM_X;
import static io.github.circles2d.world.model.JointState.SUM_Y;
import static io.github.circles2d.world.model.JointState.UPPER;

import io.github.circles2d.world.jvm.state.JointStates;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.JointMath;
import io.github.circles2d.world.model.JointRow;
import io.github.circles2d.world.model.JointSpring;
import io.github.circles2d.world.model.Softness;
import io.github.circles2d.world.model.Velocity;

/**
 * The visits of joints: a joint at a time, which knows all of its two ends. {@link JointMath} has the formulas, {@link JointPasses} the order.
 * A visit changes what the joint keeps, and leaves what it gives in its {@link JointPush}. {@code JointVisit.cl} does the same.
 */
final class JointVisits {
    private final JointStates states;
    private final JointView view;
    private final JointPush push;

    JointVisits(JointStates states, JointView view, JointPush push) {
        this.states = states;
        this.view = view;
        this.push = push;
    }

    private void begin(int place) {
        view.take(place);
        push.clear();
    }

    /** Measures a joint for the first time, and pushes with the impulses that it has. */
    void prepare(int place) {
        begin(place);
        view.measureFirst();
        view.measure(0);
        all();
    }

    /** All impulses of the joint, as what is to be given. */
    private void all() {
        float[] q = states.rows;
        int kept = view.kept;
        if (view.linear() == JointRow.AXIAL) {
            float nx = view.work[view.o + NORMAL_X];
            float ny = view.work[view.o + NORMAL_Y];
            float along = (q[kept + AXIAL] + q[kept + LOWER]) - q[kept + UPPER];
            float across = q[kept + ACROSS];
            push.x = nx * along - ny * across;
            push.y = ny * along + nx * across;
            push.both = view.has(JointRow.ACROSS) ? -0.5f * view.work[view.o + DISTANCE] * across : 0f;
        } else {
            push.x = q[kept + AXIAL];
            push.y = q[kept + ACROSS];
        }
        push.twist = q[kept + ANGULAR];
    }

    // ---- the biased pass
    // -----------------------------------------------------------------------------------------------------

    void solve(int place, int sub) {
        begin(place);
        view.measure(sub);
        view.look(sub);
        if (view.has(JointRow.ELASTIC)) {
            view.lookBack(sub);
        }
        solveTurning();
        if (view.linear() == JointRow.AXIAL) {
            along(true);
        } else if (view.linear() == JointRow.POINT) {
            solvePoint();
        }
    }

    /** Along the line from A to B, with or without bias. */
    private void along(boolean biased) {
        float[] q = states.rows;
        int kept = view.kept;
        float nx = view.work[view.o + NORMAL_X];
        float ny = view.work[view.o + NORMAL_Y];
        float d = view.work[view.o + DISTANCE];
        float v = CircleMath.dot(nx, ny, view.vx, view.vy);
        float sum = 0f;
        if (view.has(JointRow.RIGID) || biased && view.has(JointRow.ELASTIC)) {
            float change = biased ? solveLength(v, d) : relaxAxis(AXIAL, v);
            sum += change;
            v += view.inverse * change;
        }
        if (view.has(JointRow.LOWER)) {
            float before = q[kept + LOWER];
            float next = limit(biased, before, v, d - view.joints.rows[view.row + JointRow.MIN_LENGTH]);
            q[kept + LOWER] = next;
            sum += next - before;
            v += view.inverse * (next - before);
        }
        if (view.has(JointRow.UPPER)) {
            float before = q[kept + UPPER];
            float next = limit(biased, before, -1f * v, view.joints.rows[view.row + JointRow.MAX_LENGTH] - d);
            q[kept + UPPER] = next;
            sum -= next - before;
        }
        push.x = nx * sum;
        push.y = ny * sum;
        if (view.has(JointRow.ACROSS)) {
            across(biased);
        }
    }

    private float solveLength(float v, float d) {
        float nx = view.work[view.o + NORMAL_X];
        float ny = view.work[view.o + NORMAL_Y];
        float begun = CircleMath.dot(nx, ny, view.begunX, view.begunY);
        float change = solveAxis(AXIAL, v, begun, d - view.joints.rows[view.row + JointRow.LENGTH]);
        if (view.isLinearExact()) {
            states.rows[view.kept + SUM_X] += nx * change;
            states.rows[view.kept + SUM_Y] += ny * change;
        }
        return change;
    }

    private float limit(boolean biased, float before, float v, float gap) {
        return biased
                ? JointMath.solvedLimit(
                        before, view.mass, v, gap, view.k.inverseH, view.k.jointSoftness, view.work[view.o + PUSH])
                : JointMath.relaxedLimit(before, view.mass, v, gap, view.k.inverseH);
    }

    private void across(boolean biased) {
        float before = states.rows[view.kept + ACROSS];
        float m = view.acrossMass();
        float v = view.speedAcross();
        float next =
                biased ? hold(before, m, v, view.work[view.o + DIRECTION]) : JointMath.relaxedImpulse(before, m, v);
        states.rows[view.kept + ACROSS] = next;
        float change = next - before;
        push.x -= view.work[view.o + NORMAL_Y] * change;
        push.y += view.work[view.o + NORMAL_X] * change;
        push.both = -0.5f * view.work[view.o + DISTANCE] * change;
    }

    private float hold(float before, float m, float v, float c) {
        return JointMath.heldImpulse(before, m, v, c, view.k.jointSoftness, view.work[view.o + PUSH]);
    }

    /** One axis with bias; returns how much its impulse has changed. An exact spring keeps none. */
    private float solveAxis(int which, float v, float begun, float c) {
        float before = states.rows[view.kept + which];
        if (view.isLinearExact()) {
            return exact(view.springMass(), v, begun, c);
        }
        float next = view.has(JointRow.RIGID) ? hold(before, view.mass, v, c) : implicit(before, view.mass, v, c);
        states.rows[view.kept + which] = next;
        return next - before;
    }

    private float exact(float m, float v, float begun, float c) {
        return JointMath.springImpulse(
                m,
                v,
                begun,
                c,
                view.ofSpring(JointSpring.NOW),
                view.ofSpring(JointSpring.BEGUN),
                view.ofSpring(JointSpring.WAY));
    }

    private float implicit(float before, float m, float v, float c) {
        return JointMath.solvedImpulse(
                before,
                m,
                v,
                c,
                view.ofSpring(JointSpring.MASS_SCALE),
                view.ofSpring(JointSpring.BIAS_RATE),
                view.ofSpring(JointSpring.IMPULSE_SCALE));
    }

    private void solvePoint() {
        float[] q = states.rows;
        float beforeX = q[view.kept + AXIAL];
        float beforeY = q[view.kept + ACROSS];
        float changeX = solveAxis(AXIAL, view.vx, view.begunX, view.work[view.o + NORMAL_X]);
        float changeY = solveAxis(ACROSS, view.vy, view.begunY, view.work[view.o + NORMAL_Y]);
        if (view.isLinearExact()) {
            float share = Velocity.shareWithin(changeX, changeY, greatestImpulse());
            push.x = changeX * share;
            push.y = changeY * share;
            q[view.kept + SUM_X] += push.x;
            q[view.kept + SUM_Y] += push.y;
        } else {
            keepWithin(beforeX, beforeY);
        }
    }

    private float greatestImpulse() {
        return view.joints.rows[view.row + JointRow.MAX_FORCE] * view.k.h;
    }

    /** Cuts a force that is too great, and gives the change. */
    private void keepWithin(float beforeX, float beforeY) {
        float[] q = states.rows;
        int kept = view.kept;
        float share = Velocity.shareWithin(q[kept + AXIAL], q[kept + ACROSS], greatestImpulse());
        q[kept + AXIAL] *= share;
        q[kept + ACROSS] *= share;
        push.x = q[kept + AXIAL] - beforeX;
        push.y = q[kept + ACROSS] - beforeY;
    }

    private void solveTurning() {
        if (view.angular() == 0 || view.angular() == JointRow.TURN_SPEED) {
            return;
        }
        float away = view.turnedAway();
        float before = states.rows[view.kept + ANGULAR];
        Softness soft = view.k.jointSoftness;
        float turnMass = JointMath.jointMass(view.turnA + view.turnB);
        float omega = view.omegaA - view.omegaB;
        if (view.angular() == JointRow.TURN_RIGID) {
            giveTwist(
                    before,
                    JointMath.solvedImpulse(
                            before, turnMass, omega, away, soft.massScale, soft.biasRate, soft.impulseScale));
        } else if (view.isAngularExact()) {
            twist(heldTwist(exact(turnMass, omega, omega, away)));
            states.rows[view.kept + SUM_ANGULAR] += push.twist;
        } else {
            giveTwist(before, implicit(before, turnMass, omega, away));
        }
    }

    private float heldTwist(float impulse) {
        float limit = view.joints.rows[view.row + JointRow.MAX_TORQUE] * view.k.h;
        return CircleMath.clamp(impulse, -limit, limit);
    }

    private void giveTwist(float before, float next) {
        float held = heldTwist(next);
        states.rows[view.kept + ANGULAR] = held;
        twist(held - before);
    }

    private void twist(float impulse) {
        push.twist = impulse;
        view.omegaA += view.turnA * impulse;
        view.omegaB -= view.turnB * impulse;
    }

    // ---- the relaxing pass
    // ---------------------------------------------------------------------------------------------------

    void relax(int place, int sub) {
        begin(place);
        view.measure(sub + 1);
        view.look(sub + 1);
        relaxTurning();
        if (view.linear() == JointRow.AXIAL) {
            along(false);
        } else if (view.linear() == JointRow.DRAG || view.linear() == JointRow.POINT && view.has(JointRow.RIGID)) {
            float beforeX = states.rows[view.kept + AXIAL];
            float beforeY = states.rows[view.kept + ACROSS];
            relaxAxis(AXIAL, view.vx);
            relaxAxis(ACROSS, view.vy);
            keepWithin(beforeX, beforeY);
        }
    }

    private void relaxTurning() {
        if (view.angular() == 0) {
            return;
        }
        float before = states.rows[view.kept + ANGULAR];
        float turnMass = JointMath.jointMass(view.turnA + view.turnB);
        float omega = view.omegaA - view.omegaB;
        if (view.angular() == JointRow.TURN_RIGID) {
            giveTwist(before, JointMath.relaxedImpulse(before, turnMass, omega));
        } else if (view.angular() == JointRow.TURN_SPEED) {
            float speed = view.joints.rows[view.row + JointRow.SPEED];
            giveTwist(before, JointMath.relaxedImpulse(before, turnMass, omega - speed));
        }
    }

    /** One axis without bias; returns how much its impulse has changed. */
    private float relaxAxis(int which, float v) {
        float before = states.rows[view.kept + which];
        float next = JointMath.relaxedImpulse(before, view.mass, v);
        states.rows[view.kept + which] = next;
        return next - before;
    }

    /** Behind the relaxing pass of a joint: adds up the impulses that it keeps, and gives them, as the next sub-step begins with them. */
    void end(int place) {
        begin(place);
        all();
        float[] q = states.rows;
        q[view.kept + SUM_X] += push.x;
        q[view.kept + SUM_Y] += push.y;
        q[view.kept + SUM_ANGULAR] += push.twist;
    }

    /** Whether a joint breaks by what it did in the step. */
    boolean breaks(int place) {
        begin(place);
        float[] q = states.rows;
        float force = CircleMath.length(q[view.kept + SUM_X], q[view.kept + SUM_Y]);
        float torque = Math.abs(q[view.kept + SUM_ANGULAR]);
        return view.has(JointRow.BREAKABLE)
                && (force > view.joints.rows[view.row + JointRow.BREAK_FORCE] * view.k.dt
                        || torque > view.joints.rows[view.row + JointRow.BREAK_TORQUE] * view.k.dt);
    }
}
