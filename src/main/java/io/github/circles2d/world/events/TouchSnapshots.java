package io.github.circles2d.world.events;

import io.github.circles2d.world.circles.SavedTouches;
import java.util.Arrays;

/** Saves what the next events depend on, and goes on from what was saved: pairs, hits that are not complete, and late events. */
final class TouchSnapshots {
    private final TouchingPairs pairs;
    private final EventRows step;
    private final ReportTable reported;
    private final KnownCircles circles;
    private final KnownPieces pieces;

    TouchSnapshots(
            TouchingPairs pairs, EventRows step, ReportTable reported, KnownCircles circles, KnownPieces pieces) {
        this.pairs = pairs;
        this.step = step;
        this.reported = reported;
        this.circles = circles;
        this.pieces = pieces;
    }

    /** Saves all, which includes hits that are not complete. */
    void save(SavedTouches into, TouchRecords open) {
        into.ensure(pairs.count, pairs.count, step.count);
        for (int pair = 0; pair < pairs.count; pair++) {
            into.pair[pair] = (long) pairs.lower(pair) << Integer.SIZE | pairs.higher(pair);
        }
        into.pairs = pairs.count;
        Arrays.sort(into.pair, 0, into.pairs);
        for (int k = 0; k < into.pairs; k++) {
            int pair = pairs.find((int) (into.pair[k] >>> Integer.SIZE), (int) into.pair[k]);
            if (pairs.open(pair) != TouchingPairs.NONE) {
                open.copy(pairs.open(pair), into.openValues, SavedTouches.VALUES * into.open);
                into.openPair[into.open++] = k;
            }
        }
        step.sort();
        for (int k = 0; k < step.count; k++) {
            saveLate(into, k, step.ordered(k));
        }
        into.late = step.count;
    }

    private void saveLate(SavedTouches into, int k, int row) {
        into.lateHandles[2 * k] = step.a(row);
        into.lateHandles[2 * k + 1] = step.partner(row);
        into.lateInts[SavedTouches.LATE_INTS * k] = step.type(row);
        into.lateInts[SavedTouches.LATE_INTS * k + 1] = step.sideOf(row);
        step.copyValues(row, into.lateValues, SavedTouches.VALUES * k);
    }

    /** Adds what was saved and may still be reported, where nothing is left of what was. The circles are those of the state. */
    void load(SavedTouches from, TouchRecords open) {
        int nextOpen = 0;
        for (int k = 0; k < from.pairs; k++) {
            int lower = (int) (from.pair[k] >>> Integer.SIZE);
            int higher = (int) from.pair[k];
            boolean isOpen = nextOpen < from.open && from.openPair[nextOpen] == k;
            if (reported.mayReport(EventOrder.isWall(higher), ContactEvents.OF_PAIR_TYPES)) {
                int pair = pairs.add(lower, higher, circles.handle(lower), pieces.handleOfPartner(higher));
                if (isOpen) {
                    pairs.setOpen(pair, open.addValues(from.openValues, SavedTouches.VALUES * nextOpen));
                }
            }
            nextOpen += isOpen ? 1 : 0;
        }
        for (int k = 0; k < from.late; k++) {
            loadLate(from, k);
        }
    }

    private void loadLate(SavedTouches from, int k) {
        int type = from.lateInts[SavedTouches.LATE_INTS * k];
        int side = from.lateInts[SavedTouches.LATE_INTS * k + 1];
        long a = from.lateHandles[2 * k];
        long b = from.lateHandles[2 * k + 1];
        int higher = EventOrder.higher(b, side);
        if (reported.mayReport(EventOrder.isWall(higher), type)) {
            int rank = type == ContactEvents.HIT ? EventRow.LATE_HIT : EventRow.LATE_END;
            int row = step.add((int) a, higher, rank, a, b);
            step.setValues(row, from.lateValues, SavedTouches.VALUES * k);
        }
    }
}
