package io.github.circles2d.world.jvm;

import io.github.circles2d.scenes.Scene;
import io.github.circles2d.world.Simulation;
import io.github.circles2d.world.SimulationScenes;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.WorldParameters;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.ContactRows;
import io.github.circles2d.world.snapshots.SavedState;
import io.github.circles2d.world.snapshots.SnapshotCodec;
import java.nio.ByteBuffer;

/** A simulation of a scene on the JVM, for tests that look inside its pipeline. */
final class JvmWorld implements AutoCloseable {
    final JvmPipeline pipeline;
    final Simulation simulation;
    private final float timeStep;

    JvmWorld(Scene scene, int threads) {
        timeStep = scene.timeStep();
        pipeline = new JvmPipeline(threads, 1, scene.size(), false);
        simulation = SimulationScenes.simulation(scene, 4, pipeline);
    }

    /** An empty world without gravity. */
    JvmWorld(Bounds bounds, int threads) {
        timeStep = 1 / 60f;
        pipeline = new JvmPipeline(threads, 1, 0, false);
        simulation = new Simulation(pipeline, new WorldParameters(bounds, 0, 0, 0, 4, 0));
    }

    void add(float x, float y, float r, float mass, float restitution, float vx, float vy) {
        long handle = simulation.newCircles.add(x, y, r, mass, vx, vy, 0);
        simulation.circles.set(Commands.RESTITUTION, handle, restitution, 0);
    }

    long[] handles() {
        long[] handles = new long[simulation.circles.size()];
        simulation.readings.readHandles(handles);
        return handles;
    }

    void step(int steps) {
        simulation.step(timeStep, steps);
    }

    SavedState save() {
        ByteBuffer snapshot = ByteBuffer.allocate(simulation.snapshots.bytes());
        simulation.snapshots.write(snapshot);
        SavedState saved = new SavedState();
        SnapshotCodec.read(snapshot.flip(), saved);
        return saved;
    }

    /**
     * Puts the circles into other slots, of which nothing may depend: a pipeline takes circles over into slots in the order in
     * which the state has them.
     *
     * @param order the circle of each slot, by its place among the ids
     */
    void permute(int[] order) {
        SavedState sorted = save();
        SavedState permuted = save();
        for (int slot = 0; slot < order.length; slot++) {
            permuted.id[slot] = sorted.id[order[slot]];
            copyRow(sorted.circle, order[slot], permuted.circle, slot);
            copyRow(sorted.motion, order[slot], permuted.motion, slot);
            copyRow(sorted.traits, order[slot], permuted.traits, slot);
            if (sorted.turns) {
                permuted.angle[slot] = sorted.angle[order[slot]];
                permuted.angularVelocity[slot] = sorted.angularVelocity[order[slot]];
                System.arraycopy(
                        sorted.wallRows,
                        ContactRows.ofWalls(order[slot]),
                        permuted.wallRows,
                        ContactRows.ofWalls(slot),
                        ContactRows.OF_WALLS);
            }
        }
        pipeline.makeRoom(permuted);
        pipeline.load(permuted);
    }

    private static void copyRow(float[] from, int row, float[] to, int toRow) {
        System.arraycopy(from, CircleRow.STRIDE * row, to, CircleRow.STRIDE * toRow, CircleRow.STRIDE);
    }

    @Override
    public void close() {
        simulation.close();
    }
}
