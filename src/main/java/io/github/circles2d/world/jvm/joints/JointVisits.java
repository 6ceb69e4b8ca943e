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
import static io.github.circles2d.world.model.JointState.UPPER;

import io.github.circles2d.world.jvm.state.JointStates;
import io.github.circles2d.world.model.JointMath;
import io.github.circles2d.world.model.JointRow;
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
        float nx = view.work[view.o + NORMAL_X];
        float ny = view.work[view.o + NORMAL_Y];
        boolean exact = view.isLinearExact();
        float springMass = exact ? view.springMass() : 0f;
        float most = view.work[view.o + PUSH];
        float sum = view.along(biased, exact, springMass, nx, ny, view.work[view.o + DISTANCE], most);
        push.x = nx * sum;
        push.y = ny * sum;
        if (view.has(JointRow.ACROSS)) {
            across(biased);
        }
    }

    private void across(boolean biased) {
        float before = states.rows[view.kept + ACROSS];
        float m = view.acrossMass();
        float v = view.speedAcross();
        float[] w = view.work;
        float next = biased
                ? JointMath.heldImpulse(before, m, v, w[view.o + DIRECTION], view.k.jointSoftness, w[view.o + PUSH])
                : JointMath.relaxedImpulse(before, m, v);
        states.rows[view.kept + ACROSS] = next;
        float change = next - before;
        push.x -= view.work[view.o + NORMAL_Y] * change;
        push.y += view.work[view.o + NORMAL_X] * change;
        push.both = -0.5f * view.work[view.o + DISTANCE] * change;
    }

    private void solvePoint() {
        float[] w = view.work;
        if (view.isLinearExact()) {
            float m = view.springMass();
            float changeX = view.exact(m, view.vx, view.begunX, w[view.o + NORMAL_X]);
            float changeY = view.exact(m, view.vy, view.begunY, w[view.o + NORMAL_Y]);
            float share = Velocity.shareWithin(changeX, changeY, view.greatestImpulse());
            push.x = changeX * share;
            push.y = changeY * share;
            view.addToSums(push.x, push.y, 0f);
        } else {
            float beforeX = states.rows[view.kept + AXIAL];
            float beforeY = states.rows[view.kept + ACROSS];
            view.solveAxis(AXIAL, view.vx, w[view.o + NORMAL_X], w[view.o + PUSH]);
            view.solveAxis(ACROSS, view.vy, w[view.o + NORMAL_Y], w[view.o + PUSH]);
            keepWithin(beforeX, beforeY);
        }
    }

    /** Cuts a force that is too great, and gives the change. */
    private void keepWithin(float beforeX, float beforeY) {
        float[] q = states.rows;
        int kept = view.kept;
        float share = Velocity.shareWithin(q[kept + AXIAL], q[kept + ACROSS], view.greatestImpulse());
        q[kept + AXIAL] *= share;
        q[kept + ACROSS] *= share;
        push.x = q[kept + AXIAL] - beforeX;
        push.y = q[kept + ACROSS] - beforeY;
    }

    private void solveTurning() {
        if (view.angular() != 0 && view.angular() != JointRow.TURN_SPEED) {
            float turnMass = JointMath.jointMass(view.turnA + view.turnB);
            float omega = view.omegaA - view.omegaB;
            twist(view.solveTurning(view.isAngularExact(), turnMass, omega, view.turnedAway()));
        }
    }

    private void twist(float impulse) {
        push.twist = impulse;
        view.omegaA += view.turnA * impulse;
        view.omegaB -= view.turnB * impulse;
    }

    // ---- the relaxing pass

    void relax(int place, int sub) {
        begin(place);
        view.measure(sub + 1);
        view.look(sub + 1);
        if (view.relaxesTurning()) {
            twist(view.relaxTurning(JointMath.jointMass(view.turnA + view.turnB), view.omegaA - view.omegaB));
        }
        if (view.linear() == JointRow.AXIAL) {
            along(false);
        } else if (view.linear() == JointRow.DRAG || view.linear() == JointRow.POINT && view.has(JointRow.RIGID)) {
            float beforeX = states.rows[view.kept + AXIAL];
            float beforeY = states.rows[view.kept + ACROSS];
            view.relaxAxis(AXIAL, view.vx);
            view.relaxAxis(ACROSS, view.vy);
            keepWithin(beforeX, beforeY);
        }
    }

    /** Behind the relaxing pass of a joint: adds up the impulses that it keeps, and gives them, as the next sub-step begins with them. */
    void end(int place) {
        begin(place);
        all();
        view.addToSums(push.x, push.y, push.twist);
    }

    /** Whether a joint breaks by what it did in the step. */
    boolean breaks(int place) {
        begin(place);
        return view.breaks();
    }
}
