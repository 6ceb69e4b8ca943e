package io.github.circles2d.world.events;

/** Lists pairs that touch, in order. */
final class TouchingList {
    private final TouchTracker tracker;
    private final TouchingPairs pairs;
    private final KnownCircles circles;
    private final KnownPieces pieces;
    private final EventRows listed = new EventRows();

    TouchingList(TouchTracker tracker, TouchingPairs pairs, KnownCircles circles, KnownPieces pieces) {
        this.tracker = tracker;
        this.pairs = pairs;
        this.circles = circles;
        this.pieces = pieces;
    }

    /** See {@link ContactEvents#list}. */
    int list(int kindA, int kindB, long[] handles) {
        listed.clear();
        for (int pair = 0; pair < pairs.count; pair++) {
            int lower = pairs.lower(pair);
            int higher = pairs.higher(pair);
            if (EventOrder.isCircle(higher) && tracker.typesOf(lower, higher) != 0) {
                int ofLower = circles.kind(lower);
                int ofHigher = circles.kind(higher);
                if (ofLower == kindA && ofHigher == kindB) {
                    add(lower, higher, pairs.a[pair], pairs.b[pair]);
                } else if (ofLower == kindB && ofHigher == kindA) {
                    add(lower, higher, pairs.b[pair], pairs.a[pair]);
                }
            }
        }
        return write(handles);
    }

    /** See {@link ContactEvents#listPieces}. */
    int listPieces(int kind, int kindOfPieces, long[] handles) {
        listed.clear();
        for (int pair = 0; pair < pairs.count; pair++) {
            int lower = pairs.lower(pair);
            int higher = pairs.higher(pair);
            if (PieceCode.isPiece(higher)
                    && circles.kind(lower) == kind
                    && pieces.kind(PieceCode.piece(higher)) == kindOfPieces
                    && tracker.typesOf(lower, higher) != 0) {
                add(lower, higher, pairs.a[pair], pairs.b[pair]);
            }
        }
        return write(handles);
    }

    private int write(long[] handles) {
        listed.sort();
        for (int k = 0; k < Math.min(listed.count, handles.length / 2); k++) {
            int row = listed.ordered(k);
            handles[2 * k] = listed.a(row);
            handles[2 * k + 1] = listed.partner(row);
        }
        return listed.count;
    }

    private void add(int lower, int higher, long first, long second) {
        listed.add(lower, higher, 0, first, second);
    }

    /** Memory of the arrays. */
    long bytes() {
        return listed.bytes();
    }
}
