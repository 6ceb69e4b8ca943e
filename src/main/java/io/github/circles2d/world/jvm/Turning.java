package io.github.circles2d.world.jvm;

import static io.github.circles2d.world.model.CircleRow.ANGULAR_FACTOR;
import static io.github.circles2d.world.model.CircleRow.BELT;
import static io.github.circles2d.world.model.CircleRow.INVERSE_INERTIA;
import static io.github.circles2d.world.model.CircleRow.INVERSE_MASS;
import static io.github.circles2d.world.model.CircleRow.RADIUS;
import static io.github.circles2d.world.model.CircleRow.SPIN_IMPULSE;
import static io.github.circles2d.world.model.CircleRow.SURFACE_SPEED;
import static io.github.circles2d.world.model.CircleRow.TURNED;

import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.circles.StateHash;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.KindSurface;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.Surface;
import io.github.circles2d.world.model.Velocity;
import io.github.circles2d.world.snapshots.SavedState;
import java.util.Arrays;

/** What the circles of a {@link State} turn by. Worlds in which nothing has turned or gripped have none. Arrays are by slot. */
final class Turning {
    private final State state;

    /** In units of a turn's 2^-32. */
    int[] angle = new int[0];

    float[] angularVelocity = new float[0];

    /** Friction and rolling resistance of the walls; {@link CircleRow} numbers the elements of each array. */
    float[] wallGrip = new float[0];

    /** Within a step: how circles turn. */
    float[] spin = new float[0];

    /** Within a step: what circles touch others with. */
    float[] skin = new float[0];

    /** Within a step: the surfaces of kinds, by {@link KindSurface}. */
    float[] kinds;

    private int[] angleSpare = new int[0];
    private float[] angularVelocitySpare = new float[0];
    private float[] wallGripSpare = new float[0];

    Turning(State state) {
        this.state = state;
    }

    /** Memory of the arrays. */
    long bytes() {
        return (2 * (4 + 4 + 16) + 16 + 16L) * angle.length;
    }

    /** Makes room. All arrays are made before one is assigned: a growth that fails changes nothing. */
    void ensure(int circles) {
        if (circles > skin.length / CircleRow.STRIDE) {
            int[] newAngle = Arrays.copyOf(angle, circles);
            float[] newAngularVelocity = Arrays.copyOf(angularVelocity, circles);
            float[] newWallGrip = Arrays.copyOf(wallGrip, CircleRow.of(circles));
            int[] newAngleSpare = new int[circles];
            float[] newAngularVelocitySpare = new float[circles];
            float[] newWallGripSpare = new float[CircleRow.of(circles)];
            float[] newSpin = new float[CircleRow.of(circles)];
            float[] newSkin = new float[CircleRow.of(circles)];
            angle = newAngle;
            angularVelocity = newAngularVelocity;
            wallGrip = newWallGrip;
            angleSpare = newAngleSpare;
            angularVelocitySpare = newAngularVelocitySpare;
            wallGripSpare = newWallGripSpare;
            spin = newSpin;
            skin = newSkin;
        }
    }

    /** Of a new circle. */
    void add(int slot) {
        angle[slot] = 0;
        angularVelocity[slot] = 0f;
        forget(slot);
    }

    /** The impulses of walls. */
    void forget(int slot) {
        Arrays.fill(wallGrip, CircleRow.of(slot), CircleRow.of(slot + 1), 0f);
    }

    void move(int from, int to) {
        angle[to] = angle[from];
        angularVelocity[to] = angularVelocity[from];
        System.arraycopy(wallGrip, CircleRow.of(from), wallGrip, CircleRow.of(to), CircleRow.STRIDE);
    }

    void exchange(int slot, int other) {
        State.exchange(angle, slot, other);
        State.exchange(angularVelocity, slot, other);
        for (int k = 0; k < CircleRow.STRIDE; k++) {
            State.exchange(wallGrip, CircleRow.of(slot) + k, CircleRow.of(other) + k);
        }
    }

    /** An angular impulse; inertia: the inverse inertia of the circle's kind by its inverse mass. */
    void applyImpulse(int slot, float impulse, float inertia) {
        int s = CircleRow.of(slot);
        float r = state.circle[s + RADIUS];
        float inverse = state.traits[s + INVERSE_MASS] * inertia;
        angularVelocity[slot] = Surface.afterAngularImpulse(angularVelocity[slot], impulse, r, inverse);
    }

    /** Makes circles ready for a step. */
    void begin(int from, int to) {
        for (int slot = from; slot < to; slot++) {
            int s = CircleRow.of(slot);
            int id = state.id[slot];
            int row = KindSurface.of(state.fields.getInt(CircleField.KIND, id));
            float friction = state.fields.getFloat(CircleField.FRICTION, id);
            float resistance = state.fields.getFloat(CircleField.ROLLING_RESISTANCE, id);
            spin[s + SURFACE_SPEED] = angularVelocity[slot] * state.circle[s + RADIUS];
            spin[s + SPIN_IMPULSE] = 0f;
            spin[s + TURNED] = 0f;
            spin[s + INVERSE_INERTIA] = state.traits[s + INVERSE_MASS] * kinds[row + KindSurface.INERTIA];
            skin[s + CircleRow.FRICTION] = Surface.orOfKind(friction, kinds[row + KindSurface.FRICTION]);
            skin[s + CircleRow.ROLLING_RESISTANCE] =
                    Surface.orOfKind(resistance, kinds[row + KindSurface.ROLLING_RESISTANCE]);
            skin[s + BELT] = kinds[row + KindSurface.BELT];
            skin[s + ANGULAR_FACTOR] = kinds[row + KindSurface.DAMPING_FACTOR];
        }
    }

    /**
     * The start of a circle that is not static into a sub-step: a torque, damping, and the impulses of the one before. Until the move, the place
     * of these impulses has the surface speed before them, for those that record touches.
     */
    void start(int slot, StepConstants k) {
        int s = CircleRow.of(slot);
        float torque = state.fields.getFloat(CircleField.TORQUE, state.id[slot]);
        float gain = Surface.torqueGain(torque, spin[s + INVERSE_INERTIA], state.circle[s + RADIUS], k.h);
        float before = Surface.beforeImpulse(spin[s + SURFACE_SPEED], gain, skin[s + ANGULAR_FACTOR]);
        spin[s + SURFACE_SPEED] = Velocity.limitSpeed(before + spin[s + INVERSE_INERTIA] * spin[s + SPIN_IMPULSE]);
        spin[s + SPIN_IMPULSE] = before;
    }

    /** The same of a static circle. */
    void startStatic(int slot) {
        int s = CircleRow.of(slot);
        spin[s + SPIN_IMPULSE] = spin[s + SURFACE_SPEED];
    }

    /** Between the start of a circle and its move: its surface speed before any impulse. */
    float before(int slot) {
        return spin[CircleRow.of(slot) + SPIN_IMPULSE];
    }

    /** The move of a circle in a sub-step. */
    void move(int slot) {
        int s = CircleRow.of(slot);
        spin[s + SURFACE_SPEED] = Velocity.limitSpeed(spin[s + SURFACE_SPEED]);
        spin[s + TURNED] += spin[s + SURFACE_SPEED];
        spin[s + SPIN_IMPULSE] = 0f;
    }

    /** Ends the step. */
    void end(int from, int to, StepConstants k) {
        for (int slot = from; slot < to; slot++) {
            int s = CircleRow.of(slot);
            float r = state.circle[s + RADIUS];
            float before = angularVelocity[slot] * r;
            float after = spin[s + SURFACE_SPEED];
            angle[slot] = Surface.turn(angle[slot], spin[s + TURNED], k.h, r);
            angularVelocity[slot] = Surface.angularVelocity(angularVelocity[slot], before, after, r);
        }
    }

    /** Saves the circle of a slot as circle k. */
    void save(int slot, SavedState into, int k) {
        into.angle[k] = angle[slot];
        into.angularVelocity[k] = angularVelocity[slot];
        System.arraycopy(wallGrip, CircleRow.of(slot), into.wallGrip, CircleRow.of(k), CircleRow.STRIDE);
    }

    /** Takes over saved circles, for which there is room; slots are in the order of the ids. */
    void load(SavedState from) {
        if (from.turns) {
            System.arraycopy(from.angle, 0, angle, 0, from.circles);
            System.arraycopy(from.angularVelocity, 0, angularVelocity, 0, from.circles);
            System.arraycopy(from.wallGrip, 0, wallGrip, 0, CircleRow.of(from.circles));
        } else {
            Arrays.fill(angle, 0, from.circles, 0);
            Arrays.fill(angularVelocity, 0, from.circles, 0f);
            Arrays.fill(wallGrip, 0, CircleRow.of(from.circles), 0f);
        }
    }

    long hash(int slot) {
        return StateHash.turn(state.id[slot], angle[slot], angularVelocity[slot], wallGrip, CircleRow.of(slot));
    }

    /** As {@link State#permute}. */
    void permute(int old, int slot) {
        angleSpare[slot] = angle[old];
        angularVelocitySpare[slot] = angularVelocity[old];
        System.arraycopy(wallGrip, CircleRow.of(old), wallGripSpare, CircleRow.of(slot), CircleRow.STRIDE);
    }

    /** As {@link State#copy}. */
    void copy(int from, int to, boolean back) {
        State.copy(angle, angleSpare, from, to - from, back);
        State.copy(angularVelocity, angularVelocitySpare, from, to - from, back);
        State.copy(wallGrip, wallGripSpare, CircleRow.of(from), CircleRow.of(to - from), back);
    }

    void swap() {
        int[] i = angle;
        angle = angleSpare;
        angleSpare = i;
        float[] f = angularVelocity;
        angularVelocity = angularVelocitySpare;
        angularVelocitySpare = f;
        f = wallGrip;
        wallGrip = wallGripSpare;
        wallGripSpare = f;
    }
}
