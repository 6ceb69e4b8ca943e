package io.github.circles2d.world;

import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.circles.SavedState;
import io.github.circles2d.world.circles.SnapshotCodec;
import io.github.circles2d.world.circles.SnapshotRing;
import io.github.circles2d.world.model.Limits;
import java.nio.Buffer;
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
            if (Limits.notNull("to", to).isReadOnly()) {
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
            Limits.notNull("from", from);
            savedCurrent = false;
            int length = SnapshotCodec.read(from, saved);
            makeRoom();
            ((Buffer) from).position(from.position() + length);
            load();
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** Saves the state as a frame. */
    public void save(SnapshotRing ring, int frame) {
        guard.enter();
        try {
            save();
            ring.save(frame, saved);
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** Takes over a frame, in place of all that is. */
    public void restore(SnapshotRing ring, int frame) {
        guard.enter();
        try {
            int place = ring.find(frame);
            savedCurrent = false;
            ring.load(place, saved);
            makeRoom();
            load();
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** Makes room for the state in {@link #saved}. If that fails, nothing has changed. */
    private void makeRoom() {
        simulation.finishSteps();
        handles.makeRoom(saved);
        simulation.forces.makeRoom(saved);
        simulation.travels.makeRoom(saved);
        simulation.growth.makeRoom(saved);
        pipeline.makeRoom(saved);
        pipeline.prepare(
                saved.parameters().contacts(), !saved.parameters().bounds().isWalled());
        simulation.events.makeRoom(saved.touches, saved.ids);
        simulation.changed();
        simulation.journal.restore(saved);
    }

    /** Takes over the state in {@link #saved}, for which there is room. */
    private void load() {
        guard.changing = true;
        handles.load(saved);
        simulation.kindTable.copy(saved.kinds);
        simulation.forces.restored(saved);
        simulation.commands.clear();
        simulation.journal.logged = 0;
        simulation.travels.restored();
        simulation.growth.restored();
        pipeline.load(saved);
        simulation.restored(saved.parameters());
        simulation.events.load(saved.touches, handles);
        guard.changing = false;
    }

    /** The state has changed. */
    void forget() {
        savedCurrent = false;
    }

    /** The state as of now; valid until the next change. */
    SavedState now() {
        save();
        return saved;
    }

    private void save() {
        if (!savedCurrent) {
            simulation.settle();
            handles.save(saved);
            pipeline.save(saved);
            simulation.events.save(saved.touches);
            saved.setParameters(simulation.parameters());
            saved.kinds.copy(simulation.kindTable);
            savedCurrent = true;
        }
    }
}
