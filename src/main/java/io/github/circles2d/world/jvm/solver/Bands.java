package io.github.circles2d.world.jvm.solver;

import io.github.circles2d.world.jvm.grid.Grid;
import io.github.circles2d.world.jvm.threads.Team;
import io.github.circles2d.world.model.GridLevels;
import java.util.Arrays;

/**
 * Which rows of cells each worker takes: of each level, a band from an even row to an even row. The bands of a worker, of all levels
 * together, weigh about as much as those of any other. The weight of a row is the number of its circles and, if they are known, of its
 * contacts and of the cross contacts in which its circles are the light ones.
 */
final class Bands {
    private final Grid grid;
    private final GridLevels levels;
    private final Team team;

    /** By level and worker: the first row of its band; one more element a level for the end. */
    private final int[] edges;

    /** By worker: by how much the workers before it have more than their share of the levels divided so far. */
    private final long[] surplus;

    private int narrowest;

    Bands(Grid grid, GridLevels levels, Team team) {
        this.grid = grid;
        this.levels = levels;
        this.team = team;
        edges = new int[GridLevels.COUNT * (team.most() + 1)];
        surplus = new long[team.most() + 1];
    }

    /** Divides all levels. contactsBefore and cross are null if not known. A band has at least an even number of rows, or none. */
    void divide(int[] contactsBefore, CrossContacts cross, int least) {
        narrowest = Integer.MAX_VALUE;
        Arrays.fill(surplus, 0L);
        // Fine levels come last: they have the most rows to make up for what coarse ones could not share evenly.
        for (int l = levels.usedCount - 1; l >= 0; l--) {
            divide(levels.used[l], contactsBefore, cross, least);
        }
    }

    private void divide(int level, int[] contactsBefore, CrossContacts cross, int least) {
        int rows = levels.rowCount[level];
        int width = least * team.size() <= rows ? least : 0;
        int edge = level * (team.most() + 1);
        long begin = weight(level, 0, contactsBefore, cross);
        long all = weight(level, rows, contactsBefore, cross) - begin;
        edges[edge] = 0;
        for (int worker = 1; worker <= team.size(); worker++, edge++) {
            long share = begin + all * worker / team.size();
            int row =
                    worker == team.size() ? rows : firstEvenRow(level, share - surplus[worker], contactsBefore, cross);
            row = Math.min(Math.max(row, edges[edge] + width), rows - width * (team.size() - worker));
            edges[edge + 1] = row;
            surplus[worker] += weight(level, row, contactsBefore, cross) - share;
            narrowest = Math.min(narrowest, row - edges[edge]);
        }
    }

    /** The first even row with at least so much weight before it. */
    private int firstEvenRow(int level, long weight, int[] contactsBefore, CrossContacts cross) {
        int low = 0;
        int high = levels.rowCount[level] >> 1;
        while (low < high) {
            int middle = (low + high) >>> 1;
            if (weight(level, 2 * middle, contactsBefore, cross) < weight) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        return 2 * low;
    }

    /** What all rows weigh that come before one, those of finer levels too. */
    private long weight(int level, int row, int[] contactsBefore, CrossContacts cross) {
        int slot = grid.start[levels.rowStart(level, row)];
        long contacts = contactsBefore == null ? 0 : contactsBefore[levels.firstRow[level] + row];
        return slot + contacts + (cross == null ? 0 : cross.firstOf(slot));
    }

    /** What the worker with most to do has of a level: rows from so many after the start of its band to so many before its end. */
    long heaviest(int level, int[] contactsBefore, int after, int before) {
        long most = 0;
        for (int worker = 0; worker < team.size(); worker++) {
            int from = first(level, worker) + after;
            int to = first(level, worker + 1) - before;
            if (from < to) {
                most = Math.max(most, weightBetween(level, from, to, contactsBefore));
            }
        }
        return most;
    }

    /** The same of so many rows before the end of its band and so many behind it. */
    long heaviestEdge(int level, int[] contactsBefore, int before, int behind) {
        long most = 0;
        for (int worker = 1; worker <= team.size(); worker++) {
            int edge = first(level, worker);
            int next = edge < levels.rowCount[level] ? edge : 0;
            most = Math.max(
                    most,
                    weightBetween(level, Math.max(edge - before, 0), edge, contactsBefore)
                            + weightBetween(level, next, next + behind, contactsBefore));
        }
        return most;
    }

    private long weightBetween(int level, int from, int to, int[] contactsBefore) {
        return weight(level, to, contactsBefore, null) - weight(level, from, contactsBefore, null);
    }

    /** First row of a worker's band; of the number of workers: the end of the last band. */
    int first(int level, int worker) {
        return edges[level * (team.most() + 1) + worker];
    }

    /** Circles in the rows of a worker, of all levels. */
    int circles(int worker) {
        int sum = 0;
        for (int l = 0; l < levels.usedCount; l++) {
            int level = levels.used[l];
            sum += grid.start[levels.rowStart(level, first(level, worker + 1))]
                    - grid.start[levels.rowStart(level, first(level, worker))];
        }
        return sum;
    }

    int narrowest() {
        return narrowest;
    }
}
