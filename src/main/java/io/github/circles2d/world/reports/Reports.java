package io.github.circles2d.world.reports;

import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.circles.KindTable;
import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.events.EventRows;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.shared.Copies;
import io.github.circles2d.world.shared.Guard;
import io.github.circles2d.world.shared.PendingWork;
import io.github.circles2d.world.shared.Pipeline;

/** The calls on events. */
public final class Reports {
    private final Guard guard;
    private final Pipeline pipeline;
    private final HandleTable handles;
    private final ContactEvents events;
    private final PendingWork pending;
    private final Copies copies;
    private ReportSettings settings = ReportSettings.NOTHING;

    /** What the settings become by the change under way. */
    private ReportSettings next;

    public Reports(
            Guard guard,
            Pipeline pipeline,
            HandleTable handles,
            ContactEvents events,
            PendingWork pending,
            Copies copies) {
        this.guard = guard;
        this.pipeline = pipeline;
        this.handles = handles;
        this.events = events;
        this.pending = pending;
        this.copies = copies;
    }

    /** Sets which events are reported of all circles from the next step on. */
    public void report(int types) {
        change(
                () -> check(types, ContactEvents.ALL, "BEGIN, HIT, END and WALL"),
                () -> {
                    events.makeRoom(handles);
                    next = settings.ofAll(types);
                },
                () -> events.report(types, handles));
    }

    public void report(int kindA, int kindB, int types) {
        change(
                () -> {
                    KindTable.check(kindA);
                    KindTable.check(kindB);
                    check(types, ContactEvents.OF_PAIR_TYPES, "BEGIN, HIT and END");
                },
                () -> {
                    events.makeRoomForPairs(handles);
                    next = settings.ofPair(kindA, kindB, types);
                },
                () -> events.reportPair(kindA, kindB, types, handles));
    }

    public void reportWalls(int kind, int types) {
        change(
                () -> {
                    KindTable.check(kind);
                    check(types, ContactEvents.OF_PAIR_TYPES, "BEGIN, HIT and END");
                },
                () -> {
                    events.makeRoom(handles);
                    next = settings.ofWalls(kind, types);
                },
                () -> events.reportWalls(kind, types, handles));
    }

    /** Checks refuse what is not allowed; room is made when all steps have been made. */
    private void change(Runnable checks, Runnable makeRoom, Runnable change) {
        guard.enter();
        try {
            checks.run();
            pending.settle();
            makeRoom.run();
            pipeline.makeRoomToReport(events);
            copies.forgetSaved();
            boolean was = events.isOn();
            boolean hadWalls = events.hasWalls();
            guard.changing = true;
            change.run();
            settings = next;
            tell(was, hadWalls);
            guard.changing = false;
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    /** Tells the pipeline, if it is to record something else. */
    private void tell(boolean was, boolean hadWalls) {
        if (events.isOn() != was || events.hasWalls() != hadWalls) {
            pipeline.report(events.isOn() ? events : null);
        }
    }

    private static void check(int types, int allowed, String names) {
        if ((types & ~allowed) != 0) {
            throw new IllegalArgumentException("the types must be a sum of " + names + ", not " + types);
        }
    }

    /** Lists the pairs of two kinds that touch, two handles a pair, and returns their number. */
    public int touching(int kindA, int kindB, long[] to) {
        guard.enter();
        try {
            KindTable.check(kindA);
            KindTable.check(kindB);
            pending.settle();
            return events.list(kindA, kindB, Limits.notNull("handles", to));
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    /** The same of the pairs of a circle of a kind and a piece of terrain of a kind. */
    public int touchingPieces(int kind, int kindOfPieces, long[] to) {
        guard.enter();
        try {
            KindTable.check(kind);
            KindTable.check(kindOfPieces);
            pending.settle();
            return events.listPieces(kind, kindOfPieces, Limits.notNull("handles", to));
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    /** Asks for the events of all steps so far, without waiting for them. */
    public void request() {
        guard.enter();
        try {
            pending.requestEvents();
            events.queue().request();
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    public EventRows takeRequested() {
        guard.enter();
        try {
            if (!events.queue().isRequested()) {
                throw new IllegalStateException("no events have been requested since the last were taken:"
                        + " call requestEvents before each takeEvents");
            }
            if (!events.queue().haveArrived()) {
                pending.finishRequestedEvents();
            }
            return events.queue().takeRequested();
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    public void setHitSpeed(float speed) {
        guard.enter();
        try {
            hitSpeed(Limits.within("the hit speed", speed, 0, Limits.SPEED));
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    private void hitSpeed(float speed) {
        next = settings.withHitSpeed(speed);
        pending.finish();
        events.setHitSpeed(speed);
        settings = next;
    }

    /** What is reported, and the hit speed. */
    public ReportSettings settings() {
        return settings;
    }

    /** Sets again what {@link #settings} gave. If it fails half-way, it may be called again. */
    public void restore(ReportSettings before) {
        if (before == settings) {
            return;
        }
        report(before.types);
        before.repeat(this);
        guard.enter();
        try {
            hitSpeed(before.hitSpeed);
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
        settings = before;
    }

    /** The events since the last call. */
    public EventRows take() {
        guard.enter();
        try {
            pending.finishEvents();
            return events.queue().take();
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }
}
