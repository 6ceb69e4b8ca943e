package io.github.circles2d.world.shared;

import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.snapshots.SavedState;
import io.github.circles2d.world.snapshots.SnapshotCodec;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/** The copies of the state that hold until it changes: the last bulk reading, and the saved state. Also its hash. */
public final class Copies {
    private final WorldParts world;
    private final SavedState saved = new SavedState();

    /** Whether {@link #saved} is the state as it is now. */
    private boolean savedCurrent;

    private ByteBuffer snapshot = ByteBuffer.allocate(0).order(ByteOrder.LITTLE_ENDIAN);

    /** Whether {@link #snapshot} has {@link #saved}. */
    private boolean snapshotCurrent;

    private final LastReading last;

    Copies(WorldParts world) {
        this.world = world;
        last = world.last;
    }

    /** Circles have changed, and all that was read or saved of them is out of date. */
    public void forget() {
        last.forgetCircles();
        last.forgetVelocities();
        last.forgetTurns();
        last.forgetJoints();
        savedCurrent = false;
    }

    /** Something has changed that no read has. */
    public void forgetSaved() {
        savedCurrent = false;
    }

    /** An operation of {@link Commands} makes what was read or saved out of date. */
    public void forgetBy(int operation) {
        switch (operation) {
            case Commands.VELOCITY, Commands.IMPULSE -> last.forgetVelocities();
            case Commands.ANGLE, Commands.ANGULAR_VELOCITY, Commands.ANGULAR_IMPULSE -> last.forgetTurns();
            case Commands.REMOVE -> forget();
            case Commands.RESTITUTION, Commands.FIELD, Commands.WAKE -> {
                // no read has them
            }
            default -> last.forgetCircles();
        }
        savedCurrent = false;
    }

    /** The state as of now; valid until the next change. */
    public SavedState saved() {
        if (!savedCurrent) {
            world.pending.settle();
            snapshotCurrent = false;
            world.state.save(saved);
            savedCurrent = true;
        }
        return saved;
    }

    /** The state as of now as a snapshot without its check; valid until the next change. */
    public ByteBuffer snapshot() {
        SavedState now = saved();
        if (!snapshotCurrent) {
            snapshot = SnapshotCodec.encode(now, snapshot);
            snapshotCurrent = true;
        }
        return snapshot;
    }

    /** The same object as {@link #saved}, which the caller fills with another state: it is none of now. */
    public SavedState other() {
        savedCurrent = false;
        return saved;
    }

    /** The hash of the state as of now. */
    public long hash() {
        world.pending.settle();
        return world.state.hash();
    }
}
