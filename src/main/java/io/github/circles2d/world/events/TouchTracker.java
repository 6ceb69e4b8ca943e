package io.github.circles2d.world.events;

import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.TouchRule;
import java.util.Arrays;

/**
 * Follows the pairs that touch from step to step, and makes events of them. It is told of the pairs that touched and still do or do no
 * more, and takes the records of those that something happened to, {@link #endStep}. A pair that it does not hear of has ended. Mostly it
 * hears of all: then nothing is read or written of the pairs to which nothing happened. It also lists the pairs, saves them and goes on from what was saved.
 * {@code kernels/world/stages/Events.cl} does the same on a device.
 */
public final class TouchTracker {
    static final int FIRST_STAMP = 1;

    private final ReportTable reported;
    private final KnownCircles circles;
    private final KnownPieces pieces;
    private final TouchingPairs pairs;

    /** Events of the step to come, in no order: at first those of removed circles. */
    private final EventRows step;

    /** Hits that were not complete after the last step, and those after this one. */
    private TouchRecords open = new TouchRecords();

    private TouchRecords stillOpen = new TouchRecords();

    /** Pairs, in place of events, that a list has to bring into their order. */
    private final EventRows listed = new EventRows();

    private Bounds arena = new Bounds(0, 0, 1, 1);

    private float hitSpeed = ContactEvents.OF_PAIR;

    /** Pairs of circles that rest in this step, and touch as they did before it. */
    private int kept;

    /** Those of all pairs at rest whose hits are not complete. */
    private int[] keptOpen = new int[0];

    private int keptOpenCount;

    /** The stamp of the step that is being looked at: another than that of the step before. */
    private int now;

    TouchTracker(
            ReportTable reported,
            KnownCircles circles,
            KnownPieces pieces,
            TouchingPairs pairs,
            EventRows step,
            int stamp) {
        this.reported = reported;
        this.circles = circles;
        this.pieces = pieces;
        this.pairs = pairs;
        this.step = step;
        now = stamp;
    }

    Bounds arena() {
        return arena;
    }

    void setArena(Bounds bounds) {
        arena = bounds;
    }

    /** The speed from which on a hit counts, or {@link ContactEvents#OF_PAIR}. */
    public float hitSpeed() {
        return hitSpeed;
    }

    void setHitSpeed(float speed) {
        hitSpeed = speed;
    }

    /** The values of hits that are not complete, by {@link TouchingPairs#open}. */
    TouchRecords open() {
        return open;
    }

    long bytes() {
        return listed.bytes();
    }

    /** Forgets all pairs. */
    void clear() {
        pairs.clear();
        open.clear();
    }

    /** The types that are reported of two circles. */
    public int typesOfCircles(int id, int otherId) {
        return reported.isUniform() ? reported.types(0, 0) : reported.types(circles.kind(id), circles.kind(otherId));
    }

    /** The types that are reported of a pair: the one place that decides. */
    int typesOf(int lower, int higher) {
        if (Partner.isWall(higher)) {
            return Partner.hasWall(arena, higher) ? reported.wallTypes(circles.kind(lower)) : 0;
        }
        if (Partner.isPiece(higher)) {
            return reported.isUniform()
                    ? reported.types(0, 0)
                    : reported.types(circles.kind(lower), pieces.kind(Partner.piece(higher)));
        }
        return typesOfCircles(lower, higher);
    }

    /** Forgets the pairs that are not reported any more. */
    void forgetUnreported() {
        pairs.numbering++;
        for (int pair = pairs.count - 1; pair >= 0; pair--) {
            if (typesOf(pairs.lower(pair), pairs.higher(pair)) == 0) {
                pairs.remove(pair);
            }
        }
    }

    /** Makes room for the events of pairs that {@link #endRemoved} and {@link #endGone} end. */
    void makeRoomForEnds() {
        int ends = 0;
        for (int pair = 0; pair < pairs.count; pair++) {
            ends += isOfRemoved(pair) || isOfGone(pair) ? 1 : 0;
        }
        step.ensure(step.count + 2 * ends);
    }

    /** Ends the pairs of circles that the batch of commands has removed so far. */
    void endRemoved() {
        for (int pair = pairs.count - 1; pair >= 0; pair--) {
            if (isOfRemoved(pair)) {
                end(pair, EventRow.LATE_HIT, EventRow.LATE_END);
            }
        }
    }

    private boolean isOfRemoved(int pair) {
        int higher = pairs.higher(pair);
        return circles.isRemoved(pairs.lower(pair)) || Partner.isCircle(higher) && circles.isRemoved(higher);
    }

    /** Ends the pairs of pieces that are no more. */
    void endGone() {
        for (int pair = pairs.count - 1; pair >= 0; pair--) {
            if (isOfGone(pair)) {
                end(pair, EventRow.LATE_HIT, EventRow.LATE_END);
            }
        }
    }

    private boolean isOfGone(int pair) {
        int higher = pairs.higher(pair);
        return Partner.isPiece(higher) && pieces.isGone(Partner.piece(higher));
    }

    /**
     * Tells of a pair, by {@link ContactEvents#find}, that is in touch or near enough to stay so, and returns whether {@link ContactEvents#endStep} needs a
     * record. Several threads may call this at once, of different pairs. The threshold is the square of the speed that a hit must
     * exceed, unless the caller has set a speed.
     */
    public boolean concerns(
            int pair, int lower, int higher, boolean touches, float approach, float impulse, float threshold) {
        if (pair == TouchingPairs.NONE) {
            return touches && typesOf(lower, higher) != 0;
        }
        if (reported.dependsOnKinds() && typesOf(lower, higher) == 0) {
            return false; // a kind has changed: it ends, and nobody is told
        }
        stamp(pair);
        return pairs.open(pair) != TouchingPairs.NONE || isHit(approach, impulse, threshold);
    }

    /** Tells that a pair still touches. Several threads may call this at once, of different pairs. */
    public void stamp(int pair) {
        pairs.stamp(pair, now);
    }

    /** Whether a touch is a hit; threshold as in {@link #concerns}. */
    public boolean isHit(float approach, float impulse, float threshold) {
        return TouchRule.isHit(approach, impulse, threshold, hitSpeed);
    }

    /** Whether a pair approaches fast enough for a hit; the threshold as in {@link #isHit}. */
    public boolean isHitSpeed(float approach, float threshold) {
        return TouchRule.isHitSpeed(approach, threshold, hitSpeed);
    }

    /**
     * Whether records do not tell of every pair of circles that touched. Then {@link #stamp} has to be called for each pair that still
     * does, before {@link ContactEvents#endStep}; {@link #concerns} calls it.
     */
    public boolean misses(TouchRecords... records) {
        int told = 0;
        for (TouchRecords list : records) {
            told += list.told();
        }
        return told + kept != pairs.count - pairs.others;
    }

    /** Before {@link #misses}: pairs that rest go on to touch, though no step finds them. */
    public void keep(ContactEvents.Sleepers sleepers) {
        for (int pair = 0; pair < pairs.count; pair++) {
            int higher = pairs.higher(pair);
            boolean isCircle = Partner.isCircle(higher);
            if (isCircle ? sleepers.rest(pairs.lower(pair), higher) : sleepers.sleeps(pairs.lower(pair))) {
                pairs.stamp(pair, now);
                kept += isCircle ? 1 : 0;
                if (pairs.open(pair) != TouchingPairs.NONE) {
                    keptOpen = keptOpen.length > keptOpenCount
                            ? keptOpen
                            : Arrays.copyOf(keptOpen, 2 * keptOpenCount + 16);
                    keptOpen[keptOpenCount++] = pair;
                }
            }
        }
    }

    void endStep(TouchRecords... records) {
        boolean misses = misses(records);
        boolean ends = misses || pairs.others > 0;
        stillOpen.clear();
        for (int k = 0; k < keptOpenCount; k++) {
            pairs.setOpen(keptOpen[k], stillOpen.add(open, pairs.open(keptOpen[k])));
        }
        kept = 0;
        keptOpenCount = 0;
        for (TouchRecords list : records) {
            for (int k = 0; k < list.endedCount(); k++) {
                pairs.stamp(list.ended(k), TouchingPairs.ENDED);
                ends = true;
            }
        }
        for (TouchRecords list : records) {
            for (int r = 0; r < list.count; r++) {
                if (arena.wraps()) {
                    list.bringInside(r, arena);
                }
                take(list, r);
            }
        }
        if (ends) {
            end(misses);
        }
        TouchRecords complete = open;
        open = stillOpen;
        stillOpen = complete;
        if (now == Integer.MAX_VALUE) {
            pairs.stampAll(TouchingPairs.NEVER);
            now = FIRST_STAMP;
        } else {
            now++;
        }
    }

    /** Ends the pairs that touch no more; misses if some may have ended of which nobody has told. */
    private void end(boolean misses) {
        for (int pair = pairs.count - 1; pair >= 0; pair--) {
            int stamp = pairs.stamp(pair);
            if (misses || !Partner.isCircle(pairs.higher(pair)) ? stamp != now : stamp == TouchingPairs.ENDED) {
                end(pair, EventRow.HIT, EventRow.END);
            }
        }
    }

    /** Ends a pair by events of such ranks. */
    private void end(int pair, int hit, int end) {
        addOpenHit(pair, hit);
        add(pair, end);
        pairs.remove(pair);
    }

    private void take(TouchRecords list, int r) {
        int lower = list.lower(r);
        int higher = list.higher(r);
        int pair = list.pair(r);
        if (pair == TouchingPairs.NONE) {
            pair = pairs.add(lower, higher, circles.handle(lower), pieces.handleOfPartner(higher));
            pairs.stamp(pair, now);
            add(pair, EventRow.BEGIN, list, r);
        }
        boolean goesOn = pairs.open(pair) != TouchingPairs.NONE;
        boolean isHit = isHit(list.approach(r), list.impulse(r), list.threshold(r));
        if (goesOn) {
            list.addTo(r, open, pairs.open(pair));
            addOpenHit(pair, EventRow.HIT);
            pairs.setOpen(pair, TouchingPairs.NONE);
        } else if (isHit && TouchRule.isIncomplete(list.vn(r), list.approach(r))) {
            pairs.setOpen(pair, stillOpen.add(list, r));
        } else if (isHit) {
            add(pair, EventRow.HIT, list, r);
        }
        list.setPair(r, pairs.open(pair) == TouchingPairs.NONE ? pair : ContactEvents.going(pair));
    }

    private void addOpenHit(int pair, int rank) {
        if (pairs.open(pair) != TouchingPairs.NONE) {
            add(pair, rank, open, pairs.open(pair));
        }
    }

    private void add(int pair, int rank, TouchRecords list, int r) {
        int row = add(pair, rank);
        if (row >= 0) {
            list.copy(r, step, row);
        }
    }

    /** Adds an event without values, and returns its row, or -1 if it is not reported. */
    private int add(int pair, int rank) {
        int lower = pairs.lower(pair);
        int higher = pairs.higher(pair);
        if ((typesOf(lower, higher) & EventRow.type(rank)) == 0) {
            return -1;
        }
        return step.add(lower, higher, rank, pairs.a[pair], pairs.b[pair]);
    }

    // ---- lists of pairs

    /** See {@link ContactEvents#list}. */
    int list(int kindA, int kindB, long[] handles) {
        listed.clear();
        for (int pair = 0; pair < pairs.count; pair++) {
            int lower = pairs.lower(pair);
            int higher = pairs.higher(pair);
            if (Partner.isCircle(higher) && typesOf(lower, higher) != 0) {
                int ofLower = circles.kind(lower);
                int ofHigher = circles.kind(higher);
                if (ofLower == kindA && ofHigher == kindB) {
                    listed.add(lower, higher, 0, pairs.a[pair], pairs.b[pair]);
                } else if (ofLower == kindB && ofHigher == kindA) {
                    listed.add(lower, higher, 0, pairs.b[pair], pairs.a[pair]);
                }
            }
        }
        return writeListed(handles);
    }

    /** See {@link ContactEvents#listPieces}. */
    int listPieces(int kind, int kindOfPieces, long[] handles) {
        listed.clear();
        for (int pair = 0; pair < pairs.count; pair++) {
            int lower = pairs.lower(pair);
            int higher = pairs.higher(pair);
            if (Partner.isPiece(higher)
                    && circles.kind(lower) == kind
                    && pieces.kind(Partner.piece(higher)) == kindOfPieces
                    && typesOf(lower, higher) != 0) {
                listed.add(lower, higher, 0, pairs.a[pair], pairs.b[pair]);
            }
        }
        return writeListed(handles);
    }

    private int writeListed(long[] handles) {
        listed.sort();
        for (int k = 0; k < Math.min(listed.count, handles.length / 2); k++) {
            int row = listed.ordered(k);
            handles[2 * k] = listed.a(row);
            handles[2 * k + 1] = listed.partner(row);
        }
        return listed.count;
    }

    // ---- snapshots

    /** Saves what the next events depend on: pairs, hits that are not complete, and late events. */
    void save(SavedTouches into) {
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
    void load(SavedTouches from) {
        int nextOpen = 0;
        for (int k = 0; k < from.pairs; k++) {
            int lower = (int) (from.pair[k] >>> Integer.SIZE);
            int higher = (int) from.pair[k];
            boolean isOpen = nextOpen < from.open && from.openPair[nextOpen] == k;
            if (reported.mayReport(Partner.isWall(higher), ContactEvents.OF_PAIR_TYPES)) {
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
        int higher = Partner.of(b, side);
        if (reported.mayReport(Partner.isWall(higher), type)) {
            int rank = type == ContactEvents.HIT ? EventRow.LATE_HIT : EventRow.LATE_END;
            int row = step.add((int) a, higher, rank, a, b);
            step.setValues(row, from.lateValues, SavedTouches.VALUES * k);
        }
    }
}
