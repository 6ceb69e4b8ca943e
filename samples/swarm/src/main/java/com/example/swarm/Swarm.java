package com.example.swarm;

import io.github.circles2d.Backend;
import io.github.circles2d.Events;
import io.github.circles2d.Queries;
import io.github.circles2d.Rewind;
import io.github.circles2d.StaleHandles;
import io.github.circles2d.World;

/** The rules: 5,000 hunters chase the player. The score is the player's tag, so rewinding the world rewinds the whole game. */
final class Swarm implements Runnable {
    static final int WIDTH = 1280, HEIGHT = 800, MOST_CIRCLES = 6000; // a length of 1 is a pixel, and y points down
    static final int PLAYER = 0, SMALL = 1, LARGE = 2, BULLET = 3; // kinds
    private static final int[] POINTS = {-5, 1, 10, 0}; // for a hit, by kind
    private static final float[] BLASTS = {48, 4, 24, 4}; // radii of explosions, by kind
    private static final int HUNTERS = 0b10, HUNTER_COUNT = 5000; // a category, and how many

    final World world;
    final long player;
    float mouseX = WIDTH / 2f, mouseY = HEIGHT / 2f;
    boolean isBombWanted;
    private final Queries hunters;
    private final Rewind rewind;
    private final long[] handles = new long[MOST_CIRCLES];
    private final float[] forces = new float[2 * MOST_CIRCLES];
    private int step;

    Swarm(Backend backend) {
        World.Builder builder = World.builder().bounds(0, 0, WIDTH, HEIGHT).capacity(MOST_CIRCLES);
        world = builder.backend(backend).build();
        world.kind(PLAYER).setDamping(4);
        world.kind(BULLET).setMask(HUNTERS).setSensor(true).setGreatestSpeed(560);
        world.reportWalls(BULLET, Events.BEGIN);
        for (int hunter = SMALL; hunter <= LARGE; hunter++) {
            world.kind(hunter).setCategory(HUNTERS).setDamping(1).setGreatestSpeed(240);
            world.report(PLAYER, hunter, Events.BEGIN);
            world.report(BULLET, hunter, Events.BEGIN);
        }
        hunters = world.queries().withMask(HUNTERS);
        rewind = new Rewind(world, 300); // steps
        player = world.add(WIDTH / 2f, HEIGHT / 2f, 12, 20);
        float[] circles = new float[4 * HUNTER_COUNT];
        int[] kindOf = new int[HUNTER_COUNT];
        for (int k = 0; k < HUNTER_COUNT; k++) {
            kindOf[k] = k * 0.618034f % 1 < 0.02f ? LARGE : SMALL;
            circles[4 * k] = k * 0.75487767f % 1 * WIDTH; // spreads them evenly
            circles[4 * k + 1] = k * 0.56984029f % 1 * HEIGHT;
            circles[4 * k + 2] = kindOf[k] == LARGE ? 10 : 3.2f;
            circles[4 * k + 3] = 1; // mass
        }
        world.addAll(circles, null, kindOf, null);
        world.removeAll(handles, hunters.overlapCircle(WIDTH / 2f, HEIGHT / 2f, 180, handles), StaleHandles.REFUSE);
        rewind.save(0);
    }

    /** The hunter nearest to a point, or 0 if none is so near. */
    long nearest(float x, float y, float within) {
        return hunters.nearest(x, y, within, 1, handles, null) == 0 ? 0 : handles[0];
    }

    /** Goes back by a step, or stays at the oldest one. */
    void rewind() {
        step = Math.max(step - 1, rewind.oldest());
        rewind.restore(step);
    }

    /** Makes the changes before each step of the world. */
    @Override
    public void run() {
        Events events = world.events(); // taken before the step is saved, because a restored world has none
        for (int i = 0; i < events.size(); i++) {
            long a = events.a(i), b = events.b(i); // b is 0 for a wall
            if (world.contains(a) && (b == 0 || world.contains(b))) { // no event before this one has removed them
                hit(a);
                if (b != 0) {
                    hit(b);
                }
            }
        }
        rewind.save(step);
        movePlayer(world.x(player), world.y(player));
        moveHunters(world.x(player), world.y(player));
        step++;
    }

    private void hit(long circle) {
        int kind = world.kindOf(circle);
        world.explode(world.x(circle), world.y(circle), BLASTS[kind], 5 * BLASTS[kind], BLASTS[kind], HUNTERS);
        world.setTag(player, world.tag(player) + POINTS[kind]);
        if (kind != PLAYER) {
            world.remove(circle);
        }
    }

    private void movePlayer(float x, float y) {
        world.setForce(player, 100 * (mouseX - x), 100 * (mouseY - y));
        long near = nearest(x, y, 400), picked = nearest(mouseX, mouseY, 24);
        if (near != 0) { // the kind of bullets limits their speed
            world.add(x, y, 2.5f, 0.1f, 1000 * (world.x(near) - x), 1000 * (world.y(near) - y), BULLET);
        }
        if (isBombWanted && picked != 0) {
            world.explode(world.x(picked), world.y(picked), 80, 400, 80, HUNTERS);
            hit(picked);
        }
        isBombWanted = false;
    }

    /** All hunters speed up towards the player, and to its side. */
    private void moveHunters(float x, float y) {
        int count = hunters.overlapBox(0, 0, WIDTH, HEIGHT, handles);
        for (int k = 0; k < count; k++) {
            float dx = x - world.x(handles[k]), dy = y - world.y(handles[k]);
            forces[2 * k] = 0.4f * (dx - dy);
            forces[2 * k + 1] = 0.4f * (dy + dx);
        }
        world.setForces(handles, count, forces, StaleHandles.REFUSE);
    }
}
