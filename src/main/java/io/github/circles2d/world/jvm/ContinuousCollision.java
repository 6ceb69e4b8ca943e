package io.github.circles2d.world.jvm;

import static io.github.circles2d.world.model.CircleRow.ALLOWANCE;
import static io.github.circles2d.world.model.CircleRow.LIMIT;
import static io.github.circles2d.world.model.CircleRow.PATH_X;
import static io.github.circles2d.world.model.CircleRow.PATH_Y;
import static io.github.circles2d.world.model.CircleRow.RADIUS;
import static io.github.circles2d.world.model.CircleRow.VX;
import static io.github.circles2d.world.model.CircleRow.VY;
import static io.github.circles2d.world.model.CircleRow.X;
import static io.github.circles2d.world.model.CircleRow.Y;

import io.github.circles2d.world.jvm.threads.Team;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.GridLevels;
import io.github.circles2d.world.model.PairRule;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.Tuning;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;

/**
 * Continuous collision: keeps fast circles from passing through others, and makes them meet as rigid circles would. A circle is
 * fast if its path in this step is longer than its speculative distance covers. It stops where it touches another on their straight
 * paths, and another fast one stops there too. In the next step both are a contact with an exact normal. If they are so close
 * already that their contact solves them in this step, their paths end where they touch, but they may bounce off. A static circle is
 * never stopped: one that moves looks ahead too, and takes along what it comes upon for the rest of the step.
 *
 * <p>The motion clamp then holds every circle: a collision may lead it away from its path by a part of its radius. At a static
 * circle it may not go on along its path at all, or it would squeeze through narrow gaps.
 *
 * <p>The faster circle of a pair finds it, in the cells around its path. Only pairs count that move against each other by more than
 * speculative distances cover, so a circle skips blocks of cells whose circles all move much like itself. A circle that is stopped
 * loses time, at most one step, and with it what gravity would give it in that time: so its energy stays.
 */
public final class ContinuousCollision {
    private static final VarHandle INTS = MethodHandles.arrayElementVarHandle(int[].class);

    /** Blocks are 4 x 4 cells. */
    private static final int BLOCK_LOG = 2;

    // a block's row in range
    private static final int LOW_X = 0;
    private static final int HIGH_X = 1;
    private static final int LOW_Y = 2;
    private static final int HIGH_Y = 3;
    private static final int RANGE_STRIDE = 4;

    private static final int NOBODY = Integer.MAX_VALUE;

    private final State state;
    private final Grid grid;
    private final GridLevels levels;
    private final Team team;

    /** By slot: the share of its path that a circle can go, as the bits of a float, which sort like the float itself. */
    private int[] timeOfImpact = new int[0];

    /** By slot: the contact time, which is the share of its path that a circle can go before it touches one that it is close to. */
    private float[] near = new float[0];

    /** By slot: how far such a one lets it leave its path; negative if it stands at a static one, and may not go on. */
    private float[] allowance = new float[0];

    /** By slot: the static circle that moves and that a circle touches at the end of its share; {@link #NOBODY}. */
    private int[] pusher = new int[0];

    /** By block: least and greatest path x, least and greatest path y of its circles. */
    private float[] range = new float[0];

    ContinuousCollision(State state, Grid grid, GridLevels levels, Team team) {
        this.state = state;
        this.grid = grid;
        this.levels = levels;
        this.team = team;
    }

    void ensure() {
        if (timeOfImpact.length < state.capacity()) {
            timeOfImpact = new int[state.capacity()];
            near = new float[state.capacity()];
            allowance = new float[state.capacity()];
            pusher = new int[state.capacity()];
        }
        int blocks = levels.buckets() >> (2 * BLOCK_LOG);
        if (range.length < RANGE_STRIDE * blocks) {
            range = new float[RANGE_STRIDE * (blocks + (blocks >> 2))];
        }
    }

    /** Memory of the arrays. */
    long bytes() {
        return 16L * timeOfImpact.length + 4L * range.length;
    }

    void sweep(int worker, StepConstants constants) {
        int from = team.part(state.n, worker);
        int to = team.part(state.n, worker + 1);
        if (!grid.anyFast()) {
            setFreeClamps(from, to);
            return;
        }
        start(from, to, constants);
        for (int l = 0; l < levels.usedCount; l++) {
            int level = levels.used[l];
            int rows = 1 << (levels.rowsLog[level] - BLOCK_LOG);
            summarize(level, team.part(rows, worker), team.part(rows, worker + 1));
        }
        team.sync(worker);
        lookAhead(from, to, false);
        team.sync(worker);
        if (grid.anyMovingStatic()) {
            lookAhead(from, to, true);
            team.sync(worker);
        }
        setMotionClamps(from, to, constants);
        team.sync(worker);
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
        float tx = CircleMath.timeOfWall(state.circle[s + X], px, r, b.minX(), b.maxX());
        float ty = CircleMath.timeOfWall(state.circle[s + Y], py, r, b.minY(), b.maxY());
        return CircleMath.greatest(CircleMath.least(tx, ty), 0f);
    }

    private void start(int from, int to, StepConstants k) {
        for (int slot = from; slot < to; slot++) {
            timeOfImpact[slot] = Float.floatToRawIntBits(timeOfWalls(slot, k));
            near[slot] = 1f;
            allowance[slot] = Float.POSITIVE_INFINITY;
            pusher[slot] = NOBODY;
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
                        lowX = CircleMath.least(x, lowX);
                        highX = CircleMath.greatest(x, highX);
                        lowY = CircleMath.least(y, lowY);
                        highY = CircleMath.greatest(y, highY);
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

    private void lookAhead(int from, int to, boolean forPushers) {
        for (int slot = from; slot < to; slot++) {
            if (looksAhead(slot)) {
                lookAhead(slot, forPushers);
            }
        }
    }

    /** Looks for circles that a fast one would touch, no faster than itself; the second time, for who pushes whom. */
    private void lookAhead(int slot, boolean forPushers) {
        int s = CircleRow.of(slot);
        float x = state.circle[s + X];
        float y = state.circle[s + Y];
        float r = state.circle[s + RADIUS];
        float path = grid.path[slot];
        float px = state.plan[CircleRow.vector(slot) + X];
        float py = state.plan[CircleRow.vector(slot) + Y];
        for (int l = 0; l < levels.usedCount; l++) {
            int level = levels.used[l];
            float top = levels.top[level];
            float margin = CircleMath.sightMargin(r, path, top);
            int columns = levels.columnCount[level];
            int rows = levels.rowCount[level];
            float edge = levels.inverseEdge[level];
            int c0 = CircleMath.cell(CircleMath.least(x, x + px) - margin, levels.minX, edge);
            int c1 = CircleMath.cell(CircleMath.greatest(x, x + px) + margin, levels.minX, edge);
            int r0 = CircleMath.cell(CircleMath.least(y, y + py) - margin, levels.minY, edge);
            int r1 = CircleMath.cell(CircleMath.greatest(y, y + py) + margin, levels.minY, edge);
            lookAt(slot, level, c0, Math.min(c1, c0 + columns - 1), r0, Math.min(r1, r0 + rows - 1), forPushers);
        }
    }

    private void lookAt(int slot, int level, int c0, int c1, int r0, int r1, boolean forPushers) {
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
                if (CircleMath.differ(
                        px, py, range[k + LOW_X], range[k + HIGH_X], range[k + LOW_Y], range[k + HIGH_Y], least)) {
                    for (int r = row; r < row + rowsOfBlock; r++) {
                        int first = levels.rowStart(level, r) + column;
                        meetAll(slot, grid.start[first], grid.start[first + columnsOfBlock], least, forPushers);
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

    private void meetAll(int slot, int from, int to, float least, boolean forPushers) {
        for (int other = from; other < to; other++) {
            if (other != slot) {
                meet(slot, other, least, forPushers);
            }
        }
    }

    private void meet(int slot, int other, float least, boolean forPushers) {
        float[] circle = state.circle;
        float[] plan = state.plan;
        int s = CircleRow.of(slot);
        int o = CircleRow.of(other);
        float ux = plan[CircleRow.vector(slot) + X] - plan[CircleRow.vector(other) + X];
        float uy = plan[CircleRow.vector(slot) + Y] - plan[CircleRow.vector(other) + Y];
        if (!CircleMath.isLonger(ux, uy, least) || !PairFilter.mayMeet(state, slot, other)) {
            return;
        }
        float r = circle[s + RADIUS];
        float ro = circle[o + RADIUS];
        boolean pushes = state.isStatic(slot);
        boolean stands = state.isStatic(other);
        if (!pushes && !stands && !CircleMath.sweeps(r, ro)) {
            return;
        }
        float dx = circle[o + X] - circle[s + X];
        float dy = circle[o + Y] - circle[s + Y];
        if (stands && PairRule.isNear(dx, dy, r + grid.path[slot], ro) != 0) {
            restrain(slot, Tuning.CLAMP_ALLOWANCE * r, allowance[slot] < 0f);
        }
        // first what most pairs fail
        float t = CircleMath.timeOfImpact(dx, dy, ux, uy, r + ro);
        if (!(t < 1f)) {
            return;
        }
        boolean carries = pushes && carries(slot, ro) || stands && carries(other, r);
        if (PairRule.isNear(dx, dy, grid.speculativeDistance[slot], grid.speculativeDistance[other]) != 0
                && !carries
                && !CircleMath.isLonger(ux, uy, (0.5f * Tuning.CAP) * (r + ro))) {
            return;
        }
        float slack = pushes || stands ? Tuning.MARGIN : Tuning.HOLD;
        if (!carries && PairRule.isNear(dx, dy, r + slack * r, ro + slack * ro) != 0) {
            if (!pushes && !forPushers) {
                hold(slot, t, CircleMath.holdAllowance(r, grid.path[slot], ro, stands), stands);
            }
        } else if (forPushers) {
            if (pushes && timeOfImpact[other] == Float.floatToRawIntBits(t)) {
                push(slot, other);
            } else if (stands && grid.path[other] > 0f && timeOfImpact[slot] == Float.floatToRawIntBits(t)) {
                push(other, slot);
            }
        } else if (pushes) {
            shorten(other, t);
        } else if (stands) {
            shorten(slot, t);
        } else if (grid.path[other] <= grid.path[slot] || !looksAhead(other)) {
            shorten(slot, t);
            if (looksAhead(other)) {
                shorten(other, t);
            }
        }
    }

    /** Whether a static circle moves so far in the step that it pushes one of a radius along. */
    private boolean carries(int slot, float r) {
        return CircleMath.isFast(grid.path[slot], r);
    }

    /** Ends the path of a circle where it touches one that it has a contact with, and says how far it may leave it. */
    private void hold(int slot, float t, float most, boolean stands) {
        near[slot] = CircleMath.least(t, near[slot]);
        restrain(slot, most, stands || allowance[slot] < 0f);
    }

    private void restrain(int slot, float most, boolean stands) {
        float least = CircleMath.least(most, Math.abs(allowance[slot]));
        allowance[slot] = stands ? -least : least;
    }

    private void push(int slot, int pushed) {
        int seen = pusher[pushed];
        while (slot < seen && !INTS.compareAndSet(pusher, pushed, seen, slot)) {
            seen = (int) INTS.getVolatile(pusher, pushed);
        }
    }

    private void shorten(int slot, float t) {
        int bits = Float.floatToRawIntBits(t);
        int seen = timeOfImpact[slot];
        while (bits < seen && !INTS.compareAndSet(timeOfImpact, slot, seen, bits)) {
            seen = (int) INTS.getVolatile(timeOfImpact, slot);
        }
    }

    /** Sets the motion clamps where no circle is fast. */
    private void setFreeClamps(int from, int to) {
        float[] clamp = state.motionClamp;
        for (int slot = from; slot < to; slot++) {
            int s = CircleRow.of(slot);
            clamp[s + PATH_X] = state.plan[CircleRow.vector(slot) + X];
            clamp[s + PATH_Y] = state.plan[CircleRow.vector(slot) + Y];
            clamp[s + ALLOWANCE] = Tuning.CLAMP_ALLOWANCE * state.circle[s + RADIUS];
            clamp[s + LIMIT] = 1f;
        }
    }

    /** Sets the motion clamps. */
    private void setMotionClamps(int from, int to, StepConstants k) {
        float[] clamp = state.motionClamp;
        float[] plan = state.plan;
        for (int slot = from; slot < to; slot++) {
            int s = CircleRow.of(slot);
            float px = plan[CircleRow.vector(slot) + X];
            float py = plan[CircleRow.vector(slot) + Y];
            float free = Float.intBitsToFloat(timeOfImpact[slot]);
            float r = state.circle[s + RADIUS];
            float limit = near[slot];
            float allowed = limit < 1f ? allowance[slot] : Tuning.CLAMP_ALLOWANCE * r;
            if (free < limit) {
                float rest = 1f - free;
                px = free * px;
                py = free * py;
                allowed = 0f;
                if (pusher[slot] != NOBODY) {
                    int p = CircleRow.vector(pusher[slot]);
                    px += rest * plan[p + X];
                    py += rest * plan[p + Y];
                    allowed = carries(pusher[slot], r) ? Tuning.CARRIED : 0f;
                }
                grid.speculativeDistance[slot] = CircleMath.speculativeDistance(r, 0f);
                state.motion[s + VX] -= rest * (state.gainX(slot, k) * k.subSteps);
                state.motion[s + VY] -= rest * (state.gainY(slot, k) * k.subSteps);
            } else if (allowed >= 0f) {
                px = limit * px;
                py = limit * py;
            }
            clamp[s + PATH_X] = px;
            clamp[s + PATH_Y] = py;
            clamp[s + ALLOWANCE] = allowed;
            clamp[s + LIMIT] = limit;
        }
    }
}
