package io.github.circles2d.bench.jmh;

import io.github.circles2d.World;
import io.github.circles2d.WorldStats;
import io.github.circles2d.bench.engines.Engines;
import io.github.circles2d.bench.engines.Starts;
import io.github.circles2d.scenes.Quality;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.Map;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.infra.BenchmarkParams;

/**
 * A World that every iteration puts back to the same state, and whose end state must have the same hash every time. The state
 * is that of the scene {@code packed} after the steps in which the overlaps of its start come apart.
 */
@State(Scope.Thread)
public class WorldRun {
    /** World's name out of {@link Engines}. */
    @Param({"world-jvm", "world@best"})
    public String engine;

    /** Number of circles. */
    @Param({"1250", "5000", "15000"})
    public int n;

    /** Steps of the scene before the measured ones. */
    @Param("100")
    public int skipped;

    World world;
    float timeStep;
    int steps;
    private ByteBuffer start;
    private Long startHash;
    private Long endHash;
    private Quality quality;
    private long allocatedBefore;
    private Map<String, Double> stagesBefore;
    private WorldStats statsAfter;

    /** Opens the device. */
    @Setup(Level.Trial)
    public void open(BenchmarkParams params) throws IOException {
        steps = params.getOpsPerInvocation();
        timeStep = 1 / 60f;
        start = Starts.get(engine, n, skipped);
        world = Engines.worldBuilder(engine).capacity(n).profiling(profiling()).build();
    }

    boolean profiling() {
        return false;
    }

    /** Puts the world back. */
    @Setup(Level.Iteration)
    public void restore() {
        world.restore(start.rewind());
        if (startHash == null) {
            startHash = world.hash();
        }
        stagesBefore = world.stats().stageMillis();
        statsAfter = null;
        allocatedBefore = Usage.allocatedBytes();
    }

    /** Stage times since {@link #restore}, in the order in which iterations end. */
    void readStages(StageTimes times) {
        times.set(stagesBefore, statsAfter().stageMillis(), steps);
    }

    private WorldStats statsAfter() {
        if (statsAfter == null) {
            statsAfter = world.stats();
        }
        return statsAfter;
    }

    /** Checks the end state and measures it. */
    @TearDown(Level.Iteration)
    public void check(WorldOutcome outcome) {
        double allocated = Usage.allocatedBytes() - allocatedBefore;
        long hash = world.hash();
        if (hash == startHash) {
            throw new IllegalStateException(engine + " has not moved");
        }
        if (endHash == null) {
            endHash = hash;
            quality = inspect();
        } else if (endHash != hash) {
            throw new IllegalStateException(engine + " ended the same run in another state");
        }
        outcome.set(statsAfter(), hash, quality, allocated / steps);
    }

    /** The quality of the state, whose numbers are all finite and whose circles are all there, within the walls. */
    private Quality inspect() {
        if (world.size() != n) {
            throw new IllegalStateException(n + " circles have become " + world.size());
        }
        float[] circles = new float[4 * n];
        float[] velocities = new float[2 * n];
        world.read(circles);
        world.readVelocities(velocities);
        float[][] columns = new float[6][n];
        for (int i = 0; i < n; i++) {
            for (int k = 0; k < 4; k++) {
                columns[k][i] = circles[4 * i + k];
            }
            columns[4][i] = velocities[2 * i];
            columns[5][i] = velocities[2 * i + 1];
            if (!(columns[0][i] >= 0 && columns[0][i] <= 1 && columns[1][i] >= 0 && columns[1][i] <= 1)) {
                throw new IllegalStateException("circle " + i + " of " + n + " is at (" + columns[0][i] + ", "
                        + columns[1][i] + "), outside the walls");
            }
        }
        return Quality.of(columns[0], columns[1], columns[2], columns[3], columns[4], columns[5], n);
    }

    /** Closes the world. */
    @TearDown(Level.Trial)
    public void close() {
        world.close();
    }
}
