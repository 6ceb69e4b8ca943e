package io.github.circles2d.world.jvm.state;

import static io.github.circles2d.world.model.CircleRow.INVERSE_INERTIA;
import static io.github.circles2d.world.model.CircleRow.INVERSE_MASS;
import static io.github.circles2d.world.model.CircleRow.RADIUS;
import static io.github.circles2d.world.model.CircleRow.SPIN_IMPULSE;
import static io.github.circles2d.world.model.CircleRow.SURFACE_SPEED;
import static io.github.circles2d.world.model.CircleRow.TURNED;

import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.circles.StateHash;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.ContactRows;
import io.github.circles2d.world.model.KindSurface;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.Surface;
import io.github.circles2d.world.model.Velocity;
import io.github.circles2d.world.snapshots.SavedState;
import java.util.Arrays;

/** What circles of a {@link State} need if they can rotate. Arrays are by slot. */
public final class Turning {
    private final State state;

    /** In units of a turn's 2^-32. */
    public int[] angle = new int[0];

    public float[] angularVelocity = new float[0];

    /** The impulses of the walls' rows, by {@link ContactRows}; {@link CircleRow} numbers the elements of the other arrays. */
    public float[] wallRows = new float[0];

    /** Within a step: how circles rotate. */
    public float[] spin = new float[0];

    /** Within a step: the circles' own, rows as those of kinds. */
    public float[] circleSurfaces = new float[0];

    /** Within a step: the surfaces of kinds and walls, by {@link KindSurface}. */
    public float[] surfaces;

    /** Within a step: whether all circles have one friction, one rolling resistance and one belt speed. */
    public boolean alike;

    /** If so, of two circles: the friction, the greater rolling resistance, the sum of the belt speeds. */
    public float pairFriction;

    public float pairResistance;
    public float pairBelts;

    private int[] angleSpare = new int[0];
    private float[] angularVelocitySpare = new float[0];
    private float[] wallRowsSpare = new float[0];

    Turning(State state) {
        this.state = state;
    }

    long bytes() {
        return (2 * (4 + 4 + 4 * ContactRows.OF_WALLS) + 16 + 4L * KindSurface.STRIDE) * angle.length;
    }

    /** Makes room. The array that is compared grows last: a growth that fails is tried again. */
    void ensure(int circles) {
        if (KindSurface.of(circles) > circleSurfaces.length) {
            angle = Arrays.copyOf(angle, circles);
            angularVelocity = Arrays.copyOf(angularVelocity, circles);
            wallRows = Arrays.copyOf(wallRows, ContactRows.ofWalls(circles));
            angleSpare = new int[circles];
            angularVelocitySpare = new float[circles];
            wallRowsSpare = new float[ContactRows.ofWalls(circles)];
            spin = new float[CircleRow.of(circles)];
            circleSurfaces = new float[KindSurface.of(circles)];
        }
    }

    /** Of a new circle. */
    void add(int slot) {
        angle[slot] = 0;
        angularVelocity[slot] = 0f;
        forget(slot);
    }

    /** The impulses of walls. */
    public void forget(int slot) {
        Arrays.fill(wallRows, ContactRows.ofWalls(slot), ContactRows.ofWalls(slot + 1), 0f);
    }

    void move(int from, int to) {
        angle[to] = angle[from];
        angularVelocity[to] = angularVelocity[from];
        copyWalls(wallRows, from, wallRows, to);
    }

    private static void copyWalls(float[] from, int slot, float[] to, int toSlot) {
        System.arraycopy(from, ContactRows.ofWalls(slot), to, ContactRows.ofWalls(toSlot), ContactRows.OF_WALLS);
    }

    void exchange(int slot, int other) {
        State.exchange(angle, slot, other);
        State.exchange(angularVelocity, slot, other);
        for (int k = 0; k < ContactRows.OF_WALLS; k++) {
            State.exchange(wallRows, ContactRows.ofWalls(slot) + k, ContactRows.ofWalls(other) + k);
        }
    }

    /** An angular impulse; inertia: the inverse inertia of the circle's kind by its inverse mass. */
    void applyImpulse(int slot, float impulse, float inertia) {
        int s = CircleRow.of(slot);
        float r = state.circle[s + RADIUS];
        float inverse = state.traits[s + INVERSE_MASS] * inertia;
        angularVelocity[slot] = Surface.afterAngularImpulse(angularVelocity[slot], impulse, r, inverse);
    }

    /** That of a circle by its own mass, also if it sleeps. */
    public float ownInverseInertia(int slot) {
        int kind = KindSurface.of(state.fields.getInt(CircleField.KIND, state.id[slot]));
        return state.ownInverseMass(slot) * surfaces[kind + KindSurface.INERTIA];
    }

    /** Takes the surfaces of the steps to come. */
    public void take(KindSurface of) {
        surfaces = of.rows;
        alike = of.areAlike();
        if (alike) {
            float friction = surfaces[KindSurface.FRICTION];
            float resistance = surfaces[KindSurface.ROLLING_RESISTANCE];
            float belt = surfaces[KindSurface.BELT];
            pairFriction = Surface.friction(friction, friction);
            pairResistance = CircleMath.max(resistance, resistance);
            pairBelts = belt + belt;
        }
    }

    /** Makes circles ready for a step. */
    public void begin(int from, int to) {
        for (int slot = from; slot < to; slot++) {
            int s = CircleRow.of(slot);
            int id = state.id[slot];
            int kind = state.fields.getInt(CircleField.KIND, id);
            int own = KindSurface.of(slot);
            KindSurface.copy(surfaces, kind, circleSurfaces, slot);
            for (int k = 0; k < CircleField.surfaces(); k++) {
                int at = own + KindSurface.OF_CIRCLES + k;
                float value = state.fields.getFloat(CircleField.surface(k), id);
                circleSurfaces[at] = CircleMath.orOfKind(value, circleSurfaces[at]);
            }
            spin[s + SURFACE_SPEED] = angularVelocity[slot] * state.circle[s + RADIUS];
            spin[s + SPIN_IMPULSE] = 0f;
            spin[s + TURNED] = 0f;
            spin[s + INVERSE_INERTIA] = state.traits[s + INVERSE_MASS] * circleSurfaces[own + KindSurface.INERTIA];
        }
    }

    /**
     * The start of a circle that is not static into a sub-step: a torque, damping, and the impulses of the one before. Until the move, the place
     * of these impulses has the surface speed before them, for those that record touches.
     */
    public void start(int slot, StepConstants k) {
        int s = CircleRow.of(slot);
        float before = spin[s + SURFACE_SPEED] + 0f;
        if (surfaces[KindSurface.DRIVES] != 0f) {
            float torque = state.fields.getFloat(CircleField.TORQUE, state.id[slot]);
            float gain = Surface.torqueGain(torque, spin[s + INVERSE_INERTIA], state.circle[s + RADIUS], k.h);
            float factor = circleSurfaces[KindSurface.of(slot) + KindSurface.DAMPING_FACTOR];
            before = Surface.beforeImpulse(spin[s + SURFACE_SPEED], gain, factor);
        }
        spin[s + SURFACE_SPEED] = Velocity.limitSpeed(before + spin[s + INVERSE_INERTIA] * spin[s + SPIN_IMPULSE]);
        spin[s + SPIN_IMPULSE] = before;
    }

    /** The same of a static circle. */
    public void startStatic(int slot) {
        int s = CircleRow.of(slot);
        spin[s + SPIN_IMPULSE] = spin[s + SURFACE_SPEED];
    }

    /** Between the start of a circle and its move: its surface speed before any impulse. */
    public float before(int slot) {
        return spin[CircleRow.of(slot) + SPIN_IMPULSE];
    }

    /** The move of a circle in a sub-step. */
    public void move(int slot) {
        int s = CircleRow.of(slot);
        spin[s + SURFACE_SPEED] = Velocity.limitSpeed(spin[s + SURFACE_SPEED]);
        spin[s + TURNED] += spin[s + SURFACE_SPEED];
        spin[s + SPIN_IMPULSE] = 0f;
    }

    /** Ends the step. */
    public void end(int from, int to, StepConstants k) {
        for (int slot = from; slot < to; slot++) {
            int s = CircleRow.of(slot);
            float r = state.circle[s + RADIUS];
            float before = angularVelocity[slot] * r;
            float after = spin[s + SURFACE_SPEED];
            int angleBefore = angle[slot];
            angle[slot] = Surface.turn(angleBefore, spin[s + TURNED], k.h, r);
            if (state.sleepers != null) {
                state.sleepers.turnedInStep[slot] = angle[slot] - angleBefore;
            }
            angularVelocity[slot] = Surface.angularVelocity(angularVelocity[slot], before, after, r);
        }
    }

    /** Saves circles from a slot on as those from k on. */
    void save(int slot, SavedState into, int k, int count) {
        System.arraycopy(angle, slot, into.angle, k, count);
        System.arraycopy(angularVelocity, slot, into.angularVelocity, k, count);
        System.arraycopy(
                wallRows, ContactRows.ofWalls(slot), into.wallRows, ContactRows.ofWalls(k), ContactRows.ofWalls(count));
    }

    /** Takes over saved circles, for which there is room; slots are in the order of the ids. */
    void load(SavedState from) {
        if (from.turns) {
            System.arraycopy(from.angle, 0, angle, 0, from.circles);
            System.arraycopy(from.angularVelocity, 0, angularVelocity, 0, from.circles);
            System.arraycopy(from.wallRows, 0, wallRows, 0, ContactRows.ofWalls(from.circles));
        } else {
            Arrays.fill(angle, 0, from.circles, 0);
            Arrays.fill(angularVelocity, 0, from.circles, 0f);
            Arrays.fill(wallRows, 0, ContactRows.ofWalls(from.circles), 0f);
        }
    }

    long hash(int slot) {
        return StateHash.turn(state.id[slot], angle[slot], angularVelocity[slot], wallRows, ContactRows.ofWalls(slot));
    }

    /** As {@link State#permute}. */
    void permute(int old, int slot) {
        angleSpare[slot] = angle[old];
        angularVelocitySpare[slot] = angularVelocity[old];
        copyWalls(wallRows, old, wallRowsSpare, slot);
    }

    /** As {@link State#copy}. */
    void copy(int from, int to, boolean back) {
        State.copy(angle, angleSpare, from, to - from, back);
        State.copy(angularVelocity, angularVelocitySpare, from, to - from, back);
        State.copy(wallRows, wallRowsSpare, ContactRows.ofWalls(from), ContactRows.ofWalls(to - from), back);
    }

    void swap() {
        int[] i = angle;
        angle = angleSpare;
        angleSpare = i;
        float[] f = angularVelocity;
        angularVelocity = angularVelocitySpare;
        angularVelocitySpare = f;
        f = wallRows;
        wallRows = wallRowsSpare;
        wallRowsSpare = f;
    }
}
