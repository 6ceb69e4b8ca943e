package io.github.circles2d.thesis;

/**
 * The ranges of all input. Within them everything stays finite for 1,000 steps with any number of circles, which the kernels need:
 * they are compiled for finite numbers alone.
 *
 * <p>Speeds. Contacts and walls add no kinetic energy when one contact is resolved after the other, and gravity adds at most 1e7 to
 * every component of a velocity in 1,000 steps of 1 s. If one circle of the least mass took the energy of 65,536 circles of the
 * greatest, its speed would be 4e15, its way in 1,000 steps 4e18, and the square of a distance 7e37: a float reaches 3e38. The race of
 * contacts that share a circle loses some of their updates and with them adds or removes energy, but favours neither: in models of
 * the race speeds grew by a factor of 100 at most. Speeds have room for a factor of 1e17 before an impulse overflows.
 *
 * <p>Radii. An overlap is at least one unit in the last place of the sum of two radii. At the least radius its square is 1e-26 and
 * far from underflow, which would make the direction of an impulse too long, and two circles would gain speed in every step. At
 * the greatest radius all contacts of 1,000 steps push a circle less than 1e14 away.
 */
final class Ranges {
    private static final float COORDINATE = 1e6f;
    private static final float LEAST_RADIUS = 1e-6f;
    private static final float GREATEST_RADIUS = 1e6f;
    private static final float LEAST_MASS = 1e-6f;
    private static final float GREATEST_MASS = 1e6f;
    private static final float SPEED = 1e6f;
    private static final float GRAVITY = 1e4f;
    private static final float LEAST_STEP = 1e-6f;
    private static final float GREATEST_STEP = 1;

    private Ranges() {}

    static void circle(float x, float y, float radius, float mass, float vx, float vy) {
        within("the x of a circle", x, -COORDINATE, COORDINATE);
        within("the y of a circle", y, -COORDINATE, COORDINATE);
        within("the radius of a circle", radius, LEAST_RADIUS, GREATEST_RADIUS);
        within("the mass of a circle", mass, LEAST_MASS, GREATEST_MASS);
        within("the x velocity of a circle", vx, -SPEED, SPEED);
        within("the y velocity of a circle", vy, -SPEED, SPEED);
    }

    static void timeStep(float seconds) {
        within("the time step", seconds, LEAST_STEP, GREATEST_STEP);
    }

    static void restitution(float restitution) {
        within("the restitution", restitution, 0, 1);
    }

    static void gravity(float x, float y) {
        within("the x of gravity", x, -GRAVITY, GRAVITY);
        within("the y of gravity", y, -GRAVITY, GRAVITY);
    }

    private static void within(String what, float value, float least, float greatest) {
        if (!(value >= least && value <= greatest)) {
            throw new IllegalArgumentException(what + " must be from " + least + " to " + greatest + ", not " + value);
        }
    }
}
