package io.github.circles2d.world.reports;

import io.github.circles2d.world.circles.KindTable;
import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.events.EventRows;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.shared.WorldParts;

/** The calls on events. */
public final class Reports {
    private final WorldParts world;
    private ReportSettings settings = ReportSettings.NOTHING;

    /** What the settings become by the change under way. */
    private ReportSettings next;

    public Reports(WorldParts world) {
        this.world = world;
    }

    /** Sets which events are reported of all circles from the next step on. */
    public void report(int types) {
        change(
                () -> check(types, ContactEvents.ALL, "BEGIN, HIT, END and WALL"),
                () -> {
                    world.events.makeRoom(world.handles);
                    next = settings.ofAll(types);
                },
                () -> world.events.report(types, world.handles));
    }

    public void report(int kindA, int kindB, int types) {
        change(
                () -> {
                    KindTable.check(kindA);
                    KindTable.check(kindB);
                    check(types, ContactEvents.OF_PAIR_TYPES, "BEGIN, HIT and END");
                },
                () -> {
                    world.events.makeRoomForPairs(world.handles);
                    next = settings.ofPair(kindA, kindB, types);
                },
                () -> world.events.reportPair(kindA, kindB, types, world.handles));
    }

    public void reportWalls(int kind, int types) {
        change(
                () -> {
                    KindTable.check(kind);
                    check(types, ContactEvents.OF_PAIR_TYPES, "BEGIN, HIT and END");
                },
                () -> {
                    world.events.makeRoom(world.handles);
                    next = settings.ofWalls(kind, types);
                },
                () -> world.events.reportWalls(kind, types, world.handles));
    }

    /** Checks refuse what is not allowed; room is made when all steps have been made. */
    private void change(Runnable checks, Runnable makeRoom, Runnable change) {
        world.guard.enter();
        try {
            checks.run();
            world.pending.settle();
            makeRoom.run();
            world.pipeline.makeRoomToReport(world.events);
            world.copies.forgetSaved();
            boolean was = world.events.isOn();
            boolean hadWalls = world.events.hasWalls();
            world.guard.changing = true;
            change.run();
            settings = next;
            tell(was, hadWalls);
            world.guard.changing = false;
        } catch (RuntimeException | Error thrown) {
            throw world.guard.failed(thrown);
        } finally {
            world.guard.user = null;
        }
    }

    /** Tells the pipeline, if it is to record something else. */
    private void tell(boolean was, boolean hadWalls) {
        if (world.events.isOn() != was || world.events.hasWalls() != hadWalls) {
            world.pipeline.report(world.events.isOn() ? world.events : null);
        }
    }

    private static void check(int types, int allowed, String names) {
        if ((types & ~allowed) != 0) {
            throw new IllegalArgumentException("the types must be a sum of " + names + ", not " + types);
        }
    }

    /** Lists the pairs of two kinds that touch, two handles a pair, and returns their number. */
    public int touching(int kindA, int kindB, long[] to) {
        world.guard.enter();
        try {
            KindTable.check(kindA);
            KindTable.check(kindB);
            world.pending.settle();
            return world.events.list(kindA, kindB, Limits.notNull("handles", to));
        } catch (RuntimeException | Error thrown) {
            throw world.guard.failed(thrown);
        } finally {
            world.guard.user = null;
        }
    }

    /** The same of the pairs of a circle of a kind and a piece of terrain of a kind. */
    public int touchingPieces(int kind, int kindOfPieces, long[] to) {
        world.guard.enter();
        try {
            KindTable.check(kind);
            KindTable.check(kindOfPieces);
            world.pending.settle();
            return world.events.listPieces(kind, kindOfPieces, Limits.notNull("handles", to));
        } catch (RuntimeException | Error thrown) {
            throw world.guard.failed(thrown);
        } finally {
            world.guard.user = null;
        }
    }

    /** Asks for the events of all steps so far, without waiting for them. */
    public void request() {
        world.guard.enter();
        try {
            world.pending.requestEvents();
            world.events.queue().request();
        } catch (RuntimeException | Error thrown) {
            throw world.guard.failed(thrown);
        } finally {
            world.guard.user = null;
        }
    }

    public EventRows takeRequested() {
        world.guard.enter();
        try {
            if (!world.events.queue().isRequested()) {
                throw new IllegalStateException("no events have been requested since the last were taken:"
                        + " call requestEvents before each takeEvents");
            }
            if (!world.events.queue().haveArrived()) {
                world.pending.finishRequestedEvents();
            }
            return world.events.queue().takeRequested();
        } catch (RuntimeException | Error thrown) {
            throw world.guard.failed(thrown);
        } finally {
            world.guard.user = null;
        }
    }

    public void setHitSpeed(float speed) {
        world.guard.enter();
        try {
            hitSpeed(Limits.within("the hit speed", speed, 0, Limits.SPEED));
        } catch (RuntimeException | Error thrown) {
            throw world.guard.failed(thrown);
        } finally {
            world.guard.user = null;
        }
    }

    private void hitSpeed(float speed) {
        next = settings.withHitSpeed(speed);
        world.pending.finish();
        world.events.setHitSpeed(speed);
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
        world.guard.enter();
        try {
            hitSpeed(before.hitSpeed);
        } catch (RuntimeException | Error thrown) {
            throw world.guard.failed(thrown);
        } finally {
            world.guard.user = null;
        }
        settings = before;
    }

    /** The events since the last call. */
    public EventRows take() {
        world.guard.enter();
        try {
            world.pending.finishEvents();
            return world.events.queue().take();
        } catch (RuntimeException | Error thrown) {
            throw world.guard.failed(thrown);
        } finally {
            world.guard.user = null;
        }
    }
}
