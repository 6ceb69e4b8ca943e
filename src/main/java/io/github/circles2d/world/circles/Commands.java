package io.github.circles2d.world.circles;

import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.PairTable;
import io.github.circles2d.world.model.WallMotion;
import java.util.Arrays;

/**
 * The changes since the last step or read, in call order: one record of {@link #STRIDE} ints each, floats as their bits. A pipeline
 * applies the records of one circle in order; records of different circles are independent.
 *
 * <p>The constants are the one table of a record: operations, fields, and length.
 */
public final class Commands {
    // ---- operations

    /** A new circle: x, y, radius, mass, restitution, vx, vy; its fields have their initial values. */
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

    /** New value of a field that steps read: its place in {@link CircleField#OF_STEPS}, the value. */
    public static final int FIELD = 9;

    /**
     * A static circle gets the velocity that leads it to a place within a step: x, y, length of the step. It keeps its own where
     * others have the impulses of the walls.
     */
    public static final int DEPART = 10;

    /** It is at the place, and gets its own velocity back: x, y. */
    public static final int ARRIVE = 11;

    /** New radius of a circle that grows or shrinks; its impulses stay, so that it goes on to carry what lies on it. */
    public static final int GROW = 12;

    /** New angle: its units, by {@link io.github.circles2d.world.model.Surface#units}, as bits. */
    public static final int ANGLE = 13;

    /** New angular velocity. */
    public static final int ANGULAR_VELOCITY = 14;

    /** An angular impulse; the inverse inertia by inverse mass of the circle's kind. */
    public static final int ANGULAR_IMPULSE = 15;

    /** A circle wakes, if it sleeps; and begins anew to come to rest. */
    public static final int WAKE = 16;

    /** Floats of a place around which circles wake. */
    public static final int AREA = 3;

    // ---- fields of a record, as indices of its ints

    /** Field: the operation. */
    public static final int OPCODE = 0;

    /** Field: the circle's id. */
    public static final int ID = 1;

    /** Field of a change: its first value. */
    public static final int FIRST = 2;

    /** Field of a change: its second value; of no meaning if the operation has one. */
    public static final int SECOND = 3;

    /** Field of {@link #DEPART}: length of the step. */
    public static final int THIRD = 4;

    /** Field of {@link #DEPART}: period along x, which may be infinite. */
    public static final int FOURTH = 5;

    /** Field of {@link #DEPART}: period along y. */
    public static final int FIFTH = 6;

    /** Field of a new circle: x. */
    public static final int ADD_X = 2;

    /** Field of a new circle: y. */
    public static final int ADD_Y = 3;

    /** Field of a new circle: radius. */
    public static final int ADD_RADIUS = 4;

    /** Field of a new circle: mass. */
    public static final int ADD_MASS = 5;

    /** Field of a new circle: restitution. */
    public static final int ADD_RESTITUTION = 6;

    /** Field of a new circle: velocity along x. */
    public static final int ADD_VX = 7;

    /** Field of a new circle: velocity along y. */
    public static final int ADD_VY = 8;

    /** Ints of a record. */
    public static final int STRIDE = 9;

    /** A caller applies this many records before it adds more, so that waiting records do not grow with the number of calls. */
    public static final int MANY = 1 << 16;

    private int[] records = new int[STRIDE * 64];
    private int count;
    private int added;

    /** A bit of each kind whose circles wake. */
    private final int[] kindsToWake = new int[PairTable.KINDS / Integer.SIZE];

    /** A bit of each wall, by {@link WallMotion#of}: circles wake that it presses. */
    private int wallsToWake;

    private boolean wakes;

    /** Places around which circles wake: x, y and how far of each. */
    private float[] areas = new float[0];

    private int areaCount;

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

    public int operation(int record) {
        return records[STRIDE * record + OPCODE];
    }

    public int id(int record) {
        return records[STRIDE * record + ID];
    }

    public int first(int record) {
        return records[STRIDE * record + FIRST];
    }

    public int second(int record) {
        return records[STRIDE * record + SECOND];
    }

    /** Whether an operation makes a circle turn. */
    public static boolean turns(int operation) {
        return operation >= ANGLE && operation <= ANGULAR_IMPULSE;
    }

    /** Forgets all records. */
    public void clear() {
        count = 0;
        added = 0;
        if (wakes) {
            Arrays.fill(kindsToWake, 0);
            wallsToWake = 0;
            wakes = false;
        }
        areaCount = 0;
    }

    /** Makes room: the next places around which circles wake cannot fail for want of memory. */
    public void ensureAreas(int more) {
        int need = AREA * (areaCount + more);
        if (need > areas.length) {
            areas = Arrays.copyOf(areas, Math.max(need, 2 * areas.length));
        }
    }

    /** Circles wake that sleep near to a place, as {@link #wakeAll} has it: within some distance of it by {@code Sleep}. There is room. */
    public void wakeAround(float x, float y, float distance) {
        int at = AREA * areaCount++;
        areas[at] = x;
        areas[at + 1] = y;
        areas[at + 2] = distance;
    }

    /** How many places there are around which circles wake. */
    public int areas() {
        return areaCount;
    }

    /** x, y and the distance of such places; valid until the next change. */
    public float[] areaValues() {
        return areas;
    }

    /** All circles that sleep wake with these changes, before them or behind them: no change puts any to sleep. */
    public void wakeAll() {
        Arrays.fill(kindsToWake, -1);
        wakes = true;
    }

    /** The same of circles of a kind: those that get another one with these changes wake anyway. */
    public void wakeKind(int kind) {
        kindsToWake[kind / Integer.SIZE] |= 1 << kind % Integer.SIZE;
        wakes = true;
    }

    /** The same of circles that a wall presses, numbered as by {@link WallMotion#of}. */
    public void wakeAtWall(int wall) {
        wallsToWake |= 1 << wall;
        wakes = true;
    }

    /** Whether circles wake by their kind, or at a wall. */
    public boolean wakesSome() {
        return wakes;
    }

    /** A bit of each kind whose circles wake; valid until the next change. */
    public int[] kindsToWake() {
        return kindsToWake;
    }

    /** A bit of each wall at which circles wake. */
    public int wallsToWake() {
        return wallsToWake;
    }

    /** Whether circles of a kind wake on which walls have these impulses. */
    public boolean wakes(int kind, float wallX, float wallY) {
        return (kindsToWake[kind / Integer.SIZE] & 1 << kind % Integer.SIZE) != 0
                || (WallMotion.pressing(wallX, wallY) & wallsToWake) != 0;
    }

    /** Whether there is nothing to do. */
    public boolean isEmpty() {
        return count == 0 && !wakes && areaCount == 0;
    }

    /** Makes room: the next records cannot fail for want of memory. */
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

    /** Copies a new circle to where {@link #admit} finds it, behind those ahead. The next record of another kind overwrites it. */
    public void prepare(int ahead, float x, float y, float radius, float mass, float restitution, float vx, float vy) {
        ensure(ahead + 1);
        int k = STRIDE * (count + ahead);
        records[k + ADD_X] = Float.floatToRawIntBits(x);
        records[k + ADD_Y] = Float.floatToRawIntBits(y);
        records[k + ADD_RADIUS] = Float.floatToRawIntBits(radius);
        records[k + ADD_MASS] = Float.floatToRawIntBits(mass);
        records[k + ADD_RESTITUTION] = Float.floatToRawIntBits(restitution);
        records[k + ADD_VX] = Float.floatToRawIntBits(vx);
        records[k + ADD_VY] = Float.floatToRawIntBits(vy);
    }

    public float preparedRestitution() {
        return Float.intBitsToFloat(records[STRIDE * count + ADD_RESTITUTION]);
    }

    public float preparedRadius() {
        return Float.intBitsToFloat(records[STRIDE * count + ADD_RADIUS]);
    }

    public float preparedMass() {
        return Float.intBitsToFloat(records[STRIDE * count + ADD_MASS]);
    }

    /** Records the first circle that is prepared. */
    public void admit(int id) {
        record(ADD, id);
        added++;
    }

    /** b has no meaning if the operation has one value. */
    public void set(int operation, int id, float a, float b) {
        int k = record(operation, id);
        records[k + FIRST] = Float.floatToRawIntBits(a);
        records[k + SECOND] = Float.floatToRawIntBits(b);
    }

    /** Records that a static circle is to be elsewhere at the end of a step. */
    public void depart(int id, float x, float y, float timeStep, Bounds bounds) {
        set(DEPART, id, x, y);
        int k = STRIDE * (count - 1);
        records[k + THIRD] = Float.floatToRawIntBits(timeStep);
        records[k + FOURTH] = Float.floatToRawIntBits(bounds.periodX());
        records[k + FIFTH] = Float.floatToRawIntBits(bounds.periodY());
    }

    /** Takes the last records back. */
    public void drop(int records) {
        count -= records;
    }

    /** Of a field that steps read. */
    public void setField(CircleField field, int id, int value) {
        int k = record(FIELD, id);
        records[k + FIRST] = CircleField.OF_STEPS.indexOf(field);
        records[k + SECOND] = value;
    }

    /** Copies a change to where {@link #admitChanges} finds it, behind those ahead; the next record of another kind overwrites it. */
    public void prepareChange(int ahead, int operation, int id, float a, float b) {
        ensure(ahead + 1);
        int k = STRIDE * (count + ahead);
        records[k + OPCODE] = operation;
        records[k + ID] = id;
        records[k + FIRST] = Float.floatToRawIntBits(a);
        records[k + SECOND] = Float.floatToRawIntBits(b);
    }

    /** As {@link #prepareChange}. */
    public void prepareField(int ahead, CircleField field, int id, int value) {
        prepareChange(ahead, FIELD, id, 0, 0);
        int k = STRIDE * (count + ahead);
        records[k + FIRST] = CircleField.OF_STEPS.indexOf(field);
        records[k + SECOND] = value;
    }

    /** As {@link #prepareChange}, of an operation whose value is a whole number. */
    public void prepareInt(int ahead, int operation, int id, int value) {
        prepareChange(ahead, operation, id, 0, 0);
        records[STRIDE * (count + ahead) + FIRST] = value;
    }

    /** The operation of a change that is prepared, before which others are. */
    public int preparedOperation(int ahead) {
        return records[STRIDE * (count + ahead) + OPCODE];
    }

    /** The field of a change that is prepared, before which others are; its operation is {@link #FIELD}. */
    public CircleField preparedField(int ahead) {
        return CircleField.OF_STEPS.get(records[STRIDE * (count + ahead) + FIRST]);
    }

    public int preparedValue(int ahead) {
        return records[STRIDE * (count + ahead) + SECOND];
    }

    public int preparedId(int ahead) {
        return records[STRIDE * (count + ahead) + ID];
    }

    public float preparedFirst(int ahead) {
        return Float.intBitsToFloat(records[STRIDE * (count + ahead) + FIRST]);
    }

    public float preparedSecond(int ahead) {
        return Float.intBitsToFloat(records[STRIDE * (count + ahead) + SECOND]);
    }

    /** Moves a prepared change to an earlier place, over the one that is there. */
    public void advancePrepared(int from, int to) {
        if (from != to) {
            System.arraycopy(records, STRIDE * (count + from), records, STRIDE * (count + to), STRIDE);
        }
    }

    /** Records the changes that are prepared. */
    public void admitChanges(int changes) {
        count += changes;
    }

    private int record(int operation, int id) {
        ensure(1);
        int k = STRIDE * count++;
        records[k + OPCODE] = operation;
        records[k + ID] = id;
        return k;
    }
}
