package io.github.circles2d.world.jvm.bodies;

import io.github.circles2d.world.jvm.threads.Team;
import io.github.circles2d.world.model.Bounce;
import io.github.circles2d.world.model.Branchless;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.Constraints;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.Surface;
import io.github.circles2d.world.model.Tuning;
import io.github.circles2d.world.model.Velocity;

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
    private final RigidThings things;
    private final RigidOrder order;
    private final Team team;

    /** Contacts that are measured, and pairs of a colour that are visited, by so many workers that each has as many at least. */
    private final int leastShare;

    /** Whether bodies take nothing but sums. */
    private boolean summing;

    // within a step
    private StepConstants k;
    private boolean tells;

    /** See {@link #areFixed}: then several workers may push at once what does not move. */
    private boolean fixed;

    // of a pass: whether it is without bias, and the places in the order that workers have now
    private boolean relaxes;

    private int from;
    private int to;

    /** Whether a grip is -0, which a slip of 0 may change; visits make no other so. */
    private boolean gripsMinusZero;

    /** By worker: whether it has met some. */
    private final boolean[] minusZero;

    private final Team.Share begin = this::begin;
    private final Team.Share measure = this::measure;
    private final Team.Share warmStart = this::warmStart;
    private final Team.Share lookAhead = this::lookAhead;
    private final Team.Share visit = this::visitOfColour;

    RigidVisits(RigidContacts contacts, RigidThings things, RigidOrder order, Team team, int leastShare) {
        this.contacts = contacts;
        this.things = things;
        this.order = order;
        this.team = team;
        this.leastShare = leastShare;
        minusZero = new boolean[team.most()];
    }

    /** Begins a step: contacts have been found and measured; toTell: whether anybody asks how hard things have touched. */
    void begin(StepConstants constants, boolean toTell) {
        k = constants;
        tells = toTell;
        for (int t = 0; t < things.bodies; t++) {
            things.all[t].share = 0f;
        }
        for (int p = order.firstWithCircle; p < contacts.pairCount; p++) {
            RigidPair pair = contacts.pairs[p];
            for (int n = pair.begin; n < pair.end; n++) {
                RigidContact c = contacts.all[n];
                float kb = c.a == pair.a ? c.massOfA() : c.massOfB();
                if (kb > 0f) {
                    pair.a.share += kb / (kb + pair.b.ownW);
                }
            }
        }
        for (int t = 0; t < things.bodies; t++) {
            things.all[t].share = CircleMath.max(things.all[t].share, 1f);
        }
        team.share(contacts.count, 0, begin);
    }

    private void begin(int worker, int from, int end) {
        for (int n = from; n < end; n++) {
            begin(contacts.all[n]);
        }
    }

    /** Measures contacts as their things have moved. */
    void measure() {
        team.share(contacts.count, leastShare, measure);
    }

    private void measure(int worker, int from, int end) {
        for (int n = from; n < end; n++) {
            contacts.all[n].measure(k.h);
            setMasses(contacts.all[n]);
        }
    }

    /** What is accumulated acts again; on circles it has acted before. */
    void warmStart() {
        fixed = false;
        if (contacts.count < leastShare * team.size()) {
            warmStart(0, 0, things.count);
        } else {
            team.share(things.count, 0, warmStart);
        }
        gripsMinusZero = false;
        for (int worker = 0; worker < team.size(); worker++) {
            gripsMinusZero |= minusZero[worker];
        }
    }

    /** The same for some things: each gets its impulses in the order of the contacts. */
    private void warmStart(int worker, int from, int end) {
        boolean some = false;
        for (int n = 0; n < contacts.count; n++) {
            RigidContact c = contacts.all[n];
            boolean pushesA = c.a.number >= from && c.a.number < end && c.a.shape != null;
            boolean pushesB = c.b.number >= from && c.b.number < end && c.b.shape != null;
            if (!pushesA && !pushesB) {
                continue;
            }
            some |= isMinusZero(c.grip);
            if (c.impulse != 0f || c.grip != 0f) {
                float x = c.nx * c.impulse - c.ny * c.grip;
                float y = c.ny * c.impulse + c.nx * c.grip;
                if (pushesA) {
                    push(c.a, x, y, c.ax, c.ay);
                }
                if (pushesB) {
                    push(c.b, -x, -y, c.bx, c.by);
                }
            }
        }
        minusZero[worker] = some;
    }

    private void push(RigidThing t, float x, float y, float armX, float armY) {
        if (!fixed || t.gives()) {
            gain(t, t.w * x, t.w * y, t.i * (armX * y - armY * x));
        }
    }

    private void gain(RigidThing t, float x, float y, float spin) {
        if (summing && t.number < things.bodies) {
            t.addToSums(x, y, spin, k.inverseH);
        } else {
            t.add(x, y, spin);
        }
    }

    // ---- pairs that see each other as they are

    void solve() {
        relaxes = false;
        team.share(order.firstWithCircle, leastShare / 2, lookAhead); // a pair has two contacts, or one
        passByColours();
    }

    /** Looks at how contacts come together, before impulses. */
    private void lookAhead(int worker, int from, int end) {
        for (int p = from; p < end; p++) {
            RigidPair pair = contacts.pairs[p];
            pair.mayBounce = false;
            for (int n = pair.begin; n < pair.end; n++) {
                RigidContact c = contacts.all[n];
                float before = c.speedBefore();
                c.approach = Math.max(c.approach, -before);
                pair.mayBounce |= isFast(c) || c.restitution > 0f && c.isImpact(before);
            }
        }
    }

    void relax() {
        relaxes = true;
        passByColours();
    }

    /** Visits the pairs in order. Those of a colour share nothing that moves, so workers divide the large ones; what lies between these is one worker's. */
    private void passByColours() {
        fixed = areFixed();
        int done = 0;
        for (int colour = 0; colour < order.colours && team.size() > 1; colour++) {
            if (!fixed) {
                visit(done, order.begin(colour));
                done = order.begin(colour);
                fixed = areFixed();
            }
            if (fixed && order.end(colour) - order.begin(colour) >= leastShare * team.size()) {
                from = order.begin(colour);
                to = order.end(colour);
                visit(done, from);
                team.share(to - from, 0, visit);
                done = to;
            }
        }
        visit(done, order.count);
    }

    private void visitOfColour(int worker, int begin, int end) {
        visit(from + begin, from + end);
    }

    private void visit(int begin, int end) {
        for (int at = begin; at < end; at++) {
            RigidPair pair = order.order[at];
            if (relaxes) {
                relax(pair);
            } else if (pair.mayBounce || !fixed) {
                solve(pair);
            } else {
                solvePlain(pair);
            }
        }
    }

    /**
     * Whether an impulse of 0 changes no bit, nor any one a bit of what does not move: no speed is -0, which 0 makes to 0, or has to be limited. Sums never
     * become -0.
     */
    private boolean areFixed() {
        if (gripsMinusZero) {
            return false;
        }
        for (int n = 0; n < things.count; n++) {
            RigidThing t = things.all[n];
            if (RigidOrder.isOrdered(t) && (hasMinusZero(t) || !isLimited(t))) {
                return false;
            }
        }
        return true;
    }

    private static boolean hasMinusZero(RigidThing t) {
        return isMinusZero(t.vx) || isMinusZero(t.vy) || isMinusZero(t.omega);
    }

    private static boolean isMinusZero(float speed) {
        return Float.floatToRawIntBits(speed) == Integer.MIN_VALUE;
    }

    private static boolean isLimited(RigidThing t) {
        return Velocity.limitSpeed(t.vx) == t.vx
                && Velocity.limitSpeed(t.vy) == t.vy
                && Velocity.limitSpeed(t.omega) == t.omega;
    }

    /** Visits the contacts of a pair, and again those that must agree. */
    private void solve(RigidPair pair) {
        int times = 1;
        for (int time = 0; time < times; time++) {
            boolean agree = true;
            for (int n = pair.begin; n < pair.end; n++) {
                RigidContact c = contacts.all[n];
                float before = c.impulse;
                apply(c, solvedNormal(c, c.normalMass, c.normalSpeed(), c.speedBefore()));
                agree &= time == 0 || !(Math.abs(c.impulse - before) > AGREED * c.impulse);
                times = c.bounce > 0f ? Math.max(times, OF_BOUNCES) : times;
                times = isHit(c) ? OF_HITS : times;
                for (int m = pair.begin; m < pair.end && times > 1; m++) {
                    RigidContact other = contacts.all[m];
                    if (other.bounce > 0f) {
                        solveGrip(other, other.tangentMass);
                    }
                }
            }
            if (times == OF_BOUNCES && time == OF_BOUNCES - 1 && !agree) {
                times = OF_HITS;
            }
        }
    }

    /** Visits the contacts of a pair that neither bounces nor is hit. */
    private void solvePlain(RigidPair pair) {
        for (int n = pair.begin; n < pair.end; n++) {
            RigidContact c = contacts.all[n];
            apply(c, solvedNormal(c, c.normalSpeed()));
        }
    }

    /** Behind each normal all frictions of the pair: with fewer visits a pyramid sways for long. */
    private void relax(RigidPair pair) {
        for (int n = pair.begin; n < pair.end; n++) {
            relaxNormal(contacts.all[n]);
            for (int m = pair.begin; m < pair.end; m++) {
                solveGrip(contacts.all[m], contacts.all[m].tangentMass);
            }
        }
    }

    private void relaxNormal(RigidContact c) {
        if (!c.isIdle()) {
            float vn = c.normalSpeed();
            if (!bouncesLater(c, vn)) {
                apply(c, relaxedNormal(c, c.normalMass, vn));
            }
        }
    }

    private void apply(RigidContact c, float gain) {
        if (!fixed || gain != 0f) {
            pushBoth(c, c.nx * gain, c.ny * gain);
        }
    }

    /** Pushes A, and B the other way. */
    private void pushBoth(RigidContact c, float x, float y) {
        push(c.a, x, y, c.ax, c.ay);
        push(c.b, -x, -y, c.bx, c.by);
    }

    /** Friction and rolling resistance, by the normal impulse. */
    private void solveGrip(RigidContact c, float mass) {
        if (fixed && c.isFree()) {
            return;
        }
        if (c.hasGrip()) {
            float gain = gripped(c, mass, c.speedY() * c.nx - c.speedX() * c.ny);
            pushBoth(c, -c.ny * gain, c.nx * gain);
        }
        float turns = c.rolling > 0f ? c.a.ownI + c.b.ownI : 0f;
        if (turns > 0f) {
            float before = c.roll;
            float omega = c.a.omega - c.b.omega;
            c.roll = Surface.rolling(before, RigidContact.massOf(turns), omega, c.rolling * c.impulse);
            gain(c.a, 0f, 0f, c.a.i * (c.roll - before));
            gain(c.b, 0f, 0f, -c.b.i * (c.roll - before));
        }
    }

    /** Impulses of bounces are not kept: they have acted once for all. */
    void forgetBounces() {
        for (int n = 0; n < contacts.count; n++) {
            if (contacts.all[n].bounce > 0f) {
                contacts.all[n].forgetImpulses();
            }
        }
    }

    // ---- circles, which see bodies as they were

    /** A pass over the contacts of circles. */
    void passOverCircles(boolean withoutBias) {
        if (order.firstWithCircle == contacts.pairCount) {
            return;
        }
        summing = true;
        fixed = false;
        for (int t = 0; t < things.bodies; t++) {
            things.all[t].clearSums();
        }
        for (int p = order.firstWithCircle; p < contacts.pairCount; p++) {
            RigidPair pair = contacts.pairs[p];
            for (int n = pair.begin; n < pair.end; n++) {
                visit(contacts.all[n], pair.a, withoutBias);
            }
        }
        summing = false;
        for (int n = 0; n < things.bodies; n++) {
            RigidThing t = things.all[n];
            t.vx += t.summedX(k.inverseH);
            t.vy += t.summedY(k.inverseH);
            t.omega += t.summedOmega(k.inverseH);
        }
    }

    private void visit(RigidContact c, RigidThing body, boolean withoutBias) {
        // what sleeps on what moves by itself keeps its impulses
        if (withoutBias && c.isIdle() || !c.a.gives() && !c.b.gives()) {
            return;
        }
        float shareA = c.a == body ? body.share : 1f;
        float shareB = c.b == body ? body.share : 1f;
        float mass = RigidContact.massOf(shareA * c.massOfA() + shareB * c.massOfB());
        float vn = c.normalSpeed();
        apply(c, withoutBias ? relaxedNormal(c, mass, vn) : solvedNormal(c, mass, vn, c.speedBefore()));
        if (withoutBias || c.bounce > 0f) {
            solveGrip(c, c.gripMass(shareA, shareB));
        }
    }

    // ---- what a contact does

    /** What both things of a contact have together. */
    private void begin(RigidContact c) {
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
    private void setMasses(RigidContact c) {
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
    private boolean isHit(RigidContact c) {
        return isFast(c) && c.impulse > 0f;
    }

    private boolean isFast(RigidContact c) {
        return c.approach * k.h > Tuning.CAP * c.length;
    }

    /** Whether a contact has closed without an impulse, as a body turns: it is to bounce in the next sub-step, not to stop now. */
    private boolean bouncesLater(RigidContact c, float vn) {
        return c.restitution > 0f && c.impulse == 0f && !(c.gap > 0f) && bounceSpeed(c, vn) > 0f;
    }

    /** Solves with bias along the normal, where contacts bounce, too; before: the speed before impulses. Returns what the impulse gains. */
    private float solvedNormal(RigidContact c, float mass, float vn, float before) {
        c.approach = Branchless.greater(c.approach, -before);
        c.bounce = c.restitution > 0f ? bounceSpeed(c, before) : 0f;
        return take(c, Constraints.solve(c.impulse, mass, vn, c.gap, c.bounce, pushSpeed(c), k.contactSoftness, k));
    }

    /** Solves with bias along the normal of a contact that does not bounce. Returns what the impulse gains. */
    private float solvedNormal(RigidContact c, float vn) {
        return take(c, Constraints.visit(c.impulse, c.normalMass, c.speedScale, vn, c.bias, c.decay * c.impulse));
    }

    private float relaxedNormal(RigidContact c, float mass, float vn) {
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
    private float gripped(RigidContact c, float mass, float along) {
        float before = c.grip;
        c.grip = Surface.grip(before, mass, along - c.belts, c.friction * c.impulse);
        return c.grip - before;
    }
}
