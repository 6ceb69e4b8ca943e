package io.github.circles2d.reference;

import static io.github.circles2d.reference.Numbers.clamp;
import static io.github.circles2d.reference.Numbers.length;
import static io.github.circles2d.reference.Numbers.limitSpeed;
import static io.github.circles2d.reference.Numbers.max;
import static io.github.circles2d.reference.Numbers.min;

import io.github.circles2d.reference.ReferenceJoint.Angular;
import io.github.circles2d.reference.ReferenceJoint.Linear;

/** A joint that holds a body within a step, in which it has not broken. What it gives are an impulse on B, and an angular one on A. */
final class RigidJointVisit {
    private static final float GREATEST_IMPULSE = 1e20f;
    private static final float STRAIN = 0.1f;
    private static final float PUSH = 0.2f;
    private static final float RADIANS_PER_UNIT = 1.4629181e-9f;

    /** Of a determinant, by the square of the trace. */
    private static final float LEAST_DETERMINANT = 1e-6f;

    final ReferenceJoint joint;
    private final StepParameters k;
    private final JointSpring spring;
    private final JointSoftness rigid;

    /** How its anchor moves; null if it is at rest. */
    private final AnchorMotion anchor;

    private final End a;
    private final End b;

    /** From the base of A to that of B. */
    private final float[] between;

    /** The greatest speed by which it corrects where its ends are. */
    private final float most;

    private float[] normal = {1f, 0f};
    private float distance;

    /** From A to B. */
    private float[] offset = new float[2];

    private float strain;

    // the speeds of a visit, and by what an impulse changes them
    private float[] velocity;
    private float[] begun;
    private float kxx;
    private float kxy;
    private float kyy;

    // what it gives
    private float[] push = new float[2];
    private float twist;

    /** What is at one side: a body, a circle, or neither. */
    private final class End {
        private final RigidThing body;
        private final Circle circle;
        private final float[] point;

        /** From the place of the body to where it is held. */
        private float[] arm = new float[2];

        End(RigidThing body, Circle circle, float[] point) {
            this.body = body;
            this.circle = circle;
            this.point = point;
        }

        private boolean hasNothing() {
            return body == null && circle == null;
        }

        private float[] base() {
            return body != null ? body.place : circle != null ? circle.base : joint.anchorPlace(k.arena());
        }

        private float w() {
            return body != null ? body.w : circle != null ? circle.inverseMass() : 0f;
        }

        private float i() {
            return body != null ? body.i : circle != null && circle.inverseMass() > 0f ? inertia(circle) : 0f;
        }

        private static float inertia(Circle c) {
            return c.turn.inverseInertia / (c.radius * c.radius);
        }

        private float ownW() {
            return body != null ? body.ownW : w();
        }

        private float ownI() {
            return body != null ? body.ownI : i();
        }

        /** By what push-outs are measured. */
        private float size() {
            if (ownW() == 0f && ownI() == 0f) {
                return Float.POSITIVE_INFINITY;
            }
            return body != null ? body.reach : circle.radius;
        }

        private void turn() {
            arm = body == null ? new float[2] : body.turned(point);
        }

        private float[] way(int boundary) {
            if (hasNothing()) {
                return anchor == null ? new float[2] : anchor.ways()[boundary];
            }
            return body == null ? circle.displacement : Numbers.plus(body.way, arm);
        }

        private float[] velocity(int boundary) {
            if (hasNothing()) {
                return anchor == null ? new float[2] : anchor.velocities()[boundary];
            }
            return body == null ? circle.velocity : ofPoint(body.velocity, body.omega);
        }

        /** As the sub-step began: without gravity and all impulses. */
        private float[] begun(int boundary) {
            if (hasNothing()) {
                return velocity(boundary);
            }
            if (body == null) {
                return Numbers.minus(circle.velocityBeforeImpulses, circle.isStatic() ? new float[2] : circle.gain);
            }
            return ofPoint(Numbers.minus(body.velocityBefore, body.gain), body.omegaBefore - body.angularGain);
        }

        private float[] ofPoint(float[] v, float omega) {
            return new float[] {v[0] - omega * arm[1], v[1] + omega * arm[0]};
        }

        private float omega() {
            return body != null ? body.omega : circle != null ? circle.turn.speed / circle.radius : 0f;
        }

        /** As the step began. */
        private int angle() {
            return body != null ? body.body.angle : circle != null ? circle.angle : 0;
        }

        private float turned() {
            return body != null ? body.turned : circle != null ? circle.turn.turned() * k.h() / circle.radius : 0f;
        }

        private void give(float x, float y, float spin) {
            giveBody(x, y, spin);
            if (circle != null && w() > 0f) {
                circle.velocity[0] += w() * x;
                circle.velocity[1] += w() * y;
                circle.turn.speed += i() * (circle.radius * spin);
            }
        }

        private void giveBody(float x, float y, float spin) {
            if (body != null) {
                body.velocity[0] = limitSpeed(body.velocity[0] + body.w * x);
                body.velocity[1] = limitSpeed(body.velocity[1] + body.w * y);
                body.omega = limitSpeed(body.omega + body.i * ((arm[0] * y - arm[1] * x) + spin));
            }
        }

        /** A circle begins the next sub-step with it. */
        private void giveNext(float x, float y, float spin) {
            if (circle != null && w() > 0f) {
                circle.impulses[0] += x;
                circle.impulses[1] += y;
                circle.turn.impulse += spin / circle.radius;
                circle.loadedNext |= strain > STRAIN * circle.radius;
            }
        }
    }

    /** With the things that its bodies are, or null; scales the impulses of the step before. */
    RigidJointVisit(ReferenceJoint joint, RigidThing bodyA, RigidThing bodyB, StepParameters k, float warmScale) {
        this.joint = joint;
        this.k = k;
        spring = JointSpring.of(joint.frequency, joint.damping, k.h());
        rigid = JointSoftness.ofRigid(k);
        anchor = joint.anchorMotion(k);
        a = new End(bodyA, joint.a, joint.points[0]);
        b = new End(bodyB, joint.b, joint.points[1]);
        between = k.arena().way(a.base(), b.base());
        float size = min(a.size(), b.size());
        most = size < Float.POSITIVE_INFINITY ? PUSH * size * k.inverseH() : 0f;
        joint.keep(warmScale);
        if (isLinearExact()) {
            joint.along = 0f;
            joint.across = 0f;
        }
        if (isAngularExact()) {
            joint.turning = 0f;
        }
        joint.sum[0] = 0f;
        joint.sum[1] = 0f;
        joint.sumOfTurning = 0f;
    }

    // ---- what it is

    /** A weld holds a point, too. */
    private boolean isPoint() {
        return joint.linear == Linear.POINT || joint.keepsDirection;
    }

    private boolean isAlong() {
        return joint.linear == Linear.ALONG && !joint.keepsDirection;
    }

    private boolean isLinearExact() {
        return joint.angular == Angular.NONE && joint.elastic && spring.exact();
    }

    private boolean isAngularExact() {
        return joint.angular == Angular.ANGLE && spring.exact();
    }

    // ---- where its ends are

    private void measure(int boundary) {
        a.turn();
        b.turn();
        offset = Numbers.plus(between, Numbers.minus(b.way(boundary), a.way(boundary)));
        strain = 0f;
        if (isPoint() && joint.rigid) {
            strain = length(offset);
            meet();
        } else if (isAlong()) {
            distance = length(offset);
            if (distance > 0f) {
                normal = new float[] {offset[0] / distance, offset[1] / distance};
            }
            strain = joint.rigid ? Math.abs(distance - joint.length) : 0f;
            strain = joint.hasLeast ? max(joint.leastLength - distance, strain) : strain;
            strain = joint.hasGreatest ? max(distance - joint.greatestLength, strain) : strain;
        }
    }

    /** Bodies take the middle, or the centre of a circle, as the place of both ends. */
    private void meet() {
        if (a.body != null && (b.body != null || b.circle != null)) {
            a.arm[0] += (b.body != null ? 0.5f : 1f) * offset[0];
            a.arm[1] += (b.body != null ? 0.5f : 1f) * offset[1];
        }
        if (b.body != null) {
            b.arm[0] -= (a.body != null ? 0.5f : 1f) * offset[0];
            b.arm[1] -= (a.body != null ? 0.5f : 1f) * offset[1];
        }
    }

    private void look(int boundary) {
        velocity = Numbers.minus(b.velocity(boundary), a.velocity(boundary));
        begun = Numbers.minus(b.begun(boundary), a.begun(boundary));
        float w = a.ownW() + b.ownW();
        float ia = a.ownI();
        float ib = b.ownI();
        kxx = w + (ia * (a.arm[1] * a.arm[1]) + ib * (b.arm[1] * b.arm[1]));
        kxy = -1f * (ia * (a.arm[0] * a.arm[1]) + ib * (b.arm[0] * b.arm[1]));
        kyy = w + (ia * (a.arm[0] * a.arm[0]) + ib * (b.arm[0] * b.arm[0]));
    }

    /** The impulse that changes the velocity of B against A by so much. */
    private float[] solved(float x, float y) {
        float trace = kxx + kyy;
        float determinant = kxx * kyy - kxy * kxy;
        if (determinant > LEAST_DETERMINANT * (trace * trace)) {
            return new float[] {(kyy * x - kxy * y) / determinant, (kxx * y - kxy * x) / determinant};
        }
        if (trace > 0f) {
            return new float[] {((kxx * x + kxy * y) / trace) / trace, ((kxy * x + kyy * y) / trace) / trace};
        }
        return new float[2];
    }

    private float inverseAlong() {
        return (kxx * normal[0] * normal[0] + 2f * (kxy * normal[0] * normal[1])) + kyy * normal[1] * normal[1];
    }

    // ---- impulses

    private static float mass(float sum) {
        return sum > 0f ? 1f / sum : 0f;
    }

    private static float kept(float impulse) {
        return clamp(impulse, -GREATEST_IMPULSE, GREATEST_IMPULSE);
    }

    private static float relaxed(float impulse, float m, float v) {
        return kept(impulse - m * v);
    }

    private float exact(float m, float v, float itsBegun, float way) {
        return kept(-1f * (m * ((spring.now() * v + spring.begun() * itsBegun) + spring.way() * way)));
    }

    /** Begins what it gives with all its impulses. */
    private void giveAll() {
        float along = (joint.along + joint.least) - joint.greatest;
        push = isAlong() ? new float[] {normal[0] * along, normal[1] * along} : new float[] {joint.along, joint.across};
        twist = joint.turning;
    }

    private void give() {
        a.give(-1f * push[0], -1f * push[1], twist);
        b.give(push[0], push[1], -1f * twist);
    }

    private void giveNext() {
        a.giveNext(-1f * push[0], -1f * push[1], twist);
        b.giveNext(push[0], push[1], -1f * twist);
    }

    /** What turns is given at once: the rest sees it. */
    private void giveTwist() {
        if (twist != 0f) {
            a.give(0f, 0f, twist);
            b.give(0f, 0f, -1f * twist);
            twist = 0f;
        }
    }

    private void turnTo(float next) {
        float before = joint.turning;
        joint.turning = heldTwist(next);
        twist = joint.turning - before;
    }

    private float heldTwist(float impulse) {
        return clamp(impulse, -(joint.mostTorque * k.h()), joint.mostTorque * k.h());
    }

    // ---- in a step

    void prepare() {
        measure(0);
        giveAll();
        giveNext();
    }

    /** What bodies have kept acts again; circles have it in their sums. */
    void warmStart() {
        giveAll();
        a.giveBody(-1f * push[0], -1f * push[1], twist);
        b.giveBody(push[0], push[1], -1f * twist);
    }

    void solve(int subStep) {
        push = new float[2];
        twist = 0f;
        measure(subStep);
        solveTurning();
        giveTwist();
        look(subStep);
        if (isAlong()) {
            visitAlong(true);
        } else if (isPoint()) {
            solvePoint();
        }
        give();
    }

    private void solveTurning() {
        int units = (a.angle() - joint.referenceOfA) - (b.angle() - joint.referenceOfB);
        float away = (float) units * RADIANS_PER_UNIT + (a.turned() - b.turned());
        float omega = a.omega() - b.omega();
        float m = mass(a.ownI() + b.ownI());
        if (joint.angular == Angular.RIGID) {
            turnTo(rigid.solve(joint.turning, m, omega, away));
        } else if (isAngularExact()) {
            twist = heldTwist(exact(m, omega, omega, away));
            joint.sumOfTurning += twist;
        } else if (joint.angular == Angular.ANGLE) {
            turnTo(spring.soft().solve(joint.turning, m, omega, away));
        }
    }

    private void visitAlong(boolean biased) {
        float inverse = inverseAlong();
        float m = mass(inverse);
        float v = Numbers.dot(normal, velocity);
        float sum = 0f;
        if (joint.rigid || joint.elastic && biased) {
            float change = biased ? solveLength(m, v) : relaxLength(m, v);
            sum += change;
            v += inverse * change;
        }
        if (joint.hasLeast) {
            float before = joint.least;
            joint.least = byLimit(biased, before, m, v, distance - joint.leastLength);
            sum += joint.least - before;
            v += inverse * (joint.least - before);
        }
        if (joint.hasGreatest) {
            float before = joint.greatest;
            joint.greatest = byLimit(biased, before, m, -1f * v, joint.greatestLength - distance);
            sum -= joint.greatest - before;
        }
        push = new float[] {normal[0] * sum, normal[1] * sum};
    }

    private float solveLength(float m, float v) {
        float before = joint.along;
        float way = distance - joint.length;
        if (isLinearExact()) {
            float change = exact(m, v, Numbers.dot(normal, begun), way);
            joint.sum[0] += normal[0] * change;
            joint.sum[1] += normal[1] * change;
            return change;
        }
        joint.along = joint.rigid
                ? rigid.hold(before, m, v, way, most)
                : spring.soft().solve(before, m, v, way);
        return joint.along - before;
    }

    private float relaxLength(float m, float v) {
        float before = joint.along;
        joint.along = relaxed(before, m, v);
        return joint.along - before;
    }

    private float byLimit(boolean biased, float impulse, float m, float v, float gap) {
        float next = impulse - m * (gap > 0f ? v + gap * k.inverseH() : v);
        return clamp(biased && gap <= 0f ? rigid.held(impulse, m, v, gap, most) : next, 0f, GREATEST_IMPULSE);
    }

    private void solvePoint() {
        if (isLinearExact()) {
            float[] change = new float[2];
            for (int axis = 0; axis < 2; axis++) {
                change[axis] =
                        (spring.now() * velocity[axis] + spring.begun() * begun[axis]) + spring.way() * offset[axis];
            }
            float[] solved = solved(change[0], change[1]);
            push = cut(kept(-1f * solved[0]), kept(-1f * solved[1]));
            joint.sum[0] += push[0];
            joint.sum[1] += push[1];
            return;
        }
        JointSoftness soft = joint.rigid ? rigid : spring.soft();
        float[] bias = {soft.biasRate() * offset[0], soft.biasRate() * offset[1]};
        float speed = length(bias);
        float share = joint.rigid && speed > most ? most / speed : 1f;
        float[] solved = solved(
                soft.massScale() * (velocity[0] + share * bias[0]), soft.massScale() * (velocity[1] + share * bias[1]));
        takeOff(solved, soft.impulseScale());
    }

    /** Takes a solution off the impulses, which leak by a share. */
    private void takeOff(float[] solved, float leak) {
        float before = joint.along;
        float beforeAcross = joint.across;
        float x = kept((before - solved[0]) - leak * before);
        float y = kept((beforeAcross - solved[1]) - leak * beforeAcross);
        float[] held = cut(x, y);
        joint.along = held[0];
        joint.across = held[1];
        push = new float[] {held[0] - before, held[1] - beforeAcross};
    }

    /** Within the greatest force. */
    private float[] cut(float x, float y) {
        float greatest = joint.mostForce * k.h();
        float impulse = length(x, y);
        float share = impulse > greatest ? greatest / impulse : 1f;
        return new float[] {x * share, y * share};
    }

    void relax(int subStep, boolean last) {
        push = new float[2];
        twist = 0f;
        measure(subStep + 1);
        if (joint.angular == Angular.RIGID || joint.angular == Angular.SPEED) {
            float speed = joint.angular == Angular.SPEED ? joint.speed : 0f;
            turnTo(relaxed(joint.turning, mass(a.ownI() + b.ownI()), (a.omega() - b.omega()) - speed));
            giveTwist();
        }
        look(subStep + 1);
        if (isAlong()) {
            visitAlong(false);
        } else if (joint.linear == Linear.DRAG || isPoint() && joint.rigid) {
            takeOff(solved(velocity[0], velocity[1]), 0f);
        }
        give();
        giveAll();
        joint.sum[0] += push[0];
        joint.sum[1] += push[1];
        joint.sumOfTurning += twist;
        if (!last) {
            giveNext();
        }
    }

    boolean breaks() {
        return length(joint.sum) > joint.breakForce * k.dt()
                || Math.abs(joint.sumOfTurning) > joint.breakTorque * k.dt();
    }
}
