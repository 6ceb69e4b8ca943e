package io.github.circles2d.world;

/**
 * Stage Solver: moves the circles through one step of a number of sub-steps.
 *
 * <p>Soft contacts with warm starting, one biased and one relaxing pass over the contacts a sub-step (after E. Catto,
 * "Solver2D", 2024), with restitution inside the sub-step. See the package's documentation for the order. What is done to the
 * contacts is in {@link JvmPasses}, what is done to the circles in {@link JvmMover}; here is who does it when.
 *
 * <p>The groups of a row touch circles of that row of cells and of the next. So the even rows may run at the same time, and
 * then the odd ones; and an odd row may run as soon as the two even ones beside it have. Within a row, contacts run as they are
 * laid out: groups of even columns before those of odd ones.
 *
 * <p>Where all circles are of one level, this goes for whole sub-steps too: what a row needs is what the rows beside it have come
 * to. So each worker sweeps over its band of rows once, and takes several passes, each some rows behind the one before, along:
 * then the rows lie in the processor's cache, and workers need not wait for each other at each pass. What such a sweep
 * cannot do at the edges of its band, because it needs rows of the next, a second one does from there outwards.
 */
final class JvmSolver {
    /** Rows that a sub-step is behind the one before it in a sweep, and by which it does less at each edge of a band. */
    private static final int LAG = 4;

    /** Rows of the narrowest band a sub-step of a sweep: the work at the edges is not shared as evenly as the rest. */
    private static final int ROWS_PER_SUB_STEP = 24;

    private final JvmState state;
    private final JvmGrid grid;
    private final JvmContacts contacts;
    private final Levels levels;
    private final Team team;
    private final JvmMover mover;
    /** By worker: each has its own place to work. */
    private final JvmPasses[] passes;

    private final JvmBands bands;

    JvmSolver(JvmState state, JvmGrid grid, JvmContacts contacts, Levels levels, Team team) {
        this.state = state;
        this.grid = grid;
        this.contacts = contacts;
        this.levels = levels;
        this.team = team;
        mover = new JvmMover(state);
        passes = new JvmPasses[team.most()];
        for (int worker = 0; worker < passes.length; worker++) {
            passes[worker] = new JvmPasses(state, contacts);
        }
        bands = new JvmBands(grid, levels, team);
    }

    /** Fills the contacts, and measures them for the first sub-step. */
    void prepare(int worker, StepConstants k) {
        if (worker == 0) {
            bands.divide(contacts.rowStart, 2 * LAG);
        }
        mover.clear(team.part(state.n, worker), team.part(state.n, worker + 1));
        team.sync(worker);
        for (int l = 0; l < levels.usedCount; l++) {
            int from = contacts.firstRow(levels.used[l], worker);
            int to = contacts.firstRow(levels.used[l], worker + 1);
            for (int row = from; row < to; row += 2) {
                prepareRow(worker, l, row, k);
                if (row > from) {
                    prepareRow(worker, l, row - 1, k);
                }
            }
            team.sync(worker);
            if (from < to) {
                prepareRow(worker, l, to - 1, k);
            }
            team.sync(worker);
        }
    }

    private void prepareRow(int worker, int l, int row, StepConstants k) {
        contacts.fillRow(worker, l, row, k);
        passes[worker].prepare(firstContact(levels.used[l], row), firstContact(levels.used[l], row + 1));
    }

    private int firstContact(int level, int row) {
        return contacts.rowStart[levels.firstRow[level] + row];
    }

    void solve(int worker, StepConstants k) {
        if (levels.usedCount == 1 && bands.narrowest() >= 2 * LAG) {
            int most = Math.max(1, bands.narrowest() / ROWS_PER_SUB_STEP);
            for (int sub = 0; sub < k.subSteps; sub += most) {
                int next = Math.min(k.subSteps, sub + most);
                sweep(
                        worker,
                        bands.first(levels.used[0], worker),
                        bands.first(levels.used[0], worker + 1),
                        1,
                        sub,
                        next,
                        k);
                team.sync(worker);
                int edge = bands.first(levels.used[0], worker + 1);
                sweep(worker, edge, edge, -1, sub, next, k);
                team.sync(worker);
            }
        } else {
            solveInPasses(worker, k);
        }
    }

    // ---- sweeps, where there is one level
    // ----------------------------------------------------------------------------

    /**
     * Makes some sub-steps on a band of rows: with each stage on fewer rows (inwards 1), or on more (inwards -1, from an empty
     * band at the edge of two).
     */
    private void sweep(int worker, int low, int high, int inwards, int sub, int nextSub, StepConstants k) {
        int count = nextSub - sub;
        int end = high + 2 * LAG + (inwards > 0 ? 0 : 2 * LAG * count);
        for (int front = low; front < end; front += 2) {
            for (int s = 0; s < count; s++) {
                int narrower = inwards * LAG * s;
                visit(worker, front - LAG * s, low + narrower, high - narrower, inwards, sub + s, k);
            }
            if (nextSub == k.subSteps) {
                int narrower = inwards * LAG * count;
                for (int row = front - LAG * count; row < front - LAG * count + 2; row++) {
                    if (low + narrower <= row && row < high - narrower) {
                        mover.finish(firstSlot(row), endSlot(row), k);
                    }
                }
            }
        }
    }

    /** All stages of a sub-step, where its sweep has come to an even row. */
    private void visit(int worker, int row, int low, int high, int inwards, int sub, StepConstants k) {
        if (low <= row && row < high) {
            accelerate(row, k);
            accelerate(row + 1, k);
            push(worker, row, k);
        }
        int from = low + inwards;
        int to = high - inwards;
        if (from <= row - 1 && row - 1 < to) {
            push(worker, row - 1, k);
        }
        for (int r = row - 2; r < row; r++) {
            if (from <= r && r < to) {
                mover.move(firstSlot(r), endSlot(r), k, sub == 0);
            }
        }
        from += inwards;
        to -= inwards;
        if (from <= row - 2 && row - 2 < to) {
            relax(worker, row - 2, k, sub);
        }
        from += inwards;
        to -= inwards;
        if (from <= row - 3 && row - 3 < to) {
            relax(worker, row - 3, k, sub);
        }
    }

    private int ring(int row) {
        return row & ((1 << levels.rowsLog[levels.used[0]]) - 1);
    }

    private int firstSlot(int row) {
        return grid.start[levels.rowStart(levels.used[0], ring(row))];
    }

    private int endSlot(int row) {
        return grid.start[levels.rowStart(levels.used[0], ring(row) + 1)];
    }

    private void accelerate(int row, StepConstants k) {
        mover.accelerate(firstSlot(row), endSlot(row), k);
    }

    private void push(int worker, int row, StepConstants k) {
        passes[worker].push(firstContact(levels.used[0], ring(row)), firstContact(levels.used[0], ring(row) + 1), k);
    }

    private void relax(int worker, int row, StepConstants k, int sub) {
        int first = firstContact(levels.used[0], ring(row));
        passes[worker].relax(first, firstContact(levels.used[0], ring(row) + 1), k, sub == k.subSteps - 1);
    }

    // ---- pass after pass, where there are more
    // -----------------------------------------------------------------------

    private void solveInPasses(int worker, StepConstants k) {
        int from = team.part(state.n, worker);
        int to = team.part(state.n, worker + 1);
        for (int sub = 0; sub < k.subSteps; sub++) {
            mover.accelerate(from, to, k);
            team.sync(worker);
            for (int l = 0; l < levels.usedCount; l++) {
                pass(worker, levels.used[l], false, sub, k);
            }
            mover.move(from, to, k, sub == 0);
            team.sync(worker);
            for (int l = 0; l < levels.usedCount; l++) {
                pass(worker, levels.used[l], true, sub, k);
            }
        }
        mover.finish(from, to, k);
        team.sync(worker);
    }

    private void pass(int worker, int level, boolean relaxing, int sub, StepConstants k) {
        int from = bands.first(level, worker);
        int to = bands.first(level, worker + 1);
        for (int row = from; row < to; row += 2) {
            visit(worker, level, row, relaxing, sub, k);
            if (row > from) {
                visit(worker, level, row - 1, relaxing, sub, k);
            }
        }
        team.sync(worker);
        if (from < to) {
            visit(worker, level, to - 1, relaxing, sub, k);
        }
        team.sync(worker);
    }

    private void visit(int worker, int level, int row, boolean relaxing, int sub, StepConstants k) {
        int from = firstContact(level, row);
        int to = firstContact(level, row + 1);
        if (relaxing) {
            passes[worker].relax(from, to, k, sub == k.subSteps - 1);
        } else {
            passes[worker].push(from, to, k);
        }
    }
}
