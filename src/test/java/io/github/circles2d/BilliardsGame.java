package io.github.circles2d;

import java.util.Arrays;

/**
 * A table of billiards, seen from above, as a new user writes it: metres, kilograms, seconds.
 *
 * <p>The world has the balls, the cushions, and the spin about the upright axis (english), which is the angular velocity of a circle.
 * Nothing in the world presses a ball onto the table, so neither friction nor rolling resistance of the world is the cloth. The game makes
 * the cloth: it keeps the speed that the spin about lying axes would roll each ball with (follow, or draw if it is backwards), and pushes
 * the balls by forces. English dies on the cloth by the angular damping of the kind.
 */
final class BilliardsGame implements AutoCloseable {
    static final float LENGTH = 2.54f;
    static final float WIDTH = 1.27f;
    static final float RADIUS = 0.0286f;
    static final float MASS = 0.17f;
    static final float STEP = 1 / 240f;

    /** Of two balls, and of a ball at a cushion: a wall has the restitution of the ball. */
    static final float RESTITUTION = 0.9f;

    static final float BALL_FRICTION = 0.06f;
    static final float CUSHION_FRICTION = 0.2f;
    static final float SLIDING = 0.2f;
    static final float ROLLING = 0.01f;
    static final float GRAVITY = 9.81f;

    private static final int BALL = 1;

    final World world;
    final long cue;

    /** By id: the velocity that the ball would roll with; that of its centre if it does roll. */
    private float[] roll = {};

    private float[] velocities = {};

    BilliardsGame(Backend backend) {
        // A ball and a cushion have the geometric mean of their frictions, which is to be that of cushions.
        float cushion = CUSHION_FRICTION * CUSHION_FRICTION / BALL_FRICTION;
        World.Builder builder = World.builder().backend(backend).bounds(0, 0, LENGTH, WIDTH);
        for (Wall wall : Wall.values()) {
            builder.wallSurface(wall, cushion, 0, 0);
        }
        world = builder.gravity(0, 0).restitution(RESTITUTION).build();
        world.kind(BALL).setFriction(BALL_FRICTION).setAngularDamping(0.3f);
        cue = ball(0.6f, WIDTH / 2);
    }

    long ball(float x, float y) {
        return world.add(x, y, RADIUS, MASS, 0, 0, BALL);
    }

    /** Fifteen balls in five rows. */
    void rack() {
        for (int row = 0; row < 5; row++) {
            for (int k = 0; k <= row; k++) {
                ball(1.8f + 1.74f * row * RADIUS, WIDTH / 2 + (2.002f * k - 1.001f * row) * RADIUS);
            }
        }
    }

    /** Strikes the cue ball. It rolls if (rollX, rollY) is its velocity, slides if it is 0, and draws if it points backwards. */
    void strike(float vx, float vy, float rollX, float rollY, float english) {
        ensure();
        world.setVelocity(cue, vx, vy);
        world.setAngularVelocity(cue, english);
        roll[2 * World.id(cue)] = rollX;
        roll[2 * World.id(cue) + 1] = rollY;
    }

    /** Makes a step. */
    void step() {
        ensure();
        world.readVelocitiesById(velocities, null);
        for (int id = 0; id < world.idLimit(); id++) {
            cloth(id);
        }
        world.step(STEP);
    }

    private void ensure() {
        if (velocities.length < 2 * world.idLimit()) {
            velocities = new float[2 * world.idLimit()];
            roll = Arrays.copyOf(roll, velocities.length);
        }
    }

    /** Sliding friction pushes the lowest point until the ball rolls. A sphere turns by 5/2 of what it loses. Then it rolls to a stop. */
    private void cloth(int id) {
        float vx = velocities[2 * id];
        float vy = velocities[2 * id + 1];
        float slipX = vx - roll[2 * id];
        float slipY = vy - roll[2 * id + 1];
        float slip = (float) Math.hypot(slipX, slipY);
        float loss = SLIDING * GRAVITY * STEP;
        float share = slip == 0 ? 0 : Math.min(loss / slip, 2 / 7f);
        float x = vx - share * slipX;
        float y = vy - share * slipY;
        roll[2 * id] += 2.5f * share * slipX;
        roll[2 * id + 1] += 2.5f * share * slipY;
        if (share == 2 / 7f || slip == 0) { // it rolls
            float speed = (float) Math.hypot(x, y);
            float kept = speed == 0 ? 0 : Math.max(0, 1 - ROLLING * GRAVITY * STEP / speed);
            x *= kept;
            y *= kept;
            roll[2 * id] = x;
            roll[2 * id + 1] = y;
        }
        world.applyForce(world.handle(id), (x - vx) * MASS / STEP, (y - vy) * MASS / STEP);
    }

    /** Makes steps until all balls lie still. */
    int stepsToRest() {
        int steps = 0;
        do {
            step();
            steps++;
        } while (fastest() > 0.001f);
        return steps;
    }

    private float fastest() {
        float fastest = 0;
        for (int id = 0; id < world.idLimit(); id++) {
            long ball = world.handle(id);
            fastest = Math.max(fastest, (float) Math.hypot(world.vx(ball), world.vy(ball)));
            fastest = Math.max(fastest, (float) Math.hypot(roll[2 * id], roll[2 * id + 1]));
        }
        return fastest;
    }

    /** That of the centres, of rolling on the cloth (two fifths of the mass), and of english (half of the mass). */
    double energy() {
        double sum = 0;
        for (int id = 0; id < world.idLimit(); id++) {
            long ball = world.handle(id);
            double surface = world.angularVelocity(ball) * (double) RADIUS;
            sum += square(world.vx(ball)) + square(world.vy(ball)) + surface * surface / 2;
            sum += 0.4 * (square(roll[2 * id]) + square(roll[2 * id + 1]));
        }
        return MASS * sum / 2;
    }

    private static double square(double value) {
        return value * value;
    }

    @Override
    public void close() {
        world.close();
    }
}
