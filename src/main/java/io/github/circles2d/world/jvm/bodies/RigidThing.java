package io.github.circles2d.world.jvm.bodies;

import io.github.circles2d.world.bodies.OutlineShape;
import io.github.circles2d.world.bodies.RigidStep;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.CrossRule;
import io.github.circles2d.world.model.Tuning;
import io.github.circles2d.world.model.Velocity;

/**
 * What takes part in contacts of rigid bodies in a step: a body, or a piece of terrain, a wall or a circle near to one. All are alike: a place, an angle,
 * velocities, and an outline of corners and lines, which turns with it; {@link RigidThings} has those.
 *
 * <p>A place is a base, which stays for a step, and the displacement since, as those of circles.
 */
final class RigidThing {
    /** Its number among all. */
    final int number;

    /** {@link RigidStep#BODY_BODY} of a body, and so on. */
    int type;

    int id;
    float x;
    float y;
    float dx;
    float dy;
    int angle;

    /** Of a body: by how much it has turned in the step, in radians. */
    float turned;

    float cos;
    float sin;
    float vx;
    float vy;
    float omega;

    // within a sub-step: velocities before impulses
    float beforeX;
    float beforeY;
    float beforeOmega;

    // inverse mass and inertia; 0 of what contacts do not move
    float w;
    float i;

    // the same, also of what sleeps, which moves others as if it would give way
    float ownW;
    float ownI;

    /** Lengths of contacts are measured by it. */
    float thin;

    float reach;
    float restitution;
    float friction;
    float rolling;
    float belt;

    // speed by gravity and forces in a sub-step, also of a body that sleeps, which does not take it
    float gainX;
    float gainY;
    float gainOmega;
    int kind;

    /** Half of its part of a margin. */
    float near;

    /** Of a body: whether it sleeps. */
    boolean asleep;

    /** Of a piece that lets pass what comes from behind. */
    boolean oneWay;

    /** Null of what is no body. */
    OutlineShape shape;

    // its corners and lines, by their numbers among all
    int firstCorner;
    int endCorner;
    int firstLine;
    int endLine;

    /** The number of its pairs in {@link RigidOrder}. */
    int degree;

    /** Of a body: as how many it counts where circles push it at once. */
    float share;

    // of a body: what circles give in a pass, in units; before a step, what presses one that sleeps, also without its
    // direction
    long sumX;
    long sumY;
    long sumOmega;
    long sumLoad;

    // of a body that sleeps, by WakingByBodies: the last steps that have looked at it and woken it, the speed that
    // wakes it,
    // and that which wakes it in the next ring, 0 between rings
    long looked;
    long wokenIn;
    float speed;
    float nextSpeed;

    RigidThing(int number) {
        this.number = number;
    }

    /** Begins as something at rest and unturned, without corners and lines. */
    void begin(int itsType, int itsId, float atX, float atY) {
        type = itsType;
        id = itsId;
        x = atX;
        y = atY;
        dx = 0f;
        dy = 0f;
        angle = 0;
        turned = 0f;
        cos = 1f;
        sin = 0f;
        setVelocity(0f, 0f, 0f);
        noteVelocity();
        setMasses(0f, 0f);
        thin = 0f;
        reach = Float.POSITIVE_INFINITY;
        restitution = 0f;
        setSurface(0f, 0f, 0f);
        gainX = 0f;
        gainY = 0f;
        gainOmega = 0f;
        kind = 0;
        asleep = false;
        oneWay = false;
        shape = null;
    }

    void setVelocity(float itsVx, float itsVy, float itsOmega) {
        vx = itsVx;
        vy = itsVy;
        omega = itsOmega;
    }

    /** A sub-step has given it all but impulses. */
    void noteVelocity() {
        beforeX = vx;
        beforeY = vy;
        beforeOmega = omega;
    }

    /** Inverse mass and inertia of what is awake. */
    void setMasses(float inverseMass, float inverseInertia) {
        w = inverseMass;
        i = inverseInertia;
        ownW = inverseMass;
        ownI = inverseInertia;
    }

    void setSurface(float itsFriction, float itsRolling, float itsBelt) {
        friction = itsFriction;
        rolling = itsRolling;
        belt = itsBelt;
    }

    // ---- sums

    void clearSums() {
        sumX = 0L;
        sumY = 0L;
        sumOmega = 0L;
        sumLoad = 0L;
    }

    float range(float inverseH) {
        return CrossRule.velocityRange(reach, inverseH);
    }

    /** Adds velocities. */
    void addToSums(float byX, float byY, float byOmega, float inverseH) {
        float scale = CrossRule.scaleOf(range(inverseH));
        sumX += CrossRule.toFixed(byX, scale);
        sumY += CrossRule.toFixed(byY, scale);
        sumOmega += CrossRule.toFixed(byOmega, CrossRule.scaleOf(inverseH));
    }

    float summedX(float inverseH) {
        return CrossRule.fromFixed(sumX, CrossRule.unitOf(range(inverseH)));
    }

    float summedY(float inverseH) {
        return CrossRule.fromFixed(sumY, CrossRule.unitOf(range(inverseH)));
    }

    float summedOmega(float inverseH) {
        return CrossRule.fromFixed(sumOmega, CrossRule.unitOf(inverseH));
    }

    // ---- what moves it

    /** Adds velocities, within the greatest speed; one look at all is enough nearly always. */
    void add(float byX, float byY, float byOmega) {
        vx += byX;
        vy += byY;
        omega += byOmega;
        if (!(Math.abs(vx) + Math.abs(vy) + Math.abs(omega) <= Tuning.GREATEST_SPEED)) {
            vx = Velocity.limitSpeed(vx);
            vy = Velocity.limitSpeed(vy);
            omega = Velocity.limitSpeed(omega);
        }
    }

    /** Whether contacts move or turn it. */
    boolean gives() {
        return w > 0f || i > 0f;
    }

    float gain() {
        return CircleMath.length(gainX, gainY);
    }

    /** What it takes of {@link #gainX}. */
    float takenX() {
        return asleep ? 0f : gainX;
    }

    float takenY() {
        return asleep ? 0f : gainY;
    }

    float takenOmega() {
        return asleep ? 0f : gainOmega;
    }
}
