package io.github.circles2d;

import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Consumer;

/**
 * Calls worlds while the heap is full but for some bytes. It is to be run in a JVM of its own with a small heap, and prints what
 * is wrong, and how many calls found too little memory.
 */
final class MemoryEnds {
    private static final int CIRCLES = 1500;
    private static final float STEP = 1 / 60f;
    private static final int[] SPARES = {0, 20_000, 150_000};

    private static final byte[][] BALLAST = new byte[1 << 15][];

    private static int wrong;
    private static int outOfMemory;

    private MemoryEnds() {}

    public static void main(String[] args) {
        float[] more = circles(2 * CIRCLES);
        ByteBuffer larger = snapshotOf(2 * CIRCLES);
        ByteBuffer room = ByteBuffer.allocate(larger.limit());
        Map<String, Consumer<World>> calls = new TreeMap<>(Map.of(
                "hash after addAll",
                        world -> {
                            world.addAll(more, null);
                            world.hash();
                        },
                "addAll", world -> world.addAll(more, null),
                "restore", world -> world.restore(larger.rewind()),
                "snapshot", world -> world.snapshot(room.clear()),
                "x", world -> world.x(1L << 32),
                "vx", world -> world.vx(1L << 32),
                "positions", World::positions,
                "explode", world -> world.explode(50, 10, 20, 1, 20),
                "requested positions",
                        world -> {
                            world.requestPositions();
                            world.takePositions();
                        },
                "stats", World::stats));
        calls.put("clear", World::clear);
        calls.put("setAngle", world -> {
            world.setAngle(1L << 32, 1);
            world.hash();
        });
        calls.put("a step in which circles begin to grip", world -> {
            world.kind(0).setFriction(0.5f);
            world.step(STEP);
        });
        calls.put("angle", world -> world.angle(1L << 32));
        calls.put("a step in which circles grow", world -> {
            for (int id = 0; id < CIRCLES; id += 2) {
                world.grow(1L << 32 | id, 0.6f, 3);
            }
            world.step(STEP);
        });
        float[] segments = circles(500); // from the centre of each circle to the right
        for (int k = 0; k < segments.length; k += 4) {
            segments[k + 2] = segments[k] + 1;
            segments[k + 3] = segments[k + 1];
        }
        calls.put("addSegments", world -> world.terrain().addSegments(segments, 0, null));
        calls.put("snapshotBytes with terrain", world -> {
            if (world.terrain().size() == 0) {
                world.terrain().addSegments(segments, 0, null);
            }
            world.snapshotBytes();
        });
        float[] pieces = new float[Terrain.PIECE_STRIDE * 500];
        calls.put("readPieces", world -> {
            if (world.terrain().size() == 0) {
                world.terrain().addSegments(segments, 0, null);
            }
            world.terrain().readPieces(pieces, null);
        });
        long[] firsts = new long[CIRCLES - 1];
        long[] others = new long[CIRCLES - 1];
        for (int k = 0; k < firsts.length; k++) {
            firsts[k] = 1L << 32 | k;
            others[k] = 1L << 32 | k + 1;
        }
        Joint spring = Joint.spring(3, 1).withLength(1);
        calls.put("addAll of joints", world -> world.joints().addAll(firsts, others, spring, null));
        calls.put("a step of joints", world -> {
            if (world.joints().size() == 0) {
                world.joints().addAll(firsts, others, spring, null);
            }
            world.step(STEP);
        });
        Joint weak = Joint.distance(5).breakingAt(0, 0);
        calls.put("joints that break", world -> {
            if (world.joints().size() == 0 && world.joints().idLimit() == 0) {
                world.joints().report(true);
                world.joints().addAll(firsts, others, weak, null);
                world.step(STEP);
            }
            world.joints().size();
        });
        calls.put("a circle with joints goes", world -> {
            if (world.joints().size() == 0 && world.contains(1L << 32)) {
                world.joints().report(true);
                world.joints().addAll(firsts, others, spring, null);
            }
            world.clear();
        });
        float[] ends = new float[4 * CIRCLES];
        calls.put("readEnds", world -> {
            if (world.joints().size() == 0) {
                world.joints().addAll(firsts, others, spring, null);
            }
            world.joints().readEnds(ends);
            world.joints().force(world.joints().handle(0));
        });
        calls.put("jointEnds", world -> {
            if (world.joints().size() == 0) {
                world.joints().addAll(firsts, others, spring, null);
            }
            new FixedStep(world, STEP).jointEnds(ends, null);
        });
        calls.put("queries", world -> world.queries().overlapBox(0, 0, 100, 100, new long[0]));
        calls.forEach((name, call) -> {
            for (int spare : SPARES) {
                check(name + " with " + spare + " bytes", call, spare);
            }
        });
        System.out.println(wrong + " wrong, out of memory " + (outOfMemory >= SPARES.length ? "often" : "seldom"));
    }

    private static float[] circles(int count) {
        float[] circles = new float[4 * count];
        for (int i = 0; i < count; i++) {
            circles[4 * i] = 1 + i % 90;
            circles[4 * i + 1] = 1 + i / 90;
            circles[4 * i + 2] = 0.55f;
            circles[4 * i + 3] = 1;
        }
        return circles;
    }

    private static World world(int count) {
        World world = WorldScenes.jvm()
                .bounds(0, 0, 100, 100)
                .gravity(0, -9)
                .threads(1)
                .build();
        world.addAll(circles(count), null);
        world.step(STEP);
        return world;
    }

    private static ByteBuffer snapshotOf(int count) {
        try (World world = world(count)) {
            ByteBuffer snapshot = ByteBuffer.allocate(world.snapshotBytes());
            world.snapshot(snapshot);
            return snapshot.flip();
        }
    }

    /** Where memory runs out, the world is as before, except that a call of two may have made the first. */
    private static void check(String name, Consumer<World> call, int spare) {
        try (World world = world(CIRCLES);
                World same = world(CIRCLES)) {
            boolean thrown = false;
            byte[] spared = new byte[spare];
            fill();
            spared = null;
            try {
                call.accept(world);
            } catch (OutOfMemoryError e) {
                thrown = true;
            }
            empty();
            outOfMemory += thrown ? 1 : 0;
            try {
                if (!thrown || world.size() > CIRCLES) {
                    call.accept(same);
                }
                if (thrown && world.size() == CIRCLES) {
                    call.accept(world);
                    call.accept(same);
                }
                for (World each : List.of(world, same)) {
                    each.step(STEP);
                }
                if (world.hash() != same.hash()) {
                    report(name + ": another state");
                }
            } catch (RuntimeException e) {
                report(name + ": " + e);
            }
        }
    }

    private static void fill() {
        int count = 0;
        for (int bytes = 1 << 20; bytes >= 1 << 9; bytes >>= 3) {
            try {
                while (true) {
                    BALLAST[count] = new byte[bytes];
                    count++;
                }
            } catch (OutOfMemoryError e) {
                // smaller pieces next
            }
        }
    }

    private static void empty() {
        Arrays.fill(BALLAST, null);
    }

    private static void report(String what) {
        wrong++;
        System.out.println(what);
    }
}
