package io.github.circles2d.world.jvm.bodies;

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
import io.github.circles2d.world.model.JointState;
import io.github.circles2d.world.model.JointStep;
import io.github.circles2d.world.model.Softness;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.Velocity;

/**
 * The visits of a joint that holds a rigid body, by the formulas of {@link JointMath}. What acts in both axes at once, a pin, a weld or friction, solves both
 * together, since an impulse along one of them moves a place on an arm along the other.
 */
final class RigidJointVisits {
    /** Of a determinant, by the square of the trace: less is rounding, and the place moves along one line alone. */
    private static final float LEAST_DETERMINANT = 1e-6f;

    private final RigidJointEnds ends;

    // within a step
    private JointStep joints;
    private JointStates states;
    private StepConstants k;

    // ---- of the visit

    private int a;
    private int b;
    private int row;
    private int kept;
    private int spring;
    private int form;
    private int traits;

    /** How far B is from A. */
    private float x;

    private float y;

    /** Velocity of B against A, and that as the sub-step began. */
    private float vx;

    private float vy;
    private float begunX;
    private float begunY;

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

    RigidJointVisits(RigidJointEnds ends) {
        this.ends = ends;
    }

    void begin(JointStep step, JointStates itsStates, StepConstants constants) {
        joints = step;
        states = itsStates;
        k = constants;
    }

    // ---- what it is
    // ---------------------------------------------------------------------------------------------------------

    /** Takes a joint, whose ends are e and the one behind it. */
    void take(int joint, int e) {
        a = e;
        b = e + 1;
        row = JointRow.of(joint);
        kept = JointState.of(joint);
        traits = JointRow.traits(joint);
        form = joints.traits[traits + JointRow.FORM];
        spring = JointSpring.of(joints.traits[traits + JointRow.SPRING]);
    }

    private boolean has(int flag) {
        return (form & flag) != 0;
    }

    /** A weld has its place at both ends. */
    private boolean isPoint() {
        return (form & JointRow.LINEAR) == JointRow.POINT || has(JointRow.ACROSS);
    }

    private boolean isAxial() {
        return (form & JointRow.LINEAR) == JointRow.AXIAL && !has(JointRow.ACROSS);
    }

    private boolean isDrag() {
        return (form & JointRow.LINEAR) == JointRow.DRAG;
    }

    private int angular() {
        return form & JointRow.ANGULAR;
    }

    private boolean isExact() {
        return has(JointRow.ELASTIC) && joints.springs[spring + JointSpring.EXACT] != 0f;
    }

    private boolean isLinearExact() {
        return angular() == 0 && isExact();
    }

    private boolean isAngularExact() {
        return angular() == JointRow.TURN_ANGLE && isExact();
    }

    private float value(int which) {
        return joints.rows[row + which];
    }

    private float spring(int which) {
        return joints.springs[spring + which];
    }

    /** Scales the impulses of the step before. */
    void scale() {
        float[] q = states.rows;
        q[kept + AXIAL] *= k.warmScale;
        q[kept + ACROSS] *= k.warmScale;
        q[kept + LOWER] *= k.warmScale;
        q[kept + UPPER] *= k.warmScale;
        q[kept + ANGULAR] *= k.warmScale;
        if (isLinearExact()) {
            q[kept + AXIAL] = 0f;
            q[kept + ACROSS] = 0f;
        }
        if (isAngularExact()) {
            q[kept + ANGULAR] = 0f;
        }
        q[kept + SUM_X] = 0f;
        q[kept + SUM_Y] = 0f;
        q[kept + SUM_ANGULAR] = 0f;
    }

    // ---- where its ends are, and how they move
    // ------------------------------------------------------------------------------

    /** Measures at a boundary of sub-steps; work: the base, and the normal of the last time. */
    void measure(int boundary, float[] work, int o) {
        ends.turn(a);
        ends.turn(b);
        x = CircleMath.difference(work[o + RigidJoints.BASE_X], ends.wayX(a, boundary), ends.wayX(b, boundary));
        y = CircleMath.difference(work[o + RigidJoints.BASE_Y], ends.wayY(a, boundary), ends.wayY(b, boundary));
        strain = 0f;
        if (isPoint()) {
            strain = has(JointRow.RIGID) ? CircleMath.length(x, y) : 0f;
            if (has(JointRow.RIGID)) {
                ends.meet(a, x, y);
            }
        } else if (isAxial()) {
            measureLine(work, o);
        }
    }

    private void measureLine(float[] work, int o) {
        float d = CircleMath.length(x, y);
        if (d > 0f) {
            work[o + RigidJoints.NORMAL_X] = x / d;
            work[o + RigidJoints.NORMAL_Y] = y / d;
        }
        work[o + RigidJoints.DISTANCE] = d;
        strain = has(JointRow.RIGID) ? Math.abs(d - value(JointRow.LENGTH)) : 0f;
        strain = has(JointRow.LOWER) ? CircleMath.max(value(JointRow.MIN_LENGTH) - d, strain) : strain;
        strain = has(JointRow.UPPER) ? CircleMath.max(d - value(JointRow.MAX_LENGTH), strain) : strain;
    }

    private void look(int boundary) {
        vx = ends.vx(b, boundary) - ends.vx(a, boundary);
        vy = ends.vy(b, boundary) - ends.vy(a, boundary);
        float ax = ends.arm[0][a];
        float ay = ends.arm[1][a];
        float bx = ends.arm[0][b];
        float by = ends.arm[1][b];
        float w = ends.ownW[a] + ends.ownW[b];
        kxx = w + (ends.ownI[a] * (ay * ay) + ends.ownI[b] * (by * by));
        kxy = -1f * (ends.ownI[a] * (ax * ay) + ends.ownI[b] * (bx * by));
        kyy = w + (ends.ownI[a] * (ax * ax) + ends.ownI[b] * (bx * bx));
    }

    private void lookBack(int boundary) {
        begunX = ends.begunX(b, boundary) - ends.begunX(a, boundary);
        begunY = ends.begunY(b, boundary) - ends.begunY(a, boundary);
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
    private float along(float nx, float ny) {
        return (kxx * nx * nx + 2f * (kxy * nx * ny)) + kyy * ny * ny;
    }

    // ---- impulses
    // -----------------------------------------------------------------------------------------------------------

    private void clear() {
        pushX = 0f;
        pushY = 0f;
        twist = 0f;
    }

    /** All impulses that the joint keeps, as what is to be given. */
    void all(float[] work, int o) {
        float[] q = states.rows;
        if (isAxial()) {
            float along = (q[kept + AXIAL] + q[kept + LOWER]) - q[kept + UPPER];
            pushX = work[o + RigidJoints.NORMAL_X] * along;
            pushY = work[o + RigidJoints.NORMAL_Y] * along;
        } else {
            pushX = q[kept + AXIAL];
            pushY = q[kept + ACROSS];
        }
        twist = q[kept + ANGULAR];
    }

    void give() {
        ends.push(a, -1f * pushX, -1f * pushY, twist);
        ends.push(b, pushX, pushY, -1f * twist);
    }

    void giveToBodies() {
        ends.pushBody(a, -1f * pushX, -1f * pushY, twist);
        ends.pushBody(b, pushX, pushY, -1f * twist);
    }

    /** Circles begin the next sub-step with it. */
    void giveNext() {
        ends.pushNext(a, -1f * pushX, -1f * pushY, twist, strain);
        ends.pushNext(b, pushX, pushY, -1f * twist, strain);
    }

    void addToSums() {
        float[] q = states.rows;
        q[kept + SUM_X] += pushX;
        q[kept + SUM_Y] += pushY;
        q[kept + SUM_ANGULAR] += twist;
    }

    // ---- the biased pass
    // ----------------------------------------------------------------------------------------------------

    /** With bias; the joint has been measured. */
    void solve(int sub, float[] work, int o) {
        clear();
        if (angular() != 0 && angular() != JointRow.TURN_SPEED) {
            solveTurning();
        }
        giveTwist();
        look(sub);
        if (has(JointRow.ELASTIC)) {
            lookBack(sub);
        }
        if (isAxial()) {
            solveLine(true, work, o);
        } else if (isPoint()) {
            solvePoint(work, o);
        }
        give();
    }

    /** Gives what turns at once, since the rest sees it. */
    private void giveTwist() {
        if (twist != 0f) {
            ends.push(a, 0f, 0f, twist);
            ends.push(b, 0f, 0f, -1f * twist);
            twist = 0f;
        }
    }

    private void solveLine(boolean biased, float[] work, int o) {
        float[] q = states.rows;
        float nx = work[o + RigidJoints.NORMAL_X];
        float ny = work[o + RigidJoints.NORMAL_Y];
        float d = work[o + RigidJoints.DISTANCE];
        float most = work[o + RigidJoints.PUSH];
        float inverse = along(nx, ny);
        float m = JointMath.jointMass(inverse);
        float v = CircleMath.dot(nx, ny, vx, vy);
        float sum = 0f;
        if (has(JointRow.RIGID) || biased && has(JointRow.ELASTIC)) {
            float change = biased ? solveLength(m, v, d, nx, ny, most) : relaxAxis(m, v);
            sum += change;
            v += inverse * change;
        }
        if (has(JointRow.LOWER)) {
            float before = q[kept + LOWER];
            float next = limit(biased, before, m, v, d - value(JointRow.MIN_LENGTH), most);
            q[kept + LOWER] = next;
            sum += next - before;
            v += inverse * (next - before);
        }
        if (has(JointRow.UPPER)) {
            float before = q[kept + UPPER];
            float next = limit(biased, before, m, -1f * v, value(JointRow.MAX_LENGTH) - d, most);
            q[kept + UPPER] = next;
            sum -= next - before;
        }
        pushX = nx * sum;
        pushY = ny * sum;
    }

    private float solveLength(float m, float v, float d, float nx, float ny, float most) {
        float before = states.rows[kept + AXIAL];
        float c = d - value(JointRow.LENGTH);
        if (isLinearExact()) {
            float change = exact(m, v, CircleMath.dot(nx, ny, begunX, begunY), c);
            states.rows[kept + SUM_X] += nx * change;
            states.rows[kept + SUM_Y] += ny * change;
            return change;
        }
        float next = has(JointRow.RIGID)
                ? JointMath.heldImpulse(before, m, v, c, k.jointSoftness, most)
                : implicit(before, m, v, c);
        states.rows[kept + AXIAL] = next;
        return next - before;
    }

    private float relaxAxis(float m, float v) {
        float before = states.rows[kept + AXIAL];
        float next = JointMath.relaxedImpulse(before, m, v);
        states.rows[kept + AXIAL] = next;
        return next - before;
    }

    private float limit(boolean biased, float before, float m, float v, float gap, float most) {
        return biased
                ? JointMath.solvedLimit(before, m, v, gap, k.inverseH, k.jointSoftness, most)
                : JointMath.relaxedLimit(before, m, v, gap, k.inverseH);
    }

    private float exact(float m, float v, float begun, float c) {
        return JointMath.springImpulse(
                m, v, begun, c, spring(JointSpring.NOW), spring(JointSpring.BEGUN), spring(JointSpring.WAY));
    }

    private float implicit(float before, float m, float v, float c) {
        return JointMath.solvedImpulse(
                before,
                m,
                v,
                c,
                spring(JointSpring.MASS_SCALE),
                spring(JointSpring.BIAS_RATE),
                spring(JointSpring.IMPULSE_SCALE));
    }

    private void solvePoint(float[] work, int o) {
        float[] q = states.rows;
        if (isLinearExact()) {
            float now = spring(JointSpring.NOW);
            float ofBegun = spring(JointSpring.BEGUN);
            float way = spring(JointSpring.WAY);
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
        float massScale = rigid ? soft.massScale : spring(JointSpring.MASS_SCALE);
        float rate = rigid ? soft.biasRate : spring(JointSpring.BIAS_RATE);
        float impulseScale = rigid ? soft.impulseScale : spring(JointSpring.IMPULSE_SCALE);
        float share = rigid ? Velocity.shareWithin(rate * x, rate * y, work[o + RigidJoints.PUSH]) : 1f;
        solve(massScale * (vx + share * (rate * x)), massScale * (vy + share * (rate * y)));
        accumulate(impulseScale);
    }

    private float greatestImpulse() {
        return value(JointRow.MAX_FORCE) * k.h;
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

    private void solveTurning() {
        float away = JointMath.turnedAway(
                ends.angle(a),
                joints.traits[traits + JointRow.REFERENCE_A],
                ends.turned(a),
                ends.angle(b),
                joints.traits[traits + JointRow.REFERENCE_B],
                ends.turned(b));
        float before = states.rows[kept + ANGULAR];
        Softness soft = k.jointSoftness;
        float m = JointMath.jointMass(ends.ownI[a] + ends.ownI[b]);
        float omega = ends.omega(a) - ends.omega(b);
        if (angular() == JointRow.TURN_RIGID) {
            turnBy(
                    before,
                    JointMath.solvedImpulse(before, m, omega, away, soft.massScale, soft.biasRate, soft.impulseScale));
        } else if (isAngularExact()) {
            twist = held(exact(m, omega, omega, away));
            states.rows[kept + SUM_ANGULAR] += twist;
        } else {
            turnBy(before, implicit(before, m, omega, away));
        }
    }

    private float held(float impulse) {
        float limit = value(JointRow.MAX_TORQUE) * k.h;
        return CircleMath.clamp(impulse, -limit, limit);
    }

    private void turnBy(float before, float next) {
        float held = held(next);
        states.rows[kept + ANGULAR] = held;
        twist = held - before;
    }

    // ---- the relaxing pass
    // --------------------------------------------------------------------------------------------------

    /** Without bias; the joint has been measured. */
    void relax(int sub, float[] work, int o) {
        clear();
        if (angular() == JointRow.TURN_RIGID || angular() == JointRow.TURN_SPEED) {
            float before = states.rows[kept + ANGULAR];
            float m = JointMath.jointMass(ends.ownI[a] + ends.ownI[b]);
            float speed = angular() == JointRow.TURN_SPEED ? value(JointRow.SPEED) : 0f;
            turnBy(before, JointMath.relaxedImpulse(before, m, (ends.omega(a) - ends.omega(b)) - speed));
            giveTwist();
        }
        look(sub + 1);
        if (isAxial()) {
            solveLine(false, work, o);
        } else if (isDrag() || isPoint() && has(JointRow.RIGID)) {
            solve(vx, vy);
            accumulate(0f);
        }
        give();
    }

    /** Whether the joint breaks by what it did in the step. */
    boolean breaks() {
        float[] q = states.rows;
        float force = CircleMath.length(q[kept + SUM_X], q[kept + SUM_Y]);
        float torque = Math.abs(q[kept + SUM_ANGULAR]);
        return has(JointRow.BREAKABLE)
                && (force > value(JointRow.BREAK_FORCE) * k.dt || torque > value(JointRow.BREAK_TORQUE) * k.dt);
    }
}
