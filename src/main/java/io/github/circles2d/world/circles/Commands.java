package io.github.circles2d.world.circles;

import java.util.Arrays;

/**
 * What the caller asked for since the last step or read, in call order: one record of {@link #STRIDE} ints each, floats as
 * their bits. A pipeline applies the records of one circle in order; those of different circles do not meet.
 */
public final class Commands {
    /** Ints a record: the operation, the id, seven values. */
    public static final int STRIDE = 9;

    /** A new circle: x, y, radius, mass, restitution, vx, vy. */
    public static final int ADD = 1;

    /** A circle goes. */
    public static final int REMOVE = 2;

    /** New position: x, y. */
    public static final int POSITION = 3;

    /** New velocity: vx, vy. */
    public static final int VELOCITY = 4;

    /** New radius; the circle's impulses are forgotten. */
    public static final int RADIUS = 5;

    /** New mass; the circle's impulses are forgotten. */
    public static final int MASS = 6;

    /** New restitution. */
    public static final int RESTITUTION = 7;

    /** An impulse: x, y. */
    public static final int IMPULSE = 8;

    /** So many records had better be applied before there are more: what waits must not grow with the number of calls. */
    public static final int MANY = 1 << 16;

    private int[] records = new int[STRIDE * 64];
    private int count;
    private int added;

    /** No commands. */
    public Commands() {}

    /**
     * The number of records.
     *
     * @return at least 0
     */
    public int count() {
        return count;
    }

    /** The number of records of new circles. */
    public int added() {
        return added;
    }

    /** The records; valid until the next change. */
    public int[] records() {
        return records;
    }

    /** Forgets all records. */
    public void clear() {
        count = 0;
        added = 0;
    }

    /**
     * Makes room: the next records cannot fail for want of memory.
     *
     * @param more number of records to come
     */
    public void ensure(int more) {
        long need = ((long) count + more) * STRIDE;
        if (need > records.length) {
            if (need > Integer.MAX_VALUE - 8) {
                throw new IllegalStateException("too many changes before a step: " + (count + (long) more));
            }
            records =
                    Arrays.copyOf(records, (int) Math.min(Integer.MAX_VALUE - 8, Math.max(need, records.length * 2L)));
        }
    }

    /**
     * Records a new circle.
     *
     * @param id its id
     * @param x x
     * @param y y
     * @param radius radius
     * @param mass mass
     * @param restitution restitution
     * @param vx velocity
     * @param vy velocity
     */
    public void add(int id, float x, float y, float radius, float mass, float restitution, float vx, float vy) {
        prepare(0, x, y, radius, mass, restitution, vx, vy);
        admit(id);
    }

    /**
     * Copies a new circle to where {@link #admit} finds it. Until then it is no record, and the next record of another kind
     * overwrites it.
     *
     * @param ahead number of circles that are prepared and come before this one
     * @param x x
     * @param y y
     * @param radius radius
     * @param mass mass
     * @param restitution restitution
     * @param vx velocity
     * @param vy velocity
     */
    public void prepare(int ahead, float x, float y, float radius, float mass, float restitution, float vx, float vy) {
        ensure(ahead + 1);
        int k = STRIDE * (count + ahead);
        records[k + 2] = Float.floatToRawIntBits(x);
        records[k + 3] = Float.floatToRawIntBits(y);
        records[k + 4] = Float.floatToRawIntBits(radius);
        records[k + 5] = Float.floatToRawIntBits(mass);
        records[k + 6] = Float.floatToRawIntBits(restitution);
        records[k + 7] = Float.floatToRawIntBits(vx);
        records[k + 8] = Float.floatToRawIntBits(vy);
    }

    /**
     * The radius of the first circle that is prepared.
     *
     * @return a length
     */
    public float preparedRadius() {
        return Float.intBitsToFloat(records[STRIDE * count + 4]);
    }

    /**
     * Records the first circle that is prepared.
     *
     * @param id its id
     */
    public void admit(int id) {
        record(ADD, id);
        added++;
    }

    /**
     * Records that a circle goes.
     *
     * @param id its id
     */
    public void remove(int id) {
        record(REMOVE, id);
    }

    /**
     * Records a change of a circle.
     *
     * @param operation what changes
     * @param id the circle's id
     * @param a first value
     * @param b second value, of no meaning where the operation has one
     */
    public void set(int operation, int id, float a, float b) {
        int k = record(operation, id);
        records[k + 2] = Float.floatToRawIntBits(a);
        records[k + 3] = Float.floatToRawIntBits(b);
    }

    private int record(int operation, int id) {
        ensure(1);
        int k = STRIDE * count++;
        records[k] = operation;
        records[k + 1] = id;
        return k;
    }
}
