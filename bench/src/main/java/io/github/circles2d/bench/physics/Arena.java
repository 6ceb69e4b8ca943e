package io.github.circles2d.bench.physics;

/** A world that a scene fills, steps and watches. Circles have the numbers 0, 1, 2, .. in the order of adding. */
interface Arena extends AutoCloseable {
    /** Adds a circle; an infinite mass makes it static, or kinematic if it has a velocity. */
    int add(double x, double y, double radius, double mass, double vx, double vy);

    /** Adds a circle at rest. */
    default int add(double x, double y, double radius, double mass) {
        return add(x, y, radius, mass, 0, 0);
    }

    void setPosition(int circle, double x, double y);

    void setRadius(int circle, double radius);

    /** Moves the walls within the next step, which has this length. */
    void setBounds(double minX, double minY, double maxX, double maxY, double timeStep);

    void step(double timeStep, int steps);

    /** Makes steps of 1/60 s. */
    default void step(int steps) {
        step(Scenery.TIME_STEP, steps);
    }

    /** A copy of the present state. */
    State state();

    @Override
    void close();
}
