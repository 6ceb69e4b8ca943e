package io.github.circles2d.reference;

import static io.github.circles2d.reference.Numbers.clamp;
import static io.github.circles2d.reference.Numbers.dot;
import static io.github.circles2d.reference.Numbers.length;
import static io.github.circles2d.reference.Numbers.max;
import static io.github.circles2d.reference.Numbers.min;
import static io.github.circles2d.reference.Numbers.minus;
import static io.github.circles2d.reference.Numbers.plus;

import io.github.circles2d.reference.ReferenceJoint.Angular;
import io.github.circles2d.reference.ReferenceJoint.Linear;

/** A joint within a step, in which it has not broken. What it gives are an impulse on B, an angular one on A, and one that both get. */
final class JointVisit {
    private static final float GREATEST_IMPULSE = 1e20f;
    private static final float STRAIN = 0.1f;
    private static final float PUSH = 0.2f;
    private static final float[] NOTHING = {0f, 0f};
    private static final float RADIANS_PER_UNIT = 1.4629181e-9f;
    private static final float UNITS_PER_RADIAN = 683565275.576f;
    private static final float GREATEST_UNITS = 0x1p62f;

    final ReferenceJoint joint;
    private final StepParameters k;
    private final Circle a;
    private final Circle b;
    private final JointSpring spring;
    private final JointSoftness rigid;

    /** How its anchor moves; null if it is at rest. */
    private final AnchorMotion anchor;

    private final float[] between;

    private float[] normal = {1f, 0f};

    /** From A to B. */
    private float[] offset;

    private float distance;
    private float direction;

    // the speeds of a visit
    private float[] velocity;
    private float[] begun;
    private float inverse;

    // angular ones, and what an angular impulse adds to them
    private float omegaA;
    private float omegaB;
    private float turnA;
    private float turnB;

    // what the visit gives
    private float[] push = NOTHING;
    private float twist;
    private float both;

    /** Scales the impulses of the step before. */
    JointVisit(ReferenceJoint joint, StepParameters k, float warmScale) {
        this.joint = joint;
        this.k = k;
        a = joint.a;
        b = joint.b;
        spring = JointSpring.of(joint.frequency, joint.damping, k.h());
        rigid = JointSoftness.ofRigid(k);
        anchor = b == null ? joint.anchorMotion(k) : null;
        between = b == null ? k.arena().way(a.base, joint.anchorPlace(k.arena())) : a.wayTo(b);
        joint.along *= warmScale;
        joint.across *= warmScale;
        joint.least *= warmScale;
        joint.greatest *= warmScale;
        joint.turning *= warmScale;
        if (isExact()) {
            forgetImpulses();
        }
        joint.sum[0] = 0f;
        joint.sum[1] = 0f;
        joint.sumOfTurning = 0f;
    }

    /** Whether it has a spring, and an exact one, whose impulses are not kept. */
    private boolean isExact() {
        return joint.isElastic() && spring.exact();
    }

    /** Whether it does something without bias. */
    boolean relaxes() {
        return !isExact() || joint.hasLeast || joint.hasGreatest;
    }

    boolean isSplit() {
        return joint.colour == ReferenceJoints.SPLIT;
    }

    private boolean turns() {
        return joint.turns();
    }

    private boolean isAlong() {
        return joint.linear == Linear.ALONG;
    }

    // ---- what it knows of its ends

    private void measure(int boundary) {
        float[] to = b != null ? b.displacement : anchor == null ? NOTHING : anchor.ways()[boundary];
        offset = plus(between, minus(to, a.displacement));
        distance = length(offset);
        if (isAlong() && distance > 0f) {
            normal = new float[] {offset[0] / distance, offset[1] / distance};
        }
        if (joint.keepsDirection) {
            int turn = meanTurn();
            float cos = sine(turn + (1 << 30));
            float sin = sine(turn);
            float[] d = joint.direction;
            direction = (cos * d[0] - sin * d[1]) * offset[1] - (sin * d[0] + cos * d[1]) * offset[0];
        }
    }

    private int unitsOf(Circle c, int reference) {
        return (c == null ? 0 : c.angle) - reference;
    }

    /** In this step, in radians. */
    private float turned(Circle c) {
        return c == null ? 0f : c.turn.turned() * k.h() / c.radius;
    }

    /** How far A has turned against B, in radians. */
    private float turnedAway() {
        int units = unitsOf(a, joint.referenceOfA) - unitsOf(b, joint.referenceOfB);
        return (float) units * RADIANS_PER_UNIT + (turned(a) - turned(b));
    }

    private int meanTurn() {
        int ofA = unitsOf(a, joint.referenceOfA);
        int ofB = unitsOf(b, joint.referenceOfB);
        float half = 0.5f * (turned(a) + turned(b)) * UNITS_PER_RADIAN;
        return ofB + ((ofA - ofB) >> 1) + (int) (long) clamp(half, -GREATEST_UNITS, GREATEST_UNITS);
    }

    /** Of an angle in units, in single precision. */
    private static float sine(int units) {
        int quarter = (units + (1 << 29)) >> 30;
        float x = (float) (units - (quarter << 30)) * RADIANS_PER_UNIT;
        float z = x * x;
        float near = x + x * (z * (-1.6666667e-1f + z * (8.3333310e-3f + z * -1.9840874e-4f)));
        float far = 1f - z * (0.5f - z * (4.1666666e-2f + z * (-1.3888397e-3f + z * 2.4760495e-5f)));
        float value = Math.floorMod(quarter, 2) == 0 ? near : far;
        return Math.floorMod(quarter, 4) < 2 ? value : -1f * value;
    }

    private static float radius(Circle c) {
        return c == null ? 1f : c.radius;
    }

    private static float surfaceSpeed(Circle c) {
        return c == null ? 0f : c.turn.speed;
    }

    /** Also of one that sleeps, which is pulled as if it would give way. */
    private static float inverseMass(Circle c) {
        return c == null ? 0f : c.ownInverseMass();
    }

    private static float inverseInertia(Circle c) {
        return c == null ? 0f : c.turn.ownInverseInertia;
    }

    private float[] velocityOfAnchor(int boundary) {
        return anchor == null ? NOTHING : anchor.velocities()[boundary];
    }

    private void look(int boundary) {
        velocity = minus(b != null ? b.velocity : velocityOfAnchor(boundary), a.velocity);
        float shareA = isSplit() ? a.splitJoints : 1f;
        float shareB = isSplit() && b != null ? b.splitJoints : 1f;
        inverse = shareA * inverseMass(a) + shareB * inverseMass(b);
        if (turns()) {
            float ofA = radius(a);
            float ofB = radius(b);
            omegaA = surfaceSpeed(a) / ofA;
            omegaB = surfaceSpeed(b) / ofB;
            turnA = shareA * (inverseInertia(a) / (ofA * ofA));
            turnB = shareB * (inverseInertia(b) / (ofB * ofB));
        }
    }

    /** The velocity of B against A as the sub-step began. */
    private void lookBack(int boundary) {
        begun = minus(b != null ? begun(b) : velocityOfAnchor(boundary), begun(a));
    }

    private static float[] begun(Circle c) {
        return minus(c.velocityBeforeImpulses, c.isStatic() ? NOTHING : c.gain);
    }

    /** The greatest speed by which it corrects. */
    private float most() {
        return PUSH * (b == null ? a.radius : min(a.radius, b.radius)) * k.inverseH();
    }

    /** One over a sum of inverse masses. */
    private static float mass(float sum) {
        return sum > 0f ? 1f / sum : 0f;
    }

    /** Circles are loaded in the next sub-step if they are farther than a share of their radii from what they are held to. */
    private void loadCircles() {
        float strain = strain();
        a.loadedNext |= strain > STRAIN * a.radius;
        if (b != null) {
            b.loadedNext |= strain > STRAIN * b.radius;
        }
    }

    private float strain() {
        if (joint.linear == Linear.POINT) {
            return joint.rigid ? length(offset) : 0f;
        }
        float strain = joint.rigid ? Math.abs(distance - joint.length) : 0f;
        strain = joint.hasLeast ? Numbers.max(joint.leastLength - distance, strain) : strain;
        return joint.hasGreatest ? Numbers.max(distance - joint.greatestLength, strain) : strain;
    }

    // ---- impulses

    private static float kept(float impulse) {
        return clamp(impulse, -GREATEST_IMPULSE, GREATEST_IMPULSE);
    }

    private static float relaxed(float impulse, float m, float v) {
        return kept(impulse - m * v);
    }

    private float bySpring(float impulse, float m, float v, float vBegun, float way) {
        return spring.exact()
                ? kept(-1f * (m * ((spring.now() * v + spring.begun() * vBegun) + spring.way() * way)))
                : spring.soft().solve(impulse, m, v, way);
    }

    private float springMass() {
        float sum = springShare(a) * inverseMass(a);
        return mass(sum + (b == null ? 1f : springShare(b)) * inverseMass(b));
    }

    private float springShare(Circle c) {
        return isSplit() ? max(spring.split() * c.splitJoints, 1f) : 1f;
    }

    private float byAxis(float impulse, float v, float vBegun, float way) {
        float m = mass(inverse);
        return joint.rigid
                ? rigid.hold(impulse, m, v, way, most())
                : bySpring(impulse, spring.exact() ? springMass() : m, v, vBegun, way);
    }

    /** At a limit, from which B is away by a gap. */
    private float byLimit(boolean biased, float impulse, float v, float gap) {
        float m = mass(inverse);
        float next = impulse - m * (gap > 0f ? v + gap * k.inverseH() : v);
        if (biased && gap <= 0f) {
            next = rigid.held(impulse, m, v, gap, most());
        }
        return clamp(next, 0f, GREATEST_IMPULSE);
    }

    /** Begins what it gives with all its impulses. */
    private void giveAll() {
        if (isAlong()) {
            float along = (joint.along + joint.least) - joint.greatest;
            push = new float[] {
                normal[0] * along - normal[1] * joint.across, normal[1] * along + normal[0] * joint.across
            };
        } else {
            push = new float[] {joint.along, joint.across};
        }
        both = joint.keepsDirection ? -0.5f * distance * joint.across : 0f;
        twist = joint.turning;
    }

    private void giveNothing() {
        push = new float[2];
        twist = 0f;
        both = 0f;
    }

    void prepare() {
        measure(0);
        loadCircles();
        giveAll();
    }

    void solve(int subStep) {
        giveNothing();
        measure(subStep);
        look(subStep);
        lookBack(subStep);
        float omega = omegaA - omegaB;
        if (joint.angular == Angular.RIGID) {
            turn(rigid.solve(joint.turning, mass(turnA + turnB), omega, turnedAway()));
        } else if (joint.angular == Angular.ANGLE) {
            turn(bySpring(joint.turning, mass(turnA + turnB), omega, omega, turnedAway()));
        }
        if (isAlong()) {
            visitAlong(true);
        } else if (joint.linear == Linear.POINT) {
            float before = joint.along;
            float beforeAcross = joint.across;
            joint.along = byAxis(before, velocity[0], begun[0], offset[0]);
            joint.across = byAxis(beforeAcross, velocity[1], begun[1], offset[1]);
            cut(before, beforeAcross);
        }
        forgetExact();
    }

    /** What an exact spring has given counts at once, and is not kept. */
    private void forgetExact() {
        if (!isExact()) {
            return;
        }
        float[] given = isAlong() ? new float[] {normal[0] * joint.along, normal[1] * joint.along} : push;
        joint.sum[0] += given[0];
        joint.sum[1] += given[1];
        joint.sumOfTurning += twist;
        forgetImpulses();
    }

    private void forgetImpulses() {
        joint.along = 0f;
        joint.across = 0f;
        joint.turning = 0f;
    }

    void relax(int subStep) {
        giveNothing();
        measure(subStep + 1);
        look(subStep + 1);
        float omega = omegaA - omegaB;
        if (joint.angular == Angular.RIGID) {
            turn(relaxed(joint.turning, mass(turnA + turnB), omega));
        } else if (joint.angular == Angular.SPEED) {
            turn(relaxed(joint.turning, mass(turnA + turnB), omega - joint.speed));
        }
        if (isAlong()) {
            visitAlong(false);
        } else if (joint.linear == Linear.DRAG || joint.linear == Linear.POINT && joint.rigid) {
            float before = joint.along;
            float beforeAcross = joint.across;
            joint.along = relaxed(before, mass(inverse), velocity[0]);
            joint.across = relaxed(beforeAcross, mass(inverse), velocity[1]);
            cut(before, beforeAcross);
        }
    }

    private void turn(float next) {
        float most = joint.mostTorque * k.h();
        float before = joint.turning;
        joint.turning = clamp(next, -most, most);
        twist = joint.turning - before;
        omegaA += turnA * twist;
        omegaB -= turnB * twist;
    }

    /** Keeps an impulse in both axes within the greatest force. */
    private void cut(float before, float beforeAcross) {
        float most = joint.mostForce * k.h();
        float length = length(joint.along, joint.across);
        float share = length > most ? most / length : 1f;
        joint.along *= share;
        joint.across *= share;
        push = new float[] {joint.along - before, joint.across - beforeAcross};
    }

    private void visitAlong(boolean biased) {
        float v = dot(normal, velocity);
        float sum = 0f;
        if (joint.rigid || joint.elastic && biased) {
            float before = joint.along;
            joint.along = biased
                    ? byAxis(before, v, dot(normal, begun), distance - joint.length)
                    : relaxed(before, mass(inverse), v);
            sum += joint.along - before;
            v += inverse * (joint.along - before);
        }
        if (joint.hasLeast) {
            float before = joint.least;
            joint.least = byLimit(biased, before, v, distance - joint.leastLength);
            sum += joint.least - before;
            v += inverse * (joint.least - before);
        }
        if (joint.hasGreatest) {
            float before = joint.greatest;
            joint.greatest = byLimit(biased, before, -1f * v, joint.greatestLength - distance);
            sum -= joint.greatest - before;
        }
        push = new float[] {normal[0] * sum, normal[1] * sum};
        if (joint.keepsDirection) {
            visitAcross(biased);
        }
    }

    private void visitAcross(boolean biased) {
        float arm = 0.5f * distance;
        float m = mass(inverse + arm * arm * (turnA + turnB));
        float v = (-normal[1] * velocity[0] + normal[0] * velocity[1]) - arm * (omegaA + omegaB);
        float before = joint.across;
        joint.across = biased ? rigid.hold(before, m, v, direction, most()) : relaxed(before, m, v);
        float change = joint.across - before;
        push[0] += -normal[1] * change;
        push[1] += normal[0] * change;
        both = -0.5f * distance * change;
    }

    /** Ends a sub-step: what it gives now is what the next one begins with. */
    void end() {
        loadCircles();
        giveAll();
        joint.sum[0] += push[0];
        joint.sum[1] += push[1];
        joint.sumOfTurning += twist;
    }

    boolean breaks() {
        return length(joint.sum) > joint.breakForce * k.dt()
                || Math.abs(joint.sumOfTurning) > joint.breakTorque * k.dt();
    }

    // ---- what the circles get

    private float spinOfA() {
        return (twist + both) / radius(a);
    }

    private float spinOfB() {
        return (both - twist) / radius(b);
    }

    /** Gives it to the velocities. */
    void give() {
        if (!a.isStatic()) {
            a.velocity[0] -= a.inverseMass() * push[0];
            a.velocity[1] -= a.inverseMass() * push[1];
            a.turn.speed += turns() ? a.turn.inverseInertia * spinOfA() : -0f;
        }
        if (b != null && !b.isStatic()) {
            b.velocity[0] += b.inverseMass() * push[0];
            b.velocity[1] += b.inverseMass() * push[1];
            b.turn.speed += turns() ? b.turn.inverseInertia * spinOfB() : -0f;
        }
    }

    /** Gives it to the impulses that the circles begin the next sub-step with. */
    void giveToSums() {
        if (!a.isStatic()) {
            a.impulses[0] -= push[0];
            a.impulses[1] -= push[1];
            a.turn.impulse += turns() ? spinOfA() : -0f;
        }
        if (b != null && !b.isStatic()) {
            b.impulses[0] += push[0];
            b.impulses[1] += push[1];
            b.turn.impulse += turns() ? spinOfB() : -0f;
        }
    }

    /** Gives it to the sums of a pass over split joints: as velocities, or as impulses. */
    void giveToFixed(boolean speeds) {
        if (!a.isStatic()) {
            FixedSum to = speeds ? a.jointGain : a.jointImpulse;
            float by = speeds ? a.inverseMass() : 1f;
            to.add(0, -(by * push[0]));
            to.add(1, -(by * push[1]));
            to.add(2, (speeds ? a.turn.inverseInertia : 1f) * spinOfA());
        }
        if (b != null && !b.isStatic()) {
            FixedSum to = speeds ? b.jointGain : b.jointImpulse;
            float by = speeds ? b.inverseMass() : 1f;
            to.add(0, by * push[0]);
            to.add(1, by * push[1]);
            to.add(2, (speeds ? b.turn.inverseInertia : 1f) * spinOfB());
        }
    }
}
