package io.github.circles2d.world.reports;

import io.github.circles2d.world.events.ContactEvents;
import java.util.Arrays;

/** Which events a world reports, and the hit speed. It never changes: a call that says something else makes another. */
public final class ReportSettings {
    /** Those of a new world. */
    static final ReportSettings NOTHING = new ReportSettings(0, new long[0], ContactEvents.OF_PAIR);

    /** In the key of a kind and walls, the place of the other kind has this. */
    private static final int WALLS = 256;

    /** The types of all that has no row. */
    final int types;

    final float hitSpeed;

    /** What was said of two kinds, or of a kind and walls, since anything was said of all: a key, and types in the lower half. */
    private final long[] rows;

    private ReportSettings(int types, long[] rows, float hitSpeed) {
        this.types = types;
        this.rows = rows;
        this.hitSpeed = hitSpeed;
    }

    /** The same with the types of all circles. */
    ReportSettings ofAll(int all) {
        return rows.length == 0 && all == types ? this : new ReportSettings(all, new long[0], hitSpeed);
    }

    /** The same with the types of two kinds. */
    ReportSettings ofPair(int kindA, int kindB, int ofPair) {
        return with(Math.min(kindA, kindB), Math.max(kindA, kindB), ofPair);
    }

    /** The same with the types of a kind and walls. */
    ReportSettings ofWalls(int kind, int ofWalls) {
        return with(kind, WALLS, ofWalls);
    }

    ReportSettings withHitSpeed(float speed) {
        return speed == hitSpeed ? this : new ReportSettings(types, rows, speed);
    }

    private ReportSettings with(int first, int second, int wanted) {
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
        return new ReportSettings(types, more, hitSpeed);
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
