package io.github.circles2d.world.jvm.bodies;

import io.github.circles2d.world.model.Bounce;
import io.github.circles2d.world.model.Branchless;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.Constraints;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.Surface;
import io.github.circles2d.world.model.Tuning;

/** What a contact of rigid bodies does in a visit, by the numbers of the step: masses, and impulses along the normal and the tangent. */
final class RigidRules {
    /** Greatest speed of push-outs, by that of circles: half thicknesses are greater than what touches. */
    private static final float PUSH = 0.5f;

    private static final float LEAST_BOUNCE = 1e-6f;

    /** No masses and speeds that a world takes need more. It and the greatest speed keep all finite: of what is not, processors make what they like. */
    private static final float GREATEST_IMPULSE = 1e20f;

    // within a step
    private StepConstants k;
    private boolean tells;

    /** Begins a step; toTell: whether anybody asks how hard things have touched. */
    void begin(StepConstants constants, boolean toTell) {
        k = constants;
        tells = toTell;
    }

    /** What both things of a contact have together. */
    void begin(RigidContact c) {
        RigidThing a = c.a;
        RigidThing b = c.b;
        c.friction = Surface.friction(a.friction, b.friction);
        c.rolling = CircleMath.max(a.rolling, b.rolling);
        c.belts = a.belt + b.belt;
        c.restitution = CircleMath.max(a.restitution, b.restitution);
        c.length = a.ownW == 0f ? 2f * b.thin : b.ownW == 0f ? 2f * a.thin : a.thin + b.thin;
        c.threshold = Bounce.bounceThreshold(c.length, c.restitution, k.thresholdRate, k.restRate, k.fixedThreshold);
        setMasses(c);
    }

    /** Masses and terms of a contact that has been measured. */
    void setMasses(RigidContact c) {
        c.normalMass = RigidContact.massOf(c.massOfA() + c.massOfB());
        c.tangentMass = c.gripMass(1f, 1f);
        boolean apart = c.gap > 0f;
        c.speedScale = apart ? 1f : k.contactSoftness.massScale;
        c.decay = apart ? 0f : k.contactSoftness.impulseScale;
        c.near = apart ? c.gap * k.inverseH : 0f;
        c.bias = apart ? c.near : Constraints.softBias(c.gap, pushSpeed(c), k.contactSoftness, k);
    }

    private float pushSpeed(RigidContact c) {
        return PUSH * k.pushRate * c.length;
    }

    /** Whether a contact stops what would come far into the other within a sub-step. */
    boolean isHit(RigidContact c) {
        return isFast(c) && c.impulse > 0f;
    }

    boolean isFast(RigidContact c) {
        return c.approach * k.h > Tuning.CAP * c.length;
    }

    /** Whether a contact has closed without an impulse, as a body turns: it is to bounce in the next sub-step, not to stop now. */
    boolean bouncesLater(RigidContact c, float vn) {
        return c.restitution > 0f && c.impulse == 0f && !(c.gap > 0f) && bounceSpeed(c, vn) > 0f;
    }

    /** Solves with bias along the normal, where contacts bounce, too; before: the speed before impulses. Returns what the impulse gains. */
    float solvedNormal(RigidContact c, float mass, float vn, float before) {
        c.approach = Branchless.greater(c.approach, -before);
        c.bounce = c.restitution > 0f ? bounceSpeed(c, before) : 0f;
        return take(c, Constraints.solve(c.impulse, mass, vn, c.gap, c.bounce, pushSpeed(c), k.contactSoftness, k));
    }

    /** Solves with bias along the normal of a contact that does not bounce. Returns what the impulse gains. */
    float solvedNormal(RigidContact c, float vn) {
        return take(c, Constraints.visit(c.impulse, c.normalMass, c.speedScale, vn, c.bias, c.decay * c.impulse));
    }

    float relaxedNormal(RigidContact c, float mass, float vn) {
        return take(c, Constraints.visit(c.impulse, mass, 1f, vn, c.near, 0f));
    }

    private float take(RigidContact c, float wanted) {
        float next = CircleMath.min(wanted, GREATEST_IMPULSE);
        float gain = next - c.impulse;
        c.impulse = next;
        if (tells) {
            c.most = Branchless.greater(c.most, next);
        }
        return gain;
    }

    /** Of a contact with a restitution. */
    private float bounceSpeed(RigidContact c, float before) {
        float e = c.restitution;
        if (!c.isImpact(before)
                || !(Constraints.bounceSpeed(e, 1f, before, c.gap, k.h, c.threshold, pushSpeed(c)) > 0f)) {
            return 0f;
        }
        RigidThing falls = c.a.w == 0f ? c.b : c.a;
        float fall = falls.takenX() * c.nx + falls.takenY() * c.ny;
        float half = Bounce.halfFall(fall, c.b.w, c.a.w);
        return CircleMath.max(-e * before + (1f + e) * half, LEAST_BOUNCE);
    }

    /** By the speed along the tangent. Returns what the grip gains. */
    float gripped(RigidContact c, float mass, float along) {
        float before = c.grip;
        c.grip = Surface.grip(before, mass, along - c.belts, c.friction * c.impulse);
        return c.grip - before;
    }
}
