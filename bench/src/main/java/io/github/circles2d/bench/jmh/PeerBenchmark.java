package io.github.circles2d.bench.jmh;

import io.github.circles2d.bench.engines.Engine;
import io.github.circles2d.bench.engines.Engines;
import io.github.circles2d.bench.engines.Motion;
import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
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
 * Ms a step of the engines on the same scenes. An iteration loads the scene, runs some steps that do not count (the crowd
 * starts with overlaps that no engine meets in use), then the steps that do, and measures the quality.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.SingleShotTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@OperationsPerInvocation(500)
@Warmup(iterations = 1)
@Measurement(iterations = 4)
@Fork(value = 1, jvmArgsAppend = "--enable-native-access=ALL-UNNAMED")
public class PeerBenchmark {
    /** A name out of {@link Engines}. */
    @Param({"java-all-pairs", "gdx-box2d", "jbox2d", "dyn4j", "circles2d-lookup-table", "circles2d-exact"})
    public String engine;

    /** {@code packed} or {@code thesis}. */
    @Param({"packed", "thesis"})
    public String scene;

    /** Number of circles. */
    @Param({"1250", "2500", "5000"})
    public int n;

    /** Steps before the measured ones. */
    @Param("100")
    public int skipped;

    private Engine running;
    private Scene start;
    private Motion end;
    private int steps;
    private long allocatedBefore;
    private long allocatedAfter;
    private Long firstHash;

    /** Starts the engine. */
    @Setup(Level.Trial)
    public void open(BenchmarkParams params) {
        steps = params.getOpsPerInvocation();
        start = scene.equals("thesis") ? Scenes.thesis(n, Scenes.SEED) : Scenes.packed(n, Scenes.SEED);
        end = new Motion(n);
        running = Engines.create(engine);
    }

    /** Brings the crowd to where the measurement starts. */
    @Setup(Level.Iteration)
    public void load() {
        running.load(start);
        for (int step = 0; step < skipped; step++) {
            running.step();
        }
        running.finish();
        allocatedBefore = Usage.allocatedBytes();
    }

    /** Runs the steps. */
    @Benchmark
    public void step() {
        for (int step = 0; step < steps; step++) {
            running.step();
        }
        running.finish();
    }

    /** Checks the end state and measures its quality. */
    @TearDown(Level.Iteration)
    public void check(Outcome outcome) {
        allocatedAfter = Usage.allocatedBytes();
        running.read(end);
        // Over-full crowds push circles some radii out of the thesis's arena before it reflects them.
        end.requirePlausible(start, 0.1f);
        requireRepeatable();
        outcome.set(end.quality(start), (double) (allocatedAfter - allocatedBefore) / steps);
    }

    private void requireRepeatable() {
        long hash = end.hash();
        if (firstHash != null && firstHash != hash && running.repeatable()) {
            throw new IllegalStateException(engine + " ended the same run in another state");
        }
        firstHash = hash;
    }

    /** Ends the engine. */
    @TearDown(Level.Trial)
    public void close() {
        running.close();
    }
}
