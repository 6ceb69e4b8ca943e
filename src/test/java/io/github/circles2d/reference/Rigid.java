package io.github.circles2d.reference;

import io.github.circles2d.Edge;

/** A body that is pushed: its state. Arrays hold a value for x and one for y. */
final class Rigid {
    private static final float GREATEST_FORCE = 1e18f;

    /** What few bodies have is in the hash with numbers from this one on. */
    private static final int FIRST_EXTRA = 16;

    private static final long RIGID = 0x7269676964733264L;

    final int id;
    final long handle;
    final RigidOutline outline;
    final float mass;
    final float[] base = new float[2];

    /** What the last addition to the base lost. */
    final float[] rest = new float[2];

    /** In parts of a turn of which it has 2^32. */
    int angle;

    final float[] velocity = new float[2];
    float omega;
    float inertia;
    float restitution;
    int kind;
    long tag;

    /** What acts in the next step alone. */
    final float[] force = new float[2];

    float torque;

    /** What acts until it is changed. */
    final float[] lastingForce = new float[2];

    float lastingTorque;
    int group;

    /** As of a {@link Circle}. */
    int restSteps;

    int turned;
    final float[] drift = new float[2];

    /** While asleep, the angular acceleration that it knows, and what its turning was out of balance. */
    float knownSpin;

    int spinOffset;

    Rigid(int id, long handle, RigidOutline outline, float mass) {
        this.id = id;
        this.handle = handle;
        this.outline = outline;
        this.mass = mass;
        inertia = mass * outline.inertia;
    }

    /** Where a point of it is in the world. */
    float[] place(float[] point, Arena arena) {
        float[] at = turned(angle, point[0], point[1]);
        return new float[] {arena.inside(0, base[0] + at[0]), arena.inside(1, base[1] + at[1])};
    }

    /** Where a place of the world is in its coordinates. */
    float[] pointAt(float[] place, Arena arena) {
        float[] way = arena.way(base, new float[] {arena.inside(0, place[0]), arena.inside(1, place[1])});
        float[] point = turned(-angle, way[0], way[1]);
        return new float[] {point[0] + 0f, point[1] + 0f};
    }

    private static float[] turned(int units, float x, float y) {
        double cos = Angles.cos(units);
        double sin = Angles.sin(units);
        return new float[] {(float) (cos * x - sin * y), (float) (sin * x + cos * y)};
    }

    boolean isAsleep() {
        return restSteps < 0;
    }

    /** Is awake, and begins anew to come to rest. */
    void wake() {
        restSteps = 0;
        turned = 0;
        drift[0] = 0f;
        drift[1] = 0f;
        knownSpin = 0f;
        spinOffset = 0;
    }

    void put(float x, float y, int toAngle) {
        place(0, x);
        place(1, y);
        angle = toAngle;
    }

    void place(int axis, float coordinate) {
        base[axis] = coordinate;
        rest[axis] = 0f;
    }

    void push(float[] impulse, float[] arm) {
        for (int a = 0; a < 2; a++) {
            velocity[a] = Numbers.limitSpeed(velocity[a] + 1f / mass * impulse[a]) + 0f;
        }
        turn(Numbers.clamp(arm[0] * impulse[1] - arm[1] * impulse[0], -GREATEST_FORCE, GREATEST_FORCE));
    }

    void turn(float impulse) {
        omega = Numbers.limitSpeed(omega + 1f / inertia * impulse) + 0f;
    }

    void press(float forceX, float forceY, float itsTorque) {
        force[0] = sum(force[0], forceX);
        force[1] = sum(force[1], forceY);
        torque = sum(torque, itsTorque);
    }

    /** A force at a point. */
    void press(float forceX, float forceY, float[] arm) {
        press(forceX, forceY, Numbers.clamp(arm[0] * forceY - arm[1] * forceX, -GREATEST_FORCE, GREATEST_FORCE));
    }

    /** The force of the next step. */
    float force(int axis) {
        return sum(lastingForce[axis], force[axis]);
    }

    float torque() {
        return sum(lastingTorque, torque);
    }

    private static float sum(float a, float b) {
        return Numbers.clamp(a + b, -GREATEST_FORCE, GREATEST_FORCE) + 0f;
    }

    /** Takes what it has become in a step. */
    void arrive(float[] displacement, Arena arena, float[] min, float[] max) {
        for (int a = 0; a < 2; a++) {
            float sum = base[a] + displacement[a];
            float part = sum - base[a];
            rest[a] = (base[a] - (sum - part)) + (displacement[a] - part);
            base[a] = sum;
            float inside = arena.edges()[a] == Edge.WRAP ? arena.inside(a, sum) : Numbers.clamp(sum, min[a], max[a]);
            if (inside != sum) {
                place(a, inside);
            }
        }
        release();
    }

    /** What acts in one step alone has acted. */
    void release() {
        force[0] = 0f;
        force[1] = 0f;
        torque = 0f;
    }

    long hash() {
        long h = ReferenceWorld.absorb(ReferenceWorld.absorb(RIGID, id), kind);
        h = ReferenceWorld.absorb(ReferenceWorld.absorb(h, base), rest);
        h = ReferenceWorld.absorb(ReferenceWorld.absorb(h, angle), velocity);
        h = ReferenceWorld.absorb(h, omega, mass, inertia, restitution, force[0], force[1], torque);
        h = ReferenceWorld.absorb(ReferenceWorld.absorb(h, (int) tag), (int) (tag >> 32));
        int[] bits = {
            Float.floatToRawIntBits(lastingForce[0]),
            Float.floatToRawIntBits(lastingForce[1]),
            Float.floatToRawIntBits(lastingTorque),
            group,
            restSteps,
            turned,
            Float.floatToRawIntBits(drift[0]),
            Float.floatToRawIntBits(drift[1]),
            Float.floatToRawIntBits(knownSpin),
            spinOffset
        };
        for (int k = 0; k < bits.length; k++) {
            if (bits[k] != 0) {
                h = ReferenceWorld.absorb(ReferenceWorld.absorb(h, FIRST_EXTRA + k), bits[k]);
            }
        }
        for (int word : outline.words()) {
            h = ReferenceWorld.absorb(h, word);
        }
        return h;
    }
}
