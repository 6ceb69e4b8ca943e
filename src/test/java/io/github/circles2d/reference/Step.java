package io.github.circles2d.reference;

import static io.github.circles2d.reference.Numbers.clamp;
import static io.github.circles2d.reference.Numbers.length;
import static io.github.circles2d.reference.Numbers.limitSpeed;
import static io.github.circles2d.reference.Numbers.min;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;

/** One step of at least one circle, or one body that is pushed. */
final class Step {
    private static final int CROWD = 60;

    private final List<Circle> circles;
    private final ReferenceTerrain terrain;
    private final ReferenceJoints joints;
    private final ReferenceRigids rigids;
    private final StepParameters k;
    private final Kinds kinds;
    private final List<Contact> contacts = new ArrayList<>();

    /** Those of circles of different levels. */
    private final List<Contact> crossContacts = new ArrayList<>();

    /** Circles whose joints have broken in the step. */
    private List<Circle> torn = List.of();

    /** What bodies that are pushed touch, and which pairs of them rest. */
    private final List<RigidTouch> touches = new ArrayList<>();

    private Set<RigidTouch.Key> resting = Set.of();

    /** Circles are in the order of their ids. */
    Step(
            List<Circle> circles,
            ReferenceTerrain terrain,
            ReferenceJoints joints,
            ReferenceRigids rigids,
            StepParameters k,
            Kinds kinds) {
        this.circles = circles;
        this.terrain = terrain;
        this.joints = joints;
        this.rigids = rigids;
        this.k = k;
        this.kinds = kinds;
    }

    /** Makes the step; cached impulses are multiplied by a scale, then replaced by those that the step ends with. */
    void make(Map<Contact.Pair, Impulses> impulseCache, float warmScale) {
        circles.forEach(this::findGain);
        if (k.sleep()) {
            circles.forEach(c -> c.turn = new Turn(c, kinds, k.surfaces(), k.h()));
            circles.forEach(this::planMotion);
            RigidStep lying = new RigidStep(rigids.all(), circles, terrain, joints, k, kinds);
            RigidSleep bodies = new RigidSleep(lying, rigids.contacts(), k, warmScale);
            new Sleep(circles, terrain, joints, k, kinds).wake(impulseCache, bodies, warmScale);
        }
        Grid grid = new Grid(circles, k);
        circles.forEach(c -> c.turn = new Turn(c, kinds, k.surfaces(), k.h()));
        circles.forEach(this::planMotion);
        joints.begin(circles, k, warmScale);
        new ContinuousCollision(circles, grid, k, kinds).clampMotion();
        circles.stream().filter(c -> !c.isStatic()).forEach(c -> terrain.findContacts(c, kinds, k));
        findContacts(grid);
        prepare(impulseCache, warmScale);
        RigidStep bodies = new RigidStep(rigids.all(), circles, terrain, joints, k, kinds);
        bodies.begin(rigids.contacts(), warmScale);
        for (int subStep = 0; subStep < k.subSteps(); subStep++) {
            int now = subStep;
            circles.forEach(c -> integrateVelocities(c, now));
            bodies.integrateVelocities();
            contacts.forEach(Contact::solve);
            joints.solve(subStep);
            bodies.solve(subStep);
            crossPass(Contact::solve);
            bodies.solveCircles();
            all(Contact::lookAfterSolve);
            circles.forEach(c -> integratePositions(c, now));
            bodies.integratePositions(subStep);
            contacts.forEach(Step::relax);
            joints.relax(subStep);
            bodies.relax(subStep);
            crossPass(Step::relax);
            circles.forEach(c -> c.claim = 0);
            circles.forEach(Circle::takeImpulses);
            bodies.relaxCircles(subStep == k.subSteps() - 1);
            all(Contact::lookAfterRelax);
        }
        touches.addAll(bodies.touches());
        resting = bodies.resting();
        RigidSensing sensing = new RigidSensing(rigids.all());
        rigids.keep(bodies.end());
        circles.forEach(this::finalizePositions);
        if (rigids.events.isOn()) {
            touches.addAll(sensing.touches(circles, terrain, k, kinds, rigids.events::touched));
        }
        all(Contact::lookAfterStep);
        storeImpulses(impulseCache, warmScale);
        torn = joints.end(k.dt(), bodies.broken());
    }

    /** Lets circles fall asleep, after the step. */
    void fallAsleep() {
        if (k.sleep()) {
            new Sleep(circles, terrain, joints, k, kinds).fallAsleep(torn);
        }
    }

    List<RigidTouch> touches() {
        return touches;
    }

    Set<RigidTouch.Key> resting() {
        return resting;
    }

    /** The contacts of the step. */
    List<Contact> contacts() {
        List<Contact> both = new ArrayList<>(contacts);
        both.addAll(crossContacts);
        return both;
    }

    private void all(Consumer<Contact> job) {
        contacts().forEach(job);
    }

    /** A pass over the contacts of different levels. */
    private void crossPass(Consumer<Contact> visit) {
        for (Circle c : circles) {
            c.velocityBeforePass = c.velocity.clone();
            c.turn.speedBeforePass = c.turn.speed;
        }
        crossContacts.forEach(visit);
        circles.forEach(Circle::takeGains);
    }

    private void findGain(Circle c) {
        float scale = kinds.gravityScale(c);
        for (int a = 0; a < 2; a++) {
            c.gain[a] = limitSpeed(k.gravity()[a] * scale) * k.h();
            if (c.actingForce[a] != 0f) {
                c.gain[a] = limitSpeed(c.gain[a] + c.actingForce[a] * c.ownInverseMass() * k.h());
            }
        }
    }

    /** What is left of a velocity after a sub-step's damping. */
    private float dampingFactor(Circle c) {
        return 1f / (1f + kinds.damping(c) * k.h());
    }

    /** Multiplies a vector so that it is not longer than a length. */
    private static void cut(float[] vector, float most) {
        float length = length(vector);
        for (int a = 0; a < 2 && length > most; a++) {
            vector[a] *= most / length;
        }
    }

    private void planMotion(Circle c) {
        float factor = dampingFactor(c);
        float powers = 0f;
        float falls = 0f;
        float power = 1f;
        for (int subStep = 0; subStep < k.subSteps(); subStep++) {
            power *= factor;
            powers += power;
            falls += powers;
        }
        // The sums of powers of 1 are whole numbers, but their product with h need not be dt.
        float time = factor == 1f || c.isStatic() ? k.dt() : k.h() * powers;
        for (int a = 0; a < 2; a++) {
            c.path[a] = c.velocity[a] * time + (c.isStatic() ? 0f : c.gain[a] * k.h() * falls);
        }
        if (!c.isStatic()) {
            cut(c.path, kinds.greatestSpeed(c) * k.dt());
        }
        float share = k.arena().share(c.path);
        c.path[0] *= share;
        c.path[1] *= share;
        c.pathLength = length(c.path);
        if (c.isStatic()) {
            ContinuousCollision.cutStaticPath(c, k);
        } else {
            ContinuousCollision.cutPath(c, k);
        }
        c.speculativeDistance = (c.radius + Circle.MARGIN * c.radius) + min(c.pathLength, Circle.CAP * c.radius);
    }

    private void findContacts(Grid grid) {
        List<Contact.Pair> candidates = new ArrayList<>();
        circles.forEach(c -> c.candidates = 0);
        for (int i = 0; i < circles.size(); i++) {
            Circle a = circles.get(i);
            for (Circle b : circles.subList(i + 1, circles.size())) {
                if (a.isNear(b) && kinds.mayMeet(a, b)) {
                    candidates.add(new Contact.Pair(a, b));
                    a.candidates += b.level <= a.level ? 1 : 0;
                    b.candidates += a.level <= b.level ? 1 : 0;
                }
            }
        }
        for (Contact.Pair pair : candidates) {
            long fewer = Math.min(pair.lower().candidates, pair.higher().candidates);
            if (fewer <= CROWD || (pair.hash() >>> 16) * fewer < CROWD * 65_536L) {
                Contact contact = new Contact(pair, k);
                (contact.isCross() ? crossContacts : contacts).add(contact);
            }
        }
        crossContacts.forEach(Contact::cross);
        crossContacts.sort(
                Comparator.comparing((Contact c) -> c.light, grid.order()).thenComparingInt(c -> c.heavy.id));
        circles.forEach(c -> c.forgetHeavyContacts(k));
        crossContacts.forEach(Contact::join);
        crossContacts.forEach(Contact::split);
        contacts.forEach(c -> c.colour = grid.colour(c));
        contacts.sort(Comparator.comparingInt((Contact c) -> -c.level())
                .thenComparingInt(c -> c.colour)
                .thenComparingInt(c -> c.lower.id)
                .thenComparingInt(c -> c.higher.id));
    }

    private void prepare(Map<Contact.Pair, Impulses> impulseCache, float warmScale) {
        for (Circle c : circles) {
            clearImpulses(c);
            for (int a = 0; a < 2; a++) {
                c.walls[a] = new Wall(c, a, k);
            }
        }
        contacts.forEach(contact -> prepare(contact, impulseCache, warmScale));
        joints.prepare();
        crossContacts.forEach(contact -> prepare(contact, impulseCache, warmScale));
        circles.forEach(Circle::takeImpulses);
    }

    private static void prepare(Contact contact, Map<Contact.Pair, Impulses> impulseCache, float warmScale) {
        contact.begin(impulseCache.getOrDefault(contact.pair, Impulses.NONE), warmScale);
        contact.measure();
        contact.warmStart(contact.carries(contact.normalVelocity(c -> c.velocity)));
    }

    private void integrateVelocities(Circle c, int subStep) {
        c.loaded = !c.isStatic() && (c.loadedNext || c.wallImpulse[0] != 0f || c.wallImpulse[1] != 0f);
        c.loaded |= !c.isStatic() && c.pieceContacts.stream().anyMatch(contact -> contact.normalImpulse > 0f);
        float[] gained = new float[2];
        for (int a = 0; a < 2; a++) {
            c.velocityBeforeImpulses[a] = c.isStatic() ? c.velocity[a] : (c.velocity[a] + c.gain[a]) * dampingFactor(c);
        }
        if (!c.isStatic()) {
            cut(c.velocityBeforeImpulses, kinds.greatestSpeed(c));
        }
        for (int a = 0; a < 2; a++) {
            if (!c.isStatic()) {
                c.velocity[a] = limitSpeed(c.velocityBeforeImpulses[a] + c.inverseMass() * c.impulses[a]);
            }
        }
        c.turn.speedBeforeImpulses = c.turn.speed;
        if (!c.isStatic()) {
            c.turn.accelerate();
            c.walls[0].warmStartGrips();
            c.walls[1].warmStartGrips();
        }
        for (int a = 0; a < 2; a++) {
            if (!c.isStatic()) {
                c.walls[a].measure(subStep);
                float before = c.velocity[a];
                c.walls[a].apply(c.walls[a].normalImpulse);
                c.walls[a].solveInFrame();
                gained[a] = c.velocity[a] - before;
            }
        }
        for (int a = 0; a < 2 && !c.isStatic(); a++) {
            float slip = c.walls[a].slipOf(c.velocityBeforeImpulses, c.turn.speedBeforeImpulses);
            c.walls[a].look(c.velocityBeforeImpulses[a], gained[a], slip);
        }
        if (c.isStatic()) {
            return;
        }
        PieceContact.measure(c.pieceContacts, subStep);
        c.pieceContacts.forEach(PieceContact::warmStart);
        c.pieceContacts.stream().filter(PieceContact::acts).forEach(contact -> contact.solve(subStep));
    }

    private void integratePositions(Circle c, int subStep) {
        float[] from = c.displacement.clone();
        float[] to = new float[2];
        for (int a = 0; a < 2; a++) {
            c.velocity[a] = limitSpeed(c.velocity[a]);
            to[a] = c.displacement[a] + c.velocity[a] * k.h();
        }
        c.turn.move();
        if (!c.isStatic()) {
            ContinuousCollision.clamp(c, to);
        }
        for (int a = 0; a < 2; a++) {
            float x = c.base[a] + to[a];
            float low = c.isStatic() ? c.low(a, k) : (k.min()[a] - k.behind(k.minIn()[a], subStep)) + c.radius;
            float high = c.isStatic() ? c.high(a, k) : (k.max()[a] + k.behind(k.maxIn()[a], subStep)) - c.radius;
            c.displacement[a] = x < low ? low - c.base[a] : x > high ? high - c.base[a] : to[a];
            if (!c.isStatic()) {
                c.walls[a].stopAtFarWall(to[a]);
            } else if (c.displacement[a] != to[a]) {
                c.velocity[a] = 0f;
            }
        }
        if (c.isStatic()) {
            clearImpulses(c);
            return;
        }
        PieceContact.move(c, from, subStep);
        for (int a = 0; a < 2 && !c.isStatic(); a++) {
            float before = c.velocity[a];
            float slip = c.walls[a].slipOf(c.velocity, c.turn.speed);
            c.walls[a].measure(subStep);
            c.walls[a].relax();
            c.walls[a].storeImpulse();
            c.walls[a].look(before, c.velocity[a] - before, slip);
        }
        c.pieceContacts.stream().filter(PieceContact::acts).forEach(contact -> contact.relax(subStep + 1));
        clearImpulses(c);
    }

    private static void clearImpulses(Circle c) {
        c.impulses[0] = 0f;
        c.impulses[1] = 0f;
        c.loadedNext = false;
    }

    private static void relax(Contact contact) {
        contact.measure();
        if (contact.relax()) {
            contact.warmStart(true);
        }
    }

    private void finalizePositions(Circle c) {
        for (int a = 0; a < 2; a++) {
            c.drift[a] += !k.sleep() || c.isStatic() ? 0f : c.displacement[a];
            float sum = c.base[a] + c.displacement[a];
            float inside = clamp(sum, c.low(a, k), c.high(a, k));
            float part = sum - c.base[a];
            float lost = (c.base[a] - (sum - part)) + (c.displacement[a] - part);
            c.displacement[a] = inside == sum ? lost : 0f;
            c.base[a] = inside;
            bringInside(c, a);
            c.velocity[a] = limitSpeed(c.velocity[a]);
        }
        c.turn.finish(c, k.h());
    }

    /** What leaves on one side of an axis that wraps comes in on the other, and loses nothing by rounding. */
    private void bringInside(Circle c, int axis) {
        float turns = k.arena().turns(axis, c.base[axis]);
        if (turns == 0f) {
            return;
        }
        float away = -(turns * k.arena().period(axis));
        float near = c.base[axis] + away;
        float rest = c.displacement[axis] + lost(c.base[axis], away);
        float sum = near + rest;
        c.base[axis] = k.arena().clamp(axis, sum);
        c.displacement[axis] = c.base[axis] == sum ? lost(near, rest) : 0f;
    }

    /** What a sum loses by rounding. */
    private static float lost(float a, float b) {
        float sum = a + b;
        float part = sum - a;
        return (a - (sum - part)) + (b - part);
    }

    private void storeImpulses(Map<Contact.Pair, Impulses> impulseCache, float warmScale) {
        impulseCache.keySet().removeIf(pair -> !pair.rests());
        impulseCache.replaceAll((pair, impulses) -> impulses.times(warmScale));
        for (Contact contact : contacts()) {
            if (contact.normalImpulse > 0f) {
                impulseCache.put(contact.pair, new Impulses(contact.normalImpulse, contact.friction, contact.rolling));
            }
        }
    }
}
