package io.github.circles2d.world.terrain;

import io.github.circles2d.world.circles.StateHash;
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

    /** By contact: the impulse of friction. */
    public float[] friction = new float[0];

    /** By contact: the rolling impulse. */
    public float[] rolling = new float[0];

    public SavedPieceContacts() {}

    public void clear() {
        count = 0;
    }

    /** Makes room without changing the number. */
    public void ensure(int contacts) {
        if (rolling.length < contacts) {
            // All arrays are made before one is assigned: a growth that fails changes nothing.
            int c = Math.max(contacts, rolling.length + (rolling.length >> 1));
            int[] newCircle = Arrays.copyOf(circle, c);
            int[] newPiece = Arrays.copyOf(piece, c);
            int[] newSerial = Arrays.copyOf(serial, c);
            byte[] newSide = Arrays.copyOf(side, c);
            float[] newImpulse = Arrays.copyOf(impulse, c);
            float[] newFriction = Arrays.copyOf(friction, c);
            float[] newRolling = Arrays.copyOf(rolling, c);
            circle = newCircle;
            piece = newPiece;
            serial = newSerial;
            side = newSide;
            impulse = newImpulse;
            friction = newFriction;
            rolling = newRolling;
        }
    }

    /** Adds a contact behind those that there are; there is room. */
    public void add(
            int ofCircle,
            int ofPiece,
            int serialOfPiece,
            int onSide,
            float normalImpulse,
            float ofFriction,
            float ofRolling) {
        circle[count] = ofCircle;
        piece[count] = ofPiece;
        serial[count] = serialOfPiece;
        side[count] = (byte) onSide;
        impulse[count] = normalImpulse;
        friction[count] = ofFriction;
        rolling[count++] = ofRolling;
    }

    /** Copies a contact to a place at or before its own. */
    public void move(int from, int to) {
        circle[to] = circle[from];
        piece[to] = piece[from];
        serial[to] = serial[from];
        side[to] = side[from];
        impulse[to] = impulse[from];
        friction[to] = friction[from];
        rolling[to] = rolling[from];
    }

    /** Whether a piece holds a circle. */
    public boolean grip() {
        for (int k = 0; k < count; k++) {
            if (friction[k] != 0f || rolling[k] != 0f) {
                return true;
            }
        }
        return false;
    }

    /** The part of the contacts in the hash of the state. */
    public long hash() {
        long sum = 0;
        for (int k = 0; k < count; k++) {
            sum += StateHash.pieceContact(circle[k], piece[k], side[k], impulse[k], friction[k], rolling[k]);
        }
        return sum;
    }
}
