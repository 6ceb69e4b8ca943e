package io.github.circles2d.reference;

import static io.github.circles2d.reference.Numbers.dot;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** A circle: its state, and what a step notes about it. Arrays hold a value for x and one for y. */
final class Circle {
    static final float MARGIN = 0.025f;
    static final float CAP = 0.25f;

    final int id;
    final long handle;
    final float[] base = new float[2];
    final float[] displacement = new float[2];
    final float[] velocity = new float[2];
    final float[] wallImpulse = new float[2];

    /** Of the walls, as the impulses: friction, and what stops the rolling. */
    final float[] wallFriction = new float[2];

    final float[] wallRolling = new float[2];

    /** In parts of a turn of which it has 2^32. */
    int angle;

    float angularVelocity;

    /** Where a static circle travels in the next step; null if nowhere. */
    float[] target;

    float radius;

    /** The radius that it has after the steps in which it grows. */
    float radiusGrownTo;

    /** In how many steps it has that radius; 0 if it does not grow. */
    int stepsToGrow;

    float mass;
    float restitution;
    int kind;
    int group;
    long tag;
    final float[] force = new float[2];

    /** What acts in the next step alone. */
    final float[] appliedForce = new float[2];

    float torque;
    float appliedTorque;

    /** Not a number if the kind has them. */
    float friction = Float.NaN;

    float rollingResistance = Float.NaN;

    float gravityScale = Float.NaN;

    float damping = Float.NaN;

    float greatestSpeed = Float.NaN;

    /** With the pieces that it was near to in the last step, in the order of their ids. */
    final List<PieceContact> pieceContacts = new ArrayList<>();

    /**
     * While awake, how many steps in a row it has been near to where it came to rest; while asleep, -1 minus the steps in a row in which it
     * was out of balance.
     */
    int rest;

    /** While awake, how far it is from where it came to rest, less the displacement; while asleep, the acceleration by gravity and its force. */
    final float[] drift = new float[2];

    /** While awake, by how many parts of a turn it has turned since it came to rest; while asleep, what it was out of balance. */
    int turned;

    // within a step
    /** Of a circle that wakes, the speed that woke it. */
    float wakingSpeed;

    /** The base as the step begins. */
    float[] start = base;

    Arena arena;

    /** The whole force in this step. */
    final float[] actingForce = new float[2];

    float actingTorque;
    Turn turn;

    /** What is added to the velocity in a sub-step. */
    final float[] gain = new float[2];

    final float[] path = new float[2];
    final float[] freePath = new float[2];
    final float[] impulses = new float[2];
    final float[] velocityBeforeImpulses = new float[2];
    final Wall[] walls = new Wall[2];
    int level;
    int column;
    int row;
    int candidates;
    float pathLength;
    float speculativeDistance;
    float leastPath;
    float contactTime;
    float timeOfImpact;
    float allowance;
    boolean stands;
    boolean isPushed;
    float carryTime;
    Circle carrier;
    boolean loaded;
    boolean loadedNext;

    /** Of a heavy circle, what its contacts with light ones add up to. */
    int load;

    /** Of a heavy circle, 1 + the highest id of the light ones that wait to bounce off it; 0 if there are none. */
    int claim;

    /** Whether a joint holds it. */
    boolean jointed;

    /** Those that joints keep from colliding with it. */
    final Set<Circle> parted = new HashSet<>();

    /** How many of its joints have found no colour. */
    int splitJoints;

    /** Of a circle with joints that have found no colour, what these give it. */
    FixedSum jointGain;

    FixedSum jointImpulse;

    FixedSum heavyGain;
    FixedSum heavyImpulse;
    float[] velocityBeforePass;

    Circle(int id, long handle) {
        this.id = id;
        this.handle = handle;
    }

    /** As a step sees it: nothing moves a circle that sleeps. */
    float inverseMass() {
        return isAsleep() ? 0f : ownInverseMass();
    }

    float ownInverseMass() {
        return 1f / mass;
    }

    /** Whether a step moves it by its own velocity alone: its mass is infinite, or it sleeps. */
    boolean isStatic() {
        return inverseMass() == 0f;
    }

    boolean hasInfiniteMass() {
        return ownInverseMass() == 0f;
    }

    boolean isAsleep() {
        return rest < 0;
    }

    /** Is awake, and begins anew to come to rest. */
    void wake() {
        rest = 0;
        turned = 0;
        for (int a = 0; a < 2; a++) {
            drift[a] = hasInfiniteMass() ? 0f : 0f - displacement[a];
        }
    }

    /** From this circle to another, by their bases. */
    float[] wayTo(Circle other) {
        return arena.way(base, other.base);
    }

    boolean isNear(Circle other) {
        float[] d = wayTo(other);
        float distance = speculativeDistance + other.speculativeDistance;
        return dot(d, d) < distance * distance;
    }

    void place(int axis, float coordinate) {
        base[axis] = coordinate;
        displacement[axis] = 0f;
    }

    /** Sets out for the target; returns the velocity to go on with after the step. */
    float[] depart(float dt, Arena arena) {
        float[] own = velocity.clone();
        for (int a = 0; a < 2 && target != null; a++) {
            velocity[a] = Numbers.limitSpeed(arena.way(base, target)[a] / dt);
        }
        return own;
    }

    /** Is at the target after the step. */
    void arrive(float[] own) {
        for (int a = 0; a < 2; a++) {
            place(a, target[a]);
            velocity[a] = own[a];
        }
        target = null;
    }

    /** The least coordinate that the circle may have. */
    float low(int axis, StepParameters k) {
        return k.min()[axis] + (isStatic() ? 0f : radius);
    }

    /** The greatest coordinate that the circle may have. */
    float high(int axis, StepParameters k) {
        return k.max()[axis] - (isStatic() ? 0f : radius);
    }

    void beginJoints(StepParameters k) {
        parted.clear();
        jointed = false;
        splitJoints = 0;
        jointGain = new FixedSum(radius * k.inverseH());
        jointImpulse = new FixedSum(radius * k.inverseH() / inverseMass());
    }

    void forgetHeavyContacts(StepParameters k) {
        load = 0;
        claim = 0;
        heavyGain = new FixedSum(radius * k.inverseH());
        heavyImpulse = new FixedSum(radius * k.inverseH() / inverseMass());
    }

    /** Adds what light circles gave it in a pass to its velocity. */
    void takeGains() {
        turn.speed += take(load != 0, heavyGain, velocity);
    }

    /** Adds the impulses of its contacts with light circles to those that it begins its next sub-step with. */
    void takeImpulses() {
        turn.impulse += take(load != 0, heavyImpulse, impulses);
    }

    void takeJointGains() {
        turn.speed += take(true, jointGain, velocity);
    }

    void takeJointImpulses() {
        turn.impulse += take(true, jointImpulse, impulses);
    }

    /** Adds a sum to a vector; returns what to add along the surface. */
    private float take(boolean takes, FixedSum sum, float[] vector) {
        float[] taken = sum.take();
        for (int a = 0; a < 2 && takes && !isStatic(); a++) {
            vector[a] += taken[a];
        }
        return takes && !isStatic() ? taken[2] : 0f;
    }
}
