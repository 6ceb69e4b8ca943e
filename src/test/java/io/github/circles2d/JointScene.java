package io.github.circles2d;

import static io.github.circles2d.TerrainBall.DT;

/** Discs and joints without walls. All surfaces have a friction of 0.6; a kind of discs meets none. */
final class JointScene implements AutoCloseable {
    /** The kind of discs that meet none. */
    static final int ALONE = 2;

    final World world;

    JointScene(double gravity) {
        world = TerrainBall.builder(gravity, 0.6, 0).build();
        world.kind(ALONE).setMask(0);
    }

    long ball(double x, double y, double radius, double mass) {
        return world.add((float) x, (float) y, (float) radius, (float) mass, 0, 0);
    }

    /** A disc that meets none. */
    long alone(double x, double y, double radius, double mass) {
        return world.add((float) x, (float) y, (float) radius, (float) mass, 0, 0, ALONE);
    }

    /** Holds a disc to a place. */
    long hold(long ball, double x, double y, Joint joint) {
        return world.joints().add(ball, (float) x, (float) y, joint);
    }

    long hold(long ball, long other, Joint joint) {
        return world.joints().add(ball, other, joint);
    }

    void step(int steps) {
        world.step((float) DT, steps);
    }

    double x(long ball) {
        return world.x(ball);
    }

    double y(long ball) {
        return world.y(ball);
    }

    double vx(long ball) {
        return world.vx(ball);
    }

    double vy(long ball) {
        return world.vy(ball);
    }

    double speed(long ball) {
        return Math.hypot(vx(ball), vy(ball));
    }

    double distance(long ball, double x, double y) {
        return Math.hypot(x(ball) - x, y(ball) - y);
    }

    double distance(long ball, long other) {
        return distance(ball, x(other), y(other));
    }

    double meanSpeed(long[] balls) {
        double sum = 0;
        for (long ball : balls) {
            sum += speed(ball);
        }
        return sum / balls.length;
    }

    @Override
    public void close() {
        world.close();
    }
}
