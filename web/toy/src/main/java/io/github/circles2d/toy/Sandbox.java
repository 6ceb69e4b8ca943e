package io.github.circles2d.toy;

import io.github.circles2d.Bodies;
import io.github.circles2d.Joint;
import io.github.circles2d.JointType;
import io.github.circles2d.Joints;
import io.github.circles2d.Rewind;
import io.github.circles2d.Ropes;
import io.github.circles2d.Wall;
import io.github.circles2d.World;
import java.util.HashSet;
import java.util.Random;
import java.util.Set;

/** A world, its past, and what the pointer does to it. */
final class Sandbox {
    static final float DT = 1 / 60f;

    /** States to go back to: of ten seconds, or fewer of a large world. */
    private static final int MOST_PAST = 600;

    private static final int LEAST_PAST = 4;
    private static final int BYTES_OF_PAST = 64 << 20;

    /** A world of more circles than this is saved the more seldom, for that takes as long as a step. */
    private static final int OFTEN_SAVED = 3_000;

    /** How many circles there are at most when tools have added theirs. */
    private static final int MOST_CIRCLES = 8_000;

    /** How many they may add to any world. */
    private static final int MORE_CIRCLES = 2_000;

    // Of the joint between the pointer and a grabbed circle.
    private static final float PULL_HERTZ = 4;

    /** How much of the speed that a held body lacks it gets in a step. */
    private static final double PULL_PART = 0.7;

    /** The greatest acceleration, which brings a circle to a high speed in a fortieth of a second. */
    private static final float PULL = 40;

    /** The speed that an explosion gives to a usual circle, as a part of one that is high in the world. */
    private static final float BLAST = 0.7f;

    // In radii of usual circles.
    private static final float NEAR = 3.5f; // how far beside a circle a finger may be
    private static final float LINK = 1.9f;
    private static final float LINK_RADIUS = 0.6f;
    private static final float CUT = 0.8f;
    private static final float WALL_RADIUS = 0.9f;
    private static final float SHORTEST_WALL = 0.6f;
    private static final float BLAST_RADIUS = 4.5f;
    private static final float BLAST_FALLOFF = 18;
    private static final float POURED_AROUND = 4.5f;
    private static final float POURED_LEAST = 0.7f;
    private static final float POURED_MORE = 0.6f;
    private static final float POURED_SPEED = 35; // a second

    private static final int POURED = 6;
    private static final int MOST_PIECES = 4_000;

    private final World world;
    private final Grain grain;
    private final View first;
    private final Rewind past;
    private final int mostCircles;

    // Of gravity.
    private final float directionX;
    private final float directionY;

    private final Random random = new Random(1);

    /** The pins whose force has a limit that the world had when it came. Others of the past are hands of then. */
    private final Set<Long> ownPulls = new HashSet<>();

    private final BodyShapes bodies = new BodyShapes();

    private long grabbed;

    /** A body that is held, and the place where, as it lies when it is not turned. */
    private long pushed;

    private double armX;
    private double armY;
    private long grip;
    private long begun;
    private float begunX;
    private float begunY;
    private boolean pouring;
    private float x;
    private float y;
    private int steps;

    /** The last step before which the state was saved, if there was something to save. */
    private int looked;

    /** Whether a circle was awake then; true at first, so that the first state is saved. */
    private boolean wasAwake = true;

    Sandbox(World world) {
        this.world = world;
        first = View.of(world);
        grain = Grain.of(world, first);
        mostCircles = Math.max(MOST_CIRCLES, world.size() + MORE_CIRCLES);
        int fitting = BYTES_OF_PAST / world.snapshotBytes();
        float strength = gravity();
        directionX = strength > 0 ? world.gravityX() / strength : 0;
        directionY = strength > 0 ? world.gravityY() / strength : -1;
        findPulls();
        past = new Rewind(world, Math.max(LEAST_PAST, Math.min(fitting, MOST_PAST)));
    }

    World world() {
        return world;
    }

    Grain grain() {
        return grain;
    }

    View view() {
        return first.now(world);
    }

    int steps() {
        return steps;
    }

    void close() {
        world.close();
    }

    /** The pointer is there now. A wall that is being drawn goes on to it. */
    void moveTo(float toX, float toY) {
        x = view().nearestX(toX);
        y = view().nearestY(toY);
    }

    /** Takes the body or the circle at the pointer. */
    void grab() {
        pushed = bodies.at(world.bodies(), x, y);
        grabbed = pushed == 0 ? circleHere() : 0;
        if (pushed != 0) {
            double cos = Math.cos(world.bodies().angle(pushed));
            double sin = Math.sin(world.bodies().angle(pushed));
            double dx = x - world.bodies().x(pushed);
            double dy = y - world.bodies().y(pushed);
            armX = cos * dx + sin * dy;
            armY = cos * dy - sin * dx;
        }
    }

    /** The circle under the pointer, or the nearest around it, for fingers are thick; 0 if there is none. */
    private long circleHere() {
        long[] found = {world.queries().pick(x, y)};
        if (found[0] == 0) {
            world.queries().nearest(x, y, NEAR * grain.radius(), 1, found, null);
        }
        return found[0];
    }

    /** A joint will begin here, at a circle or a place. */
    void beginJoint() {
        begun = circleHere();
        begunX = begun == 0 ? x : world.x(begun);
        begunY = begun == 0 ? y : world.y(begun);
    }

    /** It ends here: a spring, or a rope of small circles. */
    void endJoint(boolean isRope) {
        long to = circleHere();
        if (begun != 0 && (!world.contains(begun) || begun == to)) {
            return;
        }
        float toX = to == 0 ? x : world.x(to);
        float toY = to == 0 ? y : world.y(to);
        float length = (float) Math.hypot(toX - begunX, toY - begunY);
        if (!isRope) {
            join(begun, begunX, begunY, to, toX, toY, Joint.spring(2, 0.2f));
            return;
        }
        int count = (int) (length / (LINK * grain.radius())) - 1;
        if (count < 1 || world.size() + count > mostCircles) {
            return;
        }
        Ropes.End from = begun == 0 ? Ropes.at(begunX, begunY) : Ropes.circle(begun);
        Ropes.End end = to == 0 ? Ropes.at(toX, toY) : Ropes.circle(to);
        float radius = LINK_RADIUS * grain.radius();
        float mass = grain.mass(radius);
        if (isLoose(begun) || isLoose(to)) {
            Ropes.rope(world, from, end, count, radius, mass, 0);
        } else {
            Ropes.bridge(world, from, end, count, radius, mass, 0);
        }
    }

    /** Joins two ends, circles or places, of which one can move. */
    private void join(long a, float ax, float ay, long b, float bx, float by, Joint joint) {
        boolean isLoose = isLoose(a);
        if (isLoose && b != 0) {
            world.joints().add(a, b, joint);
        } else if (isLoose) {
            world.joints().add(a, bx, by, joint);
        } else if (isLoose(b)) {
            world.joints().add(b, ax, ay, joint);
        }
    }

    private boolean isLoose(long circle) {
        return circle != 0 && world.mass(circle) < Float.POSITIVE_INFINITY;
    }

    /** Holds the circle here where it is. */
    void pin() {
        long circle = circleHere();
        if (isLoose(circle)) {
            world.joints().add(circle, world.x(circle), world.y(circle), Joint.pin());
        }
    }

    /** Removes the joints here. */
    void cut() {
        Joints joints = world.joints();
        float reach = CUT * grain.radius();
        for (long found = joints.pick(x, y, reach); found != 0; found = joints.pick(x, y, reach)) {
            joints.remove(found);
        }
    }

    void pour() {
        pouring = true;
    }

    /** Lets a circle go with the speed that it has, and pours no more. */
    void release() {
        if (grip != 0 && world.joints().contains(grip)) {
            world.joints().remove(grip);
        }
        grip = 0;
        grabbed = 0;
        pushed = 0;
        pouring = false;
    }

    void explode() {
        float radius = grain.radius();
        float impulse = BLAST * grain.highSpeed() * grain.mass(radius);
        world.explode(x, y, BLAST_RADIUS * radius, impulse, BLAST_FALLOFF * radius);
    }

    /** Draws a wall to the pointer. */
    void wallFrom(float fromX, float fromY) {
        boolean isLong = Math.max(Math.abs(x - fromX), Math.abs(y - fromY)) > SHORTEST_WALL * grain.radius();
        if (isLong && world.terrain().size() < MOST_PIECES) {
            world.terrain().addSegment(fromX, fromY, x, y, WALL_RADIUS * grain.radius(), 0);
        }
    }

    /** Gives walls and the circles of kind 0 a surface, which those that are poured have, too. Belts stay. */
    void setSurface(float friction, float rollingResistance) {
        world.kind(0).setFriction(friction).setRollingResistance(rollingResistance);
        for (Wall wall : Wall.values()) {
            world.setWallSurface(wall, friction, rollingResistance, world.wallBeltSpeed(wall));
        }
    }

    void setGravity(float strength) {
        world.setGravity(strength * directionX, strength * directionY);
    }

    float gravity() {
        return length(world.gravityX(), world.gravityY());
    }

    private static float length(float x, float y) {
        return (float) Math.sqrt((double) x * x + (double) y * y);
    }

    float friction() {
        float own = world.kind(0).friction();
        return Float.isNaN(own) ? world.defaultFriction() : own;
    }

    float rollingResistance() {
        float own = world.kind(0).rollingResistance();
        return Float.isNaN(own) ? world.defaultRollingResistance() : own;
    }

    /** Whether circles that come to rest fall asleep. */
    boolean sleeps() {
        return world.sleeps() && world.kind(0).sleeps();
    }

    /** Lets circles of kind 0 fall asleep, or wakes them, if the world is one in which circles sleep. */
    void setSleeps(boolean sleeps) {
        world.kind(0).setSleeps(sleeps);
    }

    void step() {
        save();
        if (pouring) {
            addSome();
        }
        if (grabbed != 0 && world.contains(grabbed)) {
            pull();
        }
        if (pushed != 0 && world.bodies().contains(pushed)) {
            pullBody(world.bodies());
        }
        world.step(DT);
        steps++;
    }

    /** Takes the held place towards the pointer: its speed follows the distance. */
    private void pullBody(Bodies all) {
        double cos = Math.cos(all.angle(pushed));
        double sin = Math.sin(all.angle(pushed));
        double ax = cos * armX - sin * armY;
        double ay = sin * armX + cos * armY;
        double px = all.x(pushed) + ax;
        double py = all.y(pushed) + ay;
        double spin = all.angularVelocity(pushed);
        double wishedX = PULL_HERTZ * (x - px) - (all.vx(pushed) - spin * ay);
        double wishedY = PULL_HERTZ * (y - py) - (all.vy(pushed) + spin * ax);
        double part = Math.min(1, grain.highSpeed() / Math.max(Math.hypot(wishedX, wishedY), 1e-30));
        double mass = PULL_PART / (1 / all.mass(pushed) + (ax * ax + ay * ay) / all.inertia(pushed));
        all.applyImpulse(
                pushed, (float) (mass * part * wishedX), (float) (mass * part * wishedY), (float) px, (float) py);
    }

    private void pull() {
        Joints joints = world.joints();
        float mass = world.mass(grabbed);
        if (mass == Float.POSITIVE_INFINITY) {
            world.setPosition(grabbed, x, y);
        } else if (grip != 0 && joints.contains(grip)) {
            joints.setAnchor(grip, x, y);
        } else {
            grip = joints.add(grabbed, x, y, Joint.mouse(PULL_HERTZ, 1, PULL * grain.highSpeed() * mass));
        }
    }

    private void addSome() {
        View view = view();
        float unit = grain.radius();
        float gravity = (float) Math.hypot(world.gravityX(), world.gravityY());
        float fall = gravity > 0 ? POURED_SPEED * unit / gravity : 0;
        for (int k = 0; k < POURED && world.size() < mostCircles; k++) {
            float radius = unit * (POURED_LEAST + POURED_MORE * random.nextFloat());
            float px = x + 2 * POURED_AROUND * unit * (random.nextFloat() - 0.5f);
            float py = y + 2 * POURED_AROUND * unit * (random.nextFloat() - 0.5f);
            if (view.holds(px, py, radius) && world.queries().overlapCircle(px, py, radius, new long[0]) == 0) {
                world.add(px, py, radius, grain.mass(radius), fall * world.gravityX(), fall * world.gravityY());
            }
        }
    }

    /** Keeps the state for {@link #back}. While all circles sleep, that of the first such step will do. */
    private void save() {
        if (steps >= looked + Math.max(1, world.size() / OFTEN_SAVED) || steps <= looked) {
            boolean isAwake = world.stats().awake() > 0;
            if (isAwake || wasAwake) {
                past.save(steps);
            }
            wasAwake = isAwake;
            looked = steps;
        }
    }

    /** Goes back to the last state that was saved before; does nothing if there is none. */
    void back() {
        for (int step = steps - 1; past.size() > 0 && step >= past.oldest(); step--) {
            if (past.has(step)) {
                past.restore(step);
                steps = step;
                looked = step;
                wasAwake = true;
                letGo();
                return;
            }
        }
    }

    /** A world of the past may be held by a hand of then. */
    private void letGo() {
        Joints joints = world.joints();
        for (int id = 0; id < joints.idLimit(); id++) {
            long found = joints.handle(id);
            if (found != 0 && isPull(joints.joint(found)) && !ownPulls.contains(found)) {
                joints.remove(found);
            }
        }
        grip = 0;
    }

    private void findPulls() {
        Joints joints = world.joints();
        for (int id = 0; id < joints.idLimit(); id++) {
            long found = joints.handle(id);
            if (found != 0 && isPull(joints.joint(found))) {
                ownPulls.add(found);
            }
        }
    }

    private static boolean isPull(Joint joint) {
        return joint.type() == JointType.PIN && joint.maxForce() < Float.POSITIVE_INFINITY;
    }
}
