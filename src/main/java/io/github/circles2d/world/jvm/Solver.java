package io.github.circles2d.world.jvm;

import io.github.circles2d.world.jvm.threads.Team;
import io.github.circles2d.world.model.GridLevels;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.TerrainStep;

/**
 * Stage Solver: moves the circles through the sub-steps of one step.
 *
 * <p>Contacts are soft, with warm starting and restitution; each sub-step has a biased and a relaxing pass over them (after
 * E. Catto, "Solver2D", 2024). The package's documentation has the order. {@link PairVisits} treats contacts, {@link CirclePasses}
 * treats circles, and this class says which worker does so when.
 *
 * <p>The groups of a row touch circles of that row of cells and of the next one. So all even rows may run at the same time, and
 * then all odd ones; an odd row may run as soon as the two even rows beside it have. Within a row, contacts run as they lie in
 * memory: groups of even columns before groups of odd ones.
 *
 * <p>If all circles are of one level, this holds for whole sub-steps too: a row needs only the rows beside it. So each worker sweeps
 * over its band of rows and takes all passes of one or more sub-steps along, each some rows behind the one before. The rows are
 * then still in the processor's cache, and workers wait for each other twice per sweep. At the edges of its band a sweep lacks rows of
 * the next band; a second sweep completes them, from the edge outwards.
 *
 * <p>If there are more levels, their cross contacts come between the passes; joints do too. So all workers make pass after pass, each on its
 * {@link Share} of all levels.
 */
public final class Solver {
    /** Rows that a sub-step is behind the one before it in a sweep, and by which it does less at each edge of a band. */
    private static final int LAG = 4;

    /** Rows of the narrowest band a sub-step of a sweep: the work at the edges is not shared as evenly as the rest. */
    private static final int ROWS_PER_SUB_STEP = 24;

    private final State state;
    private final Grid grid;
    private final Contacts contacts;
    private final GridLevels levels;
    private final Team team;
    /** By worker: each has its own place to work. */
    private final CirclePasses[] movers;

    private final PairVisits[] likeVisits;

    /** By worker, as {@link #likeVisits}. */
    private final PairVisits[] crossVisits;

    /** By worker: what it has where contacts are solved pass after pass. */
    private final Share[] shares;

    private final HeavyCircles heavyCircles;
    private final Bands bands;

    /** Null in steps without joints. */
    private JointPasses joints;

    /** Records what contacts do; null if nobody is told. */
    private Touches touches;

    Solver(State state, Grid grid, Contacts contacts, GridLevels levels, Team team) {
        this.state = state;
        this.grid = grid;
        this.contacts = contacts;
        this.levels = levels;
        this.team = team;
        movers = new CirclePasses[team.most()];
        likeVisits = new PairVisits[team.most()];
        crossVisits = new PairVisits[team.most()];
        shares = new Share[team.most()];
        for (int worker = 0; worker < likeVisits.length; worker++) {
            movers[worker] = new CirclePasses(state);
            likeVisits[worker] = PairVisits.ofLike(state, contacts);
            crossVisits[worker] = PairVisits.ofCross(state, contacts, worker);
            shares[worker] = new Share(grid, levels, contacts.cross());
        }
        heavyCircles = contacts.cross().heavyCircles;
        bands = new Bands(grid, levels, team);
    }

    /** Sets what records the contacts of the steps to come, or null. */
    void record(Touches recorder) {
        touches = recorder;
        for (CirclePasses each : movers) {
            each.walls.touches = recorder == null ? null : recorder.walls;
            each.pieceTouches = recorder == null ? null : recorder.pieces;
        }
        for (PairVisits each : likeVisits) {
            each.touches = recorder;
        }
        for (PairVisits each : crossVisits) {
            each.touches = recorder;
        }
    }

    /** Sets the joints of the steps to come, or null. */
    void join(JointPasses passes) {
        joints = passes;
    }

    /** Fills the contacts, and measures them for the first sub-step. */
    void prepare(int worker, StepConstants k, TerrainStep terrain) {
        movers[worker].beginTerrain(terrain, k);
        if (worker == 0) {
            boolean alike = levels.usedCount == 1;
            bands.divide(contacts.rowStart, alike ? null : contacts.cross(), alike && joints == null ? 2 * LAG : 0);
        }
        movers[worker].begin(team.part(state.awake, worker), team.part(state.awake, worker + 1), k);
        likeVisits[worker].turn(k.turning);
        crossVisits[worker].turn(k.turning);
        if (movers[worker].walls.touches != null) {
            movers[worker].walls.touches.clear(team.part(state.awake, worker), team.part(state.awake, worker + 1));
        }
        if (movers[worker].pieceTouches != null) {
            movers[worker].pieceTouches.clear(team.part(state.awake, worker), team.part(state.awake, worker + 1));
        }
        contacts.beginToFill(worker);
        team.sync(worker);
        for (int l = 0; l < levels.usedCount; l++) {
            int from = contacts.firstRow(levels.used[l], worker);
            int to = contacts.firstRow(levels.used[l], worker + 1);
            for (int row = from; row < to; row += 2) {
                prepare(worker, l, row, k);
                if (row > from) {
                    prepare(worker, l, row - 1, k);
                }
            }
        }
        team.sync(worker);
        for (int l = 0; l < levels.usedCount; l++) {
            int to = contacts.firstRow(levels.used[l], worker + 1);
            if (contacts.firstRow(levels.used[l], worker) < to) {
                prepare(worker, l, to - 1, k);
            }
        }
        team.sync(worker);
        if (joints != null) {
            joints.prepare(worker);
        }
        if (levels.usedCount > 1) {
            shares[worker].takeBands(bands, worker);
            prepareCross(worker, k);
        } else {
            shares[worker].takeSlots(team.part(state.awake, worker), team.part(state.awake, worker + 1));
        }
    }

    private void prepareCross(int worker, StepConstants k) {
        Share share = shares[worker];
        for (int l = 0; l < share.count; l++) {
            heavyCircles.prepare(share.fromHeavy[l], share.toHeavy[l], k);
        }
        team.sync(worker);
        for (int l = 0; l < share.count; l++) {
            int from = firstCross(share, l);
            int to = endCross(share, l);
            contacts.fillCross(worker, from, to, k);
            crossVisits[worker].prepare(from, to);
            if (touches != null) {
                touches.clear(worker, from, to);
            }
        }
        team.sync(worker);
        takeImpulses(share, k);
        team.sync(worker);
    }

    void solve(int worker, StepConstants k) {
        if (levels.usedCount == 1 && joints == null && bands.narrowest() >= 2 * LAG) {
            solveInSweeps(worker, k);
        } else {
            solveInPasses(worker, k);
        }
    }

    // ---- sweeps, where there is one level
    // ----------------------------------------------------------------------------

    private void solveInSweeps(int worker, StepConstants k) {
        int from = bands.first(levels.used[0], worker);
        int to = bands.first(levels.used[0], worker + 1);
        int most = Math.max(1, bands.narrowest() / ROWS_PER_SUB_STEP);
        for (int sub = 0; sub < k.subSteps; sub += most) {
            int end = Math.min(k.subSteps, sub + most);
            sweep(worker, from, to, 1, sub, end, k);
            team.sync(worker);
            sweep(worker, to, to, -1, sub, end, k);
            team.sync(worker);
        }
    }

    /**
     * Makes sub-steps [sub, endSub) on a band of rows: each stage on fewer rows than the one before it (inwards 1), or on more
     * (inwards -1, from an empty band at the edge of two).
     */
    private void sweep(int worker, int low, int high, int inwards, int sub, int endSub, StepConstants k) {
        int lag = LAG * (endSub - sub);
        int end = high + 2 * LAG + (inwards > 0 ? 0 : 2 * lag);
        for (int front = low; front < end; front += 2) {
            int behind = 0;
            for (int s = sub; s < endSub; s++) {
                subStep(worker, front - behind, low + inwards * behind, high - inwards * behind, inwards, s, k);
                behind += LAG;
            }
            if (endSub == k.subSteps) {
                finalizePositions(worker, front - lag, low + inwards * lag, high - inwards * lag, k);
                finalizePositions(worker, front - lag + 1, low + inwards * lag, high - inwards * lag, k);
            }
        }
    }

    /** All stages of a sub-step, each on what of [low, high) it can do, where its sweep has come to an even row. */
    private void subStep(int worker, int row, int low, int high, int inwards, int sub, StepConstants k) {
        if (low <= row && row < high) {
            integrateVelocities(worker, row, sub, k);
            integrateVelocities(worker, row + 1, sub, k);
            solveRow(worker, row, k);
        }
        int from = low + inwards;
        int to = high - inwards;
        if (from <= row - 1 && row - 1 < to) {
            solveRow(worker, row - 1, k);
        }
        integratePositions(worker, row - 2, from, to, sub, k);
        integratePositions(worker, row - 1, from, to, sub, k);
        relaxRow(worker, row - 2, from + inwards, to - inwards, sub, k);
        relaxRow(worker, row - 3, from + 2 * inwards, to - 2 * inwards, sub, k);
    }

    private int ring(int row) {
        return GridLevels.onRing(row, levels.rowCount[levels.used[0]]);
    }

    private int firstSlot(int row) {
        return grid.start[levels.rowStart(levels.used[0], ring(row))];
    }

    private int endSlot(int row) {
        return grid.start[levels.rowStart(levels.used[0], ring(row) + 1)];
    }

    private void integrateVelocities(int worker, int row, int sub, StepConstants k) {
        movers[worker].integrateVelocities(firstSlot(row), endSlot(row), k, sub);
    }

    private void solveRow(int worker, int row, StepConstants k) {
        solve(worker, levels.used[0], ring(row), k);
    }

    private void integratePositions(int worker, int row, int from, int to, int sub, StepConstants k) {
        if (from <= row && row < to) {
            movers[worker].integratePositions(firstSlot(row), endSlot(row), k, sub);
        }
    }

    private void relaxRow(int worker, int row, int from, int to, int sub, StepConstants k) {
        if (from <= row && row < to) {
            relax(worker, levels.used[0], ring(row), sub, k);
        }
    }

    private void finalizePositions(int worker, int row, int from, int to, StepConstants k) {
        if (from <= row && row < to) {
            movers[worker].finalizePositions(firstSlot(row), endSlot(row), k);
        }
    }

    // ---- pass after pass, where there are more levels, or hardly any rows
    // --------------------------------------------

    private void solveInPasses(int worker, StepConstants k) {
        Share share = shares[worker];
        boolean crosses = levels.usedCount > 1;
        for (int sub = 0; sub < k.subSteps; sub++) {
            boolean last = sub == k.subSteps - 1;
            for (int l = 0; l < share.count; l++) {
                movers[worker].integrateVelocities(share.fromSlot[l], share.toSlot[l], k, sub);
            }
            team.sync(worker);
            passOverAll(worker, false, sub, k);
            if (joints != null) {
                joints.solve(worker, sub);
            }
            if (crosses) {
                solveCross(worker, k);
            }
            for (int l = 0; l < share.count; l++) {
                movers[worker].integratePositions(share.fromSlot[l], share.toSlot[l], k, sub);
            }
            team.sync(worker);
            passOverAll(worker, true, sub, k);
            if (joints != null) {
                joints.relax(worker, sub);
            }
            if (crosses) {
                relaxCross(worker, k, last);
            }
        }
        for (int l = 0; l < share.count; l++) {
            movers[worker].finalizePositions(share.fromSlot[l], share.toSlot[l], k);
        }
        team.sync(worker);
    }

    /**
     * A pass over the contacts of circles of one level. The levels share no circle but in cross contacts, so all of them run at the same
     * time.
     */
    private void passOverAll(int worker, boolean relaxes, int sub, StepConstants k) {
        for (int l = 0; l < levels.usedCount; l++) {
            int from = bands.first(levels.used[l], worker);
            int to = bands.first(levels.used[l], worker + 1);
            for (int row = from; row < to; row += 2) {
                pass(worker, levels.used[l], row, relaxes, sub, k);
                if (row > from) {
                    pass(worker, levels.used[l], row - 1, relaxes, sub, k);
                }
            }
        }
        team.sync(worker);
        for (int l = 0; l < levels.usedCount; l++) {
            int to = bands.first(levels.used[l], worker + 1);
            if (bands.first(levels.used[l], worker) < to) {
                pass(worker, levels.used[l], to - 1, relaxes, sub, k);
            }
        }
        team.sync(worker);
    }

    private void pass(int worker, int level, int row, boolean relaxes, int sub, StepConstants k) {
        if (relaxes) {
            relax(worker, level, row, sub, k);
        } else {
            solve(worker, level, row, k);
        }
    }

    // ---- cross contacts
    // ----------------------------------------------------------------------------------------------

    private int firstCross(Share share, int l) {
        return contacts.firstCross + share.fromCross[l];
    }

    private int endCross(Share share, int l) {
        return contacts.firstCross + share.toCross[l];
    }

    private void solveCross(int worker, StepConstants k) {
        Share share = shares[worker];
        look(share);
        team.sync(worker);
        for (int l = 0; l < share.count; l++) {
            crossVisits[worker].solve(firstCross(share, l), endCross(share, l), k);
            if (touches != null) {
                touches.afterSolve(worker, firstCross(share, l), endCross(share, l), k);
            }
        }
        team.sync(worker);
        takeGains(share, k);
        team.sync(worker);
    }

    private void relaxCross(int worker, StepConstants k, boolean last) {
        Share share = shares[worker];
        look(share);
        team.sync(worker);
        for (int l = 0; l < share.count; l++) {
            crossVisits[worker].relax(firstCross(share, l), endCross(share, l), k, last);
            if (touches != null && last) {
                touches.tell(worker, firstCross(share, l), endCross(share, l), k);
            }
        }
        team.sync(worker);
        takeGains(share, k);
        for (int l = 0; l < share.count; l++) {
            heavyCircles.forgetClaims(share.fromHeavy[l], share.toHeavy[l]);
        }
        if (!last) {
            takeImpulses(share, k);
        }
        team.sync(worker);
    }

    private void look(Share share) {
        for (int l = 0; l < share.count; l++) {
            heavyCircles.look(share.fromHeavy[l], share.toHeavy[l]);
        }
    }

    private void takeGains(Share share, StepConstants k) {
        for (int l = 0; l < share.count; l++) {
            heavyCircles.takeGains(share.fromHeavy[l], share.toHeavy[l], k);
        }
    }

    private void takeImpulses(Share share, StepConstants k) {
        for (int l = 0; l < share.count; l++) {
            heavyCircles.takeImpulses(share.fromHeavy[l], share.toHeavy[l], k);
        }
    }

    // ---- rows of contacts
    // --------------------------------------------------------------------------------------------

    private int firstContact(int level, int row) {
        return contacts.rowStart[levels.firstRow[level] + row];
    }

    private void prepare(int worker, int l, int row, StepConstants k) {
        contacts.fillRow(worker, l, row, k);
        int level = levels.used[l];
        likeVisits[worker].prepare(firstContact(level, row), firstContact(level, row + 1));
        if (touches != null) {
            touches.clear(worker, firstContact(level, row), firstContact(level, row + 1));
        }
    }

    private void solve(int worker, int level, int row, StepConstants k) {
        contacts.startResting(firstContact(level, row), firstContact(level, row + 1), k);
        likeVisits[worker].solve(firstContact(level, row), firstContact(level, row + 1), k);
        if (touches != null) {
            touches.afterSolve(worker, firstContact(level, row), firstContact(level, row + 1), k);
        }
    }

    private void relax(int worker, int level, int row, int sub, StepConstants k) {
        likeVisits[worker].relax(firstContact(level, row), firstContact(level, row + 1), k, sub == k.subSteps - 1);
        if (touches != null && sub == k.subSteps - 1) {
            touches.tell(worker, firstContact(level, row), firstContact(level, row + 1), k);
        }
    }
}
