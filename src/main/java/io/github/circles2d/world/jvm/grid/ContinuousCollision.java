package io.github.circles2d.world.jvm.grid;

import static io.github.circles2d.world.model.CircleRow.ALLOWANCE;
import static io.github.circles2d.world.model.CircleRow.LIMIT;
import static io.github.circles2d.world.model.CircleRow.PATH_X;
import static io.github.circles2d.world.model.CircleRow.PATH_Y;
import static io.github.circles2d.world.model.CircleRow.RADIUS;
import static io.github.circles2d.world.model.CircleRow.RESTITUTION;
import static io.github.circles2d.world.model.CircleRow.VX;
import static io.github.circles2d.world.model.CircleRow.VY;
import static io.github.circles2d.world.model.CircleRow.X;
import static io.github.circles2d.world.model.CircleRow.Y;

import io.github.circles2d.world.jvm.state.Resting;
import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.jvm.threads.SharedInts;
import io.github.circles2d.world.jvm.threads.Team;
import io.github.circles2d.world.model.AxisEdge;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.GridLevels;
import io.github.circles2d.world.model.PairRule;
import io.github.circles2d.world.model.Paths;
import io.github.circles2d.world.model.Reach;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.TimeOfImpact;
import io.github.circles2d.world.model.Tuning;
import io.github.circles2d.world.model.WallMotion;

/**
 * Keeps fast circles from passing through others, and makes them meet as rigid circles would, by docs/step.md. A fast circle stops
 * where it touches another, so in the next step both are a contact with an exact normal.
 *
 * <p>A fast circle looks for others in the cells around its path. In a level in which it would have to look at many cells, the circles
 * look for it instead ({@link ReachGrid}). Several may stop a circle at the same time: what they make of it is a minimum, which needs
 * no order. A static circle that moves, and what it may take along ({@link Carrying}), skip blocks of cells whose circles all move
 * alike.
 */
public final class ContinuousCollision {
    /** Blocks are 4 x 4 cells. */
    private static final int BLOCK_LOG = 2;

    // a block's row in range
    private static final int LOW_X = 0;
    private static final int HIGH_X = 1;
    private static final int LOW_Y = 2;
    private static final int HIGH_Y = 3;
    private static final int RANGE_STRIDE = 4;

    private final State state;
    private final Grid grid;
    private final GridLevels levels;
    private final Team team;
    private final Carrying carrying;
    private final ReachGrid reaches;
    private final SparseGrid sparse;
    private final Ahead[] ahead;

    /** By worker: the circles around the one that it looks at. */
    private final Nearby[] nearby;

    /** By worker: those that rest. */
    private final Resting.Found[] resting;

    /** By slot: the share of its path that a circle can go, as the bits of a float, which sort like the float itself. */
    private int[] timeOfImpact = new int[0];

    /** By slot, as bits: the contact time, which is the share of its path that a circle can go before it touches one that it is close to. */
    private int[] near = new int[0];

    /** By slot, as bits: how far such a one lets it leave its path; negative if it stands at a static one, and may not go on. */
    private int[] allowance = new int[0];

    /** By block: least and greatest path x, least and greatest path y of its circles. */
    private float[] range = new float[0];

    private final Team.Work setFreeClamps = this::setFreeClamps;
    private final Team.Work start = this::start;
    private final Team.Work add = this::add;
    private final Team.Work lookForStops = this::lookForStops;
    private final Team.Work summarize = this::summarize;
    private final Team.Work lookForCarriers = worker -> lookForCarriers(worker, false);
    private final Team.Work noteCarriers = worker -> lookForCarriers(worker, true);
    private final Team.Work setMotionClamps = this::setMotionClamps;

    private StepConstants constants;

    public ContinuousCollision(State state, Grid grid, GridLevels levels, Team team, Ahead[] ahead) {
        this.state = state;
        this.grid = grid;
        this.levels = levels;
        this.team = team;
        this.ahead = ahead;
        carrying = new Carrying(state, grid);
        reaches = new ReachGrid(state, grid, levels, team);
        sparse = new SparseGrid(state, grid, levels, team);
        nearby = Nearby.ofWorkers(grid, levels, team);
        resting = new Resting.Found[team.most()];
        for (int worker = 0; worker < resting.length; worker++) {
            resting[worker] = new Resting.Found();
        }
    }

    public void ensure() {
        carrying.ensure();
        reaches.ensure();
        sparse.ensure();
        if (timeOfImpact.length < state.capacity()) {
            near = new int[state.capacity()];
            allowance = new int[state.capacity()];
            timeOfImpact = new int[state.capacity()];
        }
        int blocks = levels.buckets() >> (2 * BLOCK_LOG);
        if (range.length < RANGE_STRIDE * blocks) {
            range = new float[RANGE_STRIDE * (blocks + (blocks >> 2))];
        }
    }

    public long bytes() {
        return 12L * timeOfImpact.length
                + 4L * range.length
                + carrying.bytes()
                + reaches.bytes()
                + sparse.bytes()
                + aheadBytes();
    }

    private long aheadBytes() {
        long sum = 0;
        for (Ahead each : ahead) {
            sum += each.bytes();
        }
        return sum;
    }

    public void sweep(StepConstants k) {
        for (Ahead each : ahead) {
            each.clear();
        }
        if (!grid.anyFast()) {
            team.all(setFreeClamps);
            return;
        }
        constants = k;
        team.all(start);
        team.all(add);
        sparse.settle();
        team.all(lookForStops);
        if (grid.anyMovingStatic()) {
            team.all(summarize);
            team.all(lookForCarriers);
            team.all(noteCarriers);
        }
        team.all(setMotionClamps);
    }

    private void setFreeClamps(int worker) {
        setFreeClamps(team.part(state.awake, worker), team.part(state.awake, worker + 1));
    }

    private void start(int worker) {
        reaches.clear(worker);
        sparse.clear(worker);
        for (int round = 0; round < team.rounds(); round++) {
            start(team.from(state.awake, worker, round), team.to(state.awake, worker, round), constants);
        }
    }

    private void add(int worker) {
        for (int round = 0; round < team.rounds(); round++) {
            reaches.add(team.from(state.awake, worker, round), team.to(state.awake, worker, round));
            sparse.add(worker, team.from(state.awake, worker, round), team.to(state.awake, worker, round));
        }
    }

    private void lookForStops(int worker) {
        for (int round = 0; round < team.rounds(); round++) {
            lookForStops(worker, team.from(state.awake, worker, round), team.to(state.awake, worker, round));
        }
    }

    private void setMotionClamps(int worker) {
        for (int round = 0; round < team.rounds(); round++) {
            setMotionClamps(team.from(state.awake, worker, round), team.to(state.awake, worker, round), constants);
        }
    }

    /** What a circle must move in a step to look ahead, and against another to matter. */
    private float leastPath(int slot) {
        return Tuning.CAP * (state.isStatic(slot) ? grid.leastRadius() : state.circle[CircleRow.of(slot) + RADIUS]);
    }

    private boolean looksAhead(int slot) {
        return grid.path[slot] > leastPath(slot);
    }

    /** The share of its path after which a circle touches a wall; 1 if the path is not longer than its radius. */
    private float timeOfWalls(int slot, StepConstants k) {
        int s = CircleRow.of(slot);
        float r = state.circle[s + RADIUS];
        if (state.isStatic(slot) || !(grid.path[slot] > r)) {
            return 1f;
        }
        Bounds b = k.bounds;
        float px = state.plan[CircleRow.vector(slot) + X];
        float py = state.plan[CircleRow.vector(slot) + Y];
        WallMotion m = k.walls;
        float tx = TimeOfImpact.timeOfWall(
                state.circle[s + X], px, r, b.minX(), b.maxX(), m.travelFor(0, r), m.travelFor(1, r));
        float ty = TimeOfImpact.timeOfWall(
                state.circle[s + Y], py, r, b.minY(), b.maxY(), m.travelFor(2, r), m.travelFor(3, r));
        return CircleMath.max(CircleMath.min(tx, ty), 0f);
    }

    private void start(int from, int to, StepConstants k) {
        for (int slot = from; slot < to; slot++) {
            timeOfImpact[slot] = Float.floatToRawIntBits(timeOfWalls(slot, k));
            near[slot] = Float.floatToRawIntBits(1f);
            allowance[slot] = Float.floatToRawIntBits(Float.POSITIVE_INFINITY);
            carrying.start(slot);
        }
    }

    private void summarize(int level, int fromRow, int toRow) {
        int w = levels.columnsLog[level];
        int firstBlock = levels.first[level] >> (2 * BLOCK_LOG);
        int columns = 1 << (w - BLOCK_LOG);
        for (int row = fromRow; row < toRow; row++) {
            for (int column = 0; column < columns; column++) {
                float lowX = Float.POSITIVE_INFINITY;
                float highX = Float.NEGATIVE_INFINITY;
                float lowY = Float.POSITIVE_INFINITY;
                float highY = Float.NEGATIVE_INFINITY;
                for (int v = 0; v < 1 << BLOCK_LOG; v++) {
                    int bucket = levels.first[level] + (((row << BLOCK_LOG) + v) << w) + (column << BLOCK_LOG);
                    int end = grid.start[bucket + (1 << BLOCK_LOG)];
                    for (int slot = grid.start[bucket]; slot < end; slot++) {
                        float x = state.plan[CircleRow.vector(slot) + X];
                        float y = state.plan[CircleRow.vector(slot) + Y];
                        lowX = CircleMath.min(x, lowX);
                        highX = CircleMath.max(x, highX);
                        lowY = CircleMath.min(y, lowY);
                        highY = CircleMath.max(y, highY);
                    }
                }
                int k = RANGE_STRIDE * (firstBlock + row * columns + column);
                range[k + LOW_X] = lowX;
                range[k + HIGH_X] = highX;
                range[k + LOW_Y] = lowY;
                range[k + HIGH_Y] = highY;
            }
        }
    }

    /** Finds the pairs in which a fast circle stops. It looks for others itself, or they look for it if it reaches far. */
    private void lookForStops(int worker, int from, int to) {
        boolean notes = levels.bounds.isWalled() && !grid.anyMovingStatic();
        for (int slot = from; slot < to; slot++) {
            boolean looks = looksForStops(slot);
            if (looks) {
                lookForStops(worker, slot, notes);
                lookAtResting(resting[worker], slot);
            }
            int count = reaches.find(worker, slot, looks);
            int[] hits = reaches.hits(worker);
            for (int k = 0; k < count; k++) {
                if (hits[k] != slot) {
                    meetBoth(slot, looks, hits[k]);
                }
            }
        }
    }

    /** Two circles whose reaches meet, of which the other reaches far. Most do not touch by their paths. */
    private void meetBoth(int slot, boolean looks, int other) {
        state.noteSeen(slot, other);
        int touches = mayTouch(slot, other);
        if (looks && (touches != 0 || state.isStatic(other))) {
            meet(slot, other);
        }
        if (touches != 0 || state.isStatic(slot)) {
            meet(other, slot);
        }
    }

    /** Looks at the circles around the path of a fast one, in the levels in which it does not reach far. */
    private void lookForStops(int worker, int slot, boolean notes) {
        int s = CircleRow.of(slot);
        float x = state.circle[s + X];
        float y = state.circle[s + Y];
        float px = state.plan[CircleRow.vector(slot) + X];
        float py = state.plan[CircleRow.vector(slot) + Y];
        float reach = reaches.reaches()[slot];
        int coarser = notes ? grid.level[slot] : 0;
        Ahead seen = ahead[worker];
        if (coarser > 0) {
            seen.begin(slot);
        }
        int l = levels.usedCount - 1;
        for (; l >= 0; l--) {
            int level = levels.used[l];
            if (reach > reaches.farIn(level)) {
                break;
            }
            float margin = Paths.sightMargin(state.circle[s + RADIUS], grid.path[slot], levels.top[level]);
            boolean noted = level < coarser;
            if (noted) {
                margin = CircleMath.max(margin, grid.speculativeDistance[slot] + levels.reach(level));
            }
            float left = CircleMath.min(x, x + px) - margin;
            float right = CircleMath.max(x, x + px) + margin;
            float low = CircleMath.min(y, y + py) - margin;
            float high = CircleMath.max(y, y + py) + margin;
            if (sparse.holds(level)) {
                int count = sparse.find(worker, slot, level, left, right, low, high, reaches.reaches());
                if (noted) {
                    seen.add(sparse.hits(worker), count);
                }
                meetNear(slot, sparse.hits(worker), count);
            } else if (levels.folded[level]) {
                Nearby near = nearby[worker];
                near.begin(level, left, right, low, high, true);
                while (near.next()) {
                    meetNear(slot, near.from, near.to, noted ? seen : null);
                }
            } else {
                meetInRows(slot, level, left, right, low, high, noted ? seen : null);
            }
        }
        if (coarser > 0) {
            seen.end(l + 1);
        }
    }

    private void lookAtResting(Resting.Found found, int slot) {
        if (state.awake == state.n) {
            return;
        }
        float x = state.circle[CircleRow.of(slot) + X];
        float y = state.circle[CircleRow.of(slot) + Y];
        float reach = reaches.reaches()[slot];
        state.resting.find(found, levels.bounds, x - reach, x + reach, y - reach, y + reach);
        for (int k = 0; k < found.count; k++) {
            int other = found.slots[k];
            float r = state.circle[CircleRow.of(other) + RADIUS];
            if (PairRule.isNear(
                            state.differenceX(slot, other),
                            state.differenceY(slot, other),
                            reach,
                            Reach.reachOf(r, 0f, true))
                    != 0) {
                grid.describeResting(other);
                meet(slot, other);
            }
        }
    }

    /** Row by row: a walk that knows of sheets takes longer. */
    private void meetInRows(int slot, int level, float left, float right, float low, float high, Ahead seen) {
        int columns = levels.columnCount[level];
        int rows = levels.rowCount[level];
        int c0 = levels.columnFrom(left, level);
        int c1 = levels.columnTo(left, right, level);
        int r0 = levels.rowFrom(low, level);
        int r1 = levels.rowTo(low, high, level);
        int column = GridLevels.onRing(c0, columns);
        int end = column + Math.min(c1 - c0 + 1, columns);
        int row = GridLevels.onRing(r0, rows);
        for (int v = Math.min(r1 - r0 + 1, rows); v > 0; v--) {
            int b = levels.rowStart(level, row);
            meetNear(slot, grid.start[b + column], grid.start[b + Math.min(end, columns)], seen);
            if (end > columns) {
                meetNear(slot, grid.start[b], grid.start[b + end - columns], seen);
            }
            row = row + 1 < rows ? row + 1 : 0;
        }
    }

    private void meetNear(int slot, int from, int to, Ahead seen) {
        float[] circle = state.circle;
        float[] reach = reaches.reaches();
        float own = reach[slot];
        float x = circle[CircleRow.of(slot) + X];
        float y = circle[CircleRow.of(slot) + Y];
        for (int other = from; other < to; other++) {
            float dx = circle[CircleRow.of(other) + X] - x;
            float dy = circle[CircleRow.of(other) + Y] - y;
            if (state.wraps) {
                dx = CircleMath.shortWay(dx, state.periodX);
                dy = CircleMath.shortWay(dy, state.periodY);
            }
            if (PairRule.isNear(dx, dy, own, reach[other]) != 0 && other != slot) {
                if (seen != null) {
                    seen.add(other);
                }
                state.noteSeen(slot, other);
                if (mayTouch(slot, other) != 0 || state.isStatic(other)) {
                    meet(slot, other);
                }
            }
        }
    }

    private void meetNear(int slot, int[] near, int count) {
        for (int k = 0; k < count; k++) {
            int other = near[k];
            if (other != slot) {
                state.noteSeen(slot, other);
            }
            if (other != slot && (mayTouch(slot, other) != 0 || state.isStatic(other))) {
                meet(slot, other);
            }
        }
    }

    private boolean looksForStops(int slot) {
        return looksAhead(slot) && !state.isStatic(slot);
    }

    private void summarize(int worker) {
        for (int l = 0; l < levels.usedCount; l++) {
            int level = levels.used[l];
            int rows = 1 << (levels.rowsLog[level] - BLOCK_LOG);
            summarize(level, team.part(rows, worker), team.part(rows, worker + 1));
        }
    }

    /** The first time for when circles are taken along, the second to note by which static circle. */
    private void lookForCarriers(int worker, boolean note) {
        for (int round = 0; round < team.rounds(); round++) {
            int to = team.to(state.awake, worker, round);
            for (int slot = team.from(state.awake, worker, round); slot < to; slot++) {
                if (looksAhead(slot)) {
                    lookAhead(nearby[worker], slot, note);
                }
            }
        }
    }

    /** A fast circle looks for those that it may take along, or that may take it along. */
    private void lookAhead(Nearby near, int slot, boolean note) {
        int s = CircleRow.of(slot);
        float x = state.circle[s + X];
        float y = state.circle[s + Y];
        float r = state.circle[s + RADIUS];
        float px = state.plan[CircleRow.vector(slot) + X];
        float py = state.plan[CircleRow.vector(slot) + Y];
        for (int l = 0; l < levels.usedCount; l++) {
            int level = levels.used[l];
            float top = levels.top[level];
            float path = state.isStatic(slot)
                    ? Paths.carriedPath(grid.path[slot], grid.longestPath(), top)
                    : grid.path[slot];
            float margin = Paths.sightMargin(r, path, top);
            int columns = levels.columnCount[level];
            int rows = levels.rowCount[level];
            float edge = levels.inverseEdge[level];
            float below = CircleMath.min(y, y + py) - margin;
            int r0 = levels.rowFrom(below, level);
            int r1 = levels.rowTo(below, CircleMath.max(y, y + py) + margin, level);
            // A static circle may cross the arena: it looks at its path piece by piece, unless its rows meet again on
            // the ring.
            boolean byPieces = state.isStatic(slot) && levels.bounds.edgeY() == AxisEdge.WALL && r1 - r0 < rows;
            int rowsAtOnce = byPieces ? 1 << BLOCK_LOG : rows;
            for (int v = r0; v <= Math.min(r1, r0 + rows - 1); v += rowsAtOnce) {
                int end = Math.min(v + rowsAtOnce, byPieces ? r1 + 1 : r0 + rows);
                float low = byPieces ? levels.minY + v / edge - margin : Float.NEGATIVE_INFINITY;
                float high = byPieces ? levels.minY + end / edge + margin : Float.POSITIVE_INFINITY;
                float left = Paths.leastBetween(x, px, y, py, low, high) - margin;
                float right = Paths.greatestBetween(x, px, y, py, low, high) + margin;
                int c0 = levels.columnFrom(left, level);
                int c1 = levels.columnTo(left, right, level);
                if (c1 - c0 < columns && r1 - r0 < rows) {
                    near.setSheets(
                            level, levels.sheetX(left, level), byPieces ? v / rows : levels.sheetY(below, level));
                } else {
                    near.forgetSheets();
                }
                lookAt(near, slot, level, c0, Math.min(c1, c0 + columns - 1), v, Math.min(end - 1, r1), note);
            }
        }
    }

    private void lookAt(Nearby near, int slot, int level, int c0, int c1, int r0, int r1, boolean note) {
        int w = levels.columnsLog[level];
        int columns = levels.columnCount[level];
        int rows = levels.rowCount[level];
        int firstBlock = levels.first[level] >> (2 * BLOCK_LOG);
        float least = leastPath(slot);
        float px = state.plan[CircleRow.vector(slot) + X];
        float py = state.plan[CircleRow.vector(slot) + Y];
        for (int v = r0; v <= r1; ) {
            int row = GridLevels.onRing(v, rows);
            int rowsOfBlock = inBlock(row, rows, r1 - v);
            for (int u = c0; u <= c1; ) {
                int column = GridLevels.onRing(u, columns);
                int columnsOfBlock = inBlock(column, columns, c1 - u);
                int k = RANGE_STRIDE * (firstBlock + (row >> BLOCK_LOG << (w - BLOCK_LOG)) + (column >> BLOCK_LOG));
                if (state.isStatic(slot)
                        || Paths.differ(
                                px,
                                py,
                                range[k + LOW_X],
                                range[k + HIGH_X],
                                range[k + LOW_Y],
                                range[k + HIGH_Y],
                                least)) {
                    boolean isBeyondX = GridLevels.onRing(c0, columns) + (u - c0) >= columns;
                    boolean isBeyondY = GridLevels.onRing(r0, rows) + (v - r0) >= rows;
                    near.beginBlock(level, column, columnsOfBlock, isBeyondX, row, rowsOfBlock, isBeyondY);
                    while (near.next()) {
                        meetAll(slot, near.from, near.to, least, note);
                    }
                }
                u += columnsOfBlock;
            }
            v += rowsOfBlock;
        }
    }

    /** How many columns (or rows) from one on lie in its block, of those on the ring and no more than so many behind it. */
    private static int inBlock(int column, int side, int most) {
        int blockEnd = (column | ((1 << BLOCK_LOG) - 1)) + 1;
        return Math.min(Math.min(blockEnd, side) - column, most + 1);
    }

    private void meetAll(int slot, int from, int to, float least, boolean note) {
        for (int other = from; other < to; other++) {
            if (other != slot) {
                meetCarrier(slot, other, least, note);
            }
        }
    }

    /** Whether two circles may touch in the step: -1, or 0, as for most. */
    private int mayTouch(int slot, int other) {
        float ux = state.plan[CircleRow.vector(slot) + X] - state.plan[CircleRow.vector(other) + X];
        float uy = state.plan[CircleRow.vector(slot) + Y] - state.plan[CircleRow.vector(other) + Y];
        float radii = state.circle[CircleRow.of(slot) + RADIUS] + state.circle[CircleRow.of(other) + RADIUS];
        return PairRule.mayTouch(state.differenceX(slot, other), state.differenceY(slot, other), ux, uy, radii);
    }

    private void meet(int slot, int other) {
        float[] circle = state.circle;
        float[] plan = state.plan;
        int s = CircleRow.of(slot);
        int o = CircleRow.of(other);
        float ux = plan[CircleRow.vector(slot) + X] - plan[CircleRow.vector(other) + X];
        float uy = plan[CircleRow.vector(slot) + Y] - plan[CircleRow.vector(other) + Y];
        if (!CircleMath.isLonger(ux, uy, leastPath(slot)) || !PairFilter.mayMeet(state, slot, other)) {
            return;
        }
        float r = circle[s + RADIUS];
        float ro = circle[o + RADIUS];
        boolean isStatic = state.isStatic(other);
        if (!isStatic && !Paths.sweeps(r, ro)) {
            return;
        }
        float dx = state.differenceX(slot, other);
        float dy = state.differenceY(slot, other);
        if (isStatic && PairRule.isNear(dx, dy, r + grid.path[slot], ro) != 0) {
            restrain(slot, Tuning.CLAMP_ALLOWANCE * r, false);
        }
        // first what most pairs fail
        float graze = Paths.deepestGraze(r, ro);
        float t = TimeOfImpact.timeOfImpactBeyond(dx, dy, ux, uy, r + ro, graze);
        if (!(t < 1f) || isStatic && carrying.pushes(other, r)) {
            return;
        }
        boolean isNear = PairRule.isNear(dx, dy, grid.speculativeDistance[slot], grid.speculativeDistance[other]) != 0;
        if (isNear && !CircleMath.isLonger(ux, uy, (0.5f * Tuning.CAP) * (r + ro))) {
            return;
        }
        float lost = 1f - CircleMath.max(state.traits[s + RESTITUTION], state.traits[o + RESTITUTION]);
        boolean isDull = CircleMath.isLonger(lost * ux, lost * uy, Tuning.DULL * r);
        if (!isStatic && isDull && CircleMath.isLonger(ux, uy, r) && !looksAhead(other)) {
            float px = plan[CircleRow.vector(slot) + X];
            float py = plan[CircleRow.vector(slot) + Y];
            float qx = plan[CircleRow.vector(other) + X];
            float qy = plan[CircleRow.vector(other) + Y];
            t = TimeOfImpact.beforeSlow(t, dx, dy, px, py, qx, qy, (r + ro) + graze);
        }
        float slack = isStatic ? Tuning.MARGIN : Tuning.HOLD;
        if (isNear && PairRule.isNear(dx, dy, r + slack * r, ro + slack * ro) != 0) {
            hold(slot, t, Paths.holdAllowance(r, grid.path[slot], ro, isStatic, isDull), isStatic);
        } else if (isStatic) {
            if (grid.path[other] == 0f) {
                shorten(slot, t);
            }
        } else if (grid.path[other] <= grid.path[slot] || !looksAhead(other)) {
            shorten(slot, t);
            if (looksAhead(other)) {
                shorten(other, t);
            }
        }
    }

    /** As {@link #meet}, for a pair of which one is static and moves. Its faster circle finds it, or both do. */
    private void meetCarrier(int slot, int other, float least, boolean note) {
        if (!PairFilter.mayMeet(state, slot, other)) {
            return;
        }
        float path = grid.path[slot];
        float pathOfOther = grid.path[other];
        if (state.isStatic(slot)) {
            float r = state.circle[CircleRow.of(other) + RADIUS];
            if (pathOfOther <= path + Tuning.CAP * r) {
                carrying.meet(slot, other, freeShare(other), note);
            }
        } else if (state.isStatic(other) && pathOfOther > 0f) {
            float ux = state.plan[CircleRow.vector(slot) + X] - state.plan[CircleRow.vector(other) + X];
            float uy = state.plan[CircleRow.vector(slot) + Y] - state.plan[CircleRow.vector(other) + Y];
            if (CircleMath.isLonger(ux, uy, least)) {
                carrying.meet(other, slot, freeShare(slot), note);
            }
        }
    }

    /** The share of its path that a circle goes if no static one takes it along. */
    private float freeShare(int slot) {
        return CircleMath.min(Float.intBitsToFloat(timeOfImpact[slot]), Float.intBitsToFloat(near[slot]));
    }

    /** Ends the path of a circle where it touches one that it has a contact with, and says how far it may leave it. */
    private void hold(int slot, float t, float most, boolean isStatic) {
        lower(near, slot, t);
        restrain(slot, most, isStatic);
    }

    private void restrain(int slot, float most, boolean isStatic) {
        int seen = SharedInts.get(allowance, slot);
        int next = restrained(seen, most, isStatic);
        while (next != seen && !SharedInts.compareAndSet(allowance, slot, seen, next)) {
            seen = SharedInts.get(allowance, slot);
            next = restrained(seen, most, isStatic);
        }
    }

    private static int restrained(int bits, float most, boolean isStatic) {
        float allowance = Float.intBitsToFloat(bits);
        float least = CircleMath.min(most, Math.abs(allowance));
        return Float.floatToRawIntBits(isStatic || allowance < 0f ? -least : least);
    }

    private void shorten(int slot, float t) {
        lower(timeOfImpact, slot, t);
    }

    /** Lowers a share of a path: as bits, since these sort like the float itself. */
    private static void lower(int[] shares, int slot, float t) {
        int bits = Float.floatToRawIntBits(t);
        int seen = shares[slot];
        while (bits < seen && !SharedInts.compareAndSet(shares, slot, seen, bits)) {
            seen = SharedInts.get(shares, slot);
        }
    }

    /** Sets the motion clamps where no circle is fast. */
    private void setFreeClamps(int from, int to) {
        float[] clamp = state.motionClamp;
        for (int slot = from; slot < to; slot++) {
            int s = CircleRow.of(slot);
            clamp[s + PATH_X] = state.plan[CircleRow.vector(slot) + X];
            clamp[s + PATH_Y] = state.plan[CircleRow.vector(slot) + Y];
            clamp[s + ALLOWANCE] = state.freeAllowance(slot);
            clamp[s + LIMIT] = 1f;
        }
    }

    private void setMotionClamps(int from, int to, StepConstants k) {
        float[] clamp = state.motionClamp;
        float[] plan = state.plan;
        for (int slot = from; slot < to; slot++) {
            int s = CircleRow.of(slot);
            float px = plan[CircleRow.vector(slot) + X];
            float py = plan[CircleRow.vector(slot) + Y];
            float free = Float.intBitsToFloat(timeOfImpact[slot]);
            float r = state.circle[s + RADIUS];
            float limit = Float.intBitsToFloat(near[slot]);
            float allowed = limit < 1f ? Float.intBitsToFloat(allowance[slot]) : state.freeAllowance(slot);
            float own = CircleMath.min(CircleMath.min(free, limit), carrying.time(slot));
            boolean carried = carrying.isCarried(slot);
            boolean stops = free < limit || carrying.time(slot) < 1f;
            if (carried || stops) {
                px = own * px;
                py = own * py;
                allowed = 0f;
                if (carried) {
                    px += carrying.x(slot);
                    py += carrying.y(slot);
                    allowed = carrying.allowance(slot);
                }
            } else if (allowed >= 0f) {
                px = limit * px;
                py = limit * py;
            }
            if (stops) {
                grid.speculativeDistance[slot] = Paths.speculativeDistance(r, 0f);
                state.motion[s + VX] -= (1f - own) * (state.gainX(slot, k) * k.subSteps);
                state.motion[s + VY] -= (1f - own) * (state.gainY(slot, k) * k.subSteps);
            }
            clamp[s + PATH_X] = px;
            clamp[s + PATH_Y] = py;
            clamp[s + ALLOWANCE] = allowed;
            clamp[s + LIMIT] = limit;
        }
    }
}
