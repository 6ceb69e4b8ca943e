package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.management.ThreadMXBean;
import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.OnEachDevice;
import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import java.lang.management.ManagementFactory;
import java.nio.ByteBuffer;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Circles that come and go in great numbers while no step is made. */
@Tag("each-jdk")
class WorldChurnTest {
    private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    private static final int PAIRS = 1_000_000;
    private static final int LIVING = 40;
    private static final Scene SCENE = Scenes.thesis(200, Scenes.SEED);

    private static World world(World.Builder builder) {
        World world = WorldScenes.world(SCENE, builder);
        world.step(SCENE.timeStep(), 5);
        return world;
    }

    private static World.Builder builder() {
        return WorldScenes.builder(SCENE).threads(1);
    }

    /** Makes pairs of an add and a remove, of circles in no order; some were there when the last step was made. */
    private static void churn(World world, int pairs, long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        long[] some = new long[LIVING];
        long[] handles = new long[world.size()];
        world.readHandles(handles);
        System.arraycopy(handles, handles.length - LIVING, some, 0, LIVING);
        for (int k = 0; k < pairs; k++) {
            int which = random.nextInt(LIVING);
            world.remove(some[which]);
            some[which] = world.add((float) random.nextDouble(), (float) random.nextDouble(), 0.02f, 1);
        }
    }

    private static void assertSame(World world, World jvm) {
        assertThat(world.hash()).isEqualTo(jvm.hash());
        float[] circles = new float[4 * world.size()];
        float[] expected = new float[4 * jvm.size()];
        world.read(circles);
        jvm.read(expected);
        assertThat(circles).isEqualTo(expected);
        world.step(SCENE.timeStep(), 10);
        jvm.step(SCENE.timeStep(), 10);
        assertThat(world.hash()).isEqualTo(jvm.hash());
    }

    @Test
    void aMillionCirclesThatComeAndGoBetweenStepsNeedNoMoreMemoryOnTheJvm() {
        try (World world = world(builder())) {
            churn(world, PAIRS / 4, 1);
            long held = world.stats().bytesHeld();
            long before = THREADS.getCurrentThreadAllocatedBytes();
            churn(world, PAIRS, 2);
            assertThat(THREADS.getCurrentThreadAllocatedBytes() - before).isLessThan(1 << 20);
            assertThat(world.stats().bytesHeld()).isEqualTo(held);
            assertThat(world.size()).isEqualTo(SCENE.size());
        }
    }

    @OnEachDevice
    void aMillionCirclesThatComeAndGoBetweenStepsNeedNoMoreMemoryOnADeviceAndLeaveTheSameWorld(Device device) {
        try (World world = world(builder().device(device));
                World jvm = world(builder())) {
            churn(world, PAIRS / 4, 1);
            long held = world.stats().bytesHeld();
            assertThat(held).isLessThan(32 << 20);
            churn(world, PAIRS, 2);
            assertThat(world.stats().bytesHeld()).isEqualTo(held);
            churn(jvm, PAIRS / 4, 1);
            churn(jvm, PAIRS, 2);
            assertSame(world, jvm);
        }
    }

    @OnEachDevice
    void placesOfCirclesThatWentAreTakenAgainWhateverHappensBetween(Device device) {
        try (World world = world(builder().device(device));
                World jvm = world(builder())) {
            List<World> worlds = List.of(world, jvm);
            for (int k = 0; k < 20; k++) {
                for (World each : worlds) {
                    churn(each, 25, k);
                    each.hash();
                    if (k % 3 == 0) {
                        each.step(SCENE.timeStep());
                    }
                    if (k % 4 == 0) {
                        restoreItself(each);
                    }
                    churn(each, 25, 100 + k);
                    if (k % 5 == 4) {
                        empty(each);
                    }
                }
                assertSame(world, jvm);
            }
        }
    }

    private static void restoreItself(World world) {
        ByteBuffer snapshot = ByteBuffer.allocate(world.snapshotBytes());
        world.snapshot(snapshot);
        churn(world, 25, 7);
        world.hash();
        world.restore(snapshot.flip());
    }

    /** Removes all, makes a step of nothing, and adds as many anew. */
    private static void empty(World world) {
        long[] handles = new long[world.size()];
        float[] circles = new float[4 * world.size()];
        world.read(circles);
        world.readHandles(handles);
        for (long handle : handles) {
            world.remove(handle);
        }
        world.step(SCENE.timeStep());
        world.addAll(circles, null);
    }
}
