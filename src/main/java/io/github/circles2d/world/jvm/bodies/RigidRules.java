package io.github.circles2d.world.jvm.bodies;

import io.github.circles2d.world.model.Bounce;
import io.github.circles2d.world.model.Branchless;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.Constraints;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.Surface;
import io.github.circles2d.world.model.Tuning;

/** What a contact of rigid bodies does in a visit, by its numbers in {@link RigidRow}: masses, speeds, and impulses along the normal and the tangent. */
final class RigidRules {
    /** Greatest speed of push-outs, by that of circles: half thicknesses are greater than what touches. */
    private static final float PUSH = 0.5f;

    private static final float LEAST_BOUNCE = 1e-6f;

    /** No masses and speeds that a world takes need more. It and the greatest speed keep all finite: of what is not, processors make what they like. */
    private static final float GREATEST_IMPULSE = 1e20f;

    private final RigidContacts contacts;
    private final RigidThings things;

    // within a step
    private StepConstants k;
    private boolean tells;

    RigidRules(RigidContacts contacts, RigidThings things) {
        this.contacts = contacts;
        this.things = things;
    }

    /** Begins a step; toTell: whether anybody asks how hard things have touched. */
    void begin(StepConstants constants, boolean toTell) {
        k = constants;
        tells = toTell;
    }

    /** What both things of a contact have together. */
    void begin(int c) {
        float[] rows = contacts.rows;
        int a = contacts.a[c];
        int b = contacts.b[c];
        int row = RigidRow.of(c);
        rows[row + RigidRow.FRICTION] = Surface.friction(things.friction[a], things.friction[b]);
        rows[row + RigidRow.ROLLING] = CircleMath.max(things.rolling[a], things.rolling[b]);
        rows[row + RigidRow.BELTS] = things.belt[a] + things.belt[b];
        rows[row + RigidRow.RESTITUTION] = CircleMath.max(things.restitution[a], things.restitution[b]);
        rows[row + RigidRow.LENGTH] = things.ownW[a] == 0f
                ? 2f * things.thin[b]
                : things.ownW[b] == 0f ? 2f * things.thin[a] : things.thin[a] + things.thin[b];
        rows[row + RigidRow.THRESHOLD] = Bounce.bounceThreshold(
                rows[row + RigidRow.LENGTH],
                rows[row + RigidRow.RESTITUTION],
                k.thresholdRate,
                k.restRate,
                k.fixedThreshold);
        setMasses(c);
    }

    void setMasses(int c) {
        int row = RigidRow.of(c);
        float normalMass = massOf(massOfA(c) + massOfB(c));
        float tangentMass = gripMass(c, 1f, 1f);
        contacts.rows[row + RigidRow.NORMAL_MASS] = normalMass;
        contacts.rows[row + RigidRow.TANGENT_MASS] = tangentMass;
        setTerms(contacts.rows, row);
    }

    private void setTerms(float[] rows, int row) {
        float gap = rows[row + RigidRow.GAP];
        boolean apart = gap > 0f;
        float soft = Constraints.softBias(gap, pushSpeed(row), k.contactSoftness, k);
        rows[row + RigidRow.SPEED_SCALE] = apart ? 1f : k.contactSoftness.massScale;
        rows[row + RigidRow.DECAY] = apart ? 0f : k.contactSoftness.impulseScale;
        rows[row + RigidRow.BIAS] = apart ? gap * k.inverseH : soft;
        rows[row + RigidRow.NEAR] = apart ? gap * k.inverseH : 0f;
    }

    private float pushSpeed(int row) {
        return PUSH * k.pushRate * contacts.rows[row + RigidRow.LENGTH];
    }

    /** One over the effective mass of A alone along the normal. */
    float massOfA(int c) {
        return inverseMass(contacts.a[c], RigidRow.of(c), RigidRow.AX);
    }

    float massOfB(int c) {
        return inverseMass(contacts.b[c], RigidRow.of(c), RigidRow.BX);
    }

    private float inverseMass(int t, int row, int armX) {
        float[] rows = contacts.rows;
        float arm = rows[row + armX] * rows[row + RigidRow.NY] - rows[row + armX + 1] * rows[row + RigidRow.NX];
        return things.ownW[t] + things.ownI[t] * arm * arm;
    }

    /** Shares: 1, or of what counts as lighter. */
    float gripMass(int c, float shareA, float shareB) {
        float[] rows = contacts.rows;
        int row = RigidRow.of(c);
        int a = contacts.a[c];
        int b = contacts.b[c];
        float nx = rows[row + RigidRow.NX];
        float ny = rows[row + RigidRow.NY];
        float armA = rows[row + RigidRow.AX] * nx + rows[row + RigidRow.AY] * ny;
        float armB = rows[row + RigidRow.BX] * nx + rows[row + RigidRow.BY] * ny;
        return massOf(shareA * (things.ownW[a] + things.ownI[a] * armA * armA)
                + shareB * (things.ownW[b] + things.ownI[b] * armB * armB));
    }

    /** An effective mass, from one over it. No impulse moves what has none. */
    static float massOf(float inverse) {
        return inverse >= Float.MIN_NORMAL ? 1f / inverse : 0f;
    }

    /** Whether a contact stops what would come far into the other within a sub-step. */
    boolean isHit(int row) {
        return isFast(row) && contacts.rows[row + RigidRow.IMPULSE] > 0f;
    }

    boolean isFast(int row) {
        float[] rows = contacts.rows;
        return rows[row + RigidRow.APPROACH] * k.h > Tuning.CAP * rows[row + RigidRow.LENGTH];
    }

    /** Whether a contact with a restitution is fast enough to bounce. */
    boolean isImpact(int row, float before) {
        return before < 0f && before * before > contacts.rows[row + RigidRow.THRESHOLD];
    }

    /** Whether a contact has closed without an impulse, as a body turns: it is to bounce in the next sub-step, not to stop now. */
    boolean bouncesLater(int c, float vn) {
        float[] rows = contacts.rows;
        int row = RigidRow.of(c);
        return rows[row + RigidRow.RESTITUTION] > 0f
                && rows[row + RigidRow.IMPULSE] == 0f
                && !(rows[row + RigidRow.GAP] > 0f)
                && bounceSpeed(c, vn) > 0f;
    }

    boolean isIdle(int row) {
        float[] rows = contacts.rows;
        return rows[row + RigidRow.GAP] > 0f && rows[row + RigidRow.IMPULSE] == 0f && rows[row + RigidRow.GRIP] == 0f;
    }

    float normalSpeed(int c) {
        return normalSpeed(c, things.vx, things.vy, things.omega);
    }

    /** Before impulses. */
    float speedBefore(int c) {
        return normalSpeed(c, things.beforeX, things.beforeY, things.beforeOmega);
    }

    private float normalSpeed(int c, float[] vx, float[] vy, float[] omega) {
        float[] rows = contacts.rows;
        int row = RigidRow.of(c);
        int a = contacts.a[c];
        int b = contacts.b[c];
        return speedX(rows, row, vx, omega, a, b) * rows[row + RigidRow.NX]
                + speedY(rows, row, vy, omega, a, b) * rows[row + RigidRow.NY];
    }

    static float speedX(float[] rows, int row, float[] vx, float[] omega, int a, int b) {
        return (vx[a] - omega[a] * rows[row + RigidRow.AY]) - (vx[b] - omega[b] * rows[row + RigidRow.BY]);
    }

    static float speedY(float[] rows, int row, float[] vy, float[] omega, int a, int b) {
        return (vy[a] + omega[a] * rows[row + RigidRow.AX]) - (vy[b] + omega[b] * rows[row + RigidRow.BX]);
    }

    /** Solves with bias along the normal, where contacts bounce, too; before: the speed before impulses. Returns what the impulse gains. */
    float solvedNormal(int c, float mass, float vn, float before) {
        float[] rows = contacts.rows;
        int row = RigidRow.of(c);
        float gap = rows[row + RigidRow.GAP];
        float impulse = rows[row + RigidRow.IMPULSE];
        float approach = Branchless.greater(rows[row + RigidRow.APPROACH], -before);
        float bounce = rows[row + RigidRow.RESTITUTION] > 0f ? bounceSpeed(c, before) : 0f;
        rows[row + RigidRow.APPROACH] = approach;
        rows[row + RigidRow.BOUNCE] = bounce;
        return take(row, Constraints.solve(impulse, mass, vn, gap, bounce, pushSpeed(row), k.contactSoftness, k));
    }

    /** Solves with bias along the normal of a contact that does not bounce. Returns what the impulse gains. */
    float solvedNormal(int row, float vn) {
        float[] rows = contacts.rows;
        float impulse = rows[row + RigidRow.IMPULSE];
        return take(
                row,
                Constraints.visit(
                        impulse,
                        rows[row + RigidRow.NORMAL_MASS],
                        rows[row + RigidRow.SPEED_SCALE],
                        vn,
                        rows[row + RigidRow.BIAS],
                        rows[row + RigidRow.DECAY] * impulse));
    }

    float relaxedNormal(int row, float mass, float vn) {
        float[] rows = contacts.rows;
        return take(row, Constraints.visit(rows[row + RigidRow.IMPULSE], mass, 1f, vn, rows[row + RigidRow.NEAR], 0f));
    }

    private float take(int row, float wanted) {
        float[] rows = contacts.rows;
        float next = CircleMath.min(wanted, GREATEST_IMPULSE);
        float gain = next - rows[row + RigidRow.IMPULSE];
        rows[row + RigidRow.IMPULSE] = next;
        if (tells) {
            rows[row + RigidRow.MOST] = Branchless.greater(rows[row + RigidRow.MOST], next);
        }
        return gain;
    }

    /** Of a contact with a restitution. */
    private float bounceSpeed(int c, float before) {
        float[] rows = contacts.rows;
        int row = RigidRow.of(c);
        float e = rows[row + RigidRow.RESTITUTION];
        float threshold = rows[row + RigidRow.THRESHOLD];
        if (!isImpact(row, before)
                || !(Constraints.bounceSpeed(e, 1f, before, rows[row + RigidRow.GAP], k.h, threshold, pushSpeed(row))
                        > 0f)) {
            return 0f;
        }
        int a = contacts.a[c];
        int b = contacts.b[c];
        int falls = things.w[a] == 0f ? b : a;
        float fall = things.gainX(falls) * rows[row + RigidRow.NX] + things.gainY(falls) * rows[row + RigidRow.NY];
        float half = Bounce.halfFall(fall, things.w[b], things.w[a]);
        return CircleMath.max(-e * before + (1f + e) * half, LEAST_BOUNCE);
    }

    /** Whether there is friction, or has been. */
    boolean hasGrip(int row) {
        return contacts.rows[row + RigidRow.FRICTION] > 0f || contacts.rows[row + RigidRow.GRIP] != 0f;
    }

    /** Whether friction may change something, where nothing rolls. */
    boolean grips(int row) {
        float grip = contacts.rows[row + RigidRow.GRIP];
        return grip != 0f || contacts.rows[row + RigidRow.IMPULSE] != 0f && hasGrip(row);
    }

    /** By the speed along the tangent. Returns what the grip gains. */
    float gripped(int row, float mass, float along) {
        float[] rows = contacts.rows;
        float before = rows[row + RigidRow.GRIP];
        float slip = along - rows[row + RigidRow.BELTS];
        float next = Surface.grip(before, mass, slip, rows[row + RigidRow.FRICTION] * rows[row + RigidRow.IMPULSE]);
        rows[row + RigidRow.GRIP] = next;
        return next - before;
    }

    /** Whether nothing presses or grips, so that the next friction changes nothing. */
    boolean isFree(int row) {
        float[] rows = contacts.rows;
        return rows[row + RigidRow.IMPULSE] == 0f && rows[row + RigidRow.GRIP] == 0f && rows[row + RigidRow.ROLL] == 0f;
    }
}
