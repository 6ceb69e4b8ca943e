package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.management.ThreadMXBean;
import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import java.lang.management.ManagementFactory;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.FloatBuffer;
import java.nio.LongBuffer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A game that runs leaves no garbage. */
class WorldAllocationTest {
    private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();

    @ParameterizedTest
    @ValueSource(ints = {1, 3})
    void stepsAndReadsAllocateNothingOnTheJvm(int threads) {
        Scene scene = Scenes.thesis(1250, Scenes.SEED);
        int n = scene.size();
        float[] circles = new float[4 * n];
        float[] velocities = new float[2 * n];
        long[] handles = new long[n];
        FloatBuffer circleBuffer =
                ByteBuffer.allocateDirect(16 * n).order(ByteOrder.nativeOrder()).asFloatBuffer();
        FloatBuffer velocityBuffer = FloatBuffer.allocate(2 * n);
        LongBuffer handleBuffer = LongBuffer.allocate(n);
        World empty = WorldScenes.onThreads(threads, true, WorldScenes.builder(scene));
        try (World world = WorldScenes.load(scene, empty)) {
            world.report(Events.BEGIN | Events.HIT | Events.END | Events.WALL);
            Runnable frame = () -> {
                world.readHandles(handles);
                world.setVelocity(handles[7], 0.01f, 0);
                world.applyImpulse(handles[8], 0.01f, 0);
                world.setTag(handles[9], world.tag(handles[9]) + 1);
                world.step(scene.timeStep());
                world.step(scene.timeStep(), 2);
                world.read(circles);
                world.readVelocities(velocities);
                world.read(circleBuffer.clear());
                world.readVelocities(velocityBuffer.clear());
                world.readHandles(handleBuffer.clear());
                consume(world.positions().get(5));
                world.requestPositions();
                world.step(scene.timeStep());
                consume(world.takePositions().get(5));
                Events events = world.events();
                for (int i = 0; i < events.size(); i++) {
                    consume(events.type(i) + events.speed(i) + events.x(i));
                    consume(events.side(i) == Events.Side.LEFT ? 1 : 0);
                }
                consume(world.x(handles[3]) + world.vy(handles[4]) + world.hash() + world.size());
            };
            for (int k = 0; k < 200; k++) { // the list of contacts grows to its greatest length, and compilers settle
                frame.run();
            }
            // the virtual machine may still leave some hundred bytes now and then; what a frame leaves, every frame
            // does
            long least = Long.MAX_VALUE;
            for (int k = 0; k < 10 && least != 0; k++) {
                least = Math.min(least, allocatedBy(frame, 50));
            }
            assertThat(least).isZero();
        }
    }

    @Test
    void theMeasurementSeesWhatIsAllocated() {
        byte[][] own = new byte[1][];
        assertThat(allocatedBy(() -> own[0] = new byte[100_000], 10)).isGreaterThanOrEqualTo(1_000_000);
    }

    private static volatile double sink;

    private static void consume(double value) {
        sink = value;
    }

    /**
     * Bytes that the threads which live throughout, but those of the test's runner, allocate in some runs, without those for
     * measuring.
     */
    private static long allocatedBy(Runnable action, int runs) {
        long[] ids = Thread.getAllStackTraces().keySet().stream()
                .filter(thread -> !thread.getName().startsWith("surefire"))
                .mapToLong(Thread::getId)
                .toArray();
        long[] start = new long[ids.length];
        long[] before = new long[ids.length];
        long[] after = new long[ids.length];
        measure(ids, after);
        measure(ids, start);
        measure(ids, before);
        for (int k = 0; k < runs; k++) {
            action.run();
        }
        measure(ids, after);
        long sum = 0;
        for (int k = 0; k < ids.length; k++) {
            boolean lives = after[k] >= 0; // -1 of a thread that has ended
            sum += lives ? after[k] - before[k] - (before[k] - start[k]) : 0;
        }
        return sum;
    }

    private static void measure(long[] ids, long[] bytes) {
        for (int k = 0; k < ids.length; k++) {
            bytes[k] = THREADS.getThreadAllocatedBytes(ids[k]);
        }
    }
}
