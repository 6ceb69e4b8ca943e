package io.github.circles2d.world.saves;

import io.github.circles2d.world.changes.NextStep;
import io.github.circles2d.world.circles.SavedState;
import io.github.circles2d.world.circles.SnapshotCodec;
import io.github.circles2d.world.circles.SnapshotRing;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.shared.CallLog;
import io.github.circles2d.world.shared.Copies;
import io.github.circles2d.world.shared.Guard;
import io.github.circles2d.world.shared.PendingWork;
import io.github.circles2d.world.shared.WorldState;
import java.nio.Buffer;
import java.nio.ByteBuffer;

/** Takes snapshots and restores them. A state that has been saved is not saved again until it changes. */
public final class Snapshots {
    private final Guard guard;
    private final CallLog log;
    private final PendingWork pending;
    private final Copies copies;
    private final NextStep nextStep;
    private final WorldState state;

    public Snapshots(
            Guard guard, CallLog log, PendingWork pending, Copies copies, NextStep nextStep, WorldState state) {
        this.guard = guard;
        this.log = log;
        this.pending = pending;
        this.copies = copies;
        this.nextStep = nextStep;
        this.state = state;
    }

    /** The number of bytes that {@link #write} would write now. */
    public int bytes() {
        guard.enter();
        try {
            return SnapshotCodec.bytes(copies.saved());
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
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
            SavedState saved = copies.saved();
            int bytes = SnapshotCodec.bytes(saved);
            if (to.remaining() < bytes) {
                throw new IllegalArgumentException(
                        "the buffer has room for " + to.remaining() + " bytes, but the snapshot has " + bytes);
            }
            SnapshotCodec.write(saved, to);
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    /** Takes over what a snapshot says, in place of all that is. */
    public void restore(ByteBuffer from) {
        guard.enter();
        try {
            Limits.notNull("from", from);
            SavedState saved = copies.other();
            int length = SnapshotCodec.read(from, saved);
            makeRoom(saved);
            ((Buffer) from).position(from.position() + length);
            load(saved);
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    /** Saves the state as a frame. */
    public void save(SnapshotRing ring, int frame) {
        guard.enter();
        try {
            ring.save(frame, copies.saved());
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    /** Takes over a frame, in place of all that is. */
    public void restore(SnapshotRing ring, int frame) {
        guard.enter();
        try {
            int place = ring.find(frame);
            SavedState saved = copies.other();
            ring.load(place, saved);
            makeRoom(saved);
            load(saved);
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    /** Makes room for a saved state. If that fails, nothing has changed. */
    private void makeRoom(SavedState saved) {
        pending.finish();
        state.makeRoom(saved);
        nextStep.makeRoom(saved);
        copies.forget();
        log.restore(saved);
    }

    /** Takes over a saved state, for which there is room. */
    private void load(SavedState saved) {
        guard.changing = true;
        pending.restored();
        state.load(saved);
        nextStep.restored(saved);
        guard.changing = false;
    }
}
