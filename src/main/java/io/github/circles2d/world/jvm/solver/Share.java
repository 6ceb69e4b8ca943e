package io.github.circles2d.world.jvm.solver;

import io.github.circles2d.world.jvm.grid.Grid;
import io.github.circles2d.world.jvm.threads.Team;
import io.github.circles2d.world.model.GridLevels;

/**
 * What a worker has in stage Solver where contacts are solved pass after pass: of each level, the circles in its band of rows, the cross
 * contacts in which they are the light ones, and those of them that are heavy. Levels differ in what their circles cost, so each worker
 * has a part of every level; and the rows of its own circles are the rows that it solves, so they stay in the cache of its processor.
 */
final class Share {
    private final Grid grid;
    private final GridLevels levels;
    private final CrossContacts cross;

    /** Number of ranges: one a level, or one a round in which slots of one level are dealt out. */
    int count;

    // by range: slots, cross contacts and numbers of heavy circles, the first one and one behind the last
    final int[] fromSlot = new int[Math.max(GridLevels.COUNT, Team.ROUNDS)];
    final int[] toSlot = new int[Math.max(GridLevels.COUNT, Team.ROUNDS)];
    final int[] fromCross = new int[GridLevels.COUNT];
    final int[] toCross = new int[GridLevels.COUNT];
    final int[] fromHeavy = new int[GridLevels.COUNT];
    final int[] toHeavy = new int[GridLevels.COUNT];

    Share(Grid grid, GridLevels levels, CrossContacts cross) {
        this.grid = grid;
        this.levels = levels;
        this.cross = cross;
    }

    /**
     * Takes some of so many slots, where there is one level: it may have fewer rows than there are workers. They are dealt out, as terrain and
     * walls are near to some.
     */
    void takeSlots(Team team, int slots, int worker) {
        count = team.rounds();
        for (int round = 0; round < count; round++) {
            fromSlot[round] = team.from(slots, worker, round);
            toSlot[round] = team.to(slots, worker, round);
        }
    }

    void takeBands(Bands bands, int worker) {
        count = levels.usedCount;
        for (int l = 0; l < count; l++) {
            int level = levels.used[l];
            fromSlot[l] = grid.start[levels.rowStart(level, bands.first(level, worker))];
            toSlot[l] = grid.start[levels.rowStart(level, bands.first(level, worker + 1))];
            fromCross[l] = cross.firstOf(fromSlot[l]);
            toCross[l] = cross.firstOf(toSlot[l]);
            fromHeavy[l] = cross.heavyCircles.firstFrom(fromSlot[l]);
            toHeavy[l] = cross.heavyCircles.firstFrom(toSlot[l]);
        }
    }
}
