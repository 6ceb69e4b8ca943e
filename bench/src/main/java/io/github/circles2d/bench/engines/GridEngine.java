package io.github.circles2d.bench.engines;

import io.github.circles2d.scenes.Scene;
import java.util.Arrays;

/**
 * What a good Java programmer would write without help: one thread, arrays of floats, a uniform grid, and the soft step of
 * E. Catto's "Solver2D" (2024): four sub-steps, warm starting, a pass that pushes overlaps out and one that takes the speed
 * of the push-out away again, restitution at the end of the step. Contacts are solved one after the other, in the order in
 * which the grid gives them. Circles are put in the order of their cells once, when the scene is loaded, so that neighbours
 * are near each other in memory.
 */
final class GridEngine implements Engine {
    private static final int SUB_STEPS = 4;

    /** A pair is listed from this gap on, in mean radii, even if nothing moves. */
    private static final float MARGIN = 0.05f;

    /** Motion within a step that is looked ahead for, in greatest radii. */
    private static final float LOOK_AHEAD = 0.25f;

    private static final float DAMPING = 10;

    /** Greatest push-out speed, and the speed from which impacts bounce, in mean radii a second. */
    private static final float PUSH = 2.4f;

    private static final float BOUNCE = 0.8f;

    private Scene scene;
    private int n;

    /** By place: the scene's number of the circle there. */
    private int[] number;

    private float[] x;
    private float[] y;
    private float[] vx;
    private float[] vy;
    private float[] radius;
    private float[] restitution;

    /** Inverse mass, 0 for a static circle. */
    private float[] weight;

    /** Impulses of the walls a mass, positive where the lower wall pushes. */
    private float[] wallX;

    private float[] wallY;

    /** Velocities at the start of the step, for the bounce off walls. */
    private float[] startVx;

    private float[] startVy;
    private float meanRadius;
    private float greatestRadius;

    private float perEdge;
    private int columns;
    private int rows;
    private int[] cellStart;
    private int[] cellOf;
    private int[] inCells;

    private Contacts now = new Contacts();
    private Contacts before = new Contacts();

    /** Contacts by the circle of the lower place: those of i are from {@code start[i]} to {@code start[i + 1]}. */
    private static final class Contacts {
        int count;
        int[] start;
        int[] low = new int[1024];
        int[] high = new int[1024];
        float[] impulse = new float[1024];
        float[] greatestImpulse = new float[1024];
        float[] mass = new float[1024];
        float[] nx = new float[1024];
        float[] ny = new float[1024];
        float[] approach = new float[1024];

        void add(int i, int j, float effectiveMass) {
            if (count == low.length) {
                int room = 2 * count;
                low = Arrays.copyOf(low, room);
                high = Arrays.copyOf(high, room);
                impulse = Arrays.copyOf(impulse, room);
                greatestImpulse = Arrays.copyOf(greatestImpulse, room);
                mass = Arrays.copyOf(mass, room);
                nx = Arrays.copyOf(nx, room);
                ny = Arrays.copyOf(ny, room);
                approach = Arrays.copyOf(approach, room);
            }
            low[count] = i;
            high[count] = j;
            mass[count] = effectiveMass;
            count++;
        }

        /** The impulse of a pair; 0 where it was none. */
        float impulseOf(int i, int j) {
            for (int c = start[i]; c < start[i + 1]; c++) {
                if (high[c] == j) {
                    return impulse[c];
                }
            }
            return 0;
        }
    }

    @Override
    public void load(Scene start) {
        scene = start;
        n = start.size();
        layOutGrid();
        cellOf = new int[n];
        inCells = new int[n];
        cellStart = new int[columns * rows + 1];
        sortIntoCells(start.x(), start.y());
        number = inCells.clone();
        x = placed(start.x());
        y = placed(start.y());
        vx = placed(start.vx());
        vy = placed(start.vy());
        radius = placed(start.radius());
        weight = new float[n];
        restitution = new float[n];
        for (int i = 0; i < n; i++) {
            weight[i] = start.fixed(number[i]) ? 0 : 1 / start.mass(number[i]);
            restitution[i] = start.restitution(number[i]);
        }
        wallX = new float[n];
        wallY = new float[n];
        startVx = new float[n];
        startVy = new float[n];
        now.count = 0;
        now.start = new int[n + 1];
        before.start = new int[n + 1];
    }

    private void layOutGrid() {
        double sum = 0;
        greatestRadius = 0;
        for (int i = 0; i < n; i++) {
            sum += scene.radius(i);
            greatestRadius = Math.max(greatestRadius, scene.radius(i));
        }
        meanRadius = (float) (sum / n);
        float edge = 2 * greatestRadius + MARGIN * meanRadius + 2 * LOOK_AHEAD * greatestRadius;
        columns = (int) Math.ceil((scene.maxX() - scene.minX()) / edge);
        rows = (int) Math.ceil((scene.maxY() - scene.minY()) / edge);
        perEdge = 1 / edge;
    }

    private float[] placed(float[] values) {
        float[] placed = new float[n];
        for (int i = 0; i < n; i++) {
            placed[i] = values[number[i]];
        }
        return placed;
    }

    @Override
    public void step() {
        sortIntoCells(x, y);
        listContacts();
        float h = scene.timeStep() / SUB_STEPS;
        System.arraycopy(vx, 0, startVx, 0, n);
        System.arraycopy(vy, 0, startVy, 0, n);
        for (int sub = 0; sub < SUB_STEPS; sub++) {
            accelerate(h);
            solve(h, true);
            solveWalls(h, true);
            move(h);
            solve(h, false);
            solveWalls(h, false);
        }
        bounce();
        bounceOffWalls();
    }

    // ---- broad phase
    // -----------------------------------------------------------------------------------------------

    /** A counting sort. */
    private void sortIntoCells(float[] px, float[] py) {
        Arrays.fill(cellStart, 0);
        for (int i = 0; i < n; i++) {
            int cell = row(py[i]) * columns + column(px[i]);
            cellOf[i] = cell;
            cellStart[cell]++;
        }
        int end = 0;
        for (int cell = 0; cell <= columns * rows; cell++) {
            end += cellStart[cell];
            cellStart[cell] = end;
        }
        for (int i = n - 1; i >= 0; i--) {
            inCells[--cellStart[cellOf[i]]] = i;
        }
    }

    private int column(float px) {
        return Math.max(0, Math.min(columns - 1, (int) ((px - scene.minX()) * perEdge)));
    }

    private int row(float py) {
        return Math.max(0, Math.min(rows - 1, (int) ((py - scene.minY()) * perEdge)));
    }

    /** Lists the pairs that may touch within the step, with the impulses that they ended the last one with. */
    private void listContacts() {
        Contacts old = now;
        now = before;
        before = old;
        now.count = 0;
        for (int i = 0; i < n; i++) {
            now.start[i] = now.count;
            int column = column(x[i]);
            int firstColumn = Math.max(0, column - 1);
            int lastColumn = Math.min(columns - 1, column + 1);
            int row = row(y[i]);
            for (int r = Math.max(0, row - 1); r <= Math.min(rows - 1, row + 1); r++) {
                listContacts(i, cellStart[r * columns + firstColumn], cellStart[r * columns + lastColumn + 1]);
            }
        }
        now.start[n] = now.count;
        for (int c = 0; c < now.count; c++) {
            int i = now.low[c];
            int j = now.high[c];
            now.impulse[c] = before.impulseOf(i, j);
            now.greatestImpulse[c] = 0;
            float dx = x[j] - x[i];
            float dy = y[j] - y[i];
            float distance = (float) Math.sqrt(dx * dx + dy * dy);
            // Circles at one point part upwards.
            now.nx[c] = distance > 0 ? dx / distance : 0;
            now.ny[c] = distance > 0 ? dy / distance : 1;
            now.approach[c] = (vx[j] - vx[i]) * now.nx[c] + (vy[j] - vy[i]) * now.ny[c];
        }
    }

    private void listContacts(int i, int from, int to) {
        float xi = x[i];
        float yi = y[i];
        float reach = radius[i] + MARGIN * meanRadius + lookAhead(i);
        for (int k = from; k < to; k++) {
            int j = inCells[k];
            if (j <= i) {
                continue;
            }
            float dx = x[j] - xi;
            float dy = y[j] - yi;
            float sum = reach + radius[j] + lookAhead(j);
            if (dx * dx + dy * dy < sum * sum && weight[i] + weight[j] > 0) {
                now.add(i, j, 1 / (weight[i] + weight[j]));
            }
        }
    }

    private float lookAhead(int i) {
        float speed = (float) Math.sqrt(vx[i] * vx[i] + vy[i] * vy[i]);
        return Math.min(speed * scene.timeStep(), LOOK_AHEAD * greatestRadius);
    }

    // ---- solver
    // ----------------------------------------------------------------------------------------------------

    /** Gravity, and the impulses of the sub-step before. */
    private void accelerate(float h) {
        float gx = scene.gravityX() * h;
        float gy = scene.gravityY() * h;
        for (int i = 0; i < n; i++) {
            if (weight[i] > 0) {
                vx[i] += gx + wallX[i];
                vy[i] += gy + wallY[i];
            }
        }
        for (int c = 0; c < now.count; c++) {
            if (now.impulse[c] > 0) {
                apply(c, now.impulse[c]);
            }
        }
    }

    private void apply(int c, float impulse) {
        int i = now.low[c];
        int j = now.high[c];
        float px = impulse * now.nx[c];
        float py = impulse * now.ny[c];
        vx[i] -= weight[i] * px;
        vy[i] -= weight[i] * py;
        vx[j] += weight[j] * px;
        vy[j] += weight[j] * py;
    }

    private void move(float h) {
        for (int i = 0; i < n; i++) {
            x[i] += h * vx[i];
            y[i] += h * vy[i];
        }
    }

    /**
     * One pass over the contacts.
     *
     * @param biased whether overlaps are pushed out
     */
    private void solve(float h, boolean biased) {
        float omega = (float) (0.5 * Math.PI); // times h: a quarter of the sub-steps' frequency
        float biasRate = omega / (2 * DAMPING + omega) / h;
        float a = omega * (2 * DAMPING + omega);
        float softMass = a / (1 + a);
        float softImpulse = 1 / (1 + a);
        float push = PUSH * meanRadius;
        Contacts k = now;
        for (int c = 0; c < k.count; c++) {
            int i = k.low[c];
            int j = k.high[c];
            float dx = x[j] - x[i];
            float dy = y[j] - y[i];
            float distance = (float) Math.sqrt(dx * dx + dy * dy);
            if (distance > 0) {
                k.nx[c] = dx / distance;
                k.ny[c] = dy / distance;
            }
            float gap = distance - radius[i] - radius[j];
            float bias = 0;
            float massScale = 1;
            float impulseScale = 0;
            if (gap > 0) {
                bias = gap / h;
            } else if (biased) {
                bias = Math.max(biasRate * gap, -push);
                massScale = softMass;
                impulseScale = softImpulse;
            }
            float speed = (vx[j] - vx[i]) * k.nx[c] + (vy[j] - vy[i]) * k.ny[c];
            float old = k.impulse[c];
            float impulse = Math.max(0, old - k.mass[c] * massScale * (speed + bias) - impulseScale * old);
            if (impulse != old) {
                k.impulse[c] = impulse;
                k.greatestImpulse[c] = Math.max(k.greatestImpulse[c], impulse);
                apply(c, impulse - old);
            }
        }
    }

    /** Restitution: pairs that met at speed and pressed part at their share of it. */
    private void bounce() {
        float threshold = -BOUNCE * meanRadius;
        Contacts k = now;
        for (int c = 0; c < k.count; c++) {
            float e = Math.max(restitution[k.low[c]], restitution[k.high[c]]);
            if (e == 0 || k.approach[c] > threshold || k.greatestImpulse[c] == 0) {
                continue;
            }
            int i = k.low[c];
            int j = k.high[c];
            float speed = (vx[j] - vx[i]) * k.nx[c] + (vy[j] - vy[i]) * k.ny[c];
            float old = k.impulse[c];
            k.impulse[c] = Math.max(0, old - k.mass[c] * (speed + e * k.approach[c]));
            apply(c, k.impulse[c] - old);
        }
    }

    // ---- walls
    // -----------------------------------------------------------------------------------------------------

    private void solveWalls(float h, boolean biased) {
        for (int i = 0; i < n; i++) {
            if (weight[i] > 0) {
                solveWall(i, x, vx, wallX, scene.minX(), scene.maxX(), h, biased);
                solveWall(i, y, vy, wallY, scene.minY(), scene.maxY(), h, biased);
            }
        }
    }

    /** The nearer wall of an axis: a contact with a mass of 1, twice as stiff. */
    private void solveWall(int i, float[] at, float[] v, float[] wall, float min, float max, float h, boolean biased) {
        float side = at[i] - min <= max - at[i] ? 1 : -1;
        float gap = (side > 0 ? at[i] - min : max - at[i]) - radius[i];
        float old = Math.max(0, side * wall[i]);
        float speed = side * v[i];
        if (old == 0 && gap + speed * h > 0) {
            wall[i] = 0;
            return;
        }
        float omega = (float) Math.PI;
        float a = omega * (2 * DAMPING + omega);
        float bias = 0;
        float massScale = 1;
        float impulseScale = 0;
        if (gap > 0) {
            bias = gap / h;
        } else if (biased) {
            bias = Math.max(omega / (2 * DAMPING + omega) / h * gap, -PUSH * meanRadius);
            massScale = a / (1 + a);
            impulseScale = 1 / (1 + a);
        }
        float impulse = Math.max(0, old - massScale * (speed + bias) - impulseScale * old);
        wall[i] = side * impulse;
        v[i] += side * (impulse - old);
    }

    private void bounceOffWalls() {
        for (int i = 0; i < n; i++) {
            if (weight[i] > 0) {
                bounceOffWall(i, vx, wallX, startVx[i]);
                bounceOffWall(i, vy, wallY, startVy[i]);
                x[i] = Math.max(scene.minX() + radius[i], Math.min(scene.maxX() - radius[i], x[i]));
                y[i] = Math.max(scene.minY() + radius[i], Math.min(scene.maxY() - radius[i], y[i]));
            }
        }
    }

    private void bounceOffWall(int i, float[] v, float[] wall, float atStart) {
        float side = Math.signum(wall[i]);
        float approach = side * atStart;
        if (side != 0 && approach < -BOUNCE * meanRadius) {
            v[i] = side * Math.max(side * v[i], -restitution[i] * approach);
        }
    }

    @Override
    public void read(Motion motion) {
        for (int i = 0; i < n; i++) {
            motion.x[number[i]] = x[i];
            motion.y[number[i]] = y[i];
            motion.vx[number[i]] = vx[i];
            motion.vy[number[i]] = vy[i];
        }
    }

    @Override
    public boolean repeatable() {
        return true;
    }

    @Override
    public void close() {
        scene = null;
    }
}
