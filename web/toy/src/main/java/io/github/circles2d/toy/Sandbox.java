package io.github.circles2d.toy;

import io.github.circles2d.Rewind;
import io.github.circles2d.Wall;
import io.github.circles2d.World;
import java.util.Random;

/** A world, its past, and what the pointer does to it. */
final class Sandbox {
    static final float DT = 1 / 60f;
    static final float WIDTH = 160;
    static final float HEIGHT = 100;

    /** Steps to go back by: ten seconds, or fewer of a large world. */
    private static final int MOST_PAST = 600;

    private static final int LEAST_PAST = 60;
    private static final int BYTES_OF_PAST = 64 << 20;

    private static final int MOST_CIRCLES = 8_000;

    /** Part of the way to the pointer that a grabbed circle goes in a step, as a speed. */
    private static final float PULL = 15;

    private static final int MOST_PIECES = 4_000;
    private static final float SHORTEST_WALL = 0.5f;
    private static final float BLAST_RADIUS = 4;
    private static final float BLAST_FALLOFF = 16;
    private static final float BLAST_IMPULSE = 70;
    private static final int POURED = 6;

    private final World world;
    private final Rewind past;
    private final Random random = new Random(1);
    private long grabbed;
    private boolean pouring;
    private float x;
    private float y;
    private int steps;

    Sandbox(String stage) {
        world = Stages.open(stage);
        int fitting = BYTES_OF_PAST / world.snapshotBytes();
        past = new Rewind(world, Math.max(LEAST_PAST, Math.min(fitting, MOST_PAST)));
    }

    World world() {
        return world;
    }

    int steps() {
        return steps;
    }

    void close() {
        world.close();
    }

    /** The pointer is there now. A wall that is being drawn goes on to it. */
    void moveTo(float toX, float toY) {
        x = Math.max(0, Math.min(toX, WIDTH));
        y = Math.max(0, Math.min(toY, HEIGHT));
    }

    /** Takes the circle under the pointer, or the nearest around it, for fingers are thick. */
    void grab() {
        long[] nearest = new long[1];
        grabbed = world.queries().pick(x, y);
        if (grabbed == 0 && world.queries().nearest(x, y, 3, 1, nearest, new float[1]) > 0) {
            grabbed = nearest[0];
        }
    }

    void pour() {
        pouring = true;
    }

    /** Lets a circle go with the speed that it has, and pours no more. */
    void release() {
        grabbed = 0;
        pouring = false;
    }

    void explode() {
        world.explode(x, y, BLAST_RADIUS, BLAST_IMPULSE, BLAST_FALLOFF);
    }

    /** Draws a wall to the pointer. */
    void wallFrom(float fromX, float fromY) {
        boolean isLong = Math.max(Math.abs(x - fromX), Math.abs(y - fromY)) > SHORTEST_WALL;
        if (isLong && world.terrain().size() < MOST_PIECES) {
            world.terrain().addSegment(fromX, fromY, x, y, Stages.WALL_RADIUS, 0);
        }
    }

    /** Gives walls and the circles of kind 0 a surface, which those that are poured have, too. Belts stay. */
    void setSurface(float friction, float rollingResistance) {
        world.kind(0).setFriction(friction).setRollingResistance(rollingResistance);
        for (Wall wall : Wall.values()) {
            world.setWallSurface(wall, friction, rollingResistance, world.wallBeltSpeed(wall));
        }
    }

    float friction() {
        float own = world.kind(0).friction();
        return Float.isNaN(own) ? world.defaultFriction() : own;
    }

    float rollingResistance() {
        float own = world.kind(0).rollingResistance();
        return Float.isNaN(own) ? world.defaultRollingResistance() : own;
    }

    void step() {
        past.save(steps);
        if (pouring) {
            addSome();
        }
        if (grabbed != 0 && world.contains(grabbed)) {
            pull();
        }
        world.step(DT);
        steps++;
    }

    private void pull() {
        float dx = (x - world.x(grabbed)) * PULL;
        float dy = (y - world.y(grabbed)) * PULL;
        if (world.mass(grabbed) == Float.POSITIVE_INFINITY) {
            world.setPosition(grabbed, x, y);
        } else {
            world.setVelocity(grabbed, dx, dy);
        }
    }

    private void addSome() {
        for (int k = 0; k < POURED && world.size() < MOST_CIRCLES; k++) {
            float radius = 0.6f + 0.5f * random.nextFloat();
            float px = x + 8 * (random.nextFloat() - 0.5f);
            float py = y + 8 * (random.nextFloat() - 0.5f);
            boolean inside = px > radius && px < WIDTH - radius && py > radius && py < HEIGHT - radius;
            if (inside && world.queries().overlapCircle(px, py, radius, new long[0]) == 0) {
                world.add(px, py, radius, radius * radius, 0, -30);
            }
        }
    }

    /** Goes back by a step; does nothing if there is none. */
    void back() {
        if (past.has(steps - 1)) {
            steps--;
            past.restore(steps);
        }
    }
}
