package io.github.circles2d.world.circles;

import java.nio.ByteBuffer;

/**
 * How fast surfaces slid in the hits of a {@link TouchSection}: a section behind it, if some did.
 *
 * <pre>
 * section    int {@link #NUMBER}, number of hits that slid; for each: int number of the hit, float speed. The hits that are not complete come
 *            first, then the events of removed circles, in the order of the section before; those that did not slide are left out.
 * </pre>
 */
final class SlipSection {
    /** Greater than those of all other sections. */
    static final int NUMBER = TouchSection.NUMBER + 1;

    private static final int HEAD = 2 * Integer.BYTES;
    private static final int SLIP = Integer.BYTES + Float.BYTES;

    private SlipSection() {}

    /** The number of sections: 1 or none. */
    static int count(SavedTouches t) {
        return slips(t) > 0 ? 1 : 0;
    }

    static long bytes(SavedTouches t) {
        int slips = slips(t);
        return slips > 0 ? HEAD + (long) SLIP * slips : 0;
    }

    private static int slips(SavedTouches t) {
        int count = 0;
        for (int hit = 0; hit < t.open + t.late; hit++) {
            count += slip(t, hit) == 0f ? 0 : 1;
        }
        return count;
    }

    private static float slip(SavedTouches t, int hit) {
        return hit < t.open ? t.openValues[place(hit)] : t.lateValues[place(hit - t.open)];
    }

    private static int place(int hit) {
        return SavedTouches.VALUES * hit + SavedTouches.SLIP;
    }

    static void write(SavedTouches t, ByteBuffer out) {
        int slips = slips(t);
        if (slips == 0) {
            return;
        }
        out.putInt(NUMBER).putInt(slips);
        for (int hit = 0; hit < t.open + t.late; hit++) {
            float slip = slip(t, hit);
            if (slip != 0f) {
                out.putInt(hit).putFloat(slip);
            }
        }
    }

    /** Reads the section behind its number and its number of hits, and checks it; the section of hits has been read. */
    static void read(ByteBuffer in, SavedTouches t, int slips) {
        SnapshotCodec.require(
                slips > 0 && slips <= t.open + t.late && (long) SLIP * slips <= in.remaining(),
                "it cannot hold as many hits that slid as it says");
        int before = -1;
        for (int k = 0; k < slips; k++) {
            int hit = in.getInt();
            float slip = in.getFloat();
            SnapshotCodec.require(hit > before && hit < t.open + t.late, "its hits that slid are not in order");
            SnapshotCodec.require(
                    hit < t.open || t.lateInts[SavedTouches.LATE_INTS * (hit - t.open)] == SavedTouches.HIT,
                    "an event that is no hit has slid");
            SnapshotCodec.require(slip > 0f && Float.isFinite(slip), "the speed of a hit that slid is out of range");
            before = hit;
            if (hit < t.open) {
                t.openValues[place(hit)] = slip;
            } else {
                t.lateValues[place(hit - t.open)] = slip;
            }
        }
    }
}
