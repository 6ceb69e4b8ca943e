package io.github.circles2d.world.jvm.bodies;

import io.github.circles2d.world.bodies.KeptContacts;

/** A contact of two things: a corner of A, and a line or a corner of B. */
final class RigidContact {
    RigidThing a;
    RigidThing b;

    /** The corner of A. */
    RigidCorner corner;

    /** The line of B, or null. */
    RigidLine line;

    /** The corner of B, or null. */
    RigidCorner itsCorner;

    // as KeptContacts has them: the form with the feature of the pair's body, and the feature of the other
    int first;
    int second;

    // by how much the base of A lies beyond that of B
    float ox;
    float oy;

    // the normal, from B to A
    float nx;
    float ny;
    float gap;

    // arms
    float ax;
    float ay;
    float bx;
    float by;

    // accumulated impulses: along the normal and the tangent, and the angular one of rolling resistance
    float impulse;
    float grip;
    float roll;

    /** Within a sub-step: the speed after a bounce. */
    float bounce;

    // within a step: the greatest impulse, and the greatest speed before an impulse, towards each other
    float most;
    float approach;

    // effective masses along the normal and the tangent, since contacts were measured; not with circles
    float normalMass;
    float tangentMass;

    // what both things have together
    float friction;
    float rolling;
    float belts;
    float restitution;

    /** Lengths are measured by it. */
    float length;

    /** The square of a speed: slower ones do not bounce. */
    float threshold;

    /** Whether it does not begin. */
    boolean covered;

    // terms of a biased visit that does not bounce, since contacts were measured: factors of speed and impulse, and a
    // speed
    float speedScale;
    float decay;
    float bias;

    /** What a visit without bias aims at: to come as near as the gap lets. */
    float near;

    /** Begins without a measure and impulses. */
    void begin(RigidPair pair) {
        boolean swapped = form() == KeptContacts.SWAPPED;
        a = swapped ? pair.b : pair.a;
        b = swapped ? pair.a : pair.b;
        ox = swapped ? -pair.ox : pair.ox;
        oy = swapped ? -pair.oy : pair.oy;
        nx = 0f;
        ny = 0f;
        gap = 0f;
        forgetImpulses();
        most = 0f;
        approach = 0f;
    }

    void forgetImpulses() {
        bounce = 0f;
        impulse = 0f;
        grip = 0f;
        roll = 0f;
    }

    int form() {
        return KeptContacts.form(first);
    }

    /** Whether it comes behind another one of its pair. */
    boolean isBehind(RigidContact other) {
        return first > other.first || first == other.first && second > other.second;
    }

    boolean isLine() {
        return line != null;
    }

    /** How far the place of A is from that of B. */
    float x() {
        return ox + (a.dx - b.dx);
    }

    float y() {
        return oy + (a.dy - b.dy);
    }

    // ---- masses

    /** One over the effective mass of A alone along the normal. */
    float massOfA() {
        float arm = ax * ny - ay * nx;
        return a.ownW + a.ownI * arm * arm;
    }

    float massOfB() {
        float arm = bx * ny - by * nx;
        return b.ownW + b.ownI * arm * arm;
    }

    /** The effective mass along the tangent. Shares: 1, or of what counts as lighter. */
    float gripMass(float shareA, float shareB) {
        float armA = ax * nx + ay * ny;
        float armB = bx * nx + by * ny;
        return massOf(shareA * (a.ownW + a.ownI * armA * armA) + shareB * (b.ownW + b.ownI * armB * armB));
    }

    /** An effective mass, from one over it. No impulse moves what has none. */
    static float massOf(float inverse) {
        return inverse >= Float.MIN_NORMAL ? 1f / inverse : 0f;
    }

    // ---- speeds of A against B

    float speedX() {
        return (a.vx - a.omega * ay) - (b.vx - b.omega * by);
    }

    float speedY() {
        return (a.vy + a.omega * ax) - (b.vy + b.omega * bx);
    }

    float normalSpeed() {
        return speedX() * nx + speedY() * ny;
    }

    /** Before impulses. */
    float speedBefore() {
        float x = (a.beforeX - a.beforeOmega * ay) - (b.beforeX - b.beforeOmega * by);
        float y = (a.beforeY + a.beforeOmega * ax) - (b.beforeY + b.beforeOmega * bx);
        return x * nx + y * ny;
    }

    // ---- what there is to do

    boolean isIdle() {
        return gap > 0f && impulse == 0f && grip == 0f;
    }

    /** Whether nothing presses or grips, so that the next friction changes nothing. */
    boolean isFree() {
        return impulse == 0f && grip == 0f && roll == 0f;
    }

    /** Whether there is friction, or has been. */
    boolean hasGrip() {
        return friction > 0f || grip != 0f;
    }

    /** Whether friction may change something, where nothing rolls. */
    boolean grips() {
        return grip != 0f || impulse != 0f && hasGrip();
    }

    /** Whether a contact with a restitution is fast enough to bounce. */
    boolean isImpact(float before) {
        return before < 0f && before * before > threshold;
    }
}
