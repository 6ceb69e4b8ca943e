package io.github.circles2d.bench.jmh;

import io.github.circles2d.bench.engines.Engines;
import io.github.circles2d.bench.games.GameCosts;
import java.io.IOException;
import java.nio.ByteBuffer;
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
 * Ms a step of World with a feature for games in use. Features whose times differ little are compared better by {@link GameCosts},
 * which measures all of them in turn in one JVM.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.SingleShotTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@OperationsPerInvocation(120)
@Warmup(iterations = 2)
@Measurement(iterations = 5)
@Fork(value = 1, jvmArgsAppend = "--enable-native-access=ALL-UNNAMED")
public class GameCostBenchmark {
    /** World's name out of {@link Engines}. */
    @Param({"world-jvm", "world@best"})
    public String engine;

    /** Number of circles. */
    @Param({"1250", "15000", "100000", "1000000"})
    public int n;

    /** One of {@link GameCosts#FEATURES}. */
    @Param({
        "nothing",
        "positions",
        "hits",
        "hits-later",
        "kind",
        "walls",
        "half-ignored",
        "sensors",
        "forces",
        "record",
        "rewind",
        "fixed-step"
    })
    public String feature;

    private GameCosts costs;
    private int steps;
    private long silentHash;
    private Long endHash;

    /** Makes the start, and finds out how a silent world ends. */
    @Setup(Level.Trial)
    public void open(BenchmarkParams params) throws IOException {
        steps = params.getOpsPerInvocation();
        ByteBuffer start = GameCosts.start(Engines.worldBuilder(engine), n);
        try (GameCosts silent = new GameCosts(GameCosts.NOTHING, Engines.worldBuilder(engine), start)) {
            silent.prepare();
            silent.frames(steps);
            silentHash = silent.end();
        }
        costs = new GameCosts(feature, Engines.worldBuilder(engine), start);
    }

    /** Puts the world back. */
    @Setup(Level.Iteration)
    public void prepare() throws IOException {
        costs.prepare();
    }

    /** Makes steps with the feature. */
    @Benchmark
    public void frames() {
        costs.frames(steps);
    }

    /** Checks the end state. */
    @TearDown(Level.Iteration)
    public void check() throws IOException {
        long hash = costs.end();
        GameCosts.checkAgainstSilent(feature, hash, silentHash);
        if (endHash != null && endHash != hash) {
            throw new IllegalStateException(feature + " ended the same run in another state");
        }
        endHash = hash;
    }

    /** Closes the world. */
    @TearDown(Level.Trial)
    public void close() {
        costs.close();
    }
}
