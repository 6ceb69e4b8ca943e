package io.github.circles2d.world.events;

import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.circles.KindTable;
import io.github.circles2d.world.circles.SavedTouches;
import io.github.circles2d.world.model.AxisEdge;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.model.PairTable;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.TouchRule;
import java.util.Arrays;

/**
 * Makes the events of contacts: pairs begin to touch, hit each other, and end to touch. It holds the pairs that touch. A pipeline
 * tells it after each step of the pairs that touch then, {@link #concerns}, and hands over the records of those that something
 * happened to, {@link #endStep}. A pair that it does not hear of has ended. So a pile at rest has no records.
 *
 * <p>A wall is the partner of a circle too, under a code above all ids.
 */
public final class ContactEvents {
    /** Type: a pair begins to touch. */
    public static final int BEGIN = 1;

    /** Type: a pair hits each other. */
    public static final int HIT = SavedTouches.HIT;

    /** Type: a pair ends to touch. */
    public static final int END = SavedTouches.END;

    /** Not a type: walls are reported too. */
    public static final int WALL = 8;

    /** All that can be reported of a pair. */
    public static final int OF_PAIR_TYPES = BEGIN | HIT | END;

    /** All that can be reported. */
    public static final int ALL = OF_PAIR_TYPES | WALL;

    /** The hit speed if none is set: that of the pair, from which on impacts bounce. */
    public static final float OF_PAIR = -1f;

    private static final int NO_SIDE = -1;
    private static final int NOT_REQUESTED = -1;

    // The order of a step's events: lower id, higher id, rank. Late events are those of a circle that has been removed.
    private static final int LATE_HIT = 0;
    private static final int LATE_END = 1;
    private static final int RANK_OF_BEGIN = 2;
    private static final int RANK_OF_HIT = 3;
    private static final int RANK_OF_END = 4;
    private static final int RANK_BITS = 3;
    private static final int ID_BITS = 28;

    private static final int KIND_BITS = PairTable.KINDS - 1;
    private static final int FIELD_OF_KIND = CircleField.OF_STEPS.indexOf(CircleField.KIND);

    private final TouchingPairs pairs = new TouchingPairs();
    private final ReportTable reported = new ReportTable();

    /** Events of the step to come, in no order: at first those of removed circles. */
    private final EventRows step = new EventRows();

    private EventRows events = new EventRows();
    private EventRows taken = new EventRows();

    /** Hits that were not complete after the last step, and those after this one. */
    private TouchRecords open = new TouchRecords();

    private TouchRecords stillOpen = new TouchRecords();

    /** By id: the handle as of the last step, which the table of handles may be ahead of. */
    private long[] handleOf = new long[0];

    /** By id: the kind, as of the last commands, which the table of handles may be ahead of too. */
    private byte[] kindOf = new byte[0];

    /** By id: the last batch of commands that removed its circle. */
    private int[] removedIn = new int[0];

    private int batch;
    private Bounds arena = new Bounds(0, 0, 1, 1);

    private float hitSpeed = OF_PAIR;

    /** The stamp of the step that is being looked at. */
    private int now = 1;

    /** Whether the next step has to tell of every pair in touch, since some are not as it left them. */
    private boolean wantsAll = true;

    /** Steps since events were taken last: those of which there are events, those that have been asked for, and of these those of a request. */
    private int steps;

    private int asked;
    private int requested = NOT_REQUESTED;

    /** What {@link #list} has found. */
    private final EventRows listed = new EventRows();

    /** Nothing is reported. */
    public ContactEvents() {}

    /** The code of a wall: axis 0 or 1, side 1 for the lower wall and -1 for the upper. */
    public static int wall(int axis, float side) {
        return Limits.CIRCLES + 2 * axis + (side > 0f ? 0 : 1);
    }

    /** Whether a partner is a wall. */
    private static boolean isWall(int higher) {
        return higher >= Limits.CIRCLES;
    }

    /** Whether an int is the code of a wall. */
    public static boolean isWallCode(int code) {
        return code >= Limits.CIRCLES && code < Limits.CIRCLES + 4;
    }

    // ---- what is reported
    // --------------------------------------------------------------------------------------------

    /** Whether anything is reported. */
    public boolean isOn() {
        return reported.isOn();
    }

    /** Whether there is a wall: circles that come to the end of coordinates, on an axis without walls, are not reported. */
    private boolean hasWall(int code) {
        return (code - Limits.CIRCLES < 2 ? arena.edgeX() : arena.edgeY()) == AxisEdge.WALL;
    }

    /** The arena of the last step. */
    Bounds arena() {
        return arena;
    }

    /** Sets the arena of the steps to come. */
    public void setArena(Bounds bounds) {
        arena = bounds;
    }

    /** Whether walls are reported. */
    public boolean hasWalls() {
        return reported.hasWalls();
    }

    /** Whether something is reported of every pair of circles. */
    public boolean hasAllPairs() {
        return reported.isUniform() && reported.types(0, 0) != 0;
    }

    /** The types that are reported of two circles. */
    public int typesOfCircles(int id, int otherId) {
        return reported.isUniform()
                ? reported.types(0, 0)
                : reported.types(kindOf[id] & KIND_BITS, kindOf[otherId] & KIND_BITS);
    }

    /** The types that are reported of a pair: the one place that decides. */
    private int typesOf(int lower, int higher) {
        if (isWall(higher)) {
            return hasWall(higher) ? reported.wallTypes(kindOf[lower] & KIND_BITS) : 0;
        }
        return typesOfCircles(lower, higher);
    }

    /** Tells a step what of it is reported. */
    public void prepare(KindTable kinds, StepConstants step) {
        reported.resolve(kinds);
        boolean records = reported.solids() || reported.hasWalls();
        step.setReports(records, reported.senses(), reported.seeking(), reported.seekingVersion());
    }

    /** Makes room for {@link #report}. */
    public void makeRoom(HandleTable handles) {
        ensureIds(handles.end());
    }

    /** Makes room for {@link #reportPair}. */
    public void makeRoomForPairs(HandleTable handles) {
        ensureIds(handles.end());
        reported.makeRoom();
    }

    /**
     * Sets what is reported of all pairs. Pairs that are not reported any more are forgotten; those that are from now on begin if they
     * touch.
     *
     * @param handles as of now; all changes have been applied
     */
    public void report(int types, HandleTable handles) {
        boolean was = isOn();
        reported.set(types);
        changed(was, handles);
    }

    /** Sets what is reported of two kinds. */
    public void reportPair(int kindA, int kindB, int types, HandleTable handles) {
        boolean was = isOn();
        reported.set(kindA, kindB, types);
        changed(was, handles);
    }

    /** Sets what is reported of a kind and walls. */
    public void reportWalls(int kind, int types, HandleTable handles) {
        boolean was = isOn();
        reported.setWalls(kind, types);
        changed(was, handles);
    }

    private void changed(boolean was, HandleTable handles) {
        wantsAll = true;
        if (!isOn()) {
            pairs.clear();
            step.clear();
            open.clear();
        } else if (!was) {
            readHandles(handles);
        }
        for (int pair = pairs.count - 1; pair >= 0; pair--) {
            if (typesOf(pairs.lower(pair), pairs.higher(pair)) == 0) {
                pairs.remove(pair);
            }
        }
        for (int late = step.count - 1; late >= 0; late--) {
            if (!mayReport(step.side(late) != NO_SIDE, step.type(late))) {
                step.remove(late);
            }
        }
    }

    private void readHandles(HandleTable handles) {
        for (int id = 0; id < handles.end(); id++) {
            handleOf[id] = handles.lives(id) ? handles.handle(id) : 0;
            kindOf[id] = (byte) handles.fields().getInt(CircleField.KIND, id);
        }
    }

    /** Sets the speed from which on a hit counts. */
    public void setHitSpeed(float speed) {
        hitSpeed = speed;
    }

    /** The speed from which on a hit counts, or {@link #OF_PAIR}. */
    public float hitSpeed() {
        return hitSpeed;
    }

    // ---- circles come and go
    // -----------------------------------------------------------------------------------------

    private void ensureIds(int ids) {
        pairs.ensureIds(ids);
        if (ids > handleOf.length) {
            int c = Math.max(ids, handleOf.length + (handleOf.length >> 1));
            removedIn = Arrays.copyOf(removedIn, c);
            kindOf = Arrays.copyOf(kindOf, c);
            handleOf = Arrays.copyOf(handleOf, c);
        }
    }

    /** Makes room for commands, so that {@link #apply} does not run out of memory. */
    public void makeRoom(Commands commands) {
        int ids = 0;
        for (int c = 0; c < commands.count(); c++) {
            ids = Math.max(ids, commands.id(c) + 1);
        }
        ensureIds(ids);
        if (markRemoved(commands)) {
            int ends = 0;
            for (int pair = 0; pair < pairs.count; pair++) {
                ends += isOfRemoved(pair) ? 1 : 0;
            }
            step.ensure(step.count + 2 * ends);
        }
    }

    /** Ends the pairs of circles that commands remove, and learns the handles of new ones, and kinds. */
    public void apply(Commands commands, HandleTable handles) {
        batch++;
        boolean waiting = false;
        for (int c = 0; c < commands.count(); c++) {
            int id = commands.id(c);
            if (commands.operation(c) == Commands.REMOVE) {
                removedIn[id] = batch;
                waiting = true;
            } else if (commands.operation(c) == Commands.ADD && removedIn[id] != batch) {
                removedIn[id] = -batch; // it has no pairs yet
            } else if (isKind(commands, c) && Math.abs(removedIn[id]) != batch) {
                // An end is reported by the kinds that both circles have when one of them is removed.
                if (waiting && reported.dependsOnKinds()) {
                    endRemoved();
                    waiting = false;
                }
                kindOf[id] = (byte) commands.second(c);
                wantsAll |= reported.dependsOnKinds();
            }
        }
        if (waiting) {
            endRemoved();
        }
        for (int c = 0; c < commands.count(); c++) {
            int id = commands.id(c);
            if (commands.operation(c) == Commands.ADD) {
                handleOf[id] = handles.handle(id);
                kindOf[id] = 0;
            } else if (isKind(commands, c)) {
                kindOf[id] = (byte) commands.second(c);
            }
        }
    }

    private static boolean isKind(Commands commands, int c) {
        return commands.operation(c) == Commands.FIELD && commands.first(c) == FIELD_OF_KIND;
    }

    private void endRemoved() {
        for (int pair = pairs.count - 1; pair >= 0; pair--) {
            if (isOfRemoved(pair)) {
                addOpenHit(pair, LATE_HIT);
                add(pair, END, LATE_END);
                pairs.remove(pair);
            }
        }
    }

    private boolean markRemoved(Commands commands) {
        batch++;
        boolean some = false;
        for (int c = 0; c < commands.count(); c++) {
            if (commands.operation(c) == Commands.REMOVE) {
                removedIn[commands.id(c)] = batch;
                some = true;
            }
        }
        return some;
    }

    private boolean isOfRemoved(int pair) {
        int higher = pairs.higher(pair);
        return removedIn[pairs.lower(pair)] == batch || !isWall(higher) && removedIn[higher] == batch;
    }

    // ---- a step
    // ------------------------------------------------------------------------------------------------------

    /**
     * Tells of a pair that is in touch, or near enough to stay so. Several threads may call this at once, of different pairs.
     *
     * @param touches whether it touches even if it did not before
     * @param threshold square of the speed that a hit must exceed, unless the caller has set a speed
     * @return whether {@link #endStep} needs a record of it
     */
    public boolean concerns(int lower, int higher, boolean touches, float approach, float impulse, float threshold) {
        int pair = pairs.find(lower, higher);
        if (pair == TouchingPairs.NONE) {
            return touches && typesOf(lower, higher) != 0;
        }
        if (reported.dependsOnKinds() && typesOf(lower, higher) == 0) {
            return false; // a kind has changed: it ends, and nobody is told
        }
        pairs.stamp(pair, now);
        return pairs.open(pair) != TouchingPairs.NONE || isHit(approach, impulse, threshold);
    }

    private boolean isHit(float approach, float impulse, float threshold) {
        return impulse > 0f && (hitSpeed >= 0f ? approach >= hitSpeed : approach * approach > threshold);
    }

    /** Whether the next step has to tell of every pair in touch, also of those that {@link #hold}. */
    public boolean wantsAll() {
        return wantsAll;
    }

    /** Takes note that a step ends with a pair that will be told of when it parts. */
    public void hold(int lower, int higher) {
        int pair = pairs.find(lower, higher);
        if (pair != TouchingPairs.NONE) {
            pairs.hold(pair);
        }
    }

    /** Tells of a pair that was to be told of when it parts. */
    public void part(int lower, int higher) {
        int pair = pairs.find(lower, higher);
        if (pair != TouchingPairs.NONE) {
            pairs.stamp(pair, TouchingPairs.NEVER);
        }
    }

    /**
     * Ends a step that has told of every pair in touch.
     *
     * @param records those that {@link #concerns} asked for, in any order
     */
    public void endStep(TouchRecords... records) {
        endStep(true, records);
    }

    /**
     * Ends a step.
     *
     * @param all whether it has told of every pair in touch; else of those that hold only if something happened to them
     * @param records those that {@link #concerns} asked for, in any order
     */
    public void endStep(boolean all, TouchRecords... records) {
        wantsAll = false;
        stillOpen.clear();
        for (TouchRecords list : records) {
            for (int r = 0; r < list.count; r++) {
                if (arena.wraps()) {
                    list.bringInside(r, arena);
                }
                take(list, r);
            }
        }
        for (int pair = pairs.count - 1; pair >= 0; pair--) {
            if (pairs.stamp(pair) != now && (all || !pairs.holds(pair))) {
                addOpenHit(pair, RANK_OF_HIT);
                add(pair, END, RANK_OF_END);
                pairs.remove(pair);
            }
        }
        TouchRecords complete = open;
        open = stillOpen;
        stillOpen = complete;
        now++;
        publish(1);
    }

    /** Makes steps without circles. */
    public void emptySteps(int count) {
        publish(count);
    }

    private void publish(int count) {
        events.addInOrder(step, steps);
        step.clear();
        steps += count;
    }

    private void take(TouchRecords list, int r) {
        int lower = list.lower(r);
        int higher = list.higher(r);
        int pair = pairs.find(lower, higher);
        if (pair == TouchingPairs.NONE) {
            pair = pairs.add(lower, higher, handleOf[lower], isWall(higher) ? 0 : handleOf[higher]);
            pairs.stamp(pair, now);
            add(pair, BEGIN, RANK_OF_BEGIN, list, r);
        }
        boolean goesOn = pairs.open(pair) != TouchingPairs.NONE;
        boolean isHit = isHit(list.approach(r), list.impulse(r), list.threshold(r));
        if (goesOn) {
            list.addTo(r, open, pairs.open(pair));
            addOpenHit(pair, RANK_OF_HIT);
            pairs.setOpen(pair, TouchingPairs.NONE);
        } else if (isHit && TouchRule.isIncomplete(list.vn(r), list.approach(r))) {
            pairs.setOpen(pair, stillOpen.add(list, r));
        } else if (isHit) {
            add(pair, HIT, RANK_OF_HIT, list, r);
        }
    }

    private void addOpenHit(int pair, int rank) {
        if (pairs.open(pair) != TouchingPairs.NONE) {
            add(pair, HIT, rank, open, pairs.open(pair));
        }
    }

    private void add(int pair, int type, int rank, TouchRecords list, int r) {
        int at = add(pair, type, rank);
        if (at >= 0) {
            list.copy(r, step.values, at);
        }
    }

    /** Adds an event without values, and returns where they begin, or -1 if it is not reported. */
    private int add(int pair, int type, int rank) {
        int lower = pairs.lower(pair);
        int higher = pairs.higher(pair);
        if ((typesOf(lower, higher) & type) == 0) {
            return -1;
        }
        int side = isWall(higher) ? higher - Limits.CIRCLES : NO_SIDE;
        return step.add(key(lower, higher, rank), type, pairs.a[pair], pairs.b[pair], side);
    }

    private static long key(int lower, int higher, int rank) {
        return ((long) lower << ID_BITS | higher) << RANK_BITS | rank;
    }

    // ---- for the caller
    // ----------------------------------------------------------------------------------------------

    /** Takes note that steps have been asked for, of which there will be events. */
    public void asked(int count) {
        asked += count;
    }

    /** The events of all steps since events were taken last. They stay as they are until the next call; no request is left. */
    public EventRows take() {
        EventRows next = taken;
        taken = events;
        events = next;
        events.clear();
        steps = 0;
        asked = 0;
        requested = NOT_REQUESTED;
        return taken;
    }

    /** Requests the events of the steps that have been asked for. */
    public void request() {
        requested = asked;
    }

    /** Whether events have been requested and not been taken. */
    public boolean isRequested() {
        return requested != NOT_REQUESTED;
    }

    /** Whether there are the events of all steps of the request. */
    public boolean haveArrived() {
        return steps >= requested;
    }

    /** The events of the request, which have arrived. They stay as they are until events are taken again. */
    public EventRows takeRequested() {
        int ofRequest = requested;
        int stepsNow = steps;
        int askedNow = asked;
        EventRows all = take();
        steps = stepsNow - ofRequest;
        asked = askedNow - ofRequest;
        all.moveFrom(ofRequest, events);
        return all;
    }

    /**
     * Lists the pairs of two kinds that touched in the last step, in the order of the lower and the higher id.
     *
     * @param handles takes two a pair, of each kind one; of one kind, the one of lower id first. Only the first ones if it is too short
     * @return how many pairs there are
     */
    public int list(int kindA, int kindB, long[] handles) {
        listed.clear();
        for (int pair = 0; pair < pairs.count; pair++) {
            int lower = pairs.lower(pair);
            int higher = pairs.higher(pair);
            if (!isWall(higher) && typesOf(lower, higher) != 0) {
                int ofLower = kindOf[lower] & KIND_BITS;
                int ofHigher = kindOf[higher] & KIND_BITS;
                if (ofLower == kindA && ofHigher == kindB) {
                    listed.add(key(lower, higher, 0), 0, pairs.a[pair], pairs.b[pair], NO_SIDE);
                } else if (ofLower == kindB && ofHigher == kindA) {
                    listed.add(key(lower, higher, 0), 0, pairs.b[pair], pairs.a[pair], NO_SIDE);
                }
            }
        }
        listed.sort();
        for (int k = 0; k < Math.min(listed.count, handles.length / 2); k++) {
            int row = listed.ordered(k);
            handles[2 * k] = listed.a(row);
            handles[2 * k + 1] = listed.b(row);
        }
        return listed.count;
    }

    /** Memory of the arrays. */
    public long bytes() {
        return events.bytes()
                + taken.bytes()
                + step.bytes()
                + listed.bytes()
                + 13L * handleOf.length
                + pairs.bytes()
                + reported.bytes();
    }

    // ---- snapshots
    // ---------------------------------------------------------------------------------------------------

    /** Saves what the next events depend on; nothing if nothing is reported. */
    public void save(SavedTouches into) {
        into.clear();
        if (!isOn()) {
            return;
        }
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
            int row = step.ordered(k);
            into.lateHandles[2 * k] = step.a(row);
            into.lateHandles[2 * k + 1] = step.b(row);
            into.lateInts[SavedTouches.LATE_INTS * k] = step.type(row);
            into.lateInts[SavedTouches.LATE_INTS * k + 1] = step.side(row);
            System.arraycopy(
                    step.values,
                    SavedTouches.VALUES * row,
                    into.lateValues,
                    SavedTouches.VALUES * k,
                    SavedTouches.VALUES);
        }
        into.late = step.count;
    }

    /** Makes room for a saved state, so that {@link #load} does not run out of memory. */
    public void makeRoom(SavedTouches from, int ids) {
        if (isOn()) {
            ensureIds(ids);
            pairs.ensure(from.pairs);
            step.ensure(from.late);
        }
    }

    /**
     * Takes over a saved state. Events that have not been taken are of a time that is no more, and are dropped.
     *
     * @param from the state, for which there is room
     * @param handles those of the state
     */
    public void load(SavedTouches from, HandleTable handles) {
        wantsAll = true;
        events.clear();
        steps = 0;
        asked = 0;
        requested = Math.min(requested, 0);
        pairs.clear();
        step.clear();
        open.clear();
        if (!isOn()) {
            return;
        }
        readHandles(handles);
        int nextOpen = 0;
        for (int k = 0; k < from.pairs; k++) {
            int lower = (int) (from.pair[k] >>> Integer.SIZE);
            int higher = (int) from.pair[k];
            boolean isOpen = nextOpen < from.open && from.openPair[nextOpen] == k;
            if (mayReport(isWall(higher), OF_PAIR_TYPES)) {
                int pair = pairs.add(lower, higher, handleOf[lower], isWall(higher) ? 0 : handleOf[higher]);
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

    /**
     * Whether a saved pair, or a late event, may still be reported. If kinds decide it may be: they may change until the next step,
     * which forgets the pairs that are not, and the kind of a removed circle is not known any more.
     */
    private boolean mayReport(boolean ofWall, int types) {
        int now = ofWall ? reported.wallTypes(0) : reported.types(0, 0);
        return reported.dependsOnKinds() || (now & types) != 0;
    }

    private void loadLate(SavedTouches from, int k) {
        int type = from.lateInts[SavedTouches.LATE_INTS * k];
        int side = from.lateInts[SavedTouches.LATE_INTS * k + 1];
        long a = from.lateHandles[2 * k];
        long b = from.lateHandles[2 * k + 1];
        int lower = (int) a;
        int higher = side == NO_SIDE ? (int) b : Limits.CIRCLES + side;
        if (mayReport(side != NO_SIDE, type)) {
            int at = step.add(key(lower, higher, type == HIT ? LATE_HIT : LATE_END), type, a, b, side);
            System.arraycopy(from.lateValues, SavedTouches.VALUES * k, step.values, at, SavedTouches.VALUES);
        }
    }
}
