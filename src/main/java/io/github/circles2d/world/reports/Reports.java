package io.github.circles2d.world.reports;

import io.github.circles2d.world.circles.KindTable;
import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.events.EventRows;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.shared.WorldParts;
import java.util.Arrays;

/** The calls on events. */
public final class Reports {
    private final WorldParts world;
    private Settings settings = Settings.NOTHING;

    // of the change under way
    private Settings next;
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
    private void begin(Settings then) {
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
    public Settings settings() {
        return settings;
    }

    /** Sets again what {@link #settings} gave. If it fails half-way, it may be called again. */
    public void restore(Settings before) {
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

    /** Which events a world reports, and the hit speed. It never changes: a call that says something else makes another. */
    public static final class Settings {
        /** Those of a new world. */
        static final Settings NOTHING = new Settings(0, new long[0], ContactEvents.OF_PAIR);

        /** In the key of a kind and walls, the place of the other kind has this. */
        private static final int WALLS = 256;

        /** The types of all that has no row. */
        final int types;

        final float hitSpeed;

        /** What was said of two kinds, or of a kind and walls, since anything was said of all: a key, and types in the lower half. */
        private final long[] rows;

        private Settings(int types, long[] rows, float hitSpeed) {
            this.types = types;
            this.rows = rows;
            this.hitSpeed = hitSpeed;
        }

        /** The same with the types of all circles. */
        Settings ofAll(int all) {
            return rows.length == 0 && all == types ? this : new Settings(all, new long[0], hitSpeed);
        }

        /** The same with the types of two kinds. */
        Settings ofPair(int kindA, int kindB, int ofPair) {
            return with(Math.min(kindA, kindB), Math.max(kindA, kindB), ofPair);
        }

        /** The same with the types of a kind and walls. */
        Settings ofWalls(int kind, int ofWalls) {
            return with(kind, WALLS, ofWalls);
        }

        Settings withHitSpeed(float speed) {
            return speed == hitSpeed ? this : new Settings(types, rows, speed);
        }

        private Settings with(int first, int second, int wanted) {
            int key = first << 16 | second;
            long row = (long) key << 32 | wanted;
            int k = 0;
            while (k < rows.length && rows[k] >> 32 != key) {
                k++;
            }
            if (k < rows.length && rows[k] == row) {
                return this;
            }
            long[] more = Arrays.copyOf(rows, Math.max(rows.length, k + 1));
            more[k] = row;
            return new Settings(types, more, hitSpeed);
        }

        /** Says again what was said of single kinds. */
        void repeat(Reports reports) {
            for (long row : rows) {
                int first = (int) (row >> 48);
                int second = (int) (row >> 32) & 0xffff;
                if (second == WALLS) {
                    reports.reportWalls(first, (int) row);
                } else {
                    reports.report(first, second, (int) row);
                }
            }
        }
    }
}
