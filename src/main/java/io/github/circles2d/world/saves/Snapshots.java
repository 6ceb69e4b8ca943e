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
    // The functions of the calls. They are linked before memory, or the stack, may end in a call.
    private static final Guard.Numbers<Snapshots, Void> BYTES =
            (snapshots, none, m, n) -> SnapshotCodec.bytes(snapshots.copies.saved());
    private static final Guard.ChangeWith<Snapshots, ByteBuffer> WRITE = Snapshots::writeSaved;
    private static final Guard.ChangeWith<Snapshots, ByteBuffer> RESTORE = Snapshots::read;
    private static final Guard.Numbers<Snapshots, SnapshotRing> SAVE =
            (snapshots, to, f, n) -> snapshots.saveFrame(to, (int) f);
    private static final Guard.Numbers<Snapshots, SnapshotRing> RESTORE_FRAME =
            (snapshots, from, f, n) -> snapshots.restoreFrame(from, (int) f);

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
        return (int) guard.read(this, null, 0, 0, BYTES);
    }

    /** Writes all that decides what comes after it. */
    public void write(ByteBuffer to) {
        guard.change(this, to, WRITE);
    }

    private void writeSaved(ByteBuffer to) {
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
    }

    /** Takes over what a snapshot says, in place of all that is. */
    public void restore(ByteBuffer from) {
        guard.change(this, from, RESTORE);
    }

    private void read(ByteBuffer from) {
        Limits.notNull("from", from);
        SavedState saved = copies.other();
        int length = SnapshotCodec.read(from, saved);
        makeRoom(saved);
        ((Buffer) from).position(from.position() + length);
        load(saved);
    }

    /** Saves the state as a frame. */
    public void save(SnapshotRing ring, int frame) {
        guard.read(this, ring, frame, 0, SAVE);
    }

    private long saveFrame(SnapshotRing ring, int frame) {
        ring.save(frame, copies.saved());
        return 0;
    }

    /** Takes over a frame, in place of all that is. */
    public void restore(SnapshotRing ring, int frame) {
        guard.read(this, ring, frame, 0, RESTORE_FRAME);
    }

    private long restoreFrame(SnapshotRing ring, int frame) {
        int place = ring.find(frame);
        SavedState saved = copies.other();
        ring.load(place, saved);
        makeRoom(saved);
        load(saved);
        return 0;
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
