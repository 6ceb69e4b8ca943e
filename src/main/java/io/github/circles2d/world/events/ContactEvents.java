package io.github.circles2d.world.events;

import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.circles.KindTable;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.StepReports;
import io.github.circles2d.world.terrain.PieceTable;
import java.nio.IntBuffer;

/**
 * Makes the events of contacts: pairs begin to touch, hit each other, and end to touch. It knows the pairs that touch, or a device
 * does, {@link Remote}. A pipeline in Java tells it of the pairs in touch, {@link TouchTracker#concerns} and {@link #endStep}; a device hands over
 * the events that it has decided, {@link #publishDecided}.
 *
 * <p>{@link TouchTracker} follows pairs, {@link EventQueue} keeps events until they are taken, and {@link
 * KnownCircles} and {@link KnownPieces} have handles and kinds. Walls and pieces of terrain are partners of circles, too ({@link Partner}).
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

    /** The number of no pair. */
    public static final int NONE = TouchingPairs.NONE;

    private final TouchingPairs pairs = new TouchingPairs();
    private final ReportTable reported = new ReportTable();
    private final KnownCircles circles = new KnownCircles();
    private final KnownPieces pieces = new KnownPieces(circles);

    /** Events of the step to come, in no order: at first those of removed circles. */
    private final EventRows step = new EventRows();

    private final EventQueue queue = new EventQueue();
    /** Follows the pairs that are here. */
    public final TouchTracker tracker;
    /** The pairs on a device that decides itself what a step reports of them; null if there is none. */
    private Remote remote;

    /** Whether all pairs are here; some are not while only a device knows them. */
    private boolean here = true;

    /** Whether all pairs are on the device, as they are here or as its last step left them. */
    private boolean there;

    /** The circles that the commands remove for which there is room, and whose pairs may be elsewhere. */
    private int[] removed = new int[0];

    private int removedCount;

    /** Nothing is reported. */
    public ContactEvents() {
        this(TouchTracker.FIRST_STAMP);
    }

    /** As if many steps had been made. */
    ContactEvents(int stamp) {
        tracker = new TouchTracker(reported, circles, pieces, pairs, step, stamp);
    }

    /** Who sleeps in a step. */
    public interface Sleepers {
        boolean sleeps(int id);

        /** Whether two circles do not move: one sleeps, and the other one sleeps or is static. */
        boolean rest(int id, int otherId);
    }

    /** The pairs that touch, on a device that decides itself what a step reports of them. */
    public interface Remote {
        /** Hands all pairs over, by {@link #receive}; they stay there, too. */
        void fetchAll();

        /** Whether a circle may have pairs there. A device has no room for the ids of circles that have come since its last step. */
        boolean mayKnow(int id);

        /** Hands the pairs of circles over, which it may know; they stay there, too. */
        void fetchOf(int[] ids, int count);

        /** Forgets the pairs of circles that {@link #fetchOf} has made room for. */
        void forgetOf(int[] ids, int count);
    }

    // ---- what is reported

    /** Whether anything is reported. */
    public boolean isOn() {
        return reported.isOn();
    }

    /** The arena of the last step. */
    public Bounds arena() {
        return tracker.arena();
    }

    /** Sets the arena of the steps to come. */
    public void setArena(Bounds bounds) {
        tracker.setArena(bounds);
    }

    public boolean hasWalls() {
        return reported.hasWalls();
    }

    /** Whether something is reported of every pair of circles. */
    public boolean hasAllPairs() {
        return reported.isUniform() && reported.types(0, 0) != 0;
    }

    public boolean dependsOnKinds() {
        return reported.dependsOnKinds();
    }

    public int typesOfKinds(int a, int b) {
        return reported.types(a, b);
    }

    public int typesOfWalls(int kind) {
        return reported.wallTypes(kind);
    }

    /** Counts the changes of what is reported. */
    public int version() {
        return reported.version();
    }

    public void prepare(KindTable kinds, StepReports reports) {
        reported.resolve(kinds, circles, pieces);
        reported.tell(reports);
    }

    /** Makes room for {@link #report}. */
    public void makeRoom(HandleTable handles) {
        circles.ensure(handles.end());
        bringHere();
    }

    /** Makes room for {@link #reportPair}. */
    public void makeRoomForPairs(HandleTable handles) {
        makeRoom(handles);
        reported.makeRoom();
    }

    /** Once all changes have been applied. Pairs that are not reported any more are forgotten; new ones begin if they touch. */
    public void report(int types, HandleTable handles) {
        boolean was = isOn();
        reported.set(types);
        changed(was, handles);
    }

    public void reportPair(int kindA, int kindB, int types, HandleTable handles) {
        boolean was = isOn();
        reported.set(kindA, kindB, types);
        changed(was, handles);
    }

    public void reportWalls(int kind, int types, HandleTable handles) {
        boolean was = isOn();
        reported.setWalls(kind, types);
        changed(was, handles);
    }

    private void changed(boolean was, HandleTable handles) {
        there = false;
        if (!isOn()) {
            tracker.clear();
            step.clear();
        } else if (!was) {
            circles.read(handles);
        }
        tracker.forgetUnreported();
        for (int late = step.count - 1; late >= 0; late--) {
            if (!reported.mayReport(step.isOfWall(late), step.type(late))) {
                step.remove(late);
            }
        }
    }

    public void setHitSpeed(float speed) {
        tracker.setHitSpeed(speed);
    }

    // ---- circles come and go

    /** Makes room for commands, and for pieces, so that {@link #apply} and {@link #learnPieces} do not run out of memory. All steps have been made. */
    public void makeRoom(Commands commands) {
        boolean gone = makeRoomForPieces();
        int ids = 0;
        for (int c = 0; c < commands.count(); c++) {
            ids = Math.max(ids, commands.id(c) + 1);
        }
        circles.ensure(ids);
        removedCount = 0;
        boolean removes = circles.markRemoved(commands);
        if (removes) {
            fetchOfRemoved(commands);
        }
        if (removes || gone) {
            tracker.makeRoomForEnds();
        }
    }

    /** Returns whether a piece has gone, of whose pairs all are here then. */
    private boolean makeRoomForPieces() {
        if (knowsPieces()) {
            return false;
        }
        pieces.ensure(pieces.idsNow());
        boolean gone = pieces.anyGone();
        if (gone) {
            bringHere();
        }
        return gone;
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
                    tracker.endRemoved();
                    waiting = false;
                }
                circles.setKind(id, commands.second(c));
            }
        }
        if (waiting) {
            tracker.endRemoved();
        }
        forgetRemoved();
        circles.learn(commands, handles);
    }

    // ---- pieces of terrain come and go

    /** Sets which pieces of terrain circles may touch; there are none yet. */
    public void setPieces(PieceTable table) {
        pieces.setTable(table);
    }

    /** Whether no piece has come or gone since {@link #learnPieces}, nor got another kind. */
    public boolean knowsPieces() {
        return pieces.isCurrent();
    }

    /** Ends the pairs of pieces that have gone, and learns the handles of new ones, and kinds. */
    public void learnPieces() {
        if (pieces.anyGone()) {
            there = false;
            tracker.endGone();
        }
        pieces.read();
    }

    // ---- pairs that only a device knows

    /** Sets who decides about pairs: null if this object does, which then has all of them. All pairs are here. */
    public void setRemote(Remote pairsElsewhere) {
        remote = pairsElsewhere;
        there = false;
    }

    /** Who decides about pairs; null if this object does. */
    public Remote remote() {
        return remote;
    }

    /** Brings all pairs here; they stay on the device, too. */
    public void bringHere() {
        if (!here) {
            tracker.clear();
            remote.fetchAll();
            here = true;
        }
    }

    /** Brings the pairs here of the circles that commands remove, for which {@link #forgetRemoved} then has room. */
    private void fetchOfRemoved(Commands commands) {
        if (removed.length < commands.count()) {
            removed = new int[commands.count() + (commands.count() >> 1)];
        }
        for (int c = 0; c < commands.count(); c++) {
            if (commands.operation(c) == Commands.REMOVE && remote != null && remote.mayKnow(commands.id(c))) {
                removed[removedCount++] = commands.id(c);
            }
        }
        if (!here) {
            tracker.clear();
            if (removedCount > 0) {
                remote.fetchOf(removed, removedCount);
            }
        }
    }

    /** The device forgets the pairs of the circles that are removed. */
    private void forgetRemoved() {
        if (removedCount > 0) {
            if (there) {
                remote.forgetOf(removed, removedCount);
            }
            removedCount = 0;
        }
    }

    /** Takes a pair over; openHit is where the values of an incomplete hit begin, or -1. */
    public void receive(int lower, int higher, float[] values, int openHit) {
        int pair = pairs.add(lower, higher, circles.handle(lower), pieces.handleOfPartner(higher));
        if (openHit >= 0) {
            int hit = tracker.open().addValues(values, openHit);
            if (arena().wraps()) {
                tracker.open().bringInside(hit, arena());
            }
            pairs.setOpen(pair, hit);
        }
    }

    /** Whether all pairs are on the device; else they are here. */
    public boolean areThere() {
        return there;
    }

    /** Takes note that the pairs that are here are on the device too. */
    public void sent() {
        there = true;
    }

    /** Takes note that a step changes the pairs, which are on the device. */
    public void leave() {
        if (here) {
            here = false;
            tracker.clear();
        }
    }

    /** Number of pairs that touch, which are here. */
    public int pairs() {
        return pairs.count;
    }

    public int lower(int pair) {
        return pairs.lower(pair);
    }

    public int higher(int pair) {
        return pairs.higher(pair);
    }

    /** The number of a pair's hit that is not complete, or {@link #NONE}. */
    public int openHit(int pair) {
        return pairs.open(pair);
    }

    /** Number of hits that are not complete. */
    public int openHits() {
        return tracker.open().count;
    }

    /** Copies the values of a hit that is not complete. */
    public void copyOpenHit(int hit, float[] to, int at) {
        tracker.open().copy(hit, to, at);
    }

    /** Publishes the {@link EventRow}s of a step that a device has decided, and those of circles removed before it. */
    public void publishDecided(IntBuffer rows, int first, int count, boolean ordered) {
        if (ordered && step.count == 0) {
            queue.publishDecided(rows, first, count, circles, pieces, arena());
        } else {
            step.addDecided(rows, first, count, 0, circles, pieces, arena());
            publish(1);
        }
    }

    // ---- a step in Java

    /** The number of a pair that touched in the last step, or {@link #NONE}. */
    public int find(int lower, int higher) {
        return pairs.find(lower, higher);
    }

    /** What stands for the number of a pair whose hit goes on; of what this returns, the number again. Below {@link #NONE}. */
    public static int going(int pair) {
        return -2 - pair;
    }

    /** Counts how often pairs have been numbered anew. Until it does, {@link #isNumber} tells which numbers still hold. */
    public int numbering() {
        return pairs.numbering;
    }

    /** Whether a number that a pair had after a step still is one; if not, {@link #find} tells. */
    public boolean isNumber(int pair) {
        return pair < pairs.count;
    }

    /** Ends a step by the records of all threads, in any order. */
    public void endStep(TouchRecords... records) {
        there = false;
        tracker.endStep(records);
        publish(1);
    }

    /** Makes steps in which no pair is in touch, and none was before. */
    public void emptySteps(int count) {
        publish(count);
    }

    private void publish(int count) {
        queue.publish(step, count);
        step.clear();
    }

    // ---- for the caller

    /** The events that have not been taken. */
    public EventQueue queue() {
        return queue;
    }

    /** Lists pairs that touched in the last step by lower and higher id, as far as there is room, and returns how many there are. */
    public int list(int kindA, int kindB, long[] handles) {
        bringHere();
        return tracker.list(kindA, kindB, handles);
    }

    /** The same of circles of a kind and pieces of terrain of a kind. */
    public int listPieces(int kind, int kindOfPieces, long[] handles) {
        bringHere();
        return tracker.listPieces(kind, kindOfPieces, handles);
    }

    public long bytes() {
        return queue.bytes()
                + step.bytes()
                + tracker.bytes()
                + circles.bytes()
                + pieces.bytes()
                + pairs.bytes()
                + reported.bytes();
    }

    // ---- snapshots

    /** Saves what the next events depend on; nothing if nothing is reported. */
    public void save(SavedTouches into) {
        into.clear();
        if (isOn()) {
            bringHere();
            tracker.save(into);
        }
    }

    /** Makes room for a saved state, so that {@link #load} does not run out of memory. */
    public void makeRoom(SavedTouches from, int ids, int pieceIds) {
        if (isOn()) {
            circles.ensure(ids);
            pieces.ensure(pieceIds);
            pairs.ensure(from.pairs);
            step.ensure(from.late);
        }
    }

    /** Room has been made. Events that have not been taken are of a time that is no more, and are dropped. */
    public void load(SavedTouches from, HandleTable handles) {
        here = true;
        there = false;
        queue.drop();
        tracker.clear();
        step.clear();
        if (isOn()) {
            circles.read(handles);
            pieces.read();
            tracker.load(from);
        }
    }
}
