package io.github.circles2d.bench.physics;

/** What the scenes have in common unless they say otherwise. */
final class Scenery {
    /** Radius of a circle. */
    static final double R = 0.5;

    static final double GRAVITY = 10;

    static final double TIME_STEP = 1 / 60f;

    /** Steps in a second. */
    static final int SECOND = 60;

    private Scenery() {}

    /** Mass of a circle of density 1. */
    static double mass(double radius) {
        return Math.PI * radius * radius;
    }
}
