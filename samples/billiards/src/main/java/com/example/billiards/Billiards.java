package com.example.billiards;

import io.github.circles2d.Backend;
import io.github.circles2d.Chain;
import io.github.circles2d.Events;
import io.github.circles2d.Queries;
import io.github.circles2d.World;

/**
 * The rules, seen from above, in metres, kilograms and seconds. Nothing in the world presses balls onto the cloth, so the game makes the
 * cloth by forces: it keeps the velocity with which each ball's spin about lying axes would roll it.
 */
final class Billiards implements Runnable {
    static final float LENGTH = 2.54f, WIDTH = 1.27f, MIDDLE = LENGTH / 2, RADIUS = 0.0286f, HOLE = 0.062f;
    static final float STEP = 1 / 240f;
    static final int CUSHION = 0, CUE = 1, BALL = 2, POCKET = 3; // kinds
    static final float[][] POCKETS = {
        {-0.03f, -0.03f}, {MIDDLE, -0.05f}, {LENGTH + 0.03f, -0.03f},
        {-0.03f, WIDTH + 0.03f}, {MIDDLE, WIDTH + 0.05f}, {LENGTH + 0.03f, WIDTH + 0.03f}
    };
    /** Balls are on the right of a chain, which is its left on a screen: y points down there. */
    static final float[][] CUSHIONS = {
        {MIDDLE - 0.05f, -0.06f, MIDDLE - 0.065f, 0, 0.085f, 0, 0.02f, -0.065f},
        {LENGTH - 0.02f, -0.065f, LENGTH - 0.085f, 0, MIDDLE + 0.065f, 0, MIDDLE + 0.05f, -0.06f},
        {LENGTH + 0.065f, WIDTH - 0.02f, LENGTH, WIDTH - 0.085f, LENGTH, 0.085f, LENGTH + 0.065f, 0.02f},
        {MIDDLE + 0.05f, WIDTH + 0.06f, MIDDLE + 0.065f, WIDTH, LENGTH - 0.085f, WIDTH, LENGTH - 0.02f, WIDTH + 0.065f},
        {0.02f, WIDTH + 0.065f, 0.085f, WIDTH, MIDDLE - 0.065f, WIDTH, MIDDLE - 0.05f, WIDTH + 0.06f},
        {-0.065f, 0.02f, 0, 0.085f, 0, WIDTH - 0.085f, -0.065f, WIDTH - 0.02f}
    };

    private static final float MASS = 0.17f, SLIDING = 0.2f * 9.81f, ROLLING = 0.01f * 9.81f; // both in m/s²

    final World world;
    final Queries balls; // all but the cue ball
    long cue; // the cue ball
    float aimX = 1, aimY, side, top; // where to; where the cue hits, in radii to the right and up
    float wantedSpeed; // of the shot that is to be made, or 0
    int shots, potted, fouls;
    private final float[] roll = new float[44], velocities = new float[44]; // by id

    Billiards(Backend backend) {
        World.Builder builder = World.builder().bounds(-0.15f, -0.15f, LENGTH + 0.15f, WIDTH + 0.15f);
        world = builder.restitution(0.9f).backend(backend).build();
        world.kind(CUSHION).setFriction(0.67f); // with a ball the geometric mean, 0.2
        world.kind(CUE).setFriction(0.06f).setAngularDamping(0.4f);
        world.kind(BALL).setFriction(0.06f).setAngularDamping(0.4f).setCategory(0b10);
        world.kind(POCKET).setSensor(true);
        world.report(POCKET, CUE, Events.BEGIN);
        world.report(POCKET, BALL, Events.BEGIN);
        balls = world.queries().withMask(0b10);
        for (float[] cushion : CUSHIONS) {
            world.terrain().addChain(Chain.of(cushion));
        }
        for (float[] pocket : POCKETS) { // a ball drops if its centre is over the hole
            world.add(pocket[0], pocket[1], HOLE - RADIUS, Float.POSITIVE_INFINITY, 0, 0, POCKET);
        }
        cue = add(MIDDLE / 2, WIDTH / 2, CUE, 0);
        for (int number = 1, row = 0; row < 5; row++) { // the tag of a ball is its number
            for (int k = 0; k <= row; k++, number++) {
                float y = WIDTH / 2 + (2.002f * k - 1.001f * row) * RADIUS;
                add(1.5f * MIDDLE + 1.74f * row * RADIUS, y, BALL, number);
            }
        }
    }

    private long add(float x, float y, int kind, int number) {
        long ball = world.add(x, y, RADIUS, MASS, 0, 0, kind);
        world.setTag(ball, number);
        roll[2 * World.id(ball)] = roll[2 * World.id(ball) + 1] = 0;
        return ball;
    }

    /** Whether the cue ball lies still; the others may roll. */
    boolean isReady() {
        int k = 2 * World.id(cue);
        return Math.abs(world.vx(cue)) + Math.abs(world.vy(cue)) + Math.abs(roll[k]) + Math.abs(roll[k + 1]) < 0.01f;
    }

    /** Makes the changes before each step of the world. */
    @Override
    public void run() {
        Events events = world.events();
        for (int i = 0; i < events.size(); i++) {
            long ball = events.b(i); // the pockets have the lower ids
            if (world.contains(ball)) { // it has not dropped into two of them at once
                world.remove(ball);
                potted += ball == cue ? 0 : 1;
            }
        }
        if (!world.contains(cue)) { // it comes back to its place, or as near to it as there is room
            float x = MIDDLE / 2;
            while (balls.overlapCircle(x, WIDTH / 2, RADIUS, new long[0]) > 0) {
                x -= RADIUS / 2;
            }
            cue = add(x, WIDTH / 2, CUE, 0);
            fouls++;
        }
        if (wantedSpeed > 0 && isReady()) {
            strike();
        }
        world.readVelocitiesById(velocities, null);
        for (int id = POCKETS.length; id < world.idLimit(); id++) {
            if (world.handle(id) != 0) {
                cloth(id, velocities[2 * id], velocities[2 * id + 1]);
            }
        }
    }

    /** A blow beside the centre turns the ball, by its lever: to the side it is english, above follow, and below draw. */
    private void strike() {
        int k = 2 * World.id(cue);
        world.applyImpulse(cue, MASS * wantedSpeed * aimX, MASS * wantedSpeed * aimY);
        world.applyAngularImpulse(cue, -MASS * wantedSpeed * side * RADIUS);
        roll[k] = 2.5f * top * wantedSpeed * aimX; // a sphere that is hit 2/5 of its radius above its centre rolls
        roll[k + 1] = 2.5f * top * wantedSpeed * aimY;
        wantedSpeed = 0;
        shots++;
    }

    /** Sliding friction pushes the lowest point until the ball rolls. A sphere turns by 5/2 of what it loses. Then it rolls to a stop. */
    private void cloth(int id, float vx, float vy) {
        float slipX = vx - roll[2 * id], slipY = vy - roll[2 * id + 1], slip = length(slipX, slipY);
        float share = slip == 0 ? 2 / 7f : Math.min(SLIDING * STEP / slip, 2 / 7f);
        float x = vx - share * slipX, y = vy - share * slipY, speed = length(x, y);
        roll[2 * id] += 2.5f * share * slipX;
        roll[2 * id + 1] += 2.5f * share * slipY;
        if (share == 2 / 7f) { // it rolls
            float kept = speed == 0 ? 0 : Math.max(0, 1 - ROLLING * STEP / speed);
            roll[2 * id] = x *= kept;
            roll[2 * id + 1] = y *= kept;
        }
        world.applyForce(world.handle(id), (x - vx) * MASS / STEP, (y - vy) * MASS / STEP);
    }

    void aimAt(float x, float y) {
        float length = length(x - world.x(cue), y - world.y(cue)) + 1e-9f;
        aimX = (x - world.x(cue)) / length;
        aimY = (y - world.y(cue)) / length;
    }

    private static float length(float x, float y) {
        return (float) Math.sqrt(x * x + y * y); // not Math.hypot, which may differ from machine to machine
    }

    /** A player without hands breaks, then shoots at the nearest ball, each time with another spin. */
    void playAlone() {
        long[] nearest = new long[1];
        int count = balls.nearest(world.x(cue), world.y(cue), 3, 1, nearest, null);
        if (isReady() && wantedSpeed == 0 && count > 0) {
            aimAt(world.x(nearest[0]), world.y(nearest[0]) - 0.1f * RADIUS);
            side = 0.3f * (shots % 3 - 1);
            top = 0.4f * ((shots + 1) % 3 - 1);
            wantedSpeed = shots == 0 ? 7 : 2.5f;
        }
    }
}
