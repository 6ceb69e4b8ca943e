package io.github.circles2d;

import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.function.Consumer;

/**
 * A world that lives on and on: circles come and go, change and crowd in one point, gravity turns, snapshots go into another
 * world, and now and then a new world takes the place of the old one. A control, on one thread of the JVM, is told the same,
 * and must have the same bits.
 */
final class SoakedWorld implements Soak.Soaked {
    private static final float EXTENT = 100;
    private static final int FEWEST = 300;
    private static final int MOST = 2_000;
    private static final float TIME_STEP = 1 / 60f;
    private static final int STEPS_BETWEEN_CHANGES = 7;
    private static final int CHANGES = 30;
    private static final int ROUNDS_OF_A_WORLD = 4;

    private final Backend backend;
    private final SplittableRandom random = new SplittableRandom(1);
    private final World control;
    private final World other;
    private World tested;
    private ByteBuffer snapshot = ByteBuffer.allocateDirect(0);
    private long rounds;
    private long steps;
    private long engines;

    SoakedWorld(Backend backend) {
        this.backend = backend;
        control = build(WorldScenes.jvm().threads(1));
        other = build(World.builder().backend(backend));
        tested = build(World.builder().backend(backend));
        engines = 3;
    }

    private static World build(World.Builder builder) {
        return builder.bounds(0, 0, EXTENT, EXTENT)
                .gravity(0, -10)
                .restitution(0.3f)
                .build();
    }

    @Override
    public void round() {
        for (int k = 0; k < CHANGES; k++) {
            change();
            control.requestPositions();
            tested.requestPositions();
            both(world -> world.step(TIME_STEP, STEPS_BETWEEN_CHANGES));
            steps += STEPS_BETWEEN_CHANGES;
            if (k % 2 == 0) {
                expectSame(control.takePositions(), tested.takePositions());
            } else {
                expectSame(control.takePositionsById(null), tested.takePositionsById(null));
            }
            expectSame(control, tested);
        }
        saveAndRestore();
        rounds++;
    }

    /** The snapshot goes into another world, which makes a step of its own, and sometimes into a new one. */
    private void saveAndRestore() {
        int bytes = tested.snapshotBytes();
        if (snapshot.capacity() < bytes) {
            snapshot = ByteBuffer.allocateDirect(2 * bytes);
        }
        tested.snapshot(snapshot.clear());
        snapshot.flip();
        other.restore(snapshot.duplicate());
        expectSame(control, other);
        other.step(TIME_STEP);
        if (rounds % ROUNDS_OF_A_WORLD == 0) {
            tested.close();
            tested = build(World.builder().backend(backend));
            engines++;
            tested.restore(snapshot.duplicate());
            expectSame(control, tested);
        }
    }

    private void change() {
        int n = control.size();
        if (n < FEWEST || n < MOST && random.nextInt(20) == 0) {
            addMany(200);
        }
        long[] handles = new long[control.size()];
        control.readHandles(handles);
        if (handles.length > MOST || handles.length > 2 * FEWEST && random.nextInt(20) == 0) {
            int first = random.nextInt(handles.length / 2);
            long[] leaving = Arrays.copyOfRange(handles, first, first + handles.length / 4);
            both(world -> world.removeAll(leaving, leaving.length, StaleHandles.REFUSE));
            handles = Arrays.copyOf(handles, first);
        }
        for (int k = 0; k < 8 && handles.length > 0; k++) {
            change(handles[random.nextInt(handles.length)]);
        }
        if (random.nextInt(100) == 0) {
            crowd(handles);
        }
        if (random.nextInt(40) == 0) {
            float x = value(0, EXTENT);
            float y = value(0, EXTENT);
            both(world -> world.explode(x, y, 2, 20, 5));
        }
        if (random.nextInt(40) == 0) {
            float angle = value(0, 7);
            float x = 10 * (float) StrictMath.sin(angle);
            float y = 10 * (float) StrictMath.cos(angle);
            both(world -> world.setGravity(x, y));
        }
    }

    private void change(long handle) {
        float a = value(0, 1);
        float b = value(0, 1);
        switch (random.nextInt(6)) {
            case 0 -> {
                // Now and then a boulder, for which World takes other ways than for circles that are alike.
                float radius = random.nextInt(200) == 0 ? 6 : 0.5f + 0.4f * a;
                both(world -> world.setRadius(handle, radius));
            }
            case 1 -> both(world -> world.setMass(handle, 0.5f + a));
            case 2 -> both(world -> world.setRestitution(handle, a));
            case 3 -> both(world -> world.applyImpulse(handle, 10 * (a - 0.5f), 10 * (b - 0.5f)));
            case 4 -> both(world -> world.setPosition(handle, EXTENT * a, EXTENT * b));
            default -> both(world -> world.setVelocity(handle, 40 * (a - 0.5f), 40 * (b - 0.5f)));
        }
    }

    private void addMany(int count) {
        float[] circles = new float[4 * count];
        for (int i = 0; i < count; i++) {
            circles[4 * i] = value(0, EXTENT);
            circles[4 * i + 1] = value(0, EXTENT);
            circles[4 * i + 2] = value(0.5f, 0.9f);
            circles[4 * i + 3] = value(0.5f, 1.5f);
        }
        both(world -> world.addAll(circles, null));
    }

    private void crowd(long[] handles) {
        float x = value(0, EXTENT);
        float y = value(0, EXTENT);
        for (int i = 0; i < Math.min(100, handles.length); i++) {
            long handle = handles[i];
            both(world -> world.setPosition(handle, x, y));
        }
    }

    private void both(Consumer<World> call) {
        call.accept(control);
        call.accept(tested);
    }

    private float value(float low, float high) {
        return low + (high - low) * (random.nextInt(1 << 24) * 0x1p-24f);
    }

    private void expectSame(World expected, World actual) {
        if (expected.hash() != actual.hash()) {
            throw new AssertionError("after " + steps + " steps the hash differs from that of the control");
        }
    }

    private void expectSame(FloatBuffer expected, FloatBuffer actual) {
        if (!expected.equals(actual)) {
            throw new AssertionError("after " + steps + " steps positions differ from those of the control");
        }
    }

    @Override
    public long steps() {
        return steps;
    }

    @Override
    public long engines() {
        return engines;
    }

    @Override
    public long bytes() {
        return tested.stats().bytesHeld() + other.stats().bytesHeld();
    }

    @Override
    public void close() {
        tested.close();
        other.close();
        control.close();
    }
}
