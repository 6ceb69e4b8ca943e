package io.github.circles2d.world.saves;

import io.github.circles2d.world.changes.NextStep;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.shared.WorldParts;
import io.github.circles2d.world.snapshots.SavedState;
import io.github.circles2d.world.snapshots.SnapshotCodec;
import io.github.circles2d.world.snapshots.SnapshotRing;
import java.nio.Buffer;
import java.nio.ByteBuffer;

/** Takes snapshots and restores them. A state that has been saved is not saved again until it changes. */
public final class Snapshots {
    private final WorldParts world;
    private final NextStep nextStep;

    public Snapshots(WorldParts world, NextStep nextStep) {
        this.world = world;
        this.nextStep = nextStep;
    }

    /** The number of bytes that {@link #write} would write now. */
    public int bytes() {
        world.guard.enter();
        try (world.guard) {
            return world.copies.snapshot().limit();
        }
    }

    /** Writes all that decides what comes after it. */
    public void write(ByteBuffer to) {
        world.guard.enter();
        try (world.guard) {
            if (Limits.notNull("to", to).isReadOnly()) {
                throw new IllegalArgumentException("the buffer is read-only");
            }
            ByteBuffer snapshot = world.copies.snapshot();
            if (to.remaining() < snapshot.limit()) {
                throw new IllegalArgumentException("the buffer has room for " + to.remaining()
                        + " bytes, but the snapshot has " + snapshot.limit());
            }
            SnapshotCodec.addCheck(snapshot);
            to.put(snapshot.array(), 0, snapshot.limit());
        }
    }

    /** Takes over what a snapshot says, in place of all that is. */
    public void restore(ByteBuffer from) {
        world.guard.enterToReplace();
        try (world.guard) {
            Limits.notNull("from", from);
            SavedState saved = world.copies.other();
            int length = SnapshotCodec.read(from, saved);
            makeRoom(saved);
            ((Buffer) from).position(from.position() + length);
            load(saved);
        }
    }

    /** Saves the state as a frame. */
    public void save(SnapshotRing ring, int frame) {
        world.guard.enterToReplace();
        try (world.guard) {
            ByteBuffer snapshot = world.copies.snapshot();
            ring.save(frame, snapshot, world.copies.saved().parameters());
        }
    }

    /** Takes over a frame, in place of all that is. */
    public void restore(SnapshotRing ring, int frame) {
        world.guard.enterToReplace();
        try (world.guard) {
            int place = ring.find(frame);
            SavedState saved = world.copies.other();
            ring.load(place, saved);
            makeRoom(saved);
            load(saved);
        }
    }

    /** Makes room for a saved state. If that fails, nothing has changed. */
    private void makeRoom(SavedState saved) {
        if (world.guard.holds()) {
            world.pending.finish();
        } else {
            world.moves.leaveFailed();
        }
        world.state.makeRoom(saved);
        nextStep.makeRoom(saved);
        world.copies.forget();
        world.log.restore(saved);
    }

    /** Takes over a saved state, for which there is room. */
    private void load(SavedState saved) {
        world.guard.changing = true;
        try {
            world.pending.restored();
            world.state.load(saved);
            nextStep.restored(saved);
        } catch (RuntimeException | Error e) {
            throw world.guard.failed(e);
        }
        world.guard.replaced();
    }
}
