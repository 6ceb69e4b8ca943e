package io.github.circles2d.bench.jmh;

import io.github.circles2d.Circles2D;
import io.github.circles2d.PairIndexing;
import io.github.circles2d.bench.Devices;
import io.github.circles2d.bench.engines.Motion;
import io.github.circles2d.bench.engines.ThesisEngine;
import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import java.util.Arrays;
import java.util.Map;
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
import org.openjdk.jmh.infra.BenchmarkParams;

/**
 * Ms a step of the thesis's engine by pair indexing on the thesis's scene: with read-back as the thesis timed it, on the
 * device alone, and with the profiling events that tell the kernels' times. An iteration starts the scene anew; its first
 * step, in which drivers still compile, does not count.
 */
@BenchmarkMode(Mode.SingleShotTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@OperationsPerInvocation(200)
@Warmup(iterations = 1)
@Measurement(iterations = 5)
@Fork(value = 1, jvmArgsAppend = "--enable-native-access=ALL-UNNAMED")
public class StrategyBenchmark {
    /** Reads all circles back after every step. */
    @Benchmark
    public void loop(Run run) {
        for (int step = 0; step < run.steps; step++) {
            run.circles = run.engine.loop();
        }
    }

    /** Enqueues the steps and waits for the device once, at the end. */
    @Benchmark
    public void deviceOnly(Run run) {
        for (int step = 0; step < run.steps; step++) {
            run.engine.step();
        }
        run.engine.finish();
    }

    /** As {@link #deviceOnly}, with an event for every kernel. */
    @Benchmark
    public void profiled(ProfiledRun run) {
        for (int step = 0; step < run.steps; step++) {
            run.engine.step();
        }
        run.engine.finish();
    }

    /** An engine with the thesis's scene in it. */
    @State(Scope.Thread)
    public static class Run {
        /** {@code best}, {@code cpu}, or a device's name. */
        @Param("best")
        public String device;

        /** How a slot finds its pair. */
        @Param({"COMPUTED", "LOOKUP_TABLE", "ROW_SEARCH", "EXACT"})
        public PairIndexing indexing;

        /** Number of circles. */
        @Param({"1250", "2500", "5000", "10000", "15000"})
        public int n;

        Circles2D engine;
        int steps;
        float[][] circles;
        private Scene scene;
        private Motion end;
        Map<String, Long> kernelNanosBefore;
        private long allocatedBefore;

        /** Opens the device. */
        @Setup(Level.Trial)
        public void open(BenchmarkParams params) {
            steps = params.getOpsPerInvocation();
            scene = Scenes.thesis(n, Scenes.SEED);
            end = new Motion(n);
            engine = new Circles2D(Devices.find(device), profiling());
        }

        boolean profiling() {
            return false;
        }

        /** Starts the scene and runs its first step. */
        @Setup(Level.Iteration)
        public void start() {
            ThesisEngine.init(engine, scene, indexing);
            engine.step();
            engine.finish();
            circles = null;
            kernelNanosBefore = engine.profileNanos();
            allocatedBefore = Usage.allocatedBytes();
        }

        /** Checks the end state and measures it. */
        @TearDown(Level.Iteration)
        public void check(Outcome outcome) {
            double allocated = Usage.allocatedBytes() - allocatedBefore;
            float[][] last = circles != null ? circles : engine.loop();
            if (!Arrays.equals(last[2], scene.radius()) || !Arrays.equals(last[3], scene.mass())) {
                throw new IllegalStateException("radii or masses have changed");
            }
            ThesisEngine.copy(last, engine.velocities(), end);
            // Over-full crowds push circles some radii out of the arena before it reflects them.
            // The thesis's walls reflect once; a scene that is over-full presses its circles out between them.
            end.requirePlausible(scene, 1f);
            outcome.set(end.quality(scene), allocated / steps);
        }

        /** Closes the device. */
        @TearDown(Level.Trial)
        public void close() {
            engine.close();
        }
    }

    /** A {@link Run} that has the driver time every kernel. */
    @State(Scope.Thread)
    public static class ProfiledRun extends Run {
        @Override
        boolean profiling() {
            return true;
        }

        /** Reads the kernels' times. */
        @TearDown(Level.Iteration)
        public void readProfile(KernelTimes times) {
            times.set(kernelNanosBefore, engine.profileNanos(), steps);
        }
    }
}
