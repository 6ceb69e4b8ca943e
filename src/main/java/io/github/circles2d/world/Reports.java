package io.github.circles2d.world;

import io.github.circles2d.world.circles.KindTable;
import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.events.EventRows;
import io.github.circles2d.world.model.Limits;

/** The calls on events. */
public final class Reports {
    private final Simulation simulation;
    private final Guard guard;
    private final ContactEvents events;
    private ReportSettings settings = ReportSettings.NOTHING;

    /** What the settings become by the change under way. */
    private ReportSettings next;

    Reports(Simulation simulation) {
        this.simulation = simulation;
        guard = simulation.guard;
        events = simulation.events;
    }

    /** Sets which events are reported of all circles from the next step on. */
    public void report(int types) {
        change(
                () -> check(types, ContactEvents.ALL, "BEGIN, HIT, END and WALL"),
                () -> {
                    events.makeRoom(simulation.handles);
                    next = settings.ofAll(types);
                },
                () -> events.report(types, simulation.handles));
    }

    /** Sets which events are reported of two kinds. */
    public void report(int kindA, int kindB, int types) {
        change(
                () -> {
                    KindTable.check(kindA);
                    KindTable.check(kindB);
                    check(types, ContactEvents.OF_PAIR_TYPES, "BEGIN, HIT and END");
                },
                () -> {
                    events.makeRoomForPairs(simulation.handles);
                    next = settings.ofPair(kindA, kindB, types);
                },
                () -> events.reportPair(kindA, kindB, types, simulation.handles));
    }

    /** Sets which events of walls are reported of a kind. */
    public void reportWalls(int kind, int types) {
        change(
                () -> {
                    KindTable.check(kind);
                    check(types, ContactEvents.OF_PAIR_TYPES, "BEGIN, HIT and END");
                },
                () -> {
                    events.makeRoom(simulation.handles);
                    next = settings.ofWalls(kind, types);
                },
                () -> events.reportWalls(kind, types, simulation.handles));
    }

    /**
     * Changes what is reported.
     *
     * @param checks refuses what is not allowed
     * @param makeRoom for the change, so that it does not run out of memory; all steps have been made
     * @param change what is asked for
     */
    private void change(Runnable checks, Runnable makeRoom, Runnable change) {
        guard.enter();
        try {
            checks.run();
            simulation.settle();
            makeRoom.run();
            simulation.snapshots().forget();
            boolean was = events.isOn();
            boolean hadWalls = events.hasWalls();
            guard.changing = true;
            change.run();
            settings = next;
            tell(was, hadWalls);
            guard.changing = false;
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** Tells the pipeline, if it is to record something else. */
    private void tell(boolean was, boolean hadWalls) {
        if (events.isOn() != was || events.hasWalls() != hadWalls) {
            simulation.pipeline.report(events.isOn() ? events : null);
        }
    }

    private static void check(int types, int allowed, String names) {
        if ((types & ~allowed) != 0) {
            throw new IllegalArgumentException("the types must be a sum of " + names + ", not " + types);
        }
    }

    /** Lists the pairs of two kinds that touch, two handles a pair, and returns their number. */
    public int touching(int kindA, int kindB, long[] handles) {
        guard.enter();
        try {
            KindTable.check(kindA);
            KindTable.check(kindB);
            simulation.settle();
            return events.list(kindA, kindB, Limits.notNull("handles", handles));
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** Asks for the events of all steps so far, without waiting for them. */
    public void request() {
        guard.enter();
        try {
            simulation.requestEvents();
            events.request();
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** The events that were requested last. */
    public EventRows takeRequested() {
        guard.enter();
        try {
            if (!events.isRequested()) {
                throw new IllegalStateException("no events have been requested since the last were taken:"
                        + " call requestEvents before each takeEvents");
            }
            if (!events.haveArrived()) {
                simulation.finishRequestedEvents();
            }
            return events.takeRequested();
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** Sets the speed from which on a hit counts. */
    public void setHitSpeed(float speed) {
        guard.enter();
        try {
            Limits.within("the hit speed", speed, 0, Limits.SPEED);
            hitSpeed(speed);
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    private void hitSpeed(float speed) {
        next = settings.withHitSpeed(speed);
        simulation.finishSteps();
        events.setHitSpeed(speed);
        settings = next;
    }

    /** What is reported, and the hit speed. */
    public ReportSettings settings() {
        return settings;
    }

    /**
     * Sets again what was reported before, and the hit speed. If it fails half-way, it may be called again.
     *
     * @param before what {@link #settings} has given
     */
    public void restore(ReportSettings before) {
        if (before == settings) {
            return;
        }
        report(before.types);
        before.repeat(this);
        guard.enter();
        try {
            hitSpeed(before.hitSpeed);
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
        settings = before;
    }

    /** The events since the last call. */
    public EventRows take() {
        guard.enter();
        try {
            simulation.finishEvents();
            return events.take();
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }
}
