package io.github.circles2d.world.jvm.state;

import static io.github.circles2d.world.jvm.state.PieceContactRow.PIECE;
import static io.github.circles2d.world.jvm.state.PieceContactRow.SERIAL;

import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.ContactRows;
import io.github.circles2d.world.model.PieceRow;
import io.github.circles2d.world.terrain.SavedPieceContacts;
import java.util.Arrays;

/**
 * The piece contacts of all circles, kept from step to step: of each slot a range, in the order of the pieces' ids. Each step finds them anew, from
 * those of the step before. Worlds without terrain have none.
 */
public final class PieceContacts {
    /** By slot: the first contact. */
    public int[] first = new int[0];

    /** By slot: how many contacts. */
    public int[] count = new int[0];

    /** By contact, {@link PieceContactRow}. */
    public float[] rows = new float[0];

    public int[] numbers = new int[0];

    /** By contact, within a step: the row of the piece. The pieces themselves lie in another order than circles. */
    public float[] pieces = new float[0];

    /** By contact, within a step in which circles can rotate: what {@link PieceContactRow#surfaces} has. */
    public float[] surfaces = new float[0];

    /** By slot, within a step: the displacement x, y at which the contacts were measured last. */
    public float[] measured = new float[0];

    private int[] firstSpare = new int[0];
    private int[] countSpare = new int[0];
    private float[] rowsSpare = new float[0];
    private int[] numbersSpare = new int[0];

    long bytes() {
        return 4L * (2 * first.length + 2 * count.length + measured.length + surfaces.length + pieces.length)
                + 4L * (rows.length + rowsSpare.length + numbers.length + numbersSpare.length);
    }

    /** Makes room for circles. The array that is compared grows last, and no step exchanges it: a growth that fails is tried again. */
    void ensure(int circles) {
        if (CircleRow.vector(circles) > measured.length) {
            first = Arrays.copyOf(first, circles);
            firstSpare = new int[circles];
            count = Arrays.copyOf(count, circles);
            countSpare = new int[circles];
            measured = new float[CircleRow.vector(circles)];
        }
    }

    /** Makes room for the contacts that a step finds; those that there are stay until {@link #take}. */
    public void ensureNext(int contacts) {
        if (PieceContactRow.of(contacts) > rowsSpare.length) {
            int room = contacts + (contacts >> 1) + 16;
            numbersSpare = new int[PieceContactRow.numbers(room)];
            rowsSpare = new float[PieceContactRow.of(room)];
        }
        if (PieceRow.of(contacts) > pieces.length) {
            pieces = new float[PieceRow.of(contacts + (contacts >> 1) + 16)];
        }
    }

    /** Copies contacts that a step has found to where they will be, and the rows of their pieces. */
    public void copyNext(float[] fromRows, int[] fromNumbers, int found, int to, float[] pieceRows) {
        System.arraycopy(fromRows, 0, rowsSpare, PieceContactRow.of(to), PieceContactRow.of(found));
        System.arraycopy(fromNumbers, 0, numbersSpare, PieceContactRow.numbers(to), PieceContactRow.numbers(found));
        for (int k = 0; k < found; k++) {
            int piece = fromNumbers[PieceContactRow.numbers(k) + PIECE];
            System.arraycopy(pieceRows, PieceRow.of(piece), pieces, PieceRow.of(to + k), PieceRow.STRIDE);
        }
    }

    /** Makes room for the surfaces of the contacts that there are. */
    public void ensureSurfaces() {
        if (surfaces.length < PieceContactRow.surfaces(rows.length / PieceContactRow.STRIDE)) {
            surfaces = new float[PieceContactRow.surfaces(rows.length / PieceContactRow.STRIDE)];
        }
    }

    /** The contacts that a step has found take the place of those before. */
    public void take() {
        float[] f = rows;
        rows = rowsSpare;
        rowsSpare = f;
        int[] i = numbers;
        numbers = numbersSpare;
        numbersSpare = i;
    }

    /** Of a new circle, or of one that is another now. */
    void forget(int slot) {
        first[slot] = 0;
        count[slot] = 0;
    }

    void move(int from, int to) {
        first[to] = first[from];
        count[to] = count[from];
    }

    void exchange(int slot, int other) {
        State.exchange(first, slot, other);
        State.exchange(count, slot, other);
    }

    /** As {@link State#permute}. */
    void permute(int old, int slot) {
        firstSpare[slot] = first[old];
        countSpare[slot] = count[old];
    }

    /** As {@link State#copy}. */
    void copy(int from, int to, boolean back) {
        State.copy(first, firstSpare, from, to - from, back);
        State.copy(count, countSpare, from, to - from, back);
    }

    void swap() {
        int[] i = first;
        first = firstSpare;
        firstSpare = i;
        i = count;
        count = countSpare;
        countSpare = i;
    }

    /** Makes room for saved contacts. */
    void makeRoom(SavedPieceContacts from) {
        if (PieceContactRow.of(from.count) > rows.length) {
            numbers = Arrays.copyOf(numbers, PieceContactRow.numbers(from.count));
            rows = Arrays.copyOf(rows, PieceContactRow.of(from.count));
        }
    }

    /** Saves the contacts of a slot. */
    public void save(int slot, int id, SavedPieceContacts into) {
        into.ensure(into.count + count[slot]);
        for (int c = first[slot]; c < first[slot] + count[slot]; c++) {
            int row = PieceContactRow.of(c);
            into.add(
                    id,
                    piece(c),
                    serial(c),
                    (int) rows[row + PieceContactRow.SIDE],
                    rows[row + PieceContactRow.IMPULSE],
                    rows,
                    row + PieceContactRow.ROWS);
        }
    }

    /** Saves the contacts that a circle keeps while it sleeps. */
    public static void save(int id, Sleepers sleepers, SavedPieceContacts into) {
        into.ensure(into.count + sleepers.pieces(id));
        for (int c = 0; c < sleepers.pieces(id); c++) {
            float[] rows = sleepers.pieceRows(id);
            int[] numbers = sleepers.pieceNumbers(id);
            int row = PieceContactRow.of(c);
            into.add(
                    id,
                    numbers[PieceContactRow.numbers(c) + PIECE],
                    numbers[PieceContactRow.numbers(c) + SERIAL],
                    (int) rows[row + PieceContactRow.SIDE],
                    rows[row + PieceContactRow.IMPULSE],
                    rows,
                    row + PieceContactRow.ROWS);
        }
    }

    /** Takes over saved contacts, for which there is room, of so many circles in slots in the order of their ids. */
    void load(SavedPieceContacts from, int[] id, int circles) {
        int c = 0;
        for (int slot = 0; slot < circles; slot++) {
            first[slot] = c;
            for (; c < from.count && from.circle[c] == id[slot]; c++) {
                int row = PieceContactRow.of(c);
                numbers[PieceContactRow.numbers(c) + PIECE] = from.piece[c];
                numbers[PieceContactRow.numbers(c) + SERIAL] = from.serial[c];
                rows[row + PieceContactRow.SIDE] = from.side[c];
                rows[row + PieceContactRow.IMPULSE] = from.impulse[c];
                ContactRows.copy(from.rows, ContactRows.of(c), rows, row + PieceContactRow.ROWS);
            }
            count[slot] = c - first[slot];
        }
    }

    public int piece(int contact) {
        return numbers[PieceContactRow.numbers(contact) + PIECE];
    }

    public int serial(int contact) {
        return numbers[PieceContactRow.numbers(contact) + SERIAL];
    }
}
