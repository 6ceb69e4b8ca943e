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

    // of the change under way
    private ReportSettings next;
    private boolean wasOn;
    private boolean hadWalls;

    public Reports(WorldParts world) {
        this.world = world;
    }

    /** Sets which events are reported of all circles from the next step on. */
    public void report(int types) {
        world.guard.enter();
        try (world.guard) {
            check(types, ContactEvents.ALL, "BEGIN, HIT, END and WALL");
            world.pending.settle();
            world.events.makeRoom(world.handles);
            begin(settings.ofAll(types));
            world.events.report(types, world.handles);
            end();
        }
    }

    public void report(int kindA, int kindB, int types) {
        world.guard.enter();
        try (world.guard) {
            KindTable.check(kindA);
            KindTable.check(kindB);
            check(types, ContactEvents.OF_PAIR_TYPES, "BEGIN, HIT and END");
            world.pending.settle();
            world.events.makeRoomForPairs(world.handles);
            begin(settings.ofPair(kindA, kindB, types));
            world.events.reportPair(kindA, kindB, types, world.handles);
            end();
        }
    }

    public void reportWalls(int kind, int types) {
        world.guard.enter();
        try (world.guard) {
            KindTable.check(kind);
            check(types, ContactEvents.OF_PAIR_TYPES, "BEGIN, HIT and END");
            world.pending.settle();
            world.events.makeRoom(world.handles);
            begin(settings.ofWalls(kind, types));
            world.events.reportWalls(kind, types, world.handles);
            end();
        }
    }

    /** Makes the last room, and begins a change of the settings. */
    private void begin(ReportSettings then) {
        world.moves.beforeReports();
        try {
            world.pipeline.makeRoomToReport(world.events);
        } catch (RuntimeException e) {
            world.moves.goHome(e);
            world.pipeline.makeRoomToReport(world.events);
        }
        world.copies.forgetSaved();
        next = then;
        wasOn = world.events.isOn();
        hadWalls = world.events.hasWalls();
        world.guard.changing = true;
    }

    /** Ends it, and tells the pipeline, if it is to record something else. */
    private void end() {
        settings = next;
        if (world.events.isOn() != wasOn || world.events.hasWalls() != hadWalls) {
            world.pipeline.report(world.events.isOn() ? world.events : null);
        }
        world.guard.changing = false;
    }

    private static void check(int types, int allowed, String names) {
        if ((types & ~allowed) != 0) {
            throw new IllegalArgumentException("the types must be a sum of " + names + ", not " + types);
        }
    }

    /** Lists the pairs of two kinds that touch, two handles a pair, and returns their number. */
    public int touching(int kindA, int kindB, long[] to) {
        world.guard.enter();
        try (world.guard) {
            KindTable.check(kindA);
            KindTable.check(kindB);
            world.pending.settle();
            return world.events.list(kindA, kindB, Limits.notNull("handles", to));
        }
    }

    /** The same of the pairs of a circle of a kind and a piece of terrain of a kind. */
    public int touchingPieces(int kind, int kindOfPieces, long[] to) {
        world.guard.enter();
        try (world.guard) {
            KindTable.check(kind);
            KindTable.check(kindOfPieces);
            world.pending.settle();
            return world.events.listPieces(kind, kindOfPieces, Limits.notNull("handles", to));
        }
    }

    /** Asks for the events of all steps so far, without waiting for them. */
    public void request() {
        world.guard.enter();
        try (world.guard) {
            world.guard.changing = true;
            world.pipeline.requestEvents();
            world.guard.changing = false;
            world.events.queue().request();
        }
    }

    public EventRows takeRequested() {
        world.guard.enter();
        try (world.guard) {
            if (!world.events.queue().isRequested()) {
                throw new IllegalStateException("no events have been requested since the last were taken:"
                        + " call requestEvents before each takeEvents");
            }
            if (!world.events.queue().haveArrived()) {
                world.clock.begin();
                world.guard.changing = true;
                world.pipeline.finishRequestedEvents();
                world.guard.changing = false;
                world.clock.end();
            }
            return world.events.queue().takeRequested();
        }
    }

    public void setHitSpeed(float speed) {
        world.guard.enter();
        try (world.guard) {
            hitSpeed(Limits.within("the hit speed", speed, 0, Limits.SPEED));
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
        try (world.guard) {
            hitSpeed(before.hitSpeed);
        }
        settings = before;
    }

    /** The events since the last call. */
    public EventRows take() {
        world.guard.enter();
        try (world.guard) {
            world.clock.begin();
            world.guard.changing = true;
            world.pipeline.finishEvents();
            world.guard.changing = false;
            world.clock.end();
            return world.events.queue().take();
        }
    }
}
