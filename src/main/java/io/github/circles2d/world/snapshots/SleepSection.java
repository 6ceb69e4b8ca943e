package io.github.circles2d.world.snapshots;

import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.model.Sleep;
import java.nio.ByteBuffer;
import java.util.Arrays;

/**
 * How circles sleep, in a snapshot of a world whose circles do.
 *
 * <pre>
 * section    int number of circles that come to rest
 *            for each: varint of the id minus the one before (-1 at first); varint: rest (awake) times 2, or 1 plus twice the steps out of
 *            balance (asleep); float drift x, y, int turned (awake), or float known acceleration x, y, int offset (asleep), by {@link Sleep}
 * </pre>
 */
final class SleepSection {
    private static final int LEAST = 2 + 2 * Float.BYTES + Integer.BYTES;

    private SleepSection() {}

    private static boolean moves(SavedState s, int k) {
        int bits = s.rest[k]
                | s.turned[k]
                | Float.floatToRawIntBits(s.drift[2 * k])
                | Float.floatToRawIntBits(s.drift[2 * k + 1]);
        return bits == 0;
    }

    private static int key(int rest) {
        return Sleep.isAsleep(rest) ? 1 + 2 * (Sleep.ASLEEP - rest) : 2 * rest;
    }

    static void write(SavedState s, ByteBuffer out) {
        int count = 0;
        for (int k = 0; k < s.circles; k++) {
            count += moves(s, k) ? 0 : 1;
        }
        out.putInt(count);
        int previous = -1;
        for (int k = 0; k < s.circles; k++) {
            if (!moves(s, k)) {
                Varint.put(out, s.id[k] - previous);
                previous = s.id[k];
                Varint.put(out, key(s.rest[k]));
                out.putFloat(s.drift[2 * k]).putFloat(s.drift[2 * k + 1]).putInt(s.turned[k]);
            }
        }
    }

    /** Reads the section behind its number, and checks it; circles have been read. */
    static void read(ByteBuffer in, SavedState s) {
        if (!s.parameters().sleeps()) { // else they were known before, and a new object would be garbage
            s.setParameters(s.parameters().sleeping(true));
        }
        int count = in.getInt();
        SnapshotCodec.require(
                count >= 0 && count <= s.circles && (long) count * LEAST <= in.remaining(),
                "it cannot hold so many circles that come to rest");
        s.setSleeps(true);
        Arrays.fill(s.rest, 0, s.circles, 0);
        Arrays.fill(s.drift, 0, 2 * s.circles, 0f);
        Arrays.fill(s.turned, 0, s.circles, 0);
        long id = -1;
        int k = 0;
        for (int n = 0; n < count; n++) {
            long more = Integer.toUnsignedLong(Varint.get(in));
            id += more;
            while (k < s.circles && s.id[k] < id) {
                k++;
            }
            SnapshotCodec.require(more > 0 && k < s.circles && s.id[k] == id, "what comes to rest is no circle");
            readCircle(in, s, k);
        }
    }

    private static void readCircle(ByteBuffer in, SavedState s, int k) {
        int key = Varint.get(in);
        SnapshotCodec.require(key >= 0, "a circle rests for less than no step");
        SnapshotCodec.require(
                CircleMath.inverseMass(s.circle[CircleRow.of(k) + CircleRow.MASS]) > 0f, "a static circle sleeps");
        s.rest[k] = (key & 1) == 0 ? key >> 1 : Sleep.ASLEEP - (key >> 1);
        boolean asleep = Sleep.isAsleep(s.rest[k]);
        s.drift[2 * k] = asleep ? acceleration(in) : drift(in);
        s.drift[2 * k + 1] = asleep ? acceleration(in) : drift(in);
        s.turned[k] = in.getInt();
        SnapshotCodec.require(!asleep || isStill(s, k), "a circle sleeps that moves");
        SnapshotCodec.require(!asleep || isOffset(s.turned[k]), "a circle sleeps that is far out of balance");
        SnapshotCodec.require(!moves(s, k), "it says of a circle that it does not come to rest");
    }

    private static float drift(ByteBuffer in) {
        return Limits.within("a drift", in.getFloat(), -Limits.COORDINATE, Limits.COORDINATE);
    }

    private static float acceleration(ByteBuffer in) {
        return Limits.within("a known acceleration", in.getFloat(), -Float.MAX_VALUE, Float.MAX_VALUE);
    }

    static boolean isOffset(int offset) {
        return offset == Sleep.NO_OFFSET
                || Math.abs((short) offset) <= Sleep.MOST_PARTS && Math.abs(offset >> 16) <= Sleep.MOST_PARTS;
    }

    /** Whether steps leave a circle as it is, if nothing pushes it. */
    private static boolean isStill(SavedState s, int k) {
        int row = CircleRow.of(k);
        int bits = Float.floatToRawIntBits(s.motion[row + CircleRow.VX])
                | Float.floatToRawIntBits(s.motion[row + CircleRow.VY]);
        return bits == 0
                && Sleep.stays(s.circle[row + CircleRow.X], s.motion[row + CircleRow.DX])
                && Sleep.stays(s.circle[row + CircleRow.Y], s.motion[row + CircleRow.DY]);
    }
}
