package com.example.merge;

import io.github.circles2d.Backend;
import io.github.circles2d.Events;
import io.github.circles2d.World;
import java.util.Random;

/** The rules: balls drop, and two equal ones that touch merge into one of the next size. The size of a ball is its kind. */
final class Merge implements Runnable {
    static final float WIDTH = 10, HEIGHT = 14, DROP_HEIGHT = 12.5f;
    static final float LINE = 11; // no ball may stay above it
    static final float[] RADII = {0.35f, 0.48f, 0.62f, 0.76f, 0.93f, 1.12f, 1.33f, 1.56f, 1.82f, 2.1f, 2.4f}; // by kind
    private static final int DROPPED_KINDS = 5,
            STEPS_BETWEEN_DROPS = 36,
            MOST_STEPS_ABOVE_LINE = 120,
            GROWTH_STEPS = 45;
    private static final long[] COUNT_ONLY = {};

    final World world;
    float mouseX;
    boolean isDropWanted; // as soon as the next ball is ready
    int next, score; // the kind of the next ball, and points
    private final Random random;
    private int step, nextDrop, stepsAboveLine;

    Merge(Backend backend, long seed) {
        World.Builder builder = World.builder().bounds(0, 0, WIDTH, HEIGHT).gravity(0, -30);
        builder.subSteps(8).contactFrequency(134).greatestPushOutSpeed(2); // balls that grow hardly overlap others
        builder.friction(0.3f).rollingResistance(0.01f); // balls roll, and the first ones do not roll on for ever
        world = builder.restitution(0.2f).backend(backend).build();
        for (int kind = 0; kind < RADII.length; kind++) {
            world.report(kind, kind, Events.BEGIN);
        }
        random = new Random(seed);
        next = nextKind();
    }

    /** As nextInt(bound), which gives other numbers in a browser. */
    private int nextKind() {
        return (random.nextInt() >>> 1) % DROPPED_KINDS;
    }

    /** Where the next ball drops. */
    float dropX() {
        return Math.max(RADII[next], Math.min(WIDTH - RADII[next], mouseX));
    }

    boolean isReady() {
        return step >= nextDrop && !isOver();
    }

    boolean isOver() {
        return stepsAboveLine >= MOST_STEPS_ABOVE_LINE;
    }

    /** Makes the changes before each step of the world. */
    @Override
    public void run() {
        if (isOver()) {
            return;
        }
        Events events = world.events();
        for (int i = 0; i < events.size(); i++) {
            long a = events.a(i), b = events.b(i);
            if (world.contains(a)
                    && world.contains(b)
                    && world.kindOf(a) == world.kindOf(b)) { // neither has merged with a third
                merge(a, b);
            }
        }
        boolean isAboveLine = world.queries().overlapBox(0, LINE, WIDTH, HEIGHT, COUNT_ONLY) > 0;
        stepsAboveLine = isAboveLine ? stepsAboveLine + 1 : 0; // a ball that falls is soon below it
        if (isDropWanted && isReady()) {
            world.add(dropX(), DROP_HEIGHT, RADII[next], RADII[next] * RADII[next], 0, -5, next);
            next = nextKind();
            nextDrop = step + STEPS_BETWEEN_DROPS;
            isDropWanted = false;
        }
        step++;
    }

    /** The lower ball grows, and the other one goes: a ball that begins with the size that it has needs no room at once. */
    private void merge(long a, long b) {
        int kind = world.kindOf(a) + 1;
        score += kind * (kind + 1) / 2;
        long lower = world.y(a) <= world.y(b) ? a : b;
        world.remove(lower == a ? b : a);
        if (kind < RADII.length) {
            world.setKind(lower, kind);
            world.setMass(lower, RADII[kind] * RADII[kind]);
            world.grow(lower, RADII[kind], GROWTH_STEPS);
        } else { // two of the largest leave nothing
            world.remove(lower);
        }
    }

    /** A player without hands drops each ball onto an equal one if a ray finds one. */
    void playAlone() {
        float turns = step * 0.618034f;
        mouseX = (turns - (int) turns) * WIDTH; // not % 1, which is not the JVM's in a browser
        for (float x = 0.25f; x < WIDTH; x += 0.25f) {
            long below = world.queries().rayCast(x, DROP_HEIGHT, 0, -HEIGHT, null);
            mouseX = below != 0 && world.kindOf(below) == next ? x : mouseX;
        }
        isDropWanted = true;
    }
}
