package io.github.circles2d.world.jvm.bodies;

import io.github.circles2d.world.bodies.RigidExtras;
import io.github.circles2d.world.bodies.RigidStep;
import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.CrossRule;
import io.github.circles2d.world.model.Sleep;
import io.github.circles2d.world.model.StepConstants;
import java.util.Arrays;

/**
 * Which bodies wake as a step begins, and what the contacts of bodies, as the step has found them, do to circles that sleep. {@code Waking} has
 * the rings. Of bodies, the half thickness stands for the radius. What presses a body is summed up as speeds.
 */
public final class WakingByBodies {
    /** The circles that sleep. */
    public interface Circles {
        /** What has woken a body reaches a circle that it touches, with an impulse or a gap. */
        void reachFromBody(int id, float speed, float impulse, float gap, float inverseMass);
    }

    private static final int SUMS = 4;
    private static final int SUM_X = 0;
    private static final int SUM_Y = 1;
    private static final int SUM_SPIN = 2;
    private static final int SUM_LOAD = 3;

    /** Of what turns by more in a step, in radians, another corner may arrive than the one that is near. */
    private static final float FAR_TURN = 0.02f;

    private final State state;
    private final RigidContacts contacts;
    private final RigidPairs pairs;
    private final RigidThings things;
    private final RigidRules rules;
    private final RigidResting resting;
    private final RigidJoints joints;

    // by id
    private int[] looked = new int[0];
    private int[] wokenIn = new int[0];
    private long[] sums = new long[0];
    private float[] speed = new float[0];
    private float[] next = new float[0];

    /** Whether a body was near to what is awake in the step before, and whether it is now. */
    private boolean[] bordered = new boolean[0];

    private boolean[] borders = new boolean[0];
    private int step;

    /** Ids that are looked at; in a ring, that something reaches. */
    private int[] list = new int[64];

    private int count;
    private int[] woken = new int[64];
    private int wokenCount;
    private int ringFrom;

    /** Whether the next step looks at the balance of all. */
    private boolean looksAtAll;

    // of what the balance of all was looked at last
    private int changes = -1;
    private long jointsVersion = -2;
    private float gravityX;
    private float gravityY;
    private float h;

    // within a step
    private RigidStep bodies;
    private StepConstants k;
    private int thingsBefore;

    WakingByBodies(
            State state,
            RigidContacts contacts,
            RigidPairs pairs,
            RigidRules rules,
            RigidResting resting,
            RigidJoints joints) {
        this.state = state;
        this.contacts = contacts;
        this.pairs = pairs;
        this.rules = rules;
        this.resting = resting;
        this.joints = joints;
        things = pairs.things;
    }

    // ---- contacts of the step with circles

    /** The number of contacts; those with circles come last. */
    public int count() {
        return contacts.count;
    }

    /** Where contacts with circles begin. */
    public int first() {
        int p = contacts.pairCount;
        while (p > 0 && things.type[pairs.b[contacts.pair[p - 1]]] == RigidStep.BODY_CIRCLE) {
            p--;
        }
        return contacts.firstOf[p];
    }

    private boolean isA(int c) {
        return things.type[contacts.a[c]] == RigidStep.BODY_CIRCLE;
    }

    /** The id of the circle of a contact. */
    public int circle(int c) {
        return things.id[isA(c) ? contacts.a[c] : contacts.b[c]];
    }

    /** 1 if the normal goes towards the circle, else -1. */
    public float side(int c) {
        return isA(c) ? 1f : -1f;
    }

    public float nx(int c) {
        return contacts.value(c, RigidRow.NX);
    }

    public float ny(int c) {
        return contacts.value(c, RigidRow.NY);
    }

    public float gap(int c) {
        return contacts.value(c, RigidRow.GAP);
    }

    public float impulse(int c) {
        return contacts.value(c, RigidRow.IMPULSE);
    }

    public float grip(int c) {
        return contacts.value(c, RigidRow.GRIP);
    }

    /** How fast the body comes at the point. */
    public float approach(int c) {
        return approach(c, !isA(c));
    }

    /** How fast A comes to B, or B to A. */
    private float approach(int c, boolean ofA) {
        int t = ofA ? contacts.a[c] : contacts.b[c];
        float x = things.vx[t] - things.omega[t] * contacts.value(c, ofA ? RigidRow.AY : RigidRow.BY);
        float y = things.vy[t] + things.omega[t] * contacts.value(c, ofA ? RigidRow.AX : RigidRow.BX);
        if (things.type[t] == RigidStep.BODY_CIRCLE) { // a thing does not know it yet
            int s = CircleRow.of(state.slotOf[things.id[t]]);
            x = state.motion[s + CircleRow.VX];
            y = state.motion[s + CircleRow.VY];
        }
        float spin = Math.abs(things.omega[t]);
        boolean turnsFar = things.shape[t] != null && spin * k.dt > FAR_TURN;
        if (turnsFar) {
            x = things.vx[t];
            y = things.vy[t];
        }
        return (ofA ? -1f : 1f) * (x * nx(c) + y * ny(c)) + (turnsFar ? spin * things.reach[t] : 0f);
    }

    /** One over the effective mass of the body alone. */
    public float inverseMass(int c) {
        return inverseMass(c, !isA(c));
    }

    private float inverseMass(int c, boolean ofA) {
        return ofA ? rules.massOfA(c) : rules.massOfB(c);
    }

    public float restitution(int c) {
        return Math.max(things.restitution[contacts.a[c]], things.restitution[contacts.b[c]]);
    }

    // ---- contacts that stay

    /** The first contact at rest of a circle, as an entry; -1 behind the last one. */
    public int firstOf(int circle) {
        return resting.firstOfCircle(bodies, circle);
    }

    public int next(int entry) {
        return resting.next(entry);
    }

    /** Measures the contact of an entry; returns its number, or -1 if it is none any more. */
    public int measure(int entry) {
        return contacts.probe(bodies, entry >> 1) ? contacts.count : -1;
    }

    // ---- who wakes

    /** Before circles are looked at; contacts have been found. */
    public void begin(RigidStep ofStep, StepConstants constants) {
        bodies = ofStep;
        k = constants;
        thingsBefore = things.count;
        resting.begin();
        if (looked.length < bodies.end) {
            int ids = bodies.room();
            looked = new int[ids];
            wokenIn = new int[ids];
            sums = new long[SUMS * ids];
            speed = new float[ids];
            next = new float[ids];
            bordered = new boolean[ids];
            borders = new boolean[ids];
            step = 0;
            changes = bodies.changes - 1;
        }
        if (++step < 0) {
            Arrays.fill(looked, 0);
            Arrays.fill(wokenIn, 0);
            step = 1;
        }
        count = 0;
        wokenCount = 0;
        ringFrom = 0;
        boolean[] old = bordered;
        bordered = borders;
        borders = old;
        Arrays.fill(borders, 0, bodies.end, false);
    }

    /** Whether all is as it was when the balance of all was looked at. */
    private boolean isAsBefore() {
        return !looksAtAll
                && changes == bodies.changes
                && jointsVersion == joints.version()
                && gravityX == k.gravityStepX
                && gravityY == k.gravityStepY
                && h == k.h
                && k.warmScale == 1f;
    }

    /** Others have made steps since the last one here, or it has been undone. */
    public void lookAtAll() {
        looksAtAll = true;
    }

    /** Whether nothing is there for bodies to notice, all of which sleep: no circle moves, either. */
    boolean isIdle(RigidStep ofStep, StepConstants constants) {
        bodies = ofStep;
        k = constants;
        if (!isAsBefore() || joints.areThere() || k.walls.any()) {
            return false;
        }
        for (int id = 0; id < bodies.end; id++) {
            if (bodies.outline[id] != null && (!bodies.isAsleep(id) || isUncertain(id) || borders[id])) {
                return false;
            }
        }
        return true;
    }

    /** Finds who wakes first. */
    public void findWoken() {
        boolean all = !isAsBefore();
        looksAtAll = false;
        changes = bodies.changes;
        jointsVersion = joints.version();
        gravityX = k.gravityStepX;
        gravityY = k.gravityStepY;
        h = k.h;
        boolean pieces = pairs.piecesMove();
        boolean walls = k.walls.any();
        for (int t = 0; t < things.bodies; t++) {
            int id = things.id[t];
            if (things.asleep[t]) {
                if (all || bordered[id] || isUncertain(id)) {
                    look(id);
                }
                if (walls && pairs.wallsMoveNear(t) || pieces && pairs.piecesMoveNear(t)) {
                    look(id);
                    push(id, strong(t));
                }
            }
        }
        for (int c = 0; c < contacts.count; c++) {
            touch(c, true);
            touch(c, false);
        }
        joints.look(k, this);
        for (int n = 0; n < count; n++) {
            pressByResting(list[n]);
        }
        for (int n = 0; n < count; n++) {
            judge(list[n]);
        }
    }

    /** Whether a body has just fallen asleep, or is out of balance. */
    private boolean isUncertain(int id) {
        return bodies.extras.get(id, RigidExtras.REST) < Sleep.ASLEEP
                || bodies.extras.get(id, RigidExtras.TURNED) == Sleep.NO_OFFSET;
    }

    private void look(int id) {
        if (looked[id] != step) {
            list = withRoom(list, count);
            list[count++] = id;
            clear(id);
        }
    }

    private static int[] withRoom(int[] ids, int used) {
        return used == ids.length ? Arrays.copyOf(ids, 2 * used) : ids;
    }

    private void clear(int id) {
        looked[id] = step;
        Arrays.fill(sums, SUMS * id, SUMS * (id + 1), 0L);
        speed[id] = 0f;
    }

    private void push(int id, float by) {
        speed[id] = CircleMath.max(speed[id], by);
    }

    private float gain(int t) {
        return CircleMath.length(things.gainX[t], things.gainY[t]);
    }

    private float gainOfStep(int t) {
        return gain(t) * (float) k.subSteps;
    }

    private float strong(int t) {
        return Sleep.strong(gainOfStep(t), things.thin[t], k.dt);
    }

    private float hit(int t, float own, float its, float approach, float gap, float restitution, float j) {
        return Sleep.hit(approach, gap, own, its, restitution, j, gainOfStep(t), things.thin[t], k.dt);
    }

    /** A contact of the step with a body that sleeps, as A or as B. */
    private void touch(int c, boolean asA) {
        int t = asA ? contacts.a[c] : contacts.b[c];
        int other = asA ? contacts.b[c] : contacts.a[c];
        if (!things.asleep[t]) {
            return;
        }
        int id = things.id[t];
        borders[id] = true;
        look(id);
        press(c, asA);
        float own = inverseMass(c, asA);
        float its = inverseMass(c, !asA);
        boolean gives = things.gives(other); // else it moves by itself
        push(id, gives ? hit(t, own, its, approach(c, !asA), gap(c), restitution(c), impulse(c)) : strong(t));
    }

    /** Adds what presses a body at a contact. */
    private void press(int c, boolean asA) {
        int t = asA ? contacts.a[c] : contacts.b[c];
        float side = asA ? 1f : -1f;
        float x = side * (nx(c) * impulse(c) - ny(c) * grip(c));
        float y = side * (ny(c) * impulse(c) + nx(c) * grip(c));
        float armX = contacts.value(c, asA ? RigidRow.AX : RigidRow.BX);
        float armY = contacts.value(c, asA ? RigidRow.AY : RigidRow.BY);
        add(t, x, y, armX * y - armY * x, impulse(c));
    }

    private void add(int t, float x, float y, float spin, float load) {
        float scale = CrossRule.scaleOf(CrossRule.velocityRange(things.reach[t], k.inverseH));
        int at = SUMS * things.id[t];
        sums[at + SUM_X] += CrossRule.toFixed(things.ownW[t] * x, scale);
        sums[at + SUM_Y] += CrossRule.toFixed(things.ownW[t] * y, scale);
        sums[at + SUM_SPIN] += CrossRule.toFixed(things.ownI[t] * spin, CrossRule.scaleOf(k.inverseH));
        sums[at + SUM_LOAD] += CrossRule.toFixed(things.ownW[t] * load, scale);
    }

    private float sum(int t, int which) {
        float unit = CrossRule.unitOf(CrossRule.velocityRange(things.reach[t], k.inverseH));
        return CrossRule.fromFixed(sums[SUMS * things.id[t] + which], unit);
    }

    /** Adds the contacts that stay. */
    private void pressByResting(int id) {
        for (int e = resting.firstOfBody(bodies, id); e >= 0; e = resting.next(e)) {
            int c = measureScaled(e);
            if (c >= 0) {
                press(c, isBody(contacts.a[c], id));
            }
        }
    }

    private boolean isBody(int t, int id) {
        return things.type[t] == RigidStep.BODY_BODY && things.id[t] == id;
    }

    /** The same as {@link #measure}; this step goes on from other impulses if its length is another one. */
    private int measureScaled(int entry) {
        int c = measure(entry);
        if (c >= 0) {
            contacts.rows[RigidRow.of(c) + RigidRow.IMPULSE] *= k.warmScale;
            contacts.rows[RigidRow.of(c) + RigidRow.GRIP] *= k.warmScale;
        }
        return c;
    }

    private void judge(int id) {
        int t = pairs.bodyThing(id);
        push(id, outOfBalance(id, t));
        if (speed[id] > 0f) {
            addWoken(id);
        }
    }

    private float outOfBalance(int id, int t) {
        RigidExtras of = bodies.extras;
        float gainX = things.gainX[t];
        float gainY = things.gainY[t];
        float gain = gain(t);
        float thin = things.thin[t];
        float reach = things.reach[t];
        float spinGain = reach * things.gainOmega[t];
        float knownX = of.real(id, RigidExtras.DRIFT_X);
        float knownY = of.real(id, RigidExtras.DRIFT_Y);
        float knownSpin = reach * of.real(id, RigidExtras.KNOWN_SPIN);
        boolean strict = Sleep.changes(gainX, gainY, knownX, knownY, k.h, gain, thin, k.dt)
                || Sleep.changes(spinGain, 0f, knownSpin, 0f, k.h, gain, thin, k.dt);
        int rest = of.get(id, RigidExtras.REST);
        int offset = of.get(id, RigidExtras.TURNED);
        int spinOffset = of.get(id, RigidExtras.SPIN_OFFSET);
        float x = gainX + sum(t, SUM_X);
        float y = gainY + sum(t, SUM_Y);
        float turning = CrossRule.fromFixed(sums[SUMS * id + SUM_SPIN], CrossRule.unitOf(k.inverseH));
        float spin = Sleep.SHARE_OF_SPIN * (spinGain + reach * turning);
        if (offset == Sleep.NO_OFFSET) {
            offset = strict ? 0 : Sleep.offset(x, y, gain);
            spinOffset = strict || gain == 0f ? 0 : Sleep.parts(spin, gain);
        }
        float b = CircleMath.max(
                CircleMath.length(x - Sleep.offsetX(offset, gain), y - Sleep.offsetY(offset, gain)),
                Math.abs(spin - (float) spinOffset / Sleep.PARTS * gain));
        boolean balanced = !(b > Sleep.tolerance(strict, gain, sum(t, SUM_LOAD), thin, k.dt));
        rest = balanced ? Sleep.ASLEEP : rest - 1;
        bodies.setRest(id, rest, offset, strict ? gainX * k.inverseH : knownX, strict ? gainY * k.inverseH : knownY);
        bodies.setSpinOfRest(
                id, strict ? things.gainOmega[t] * k.inverseH : of.real(id, RigidExtras.KNOWN_SPIN), spinOffset);
        return !balanced && Sleep.losesPatience(strict, gain, b, Sleep.ASLEEP - rest)
                ? Sleep.imbalanceOfStep(b, k.subSteps, thin, k.dt)
                : 0f;
    }

    // ---- by joints

    boolean isLookedAt(int t) {
        return looked[things.id[t]] == step;
    }

    /** A joint drives a body that sleeps. */
    void drive(int t) {
        look(things.id[t]);
        push(things.id[t], strong(t));
    }

    /** What a joint gives a body that sleeps: an impulse at an arm, and an angular one. */
    void pull(int t, float x, float y, float armX, float armY, float twist, float load) {
        add(t, x, y, (armX * y - armY * x) + twist, load);
    }

    /** The other end of a joint of a body that sleeps is awake, and has a speed. */
    void move(int t, float itsInverseMass, float itsSpeed, float load) {
        borders[things.id[t]] = true;
        look(things.id[t]);
        push(things.id[t], hit(t, things.ownW[t], itsInverseMass, itsSpeed, 0f, 0f, load));
    }

    // ---- rings

    private void addWoken(int id) {
        woken = withRoom(woken, wokenCount);
        wokenIn[id] = step;
        woken[wokenCount++] = id;
    }

    /** Whether some have woken in the ring before. */
    public boolean hasRing() {
        return ringFrom < wokenCount;
    }

    /** Begins a ring. */
    public void beginRing() {
        count = 0;
    }

    /** What woke bodies in the ring before reaches others, and circles. */
    public void passOn(Circles circles) {
        for (int n = ringFrom; n < wokenCount; n++) {
            int id = woken[n];
            for (int e = resting.firstOfBody(bodies, id); e >= 0; e = resting.next(e)) {
                int c = measureScaled(e);
                boolean asA = c >= 0 && isBody(contacts.a[c], id);
                int type = c < 0 ? -1 : things.type[asA ? contacts.b[c] : contacts.a[c]];
                if (type == RigidStep.BODY_BODY) {
                    passOn(speed[id], c, !asA, inverseMass(c, asA));
                } else if (type == RigidStep.BODY_CIRCLE) {
                    circles.reachFromBody(circle(c), speed[id], impulse(c), gap(c), inverseMass(c, asA));
                }
            }
            joints.passOn(pairs.bodyThing(id), speed[id], this);
        }
    }

    /** What woke a circle reaches bodies. */
    public void passOnFrom(int circle, float itsSpeed) {
        for (int e = resting.firstOfCircle(bodies, circle); e >= 0; e = resting.next(e)) {
            int c = measureScaled(e);
            if (c >= 0) {
                boolean bodyIsA = !isA(c);
                passOn(itsSpeed, c, bodyIsA, things.ownW[bodyIsA ? contacts.b[c] : contacts.a[c]]);
            }
        }
    }

    /** To the body that is A, or B, of a contact. */
    private void passOn(float itsSpeed, int c, boolean toA, float its) {
        int t = toA ? contacts.a[c] : contacts.b[c];
        passOn(t, itsSpeed, impulse(c), gap(c), inverseMass(c, toA), its);
    }

    /** What woke the other end of a contact or joint reaches a body, if that sleeps. */
    void passOn(int t, float itsSpeed, float j, float gap, float own, float its) {
        int id = things.id[t];
        if (!things.asleep[t] || wokenIn[id] == step) {
            return;
        }
        float passed = j > 0f
                ? Sleep.passedOn(itsSpeed, things.ownW[t] * j, loadOf(id, t), own, its, gainOfStep(t))
                : Sleep.passedFreely(itsSpeed, gap, own, its, gainOfStep(t), k.dt);
        if (passed > 0f) {
            if (next[id] == 0f) {
                list = withRoom(list, count);
                list[count++] = id;
            }
            next[id] = CircleMath.max(next[id], passed);
        }
    }

    private float loadOf(int id, int t) {
        if (looked[id] != step) {
            clear(id);
            joints.press(t, this);
            pressByResting(id);
        }
        return sum(t, SUM_LOAD);
    }

    /** Ends a ring, all of which wake at once. */
    public void endRing() {
        ringFrom = wokenCount;
        for (int n = 0; n < count; n++) {
            int id = list[n];
            speed[id] = next[id];
            next[id] = 0f;
            if (speed[id] > Sleep.LEAST_HIT * things.thin[pairs.bodyThing(id)] / k.dt) {
                addWoken(id);
            }
        }
    }

    /** Wakes all that are to wake; returns whether there are any. */
    public boolean end() {
        for (int n = 0; n < wokenCount; n++) {
            bodies.wake(woken[n]);
        }
        pairs.forgetProbes(thingsBefore);
        resting.begin();
        return wokenCount > 0;
    }

    long bytes() {
        return 4L * (looked.length + wokenIn.length + speed.length + next.length + list.length + woken.length)
                + 8L * sums.length
                + bordered.length
                + borders.length;
    }
}
