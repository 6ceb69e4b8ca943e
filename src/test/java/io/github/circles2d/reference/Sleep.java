package io.github.circles2d.reference;

import static io.github.circles2d.reference.Numbers.dot;
import static io.github.circles2d.reference.Numbers.length;
import static io.github.circles2d.reference.Numbers.max;
import static io.github.circles2d.reference.Numbers.min;
import static io.github.circles2d.reference.Numbers.minus;
import static io.github.circles2d.reference.Numbers.plus;

import io.github.circles2d.Response;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Which circles fall asleep in a step, and which wake. A circle sleeps as long as gravity, its force and all impulses on it add up to
 * nothing, and nobody is about to push it. No circle knows more than those it touches: there are no islands.
 */
final class Sleep {
    /** Seconds for which a circle is where it was before it falls asleep. */
    static final float TIME = 1f;

    /** How far it may drift meanwhile: in radii, and by how far it would fall. */
    static final float DRIFT = 0.003f;

    static final float SHARE_OF_FALL = 0.001f;

    // how far a circle may be out of balance, in what gravity adds to its speed in a sub-step
    static final float FLOOR = 0.01f;
    static final float STRICT = 0.0005f;
    /** By how much gravity and a force change, of what they are, until a circle gets to know. */
    static final float CHANGE = 0.001f;

    // what a circle was out of balance as it fell asleep, in parts of its gain, along x in the lower half of a number
    // and y in the upper
    static final float PARTS = 16384f;
    static final float MOST_PARTS = 328f;
    static final int NO_OFFSET = Integer.MIN_VALUE;

    /** In radians. */
    static final float TURN_OF_STEP = 1f;

    static final float MOST_BY_LOAD = 1f;

    /** By what presses it, beyond so many weights. */
    static final float SHARE_OF_LOAD = 0.05f;

    static final float FREE_WEIGHTS = 2f;

    /** How many times what a spring carries counts. */
    static final float SPRING_LOADS = 4f;

    /** How much the balance of its surface counts if joints turn it. */
    static final float SHARE_OF_SPIN = 0.5f;

    /** Radii a step. */
    static final float ROUNDING = 1e-7f;

    /** A circle out of balance by b wakes once b times the square of the steps in a row is this many gains. */
    static final float PATIENCE = 2f;

    // how fast somebody has to push it, in what gravity adds to its speed in a step
    static final float PUSH = 0.5f;
    static final float HIT = 0.02f;

    /** Radii a step. */
    static final float LEAST_HIT = 1e-6f;

    static final float LEAST_WAKING = 2e-6f;

    /** How far a step wakes from circle to circle. */
    private static final int RINGS = 16;

    private static final float COINCIDENT = 1e-6f;
    static final float RADIANS = (float) (Math.PI / (1L << 31));

    /** How a circle that sleeps meets another one. The normal points from the one of lower id to the other. */
    private record Meeting(float[] normal, float separation, float radii, Impulses impulses) {}

    /** What presses a circle: the sum of all impulses, of the magnitudes of those that carry it, and of those along its surface. */
    private record Pressed(float x, float y, float load, float spin) {}

    private final List<Circle> circles;
    private final ReferenceTerrain terrain;
    private final ReferenceJoints joints;
    private final StepParameters k;
    private final Kinds kinds;

    /** The impulses of the step before, as this step goes on from them. */
    private final Map<Contact.Pair, Impulses> impulses = new HashMap<>();

    /** Contacts with bodies as the step begins. */
    private List<RigidContact> ofBodies = List.of();

    private float warmScale;

    Sleep(List<Circle> circles, ReferenceTerrain terrain, ReferenceJoints joints, StepParameters k, Kinds kinds) {
        this.circles = circles;
        this.terrain = terrain;
        this.joints = joints;
        this.k = k;
        this.kinds = kinds;
    }

    // ---- who wakes

    /** Wakes circles before anything else of the step. */
    void wake(Map<Contact.Pair, Impulses> impulseCache, RigidSleep bodies, float scale) {
        warmScale = scale;
        ofBodies = bodies.contacts();
        impulseCache.forEach((pair, each) -> impulses.put(pair, each.times(warmScale)));
        Map<Circle, Pressed> pressed = new HashMap<>();
        for (Circle c : circles) {
            if (c.isAsleep()) {
                c.freePath[0] = 0f;
                c.freePath[1] = 0f;
                pressed.put(c, pressedBy(c));
            }
        }
        List<Circle> woken = new ArrayList<>();
        for (Circle c : pressed.keySet()) {
            float speed = max(wakingSpeed(c), outOfBalance(c, pressed.get(c)));
            if (speed > 0f) {
                c.wakingSpeed = speed;
                woken.add(c);
            }
        }
        woken.forEach(Circle::wake);
        List<RigidThing> wokenBodies = bodies.firstWoken();
        for (int ring = 1; ring < RINGS && !(woken.isEmpty() && wokenBodies.isEmpty()); ring++) {
            List<Circle> next = new ArrayList<>();
            List<RigidThing> nextBodies = bodies.reached(woken, wokenBodies);
            for (Circle c : pressed.keySet()) {
                float speed = 0f;
                for (Circle o : c.isAsleep() ? woken : List.<Circle>of()) {
                    speed = max(speed, passedOn(c, o, pressed.get(c).load()));
                    for (ReferenceJoint joint : joints.of(c)) {
                        if (joint.isOf(o)) {
                            speed = max(
                                    speed, passedBy(joint, c, o, pressed.get(c).load()));
                        }
                    }
                }
                for (RigidThing o : c.isAsleep() ? wokenBodies : List.<RigidThing>of()) {
                    for (RigidContact contact : bodies.between(c, o)) {
                        speed = max(
                                speed, passedBy(contact, c, o, pressed.get(c).load()));
                    }
                }
                if (speed > LEAST_HIT * c.radius / k.dt()) {
                    c.wakingSpeed = speed;
                    next.add(c);
                }
            }
            next.forEach(Circle::wake);
            woken = next;
            wokenBodies = nextBodies;
        }
        bodies.wake();
    }

    private float gain(Circle c) {
        return length(c.gain);
    }

    /** What gravity and its force add to a circle's speed in a step. */
    private float gainOfStep(Circle c) {
        return gain(c) * k.subSteps();
    }

    private boolean couldMeet(Circle c, Circle o, boolean alsoSensed) {
        if (c.group != 0 && c.group == o.group) {
            return false;
        }
        Response response = kinds.response(c.kind, o.kind);
        return response == Response.SOLID && (alsoSensed || !joints.part(c, o))
                || alsoSensed && response == Response.SENSE;
    }

    private Meeting meeting(Circle c, Circle o) {
        Contact.Pair pair = c.id < o.id ? new Contact.Pair(c, o) : new Contact.Pair(o, c);
        float[] d =
                plus(pair.lower().wayTo(pair.higher()), minus(pair.higher().displacement, pair.lower().displacement));
        float distance = length(d);
        float radii = pair.lower().radius + pair.higher().radius;
        float[] normal = distance > COINCIDENT * radii ? new float[] {d[0] / distance, d[1] / distance} : new float[2];
        return new Meeting(normal, distance - radii, radii, impulses.getOrDefault(pair, Impulses.NONE));
    }

    /** The greatest speed with which something is about to push a circle that sleeps; 0 if nothing is. */
    private float wakingSpeed(Circle c) {
        boolean woken = joints.drive(c) || c.actingTorque != 0f || wallsMoveNear(c) || terrain.movesNear(c, kinds);
        float speed = 0f;
        for (Circle o : circles) {
            if (o.hasInfiniteMass()) {
                woken |= o.pathLength > 0f && couldMeet(c, o, true) && comesNear(o, c);
            } else if (!o.isAsleep() && couldMeet(c, o, false) && c.isNear(o)) {
                speed = max(speed, hitBy(c, o));
            }
        }
        for (ReferenceJoint joint : joints.of(c)) {
            Circle o = joint.otherThan(c);
            if (o != null && !o.isStatic()) {
                speed = max(speed, pulledBy(c, o, joint));
            }
        }
        for (RigidContact contact : ofBodies) {
            if (contact.isOf(c)) {
                speed = max(speed, hitBy(c, contact));
            }
        }
        return woken ? max(speed, strong(c)) : speed;
    }

    /** A speed that wakes for sure. */
    private float strong(Circle c) {
        return max(gainOfStep(c), LEAST_WAKING * c.radius / k.dt());
    }

    private static boolean comesNear(Circle moving, Circle c) {
        float[] d = c.wayTo(moving);
        float radii = c.radius + moving.radius;
        float far = (radii + Circle.MARGIN * radii) + moving.pathLength;
        return dot(d, d) < far * far;
    }

    private boolean wallsMoveNear(Circle c) {
        boolean near = false;
        for (int a = 0; a < 2; a++) {
            float far = c.radius + Circle.MARGIN * (2f * c.radius);
            near |= k.minIn()[a] != 0f && c.base[a] - k.min()[a] < far + Math.abs(k.minIn()[a]);
            near |= k.maxIn()[a] != 0f && k.max()[a] - c.base[a] < far + Math.abs(k.maxIn()[a]);
        }
        return near;
    }

    /** What a circle that is awake is about to add to the speed of one that sleeps; 0 if too little. */
    private float hitBy(Circle c, Circle o) {
        Meeting m = meeting(c, o);
        float v = o.id < c.id ? dot(m.normal(), o.velocity) : -dot(m.normal(), o.velocity);
        if (!(v > 0f) || !(m.separation() < v * k.dt())) {
            return 0f;
        }
        return hit(
                c,
                o,
                v,
                m.separation(),
                max(c.restitution, o.restitution),
                m.impulses().normal());
    }

    /** The same of a body. */
    private float hitBy(Circle c, RigidContact contact) {
        boolean isA = contact.a.circle == c;
        RigidThing body = isA ? contact.b : contact.a;
        float armX = isA ? contact.bx : contact.ax;
        float armY = isA ? contact.by : contact.ay;
        float vx = body.velocity[0] - body.omega * armY;
        float vy = body.velocity[1] + body.omega * armX;
        float v = (isA ? 1f : -1f) * (vx * contact.nx + vy * contact.ny);
        if (RigidSleep.turnsFar(body, k)) {
            v = RigidSleep.farSpeed(body, isA ? 1f : -1f, contact);
        }
        float restitution = max(contact.a.restitution, contact.b.restitution);
        return hit(c, contact.inverseMassOf(!isA), v, contact.gap, restitution, contact.impulse);
    }

    private float hit(Circle c, Circle o, float v, float separation, float restitution, float impulse) {
        return hit(c, o.ownInverseMass(), v, separation, restitution, impulse);
    }

    private float hit(Circle c, float itsInverseMass, float v, float separation, float restitution, float impulse) {
        if (!(v > 0f) || !(separation < v * k.dt())) {
            return 0f;
        }
        float share = c.ownInverseMass() / (c.ownInverseMass() + itsInverseMass);
        float speed = share * (1f + restitution) * v;
        float most = (impulse > 0f ? PUSH : HIT) * gainOfStep(c);
        return speed > most && speed > LEAST_HIT * c.radius / k.dt() ? speed : 0f;
    }

    /** What a circle that is awake is about to add by a joint to the speed of one that sleeps; 0 if too little. */
    private float pulledBy(Circle c, Circle o, ReferenceJoint joint) {
        float[] d = joint.offset(k.arena());
        float distance = length(d);
        float[] n = distance > 0f ? new float[] {d[0] / distance, d[1] / distance} : new float[2];
        float apart = o == joint.b ? dot(n, o.velocity) : -dot(n, o.velocity);
        float j = loadOf(joint);
        float speed = 0f;
        if (joint.rigid) {
            float v = joint.keepsDirection
                    ? length(o.velocity) + 0.5f * distance * Math.abs(o.angularVelocity)
                    : Math.abs(apart);
            speed = hit(c, o, v, 0f, 0f, j);
        }
        if (joint.hasLeast) {
            speed = max(speed, hit(c, o, -apart, distance - joint.leastLength, 0f, j));
        }
        if (joint.hasGreatest) {
            speed = max(speed, hit(c, o, apart, joint.greatestLength - distance, 0f, j));
        }
        return speed;
    }

    /** Of a sub-step, as this step goes on from the last one. */
    private float ofSubStep(float sum) {
        return sum * warmScale / k.subSteps();
    }

    /** What a joint carries; a spring counts more. */
    private float loadOf(ReferenceJoint joint) {
        return (joint.elastic ? SPRING_LOADS : 1f) * length(ofSubStep(joint.sum[0]), ofSubStep(joint.sum[1]));
    }

    /** By how much a circle is out of balance in a step, as a speed, if that is enough to wake it. Counts the steps in a row. */
    private float outOfBalance(Circle c, Pressed pressed) {
        float w = c.ownInverseMass();
        float gain = gain(c);
        boolean strict = learns(c, gain);
        float x = c.gain[0] + w * pressed.x();
        float y = c.gain[1] + w * pressed.y();
        if (c.turned == NO_OFFSET) {
            c.turned = strict || gain == 0f ? 0 : parts(x, gain) & 0xffff | parts(y, gain) << 16;
        }
        float b = length(x - (short) c.turned / PARTS * gain, y - (c.turned >> 16) / PARTS * gain);
        if (joints.of(c).stream().anyMatch(ReferenceJoint::turns)) {
            b = max(b, SHARE_OF_SPIN * Math.abs(c.turn.ownInverseInertia * pressed.spin()));
        }
        float byLoad = SHARE_OF_LOAD * max(w * pressed.load() - FREE_WEIGHTS * gain, 0f);
        float more = gain > 0f ? min(byLoad, MOST_BY_LOAD * gain) : byLoad; // weightless, all is by load
        float most = strict ? STRICT * gain : FLOOR * gain + more;
        if (!(b > most + ROUNDING * c.radius / k.dt())) {
            c.rest = -1;
            return 0f;
        }
        c.rest--;
        int steps = -1 - c.rest;
        boolean wakes = strict || gain == 0f || b * (steps * steps) >= PATIENCE * gain;
        return wakes ? max(b * k.subSteps(), LEAST_WAKING * c.radius / k.dt()) : 0f;
    }

    /** Whether gravity and the force of a circle are others than it knows; it knows them then. */
    private boolean learns(Circle c, float gain) {
        float change = length(c.gain[0] - c.drift[0] * k.h(), c.gain[1] - c.drift[1] * k.h());
        boolean changes = change > CHANGE * gain + ROUNDING * c.radius / k.dt();
        if (changes) {
            c.drift[0] = c.gain[0] * k.inverseH();
            c.drift[1] = c.gain[1] * k.inverseH();
        }
        return changes;
    }

    private static int parts(float x, float gain) {
        return (int) Numbers.clamp(x / gain * PARTS, -MOST_PARTS, MOST_PARTS);
    }

    /** Sums up, in no order, what a circle that sleeps is pressed by. */
    private Pressed pressedBy(Circle c) {
        float w = c.ownInverseMass();
        FixedSum sum = new FixedSum(c.radius * k.inverseH() / w);
        for (Circle o : circles) {
            boolean counts = o.isStatic() || couldMeet(c, o, false) && c.isNear(o);
            if (o != c && counts) {
                Meeting m = meeting(c, o);
                float side = c.id < o.id ? -1f : 1f;
                float j = m.impulses().normal();
                float f = m.impulses().friction();
                sum.add(0, side * (m.normal()[0] * j - m.normal()[1] * f));
                sum.add(1, side * (m.normal()[1] * j + m.normal()[0] * f));
                sum.add(2, j);
                sum.add(3, -f + side * m.impulses().rolling() / c.radius);
            }
        }
        for (int a = 0; a < 2; a++) {
            float along = (a == 0) == c.wallImpulse[a] > 0f ? c.wallFriction[a] : -c.wallFriction[a];
            sum.add(a, c.wallImpulse[a] / w);
            sum.add(1 - a, c.wallImpulse[a] == 0f ? 0f : along / w);
            sum.add(2, Math.abs(c.wallImpulse[a]) / w);
            sum.add(3, (c.wallRolling[a] - c.wallFriction[a]) / w);
        }
        for (PieceContact contact : terrain.contactsAtRest(c, kinds, k)) {
            float j = contact.normalImpulse / w;
            float f = contact.friction / w;
            float[] normal = contact.normal();
            sum.add(0, normal[0] * j - normal[1] * f);
            sum.add(1, normal[1] * j + normal[0] * f);
            sum.add(2, j);
            sum.add(3, (contact.rolling - contact.friction) / w);
        }
        for (RigidContact contact : ofBodies) {
            if (contact.isOf(c)) {
                float side = contact.a.circle == c ? 1f : -1f;
                float j = contact.impulse;
                float f = contact.grip;
                sum.add(0, side * (contact.nx * j - contact.ny * f));
                sum.add(1, side * (contact.ny * j + contact.nx * f));
                sum.add(2, j);
                sum.add(3, -f);
            }
        }
        joints.of(c).forEach(joint -> add(sum, c, joint));
        float[] taken = sum.take();
        return new Pressed(taken[0], taken[1], taken[2], taken[3]);
    }

    private void add(FixedSum sum, Circle c, ReferenceJoint joint) {
        float x = ofSubStep(joint.sum[0]);
        float y = ofSubStep(joint.sum[1]);
        float twist = ofSubStep(joint.sumOfTurning);
        float both = joint.keepsDirection ? -0.5f * length(joint.offset(k.arena())) * (joint.across * warmScale) : 0f;
        boolean isA = c == joint.a;
        sum.add(0, isA ? -x : x);
        sum.add(1, isA ? -y : y);
        sum.add(2, loadOf(joint));
        sum.add(3, (isA ? both + twist : both - twist) / c.radius);
    }

    /** What of the speed that woke a circle reaches one that sleeps; 0 if too little. */
    private float passedOn(Circle c, Circle o, float load) {
        Meeting m = meeting(c, o);
        if (!couldMeet(c, o, false) || !(m.separation() < Circle.MARGIN * m.radii())) {
            return 0f;
        }
        float j = m.impulses().normal();
        return j > 0f ? passedOn(c, o, j, load) : passedFreely(c, o, m.separation());
    }

    private float passedOn(Circle c, Circle o, float j, float load) {
        return passedOn(o.wakingSpeed, j, load, c.ownInverseMass(), o.ownInverseMass(), gainOfStep(c));
    }

    private float passedFreely(Circle c, Circle o, float separation) {
        return passedFreely(o.wakingSpeed, separation, c.ownInverseMass(), o.ownInverseMass(), gainOfStep(c), k.dt());
    }

    /** By a body. */
    private float passedBy(RigidContact contact, Circle c, RigidThing o, float load) {
        float own = c.ownInverseMass();
        float its = contact.inverseMassOf(contact.a == o);
        return contact.impulse > 0f
                ? passedOn(o.wakingSpeed, contact.impulse, load, own, its, gainOfStep(c))
                : passedFreely(o.wakingSpeed, contact.gap, own, its, gainOfStep(c), k.dt());
    }

    static float passedOn(float from, float j, float load, float own, float its, float gainOfStep) {
        float speed = from * min(2f * j / load, 1f) * min(own / its, 1f);
        return speed > PUSH * gainOfStep ? speed : 0f;
    }

    static float passedFreely(float from, float separation, float own, float its, float gainOfStep, float dt) {
        float speed = from * (2f * own / (own + its));
        return separation < from * dt && speed > HIT * gainOfStep ? speed : 0f;
    }

    /** The same by a joint. */
    private float passedBy(ReferenceJoint joint, Circle c, Circle o, float load) {
        float j = loadOf(joint);
        if (j > 0f) {
            return passedOn(c, o, j, load);
        }
        float distance = length(joint.offset(k.arena()));
        float speed = joint.rigid ? passedFreely(c, o, 0f) : 0f;
        speed = joint.hasLeast ? max(speed, passedFreely(c, o, distance - joint.leastLength)) : speed;
        return joint.hasGreatest ? max(speed, passedFreely(c, o, joint.greatestLength - distance)) : speed;
    }

    // ---- who falls asleep

    /** After the step. torn: circles whose joints have broken in it. */
    void fallAsleep(List<Circle> torn) {
        for (Circle c : circles) {
            if (torn.contains(c)) {
                c.wake();
            } else if (!c.isStatic()) {
                rest(c);
            }
        }
    }

    private void rest(Circle c) {
        float gain = gain(c);
        float damping = kinds.damping(c);
        float drift = DRIFT * c.radius;
        drift = gain > 0f
                ? min(drift, SHARE_OF_FALL * (gain * k.inverseH()) * (TIME * TIME))
                : drift * min(damping * TIME, 1f);
        boolean mayRest = (gain > 0f || damping > 0f)
                && kinds.get(c.kind, Kinds.AWAKE) == 0
                && !joints.drive(c)
                && c.actingTorque == 0f
                && Math.abs(c.angularVelocity) * k.dt() < TURN_OF_STEP;
        boolean rests = mayRest
                && dot(c.drift, c.drift) <= drift * drift
                && Math.abs((float) c.turned) * RADIANS * c.radius <= drift;
        if (!rests) {
            c.wake();
            return;
        }
        c.rest++;
        for (int a = 0; a < 2; a++) {
            c.drift[a] -= c.displacement[a];
        }
        if (c.rest * k.dt() >= TIME && stays(c, 0) && stays(c, 1)) {
            c.rest = -1;
            c.drift[0] = c.gain[0] * k.inverseH();
            c.drift[1] = c.gain[1] * k.inverseH();
            c.turned = NO_OFFSET;
            c.velocity[0] = 0f;
            c.velocity[1] = 0f;
            c.angularVelocity = 0f;
        }
    }

    /** Whether a step leaves a coordinate as it is, to the bit, if the circle does not move. */
    private static boolean stays(Circle c, int axis) {
        return isSame(c.base[axis] + c.displacement[axis], c.base[axis])
                && isSame(0f + c.displacement[axis], c.displacement[axis]);
    }

    private static boolean isSame(float a, float b) {
        return Float.floatToRawIntBits(a) == Float.floatToRawIntBits(b);
    }
}
