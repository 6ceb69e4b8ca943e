package io.github.circles2d.reference;

/** A circle: its state, and what a step notes about it. */
final class Circle {
    static final float MARGIN = 0.025f;
    static final float CAP = 0.25f;

    final int id;
    final Axis x = new Axis();
    final Axis y = new Axis();
    float radius;
    float mass;
    float restitution;

    // within a step
    int level;
    float pathLength;
    float speculativeDistance;
    int candidates;
    float farthest;
    float timeOfImpact;
    float allowance;
    boolean loaded;
    boolean loadedNext;

    Circle(int id) {
        this.id = id;
    }

    /** What a circle has once for x and once for y. */
    static final class Axis {
        float base;
        float displacement;
        float velocity;

        /** The speed that the wall has given; positive if it is the lower wall. */
        float wallImpulse;

        // within a step
        float path;
        float freePath;
        float impulses;
        float velocityBeforeImpulses;
        Wall wall;

        void place(float coordinate) {
            base = coordinate;
            displacement = 0f;
        }
    }

    float inverseMass() {
        return 1f / mass;
    }

    boolean isStatic() {
        return inverseMass() == 0f;
    }

    /** How near to a wall the centre may be. */
    float margin() {
        return isStatic() ? 0f : radius;
    }

    /** Notes what the circle moves in the step if it meets nothing, and how far from its centre contacts are looked for. */
    void plan(float pathX, float pathY) {
        x.path = pathX;
        y.path = pathY;
        pathLength = Numbers.length(pathX, pathY);
        speculativeDistance = (radius + MARGIN * radius) + Numbers.min(pathLength, CAP * radius);
    }

    boolean isFast() {
        return pathLength > radius;
    }

    /** A bound of what the circle is near to, with room for rounding. */
    double left() {
        return x.base - 1.001 * speculativeDistance;
    }

    double right() {
        return x.base + 1.001 * speculativeDistance;
    }

    boolean isNear(Circle other) {
        float dx = other.x.base - x.base;
        float dy = other.y.base - y.base;
        float limit = speculativeDistance + other.speculativeDistance;
        return dx * dx + dy * dy < limit * limit;
    }
}
