package io.github.circles2d.world.jvm;

import io.github.circles2d.world.jvm.threads.Team;
import io.github.circles2d.world.model.Bounce;
import io.github.circles2d.world.model.Branchless;
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
    private final Team team;

    /** Contacts that are measured, and pairs of a colour that are visited, by so many workers that each has as many at least. */
    private final int leastShare;

    /** By body: as how many it counts where circles push it at once. */
    private float[] share = new float[0];

    /** By body: what circles give in a pass, in units. */
    private long[] sums = new long[0];

    /** Whether bodies take nothing but sums. */
    private boolean summing;

    private StepConstants k;
    private boolean tells;

    /** See {@link #areFixed}: then several workers may push at once what does not move. */
    private boolean fixed;

    // of a pass: whether it is without bias, and the places in the order that workers have now
    private boolean relaxes;

    private int from;
    private int to;

    private final RigidPairVisits ofPairs;

    /** By pair without circles: whether it is one of {@link #ofPairs}. */
    private boolean[] plain = new boolean[0];

    /** By pair without circles: whether it may bounce in this sub-step, or be a hit. */
    private boolean[] mayBounce = new boolean[0];

    /** Whether a grip is -0, which a slip of 0 may change; visits make no other so. */
    private boolean gripsMinusZero;

    /** By worker: whether it has met some. */
    private final boolean[] minusZero;

    private final Team.Work measure = this::measure;
    private final Team.Work visit = this::visit;
    private final Team.Work begin = this::begin;
    private final Team.Work warmStart = this::warmStart;
    private final Team.Work lookAhead = this::lookAhead;

    RigidVisits(RigidContacts contacts, RigidPairs pairs, RigidOrder order, Team team, int leastShare) {
        this.contacts = contacts;
        this.pairs = pairs;
        this.order = order;
        this.team = team;
        this.leastShare = leastShare;
        minusZero = new boolean[team.most()];
        things = pairs.things;
        ofPairs = new RigidPairVisits(contacts, things, this);
    }

    /** Begins a step: contacts have been found and measured; toTell: whether anybody asks how hard things have touched. */
    void begin(StepConstants constants, boolean toTell) {
        k = constants;
        tells = toTell;
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
        if (plain.length < order.firstWithCircle) {
            plain = new boolean[2 * order.firstWithCircle];
            mayBounce = new boolean[2 * order.firstWithCircle];
        }
        team.together(begin);
    }

    /** What both things of a contact have together. */
    private void begin(int worker) {
        float[] rows = contacts.rows;
        int end = team.part(contacts.count, worker + 1);
        for (int c = team.part(contacts.count, worker); c < end; c++) {
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
        int endPair = team.part(order.firstWithCircle, worker + 1);
        for (int p = team.part(order.firstWithCircle, worker); p < endPair; p++) {
            plain[p] = ofPairs.has(contacts.firstOf[p], contacts.firstOf[p + 1]);
        }
    }

    /** Measures contacts as their things have moved. */
    void measure() {
        if (contacts.count < leastShare * team.size()) {
            measure(0, contacts.count);
        } else {
            team.together(measure);
        }
    }

    private void measure(int worker) {
        measure(team.part(contacts.count, worker), team.part(contacts.count, worker + 1));
    }

    private void measure(int begin, int end) {
        for (int c = begin; c < end; c++) {
            contacts.measures.measure(c);
            setMasses(c);
        }
    }

    private void setMasses(int c) {
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
        int t = contacts.a[c];
        float[] rows = contacts.rows;
        int row = RigidRow.of(c);
        float arm =
                rows[row + RigidRow.AX] * rows[row + RigidRow.NY] - rows[row + RigidRow.AY] * rows[row + RigidRow.NX];
        return things.ownW[t] + things.ownI[t] * arm * arm;
    }

    float massOfB(int c) {
        int t = contacts.b[c];
        float[] rows = contacts.rows;
        int row = RigidRow.of(c);
        float arm =
                rows[row + RigidRow.BX] * rows[row + RigidRow.NY] - rows[row + RigidRow.BY] * rows[row + RigidRow.NX];
        return things.ownW[t] + things.ownI[t] * arm * arm;
    }

    /** What is accumulated acts again; on circles it has acted before. */
    void warmStart() {
        fixed = false;
        if (contacts.count < leastShare * team.size()) {
            warmStart(0, 0, things.count);
        } else {
            team.together(warmStart);
        }
        gripsMinusZero = false;
        for (int worker = 0; worker < team.size(); worker++) {
            gripsMinusZero |= minusZero[worker];
        }
    }

    private void warmStart(int worker) {
        warmStart(worker, team.part(things.count, worker), team.part(things.count, worker + 1));
    }

    /** The same for some things: each gets its impulses in the order of the contacts. */
    private void warmStart(int worker, int from, int end) {
        boolean some = false;
        float[] rows = contacts.rows;
        for (int c = 0; c < contacts.count; c++) {
            int a = contacts.a[c];
            int b = contacts.b[c];
            boolean pushesA = a >= from && a < end && things.shape[a] != null;
            boolean pushesB = b >= from && b < end && things.shape[b] != null;
            if (!pushesA && !pushesB) {
                continue;
            }
            int row = RigidRow.of(c);
            float impulse = rows[row + RigidRow.IMPULSE];
            float grip = rows[row + RigidRow.GRIP];
            some |= isMinusZero(grip);
            if (impulse != 0f || grip != 0f) {
                float x = rows[row + RigidRow.NX] * impulse - rows[row + RigidRow.NY] * grip;
                float y = rows[row + RigidRow.NY] * impulse + rows[row + RigidRow.NX] * grip;
                if (pushesA) {
                    push(a, x, y, rows[row + RigidRow.AX], rows[row + RigidRow.AY]);
                }
                if (pushesB) {
                    push(b, -x, -y, rows[row + RigidRow.BX], rows[row + RigidRow.BY]);
                }
            }
        }
        minusZero[worker] = some;
    }

    private void push(int t, float x, float y, float armX, float armY) {
        if (fixed && !things.gives(t)) {
            return;
        }
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
        relaxes = false;
        if (contacts.count < leastShare * team.size()) {
            lookAhead(0, order.firstWithCircle);
        } else {
            team.together(lookAhead);
        }
        passByColours();
    }

    private void lookAhead(int worker) {
        lookAhead(team.part(order.firstWithCircle, worker), team.part(order.firstWithCircle, worker + 1));
    }

    /** Looks at how contacts come together, before impulses. */
    private void lookAhead(int from, int end) {
        float[] rows = contacts.rows;
        for (int p = from; p < end; p++) {
            boolean bounces = false;
            for (int c = contacts.firstOf[p]; c < contacts.firstOf[p + 1]; c++) {
                int row = RigidRow.of(c);
                float before = speedBefore(c);
                rows[row + RigidRow.APPROACH] = Math.max(rows[row + RigidRow.APPROACH], -before);
                bounces |= isFast(row) || rows[row + RigidRow.RESTITUTION] > 0f && isImpact(row, before);
            }
            mayBounce[p] = bounces;
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
                team.together(visit);
                done = to;
            }
        }
        visit(done, order.count);
    }

    private void visit(int worker) {
        visit(from + team.part(to - from, worker), from + team.part(to - from, worker + 1));
    }

    private void visit(int begin, int end) {
        for (int at = begin; at < end; at++) {
            int p = order.order[at];
            if (fixed && plain[p] && (relaxes || !mayBounce[p])) {
                if (relaxes) {
                    ofPairs.relax(contacts.firstOf[p], contacts.firstOf[p + 1]);
                } else {
                    ofPairs.solve(contacts.firstOf[p], contacts.firstOf[p + 1]);
                }
            } else if (relaxes) {
                relax(contacts.firstOf[p], contacts.firstOf[p + 1]);
            } else {
                solve(contacts.firstOf[p], contacts.firstOf[p + 1]);
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
        for (int t = 0; t < things.count; t++) {
            if (order.isOrdered(t)
                    && (isMinusZero(things.vx[t])
                            || isMinusZero(things.vy[t])
                            || isMinusZero(things.omega[t])
                            || !isLimited(t))) {
                return false;
            }
        }
        return true;
    }

    private static boolean isMinusZero(float speed) {
        return Float.floatToRawIntBits(speed) == Integer.MIN_VALUE;
    }

    private boolean isLimited(int t) {
        return Velocity.limitSpeed(things.vx[t]) == things.vx[t]
                && Velocity.limitSpeed(things.vy[t]) == things.vy[t]
                && Velocity.limitSpeed(things.omega[t]) == things.omega[t];
    }

    /** Visits the contacts of a pair, and again those that must agree. */
    private void solve(int begin, int end) {
        float[] rows = contacts.rows;
        int times = 1;
        for (int time = 0; time < times; time++) {
            boolean agree = true;
            for (int c = begin; c < end; c++) {
                int row = RigidRow.of(c);
                float before = rows[row + RigidRow.IMPULSE];
                solveNormal(c);
                if (time > 0) {
                    float impulse = rows[row + RigidRow.IMPULSE];
                    agree &= !(Math.abs(impulse - before) > AGREED * impulse);
                }
                times = rows[row + RigidRow.BOUNCE] > 0f ? Math.max(times, OF_BOUNCES) : times;
                times = isHit(row) ? OF_HITS : times;
                for (int other = begin; other < end && times > 1; other++) {
                    if (rows[RigidRow.of(other) + RigidRow.BOUNCE] > 0f) {
                        solveGrip(other, rows[RigidRow.of(other) + RigidRow.TANGENT_MASS]);
                    }
                }
            }
            if (times == OF_BOUNCES && time == OF_BOUNCES - 1 && !agree) {
                times = OF_HITS;
            }
        }
    }

    /** Behind each normal all frictions of the pair: with fewer visits a pyramid sways for long. */
    private void relax(int begin, int end) {
        for (int c = begin; c < end; c++) {
            relaxNormal(c);
            for (int other = begin; other < end; other++) {
                solveGrip(other, contacts.rows[RigidRow.of(other) + RigidRow.TANGENT_MASS]);
            }
        }
    }

    /** Whether a contact stops what would come far into the other within a sub-step. */
    private boolean isHit(int row) {
        return isFast(row) && contacts.rows[row + RigidRow.IMPULSE] > 0f;
    }

    private boolean isFast(int row) {
        float[] rows = contacts.rows;
        return rows[row + RigidRow.APPROACH] * k.h > Tuning.CAP * rows[row + RigidRow.LENGTH];
    }

    private void solveNormal(int c) {
        float mass = contacts.rows[RigidRow.of(c) + RigidRow.NORMAL_MASS];
        float vn = normalSpeed(c);
        apply(c, solvedNormal(c, mass, vn, speedBefore(c)));
    }

    private void relaxNormal(int c) {
        int row = RigidRow.of(c);
        if (isIdle(row)) {
            return;
        }
        float mass = contacts.rows[row + RigidRow.NORMAL_MASS];
        float vn = normalSpeed(c);
        if (!bouncesLater(c, vn)) {
            apply(c, relaxedNormal(row, mass, vn));
        }
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

    private void apply(int c, float gain) {
        if (!fixed || gain != 0f) {
            float[] rows = contacts.rows;
            int row = RigidRow.of(c);
            pushBoth(c, rows[row + RigidRow.NX] * gain, rows[row + RigidRow.NY] * gain);
        }
    }

    /** Pushes A, and B the other way. */
    private void pushBoth(int c, float x, float y) {
        float[] rows = contacts.rows;
        int row = RigidRow.of(c);
        float ax = rows[row + RigidRow.AX];
        float ay = rows[row + RigidRow.AY];
        float bx = rows[row + RigidRow.BX];
        float by = rows[row + RigidRow.BY];
        push(contacts.a[c], x, y, ax, ay);
        push(contacts.b[c], -x, -y, bx, by);
    }

    private float normalSpeed(int c) {
        int a = contacts.a[c];
        int b = contacts.b[c];
        float[] rows = contacts.rows;
        int row = RigidRow.of(c);
        return speedX(rows, row, things.vx, things.omega, a, b) * rows[row + RigidRow.NX]
                + speedY(rows, row, things.vy, things.omega, a, b) * rows[row + RigidRow.NY];
    }

    private static float speedX(float[] rows, int row, float[] vx, float[] omega, int a, int b) {
        return (vx[a] - omega[a] * rows[row + RigidRow.AY]) - (vx[b] - omega[b] * rows[row + RigidRow.BY]);
    }

    private static float speedY(float[] rows, int row, float[] vy, float[] omega, int a, int b) {
        return (vy[a] + omega[a] * rows[row + RigidRow.AX]) - (vy[b] + omega[b] * rows[row + RigidRow.BX]);
    }

    /** Solves with bias along the normal, where contacts bounce, too; before: the speed before impulses. Returns what the impulse gains. */
    private float solvedNormal(int c, float mass, float vn, float before) {
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

    /** Along the normal, before impulses. */
    private float speedBefore(int c) {
        float[] rows = contacts.rows;
        int row = RigidRow.of(c);
        int a = contacts.a[c];
        int b = contacts.b[c];
        return speedX(rows, row, things.beforeX, things.beforeOmega, a, b) * rows[row + RigidRow.NX]
                + speedY(rows, row, things.beforeY, things.beforeOmega, a, b) * rows[row + RigidRow.NY];
    }

    /** Whether a contact with a restitution is fast enough to bounce. */
    private boolean isImpact(int row, float before) {
        return before < 0f && before * before > contacts.rows[row + RigidRow.THRESHOLD];
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
        float fall = things.gainX[falls] * rows[row + RigidRow.NX] + things.gainY[falls] * rows[row + RigidRow.NY];
        float half = Bounce.halfFall(fall, things.w[b], things.w[a]);
        return CircleMath.max(-e * before + (1f + e) * half, LEAST_BOUNCE);
    }

    /** Friction and rolling resistance, by the normal impulse. */
    private void solveGrip(int c, float mass) {
        float[] rows = contacts.rows;
        int row = RigidRow.of(c);
        int a = contacts.a[c];
        int b = contacts.b[c];
        if (fixed && isFree(row)) {
            return;
        }
        if (hasGrip(row)) {
            float nx = rows[row + RigidRow.NX];
            float ny = rows[row + RigidRow.NY];
            float ux = speedX(rows, row, things.vx, things.omega, a, b);
            float uy = speedY(rows, row, things.vy, things.omega, a, b);
            float gain = gripped(row, mass, uy * nx - ux * ny);
            pushBoth(c, -ny * gain, nx * gain);
        }
        float resistance = rows[row + RigidRow.ROLLING];
        float turns = resistance > 0f ? things.ownI[a] + things.ownI[b] : 0f;
        if (turns > 0f) {
            float before = rows[row + RigidRow.ROLL];
            float next = Surface.rolling(
                    before,
                    massOf(turns),
                    things.omega[a] - things.omega[b],
                    resistance * rows[row + RigidRow.IMPULSE]);
            rows[row + RigidRow.ROLL] = next;
            gain(a, 0f, 0f, things.i[a] * (next - before));
            gain(b, 0f, 0f, -things.i[b] * (next - before));
        }
    }

    /** Whether there is friction, or has been. */
    private boolean hasGrip(int row) {
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
    private boolean isFree(int row) {
        float[] rows = contacts.rows;
        return rows[row + RigidRow.IMPULSE] == 0f && rows[row + RigidRow.GRIP] == 0f && rows[row + RigidRow.ROLL] == 0f;
    }

    /** Shares: 1, or of what counts as lighter. */
    private float gripMass(int c, float shareA, float shareB) {
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
    private static float massOf(float inverse) {
        return inverse >= Float.MIN_NORMAL ? 1f / inverse : 0f;
    }

    /** Impulses of bounces are not kept: they have acted once for all. */
    void forgetBounces() {
        float[] rows = contacts.rows;
        for (int c = 0; c < contacts.count; c++) {
            int row = RigidRow.of(c);
            if (rows[row + RigidRow.BOUNCE] > 0f) {
                rows[row + RigidRow.BOUNCE] = 0f;
                rows[row + RigidRow.IMPULSE] = 0f;
                rows[row + RigidRow.GRIP] = 0f;
                rows[row + RigidRow.ROLL] = 0f;
            }
        }
    }

    // ---- circles, which see bodies as they were
    // ----------------------------------------------------------------------------

    /** A pass over the contacts of circles. */
    void passOverCircles(boolean withoutBias) {
        if (order.firstWithCircle == contacts.pairCount) {
            return;
        }
        summing = true;
        fixed = false;
        Arrays.fill(sums, 0, 3 * things.bodies, 0L);
        for (int p = order.firstWithCircle; p < contacts.pairCount; p++) {
            for (int c = contacts.firstOf[p]; c < contacts.firstOf[p + 1]; c++) {
                visit(c, pairs.a[contacts.pair[p]], withoutBias);
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

    private void visit(int c, int body, boolean withoutBias) {
        float shareA = contacts.a[c] == body ? share[body] : 1f;
        float shareB = contacts.b[c] == body ? share[body] : 1f;
        int row = RigidRow.of(c);
        if (withoutBias && isIdle(row) || !isVisited(c)) {
            return;
        }
        float mass = massOf(shareA * massOfA(c) + shareB * massOfB(c));
        float vn = normalSpeed(c);
        apply(c, withoutBias ? relaxedNormal(row, mass, vn) : solvedNormal(c, mass, vn, speedBefore(c)));
        if (withoutBias || contacts.rows[row + RigidRow.BOUNCE] > 0f) {
            solveGrip(c, gripMass(c, shareA, shareB));
        }
    }

    /** Whether one of both gives. What sleeps on what moves by itself keeps its impulses. */
    private boolean isVisited(int c) {
        return things.gives(contacts.a[c]) || things.gives(contacts.b[c]);
    }

    long bytes() {
        return 4L * share.length + 8L * sums.length;
    }
}
