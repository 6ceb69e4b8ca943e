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

    /** Of what turns by more in a step, in radians, another corner may arrive than the one that is near. */
    private static final float FAR_TURN = 0.02f;

    private final State state;
    private final RigidContacts contacts;
    private final RigidPairs pairs;
    private final RigidThings things;
    private final RigidResting resting;
    private final RigidJoints joints;

    // by id: whether a body was near to what is awake in the step before, and whether it is now
    private boolean[] bordered = new boolean[0];
    private boolean[] borders = new boolean[0];

    private long step;

    /** Bodies that are looked at; in a ring, that something reaches. */
    private RigidThing[] list = new RigidThing[64];

    private int count;
    private RigidThing[] woken = new RigidThing[64];
    private int wokenCount;
    private int ringFrom;

    /** Of a circle, which the methods below tell of. */
    private RigidContact contact;

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

    WakingByBodies(State state, RigidContacts contacts, RigidPairs pairs, RigidResting resting, RigidJoints joints) {
        this.state = state;
        this.contacts = contacts;
        this.pairs = pairs;
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
        while (p > 0 && contacts.pairs[p - 1].b.type == RigidStep.BODY_CIRCLE) {
            p--;
        }
        return p == contacts.pairCount ? contacts.count : contacts.pairs[p].begin;
    }

    /** Looks at a contact of the step. */
    public void show(int n) {
        contact = contacts.all[n];
    }

    /** The first contact of a circle that stays, as an entry; -1 behind the last one. */
    public int firstOf(int circle) {
        return resting.firstOfCircle(bodies, circle);
    }

    public int next(int entry) {
        return resting.next(entry);
    }

    /** Looks at the contact of an entry, as it is now; false if it is none any more. */
    public boolean measure(int entry) {
        contact = contacts.probe(bodies.contacts, entry >> 1);
        return contact != null;
    }

    private static boolean circleIsA(RigidContact c) {
        return c.a.type == RigidStep.BODY_CIRCLE;
    }

    private static RigidThing circle(RigidContact c) {
        return circleIsA(c) ? c.a : c.b;
    }

    /** The id of the circle of the contact. */
    public int circle() {
        return circle(contact).id;
    }

    /** 1 if the normal goes towards the circle, else -1. */
    public float side() {
        return circleIsA(contact) ? 1f : -1f;
    }

    public float nx() {
        return contact.nx;
    }

    public float ny() {
        return contact.ny;
    }

    public float gap() {
        return contact.gap;
    }

    public float impulse() {
        return contact.impulse;
    }

    public float grip() {
        return contact.grip;
    }

    public float restitution() {
        return restitution(contact);
    }

    private static float restitution(RigidContact c) {
        return Math.max(c.a.restitution, c.b.restitution);
    }

    /** How fast the body comes at the point. */
    public float approach() {
        return approach(contact, !circleIsA(contact));
    }

    /** How fast A comes to B, or B to A. */
    private float approach(RigidContact c, boolean ofA) {
        RigidThing t = ofA ? c.a : c.b;
        float x = t.vx - t.omega * (ofA ? c.ay : c.by);
        float y = t.vy + t.omega * (ofA ? c.ax : c.bx);
        if (t.type == RigidStep.BODY_CIRCLE) { // a thing does not know it yet
            int s = CircleRow.of(state.slotOf[t.id]);
            x = state.motion[s + CircleRow.VX];
            y = state.motion[s + CircleRow.VY];
        }
        float spin = Math.abs(t.omega);
        boolean turnsFar = t.shape != null && spin * k.dt > FAR_TURN;
        if (turnsFar) {
            x = t.vx;
            y = t.vy;
        }
        return (ofA ? -1f : 1f) * (x * c.nx + y * c.ny) + (turnsFar ? spin * t.reach : 0f);
    }

    /** One over the effective mass of the body alone. */
    public float inverseMass() {
        return inverseMass(contact, !circleIsA(contact));
    }

    private static float inverseMass(RigidContact c, boolean ofA) {
        return ofA ? c.massOfA() : c.massOfB();
    }

    // ---- who wakes

    /** Before circles are looked at; contacts have been found. */
    public void begin(RigidStep ofStep, StepConstants constants) {
        bodies = ofStep;
        k = constants;
        thingsBefore = things.count;
        resting.begin();
        if (borders.length < bodies.end) {
            bordered = new boolean[bodies.room()];
            borders = new boolean[bodies.room()];
            changes = bodies.changes - 1;
        }
        step++;
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
        for (int n = 0; n < things.bodies; n++) {
            RigidThing t = things.all[n];
            if (t.asleep) {
                if (all || bordered[t.id] || isUncertain(t.id)) {
                    look(t);
                }
                if (walls && pairs.wallsMoveNear(t) || pieces && pairs.piecesMoveNear(t)) {
                    drive(t);
                }
            }
        }
        for (int n = 0; n < contacts.count; n++) {
            touch(contacts.all[n], true);
            touch(contacts.all[n], false);
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

    private void look(RigidThing t) {
        if (t.looked != step) {
            list = withRoom(list, count);
            list[count++] = t;
            clear(t);
        }
    }

    private static RigidThing[] withRoom(RigidThing[] some, int used) {
        return used == some.length ? Arrays.copyOf(some, 2 * used) : some;
    }

    private void clear(RigidThing t) {
        t.looked = step;
        t.clearSums();
        t.speed = 0f;
    }

    private static void push(RigidThing t, float by) {
        t.speed = CircleMath.max(t.speed, by);
    }

    private float gainOfStep(RigidThing t) {
        return t.gain() * (float) k.subSteps;
    }

    private float strong(RigidThing t) {
        return Sleep.strong(gainOfStep(t), t.thin, k.dt);
    }

    private float hit(RigidThing t, float own, float its, float approach, float gap, float restitution, float j) {
        return Sleep.hit(approach, gap, own, its, restitution, j, gainOfStep(t), t.thin, k.dt);
    }

    /** A contact of the step with a body that sleeps, as A or as B. */
    private void touch(RigidContact c, boolean asA) {
        RigidThing t = asA ? c.a : c.b;
        RigidThing other = asA ? c.b : c.a;
        if (t.asleep) {
            borders[t.id] = true;
            look(t);
            press(c, asA);
            float own = inverseMass(c, asA);
            float its = inverseMass(c, !asA);
            push(
                    t,
                    other.gives() // else it moves by itself
                            ? hit(t, own, its, approach(c, !asA), c.gap, restitution(c), c.impulse)
                            : strong(t));
        }
    }

    /** Adds what presses a body at a contact. */
    private void press(RigidContact c, boolean asA) {
        float side = asA ? 1f : -1f;
        float x = side * (c.nx * c.impulse - c.ny * c.grip);
        float y = side * (c.ny * c.impulse + c.nx * c.grip);
        float armX = asA ? c.ax : c.bx;
        float armY = asA ? c.ay : c.by;
        add(asA ? c.a : c.b, x, y, armX * y - armY * x, c.impulse);
    }

    private void add(RigidThing t, float x, float y, float spin, float load) {
        t.addToSums(t.ownW * x, t.ownW * y, t.ownI * spin, k.inverseH);
        t.sumLoad += CrossRule.toFixed(t.ownW * load, CrossRule.scaleOf(t.range(k.inverseH)));
    }

    private float load(RigidThing t) {
        return CrossRule.fromFixed(t.sumLoad, CrossRule.unitOf(t.range(k.inverseH)));
    }

    /** Adds the contacts that stay. */
    private void pressByResting(RigidThing t) {
        for (int e = resting.firstOfBody(bodies, t.id); e >= 0; e = resting.next(e)) {
            RigidContact c = measureScaled(e);
            if (c != null) {
                press(c, c.a == t);
            }
        }
    }

    /** Measures the contact of an entry; this step goes on from other impulses if its length is another one. Null if it is none any more. */
    private RigidContact measureScaled(int entry) {
        RigidContact c = contacts.probe(bodies.contacts, entry >> 1);
        if (c != null) {
            c.impulse *= k.warmScale;
            c.grip *= k.warmScale;
        }
        return c;
    }

    private void judge(RigidThing t) {
        push(t, outOfBalance(t.id, t));
        if (t.speed > 0f) {
            addWoken(t);
        }
    }

    private float outOfBalance(int id, RigidThing t) {
        RigidExtras of = bodies.extras;
        float gainX = t.gainX;
        float gainY = t.gainY;
        float gain = t.gain();
        float thin = t.thin;
        float reach = t.reach;
        float spinGain = reach * t.gainOmega;
        float knownX = of.real(id, RigidExtras.DRIFT_X);
        float knownY = of.real(id, RigidExtras.DRIFT_Y);
        float knownSpin = reach * of.real(id, RigidExtras.KNOWN_SPIN);
        boolean strict = Sleep.changes(gainX, gainY, knownX, knownY, k.h, gain, thin, k.dt)
                || Sleep.changes(spinGain, 0f, knownSpin, 0f, k.h, gain, thin, k.dt);
        int rest = of.get(id, RigidExtras.REST);
        int offset = of.get(id, RigidExtras.TURNED);
        int spinOffset = of.get(id, RigidExtras.SPIN_OFFSET);
        float x = gainX + t.summedX(k.inverseH);
        float y = gainY + t.summedY(k.inverseH);
        float spin = Sleep.SHARE_OF_SPIN * (spinGain + reach * t.summedOmega(k.inverseH));
        if (offset == Sleep.NO_OFFSET) {
            offset = strict ? 0 : Sleep.offset(x, y, gain);
            spinOffset = strict || gain == 0f ? 0 : Sleep.parts(spin, gain);
        }
        float b = CircleMath.max(
                CircleMath.length(x - Sleep.offsetX(offset, gain), y - Sleep.offsetY(offset, gain)),
                Math.abs(spin - (float) spinOffset / Sleep.PARTS * gain));
        boolean balanced = !(b > Sleep.tolerance(strict, gain, load(t), thin, k.dt));
        rest = balanced ? Sleep.ASLEEP : rest - 1;
        bodies.setRest(id, rest, offset, strict ? gainX * k.inverseH : knownX, strict ? gainY * k.inverseH : knownY);
        bodies.setSpinOfRest(id, strict ? t.gainOmega * k.inverseH : of.real(id, RigidExtras.KNOWN_SPIN), spinOffset);
        return !balanced && Sleep.losesPatience(strict, gain, b, Sleep.ASLEEP - rest)
                ? Sleep.imbalanceOfStep(b, k.subSteps, thin, k.dt)
                : 0f;
    }

    // ---- by joints

    boolean isLookedAt(RigidThing t) {
        return t.looked == step;
    }

    /** Something drives a body that sleeps. */
    void drive(RigidThing t) {
        look(t);
        push(t, strong(t));
    }

    /** What a joint gives a body that sleeps: an impulse at an arm, and an angular one. */
    void pull(RigidThing t, float x, float y, float armX, float armY, float twist, float load) {
        add(t, x, y, (armX * y - armY * x) + twist, load);
    }

    /** The other end of a joint of a body that sleeps is awake, and has a speed. */
    void move(RigidThing t, float itsInverseMass, float itsSpeed, float load) {
        borders[t.id] = true;
        look(t);
        push(t, hit(t, t.ownW, itsInverseMass, itsSpeed, 0f, 0f, load));
    }

    // ---- rings

    private void addWoken(RigidThing t) {
        woken = withRoom(woken, wokenCount);
        t.wokenIn = step;
        woken[wokenCount++] = t;
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
            RigidThing t = woken[n];
            for (int e = resting.firstOfBody(bodies, t.id); e >= 0; e = resting.next(e)) {
                RigidContact c = measureScaled(e);
                boolean asA = c != null && c.a == t;
                int type = c == null ? -1 : (asA ? c.b : c.a).type;
                if (type == RigidStep.BODY_BODY) {
                    passOn(t.speed, c, !asA, inverseMass(c, asA));
                } else if (type == RigidStep.BODY_CIRCLE) {
                    circles.reachFromBody(circle(c).id, t.speed, c.impulse, c.gap, inverseMass(c, asA));
                }
            }
            joints.passOn(t, t.speed, this);
        }
    }

    /** What woke a circle reaches bodies. */
    public void passOnFrom(int circle, float itsSpeed) {
        for (int e = resting.firstOfCircle(bodies, circle); e >= 0; e = resting.next(e)) {
            RigidContact c = measureScaled(e);
            if (c != null) {
                passOn(itsSpeed, c, !circleIsA(c), circle(c).ownW);
            }
        }
    }

    /** To the body that is A, or B, of a contact. */
    private void passOn(float itsSpeed, RigidContact c, boolean toA, float its) {
        passOn(toA ? c.a : c.b, itsSpeed, c.impulse, c.gap, inverseMass(c, toA), its);
    }

    /** What woke the other end of a contact or joint reaches a body, if that sleeps. */
    void passOn(RigidThing t, float itsSpeed, float j, float gap, float own, float its) {
        if (!t.asleep || t.wokenIn == step) {
            return;
        }
        float passed = j > 0f
                ? Sleep.passedOn(itsSpeed, t.ownW * j, loadOf(t), own, its, gainOfStep(t))
                : Sleep.passedFreely(itsSpeed, gap, own, its, gainOfStep(t), k.dt);
        if (passed > 0f) {
            if (t.nextSpeed == 0f) {
                list = withRoom(list, count);
                list[count++] = t;
            }
            t.nextSpeed = CircleMath.max(t.nextSpeed, passed);
        }
    }

    private float loadOf(RigidThing t) {
        if (t.looked != step) {
            clear(t);
            joints.press(t, this);
            pressByResting(t);
        }
        return load(t);
    }

    /** Ends a ring, all of which wake at once. */
    public void endRing() {
        ringFrom = wokenCount;
        for (int n = 0; n < count; n++) {
            RigidThing t = list[n];
            t.speed = t.nextSpeed;
            t.nextSpeed = 0f;
            if (t.speed > Sleep.LEAST_HIT * t.thin / k.dt) {
                addWoken(t);
            }
        }
    }

    /** Wakes all that are to wake; returns whether there are any. */
    public boolean end() {
        for (int n = 0; n < wokenCount; n++) {
            bodies.wake(woken[n].id);
        }
        pairs.forgetProbes(thingsBefore);
        resting.begin();
        return wokenCount > 0;
    }

    long bytes() {
        return 4L * (list.length + woken.length) + bordered.length + borders.length;
    }
}
