package io.github.circles2d.world.snapshots;

import io.github.circles2d.world.circles.Handle;
import io.github.circles2d.world.events.Partner;
import io.github.circles2d.world.events.SavedTouches;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.model.TerrainLimits;
import java.nio.ByteBuffer;
import java.util.Arrays;

/**
 * What events go on from in a snapshot: a section behind all others, if events are reported and there is something.
 *
 * <pre>
 * section    int {@link #NUMBER}, number of pairs, of hits that are not complete, of events of removed circles and pieces; for each pair, in
 *            ascending order: varint of the lower id minus the one before (0 at first), varint of the higher id, or of the code of a
 *            wall or piece of terrain, minus the lower; for each such hit: int number of the pair, its values; for each such event: long
 *            handles, byte type, byte number of the wall, -1 or {@link SavedTouches#PIECE}, values
 * values     float approach speed, impulse, normal x, y, point x, y, speed along the surfaces
 * </pre>
 */
final class TouchSection {
    /** Greater than those of all other sections. */
    static final int NUMBER = 2000;

    private static final int VALUE_BYTES = SavedTouches.VALUES * Float.BYTES;
    private static final int OPEN = Integer.BYTES + VALUE_BYTES;
    private static final int LATE = 2 * Long.BYTES + 2 + VALUE_BYTES;
    private static final int LEAST_PAIR = 2;
    private static final int PIECES = Partner.ofPiece(0);

    private TouchSection() {}

    private static int lower(SavedTouches t, int k) {
        return (int) (t.pair[k] >>> Integer.SIZE);
    }

    /** Returns how many sections that is: 1 or none. */
    static int write(SavedTouches t, ByteBuffer out) {
        if (t.pairs + t.late == 0) {
            return 0;
        }
        out.putInt(NUMBER).putInt(t.pairs).putInt(t.open).putInt(t.late);
        int before = 0;
        for (int k = 0; k < t.pairs; k++) {
            int lower = lower(t, k);
            Varint.put(out, lower - before);
            Varint.put(out, (int) t.pair[k] - lower);
            before = lower;
        }
        for (int k = 0; k < t.open; k++) {
            out.putInt(t.openPair[k]);
            writeValues(t.openValues, k, out);
        }
        for (int k = 0; k < t.late; k++) {
            out.putLong(t.lateHandles[2 * k]).putLong(t.lateHandles[2 * k + 1]);
            out.put((byte) t.lateInts[SavedTouches.LATE_INTS * k]);
            out.put((byte) t.lateInts[SavedTouches.LATE_INTS * k + 1]);
            writeValues(t.lateValues, k, out);
        }
        return 1;
    }

    private static void writeValues(float[] values, int k, ByteBuffer out) {
        for (int v = 0; v < SavedTouches.VALUES; v++) {
            out.putFloat(values[SavedTouches.VALUES * k + v]);
        }
    }

    /** Reads the section behind its number and its number of pairs, and checks it; the circles have been read. */
    static void read(ByteBuffer in, SavedState s, int pairs) {
        int open = in.getInt();
        int late = in.getInt();
        SnapshotCodec.require(
                pairs >= 0
                        && open >= 0
                        && late >= 0
                        && open <= pairs
                        && (long) pairs + late > 0
                        && (long) LEAST_PAIR * pairs + (long) OPEN * open + (long) LATE * late <= in.remaining(),
                "it cannot hold as many pairs that touch as it says, and their events");
        SavedTouches t = s.touches;
        t.ensure(pairs, open, late);
        int lower = 0;
        for (int k = 0; k < pairs; k++) {
            long nextLower = lower + Integer.toUnsignedLong(Varint.get(in));
            long higher = nextLower + Integer.toUnsignedLong(Varint.get(in));
            SnapshotCodec.require(
                    isCircle(s, nextLower)
                            && higher > nextLower
                            && (isCircle(s, higher)
                                    || higher >= Limits.CIRCLES && higher < PIECES
                                    || isPiece(s, higher)),
                    "a pair that touches lacks a circle or a piece");
            lower = (int) nextLower;
            t.pair[k] = nextLower << Integer.SIZE | higher;
            SnapshotCodec.require(k == 0 || t.pair[k] > t.pair[k - 1], "its pairs that touch are not in order");
        }
        t.pairs = pairs;
        for (int k = 0; k < open; k++) {
            t.openPair[k] = in.getInt();
            SnapshotCodec.require(
                    t.openPair[k] >= 0 && t.openPair[k] < pairs && (k == 0 || t.openPair[k] > t.openPair[k - 1]),
                    "a hit has no pair that touches");
            readValues(t.openValues, k, in);
        }
        t.open = open;
        for (int k = 0; k < late; k++) {
            readLate(t, k, in);
        }
        t.late = late;
    }

    private static void readLate(SavedTouches t, int k, ByteBuffer in) {
        long a = in.getLong();
        long b = in.getLong();
        int type = in.get();
        int side = in.get();
        boolean isEvent = type == SavedTouches.HIT || type == SavedTouches.END;
        boolean isPair = side == -1
                ? isHandle(b, Limits.CIRCLES) && (int) a < (int) b
                : side == SavedTouches.PIECE
                        ? isHandle(b ^ Handle.PIECE, TerrainLimits.PIECES)
                        : side >= 0 && side < Partner.WALLS && b == 0;
        SnapshotCodec.require(
                isEvent && isHandle(a, Limits.CIRCLES) && isPair,
                "an event of a removed circle or piece is out of range");
        t.lateHandles[2 * k] = a;
        t.lateHandles[2 * k + 1] = b;
        t.lateInts[SavedTouches.LATE_INTS * k] = type;
        t.lateInts[SavedTouches.LATE_INTS * k + 1] = side;
        readValues(t.lateValues, k, in);
        SnapshotCodec.require(
                type == SavedTouches.HIT || slip(t.lateValues, k) == 0f, "an event that is no hit has slid");
    }

    private static boolean isHandle(long handle, int ids) {
        return handle >>> Integer.SIZE != 0 && (int) handle >= 0 && (int) handle < ids;
    }

    private static void readValues(float[] values, int k, ByteBuffer in) {
        for (int v = 0; v < SavedTouches.VALUES; v++) {
            float value = in.getFloat();
            SnapshotCodec.require(Float.isFinite(value), "a value of an event is out of range");
            values[SavedTouches.VALUES * k + v] = value;
        }
        SnapshotCodec.require(
                Float.floatToRawIntBits(slip(values, k)) >= 0, "the speed of a hit that slid is out of range");
    }

    private static float slip(float[] values, int k) {
        return values[SavedTouches.VALUES * k + SavedTouches.SLIP];
    }

    private static boolean isPiece(SavedState s, long code) {
        long piece = code - PIECES;
        return piece >= 0 && piece < s.terrain.pieceIds && s.terrain.lives((int) piece);
    }

    private static boolean isCircle(SavedState s, long id) {
        return id < Limits.CIRCLES && Arrays.binarySearch(s.id, 0, s.circles, (int) id) >= 0;
    }
}
