package io.github.circles2d.world.device;

import io.github.circles2d.world.circles.SavedState;
import io.github.circles2d.world.circles.StateHash;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.Arrays;

/** A copy of a device's state on the host, for what is needed seldom: the hash and snapshots. */
final class StateTransfer {
    private static final int OLD_STRIDE = 4;

    /** Memory that a saved state needs on its way to the device. */
    static final class Links {
        private final int[] slotOf;
        private final int[] memory;
        private final int[] old;

        Links(SavedState from, DeviceArrays buffers) {
            slotOf = new int[(int) (buffers.get(DeviceArrays.SLOT_OF).bytes() / 4)];
            memory = new int[from.circles];
            old = new int[OLD_STRIDE * from.impulses];
        }
    }

    private final int slots;
    private final int[] id;
    private final float[] circle;
    private final float[] motion;
    private final float[] traits;
    private final int[] memory;
    private final int[] slotOf;

    /** Remembered contacts, {@value #OLD_STRIDE} ints each: higher id, impulse, next contact. */
    private final int[] old;

    /**
     * Reads the state.
     *
     * @param slots slots at home
     * @param remembered number of contacts of the last step
     */
    StateTransfer(DeviceArrays buffers, int slots, int remembered) {
        this.slots = slots;
        id = Readback.ints(buffers.get(DeviceArrays.HOME_ID), slots);
        circle = Readback.floats(buffers.get(DeviceArrays.HOME_CIRCLE), 4 * slots);
        motion = Readback.floats(buffers.get(DeviceArrays.HOME_MOTION), 4 * slots);
        traits = Readback.floats(buffers.get(DeviceArrays.HOME_TRAITS), 4 * slots);
        memory = Readback.ints(buffers.get(DeviceArrays.HOME_MEMORY), slots);
        slotOf = Readback.ints(buffers.get(DeviceArrays.SLOT_OF), (int)
                (buffers.get(DeviceArrays.SLOT_OF).bytes() / 4));
        old = Readback.ints(buffers.get(DeviceArrays.OLD), OLD_STRIDE * remembered);
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
            if (isRecalled(c)) {
                long h = StateHash.absorb(StateHash.absorb(StateHash.impulse(), id[slot]), old[OLD_STRIDE * c]);
                sum += StateHash.absorb(h, Float.intBitsToFloat(old[OLD_STRIDE * c + 1]));
            }
        }
        return sum;
    }

    /** Whether the circle of higher id is still the one that the impulse belongs to. */
    private boolean isRecalled(int c) {
        int hi = slotOf[old[OLD_STRIDE * c]];
        return hi >= 0 && memory[hi] != DeviceArrays.FRESH;
    }

    /** Saves the circles whose ids are given, and the impulses. */
    void save(SavedState into) {
        into.impulses = 0;
        for (int k = 0; k < into.circles; k++) {
            int slot = slotOf[into.id[k]];
            System.arraycopy(circle, 4 * slot, into.circle, 4 * k, 4);
            System.arraycopy(motion, 4 * slot, into.motion, 4 * k, 4);
            System.arraycopy(traits, 4 * slot, into.traits, 4 * k, 4);
            for (int c = memory[slot]; c >= 0; c = old[OLD_STRIDE * c + 2]) {
                if (isRecalled(c)) {
                    into.addImpulse(id[slot], old[OLD_STRIDE * c], Float.intBitsToFloat(old[OLD_STRIDE * c + 1]));
                }
            }
        }
    }

    /** Writes saved circles and impulses to a device that has room for them; slots are in the order of the ids. */
    static void load(SavedState from, DeviceArrays buffers, Links links) {
        int n = from.circles;
        int[] slotOf = links.slotOf;
        int[] memory = links.memory;
        int[] old = links.old;
        Arrays.fill(slotOf, -1);
        for (int slot = 0; slot < n; slot++) {
            slotOf[from.id[slot]] = slot;
        }
        Arrays.fill(memory, -1);
        for (int c = 0; c < from.impulses; c++) {
            int lo = slotOf[from.lo[c]];
            old[OLD_STRIDE * c] = from.hi[c];
            old[OLD_STRIDE * c + 1] = Float.floatToRawIntBits(from.lambda[c]);
            old[OLD_STRIDE * c + 2] = memory[lo];
            memory[lo] = c;
        }
        buffers.get(DeviceArrays.HOME_CIRCLE).write(FloatBuffer.wrap(from.circle, 0, 4 * n));
        buffers.get(DeviceArrays.HOME_MOTION).write(FloatBuffer.wrap(from.motion, 0, 4 * n));
        buffers.get(DeviceArrays.HOME_TRAITS).write(FloatBuffer.wrap(from.traits, 0, 4 * n));
        buffers.get(DeviceArrays.HOME_ID).write(0, IntBuffer.wrap(from.id, 0, n));
        buffers.get(DeviceArrays.HOME_MEMORY).write(0, IntBuffer.wrap(memory));
        buffers.get(DeviceArrays.SLOT_OF).write(0, IntBuffer.wrap(slotOf));
        buffers.get(DeviceArrays.OLD).write(0, IntBuffer.wrap(old));
    }
}
