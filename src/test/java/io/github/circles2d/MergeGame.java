package io.github.circles2d;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;

/** The rules of the sample game Merge, which plays by itself: balls drop into a box, and two equal ones become the next size. */
final class MergeGame implements AutoCloseable {
    static final float WIDTH = 10;
    static final float HEIGHT = 14;
    static final float[] RADII = {0.35f, 0.48f, 0.62f, 0.76f, 0.93f, 1.12f, 1.33f, 1.56f, 1.82f, 2.1f, 2.4f};
    private static final float LINE = 11;
    private static final float DROP_HEIGHT = 12.5f;
    private static final int STEPS_BETWEEN_DROPS = 36;

    /** How two balls become one. */
    interface Merging {
        /** Merges two balls into one of a kind, and returns that. */
        long merge(World world, long a, long b, int kind);
    }

    /** The newcomer takes their place at once, with its whole size. */
    static final Merging AT_ONCE = (world, a, b, kind) -> {
        float x = (world.x(a) + world.x(b)) / 2;
        float y = (world.y(a) + world.y(b)) / 2;
        float vx = (world.vx(a) + world.vx(b)) / 2;
        float vy = (world.vy(a) + world.vy(b)) / 2;
        world.remove(a);
        world.remove(b);
        return world.add(x, y, RADII[kind], RADII[kind] * RADII[kind], vx, vy, kind);
    };

    /** The lower one stays and grows, as {@link World#grow} recommends. */
    static final Merging BY_GROWTH = (world, a, b, kind) -> {
        long lower = world.y(a) <= world.y(b) ? a : b;
        world.remove(lower == a ? b : a);
        world.setKind(lower, kind);
        world.setMass(lower, RADII[kind] * RADII[kind]);
        world.grow(lower, RADII[kind], 45);
        return lower;
    };

    final World world;
    private final Merging merging;
    private final Random random;
    private int next;
    private int frame;
    private int stepsAboveLine;

    /** By handle of a ball that others merged into: the frame in which they did. */
    private final Map<Long, Integer> born = new HashMap<>();

    int merges;

    MergeGame(World.Builder builder, Merging merging, long seed) {
        world = builder.bounds(0, 0, WIDTH, HEIGHT)
                .gravity(0, -30)
                .restitution(0.2f)
                .build();
        for (int kind = 0; kind < RADII.length; kind++) {
            world.report(kind, kind, Events.BEGIN);
        }
        this.merging = merging;
        random = new Random(seed);
        next = random.nextInt(5);
    }

    /** Makes the changes of a frame, and its step. A box that is full is cleared. */
    void play() {
        Events events = world.events();
        for (int i = 0; i < events.size(); i++) {
            long a = events.a(i);
            long b = events.b(i);
            if (world.contains(a) && world.contains(b) && world.kindOf(a) == world.kindOf(b)) {
                merge(a, b);
            }
        }
        stepsAboveLine = world.queries().overlapBox(0, LINE, WIDTH, HEIGHT, new long[0]) > 0 ? stepsAboveLine + 1 : 0;
        if (stepsAboveLine >= 120) {
            world.clear();
            stepsAboveLine = 0;
        }
        if (frame % STEPS_BETWEEN_DROPS == 0) {
            world.add(dropX(), DROP_HEIGHT, RADII[next], RADII[next] * RADII[next], 0, -5, next);
            next = random.nextInt(5);
        }
        world.step(1 / 60f);
        frame++;
    }

    private void merge(long a, long b) {
        int kind = world.kindOf(a) + 1;
        if (kind < RADII.length) {
            born.put(merging.merge(world, a, b, kind), frame);
            merges++;
        } else {
            world.remove(a);
            world.remove(b);
        }
    }

    private float dropX() {
        float dropX = frame * 0.618034f % 1 * WIDTH;
        for (float x = 0.25f; x < WIDTH; x += 0.25f) {
            long below = world.queries().rayCast(x, DROP_HEIGHT, 0, -HEIGHT, null);
            dropX = below != 0 && world.kindOf(below) == next ? x : dropX;
        }
        return Math.max(RADII[next], Math.min(WIDTH - RADII[next], dropX));
    }

    /** The ids of balls that others merged into in the last frames. */
    List<Integer> newcomers(int frames) {
        born.keySet().removeIf(handle -> !world.contains(handle));
        List<Integer> ids = new ArrayList<>();
        born.forEach((handle, since) -> {
            if (frame - since <= frames) {
                ids.add(World.id(handle));
            }
        });
        return ids;
    }

    /** How deep others are in the newcomers of the last frames, in radii of the newcomer. */
    float deepestOverlap(int frames) {
        float[] circles = new float[4 * world.idLimit()];
        world.readById(circles, null);
        float deepest = 0;
        for (int id : newcomers(frames)) {
            for (int other = 0; other < world.idLimit(); other++) {
                if (other != id && world.handle(other) != 0) {
                    float depth = -WorldMergeTest.gap(circles, id, other) / circles[4 * id + 2];
                    deepest = Math.max(deepest, depth);
                }
            }
        }
        return deepest;
    }

    @Override
    public void close() {
        world.close();
    }
}
