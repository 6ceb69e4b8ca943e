package io.github.circles2d.world.saves;

import io.github.circles2d.world.changes.Forces;
import io.github.circles2d.world.changes.Growth;
import io.github.circles2d.world.changes.Travels;
import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.circles.KindTable;
import io.github.circles2d.world.circles.SavedState;
import io.github.circles2d.world.circles.SnapshotCodec;
import io.github.circles2d.world.circles.SnapshotRing;
import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.joints.JointTables;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.shared.CallLog;
import io.github.circles2d.world.shared.Copies;
import io.github.circles2d.world.shared.Guard;
import io.github.circles2d.world.shared.Needs;
import io.github.circles2d.world.shared.PendingWork;
import io.github.circles2d.world.shared.Pipeline;
import io.github.circles2d.world.shared.StepFigures;
import io.github.circles2d.world.shared.WorldSettings;
import io.github.circles2d.world.terrain.TerrainTables;
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
    private final Pipeline pipeline;
    private final HandleTable handles;
    private final KindTable kinds;
    private final ContactEvents events;
    private final CallLog log;
    private final PendingWork pending;
    private final Copies copies;
    private final WorldSettings settings;
    private final StepFigures figures;
    private final Forces forces;
    private final Travels travels;
    private final Growth growth;
    private final TerrainTables terrain;
    private final JointTables joints;
    private final Needs needs;

    public Snapshots(
            Guard guard,
            Pipeline pipeline,
            HandleTable handles,
            KindTable kinds,
            ContactEvents events,
            CallLog log,
            PendingWork pending,
            Copies copies,
            WorldSettings settings,
            StepFigures figures,
            Forces forces,
            Travels travels,
            Growth growth,
            TerrainTables terrain,
            JointTables joints,
            Needs needs) {
        this.guard = guard;
        this.pipeline = pipeline;
        this.handles = handles;
        this.kinds = kinds;
        this.events = events;
        this.log = log;
        this.pending = pending;
        this.copies = copies;
        this.settings = settings;
        this.figures = figures;
        this.forces = forces;
        this.travels = travels;
        this.growth = growth;
        this.terrain = terrain;
        this.joints = joints;
        this.needs = needs;
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
        handles.makeRoom(saved);
        forces.makeRoom(saved);
        travels.makeRoom(saved);
        growth.makeRoom(saved);
        terrain.makeRoom(saved.terrain);
        joints.makeRoom(saved);
        needs.prepare(saved); // first, since the room depends on it
        pipeline.makeRoom(saved);
        events.makeRoom(saved.touches, saved.ids, saved.terrain.pieceIds);
        copies.forget();
        log.restore(saved);
    }

    /** Takes over a saved state, for which there is room. */
    private void load(SavedState saved) {
        guard.changing = true;
        handles.load(saved);
        kinds.copy(saved.kinds);
        forces.restored(saved);
        pending.restored();
        travels.restored();
        growth.restored();
        terrain.load(saved.terrain, saved.parameters().bounds(), saved.pieceContacts);
        joints.load(saved);
        pipeline.load(saved);
        settings.set(saved.parameters());
        needs.restored(saved);
        figures.forget();
        events.load(saved.touches, handles);
        guard.changing = false;
    }
}
