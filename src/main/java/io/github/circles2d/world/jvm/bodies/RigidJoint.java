package io.github.circles2d.world.jvm.bodies;

import static io.github.circles2d.world.model.JointState.ACROSS;
import static io.github.circles2d.world.model.JointState.ANGULAR;
import static io.github.circles2d.world.model.JointState.AXIAL;
import static io.github.circles2d.world.model.JointState.LOWER;
import static io.github.circles2d.world.model.JointState.SUM_X;
import static io.github.circles2d.world.model.JointState.SUM_Y;
import static io.github.circles2d.world.model.JointState.UPPER;

import io.github.circles2d.world.jvm.joints.VisitedJoint;
import io.github.circles2d.world.jvm.state.JointStates;
import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.JointMath;
import io.github.circles2d.world.model.JointRow;
import io.github.circles2d.world.model.JointSpring;
import io.github.circles2d.world.model.JointStep;
import io.github.circles2d.world.model.Softness;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.Velocity;

/**
 * A joint that holds rigid bodies, in a step: its visits, by the formulas of {@link JointMath}. What acts in both axes at once, a pin, a weld or friction, solves both
 * together, since an impulse along one of them moves a place on an arm along the other.
 */
final class RigidJoint extends VisitedJoint {
    /** Of a determinant, by the square of the trace: less is rounding, and the place moves along one line alone. */
    private static final float LEAST_DETERMINANT = 1e-6f;

    private final State state;
    int id;
    private final RigidJointEnd a;
    private final RigidJointEnd b;

    // from the base of A to that of B
    private float baseX;
    private float baseY;

    // from A to B, as measured last
    private float normalX;
    private float normalY;
    private float distance;

    /** The greatest speed by which it corrects where its ends are. */
    private float most;

    // ---- of the visit

    /** How far B is from A. */
    private float x;

    private float y;

    /** By what an impulse moves B from A. */
    private float kxx;

    private float kxy;
    private float kyy;

    /** What the visit gives: an impulse on B, and an angular one on A. */
    private float pushX;

    private float pushY;
    private float twist;

    /** How far it is from what it is to keep. */
    private float strain;

    // what the last solution of both axes is
    private float solvedX;
    private float solvedY;

    RigidJoint(State state, RigidPairs pairs) {
        this.state = state;
        a = new RigidJointEnd(state, pairs, 0);
        b = new RigidJointEnd(state, pairs, 1);
    }

    /** Begins a step: measures for the first time, and gives circles what it keeps. */
    void beginStep(JointStep step, JointStates itsStates, StepConstants constants) {
        begin(step, itsStates, constants);
        takeJoint(id);
        a.begin(id, step, constants);
        b.begin(id, step, constants);
        float wayX = b.baseX() - a.baseX();
        float wayY = b.baseY() - a.baseY();
        baseX = state.wraps ? CircleMath.shortWay(wayX, state.periodX) : wayX;
        baseY = state.wraps ? CircleMath.shortWay(wayY, state.periodY) : wayY;
        normalX = 1f;
        normalY = 0f;
        distance = 0f;
        float size = CircleMath.min(a.size(), b.size());
        most = size < Float.POSITIVE_INFINITY ? JointMath.greatestPush(size, k.inverseH) : 0f;
        scale(isExact(0), isExact(0), isExact(JointRow.TURN_ANGLE));
        measure(0);
        all();
        giveNext();
    }

    // ---- what it is

    /** A weld has its place at both ends. */
    private boolean isPoint() {
        return linear() == JointRow.POINT || has(JointRow.ACROSS);
    }

    private boolean isAxial() {
        return linear() == JointRow.AXIAL && !has(JointRow.ACROSS);
    }

    /** Of an exact spring its linear part is one, or its angular part. */
    private boolean isExact(int ofAngular) {
        return angular() == ofAngular && has(JointRow.ELASTIC) && hasExactSpring();
    }

    // ---- where its ends are, and how they move

    /** Measures at a boundary of sub-steps. */
    private void measure(int boundary) {
        a.turn();
        b.turn();
        x = CircleMath.difference(baseX, a.wayX(boundary), b.wayX(boundary));
        y = CircleMath.difference(baseY, a.wayY(boundary), b.wayY(boundary));
        strain = 0f;
        if (isPoint()) {
            strain = has(JointRow.RIGID) ? CircleMath.length(x, y) : 0f;
            if (has(JointRow.RIGID)) {
                b.meet(a, x, y);
                a.meet(b, -x, -y);
            }
        } else if (isAxial()) {
            measureLine();
        }
    }

    private void measureLine() {
        float d = CircleMath.length(x, y);
        if (d > 0f) {
            normalX = x / d;
            normalY = y / d;
        }
        distance = d;
        strain = strain(d);
    }

    private void look(int boundary) {
        vx = b.vx(boundary) - a.vx(boundary);
        vy = b.vy(boundary) - a.vy(boundary);
        float ax = a.armX;
        float ay = a.armY;
        float bx = b.armX;
        float by = b.armY;
        float w = a.ownW + b.ownW;
        kxx = w + (a.ownI * (ay * ay) + b.ownI * (by * by));
        kxy = -1f * (a.ownI * (ax * ay) + b.ownI * (bx * by));
        kyy = w + (a.ownI * (ax * ax) + b.ownI * (bx * bx));
    }

    private void lookBack(int boundary) {
        begunX = b.begunX(boundary) - a.begunX(boundary);
        begunY = b.begunY(boundary) - a.begunY(boundary);
    }

    /** Finds the impulse that changes the velocity of B against A by so much. */
    private void solve(float byX, float byY) {
        float trace = kxx + kyy;
        float determinant = kxx * kyy - kxy * kxy;
        if (determinant > LEAST_DETERMINANT * (trace * trace)) {
            solvedX = (kyy * byX - kxy * byY) / determinant;
            solvedY = (kxx * byY - kxy * byX) / determinant;
        } else if (trace > 0f) {
            solvedX = ((kxx * byX + kxy * byY) / trace) / trace;
            solvedY = ((kxy * byX + kyy * byY) / trace) / trace;
        } else {
            solvedX = 0f;
            solvedY = 0f;
        }
    }

    /** What changes the velocity along a direction. */
    private float inverseAlong(float nx, float ny) {
        return (kxx * nx * nx + 2f * (kxy * nx * ny)) + kyy * ny * ny;
    }

    // ---- impulses

    private void clear() {
        pushX = 0f;
        pushY = 0f;
        twist = 0f;
    }

    /** All impulses that the joint keeps, as what is to be given. */
    private void all() {
        float[] q = states.rows;
        if (isAxial()) {
            float along = (q[kept + AXIAL] + q[kept + LOWER]) - q[kept + UPPER];
            pushX = normalX * along;
            pushY = normalY * along;
        } else {
            pushX = q[kept + AXIAL];
            pushY = q[kept + ACROSS];
        }
        twist = q[kept + ANGULAR];
    }

    private void give() {
        a.push(-1f * pushX, -1f * pushY, twist);
        b.push(pushX, pushY, -1f * twist);
    }

    /** What bodies keep acts again; on circles it has acted before. */
    void warmStart() {
        all();
        a.pushBody(-1f * pushX, -1f * pushY, twist);
        b.pushBody(pushX, pushY, -1f * twist);
    }

    /** Circles begin the next sub-step with it. */
    private void giveNext() {
        a.pushNext(-1f * pushX, -1f * pushY, twist, strain);
        b.pushNext(pushX, pushY, -1f * twist, strain);
    }

    // ---- the biased pass

    /** Visits with bias. */
    void solve(int sub) {
        measure(sub);
        clear();
        if (angular() != 0 && angular() != JointRow.TURN_SPEED) {
            twist = solveTurning(isExact(JointRow.TURN_ANGLE), turnMass(), omega(), away());
        }
        giveTwist();
        look(sub);
        if (has(JointRow.ELASTIC)) {
            lookBack(sub);
        }
        if (isAxial()) {
            solveLine(true);
        } else if (isPoint()) {
            solvePoint();
        }
        give();
    }

    /** Gives what turns at once, since the rest sees it. */
    private void giveTwist() {
        if (twist != 0f) {
            a.push(0f, 0f, twist);
            b.push(0f, 0f, -1f * twist);
            twist = 0f;
        }
    }

    private float turnMass() {
        return JointMath.jointMass(a.ownI + b.ownI);
    }

    private float omega() {
        return a.omega() - b.omega();
    }

    private float away() {
        return turnedAway(a.angle(), a.turned(), b.angle(), b.turned());
    }

    private void solveLine(boolean biased) {
        float nx = normalX;
        float ny = normalY;
        float d = distance;
        inverse = inverseAlong(nx, ny);
        mass = JointMath.jointMass(inverse);
        float sum = along(biased, isExact(0), mass, nx, ny, d, most);
        pushX = nx * sum;
        pushY = ny * sum;
    }

    private void solvePoint() {
        float[] q = states.rows;
        if (isExact(0)) {
            float now = ofSpring(JointSpring.NOW);
            float ofBegun = ofSpring(JointSpring.BEGUN);
            float way = ofSpring(JointSpring.WAY);
            solve((now * vx + ofBegun * begunX) + way * x, (now * vy + ofBegun * begunY) + way * y);
            float changeX = JointMath.keptImpulse(-1f * solvedX);
            float changeY = JointMath.keptImpulse(-1f * solvedY);
            float share = Velocity.shareWithin(changeX, changeY, greatestImpulse());
            pushX = changeX * share;
            pushY = changeY * share;
            q[kept + SUM_X] += pushX;
            q[kept + SUM_Y] += pushY;
            return;
        }
        Softness soft = k.jointSoftness;
        boolean rigid = has(JointRow.RIGID);
        float massScale = rigid ? soft.massScale : ofSpring(JointSpring.MASS_SCALE);
        float rate = rigid ? soft.biasRate : ofSpring(JointSpring.BIAS_RATE);
        float impulseScale = rigid ? soft.impulseScale : ofSpring(JointSpring.IMPULSE_SCALE);
        float share = rigid ? Velocity.shareWithin(rate * x, rate * y, most) : 1f;
        solve(massScale * (vx + share * (rate * x)), massScale * (vy + share * (rate * y)));
        accumulate(impulseScale);
    }

    /** Takes the solution of both axes off the impulses, which leak by a share; gives the change. */
    private void accumulate(float leak) {
        float[] q = states.rows;
        float beforeX = q[kept + AXIAL];
        float beforeY = q[kept + ACROSS];
        float nextX = JointMath.keptImpulse((beforeX - solvedX) - leak * beforeX);
        float nextY = JointMath.keptImpulse((beforeY - solvedY) - leak * beforeY);
        float share = has(JointRow.ACROSS) ? 1f : Velocity.shareWithin(nextX, nextY, greatestImpulse());
        q[kept + AXIAL] = nextX * share;
        q[kept + ACROSS] = nextY * share;
        pushX = q[kept + AXIAL] - beforeX;
        pushY = q[kept + ACROSS] - beforeY;
    }

    // ---- the relaxing pass

    /** Visits without bias; circles begin the next sub-step with what the joint keeps, if there is one. */
    void relax(int sub, boolean last) {
        measure(sub + 1);
        clear();
        if (relaxesTurning()) {
            twist = relaxTurning(turnMass(), omega());
            giveTwist();
        }
        look(sub + 1);
        if (isAxial()) {
            solveLine(false);
        } else if (linear() == JointRow.DRAG || isPoint() && has(JointRow.RIGID)) {
            solve(vx, vy);
            accumulate(0f);
        }
        give();
        all();
        addToSums(pushX, pushY, twist);
        if (!last) {
            giveNext();
        }
    }
}
