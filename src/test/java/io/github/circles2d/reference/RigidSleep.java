package io.github.circles2d.reference;

import static io.github.circles2d.reference.Numbers.clamp;
import static io.github.circles2d.reference.Numbers.length;
import static io.github.circles2d.reference.Numbers.max;
import static io.github.circles2d.reference.Numbers.min;

import java.util.ArrayList;
import java.util.List;

/** Which bodies that are pushed fall asleep in a step, and which wake: as {@link Sleep} has it of circles, with half the thickness for the radius. */
final class RigidSleep {
    /** What presses a body, as speeds. */
    private record Pressed(float x, float y, float spin, float load) {}

    private final RigidStep lying;
    private final List<RigidContact> found;
    private final List<RigidContact> resting;
    private final List<RigidThing> woken = new ArrayList<>();
    private final StepParameters k;
    private final float warmScale;

    RigidSleep(RigidStep lying, List<RigidContact.Saved> saved, StepParameters k, float warmScale) {
        this.lying = lying;
        this.k = k;
        this.warmScale = warmScale;
        found = lying.find(saved, warmScale);
        resting = lying.resting(saved, warmScale).stream().map(lying::measured).toList();
    }

    /** Those of the step, and those that stay. */
    List<RigidContact> contacts() {
        List<RigidContact> all = new ArrayList<>(found);
        all.addAll(resting);
        return all;
    }

    /** Contacts that stay between a circle and a body. */
    List<RigidContact> between(Circle c, RigidThing body) {
        return resting.stream()
                .filter(contact -> contact.isOf(c) && (contact.a == body || contact.b == body))
                .toList();
    }

    // ---- who wakes

    List<RigidThing> firstWoken() {
        List<RigidThing> first = new ArrayList<>();
        for (RigidThing t : lying.bodies()) {
            if (t.isAsleep()) {
                float speed = lying.movesNear(t) ? strong(t) : 0f;
                for (RigidContact c : found) {
                    speed = max(speed, pushedBy(c, t));
                }
                for (ReferenceJoint joint : lying.joints()) {
                    speed = max(speed, max(pulledBy(joint, 0, t), pulledBy(joint, 1, t)));
                }
                speed = max(speed, outOfBalance(t));
                if (speed > 0f) {
                    t.wakingSpeed = speed;
                    first.add(t);
                }
            }
        }
        woken.addAll(first);
        return first;
    }

    private float gain(RigidThing t) {
        return length(t.ownGain);
    }

    private float gainOfStep(RigidThing t) {
        return gain(t) * k.subSteps();
    }

    private float strong(RigidThing t) {
        return max(gainOfStep(t), Sleep.LEAST_WAKING * t.thin / k.dt());
    }

    /** What is about to push a body at a contact of the step. */
    private float pushedBy(RigidContact c, RigidThing t) {
        if (c.a != t && c.b != t) {
            return 0f;
        }
        boolean isA = c.a == t;
        RigidThing o = isA ? c.b : c.a;
        if (!o.gives()) {
            return strong(t);
        }
        float armX = isA ? c.bx : c.ax;
        float armY = isA ? c.by : c.ay;
        float vx = o.velocity[0] - o.omega * armY;
        float vy = o.velocity[1] + o.omega * armX;
        if (o.circle != null) {
            vx = o.circle.velocity[0];
            vy = o.circle.velocity[1];
        }
        float v = (isA ? 1f : -1f) * (vx * c.nx + vy * c.ny);
        if (o.circle == null && turnsFar(o, k)) {
            v = farSpeed(o, isA ? 1f : -1f, c);
        }
        if (!(v > 0f) || !(c.gap < v * k.dt())) {
            return 0f;
        }
        float e = max(c.a.restitution, c.b.restitution);
        return hit(t, c.inverseMassOf(isA), c.inverseMassOf(!isA), e, v, c.impulse > 0f);
    }

    /** What comes with a speed. */
    private float hit(RigidThing t, float own, float its, float e, float v, boolean presses) {
        float share = own / (own + its);
        float speed = share * (1f + e) * v;
        float most = (presses ? Sleep.PUSH : Sleep.HIT) * gainOfStep(t);
        return speed > most && speed > Sleep.LEAST_HIT * t.thin / k.dt() ? speed : 0f;
    }

    // ---- joints

    /** What is about to move a body at a side of a joint. */
    private float pulledBy(ReferenceJoint joint, int side, RigidThing t) {
        if (lying.thing(joint, side) != t) {
            return 0f;
        }
        float speed = joint.drivesRigids() ? strong(t) : 0f;
        RigidThing o = lying.thing(joint, 1 - side);
        if (o == null || o.isAsleep()) {
            return speed;
        }
        float[] arm = o.turned(joint.points[1 - side]);
        float v = length(o.velocity[0] - o.omega * arm[1], o.velocity[1] + o.omega * arm[0]);
        return v * k.dt() > 0f ? max(speed, hit(t, t.ownW, o.ownW, 0f, v, loadOf(joint) > 0f)) : speed;
    }

    private float ofSubStep(float sum) {
        return sum * warmScale / k.subSteps();
    }

    private float loadOf(ReferenceJoint joint) {
        float load = length(ofSubStep(joint.sum[0]), ofSubStep(joint.sum[1]));
        return joint.elastic ? Sleep.SPRING_LOADS * load : load;
    }

    private void press(ReferenceJoint joint, int side, RigidThing t, FixedSum sum, FixedSum spin) {
        float sign = side == 0 ? -1f : 1f;
        float x = sign * ofSubStep(joint.sum[0]);
        float y = sign * ofSubStep(joint.sum[1]);
        float[] arm = t.turned(joint.points[side]);
        sum.add(0, t.ownW * x);
        sum.add(1, t.ownW * y);
        sum.add(2, t.ownW * loadOf(joint));
        spin.add(0, t.ownI * ((arm[0] * y - arm[1] * x) + -sign * ofSubStep(joint.sumOfTurning)));
    }

    /** What reaches a body by a joint from the body at its other side. */
    private float passed(ReferenceJoint joint, int side, RigidThing t, List<RigidThing> from) {
        RigidThing o = lying.thing(joint, 1 - side);
        if (lying.thing(joint, side) != t || !from.contains(o)) {
            return 0f;
        }
        float j = loadOf(joint);
        return j > 0f
                ? Sleep.passedOn(o.wakingSpeed, t.ownW * j, pressed(t).load(), t.ownW, o.ownW, gainOfStep(t))
                : Sleep.passedFreely(o.wakingSpeed, 0f, t.ownW, o.ownW, gainOfStep(t), k.dt());
    }

    // ---- balance

    /** Whether another corner may arrive than the one that is near. */
    static boolean turnsFar(RigidThing body, StepParameters k) {
        return Math.abs(body.omega) * k.dt() > 0.02f;
    }

    /** How fast a body comes that turns far. */
    static float farSpeed(RigidThing body, float side, RigidContact c) {
        float along = body.velocity[0] * c.nx + body.velocity[1] * c.ny;
        return side * along + Math.abs(body.omega) * body.reach;
    }

    private Pressed pressed(RigidThing t) {
        FixedSum sum = new FixedSum(t.reach * k.inverseH());
        FixedSum spin = new FixedSum(k.inverseH());
        for (RigidContact c : contacts()) {
            if (c.a == t || c.b == t) {
                float side = c.a == t ? 1f : -1f;
                float x = side * (c.nx * c.impulse - c.ny * c.grip);
                float y = side * (c.ny * c.impulse + c.nx * c.grip);
                float armX = c.a == t ? c.ax : c.bx;
                float armY = c.a == t ? c.ay : c.by;
                sum.add(0, t.ownW * x);
                sum.add(1, t.ownW * y);
                sum.add(2, t.ownW * c.impulse);
                spin.add(0, t.ownI * (armX * y - armY * x));
            }
        }
        for (ReferenceJoint joint : lying.joints()) {
            for (int side = 0; side < 2; side++) {
                if (lying.thing(joint, side) == t) {
                    press(joint, side, t, sum, spin);
                }
            }
        }
        float[] taken = sum.take();
        return new Pressed(taken[0], taken[1], spin.take()[0], taken[2]);
    }

    private boolean changes(float x, float y, float knownX, float knownY, RigidThing t) {
        return length(x - knownX * k.h(), y - knownY * k.h())
                > Sleep.CHANGE * gain(t) + Sleep.ROUNDING * t.thin / k.dt();
    }

    private static int parts(float x, float gain) {
        return (int) clamp(x / gain * Sleep.PARTS, -Sleep.MOST_PARTS, Sleep.MOST_PARTS);
    }

    private float outOfBalance(RigidThing t) {
        Rigid body = t.body;
        Pressed by = pressed(t);
        float gain = gain(t);
        float spinGain = t.reach * t.ownAngularGain;
        boolean strict = changes(t.ownGain[0], t.ownGain[1], body.drift[0], body.drift[1], t)
                || changes(spinGain, 0f, t.reach * body.knownSpin, 0f, t);
        if (strict) {
            body.drift[0] = t.ownGain[0] * k.inverseH();
            body.drift[1] = t.ownGain[1] * k.inverseH();
            body.knownSpin = t.ownAngularGain * k.inverseH();
        }
        float x = t.ownGain[0] + by.x();
        float y = t.ownGain[1] + by.y();
        float spin = Sleep.SHARE_OF_SPIN * (spinGain + t.reach * by.spin());
        if (body.turned == Sleep.NO_OFFSET) {
            boolean none = strict || gain == 0f;
            body.turned = none ? 0 : parts(x, gain) & 0xffff | parts(y, gain) << 16;
            body.spinOffset = none ? 0 : parts(spin, gain);
        }
        float b = max(
                length(x - (short) body.turned / Sleep.PARTS * gain, y - (body.turned >> 16) / Sleep.PARTS * gain),
                Math.abs(spin - body.spinOffset / Sleep.PARTS * gain));
        float byLoad = Sleep.SHARE_OF_LOAD * max(by.load() - Sleep.FREE_WEIGHTS * gain, 0f);
        float most = gain > 0f ? min(byLoad, Sleep.MOST_BY_LOAD * gain) : byLoad;
        most = strict ? Sleep.STRICT * gain : Sleep.FLOOR * gain + most;
        if (!(b > most + Sleep.ROUNDING * t.thin / k.dt())) {
            body.restSteps = -1;
            return 0f;
        }
        body.restSteps--;
        int steps = -1 - body.restSteps;
        boolean wakes = strict || gain == 0f || b * (steps * steps) >= Sleep.PATIENCE * gain;
        return wakes ? max(b * k.subSteps(), Sleep.LEAST_WAKING * t.thin / k.dt()) : 0f;
    }

    // ---- rings

    /** Bodies that sleep, and that what woke in the ring before reaches. */
    List<RigidThing> reached(List<Circle> circles, List<RigidThing> bodies) {
        List<RigidThing> next = new ArrayList<>();
        for (RigidThing t : lying.bodies()) {
            float speed = 0f;
            for (RigidContact c : t.isAsleep() && !woken.contains(t) ? resting : List.<RigidContact>of()) {
                if (c.a == t || c.b == t) {
                    boolean isA = c.a == t;
                    RigidThing o = isA ? c.b : c.a;
                    if (bodies.contains(o)) {
                        speed = max(speed, passed(c, isA, o.wakingSpeed, c.inverseMassOf(!isA)));
                    } else if (o.circle != null && circles.contains(o.circle)) {
                        speed = max(speed, passed(c, isA, o.circle.wakingSpeed, o.ownW));
                    }
                }
            }
            for (ReferenceJoint joint :
                    t.isAsleep() && !woken.contains(t) ? lying.joints() : List.<ReferenceJoint>of()) {
                speed = max(speed, max(passed(joint, 0, t, bodies), passed(joint, 1, t, bodies)));
            }
            if (speed > Sleep.LEAST_HIT * t.thin / k.dt()) {
                t.wakingSpeed = speed;
                next.add(t);
            }
        }
        woken.addAll(next);
        return next;
    }

    private float passed(RigidContact c, boolean toA, float from, float its) {
        RigidThing t = toA ? c.a : c.b;
        float own = c.inverseMassOf(toA);
        return c.impulse > 0f
                ? Sleep.passedOn(from, t.ownW * c.impulse, pressed(t).load(), own, its, gainOfStep(t))
                : Sleep.passedFreely(from, c.gap, own, its, gainOfStep(t), k.dt());
    }

    /** All that are to wake do. */
    void wake() {
        woken.forEach(t -> t.body.wake());
    }

    // ---- who falls asleep

    /** A body that is awake has moved and turned in the step. */
    static void rest(RigidThing t, float[] moved, int turned, boolean driven, StepParameters k, Kinds kinds) {
        Rigid body = t.body;
        float gain = length(t.gain);
        float damping = kinds.getFloat(body.kind, Kinds.DAMPING);
        float most = Sleep.DRIFT * t.thin;
        most = gain > 0f
                ? min(most, Sleep.SHARE_OF_FALL * (gain * k.inverseH()) * (Sleep.TIME * Sleep.TIME))
                : most * min(damping * Sleep.TIME, 1f);
        float x = body.drift[0] + moved[0];
        float y = body.drift[1] + moved[1];
        int turn = body.turned + turned;
        boolean rests = (gain > 0f || damping > 0f)
                && kinds.get(body.kind, Kinds.AWAKE) == 0
                && !driven
                && Math.abs(body.omega) * k.dt() < Sleep.TURN_OF_STEP
                && x * x + y * y <= most * most
                && Math.abs((float) turn) * Sleep.RADIANS * t.reach <= most;
        if (!rests) {
            body.wake();
            return;
        }
        body.restSteps++;
        body.turned = turn;
        body.drift[0] = x;
        body.drift[1] = y;
        if (body.restSteps * k.dt() >= Sleep.TIME) {
            body.restSteps = -1;
            body.turned = Sleep.NO_OFFSET;
            body.drift[0] = t.gain[0] * k.inverseH();
            body.drift[1] = t.gain[1] * k.inverseH();
            body.knownSpin = t.angularGain * k.inverseH();
            body.velocity[0] = 0f;
            body.velocity[1] = 0f;
            body.omega = 0f;
        }
    }
}
