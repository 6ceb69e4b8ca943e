package io.github.circles2d.world.jvm.bodies;

import io.github.circles2d.world.jvm.threads.Team;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.CrossRule;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.Surface;
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

    /** See {@link #areFixed}: then several workers may push at once what does not move. */
    private boolean fixed;

    // of a pass: whether it is without bias, and the places in the order that workers have now
    private boolean relaxes;

    private int from;
    private int to;

    private final RigidRules rules;
    private final RigidPairVisits ofPairs;

    /** By pair without circles: whether it is one of {@link #ofPairs}. */
    private boolean[] plain = new boolean[0];

    /** By pair without circles: whether it may bounce in this sub-step, or be a hit. */
    private boolean[] mayBounce = new boolean[0];

    /** Whether a grip is -0, which a slip of 0 may change; visits make no other so. */
    private boolean gripsMinusZero;

    /** By worker: whether it has met some. */
    private final boolean[] minusZero;

    private final Team.Share begin = this::begin;
    private final Team.Share findPlain = this::findPlain;
    private final Team.Share measure = this::measure;
    private final Team.Share warmStart = this::warmStart;
    private final Team.Share lookAhead = this::lookAhead;
    private final Team.Share visit = this::visitOfColour;

    RigidVisits(
            RigidContacts contacts, RigidPairs pairs, RigidRules rules, RigidOrder order, Team team, int leastShare) {
        this.contacts = contacts;
        this.pairs = pairs;
        this.rules = rules;
        this.order = order;
        this.team = team;
        this.leastShare = leastShare;
        minusZero = new boolean[team.most()];
        things = pairs.things;
        ofPairs = new RigidPairVisits(contacts, things, rules);
    }

    /** Begins a step: contacts have been found and measured; toTell: whether anybody asks how hard things have touched. */
    void begin(StepConstants constants, boolean toTell) {
        k = constants;
        rules.begin(constants, toTell);
        if (share.length < things.bodies) {
            share = new float[2 * things.bodies];
            sums = new long[6 * things.bodies];
        }
        Arrays.fill(share, 0, things.bodies, 0f);
        for (int p = order.firstWithCircle; p < contacts.pairCount; p++) {
            for (int c = contacts.firstOf[p]; c < contacts.firstOf[p + 1]; c++) {
                int body = pairs.a[contacts.pair[p]];
                int circle = pairs.b[contacts.pair[p]];
                float kb = contacts.a[c] == body ? rules.massOfA(c) : rules.massOfB(c);
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
        team.share(contacts.count, 0, begin);
        team.share(order.firstWithCircle, 0, findPlain);
    }

    private void begin(int worker, int from, int end) {
        for (int c = from; c < end; c++) {
            rules.begin(c);
        }
    }

    private void findPlain(int worker, int from, int end) {
        for (int p = from; p < end; p++) {
            plain[p] = ofPairs.has(contacts.firstOf[p], contacts.firstOf[p + 1]);
        }
    }

    /** Measures contacts as their things have moved. */
    void measure() {
        team.share(contacts.count, leastShare, measure);
    }

    private void measure(int worker, int from, int end) {
        for (int c = from; c < end; c++) {
            contacts.measures.measure(c);
            rules.setMasses(c);
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

    void solve() {
        relaxes = false;
        team.share(order.firstWithCircle, leastShare / 2, lookAhead); // a pair has two contacts, or one
        passByColours();
    }

    /** Looks at how contacts come together, before impulses. */
    private void lookAhead(int worker, int from, int end) {
        float[] rows = contacts.rows;
        for (int p = from; p < end; p++) {
            boolean bounces = false;
            for (int c = contacts.firstOf[p]; c < contacts.firstOf[p + 1]; c++) {
                int row = RigidRow.of(c);
                float before = rules.speedBefore(c);
                rows[row + RigidRow.APPROACH] = Math.max(rows[row + RigidRow.APPROACH], -before);
                bounces |= rules.isFast(row) || rows[row + RigidRow.RESTITUTION] > 0f && rules.isImpact(row, before);
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
                times = rules.isHit(row) ? OF_HITS : times;
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

    private void solveNormal(int c) {
        float mass = contacts.rows[RigidRow.of(c) + RigidRow.NORMAL_MASS];
        float vn = rules.normalSpeed(c);
        apply(c, rules.solvedNormal(c, mass, vn, rules.speedBefore(c)));
    }

    private void relaxNormal(int c) {
        int row = RigidRow.of(c);
        if (rules.isIdle(row)) {
            return;
        }
        float mass = contacts.rows[row + RigidRow.NORMAL_MASS];
        float vn = rules.normalSpeed(c);
        if (!rules.bouncesLater(c, vn)) {
            apply(c, rules.relaxedNormal(row, mass, vn));
        }
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

    /** Friction and rolling resistance, by the normal impulse. */
    private void solveGrip(int c, float mass) {
        float[] rows = contacts.rows;
        int row = RigidRow.of(c);
        int a = contacts.a[c];
        int b = contacts.b[c];
        if (fixed && rules.isFree(row)) {
            return;
        }
        if (rules.hasGrip(row)) {
            float nx = rows[row + RigidRow.NX];
            float ny = rows[row + RigidRow.NY];
            float ux = RigidRules.speedX(rows, row, things.vx, things.omega, a, b);
            float uy = RigidRules.speedY(rows, row, things.vy, things.omega, a, b);
            float gain = rules.gripped(row, mass, uy * nx - ux * ny);
            pushBoth(c, -ny * gain, nx * gain);
        }
        float resistance = rows[row + RigidRow.ROLLING];
        float turns = resistance > 0f ? things.ownI[a] + things.ownI[b] : 0f;
        if (turns > 0f) {
            float before = rows[row + RigidRow.ROLL];
            float next = Surface.rolling(
                    before,
                    RigidRules.massOf(turns),
                    things.omega[a] - things.omega[b],
                    resistance * rows[row + RigidRow.IMPULSE]);
            rows[row + RigidRow.ROLL] = next;
            gain(a, 0f, 0f, things.i[a] * (next - before));
            gain(b, 0f, 0f, -things.i[b] * (next - before));
        }
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
        if (withoutBias && rules.isIdle(row) || !isVisited(c)) {
            return;
        }
        float mass = RigidRules.massOf(shareA * rules.massOfA(c) + shareB * rules.massOfB(c));
        float vn = rules.normalSpeed(c);
        apply(
                c,
                withoutBias
                        ? rules.relaxedNormal(row, mass, vn)
                        : rules.solvedNormal(c, mass, vn, rules.speedBefore(c)));
        if (withoutBias || contacts.rows[row + RigidRow.BOUNCE] > 0f) {
            solveGrip(c, rules.gripMass(c, shareA, shareB));
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
