package io.github.circles2d.world.jvm.solver;

import io.github.circles2d.world.jvm.bodies.RigidPasses;
import io.github.circles2d.world.jvm.grid.Grid;
import io.github.circles2d.world.jvm.joints.JointPasses;
import io.github.circles2d.world.jvm.state.State;
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
 * the next band; a second sweep completes them, from the edge outwards. Where bands have few rows, as of a long, low heap, that is half of the
 * work, and not shared evenly; passes, as below, are then faster.
 *
 * <p>If there are more levels, their cross contacts come between the passes; joints do too. So all workers make pass after pass, each on its
 * {@link Share} of all levels. Rigid bodies come between them too ({@link RigidPasses}).
 */
public final class Solver {
    /** Rows that a sub-step is behind the one before it in a sweep, and by which it does less at each edge of a band. */
    private static final int LAG = 4;

    /** Rows at each side of the edge of two bands that the relaxing pass of a sweep leaves to one worker. */
    private static final int LEFT_TO_EDGE = 2;

    /** How much more than passes the worker with most to do may have in sweeps: rows stay in the cache, and workers wait less often. */
    private static final float MOST_IN_SWEEPS = 1.2f;

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

    /** Null in steps without rigid bodies. */
    private RigidPasses rigids;

    /** Records what contacts do; null if nobody is told. */
    private Touches touches;

    private final Team.Work beginAndPrepareRows = this::beginAndPrepareRows;
    private final Team.Work prepareEdge = this::prepareEdge;
    private final Team.Work prepareCross = this::prepareCross;
    private final Team.Work takeImpulses = this::takeImpulses;
    private final Team.Work sweepInwards = this::sweepInwards;
    private final Team.Work sweepOutwards = this::sweepOutwards;
    private final Team.Work integrateVelocities = this::integrateVelocities;
    private final Team.Work integratePositions = this::integratePositions;
    private final Team.Work finalizePositions = this::finalizePositions;
    private final Team.Work passOverRows = this::passOverRows;
    private final Team.Work passOverEdge = this::passOverEdge;
    private final Team.Work look = this::look;
    private final Team.Work solveCross = this::solveCross;
    private final Team.Work relaxCross = this::relaxCross;
    private final Team.Work takeGains = this::takeGains;
    private final Team.Work endRelaxing = this::endRelaxing;

    /** Whether workers sweep over the contacts of the step. */
    private boolean sweeps;

    /**
     * Whether heavy circles take what cross contacts give them in the next stage over circles, as a part of it: then workers wait less often.
     * Rigid bodies need it before.
     */
    private boolean takesLate;

    private StepConstants constants;
    private TerrainStep terrain;

    /** The sub-step, and the one behind the last of a sweep. */
    private int sub;

    private int endSub;

    /** Whether a pass over all rows relaxes. */
    private boolean relaxes;

    public Solver(State state, Grid grid, Contacts contacts, GridLevels levels, Team team) {
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
    public void record(Touches recorder) {
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
    public void join(JointPasses passes) {
        joints = passes;
    }

    /** Sets the rigid bodies of the steps to come, or null. */
    public void push(RigidPasses passes) {
        rigids = passes;
    }

    /** Fills the contacts, and measures them for the first sub-step. */
    public void prepare(StepConstants k, TerrainStep step) {
        constants = k;
        terrain = step;
        boolean alike = levels.usedCount == 1;
        sweeps = alike && !inPasses() && divideForSweeps();
        if (!sweeps) {
            bands.divide(contacts.rowStart, alike ? null : contacts.cross(), 0);
        }
        takesLate = !alike && !k.rigid;
        for (int worker = 0; worker < team.size(); worker++) {
            if (alike) {
                shares[worker].takeSlots(team, state.awake, worker);
            } else {
                shares[worker].takeBands(bands, worker);
            }
        }
        team.all(beginAndPrepareRows);
        team.all(prepareEdge);
        if (joints != null) {
            joints.prepare();
        }
        if (!alike) {
            team.all(prepareCross);
            if (!takesLate) {
                team.all(takeImpulses);
            }
        }
    }

    private void beginAndPrepareRows(int worker) {
        movers[worker].beginTerrain(terrain, constants);
        likeVisits[worker].turn(constants.turning);
        crossVisits[worker].turn(constants.turning);
        for (int l = 0; l < levels.usedCount; l++) {
            int level = levels.used[l];
            begin(
                    worker,
                    grid.start[levels.rowStart(level, contacts.firstRow(level, worker))],
                    grid.start[levels.rowStart(level, contacts.firstRow(level, worker + 1))]);
        }
        contacts.beginToFill(worker);
        prepareRows(worker);
        if (levels.usedCount > 1) {
            prepareHeavyCircles(worker);
        }
    }

    /** Begins a step of the circles of some rows, in which the worker fills contacts next. */
    private void begin(int worker, int from, int to) {
        movers[worker].begin(from, to, constants);
        if (movers[worker].walls.touches != null) {
            movers[worker].walls.touches.clear(from, to);
        }
        if (movers[worker].pieceTouches != null) {
            movers[worker].pieceTouches.clear(from, to);
        }
    }

    private void prepareRows(int worker) {
        for (int l = 0; l < levels.usedCount; l++) {
            int from = contacts.firstRow(levels.used[l], worker);
            int to = contacts.firstRow(levels.used[l], worker + 1);
            for (int row = from; row < to; row += 2) {
                prepare(worker, l, row);
                if (row > from) {
                    prepare(worker, l, row - 1);
                }
            }
        }
    }

    /** The last row of each band, which needs the first one of the next band. */
    private void prepareEdge(int worker) {
        for (int l = 0; l < levels.usedCount; l++) {
            int to = contacts.firstRow(levels.used[l], worker + 1);
            if (contacts.firstRow(levels.used[l], worker) < to) {
                prepare(worker, l, to - 1);
            }
        }
    }

    private void prepareHeavyCircles(int worker) {
        Share share = shares[worker];
        for (int l = 0; l < share.count; l++) {
            heavyCircles.prepare(share.fromHeavy[l], share.toHeavy[l], constants);
        }
    }

    private void prepareCross(int worker) {
        Share share = shares[worker];
        for (int l = 0; l < share.count; l++) {
            int from = firstCross(share, l);
            int to = endCross(share, l);
            contacts.fillCross(worker, from, to, constants);
            crossVisits[worker].prepare(from, to);
            if (touches != null) {
                touches.clear(worker, from, to);
            }
        }
    }

    /** Divides the rows of the only level into bands for sweeps; returns false if passes would share the work much better, as of a long heap. */
    private boolean divideForSweeps() {
        int level = levels.used[0];
        int[] rowStart = contacts.rowStart;
        long passed = Long.MAX_VALUE;
        if (team.size() > 1) {
            bands.divide(rowStart, null, 0);
            passed = bands.heaviest(level, rowStart, 0, 1) + bands.heaviestEdge(level, rowStart, 1, 0);
        }
        bands.divide(rowStart, null, 2 * LAG);
        if (bands.narrowest() < 2 * LAG) {
            return false;
        }
        long swept = bands.heaviest(level, rowStart, LEFT_TO_EDGE, LEFT_TO_EDGE)
                + bands.heaviestEdge(level, rowStart, LEFT_TO_EDGE, LEFT_TO_EDGE);
        return swept <= MOST_IN_SWEEPS * passed;
    }

    /** Whether something comes between the passes over contacts of circles. */
    private boolean inPasses() {
        return joints != null || rigids != null;
    }

    /** With the constants of {@link #prepare}. */
    public void solve() {
        if (sweeps) {
            solveInSweeps();
        } else {
            solveInPasses();
        }
    }

    // ---- sweeps, where there is one level

    private void solveInSweeps() {
        int most = Math.max(1, bands.narrowest() / ROWS_PER_SUB_STEP);
        for (sub = 0; sub < constants.subSteps; sub = endSub) {
            endSub = Math.min(constants.subSteps, sub + most);
            team.all(sweepInwards);
            team.all(sweepOutwards);
        }
    }

    private void sweepInwards(int worker) {
        int level = levels.used[0];
        sweep(worker, bands.first(level, worker), bands.first(level, worker + 1), 1, constants);
    }

    private void sweepOutwards(int worker) {
        int edge = bands.first(levels.used[0], worker + 1);
        sweep(worker, edge, edge, -1, constants);
    }

    /**
     * Makes sub-steps [sub, endSub) on a band of rows: each stage on fewer rows than the one before it (inwards 1), or on more
     * (inwards -1, from an empty band at the edge of two).
     */
    private void sweep(int worker, int low, int high, int inwards, StepConstants k) {
        int begin = sub;
        int finish = endSub;
        int lag = LAG * (finish - begin);
        int end = high + 2 * LAG + (inwards > 0 ? 0 : 2 * lag);
        for (int front = low; front < end; front += 2) {
            int behind = 0;
            for (int s = begin; s < finish; s++) {
                subStep(worker, front - behind, low + inwards * behind, high - inwards * behind, inwards, s, k);
                behind += LAG;
            }
            if (finish == k.subSteps) {
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

    private void solveInPasses() {
        boolean crosses = levels.usedCount > 1;
        for (sub = 0; sub < constants.subSteps; sub++) {
            team.all(integrateVelocities);
            if (rigids != null) {
                rigids.integrateVelocities();
            }
            passOverAll(false);
            if (joints != null) {
                joints.solve(sub);
            }
            if (rigids != null) {
                rigids.solve(sub);
            }
            if (crosses) {
                team.all(look);
                team.all(solveCross);
                if (!takesLate) {
                    team.all(takeGains);
                }
            }
            if (rigids != null) {
                rigids.solveCircles();
            }
            team.all(integratePositions);
            if (rigids != null) {
                rigids.integratePositions(sub);
            }
            passOverAll(true);
            if (joints != null) {
                joints.relax(sub);
            }
            if (rigids != null) {
                rigids.relax(sub, isLast());
            }
            if (crosses) {
                team.all(look);
                team.all(relaxCross);
                if (!takesLate) {
                    team.all(endRelaxing);
                }
            }
            if (rigids != null) {
                rigids.relaxCircles(isLast());
            }
        }
        team.all(finalizePositions);
    }

    private void integrateVelocities(int worker) {
        if (takesLate) {
            if (sub > 0) {
                takeGains(worker);
                forgetClaims(worker);
            }
            takeImpulses(worker);
        }
        Share share = shares[worker];
        for (int l = 0; l < share.count; l++) {
            movers[worker].integrateVelocities(share.fromSlot[l], share.toSlot[l], constants, sub);
        }
    }

    private void integratePositions(int worker) {
        if (takesLate) {
            takeGains(worker);
        }
        Share share = shares[worker];
        for (int l = 0; l < share.count; l++) {
            movers[worker].integratePositions(share.fromSlot[l], share.toSlot[l], constants, sub);
        }
    }

    private void finalizePositions(int worker) {
        if (takesLate) {
            takeGains(worker);
            forgetClaims(worker);
        }
        Share share = shares[worker];
        for (int l = 0; l < share.count; l++) {
            movers[worker].finalizePositions(share.fromSlot[l], share.toSlot[l], constants);
        }
    }

    /**
     * A pass over the contacts of circles of one level. The levels share no circle but in cross contacts, so all of them run at the same
     * time.
     */
    private void passOverAll(boolean relaxing) {
        relaxes = relaxing;
        team.all(passOverRows);
        team.all(passOverEdge);
    }

    private void passOverRows(int worker) {
        for (int l = 0; l < levels.usedCount; l++) {
            int from = bands.first(levels.used[l], worker);
            int to = bands.first(levels.used[l], worker + 1);
            for (int row = from; row < to; row += 2) {
                pass(worker, levels.used[l], row);
                if (row > from) {
                    pass(worker, levels.used[l], row - 1);
                }
            }
        }
    }

    private void passOverEdge(int worker) {
        for (int l = 0; l < levels.usedCount; l++) {
            int to = bands.first(levels.used[l], worker + 1);
            if (bands.first(levels.used[l], worker) < to) {
                pass(worker, levels.used[l], to - 1);
            }
        }
    }

    private void pass(int worker, int level, int row) {
        if (relaxes) {
            relax(worker, level, row, sub, constants);
        } else {
            solve(worker, level, row, constants);
        }
    }

    // ---- cross contacts

    private int firstCross(Share share, int l) {
        return contacts.firstCross + share.fromCross[l];
    }

    private int endCross(Share share, int l) {
        return contacts.firstCross + share.toCross[l];
    }

    private void look(int worker) {
        Share share = shares[worker];
        for (int l = 0; l < share.count; l++) {
            heavyCircles.look(share.fromHeavy[l], share.toHeavy[l]);
        }
    }

    private void solveCross(int worker) {
        Share share = shares[worker];
        for (int l = 0; l < share.count; l++) {
            crossVisits[worker].solve(firstCross(share, l), endCross(share, l), constants);
            if (touches != null) {
                touches.afterSolve(worker, firstCross(share, l), endCross(share, l), constants);
            }
        }
    }

    private void relaxCross(int worker) {
        Share share = shares[worker];
        boolean last = isLast();
        for (int l = 0; l < share.count; l++) {
            crossVisits[worker].relax(firstCross(share, l), endCross(share, l), constants, last);
            if (touches != null && last) {
                touches.tell(worker, firstCross(share, l), endCross(share, l), constants);
            }
        }
    }

    private void endRelaxing(int worker) {
        takeGains(worker);
        forgetClaims(worker);
        if (!isLast()) {
            takeImpulses(worker);
        }
    }

    private void forgetClaims(int worker) {
        Share share = shares[worker];
        for (int l = 0; l < share.count; l++) {
            heavyCircles.forgetClaims(share.fromHeavy[l], share.toHeavy[l]);
        }
    }

    private boolean isLast() {
        return sub == constants.subSteps - 1;
    }

    private void takeGains(int worker) {
        Share share = shares[worker];
        for (int l = 0; l < share.count; l++) {
            heavyCircles.takeGains(share.fromHeavy[l], share.toHeavy[l], constants);
        }
    }

    private void takeImpulses(int worker) {
        Share share = shares[worker];
        for (int l = 0; l < share.count; l++) {
            heavyCircles.takeImpulses(share.fromHeavy[l], share.toHeavy[l], constants);
        }
    }

    // ---- rows of contacts

    private int firstContact(int level, int row) {
        return contacts.rowStart[levels.firstRow[level] + row];
    }

    private void prepare(int worker, int l, int row) {
        contacts.fillRow(worker, l, row, constants);
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
