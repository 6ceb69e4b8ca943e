package io.github.circles2d.bench.jmh;

import io.github.circles2d.World;
import io.github.circles2d.bench.engines.Engines;
import io.github.circles2d.bench.engines.SearchEngine;
import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.SceneLoader;
import io.github.circles2d.scenes.Scenes;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;

/**
 * Ms for 10,000 queries after a step, with the index that World builds for them. The scene is the gas at its start, whose circles do
 * not overlap, so no engine can differ by more than rounding in what it finds; a run fails if one does.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
@Fork(value = 1, jvmArgsAppend = "--enable-native-access=ALL-UNNAMED")
public class QueryBenchmark {
    private static final int QUERIES = 10_000;

    /** Radius of a searched disc, and greatest length of a ray along an axis, in mean radii of the scene. */
    private static final float DISC = 4;

    private static final float RAY = 20;

    /** Share of the finds by which engines may differ: rounding at the edges of circles. */
    private static final double TOLERANCE = 1e-3;

    /** A name out of {@link Engines} of an engine that searches. */
    @Param({"world-jvm", "gdx-box2d", "dyn4j"})
    public String engine;

    /** Number of circles. */
    @Param({"1250", "15000", "100000"})
    public int n;

    private SearchEngine running;
    private final float[] discs = new float[3 * QUERIES];
    private final float[] rays = new float[4 * QUERIES];
    private long discFinds;
    private long rayFinds;

    /** Loads the scene, and finds out what there is to find. */
    @Setup(Level.Trial)
    public void open() {
        Scene scene = Scenes.gas(n, Scenes.SEED);
        World.Builder builder = Engines.worldBuilder(Engines.WORLD_JVM);
        SceneLoader.parameters(scene, builder::bounds, builder::gravity, builder::restitution, builder::capacity);
        try (World world = builder.build()) {
            SceneLoader.circles(scene, world::add, world::setRestitution);
            makeQueries(scene, world);
            discFinds = world.queries().overlapCircle(discs, QUERIES, new int[QUERIES], new long[0]);
            rayFinds = world.queries().rayCast(rays, QUERIES, new long[QUERIES], null);
        }
        running = (SearchEngine) Engines.create(engine);
        running.loadCircles(scene);
    }

    private void makeQueries(Scene scene, World world) {
        float mean = 0;
        for (int i = 0; i < n; i++) {
            mean += scene.radius(i) / n;
        }
        Random random = new Random(Scenes.SEED);
        for (int q = 0; q < QUERIES; q++) {
            discs[3 * q] = random.nextFloat();
            discs[3 * q + 1] = random.nextFloat();
            discs[3 * q + 2] = DISC * mean;
            do {
                rays[4 * q] = random.nextFloat();
                rays[4 * q + 1] = random.nextFloat();
            } while (world.queries().pick(rays[4 * q], rays[4 * q + 1]) != 0);
            rays[4 * q + 2] = (random.nextFloat() * 2 - 1) * RAY * mean;
            rays[4 * q + 3] = (random.nextFloat() * 2 - 1) * RAY * mean;
        }
    }

    /** Finds what discs overlap. */
    @Benchmark
    public long overlaps() {
        return checked(discFinds, running.overlaps(discs));
    }

    /** Finds what rays meet first. */
    @Benchmark
    public long rays() {
        return checked(rayFinds, running.rayHits(rays));
    }

    private long checked(long expected, long found) {
        if (expected == 0 || Math.abs(found - expected) > 1 + TOLERANCE * expected) {
            throw new IllegalStateException(engine + " finds " + found + ", not " + expected);
        }
        return found;
    }

    /** Ends the engine. */
    @TearDown(Level.Trial)
    public void close() {
        running.close();
    }
}
