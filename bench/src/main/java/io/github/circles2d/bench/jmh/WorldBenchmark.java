package io.github.circles2d.bench.jmh;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.FloatBuffer;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;

/** Ms a step of World by back end and size: alone, with read-back, by stage, and with circles that come and go. */
@BenchmarkMode(Mode.SingleShotTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@OperationsPerInvocation(100)
@Warmup(iterations = 1)
@Measurement(iterations = 5)
@Fork(value = 1, jvmArgsAppend = "--enable-native-access=ALL-UNNAMED")
public class WorldBenchmark {
    /** Asks for all steps in one call, and waits for the last. */
    @Benchmark
    public void steps(WorldRun run) {
        run.world.step(run.timeStep, run.steps);
        run.world.finish();
    }

    /** Asks for one step a call, as a game does that draws on the device; waits for the last. */
    @Benchmark
    public void frames(WorldRun run) {
        for (int step = 0; step < run.steps; step++) {
            run.world.step(run.timeStep);
        }
        run.world.finish();
    }

    /** Reads all circles into an array after every step. */
    @Benchmark
    public void readArray(ReadRun run) {
        for (int step = 0; step < run.steps; step++) {
            run.world.step(run.timeStep);
            run.world.read(run.array);
        }
    }

    /** Reads all circles into a buffer outside the Java heap after every step. */
    @Benchmark
    public void readBuffer(ReadRun run) {
        for (int step = 0; step < run.steps; step++) {
            run.world.step(run.timeStep);
            run.world.read(run.buffer.clear());
        }
    }

    /** Looks at the positions of all circles, in the memory that World lends, after every step. */
    @Benchmark
    public void readPositions(LookRun run) {
        for (int step = 0; step < run.steps; step++) {
            run.world.step(run.timeStep);
            run.positions = run.world.positions();
        }
    }

    /** Requests the positions of all circles after every step, and takes them once the next step has been asked for. */
    @Benchmark
    public void requestPositions(LookRun run) {
        for (int step = 0; step < run.steps; step++) {
            run.world.step(run.timeStep);
            if (step > 0) {
                run.positions = run.world.takePositions();
            }
            run.world.requestPositions();
        }
        run.positions = run.world.takePositions();
    }

    /** As {@link #steps}, with an event for every kernel. */
    @Benchmark
    public void profiled(ProfiledRun run) {
        run.world.step(run.timeStep, run.steps);
        run.world.finish();
    }

    /** Removes some circles and adds as many elsewhere before every step. */
    @Benchmark
    public void storm(StormRun run) {
        for (int step = 0; step < run.steps; step++) {
            run.replaceSome();
            run.world.step(run.timeStep);
        }
        run.world.finish();
    }

    /** A {@link WorldRun} with memory that the circles are read into. */
    @State(Scope.Thread)
    public static class ReadRun extends WorldRun {
        float[] array;
        FloatBuffer buffer;

        /** Allocates both, so that every page is there. */
        @Setup(Level.Trial)
        public void allocate() {
            array = new float[4 * n];
            buffer = ByteBuffer.allocateDirect(16 * n)
                    .order(ByteOrder.nativeOrder())
                    .asFloatBuffer();
        }

        /** Checks that what was read last is what the world reads now. */
        @TearDown(Level.Iteration)
        public void compare() {
            float[] now = new float[4 * n];
            world.read(now);
            if (!FloatBuffer.wrap(now).equals(FloatBuffer.wrap(array))
                    && !FloatBuffer.wrap(now).equals(buffer.rewind())) {
                throw new IllegalStateException("what was read after the last step is not what is there");
            }
        }
    }

    /** A {@link WorldRun} whose positions are looked at. */
    @State(Scope.Thread)
    public static class LookRun extends WorldRun {
        FloatBuffer positions;

        /** Checks that what was seen last is what the world reads now. */
        @TearDown(Level.Iteration)
        public void compare() {
            float[] now = new float[4 * n];
            world.read(now);
            for (int i = 0; i < n; i++) {
                if (positions.get(2 * i) != now[4 * i] || positions.get(2 * i + 1) != now[4 * i + 1]) {
                    throw new IllegalStateException("the positions seen after the last step are not what is there");
                }
            }
        }
    }

    /** A {@link WorldRun} that measures its stages. */
    @State(Scope.Thread)
    public static class ProfiledRun extends WorldRun {
        @Override
        boolean profiling() {
            return true;
        }

        /** Reads the stages' times. */
        @TearDown(Level.Iteration)
        public void readProfile(StageTimes times) {
            readStages(times);
        }
    }

    /** A {@link WorldRun} in which circles come and go. */
    @State(Scope.Thread)
    public static class StormRun extends WorldRun {
        private static final long SEED = 2014;

        /** Circles replaced before each step, percent. */
        @Param({"1", "10"})
        public int percent;

        private long[] handles;
        private Random random;
        private int replaced;
        private float scale;

        /** Starts the same storm anew. */
        @Setup(Level.Iteration)
        public void begin() {
            handles = null;
            random = new Random(SEED);
            replaced = Math.max(1, n * percent / 100);
            scale = (float) Math.sqrt(1250.0 / n);
        }

        void replaceSome() {
            if (handles == null) {
                handles = new long[n];
                world.readHandles(handles);
            }
            for (int k = 0; k < replaced; k++) {
                int which = random.nextInt(n);
                world.remove(handles[which]);
                handles[which] = world.add(
                        0.1f + 0.8f * random.nextFloat(),
                        0.1f + 0.8f * random.nextFloat(),
                        scale * (0.01f + 0.005f * random.nextFloat()),
                        1 + 9 * random.nextFloat());
            }
        }
    }
}
