package io.github.circles2d.world.terrain;

import io.github.circles2d.world.circles.StateHash;
import io.github.circles2d.world.model.ContactRows;
import java.util.Arrays;

/**
 * The contacts of circles with pieces of terrain, ascending by the circle's id, then by the piece's. Arrays are reused, and may be longer than their
 * contents.
 */
public final class SavedPieceContacts {
    public int count;

    /** By contact: the id of the circle. */
    public int[] circle = new int[0];

    /** By contact: the id of the piece. */
    public int[] piece = new int[0];

    /** By contact: the serial that the piece had. No part of the state: a contact with another piece than that of now is none. */
    public int[] serial = new int[0];

    /** By contact: -1, 0 or 1. */
    public byte[] side = new byte[0];

    /** By contact: the normal impulse, at least 0. */
    public float[] impulse = new float[0];

    /** By contact: the impulses of its other rows, by {@link ContactRows}. */
    public float[] rows = new float[0];

    /** Room for the rows of a contact that somebody is about to add. */
    public final float[] next = new float[ContactRows.COUNT];

    public void clear() {
        count = 0;
    }

    /** Makes room without changing the number. */
    public void ensure(int contacts) {
        if (impulse.length < contacts) {
            // The array that is compared grows last: a growth that fails is tried again.
            int c = Math.max(contacts, impulse.length + (impulse.length >> 1));
            circle = Arrays.copyOf(circle, c);
            piece = Arrays.copyOf(piece, c);
            serial = Arrays.copyOf(serial, c);
            side = Arrays.copyOf(side, c);
            rows = Arrays.copyOf(rows, ContactRows.of(c));
            impulse = Arrays.copyOf(impulse, c);
        }
    }

    /** Adds a contact behind those that there are, with the impulses of its rows from a place of an array on; there is room. */
    public void add(
            int ofCircle, int ofPiece, int serialOfPiece, int onSide, float normalImpulse, float[] ofRows, int at) {
        circle[count] = ofCircle;
        piece[count] = ofPiece;
        serial[count] = serialOfPiece;
        side[count] = (byte) onSide;
        impulse[count] = normalImpulse;
        ContactRows.copy(ofRows, at, rows, ContactRows.of(count++));
    }

    /** Copies a contact to a place at or before its own. */
    public void move(int from, int to) {
        circle[to] = circle[from];
        piece[to] = piece[from];
        serial[to] = serial[from];
        side[to] = side[from];
        impulse[to] = impulse[from];
        ContactRows.copy(rows, ContactRows.of(from), rows, ContactRows.of(to));
    }

    /** Whether some row has acted. */
    public boolean hold() {
        for (int k = 0; k < count; k++) {
            if (ContactRows.any(rows, ContactRows.of(k), 1)) {
                return true;
            }
        }
        return false;
    }

    /** The part of the contacts in the hash of the state. */
    public long hash() {
        long sum = 0;
        for (int k = 0; k < count; k++) {
            sum += StateHash.pieceContact(circle[k], piece[k], side[k], impulse[k], rows, ContactRows.of(k));
        }
        return sum;
    }
}
