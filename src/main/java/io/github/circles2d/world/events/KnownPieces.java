package io.github.circles2d.world.events;

import io.github.circles2d.world.model.PairTable;
import io.github.circles2d.world.terrain.PieceTable;
import java.util.Arrays;

/** What events know of pieces of terrain, by id: as of the last step, which the table of pieces may be ahead of. */
final class KnownPieces {
    private static final int KIND_BITS = PairTable.KINDS - 1;

    private final KnownCircles circles;

    /** Null if there is no terrain. */
    private PieceTable table;

    /** By id: the handle, or 0. */
    private long[] handleOf = new long[0];

    private byte[] kindOf = new byte[0];
    private int end;

    /** By kind: how many pieces there are. */
    private final int[] population = new int[PairTable.KINDS];

    private int names;
    private int version;

    KnownPieces(KnownCircles circles) {
        this.circles = circles;
    }

    void setTable(PieceTable pieces) {
        table = pieces;
        names = pieces.names();
    }

    /** Whether no piece has come or gone since, nor got another kind. */
    boolean isCurrent() {
        return table == null || names == table.names();
    }

    /** Makes room. The array that is compared grows last: a growth that fails is tried again. */
    void ensure(int ids) {
        if (ids > handleOf.length) {
            int c = Math.max(ids, handleOf.length + (handleOf.length >> 1));
            kindOf = Arrays.copyOf(kindOf, c);
            handleOf = Arrays.copyOf(handleOf, c);
        }
    }

    int idsNow() {
        return table.ids.end();
    }

    /** Whether a piece that was known is no more. */
    boolean anyGone() {
        for (int id = 0; id < end; id++) {
            if (isGone(id)) {
                return true;
            }
        }
        return false;
    }

    boolean isGone(int id) {
        return handleOf[id] != 0 && handleOf[id] != now(id);
    }

    private long now(int id) {
        return id < table.ids.end() && table.ids.lives(id) ? table.ids.handle(id) : 0;
    }

    /** Learns all handles and kinds, for which there is room. */
    void read() {
        if (table == null) {
            return;
        }
        Arrays.fill(population, 0);
        end = table.ids.end();
        for (int id = 0; id < end; id++) {
            handleOf[id] = now(id);
            kindOf[id] = (byte) table.kindOf(id);
            population[kind(id)] += handleOf[id] == 0 ? 0 : 1;
        }
        names = table.names();
        version++;
    }

    /** The handle of a circle's partner, by its id or code; 0 of a wall. */
    long handleOfPartner(int code) {
        if (Partner.isCircle(code)) {
            return circles.handle(code);
        }
        return Partner.isPiece(code) ? handleOf[Partner.piece(code)] : 0;
    }

    int kind(int id) {
        return kindOf[id] & KIND_BITS;
    }

    boolean has(int kind) {
        return population[kind] > 0;
    }

    /** Counts how often pieces have been learned. */
    int version() {
        return version;
    }

    long bytes() {
        return 9L * handleOf.length + 4L * population.length;
    }
}
