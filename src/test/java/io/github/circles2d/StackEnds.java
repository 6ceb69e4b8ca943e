package io.github.circles2d;

import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.ConcurrentModificationException;
import java.util.List;
import java.util.function.Consumer;

/**
 * Calls a world at each of the last frames before the stack of its thread ends, and looks at it from another thread. It is to be
 * run in a JVM of its own, and prints what is wrong. A call that hangs ends the JVM with all stacks printed.
 */
final class StackEnds {
    /** More frames than any call needs. */
    private static final int FRAMES = 45;

    /** Offsets within a frame to try: so many frames of another size come first. */
    private static final int OFFSETS = 3;

    private static final int SECONDS = 60;
    private static final int CIRCLES = 40;
    private static final float STEP = 1 / 60f;

    private static final Chain CHAIN = Chain.of(9, 1, 5, 2, 1, 1).arcTo(1, 2, -1);

    private static int wrong;

    private StackEnds() {}

    /** A call, whether it may lose the state, and what it does to the world where it succeeds. */
    private record Call(String name, boolean mayLose, Consumer<World> action) {
        static Call change(String name, Consumer<World> action) {
            return new Call(name, true, action);
        }

        static Call read(String name, Consumer<World> action) {
            return new Call(name, false, action);
        }
    }

    /** Runs an action some frames before the stack ends. */
    private static final class Descent implements Runnable {
        private final Runnable action;
        private final int frames;
        private final int offset;
        private Throwable thrown;

        Descent(Runnable action, int frames, int offset) {
            this.action = action;
            this.frames = frames;
            this.offset = offset;
        }

        @Override
        public void run() {
            begin(offset, 0);
        }

        private int begin(int left, long wider) {
            return left == 0 ? down() : begin(left - 1, wider + 1);
        }

        /** Returns how many frames of this method fit behind the caller's. */
        private int down() {
            int behind;
            try {
                behind = down() + 1;
            } catch (StackOverflowError e) {
                behind = 0;
            }
            if (behind == frames) {
                try {
                    action.run();
                } catch (Throwable t) {
                    thrown = t;
                }
            }
            return behind;
        }
    }

    public static void main(String[] args) throws InterruptedException {
        watch();
        float[] circles = new float[4 * CIRCLES];
        float[] velocities = new float[2 * CIRCLES];
        long[] one = {1L << 32};
        int[] kind = {3};
        int[] kinds = new int[CIRCLES];
        ByteBuffer snapshot = ByteBuffer.allocate(1 << 16);
        List<Call> reads = List.of(
                Call.read("hash", World::hash),
                Call.read("read", world -> world.read(circles)),
                Call.read("readVelocities", world -> world.readVelocities(velocities)),
                Call.read("x", world -> world.x(1L << 32)),
                Call.read("angle", world -> world.angle(1L << 32)),
                Call.read("angles", World::angles),
                Call.read("positions", World::positions),
                Call.read("requestPositions", World::requestPositions),
                Call.read("readById", world -> world.readById(circles, null)),
                Call.read("readKindsById", world -> world.readKindsById(kinds, null)),
                Call.read("positionsById", world -> world.positionsById(null)),
                Call.read("snapshot", world -> world.snapshot(snapshot.clear())),
                Call.read("queries", world -> {
                    world.queries().overlapBox(0, 0, 9, 9, one.clone());
                    world.queries().withMask(1).nearest(new float[] {5, 5}, 1, 9, 1, one.clone(), null);
                    world.queries().rayCastAll(0, 0, 9, 9, one.clone(), null);
                }),
                Call.read("stats", World::stats));
        List<Call> changes = List.of(
                Call.change("add", world -> world.add(5, 8, 0.6f, 1)),
                Call.change("addAll", world -> world.addAll(new float[] {5, 8, 0.6f, 1}, null)),
                Call.change("addAll of kinds", world -> world.addAll(new float[] {5, 8, 0.6f, 1}, null, kind, null)),
                Call.change("remove", world -> world.remove(1L << 32)),
                Call.change("removeAll", world -> world.removeAll(one, 1, StaleHandles.SKIP)),
                Call.change("setVelocities", world -> world.setVelocities(one, 1, velocities, StaleHandles.SKIP)),
                Call.change("setForces", world -> world.setForces(one, 1, velocities, StaleHandles.SKIP)),
                Call.change("setKinds", world -> world.setKinds(one, 1, kind, StaleHandles.SKIP)),
                Call.change("setAngularVelocity", world -> world.setAngularVelocity(1L << 32, 3)),
                Call.change("setFriction", world -> world.setFriction(1L << 32, 0.5f)),
                Call.change("applyTorque", world -> world.applyTorque(1L << 32, 0.5f)),
                Call.change("setWallSurface", world -> world.setWallSurface(Wall.MIN_Y, 0.5f, 0, 1)),
                Call.change("explode", world -> world.explode(5, 5, 3, 1, 1)),
                Call.change("setRadius", world -> world.setRadius(1L << 32, 0.7f)),
                Call.change("grow", world -> world.grow(1L << 32, 0.7f, 3)),
                Call.change("addSegment", world -> world.terrain().addSegment(0, 2, 9, 1)),
                Call.change("addSegments", world -> world.terrain().addSegments(new float[] {0, 2, 9, 1}, 0, null)),
                Call.change("addArc", world -> world.terrain().addArc(5, 5, 4, -3, 0, ArcSide.INNER)),
                Call.change("addChain", world -> world.terrain().addChain(CHAIN)),
                Call.change("addBody", world -> world.terrain().addBody(3, 3, 1)),
                Call.change("a step of terrain", world -> {
                    world.terrain().addBody(3, 3, 1).setVelocity(1, 1);
                    world.terrain().addChain(CHAIN);
                    world.step(STEP);
                }),
                Call.change("joints", world -> {
                    world.joints().report(true);
                    world.joints().add(1L << 32, 1L << 32 | 9, Joint.spring(3, 1));
                    world.joints().add(1L << 32, Joint.friction(1, 1).breakingAt(0, 0));
                    world.joints().addAll(one, new long[] {1L << 32 | 2}, Joint.weld(), null);
                    world.step(STEP);
                    world.joints().events();
                }),
                Call.change("clear", World::clear),
                Call.change("setBounds", world -> world.setBounds(0, 0, 9, 9)),
                Call.change("restore", world -> world.restore(snapshot.duplicate())));
        Call step = Call.change("step", world -> world.step(STEP, 2));
        for (int threads : new int[] {1, 2, 4}) {
            for (int k = 0; k < FRAMES * OFFSETS; k++) {
                check(step, threads, k / OFFSETS, k % OFFSETS);
            }
        }
        for (Call read : reads) {
            for (int frames = 0; frames < FRAMES; frames += 3) {
                check(read, 1, frames, 0);
            }
        }
        try (World world = world(1)) {
            world.step(STEP);
            world.snapshot(snapshot.clear());
            snapshot.flip();
        }
        for (Call change : changes) {
            for (int frames = 0; frames < FRAMES; frames += 3) {
                check(change, 1, frames, 0);
            }
        }
        System.out.println(wrong + " wrong");
    }

    private static void watch() {
        Thread watch = new Thread(() -> {
            try {
                Thread.sleep(1000L * SECONDS);
            } catch (InterruptedException e) {
                return;
            }
            Thread.getAllStackTraces().forEach((thread, trace) -> System.out.println(thread + Arrays.toString(trace)));
            System.out.println("hangs");
            Runtime.getRuntime().halt(1);
        });
        watch.setDaemon(true);
        watch.start();
    }

    private static World world(int threads) {
        World.Builder builder = World.builder().bounds(0, 0, 10, 10).gravity(0, -9);
        World world = WorldScenes.onThreads(threads, builder);
        for (int i = 0; i < CIRCLES; i++) {
            world.add(1 + i % 8, 1 + i / 8, 0.6f, 1);
        }
        world.step(STEP, 2);
        return world;
    }

    private static void check(Call call, int threads, int frames, int offset) throws InterruptedException {
        World world = world(threads);
        try (World same = world(1)) {
            Descent descent = new Descent(() -> call.action.accept(world), frames, offset);
            Thread deep = new Thread(null, descent, "deep", 256 << 10);
            deep.start();
            deep.join();
            String where = call.name + " on " + threads + " threads, " + frames + " frames before the end: ";
            if (descent.thrown != null && !(descent.thrown instanceof StackOverflowError)) {
                report(where + "threw " + descent.thrown);
            }
            if (descent.thrown == null) {
                call.action.accept(same);
            }
            try {
                same.step(STEP);
                world.step(STEP);
                if (world.hash() != same.hash()) {
                    report(where + "another state");
                }
            } catch (IllegalStateException e) {
                if (descent.thrown == null || !call.mayLose) {
                    report(where + e);
                }
            } catch (ConcurrentModificationException e) {
                report(where + e);
            }
        }
        world.close();
    }

    private static void report(String what) {
        if (wrong++ < 20) {
            System.out.println(what);
        }
    }
}
