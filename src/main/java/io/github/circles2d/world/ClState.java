package io.github.circles2d.world;

/** A copy of a device's state on the host, for what is needed seldom: the hash and snapshots. */
final class ClState {
    private final int slots;
    private final int[] id;
    private final float[] circle;
    private final float[] motion;
    private final float[] traits;
    private final int[] memory;
    private final int[] slotOf;
    private final int[] oldHi;
    private final float[] oldLambda;
    private final int[] oldNext;

    ClState(ClBuffers buffers, int slots) {
        this.slots = slots;
        id = ClReadback.ints(buffers.get(ClBuffers.HOME_ID), slots);
        circle = ClReadback.floats(buffers.get(ClBuffers.HOME_CIRCLE), 4 * slots);
        motion = ClReadback.floats(buffers.get(ClBuffers.HOME_MOTION), 4 * slots);
        traits = ClReadback.floats(buffers.get(ClBuffers.HOME_TRAITS), 4 * slots);
        memory = ClReadback.ints(buffers.get(ClBuffers.HOME_MEMORY), slots);
        slotOf = ClReadback.ints(buffers.get(ClBuffers.SLOT_OF), (int)
                (buffers.get(ClBuffers.SLOT_OF).bytes() / 4));
        oldHi = ClReadback.ints(buffers.get(ClBuffers.OLD_HI), buffers.contactRoom());
        oldLambda = ClReadback.floats(buffers.get(ClBuffers.OLD_LAMBDA), buffers.contactRoom());
        oldNext = ClReadback.ints(buffers.get(ClBuffers.OLD_NEXT), buffers.contactRoom());
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
        for (int c = memory[slot]; c >= 0; c = oldNext[c]) {
            int hi = slotOf[oldHi[c]];
            if (hi >= 0 && memory[hi] != ClBuffers.FRESH) {
                long h = StateHash.absorb(StateHash.absorb(StateHash.impulse(), id[slot]), oldHi[c]);
                sum += StateHash.absorb(h, oldLambda[c]);
            }
        }
        return sum;
    }
}
