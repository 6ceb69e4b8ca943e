package io.github.circles2d.world.circles;

import io.github.circles2d.world.model.CircleRow;
import java.util.Arrays;

/**
 * The circles of a saved state, by id: ids in use, their generations and fields ({@link HandleTable}); circles and the impulse cache, which a pipeline
 * saves and loads. It has no slots, so every pipeline saves the same state in the same way. Arrays are reused, and may be longer than their contents.
 */
public class SavedCircles {
    /** Ids in use so far: all circles have lower ones. */
    public int ids;

    /** By id: how many circles had it before. */
    public int[] generation = new int[0];

    /** By id: the fields that only calls change. */
    public final CircleFields fields = new CircleFields(CircleField.ALL);

    public int circles;

    /** By circle: its id, ascending. All arrays "by circle" have this order. */
    public int[] id = new int[0];

    /** By circle: its row, by {@link CircleRow}. */
    public float[] circle = new float[0];

    /** By circle: its row of motion, by {@link CircleRow}. */
    public float[] motion = new float[0];

    /** By circle: its row of traits, by {@link CircleRow}. */
    public float[] traits = new float[0];

    /** Whether the state has what circles turn by: the arrays of angles, angular velocities and grips. */
    public boolean turns;

    /** By circle, if circles turn: the angle, in units of a turn's 2^-32. */
    public int[] angle = new int[0];

    /** By circle, if circles turn. */
    public float[] angularVelocity = new float[0];

    /** By circle, if circles turn: the impulses of friction and of rolling of its walls, by {@link CircleRow}. */
    public float[] wallGrip = new float[0];

    public int impulses;

    /** By impulse: the lower id of the pair. Impulses are in ascending order of the lower id, then of the higher. */
    public int[] lo = new int[0];

    /** By impulse: the higher id of the pair. */
    public int[] hi = new int[0];

    /** By impulse: the impulse, greater than 0. */
    public float[] normalImpulse = new float[0];

    /** By impulse, if circles turn: the impulse of friction. */
    public float[] friction = new float[0];

    /** By impulse, if circles turn: the rolling impulse. */
    public float[] rolling = new float[0];

    protected SavedCircles() {}

    /** Makes room for ids and sets their number. */
    public void setIds(int count) {
        if (generation.length < count) {
            generation = new int[count];
        }
        ids = count;
    }

    /** Makes room for circles and sets their number. */
    public void setCircles(int count) {
        if (id.length < count) {
            // All arrays are made before one is assigned: a growth that fails changes nothing.
            float[] newCircle = new float[CircleRow.STRIDE * count];
            float[] newMotion = new float[CircleRow.STRIDE * count];
            float[] newTraits = new float[CircleRow.STRIDE * count];
            int[] newId = new int[count];
            circle = newCircle;
            motion = newMotion;
            traits = newTraits;
            id = newId;
        }
        circles = count;
    }

    /** Makes room for impulses without changing their number. */
    public void ensureImpulses(int count) {
        if (normalImpulse.length < count) {
            int c = Math.max(count, normalImpulse.length + (normalImpulse.length >> 1));
            int[] newLo = Arrays.copyOf(lo, c);
            int[] newHi = Arrays.copyOf(hi, c);
            float[] newNormalImpulse = Arrays.copyOf(normalImpulse, c);
            lo = newLo;
            hi = newHi;
            normalImpulse = newNormalImpulse;
        }
        if (turns && rolling.length < normalImpulse.length) {
            float[] newFriction = Arrays.copyOf(friction, normalImpulse.length);
            float[] newRolling = Arrays.copyOf(rolling, normalImpulse.length);
            friction = newFriction;
            rolling = newRolling;
        }
    }

    /** Says whether circles turn, and makes room for what they turn by. */
    public void setTurns(boolean does) {
        turns = does;
        if (turns && wallGrip.length < CircleRow.STRIDE * circles) {
            int[] newAngle = new int[circles];
            float[] newAngularVelocity = new float[circles];
            float[] newWallGrip = new float[CircleRow.STRIDE * circles];
            angle = newAngle;
            angularVelocity = newAngularVelocity;
            wallGrip = newWallGrip;
        }
    }

    /** Adds an impulse without friction. */
    public void addImpulse(int loId, int hiId, float impulse) {
        addImpulse(loId, hiId, impulse, 0f, 0f);
    }

    /** Adds an impulse. Those of one lower id come in a row, the lower ids ascending; the higher ids in any order. */
    public void addImpulse(int loId, int hiId, float impulse, float ofFriction, float ofRolling) {
        ensureImpulses(impulses + 1);
        int k = impulses++;
        while (k > 0 && lo[k - 1] == loId && hi[k - 1] > hiId) {
            hi[k] = hi[k - 1];
            normalImpulse[k] = normalImpulse[k - 1];
            if (turns) {
                friction[k] = friction[k - 1];
                rolling[k] = rolling[k - 1];
            }
            k--;
        }
        lo[impulses - 1] = loId;
        hi[k] = hiId;
        normalImpulse[k] = impulse;
        if (turns) {
            friction[k] = ofFriction;
            rolling[k] = ofRolling;
        }
    }
}
