package io.github.circles2d.world.events;

import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.circles.KindTable;
import io.github.circles2d.world.circles.SavedTouches;
import io.github.circles2d.world.model.AxisEdge;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.TouchRule;

/**
 * Makes the events of contacts: pairs begin to touch, hit each other, and end to touch. It holds the pairs that touch. A pipeline
 * tells it after each step of the pairs that touch then, {@link #concerns}, and hands over the records of those that something
 * happened to, {@link #endStep}. A pair that it does not hear of has ended. So a pile at rest has no records.
 *
 * <p>{@link EventQueue} keeps events until they are taken, {@link KnownCircles} has handles and kinds, {@link TouchSnapshots} saves and
 * restores, and {@link TouchingList} lists pairs.
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

    private static final int FIRST_STAMP = 1;

    private final TouchingPairs pairs = new TouchingPairs();
    private final ReportTable reported = new ReportTable();
    private final KnownCircles circles = new KnownCircles();

    /** Events of the step to come, in no order: at first those of removed circles. */
    private final EventRows step = new EventRows();

    private final EventQueue queue = new EventQueue();
    private final TouchingList touching = new TouchingList(this, pairs, circles);
    private final TouchSnapshots snapshots = new TouchSnapshots(pairs, step, reported, circles);

    /** Hits that were not complete after the last step, and those after this one. */
    private TouchRecords open = new TouchRecords();

    private TouchRecords stillOpen = new TouchRecords();

    private Bounds arena = new Bounds(0, 0, 1, 1);

    private float hitSpeed = OF_PAIR;

    /** The stamp of the step that is being looked at: another than that of the step before. */
    private int now;

    /** Whether the next step has to tell of every pair in touch, since some are not as it left them. */
    private boolean wantsAll = true;

    /** Nothing is reported. */
    public ContactEvents() {
        this(FIRST_STAMP);
    }

    /** As if many steps had been made. */
    ContactEvents(int stamp) {
        now = stamp;
    }

    /** The code of a wall: axis 0 or 1, side 1 for the lower wall and -1 for the upper. */
    public static int wall(int axis, float side) {
        return Limits.CIRCLES + 2 * axis + (side > 0f ? 0 : 1);
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
        return reported.isUniform() ? reported.types(0, 0) : reported.types(circles.kind(id), circles.kind(otherId));
    }

    /** The types that are reported of a pair: the one place that decides. */
    int typesOf(int lower, int higher) {
        if (EventOrder.isWall(higher)) {
            return hasWall(higher) ? reported.wallTypes(circles.kind(lower)) : 0;
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
            circles.read(handles);
        }
        for (int pair = pairs.count - 1; pair >= 0; pair--) {
            if (typesOf(pairs.lower(pair), pairs.higher(pair)) == 0) {
                pairs.remove(pair);
            }
        }
        for (int late = step.count - 1; late >= 0; late--) {
            if (!reported.mayReport(step.side(late) != EventOrder.NO_SIDE, step.type(late))) {
                step.remove(late);
            }
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
        circles.ensure(ids);
    }

    /** Makes room for commands, so that {@link #apply} does not run out of memory. */
    public void makeRoom(Commands commands) {
        int ids = 0;
        for (int c = 0; c < commands.count(); c++) {
            ids = Math.max(ids, commands.id(c) + 1);
        }
        ensureIds(ids);
        if (circles.markRemoved(commands)) {
            int ends = 0;
            for (int pair = 0; pair < pairs.count; pair++) {
                ends += isOfRemoved(pair) ? 1 : 0;
            }
            step.ensure(step.count + 2 * ends);
        }
    }

    /** Ends the pairs of circles that commands remove, and learns the handles of new ones, and kinds. */
    public void apply(Commands commands, HandleTable handles) {
        circles.beginBatch();
        boolean waiting = false;
        for (int c = 0; c < commands.count(); c++) {
            int id = commands.id(c);
            if (commands.operation(c) == Commands.REMOVE) {
                circles.remove(id);
                waiting = true;
            } else if (commands.operation(c) == Commands.ADD) {
                circles.add(id); // it has no pairs yet
            } else if (KnownCircles.isKind(commands, c) && circles.hasStayed(id)) {
                // An end is reported by the kinds that both circles have when one of them is removed.
                if (waiting && reported.dependsOnKinds()) {
                    endRemoved();
                    waiting = false;
                }
                circles.setKind(id, commands.second(c));
                wantsAll |= reported.dependsOnKinds();
            }
        }
        if (waiting) {
            endRemoved();
        }
        circles.learn(commands, handles);
    }

    private void endRemoved() {
        for (int pair = pairs.count - 1; pair >= 0; pair--) {
            if (isOfRemoved(pair)) {
                addOpenHit(pair, EventOrder.LATE_HIT);
                add(pair, END, EventOrder.LATE_END);
                pairs.remove(pair);
            }
        }
    }

    private boolean isOfRemoved(int pair) {
        int higher = pairs.higher(pair);
        return circles.isRemoved(pairs.lower(pair)) || !EventOrder.isWall(higher) && circles.isRemoved(higher);
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
                addOpenHit(pair, EventOrder.HIT);
                add(pair, END, EventOrder.END);
                pairs.remove(pair);
            }
        }
        TouchRecords complete = open;
        open = stillOpen;
        stillOpen = complete;
        now = now == Integer.MAX_VALUE ? FIRST_STAMP : now + 1;
        publish(1);
    }

    /** Makes steps without circles. */
    public void emptySteps(int count) {
        publish(count);
    }

    private void publish(int count) {
        queue.publish(step, count);
        step.clear();
    }

    private void take(TouchRecords list, int r) {
        int lower = list.lower(r);
        int higher = list.higher(r);
        int pair = pairs.find(lower, higher);
        if (pair == TouchingPairs.NONE) {
            pair = pairs.add(
                    lower, higher, circles.handle(lower), EventOrder.isWall(higher) ? 0 : circles.handle(higher));
            pairs.stamp(pair, now);
            add(pair, BEGIN, EventOrder.BEGIN, list, r);
        }
        boolean goesOn = pairs.open(pair) != TouchingPairs.NONE;
        boolean isHit = isHit(list.approach(r), list.impulse(r), list.threshold(r));
        if (goesOn) {
            list.addTo(r, open, pairs.open(pair));
            addOpenHit(pair, EventOrder.HIT);
            pairs.setOpen(pair, TouchingPairs.NONE);
        } else if (isHit && TouchRule.isIncomplete(list.vn(r), list.approach(r))) {
            pairs.setOpen(pair, stillOpen.add(list, r));
        } else if (isHit) {
            add(pair, HIT, EventOrder.HIT, list, r);
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
        long key = EventOrder.key(lower, higher, rank);
        return step.add(key, type, pairs.a[pair], pairs.b[pair], EventOrder.side(higher));
    }

    // ---- for the caller
    // ----------------------------------------------------------------------------------------------

    /** Takes note that steps have been asked for, of which there will be events. */
    public void asked(int count) {
        queue.asked(count);
    }

    /** The events of all steps since events were taken last. They stay as they are until the next call; no request is left. */
    public EventRows take() {
        return queue.take();
    }

    /** Requests the events of the steps that have been asked for. */
    public void request() {
        queue.request();
    }

    /** Whether events have been requested and not been taken. */
    public boolean isRequested() {
        return queue.isRequested();
    }

    /** Whether there are the events of all steps of the request. */
    public boolean haveArrived() {
        return queue.haveArrived();
    }

    /** The events of the request, which have arrived. They stay as they are until events are taken again. */
    public EventRows takeRequested() {
        return queue.takeRequested();
    }

    /**
     * Lists the pairs of two kinds that touched in the last step, in the order of the lower and the higher id.
     *
     * @param handles takes two a pair, of each kind one; of one kind, the one of lower id first. Only the first ones if it is too short
     * @return how many pairs there are
     */
    public int list(int kindA, int kindB, long[] handles) {
        return touching.list(kindA, kindB, handles);
    }

    /** Memory of the arrays. */
    public long bytes() {
        return queue.bytes() + step.bytes() + touching.bytes() + circles.bytes() + pairs.bytes() + reported.bytes();
    }

    // ---- snapshots
    // ---------------------------------------------------------------------------------------------------

    /** Saves what the next events depend on; nothing if nothing is reported. */
    public void save(SavedTouches into) {
        into.clear();
        if (isOn()) {
            snapshots.save(into, open);
        }
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
        queue.drop();
        pairs.clear();
        step.clear();
        open.clear();
        if (isOn()) {
            circles.read(handles);
            snapshots.load(from, open);
        }
    }
}
