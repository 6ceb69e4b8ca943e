package io.github.circles2d.world.device;

import io.github.circles2d.world.device.memory.DeviceArray;
import io.github.circles2d.world.device.memory.DeviceArrays;
import io.github.circles2d.world.model.ContactRows;
import io.github.circles2d.world.snapshots.SavedState;
import io.github.circles2d.world.terrain.SavedPieceContacts;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;

/** A copy of the contacts with pieces of terrain on the host, as {@link StateTransfer} is of the rest of the state. */
final class PieceTransfer {
    /** Ints of a circle's range of contacts: the first, how many. */
    private static final int RANGE = 2;

    /** Ints of a contact: piece, serial. */
    private static final int NUMBERS = 2;

    /** Floats of a contact: side, normal impulse. */
    private static final int FLOATS = 2;

    /** Memory that saved contacts need on their way to the device, which serves again. */
    static final class Room {
        private int[] ranges = new int[0];
        private int[] numbers = new int[0];
        private float[] floats = new float[0];
        private float[] rows = new float[0];

        void ensure(SavedState from) {
            int contacts = from.pieceContacts.count;
            ranges = StateTransfer.ints(ranges, RANGE * from.circles);
            numbers = StateTransfer.ints(numbers, NUMBERS * contacts);
            floats = StateTransfer.floats(floats, FLOATS * contacts);
            rows = StateTransfer.floats(rows, ContactRows.of(contacts));
        }

        /** Writes saved contacts to a device that has room for them; slots are in the order of the ids. */
        void load(SavedState from, DeviceArrays arrays) {
            SavedPieceContacts contacts = from.pieceContacts;
            int c = 0;
            for (int slot = 0; slot < from.circles; slot++) {
                ranges[RANGE * slot] = c;
                for (; c < contacts.count && contacts.circle[c] == from.id[slot]; c++) {
                    numbers[NUMBERS * c] = contacts.piece[c];
                    numbers[NUMBERS * c + 1] = contacts.serial[c];
                    floats[FLOATS * c] = contacts.side[c];
                    floats[FLOATS * c + 1] = contacts.impulse[c];
                    ContactRows.copy(contacts.rows, ContactRows.of(c), rows, ContactRows.of(c));
                }
                ranges[RANGE * slot + 1] = c - ranges[RANGE * slot];
            }
            int count = contacts.count;
            arrays.get(DeviceArray.HOME_PIECES).write(0, IntBuffer.wrap(ranges, 0, RANGE * from.circles));
            arrays.get(DeviceArray.HOME_PIECE).write(0, IntBuffer.wrap(numbers, 0, NUMBERS * count));
            arrays.get(DeviceArray.HOME_PUSH).write(FloatBuffer.wrap(floats, 0, FLOATS * count));
            arrays.get(DeviceArray.HOME_PIECE_ROWS).write(FloatBuffer.wrap(rows, 0, ContactRows.of(count)));
        }
    }

    private final int slots;
    private final int[] slotOf;
    private final int[] id;
    private final int[] ranges;
    private final int[] numbers;
    private final float[] floats;
    private final float[] rows;

    PieceTransfer(DeviceArrays arrays, int slots) {
        this.slots = slots;
        slotOf = Readback.ints(arrays.get(DeviceArray.SLOT_OF), arrays.idCapacity());
        id = Readback.ints(arrays.get(DeviceArray.HOME_ID), slots);
        ranges = Readback.ints(arrays.get(DeviceArray.HOME_PIECES), RANGE * slots);
        int end = end();
        numbers = Readback.ints(arrays.get(DeviceArray.HOME_PIECE), NUMBERS * end);
        floats = Readback.floats(arrays.get(DeviceArray.HOME_PUSH), FLOATS * end);
        rows = Readback.floats(arrays.get(DeviceArray.HOME_PIECE_ROWS), ContactRows.of(end));
    }

    /** Behind the last contact. */
    private int end() {
        int end = 0;
        for (int slot = 0; slot < slots; slot++) {
            if (id[slot] >= 0) {
                end = Math.max(end, ranges[RANGE * slot] + ranges[RANGE * slot + 1]);
            }
        }
        return end;
    }

    void save(SavedPieceContacts into) {
        for (int circle = 0; circle < slotOf.length; circle++) {
            if (slotOf[circle] >= 0) {
                save(circle, RANGE * slotOf[circle], into);
            }
        }
    }

    private void save(int circle, int range, SavedPieceContacts into) {
        int from = ranges[range];
        int to = from + ranges[range + 1];
        into.ensure(into.count + to - from);
        for (int c = from; c < to; c++) {
            into.add(
                    circle,
                    numbers[NUMBERS * c],
                    numbers[NUMBERS * c + 1],
                    (int) floats[FLOATS * c],
                    floats[FLOATS * c + 1],
                    rows,
                    ContactRows.of(c));
        }
    }
}
