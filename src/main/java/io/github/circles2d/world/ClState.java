package io.github.circles2d.world;

/** A copy of a device's state on the host, for what is needed seldom: the hash and snapshots. */
final class ClState {
    private static final int OLD_STRIDE = 4;

    private final int slots;
    private final int[] id;
    private final float[] circle;
    private final float[] motion;
    private final float[] traits;
    private final int[] memory;
    private final int[] slotOf;

    /** Remembered contacts, {@value #OLD_STRIDE} ints each: higher id, impulse, next contact. */
    private final int[] old;

    ClState(ClBuffers buffers, int slots) {
        this.slots = slots;
        id = ClReadback.ints(buffers.get(ClBuffers.HOME_ID), slots);
        circle = ClReadback.floats(buffers.get(ClBuffers.HOME_CIRCLE), 4 * slots);
        motion = ClReadback.floats(buffers.get(ClBuffers.HOME_MOTION), 4 * slots);
        traits = ClReadback.floats(buffers.get(ClBuffers.HOME_TRAITS), 4 * slots);
        memory = ClReadback.ints(buffers.get(ClBuffers.HOME_MEMORY), slots);
        slotOf = ClReadback.ints(buffers.get(ClBuffers.SLOT_OF), (int)
                (buffers.get(ClBuffers.SLOT_OF).bytes() / 4));
        old = ClReadback.ints(buffers.get(ClBuffers.OLD), OLD_STRIDE * buffers.contactRoom());
    }

    long hash() {
        long sum = 0;
        for (int slot = 0; slot < slots; slot++) {
            if (id[slot] >= 0) {
                sum += hashOfCircle(slot) + hashOfMemory(slot);
            }
        }
        return sum;
    }

    private long hashOfCircle(int slot) {
        int s = 4 * slot;
        long h = StateHash.absorb(StateHash.circle(), id[slot]);
        for (int k = 0; k < 4; k++) {
            h = StateHash.absorb(h, circle[s + k]);
        }
        for (int k = 0; k < 4; k++) {
            h = StateHash.absorb(h, motion[s + k]);
        }
        for (int k = 1; k < 4; k++) {
            h = StateHash.absorb(h, traits[s + k]);
        }
        return h;
    }

    private long hashOfMemory(int slot) {
        long sum = 0;
        for (int c = memory[slot]; c >= 0; c = old[OLD_STRIDE * c + 2]) {
            int hiId = old[OLD_STRIDE * c];
            int hi = slotOf[hiId];
            if (hi >= 0 && memory[hi] != ClBuffers.FRESH) {
                long h = StateHash.absorb(StateHash.absorb(StateHash.impulse(), id[slot]), hiId);
                sum += StateHash.absorb(h, Float.intBitsToFloat(old[OLD_STRIDE * c + 1]));
            }
        }
        return sum;
    }
}
