package io.github.circles2d.world.circles;

import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.ContactRows;
import java.util.Arrays;

/**
 * The circles of a saved state, by id: ids in use, their generations and fields ({@link HandleTable}); circles and the impulse cache, which a pipeline
 * saves and loads. It has no slots, so every pipeline saves the same state in the same way. Arrays are reused, and may be longer than their contents.
 */
public class SavedCircles {
    /** Parts of the circles, each of which one thread may save. */
    public static final int PARTS = 64;

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

    /** Whether circles can rotate: whether the state has the arrays of angles, angular velocities and impulses of {@link ContactRows}. */
    public boolean turns;

    /** By circle, if circles can rotate: the angle, in units of a turn's 2^-32. */
    public int[] angle = new int[0];

    /** By circle, if circles can rotate. */
    public float[] angularVelocity = new float[0];

    /** By circle, if circles can rotate: the impulses of its walls, by {@link ContactRows#ofWall}. */
    public float[] wallRows = new float[0];

    /** Whether circles sleep: whether the state has the arrays of how they come to rest. */
    public boolean sleeps;

    /** By circle, if circles sleep: {@code Sleep} says what a number means. */
    public int[] rest = new int[0];

    /** By circle, if circles sleep: how far it has drifted since it came to rest, less its displacement: x, y. */
    public float[] drift = new float[0];

    /** By circle, if circles sleep: the units by which it has turned since. */
    public int[] turned = new int[0];

    public int impulses;

    /** By impulse: the lower id of the pair. Impulses are in ascending order of the lower id, then of the higher. */
    public int[] lo = new int[0];

    /** By impulse: the higher id of the pair. */
    public int[] hi = new int[0];

    /** By impulse: the impulse, greater than 0. */
    public float[] normalImpulse = new float[0];

    /** By impulse, if circles can rotate: those of the contact's other rows, by {@link ContactRows}. */
    public float[] rows = new float[0];

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
            // The array that is compared grows last: a growth that fails is tried again.
            circle = new float[CircleRow.STRIDE * count];
            motion = new float[CircleRow.STRIDE * count];
            traits = new float[CircleRow.STRIDE * count];
            id = new int[count];
        }
        circles = count;
    }

    /** Where a part of the circles begins; it ends where the next begins. */
    public int part(int number) {
        return (int) ((long) circles * number / PARTS);
    }

    /** Makes room for the impulses of all parts: takes how many each has, and gives where its first one goes. */
    public void placeImpulses(int[] ofParts) {
        int sum = 0;
        for (int count : ofParts) {
            sum += count;
        }
        ensureImpulses(sum);
        impulses = sum;
        for (int part = PARTS - 1; part >= 0; part--) {
            sum -= ofParts[part];
            ofParts[part] = sum;
        }
    }

    /** Makes room for impulses without changing their number. */
    public void ensureImpulses(int count) {
        if (normalImpulse.length < count) {
            int c = Math.max(count, normalImpulse.length + (normalImpulse.length >> 1));
            lo = Arrays.copyOf(lo, c);
            hi = Arrays.copyOf(hi, c);
            normalImpulse = Arrays.copyOf(normalImpulse, c);
        }
        if (turns && rows.length < ContactRows.of(normalImpulse.length)) {
            rows = Arrays.copyOf(rows, ContactRows.of(normalImpulse.length));
        }
    }

    /** Says whether circles can rotate, and makes room for what that takes. */
    public void setTurns(boolean does) {
        turns = does;
        if (turns && wallRows.length < ContactRows.ofWalls(circles)) {
            angle = new int[circles];
            angularVelocity = new float[circles];
            wallRows = new float[ContactRows.ofWalls(circles)];
        }
    }

    /** Says whether circles sleep, and makes room for what that takes. */
    public void setSleeps(boolean does) {
        sleeps = does;
        if (sleeps && rest.length < circles) {
            drift = new float[2 * circles];
            turned = new int[circles];
            rest = new int[circles];
        }
    }

    /**
     * Adds an impulse, and those of the contact's other rows from a place of an array on, if circles can rotate. Impulses of one lower id come
     * in a row, the lower ids ascending; the higher ids in any order.
     */
    public void addImpulse(int loId, int hiId, float impulse, float[] ofRows, int at) {
        ensureImpulses(impulses + 1);
        setImpulse(impulses++, 0, loId, hiId, impulse, ofRows, at);
    }

    /** Likewise sets an impulse, for which there is room, behind the others of its lower id, none of which lies before a place. */
    public void setImpulse(int last, int first, int loId, int hiId, float impulse, float[] ofRows, int at) {
        int k = last;
        while (k > first && lo[k - 1] == loId && hi[k - 1] > hiId) {
            hi[k] = hi[k - 1];
            normalImpulse[k] = normalImpulse[k - 1];
            if (turns) {
                ContactRows.copy(rows, ContactRows.of(k - 1), rows, ContactRows.of(k));
            }
            k--;
        }
        lo[last] = loId;
        hi[k] = hiId;
        normalImpulse[k] = impulse;
        if (turns) {
            ContactRows.copy(ofRows, at, rows, ContactRows.of(k));
        }
    }
}
