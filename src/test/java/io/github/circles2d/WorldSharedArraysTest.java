package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.invoke.VarHandle;
import java.nio.ByteBuffer;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Another thread writes into what a world reads from. */
@Tag("each-jdk")
class WorldSharedArraysTest {
    private static final int CALLS = 60;
    private static final int CIRCLES = 10_000;

    /** JUnit makes an instance for each test. */
    private final long start = System.nanoTime();

    /** Runs calls while another thread makes a change and takes it back, again and again. */
    private static void during(Runnable change, Runnable back, Runnable calls) throws InterruptedException {
        Thread writer = new Thread(() -> {
            while (!Thread.currentThread().isInterrupted()) {
                change.run();
                pause();
                back.run();
                pause();
            }
        });
        writer.start();
        try {
            calls.run();
        } finally {
            writer.interrupt();
            writer.join();
        }
    }

    private static void pause() {
        VarHandle.fullFence(); // or the compiler leaves the change out
        for (int k = 0; k < 1000; k++) {
            Thread.onSpinWait();
        }
    }

    /** Whether to give up waiting for a call that meets the good values: on a busy machine the writer may sleep on a bad one. */
    private boolean isLate() {
        return System.nanoTime() - start > 60_000_000_000L;
    }

    private static World world() {
        return WorldScenes.jvm().bounds(0, 0, 10, 10).threads(1).build();
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void addAllTakesWhatItHasChecked(boolean inVelocities) throws InterruptedException {
        float[] circles = new float[4 * CIRCLES];
        float[] velocities = new float[2 * CIRCLES];
        for (int i = 0; i < CIRCLES; i++) {
            circles[4 * i] = 5;
            circles[4 * i + 1] = 5;
            circles[4 * i + 2] = 0.5f;
            circles[4 * i + 3] = 1;
        }
        float[] written = inVelocities ? velocities : circles;
        float good = written[written.length - 2];
        int last = written.length - 2;
        float[] read = new float[4 * CIRCLES];
        int[] accepted = new int[1];
        during(() -> written[last] = Float.NaN, () -> written[last] = good, () -> {
            for (int k = 0; k < CALLS || accepted[0] == 0 && !isLate(); k++) {
                try (World world = world()) {
                    world.addAll(circles, velocities, null);
                    accepted[0]++;
                    world.read(read);
                    assertFinite(read);
                    world.readVelocities(read);
                    assertFinite(read);
                } catch (IllegalArgumentException e) {
                    assertThat(e).hasMessageContaining("circle ");
                }
            }
        });
        assertThat(accepted[0]).isPositive();
    }

    @Test
    void bulkCallsTakeWhatTheyHaveChecked() throws InterruptedException {
        long[] handles = new long[CIRCLES];
        float[] values = new float[2 * CIRCLES];
        int[] kinds = new int[CIRCLES];
        float[] turning = new float[CIRCLES];
        float[] read = new float[4 * CIRCLES];
        int last = CIRCLES - 1;
        int[] accepted = new int[1];
        try (World world = world()) {
            for (int i = 0; i < CIRCLES; i++) {
                handles[i] = world.add(5, 5, 0.5f, 1);
            }
            long good = handles[last];
            Runnable change = () -> {
                handles[last] = 77;
                values[2 * last] = Float.NaN;
                kinds[last] = 256;
                turning[last] = Float.NaN;
            };
            Runnable back = () -> {
                handles[last] = good;
                values[2 * last] = 0;
                kinds[last] = 0;
                turning[last] = 0;
            };
            during(change, back, () -> {
                for (int k = 0; k < CALLS || accepted[0] == 0 && !isLate(); k++) {
                    try {
                        world.setVelocities(handles, CIRCLES, values, StaleHandles.REFUSE);
                        world.setPositions(handles, CIRCLES, values, StaleHandles.SKIP);
                        world.setForces(handles, CIRCLES, values, StaleHandles.SKIP);
                        world.setKinds(handles, CIRCLES, kinds, StaleHandles.SKIP);
                        world.setAngularVelocities(handles, CIRCLES, turning, StaleHandles.SKIP);
                        accepted[0]++;
                    } catch (IllegalArgumentException e) {
                        assertThat(e).hasMessageContaining(" " + last);
                    }
                    world.readVelocities(read);
                    assertFinite(read);
                    world.read(read);
                    assertFinite(read);
                    assertThat(world.kindOf(good)).isZero();
                    assertThat(world.angularVelocity(good)).isZero();
                    assertThat(world.forceX(good)).isZero();
                }
            });
            assertThat(accepted[0]).isPositive();
        }
    }

    @Test
    void addAllTakesTheKindsThatItHasChecked() throws InterruptedException {
        float[] circles = new float[4 * CIRCLES];
        for (int i = 0; i < circles.length; i++) {
            circles[i] = i % 4 < 2 ? 5 : 0.5f;
        }
        int[] kinds = new int[CIRCLES];
        int[] accepted = new int[1];
        during(() -> kinds[CIRCLES - 1] = 256, () -> kinds[CIRCLES - 1] = 0, () -> {
            for (int k = 0; k < CALLS || accepted[0] == 0 && !isLate(); k++) {
                try (World world = world()) {
                    world.addAll(circles, null, kinds, null);
                    accepted[0]++;
                    assertThat(world.kindOf(world.handle(CIRCLES - 1))).isZero();
                } catch (IllegalArgumentException e) {
                    assertThat(e).hasMessageContaining("circle " + (CIRCLES - 1));
                }
            }
        });
        assertThat(accepted[0]).isPositive();
    }

    private static void assertFinite(float[] values) {
        for (float value : values) {
            if (!Float.isFinite(value)) {
                assertThat(value).isFinite();
            }
        }
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void restoreTakesWhatItHasChecked(boolean direct) throws InterruptedException {
        try (World world = world();
                World target = world()) {
            for (int i = 0; i < 2000; i++) {
                world.add(5, 5, 0.01f, 1);
            }
            int length = world.snapshotBytes();
            ByteBuffer snapshot = direct ? ByteBuffer.allocateDirect(length) : ByteBuffer.allocate(length);
            world.snapshot(snapshot);
            snapshot.flip();
            byte first = snapshot.get(length - 4);
            ByteBuffer shared = snapshot.duplicate();
            Runnable change = () -> shared.put(length - 4, (byte) (first ^ 1));
            Runnable back = () -> shared.put(length - 4, first);
            int[] accepted = new int[1];
            during(change, back, () -> {
                for (int k = 0; k < CALLS || accepted[0] == 0 && !isLate(); k++) {
                    snapshot.rewind();
                    try {
                        target.restore(snapshot);
                    } catch (IllegalArgumentException e) {
                        assertThat(snapshot.position()).isZero();
                        continue;
                    }
                    accepted[0]++;
                    assertThat(target.hash()).isEqualTo(world.hash());
                }
            });
            assertThat(accepted[0]).isPositive();
        }
    }

    @Test
    void addAllOfOneRefusedCircleAddsNone() {
        try (World world = world()) {
            world.add(5, 5, 1, 1);
            long hash = world.hash();
            try {
                world.addAll(new float[] {1, 1, 0.5f, 1, 2, 2, Float.NaN, 1}, null);
            } catch (IllegalArgumentException e) {
                assertThat(e).hasMessageContaining("circle 1: ");
            }
            world.setVelocity(1L << 32, 0, 0);
            assertThat(world.size()).isOne();
            assertThat(world.hash()).isEqualTo(hash);
        }
    }
}
