package io.github.circles2d.world.jvm;

import io.github.circles2d.world.model.Bounce;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.Constraints;
import io.github.circles2d.world.model.CrossRule;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.Surface;
import io.github.circles2d.world.model.Tuning;
import io.github.circles2d.world.model.Velocity;
import java.util.Arrays;

/**
 * The passes over the contacts of rigid bodies: pairs of bodies, pieces and walls by their colours, then circles, whose bodies take the sum of their
 * visits at the end.
 */
final class RigidVisits {
    /** Visits of a pair that bounces, so that its contacts agree; {@link #OF_HITS} if they do not yet. */
    private static final int OF_BOUNCES = 4;

    /** Share of an impulse: if a visit changes none by more, contacts agree. */
    private static final float AGREED = 1e-3f;

    /** Visits of a pair that comes fast: the contacts of a body that hits askew must agree before it moves on. */
    private static final int OF_HITS = 16;

    /** Greatest speed of push-outs, by that of circles: half thicknesses are greater than what touches. */
    private static final float PUSH = 0.5f;

    private static final float LEAST_BOUNCE = 1e-6f;

    /** No masses and speeds that a world takes need more. It and the greatest speed keep all finite: of what is not, processors make what they like. */
    private static final float GREATEST_IMPULSE = 1e20f;

    private final RigidContacts contacts;
    private final RigidPairs pairs;
    private final RigidThings things;
    private final RigidOrder order;

    /** By body: as how many it counts where circles push it at once. */
    private float[] share = new float[0];

    /** By body: what circles give in a pass, in units. */
    private long[] sums = new long[0];

    /** By contact without a circle: effective masses along the normal and the tangent, since contacts were measured. */
    private float[] normalMass = new float[0];

    private float[] tangentMass = new float[0];

    /** Whether bodies take nothing but sums. */
    private boolean summing;

    private StepConstants k;

    RigidVisits(RigidContacts contacts, RigidPairs pairs, RigidOrder order) {
        this.contacts = contacts;
        this.pairs = pairs;
        this.order = order;
        things = pairs.things;
    }

    /** Begins a step: contacts have been found and measured. */
    void begin(StepConstants constants) {
        k = constants;
        if (share.length < things.bodies) {
            share = new float[2 * things.bodies];
            sums = new long[6 * things.bodies];
        }
        Arrays.fill(share, 0, things.bodies, 0f);
        for (int p = order.firstWithCircle; p < contacts.pairCount; p++) {
            for (int c = contacts.firstOf[p]; c < contacts.firstOf[p + 1]; c++) {
                int body = pairs.a[contacts.pair[p]];
                int circle = pairs.b[contacts.pair[p]];
                float kb = contacts.a[c] == body ? massOfA(c) : massOfB(c);
                if (kb > 0f) {
                    share[body] += kb / (kb + things.ownW[circle]);
                }
            }
        }
        for (int t = 0; t < things.bodies; t++) {
            share[t] = CircleMath.max(share[t], 1f);
        }
        measured();
    }

    /** To be told when contacts have been measured. */
    void measured() {
        if (normalMass.length < contacts.count) {
            normalMass = new float[2 * contacts.count];
            tangentMass = new float[2 * contacts.count];
        }
        int end = contacts.firstOf[order.firstWithCircle];
        for (int c = 0; c < end; c++) {
            normalMass[c] = massOf(massOfA(c) + massOfB(c));
            tangentMass[c] = gripMass(c, 1f, 1f);
        }
    }

    /** One over the effective mass of A alone along the normal. */
    float massOfA(int c) {
        int t = contacts.a[c];
        float arm = contacts.ax[c] * contacts.ny[c] - contacts.ay[c] * contacts.nx[c];
        return things.ownW[t] + things.ownI[t] * arm * arm;
    }

    float massOfB(int c) {
        int t = contacts.b[c];
        float arm = contacts.bx[c] * contacts.ny[c] - contacts.by[c] * contacts.nx[c];
        return things.ownW[t] + things.ownI[t] * arm * arm;
    }

    /** What is accumulated acts again; on circles it has acted before. */
    void warmStart() {
        for (int c = 0; c < contacts.count; c++) {
            if (contacts.impulse[c] != 0f || contacts.grip[c] != 0f) {
                float x = contacts.nx[c] * contacts.impulse[c] - contacts.ny[c] * contacts.grip[c];
                float y = contacts.ny[c] * contacts.impulse[c] + contacts.nx[c] * contacts.grip[c];
                if (things.shape[contacts.a[c]] != null) {
                    push(contacts.a[c], x, y, contacts.ax[c], contacts.ay[c]);
                }
                if (things.shape[contacts.b[c]] != null) {
                    push(contacts.b[c], -x, -y, contacts.bx[c], contacts.by[c]);
                }
            }
        }
    }

    private void push(int t, float x, float y, float armX, float armY) {
        gain(t, things.w[t] * x, things.w[t] * y, things.i[t] * (armX * y - armY * x));
    }

    private void gain(int t, float x, float y, float spin) {
        if (summing && t < things.bodies) {
            float scale = CrossRule.scaleOf(CrossRule.velocityRange(things.reach[t], k.inverseH));
            sums[3 * t] += CrossRule.toFixed(x, scale);
            sums[3 * t + 1] += CrossRule.toFixed(y, scale);
            sums[3 * t + 2] += CrossRule.toFixed(spin, CrossRule.scaleOf(k.inverseH));
        } else {
            things.vx[t] = Velocity.limitSpeed(things.vx[t] + x);
            things.vy[t] = Velocity.limitSpeed(things.vy[t] + y);
            things.omega[t] = Velocity.limitSpeed(things.omega[t] + spin);
        }
    }

    // ---- pairs that see each other as they are
    // -----------------------------------------------------------------------------

    void solve() {
        for (int at = 0; at < order.count; at++) {
            int from = contacts.firstOf[order.order[at]];
            int to = contacts.firstOf[order.order[at] + 1];
            int times = 1;
            for (int time = 0; time < times; time++) {
                boolean agree = true;
                for (int c = from; c < to; c++) {
                    float before = contacts.impulse[c];
                    solveNormal(c);
                    if (Math.abs(contacts.impulse[c] - before) > AGREED * contacts.impulse[c]) {
                        agree = false;
                    }
                    times = contacts.bounce[c] > 0f ? Math.max(times, OF_BOUNCES) : times;
                    times = isHit(c) ? OF_HITS : times;
                    for (int other = from; other < to && times > 1; other++) {
                        if (contacts.bounce[other] > 0f) {
                            solveGrip(other, tangentMass[other]);
                        }
                    }
                }
                if (times == OF_BOUNCES && time == OF_BOUNCES - 1 && !agree) {
                    times = OF_HITS;
                }
            }
        }
    }

    /** Behind each normal all frictions of the pair: with fewer visits a pyramid sways for long. */
    void relax() {
        for (int at = 0; at < order.count; at++) {
            int from = contacts.firstOf[order.order[at]];
            int to = contacts.firstOf[order.order[at] + 1];
            for (int c = from; c < to; c++) {
                relaxNormal(c);
                for (int other = from; other < to; other++) {
                    solveGrip(other, tangentMass[other]);
                }
            }
        }
    }

    /** Whether a contact stops what would come far into the other within a sub-step. */
    private boolean isHit(int c) {
        return contacts.impulse[c] > 0f && contacts.approach[c] * k.h > Tuning.CAP * thickness(c);
    }

    private void solveNormal(int c) {
        apply(c, solvedNormal(c, normalMass[c], normalSpeed(c)));
    }

    private void relaxNormal(int c) {
        float vn = normalSpeed(c);
        if (!isIdle(c) && !bouncesLater(c, vn)) {
            apply(c, relaxedNormal(c, normalMass[c], vn));
        }
    }

    /** Whether a contact has closed without an impulse, as a body turns: it is to bounce in the next sub-step, not to stop now. */
    private boolean bouncesLater(int c, float vn) {
        if (contacts.impulse[c] != 0f || contacts.gap[c] > 0f) {
            return false;
        }
        float length = thickness(c);
        return bounceSpeed(c, length, PUSH * k.pushRate * length, vn) > 0f;
    }

    private boolean isIdle(int c) {
        return contacts.gap[c] > 0f && contacts.impulse[c] == 0f && contacts.grip[c] == 0f;
    }

    private void apply(int c, float gain) {
        float x = contacts.nx[c] * gain;
        float y = contacts.ny[c] * gain;
        push(contacts.a[c], x, y, contacts.ax[c], contacts.ay[c]);
        push(contacts.b[c], -x, -y, contacts.bx[c], contacts.by[c]);
    }

    private float normalSpeed(int c) {
        return speedX(c) * contacts.nx[c] + speedY(c) * contacts.ny[c];
    }

    private float speedX(int c) {
        int a = contacts.a[c];
        int b = contacts.b[c];
        return (things.vx[a] - things.omega[a] * contacts.ay[c]) - (things.vx[b] - things.omega[b] * contacts.by[c]);
    }

    private float speedY(int c) {
        int a = contacts.a[c];
        int b = contacts.b[c];
        return (things.vy[a] + things.omega[a] * contacts.ax[c]) - (things.vy[b] + things.omega[b] * contacts.bx[c]);
    }

    /** By how much lengths of a contact are measured. */
    private float thickness(int c) {
        int a = contacts.a[c];
        int b = contacts.b[c];
        return things.ownW[a] == 0f
                ? 2f * things.thin[b]
                : things.ownW[b] == 0f ? 2f * things.thin[a] : things.thin[a] + things.thin[b];
    }

    /** Solves with bias along the normal, where contacts bounce, too; returns what the impulse gains. */
    private float solvedNormal(int c, float mass, float vn) {
        float length = thickness(c);
        float pushSpeed = PUSH * k.pushRate * length;
        float before = speedBefore(c);
        contacts.approach[c] = CircleMath.max(contacts.approach[c], -before);
        contacts.bounce[c] = bounceSpeed(c, length, pushSpeed, before);
        float accumulated = contacts.impulse[c];
        float next = Constraints.solve(
                accumulated, mass, vn, contacts.gap[c], contacts.bounce[c], pushSpeed, k.contactSoftness, k);
        return take(c, next);
    }

    private float relaxedNormal(int c, float mass, float vn) {
        float next = Constraints.relax(contacts.impulse[c], mass, vn, contacts.gap[c], 0f, k.inverseH);
        return take(c, next);
    }

    private float take(int c, float wanted) {
        float next = CircleMath.min(wanted, GREATEST_IMPULSE);
        float gain = next - contacts.impulse[c];
        contacts.impulse[c] = next;
        contacts.most[c] = CircleMath.max(contacts.most[c], next);
        return gain;
    }

    /** Along the normal, before impulses. */
    private float speedBefore(int c) {
        int a = contacts.a[c];
        int b = contacts.b[c];
        float ux = (things.beforeX[a] - things.beforeOmega[a] * contacts.ay[c])
                - (things.beforeX[b] - things.beforeOmega[b] * contacts.by[c]);
        float uy = (things.beforeY[a] + things.beforeOmega[a] * contacts.ax[c])
                - (things.beforeY[b] + things.beforeOmega[b] * contacts.bx[c]);
        return ux * contacts.nx[c] + uy * contacts.ny[c];
    }

    private float bounceSpeed(int c, float length, float pushSpeed, float before) {
        int a = contacts.a[c];
        int b = contacts.b[c];
        float e = CircleMath.max(things.restitution[a], things.restitution[b]);
        if (!(e > 0f)) {
            return 0f;
        }
        float threshold = Bounce.bounceThreshold(length, e, k.thresholdRate, k.restRate, k.fixedThreshold);
        if (!(Constraints.bounceSpeed(e, 1f, before, contacts.gap[c], k.h, threshold, pushSpeed) > 0f)) {
            return 0f;
        }
        int falls = things.w[a] == 0f ? b : a;
        float fall = things.gainX[falls] * contacts.nx[c] + things.gainY[falls] * contacts.ny[c];
        float half = Bounce.halfFall(fall, things.w[b], things.w[a]);
        return CircleMath.max(-e * before + (1f + e) * half, LEAST_BOUNCE);
    }

    /** Friction and rolling resistance, by the normal impulse. */
    private void solveGrip(int c, float mass) {
        int a = contacts.a[c];
        int b = contacts.b[c];
        float friction = Surface.friction(things.friction[a], things.friction[b]);
        if (friction > 0f) {
            float before = contacts.grip[c];
            float next = Surface.grip(before, mass, slip(c, speedX(c), speedY(c)), friction * contacts.impulse[c]);
            contacts.grip[c] = next;
            float x = -contacts.ny[c] * (next - before);
            float y = contacts.nx[c] * (next - before);
            push(a, x, y, contacts.ax[c], contacts.ay[c]);
            push(b, -x, -y, contacts.bx[c], contacts.by[c]);
        }
        float resistance = CircleMath.max(things.rolling[a], things.rolling[b]);
        float turns = things.ownI[a] + things.ownI[b];
        if (resistance > 0f && turns > 0f) {
            float before = contacts.roll[c];
            float next = Surface.rolling(
                    before, massOf(turns), things.omega[a] - things.omega[b], resistance * contacts.impulse[c]);
            contacts.roll[c] = next;
            gain(a, 0f, 0f, things.i[a] * (next - before));
            gain(b, 0f, 0f, -things.i[b] * (next - before));
        }
    }

    /** Shares: 1, or of what counts as lighter. */
    private float gripMass(int c, float shareA, float shareB) {
        int a = contacts.a[c];
        int b = contacts.b[c];
        float armA = contacts.ax[c] * contacts.nx[c] + contacts.ay[c] * contacts.ny[c];
        float armB = contacts.bx[c] * contacts.nx[c] + contacts.by[c] * contacts.ny[c];
        return massOf(shareA * (things.ownW[a] + things.ownI[a] * armA * armA)
                + shareB * (things.ownW[b] + things.ownI[b] * armB * armB));
    }

    /** An effective mass, from one over it. No impulse moves what has none. */
    private static float massOf(float inverse) {
        return inverse >= Float.MIN_NORMAL ? 1f / inverse : 0f;
    }

    private float slip(int c, float ux, float uy) {
        float along = uy * contacts.nx[c] - ux * contacts.ny[c];
        return along - (things.belt[contacts.a[c]] + things.belt[contacts.b[c]]);
    }

    /** Impulses of bounces are not kept: they have acted once for all. */
    void forgetBounces() {
        for (int c = 0; c < contacts.count; c++) {
            if (contacts.bounce[c] > 0f) {
                contacts.bounce[c] = 0f;
                contacts.impulse[c] = 0f;
                contacts.grip[c] = 0f;
                contacts.roll[c] = 0f;
            }
        }
    }

    // ---- circles, which see bodies as they were
    // ----------------------------------------------------------------------------

    /** A pass over the contacts of circles. */
    void passOverCircles(boolean relaxes) {
        if (order.firstWithCircle == contacts.pairCount) {
            return;
        }
        summing = true;
        Arrays.fill(sums, 0, 3 * things.bodies, 0L);
        for (int p = order.firstWithCircle; p < contacts.pairCount; p++) {
            for (int c = contacts.firstOf[p]; c < contacts.firstOf[p + 1]; c++) {
                visit(c, pairs.a[contacts.pair[p]], relaxes);
            }
        }
        summing = false;
        float spinUnit = CrossRule.unitOf(k.inverseH);
        for (int t = 0; t < things.bodies; t++) {
            float unit = CrossRule.unitOf(CrossRule.velocityRange(things.reach[t], k.inverseH));
            things.vx[t] += CrossRule.fromFixed(sums[3 * t], unit);
            things.vy[t] += CrossRule.fromFixed(sums[3 * t + 1], unit);
            things.omega[t] += CrossRule.fromFixed(sums[3 * t + 2], spinUnit);
        }
    }

    private void visit(int c, int body, boolean relaxes) {
        float shareA = contacts.a[c] == body ? share[body] : 1f;
        float shareB = contacts.b[c] == body ? share[body] : 1f;
        if (relaxes && isIdle(c) || !isVisited(c)) {
            return;
        }
        float mass = massOf(shareA * massOfA(c) + shareB * massOfB(c));
        float vn = normalSpeed(c);
        apply(c, relaxes ? relaxedNormal(c, mass, vn) : solvedNormal(c, mass, vn));
        if (relaxes || contacts.bounce[c] > 0f) {
            solveGrip(c, gripMass(c, shareA, shareB));
        }
    }

    /** Whether one of both gives. What sleeps on what moves by itself keeps its impulses. */
    private boolean isVisited(int c) {
        return things.gives(contacts.a[c]) || things.gives(contacts.b[c]);
    }

    long bytes() {
        return 4L * (share.length + normalMass.length + tangentMass.length) + 8L * sums.length;
    }
}
