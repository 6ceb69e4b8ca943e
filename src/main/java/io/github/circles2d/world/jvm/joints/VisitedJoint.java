package io.github.circles2d.world.jvm.joints;

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

/**
 * The joint of a visit, whatever is at its ends: what it is, what it keeps, and what its parts do. {@link JointMath} has the formulas. Who extends it
 * measures its ends.
 */
public class VisitedJoint {
    protected JointStep joints;
    protected JointStates states;
    protected StepConstants k;

    // rows of the joint
    protected int row;
    protected int traits;
    protected int kept;
    private int form;
    private int spring;

    /** Velocity of B against A, and that as the sub-step began. */
    protected float vx;

    protected float vy;
    protected float begunX;
    protected float begunY;

    /** One over the effective mass along the axis, as the visit sees it, and that mass. */
    protected float inverse;

    protected float mass;

    protected VisitedJoint() {}

    public final void begin(JointStep step, JointStates itsStates, StepConstants constants) {
        joints = step;
        states = itsStates;
        k = constants;
    }

    protected final void takeJoint(int joint) {
        row = JointRow.of(joint);
        traits = JointRow.traits(joint);
        kept = JointState.of(joint);
        form = joints.traits[traits + JointRow.FORM];
        spring = JointSpring.of(joints.traits[traits + JointRow.SPRING]);
    }

    protected final boolean has(int flag) {
        return (form & flag) != 0;
    }

    protected final int linear() {
        return form & JointRow.LINEAR;
    }

    protected final int angular() {
        return form & JointRow.ANGULAR;
    }

    protected final float value(int which) {
        return joints.rows[row + which];
    }

    protected final float ofSpring(int word) {
        return joints.springs[spring + word];
    }

    protected final boolean hasExactSpring() {
        return ofSpring(JointSpring.EXACT) != 0f;
    }

    /** Scales the impulses of the step before. Those of exact springs are not kept. */
    protected final void scale(boolean exactAxis, boolean exactAcross, boolean exactTurning) {
        float[] q = states.rows;
        q[kept + AXIAL] = exactAxis ? 0f : q[kept + AXIAL] * k.warmScale;
        q[kept + ACROSS] = exactAcross ? 0f : q[kept + ACROSS] * k.warmScale;
        q[kept + LOWER] *= k.warmScale;
        q[kept + UPPER] *= k.warmScale;
        q[kept + ANGULAR] = exactTurning ? 0f : q[kept + ANGULAR] * k.warmScale;
        q[kept + SUM_X] = 0f;
        q[kept + SUM_Y] = 0f;
        q[kept + SUM_ANGULAR] = 0f;
    }

    /** How far an axis is from what it is to keep, of which B is so far from A; springs keep nothing. */
    protected final float strain(float d) {
        float strain = has(JointRow.RIGID) ? Math.abs(d - value(JointRow.LENGTH)) : 0f;
        strain = has(JointRow.LOWER) ? CircleMath.max(value(JointRow.MIN_LENGTH) - d, strain) : strain;
        return has(JointRow.UPPER) ? CircleMath.max(d - value(JointRow.MAX_LENGTH), strain) : strain;
    }

    // ---- along axes

    /**
     * Visits the axis from A to B, with or without bias, and its limits; returns the impulse. exactly: of an exact spring, whose effective mass may be
     * another one; most: the greatest speed of push-outs.
     */
    protected final float along(
            boolean biased, boolean exactly, float springMass, float nx, float ny, float d, float most) {
        float[] q = states.rows;
        float v = CircleMath.dot(nx, ny, vx, vy);
        float sum = 0f;
        if (has(JointRow.RIGID) || biased && has(JointRow.ELASTIC)) {
            float change;
            if (!biased) {
                change = relaxAxis(AXIAL, v);
            } else if (exactly) {
                change = exact(springMass, v, CircleMath.dot(nx, ny, begunX, begunY), d - value(JointRow.LENGTH));
                q[kept + SUM_X] += nx * change;
                q[kept + SUM_Y] += ny * change;
            } else {
                change = solveAxis(AXIAL, v, d - value(JointRow.LENGTH), most);
            }
            sum += change;
            v += inverse * change;
        }
        if (has(JointRow.LOWER)) {
            float before = q[kept + LOWER];
            float next = limit(biased, before, v, d - value(JointRow.MIN_LENGTH), most);
            q[kept + LOWER] = next;
            sum += next - before;
            v += inverse * (next - before);
        }
        if (has(JointRow.UPPER)) {
            float before = q[kept + UPPER];
            float next = limit(biased, before, -1f * v, value(JointRow.MAX_LENGTH) - d, most);
            q[kept + UPPER] = next;
            sum -= next - before;
        }
        return sum;
    }

    private float limit(boolean biased, float before, float v, float gap, float most) {
        return biased
                ? JointMath.solvedLimit(before, mass, v, gap, k.inverseH, k.jointSoftness, most)
                : JointMath.relaxedLimit(before, mass, v, gap, k.inverseH);
    }

    /** One axis with bias that is no exact spring; returns how much its impulse has changed. */
    protected final float solveAxis(int which, float v, float c, float most) {
        float before = states.rows[kept + which];
        float next = has(JointRow.RIGID)
                ? JointMath.heldImpulse(before, mass, v, c, k.jointSoftness, most)
                : implicit(before, mass, v, c);
        states.rows[kept + which] = next;
        return next - before;
    }

    /** One axis without bias; returns how much its impulse has changed. */
    protected final float relaxAxis(int which, float v) {
        float before = states.rows[kept + which];
        float next = JointMath.relaxedImpulse(before, mass, v);
        states.rows[kept + which] = next;
        return next - before;
    }

    protected final float exact(float m, float v, float begun, float c) {
        return JointMath.springImpulse(
                m, v, begun, c, ofSpring(JointSpring.NOW), ofSpring(JointSpring.BEGUN), ofSpring(JointSpring.WAY));
    }

    private float implicit(float before, float m, float v, float c) {
        return JointMath.solvedImpulse(
                before,
                m,
                v,
                c,
                ofSpring(JointSpring.MASS_SCALE),
                ofSpring(JointSpring.BIAS_RATE),
                ofSpring(JointSpring.IMPULSE_SCALE));
    }

    protected final float greatestImpulse() {
        return value(JointRow.MAX_FORCE) * k.h;
    }

    // ---- turning

    /** How far A has turned against B, in radians, from angles in units as the step began, and what they have turned since. */
    protected final float turnedAway(int angleA, float turnedA, int angleB, float turnedB) {
        return JointMath.turnedAway(
                angleA,
                joints.traits[traits + JointRow.REFERENCE_A],
                turnedA,
                angleB,
                joints.traits[traits + JointRow.REFERENCE_B],
                turnedB);
    }

    /** With bias, of a joint that holds angles; returns the angular impulse on A. */
    protected final float solveTurning(boolean exactly, float turnMass, float omega, float away) {
        float before = states.rows[kept + ANGULAR];
        Softness soft = k.jointSoftness;
        if (angular() == JointRow.TURN_RIGID) {
            return twistTo(
                    before,
                    JointMath.solvedImpulse(
                            before, turnMass, omega, away, soft.massScale, soft.biasRate, soft.impulseScale));
        }
        if (exactly) {
            float twist = held(exact(turnMass, omega, omega, away));
            states.rows[kept + SUM_ANGULAR] += twist;
            return twist;
        }
        return twistTo(before, implicit(before, turnMass, omega, away));
    }

    /** Whether it turns its ends without bias. */
    protected final boolean relaxesTurning() {
        return angular() == JointRow.TURN_RIGID || angular() == JointRow.TURN_SPEED;
    }

    /** Without bias; returns the angular impulse on A. */
    protected final float relaxTurning(float turnMass, float omega) {
        float before = states.rows[kept + ANGULAR];
        float speed = angular() == JointRow.TURN_SPEED ? value(JointRow.SPEED) : 0f;
        return twistTo(before, JointMath.relaxedImpulse(before, turnMass, omega - speed));
    }

    private float held(float impulse) {
        float limit = value(JointRow.MAX_TORQUE) * k.h;
        return CircleMath.clamp(impulse, -limit, limit);
    }

    private float twistTo(float before, float next) {
        float held = held(next);
        states.rows[kept + ANGULAR] = held;
        return held - before;
    }

    // ---- sums

    /** Adds what the joint gives to what it has given in the step. */
    protected final void addToSums(float x, float y, float twist) {
        states.rows[kept + SUM_X] += x;
        states.rows[kept + SUM_Y] += y;
        states.rows[kept + SUM_ANGULAR] += twist;
    }

    /** Whether the joint breaks by what it did in the step. */
    public final boolean breaks() {
        float[] q = states.rows;
        float force = CircleMath.length(q[kept + SUM_X], q[kept + SUM_Y]);
        float torque = Math.abs(q[kept + SUM_ANGULAR]);
        return has(JointRow.BREAKABLE)
                && (force > value(JointRow.BREAK_FORCE) * k.dt || torque > value(JointRow.BREAK_TORQUE) * k.dt);
    }
}
