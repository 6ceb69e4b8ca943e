package io.github.circles2d.world.terrain;

import io.github.circles2d.world.circles.Handle;
import io.github.circles2d.world.circles.IdTable;
import io.github.circles2d.world.circles.StateHash;
import io.github.circles2d.world.model.BodyRow;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.model.Rotation;
import io.github.circles2d.world.model.Velocity;
import java.util.Arrays;

/**
 * Bodies of terrain: where they are, how they move, and where they travel. Body 0 is the ground, which stays where it is. A place has double
 * precision, so a slow body creeps as far as its velocity says.
 */
public final class BodyTable extends BodyStates {
    public static final int GROUND = 0;

    /** A body turns so far in a sub-step at most, in units of an angle: a sixteenth less than half a turn. */
    private static final long MOST_TURN = 15L << 27;

    public final IdTable ids = new IdTable(Handle.BODY);

    /** The first piece, or -1. */
    int[] firstPiece = new int[0];

    /** Bodies that may move, each once. */
    private int[] movers = new int[0];

    private int moverCount;

    /** Whether a body is among them. */
    private boolean[] isMover = new boolean[0];

    /** Counts how often bodies have changed their places. */
    private int jumps;

    // the motion in the step that begins
    private double nextX;
    private double nextY;
    long turn;
    double travelX;
    double travelY;

    BodyTable() {
        setRoom(8);
        add(0f, 0f, 0);
    }

    @Override
    void setRoom(int bodies) {
        super.setRoom(bodies);
        firstPiece = Arrays.copyOf(firstPiece, bodies);
        movers = Arrays.copyOf(movers, bodies);
        isMover = Arrays.copyOf(isMover, bodies);
        ids.setRoom(bodies);
    }

    /** Makes room for more bodies. If there is none, nothing has changed. */
    public void ensure(int more) {
        int needed = ids.size() + more;
        if (needed > ids.room()) {
            setRoom(Math.max(needed, ids.room() + (ids.room() >> 1)));
        }
    }

    /** A body at rest; there is room. */
    int add(float atX, float atY, int atAngle) {
        int id = ids.add();
        x[id] = atX;
        y[id] = atY;
        angle[id] = atAngle;
        stop(id);
        firstPiece[id] = -1;
        return id;
    }

    /** A body without pieces. */
    void remove(int id) {
        stop(id);
        ids.remove(id);
    }

    private void stop(int id) {
        vx[id] = 0f;
        vy[id] = 0f;
        omega[id] = 0f;
        travels[id] = false;
        stay(id);
    }

    /** The body has not moved in the last step. */
    void stay(int id) {
        lastVx[id] = 0f;
        lastVy[id] = 0f;
        lastOmega[id] = 0f;
    }

    private boolean hasMoved(int id) {
        return lastVx[id] != 0f || lastVy[id] != 0f || lastOmega[id] != 0f;
    }

    /** How fast a place of the world, so far from the pivot, has moved with the body in the last step. */
    public float lastVxAt(int id, double dy) {
        return (float) (lastVx[id] - lastOmega[id] * dy);
    }

    public float lastVyAt(int id, double dx) {
        return (float) (lastVy[id] + lastOmega[id] * dx);
    }

    /** How far a place of the world is from the pivot, the short way. */
    public double fromPivotX(int id, float toX, Bounds bounds) {
        return shortWay(bounds.placeX(toX) - x[id], bounds.periodX());
    }

    public double fromPivotY(int id, float toY, Bounds bounds) {
        return shortWay(bounds.placeY(toY) - y[id], bounds.periodY());
    }

    public void setVelocity(int id, float toX, float toY) {
        vx[id] = toX + 0f;
        vy[id] = toY + 0f;
        note(id);
    }

    public void setOmega(int id, float to) {
        omega[id] = to + 0f;
        note(id);
    }

    /** The body is to travel in the next step. */
    public void travel(int id, float toX, float toY, int toAngle) {
        travels[id] = true;
        targetX[id] = toX;
        targetY[id] = toY;
        targetAngle[id] = toAngle;
        note(id);
    }

    void put(int id, float toX, float toY, int toAngle) {
        x[id] = toX;
        y[id] = toY;
        angle[id] = toAngle;
        travels[id] = false;
        stay(id);
        jumps++;
    }

    /** Another number whenever a body is somewhere else than before. */
    public int jumps() {
        return jumps;
    }

    /** Whether it moves in the next step. */
    public boolean moves(int id) {
        return travels[id] || vx[id] != 0f || vy[id] != 0f || omega[id] != 0f;
    }

    private void note(int id) {
        if ((moves(id) || hasMoved(id)) && !isMover[id]) {
            isMover[id] = true;
            movers[moverCount++] = id;
        }
    }

    /** Bodies that may move: those that move in the next step, and those that have come to rest since they did. */
    int movers() {
        return moverCount;
    }

    int mover(int k) {
        return movers[k];
    }

    /** Whether a body moves in the next step. */
    public boolean anyMoves() {
        for (int k = 0; k < moverCount; k++) {
            if (moves(movers[k])) {
                return true;
            }
        }
        return false;
    }

    /** Works out how a body moves in a step, which may end at the edge of the coordinates. */
    void plan(int id, float dt, int subSteps, Bounds bounds) {
        if (travels[id]) {
            nextX = targetX[id];
            nextY = targetY[id];
            turn = targetAngle[id] - angle[id]; // the short way round
            travelX = shortWay(nextX - x[id], bounds.periodX());
            travelY = shortWay(nextY - y[id], bounds.periodY());
        } else {
            nextX = clamp(x[id] + (double) vx[id] * dt);
            nextY = clamp(y[id] + (double) vy[id] * dt);
            long most = MOST_TURN * subSteps;
            turn = Math.max(-most, Math.min(most, Rotation.units((double) omega[id] * dt)));
            travelX = nextX - x[id];
            travelY = nextY - y[id];
        }
    }

    private static double clamp(double coordinate) {
        return Math.max(-Limits.COORDINATE, Math.min(Limits.COORDINATE, coordinate));
    }

    static double shortWay(double d, double period) {
        return d > 0.5 * period ? d - period : d < -0.5 * period ? d + period : d;
    }

    /** Fills the row of a body that moves; returns how far its pivot goes. */
    double begin(int id, int number, float dt, int subSteps, Bounds bounds, float[] motion) {
        plan(id, dt, subSteps, bounds);
        int at = BodyRow.of(number, subSteps);
        motion[at + BodyRow.PIVOT_X] = (float) x[id];
        motion[at + BodyRow.PIVOT_Y] = (float) y[id];
        motion[at + BodyRow.VX] = velocity(travelX, dt);
        motion[at + BodyRow.VY] = velocity(travelY, dt);
        motion[at + BodyRow.OMEGA] = velocity(turn * Rotation.RADIANS_PER_UNIT, dt);
        for (int boundary = 0; boundary <= subSteps; boundary++) {
            int pose = at + BodyRow.pose(boundary);
            double share = (double) boundary / subSteps;
            int turned = (int) Rotation.nearest(turn * share);
            motion[pose + BodyRow.DX] = (float) (travelX * share);
            motion[pose + BodyRow.DY] = (float) (travelY * share);
            motion[pose + BodyRow.COS] = (float) Rotation.cos(turned);
            motion[pose + BodyRow.SIN] = (float) Rotation.sin(turned);
        }
        return Math.sqrt(travelX * travelX + travelY * travelY);
    }

    private static float velocity(double way, float dt) {
        return Velocity.limitSpeed((float) (way / dt));
    }

    /** In radians, of the body whose row was filled last. */
    double turned() {
        return Math.abs(turn) * Rotation.RADIANS_PER_UNIT;
    }

    /** A step has been made: brings a body that moves to where it is then. */
    void end(int id, float dt, int subSteps, Bounds bounds) {
        plan(id, dt, subSteps, bounds);
        x[id] = place(nextX, bounds.minX(), bounds.periodX());
        y[id] = place(nextY, bounds.minY(), bounds.periodY());
        angle[id] += (int) turn;
        lastVx[id] = travels[id] ? velocity(travelX, dt) + 0f : vx[id]; // one zero, as of velocities that are set
        lastVy[id] = travels[id] ? velocity(travelY, dt) + 0f : vy[id];
        lastOmega[id] = travels[id] ? velocity(turn * Rotation.RADIANS_PER_UNIT, dt) + 0f : omega[id];
        travels[id] = false;
        jumps++;
    }

    /** Inside an axis that wraps. */
    static double place(double at, double min, double period) {
        return period == Double.POSITIVE_INFINITY ? at : at - Math.floor((at - min) / period) * period;
    }

    /** Strikes off those that are at rest, of which the step knows. */
    void dropResting() {
        int kept = 0;
        for (int k = 0; k < moverCount; k++) {
            if (!moves(movers[k])) {
                stay(movers[k]);
            }
            isMover[movers[k]] = moves(movers[k]);
            if (isMover[movers[k]]) {
                movers[kept++] = movers[k];
            }
        }
        moverCount = kept;
    }

    /** The part of the bodies in the hash of the state: one number for each but the ground. */
    long hash() {
        long sum = 0;
        for (int id = 1; id < ids.end(); id++) {
            if (ids.lives(id)) {
                sum += hash(id);
            }
        }
        return sum;
    }

    private long hash(int id) {
        long h = absorb(absorb(StateHash.absorb(StateHash.body(), id), x[id]), y[id]);
        h = StateHash.absorb(StateHash.absorb(StateHash.absorb(h, angle[id]), vx[id]), vy[id]);
        h = StateHash.absorb(h, omega[id]);
        if (travels[id]) {
            h = StateHash.absorb(StateHash.absorb(h, targetX[id]), targetY[id]);
            h = StateHash.absorb(h, targetAngle[id]);
        }
        return h;
    }

    private static long absorb(long h, double value) {
        long bits = Double.doubleToRawLongBits(value);
        return StateHash.absorb(StateHash.absorb(h, (int) bits), (int) (bits >> Integer.SIZE));
    }

    void save(SavedTerrain to) {
        int n = ids.end();
        ids.save(to.bodyGeneration);
        for (int id = 0; id < n; id++) {
            to.bodyLives[id] = ids.lives(id);
        }
        to.bodies.copy(this, n);
    }

    /** Makes room for bodies of a saved state. */
    void makeRoom(int bodies) {
        if (bodies > ids.room()) {
            setRoom(bodies);
        }
    }

    /** Whether the saved bodies are those that are there, wherever they are. */
    boolean areThose(SavedTerrain from) {
        boolean same = from.bodyIds == ids.end();
        for (int id = 0; same && id < from.bodyIds; id++) {
            same = ids.isSame(id, from.bodyLives[id], from.bodyGeneration[id]);
        }
        return same;
    }

    /** Takes over saved bodies, without pieces yet; there is room. */
    void load(SavedTerrain from) {
        int n = from.bodyIds;
        ids.load(from.bodyGeneration, n);
        for (int id = 0; id < n; id++) {
            if (from.bodyLives[id]) {
                ids.revive(id);
            }
            firstPiece[id] = -1;
        }
        loadPoses(from);
    }

    /** Takes over where saved bodies are, and how they move. */
    void loadPoses(SavedTerrain from) {
        int n = from.bodyIds;
        moverCount = 0;
        jumps++;
        Arrays.fill(isMover, false);
        copy(from.bodies, n);
        for (int id = 1; id < n; id++) {
            if (ids.lives(id)) {
                note(id);
            }
        }
    }

    /** Removes all but the ground. */
    void clear() {
        for (int id = 1; id < ids.end(); id++) {
            if (ids.lives(id)) {
                remove(id);
            }
        }
        dropResting();
    }
}
