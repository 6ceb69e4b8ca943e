package io.github.circles2d.world;

import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.circles.SavedState;
import io.github.circles2d.world.circles.SnapshotCodec;
import java.nio.ByteBuffer;

/** Takes snapshots and restores them. A state that has been saved is not saved again until it changes. */
public final class Snapshots {
    private final Simulation simulation;
    private final Guard guard;
    private final HandleTable handles;
    private final Pipeline pipeline;
    private final SavedState saved = new SavedState();

    /** Whether {@link #saved} is the state as it is now. */
    private boolean savedCurrent;

    Snapshots(Simulation simulation) {
        this.simulation = simulation;
        guard = simulation.guard;
        handles = simulation.handles;
        pipeline = simulation.pipeline;
    }

    /** The number of bytes that {@link #write} would write now. */
    public int bytes() {
        guard.enter();
        try {
            save();
            return SnapshotCodec.bytes(saved);
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** Writes all that decides what comes after it. */
    public void write(ByteBuffer to) {
        guard.enter();
        try {
            if (to.isReadOnly()) {
                throw new IllegalArgumentException("the buffer is read-only");
            }
            save();
            int bytes = SnapshotCodec.bytes(saved);
            if (to.remaining() < bytes) {
                throw new IllegalArgumentException(
                        "the buffer has room for " + to.remaining() + " bytes, but the snapshot has " + bytes);
            }
            SnapshotCodec.write(saved, to);
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** Takes over what a snapshot says, in place of all that is. */
    public void restore(ByteBuffer from) {
        guard.enter();
        try {
            savedCurrent = false;
            int length = SnapshotCodec.read(from, saved);
            simulation.finishSteps();
            handles.makeRoom(saved);
            pipeline.makeRoom(saved);
            simulation.events.makeRoom(saved.touches, saved.ids);
            simulation.changed();
            from.position(from.position() + length);
            guard.changing = true;
            handles.load(saved);
            simulation.commands.clear();
            pipeline.load(saved);
            simulation.restored(saved.parameters());
            simulation.events.load(saved.touches, handles);
            guard.changing = false;
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** The state has changed. */
    void forget() {
        savedCurrent = false;
    }

    private void save() {
        if (!savedCurrent) {
            simulation.settle();
            handles.save(saved);
            pipeline.save(saved);
            simulation.events.save(saved.touches);
            saved.setParameters(simulation.parameters());
            savedCurrent = true;
        }
    }
}
