package io.github.circles2d.world.jvm.state;

import static io.github.circles2d.world.model.CircleRow.DX;
import static io.github.circles2d.world.model.CircleRow.DY;
import static io.github.circles2d.world.model.CircleRow.INVERSE_MASS;
import static io.github.circles2d.world.model.CircleRow.MASS;
import static io.github.circles2d.world.model.CircleRow.RADIUS;
import static io.github.circles2d.world.model.CircleRow.RESTITUTION;
import static io.github.circles2d.world.model.CircleRow.VX;
import static io.github.circles2d.world.model.CircleRow.VY;
import static io.github.circles2d.world.model.CircleRow.WALL_X;
import static io.github.circles2d.world.model.CircleRow.WALL_Y;
import static io.github.circles2d.world.model.CircleRow.X;
import static io.github.circles2d.world.model.CircleRow.Y;

import io.github.circles2d.world.bodies.RigidStep;
import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.circles.CircleFields;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.StateHash;
import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.JointStep;
import io.github.circles2d.world.model.KindMotion;
import io.github.circles2d.world.model.Sleep;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.StepReports;
import io.github.circles2d.world.model.Tuning;
import io.github.circles2d.world.model.Velocity;
import io.github.circles2d.world.model.Walls;
import io.github.circles2d.world.snapshots.SavedState;
import java.util.Arrays;

/**
 * The circles on the JVM: dense slots 0 to n - 1, in flat arrays. Slots below {@link #awake} are in the cell order of the last grid. The
 * slots behind it have the circles that {@linkplain Resting rest}, in no order.
 *
 * <p>A position is a base, which stays for a step, and the displacement since. A step adds far less to a coordinate than the
 * coordinate itself, and rounding would lose it if millions of circles share an arena. At the end of a step the base becomes the
 * sum, and the displacement becomes what the sum lost.
 */
public final class State implements ContactEvents.Sleepers {
    /** Number of circles. */
    public int n;

    /** Number of circles that do not rest, which have the lowest slots. */
    public int awake;

    /** The circles that rest. */
    public final Resting resting = new Resting(this);

    /** Circles that all arrays have room for; some have room for more after a growth that ran out of memory. */
    private int capacity;

    /** By slot: x, y of the base, radius, mass. {@link CircleRow} numbers the elements of each array. */
    public float[] circle = new float[0];

    /** By slot: displacement x, y, velocity x, y. */
    public float[] motion = new float[0];

    /** By slot: inverse mass (0: static), restitution, impulse speed of the walls x, y (positive: lower wall). */
    public float[] traits = new float[0];

    public int[] id = new int[0];

    /** By slot: first of the circle's entries in the impulse cache as the one of lower id, or -1. */
    public int[] firstCached = new int[0];

    /** By slot: true if impulses of the step before are not its own (a new circle, maybe under a recycled id). */
    public boolean[] fresh = new boolean[0];

    /** By slot, within a sub-step; {@link CircleRow} has its two meanings. */
    public float[] load = new float[0];

    /** By slot, within a sub-step: speed that the walls bounce the circle to, x, y; 0 for none. */
    public float[] wallBounce = new float[0];

    /** By slot, within a step: room from the base of a circle to the nearest wall; 0 from where on a wall or a piece may matter to it. */
    public float[] room = new float[0];

    /** By slot, within a step: what the circle would move in a step, x, y. */
    public float[] plan = new float[0];

    /** By slot, within a step: the path that is free, x, y, how far the circle may leave it, and the share of it that is free. */
    public float[] motionClamp = new float[0];

    /** By id: the slot, or -1. */
    public int[] slotOf = new int[0];

    /** By id: the fields that steps read. */
    public final CircleFields fields = new CircleFields(CircleField.OF_STEPS);

    /** Within a step: joints that keep circles from colliding, and which of them have broken; null if none does. */
    public JointStep parting;

    /** By slot, whether another circle is near; null in a step that senses none. Workers write true alone. */
    public boolean[] seen;

    public JointStates partingStates;

    /** Within a step, by slot: whether a joint holds the circle, so that it may leave its path; null without joints. */
    public boolean[] jointed;

    /** Within a step: what moves circles of kinds, by {@code KindMotion}; null if gravity alone moves all circles. */
    public float[] kindMotion;

    /** Within a step: whether circles may have values of their own in place of those of {@link #kindMotion}. */
    public boolean ownMotion;

    /** Within a step: whether an axis wraps, so that differences have to be taken {@linkplain CircleMath#shortWay the short way}. */
    public boolean wraps;

    /** Within a step: the period along x; infinite if x does not wrap. */
    public float periodX;

    public float periodY;

    /** Within a step: where things are seen again. */
    public final WrapImages images = new WrapImages();

    /** Within a step: whether pairs have to be filtered. */
    public boolean filtering;

    /** Within a step: what the circles of two kinds do to each other, by {@code PairTable}. */
    public int[] responses;

    /** Of the last step: bits by kind, whether its static circles look at others, and so never rest; null if none do. */
    public long[] asking;

    /** What circles need to rotate; null as long as they cannot. */
    public Turning turning;

    /** How circles come to rest; null if none sleeps in the state of now. */
    public Sleepers sleepers;

    /** What {@link #sleepers} is in a world whose circles sleep; null as long as there has been none. */
    private Sleepers allSleepers;

    /** Circles that have fallen asleep, or were loaded so, and do not lie with those that rest yet: ids. */
    private int[] drowsy = new int[16];

    private int drowsyCount;

    /** Null as long as there has been no rigid body. */
    public RigidStep rigids;

    /** What circles give back that wake; {@link #startSleep} sets it. */
    private ImpulseCache impulseCache;

    private Bounds arena = new Bounds(0, 0, 1, 1);

    private final Resting.Found near = new Resting.Found();

    /** The pieces of terrain that circles are near to; null as long as there has been no terrain. */
    public PieceContacts pieces;

    private float[] circleSpare = new float[0];
    private float[] motionSpare = new float[0];
    private float[] traitsSpare = new float[0];
    private int[] idSpare = new int[0];
    private int[] firstCachedSpare = new int[0];
    private boolean[] freshSpare = new boolean[0];

    public long bytes() {
        // twice: 4 floats of circle, motion and traits, id, firstCached, fresh; once: load, bounce, room, plan,
        // motionClamp
        return (2 * (3 * 16 + 4 + 4 + 1) + 16 + 8 + 4 + 8 + 16L) * capacity()
                + 4L * slotOf.length
                + fields.bytes()
                + resting.bytes()
                + (allSleepers == null ? 0 : allSleepers.bytes())
                + (turning == null ? 0 : turning.bytes())
                + (pieces == null ? 0 : pieces.bytes());
    }

    public int capacity() {
        return capacity;
    }

    /** Makes room. The array that is compared grows last: a growth that fails is tried again. */
    public void ensure(int circles) {
        if (circles > capacity) {
            int c = Math.max(circles, capacity + (capacity >> 1));
            if (turning != null) {
                turning.ensure(c);
            }
            if (pieces != null) {
                pieces.ensure(c);
            }
            circle = Arrays.copyOf(circle, CircleRow.of(c));
            motion = Arrays.copyOf(motion, CircleRow.of(c));
            traits = Arrays.copyOf(traits, CircleRow.of(c));
            id = Arrays.copyOf(id, c);
            firstCached = Arrays.copyOf(firstCached, c);
            fresh = Arrays.copyOf(fresh, c);
            load = new float[CircleRow.of(c)];
            wallBounce = new float[CircleRow.vector(c)];
            room = new float[c];
            plan = new float[CircleRow.vector(c)];
            motionClamp = new float[CircleRow.of(c)];
            circleSpare = new float[CircleRow.of(c)];
            motionSpare = new float[CircleRow.of(c)];
            traitsSpare = new float[CircleRow.of(c)];
            idSpare = new int[c];
            firstCachedSpare = new int[c];
            freshSpare = new boolean[c];
            capacity = c;
        }
    }

    /** Makes room for what circles need to rotate. */
    public void startTurning() {
        if (turning == null) {
            Turning all = new Turning(this);
            all.ensure(capacity);
            if (allSleepers != null) {
                allSleepers.ensureRows();
            }
            turning = all;
        }
    }

    /** Makes room for how circles come to rest. */
    public void startSleep(ImpulseCache cache) {
        if (allSleepers == null) {
            Sleepers all = new Sleepers(this);
            all.ensure(slotOf.length);
            impulseCache = cache;
            allSleepers = all;
            sleepers = n == 0 ? all : null; // else another state is to come
        }
    }

    /** Says whether circles sleep, for which there is room. */
    public void setSleeps(boolean does) {
        sleepers = does ? allSleepers : null;
    }

    /** Makes room for what circles have to do with terrain. */
    public void startTerrain() {
        if (pieces == null) {
            PieceContacts all = new PieceContacts();
            all.ensure(capacity);
            pieces = all;
        }
    }

    public void ensureIds(int ids) {
        if (ids > slotOf.length) {
            int old = slotOf.length;
            int[] longer = Arrays.copyOf(slotOf, Math.max(ids, old + (old >> 1)));
            Arrays.fill(longer, old, longer.length, -1);
            if (allSleepers != null) {
                allSleepers.ensure(longer.length);
            }
            slotOf = longer;
        }
    }

    /** Makes room for what the caller asked for. */
    public void makeRoom(Commands commands) {
        int[] records = commands.records();
        int circles = n;
        int most = n;
        int ids = 0;
        for (int k = 0; k < commands.count() * Commands.STRIDE; k += Commands.STRIDE) {
            if (records[k + Commands.OPCODE] == Commands.ADD) {
                most = Math.max(most, ++circles);
                ids = Math.max(ids, records[k + Commands.ID] + 1);
            } else if (records[k + Commands.OPCODE] == Commands.REMOVE) {
                circles--;
            } else if (records[k + Commands.OPCODE] == Commands.FIELD) {
                fields.ensure(field(records, k), records[k + Commands.ID] + 1);
            }
        }
        ensure(most);
        ensureIds(ids);
        if (sleepers != null) {
            impulseCache.ensure(impulseCache.filled() + sleepers.impulses());
        }
    }

    private static CircleField field(int[] records, int k) {
        return CircleField.OF_STEPS.get(records[k + Commands.FIRST]);
    }

    public void makeRoom(SavedState from) {
        ensure(from.circles);
        if (from.turns) {
            startTurning();
        }
        if (pieces != null) {
            pieces.makeRoom(from.pieceContacts);
        }
        ensureIds(from.ids);
        fields.makeRoom(from.fields);
        if (from.sleeps && drowsy.length < from.circles) {
            drowsy = new int[from.circles];
        }
    }

    /** Applies what the caller asked for, for which there is room. */
    public void apply(Commands commands) {
        if (commands.wakesSome()) {
            wakeBy(commands);
        }
        for (int k = 0; k < commands.areas(); k++) {
            float[] area = commands.areaValues();
            int at = Commands.AREA * k;
            wakeNear(-1, area[at], area[at + 1], area[at + 2]);
        }
        int[] records = commands.records();
        for (int c = 0; c < commands.count(); c++) {
            int k = c * Commands.STRIDE;
            int circleId = records[k + Commands.ID];
            if (records[k + Commands.OPCODE] == Commands.ADD) {
                add(circleId, records, k);
                continue;
            }
            int slot = slotOf[circleId];
            if (records[k + Commands.OPCODE] == Commands.REMOVE) {
                wakeNear(slot);
                remove(slotOf[circleId]);
                continue;
            }
            if (records[k + Commands.OPCODE] == Commands.FIELD) {
                fields.set(field(records, k), circleId, records[k + Commands.SECOND]);
                changed(field(records, k), circleId);
                continue;
            }
            wakeNear(records[k + Commands.OPCODE], slot);
            slot = wake(slotOf[circleId]);
            float a = Float.intBitsToFloat(records[k + Commands.FIRST]);
            float b = Float.intBitsToFloat(records[k + Commands.SECOND]);
            int s = CircleRow.of(slot);
            switch (records[k + Commands.OPCODE]) {
                case Commands.POSITION -> {
                    circle[s + X] = a;
                    circle[s + Y] = b;
                    motion[s + DX] = 0;
                    motion[s + DY] = 0;
                    forgetPieces(slot);
                }
                case Commands.VELOCITY -> {
                    motion[s + VX] = a;
                    motion[s + VY] = b;
                }
                case Commands.RADIUS -> {
                    circle[s + RADIUS] = a;
                    forget(slot);
                }
                case Commands.GROW -> circle[s + RADIUS] = a;
                case Commands.MASS -> {
                    circle[s + MASS] = a;
                    traits[s + INVERSE_MASS] = CircleMath.inverseMass(a);
                    forget(slot);
                    noteSleep();
                }
                case Commands.RESTITUTION -> traits[s + RESTITUTION] = a;
                case Commands.IMPULSE -> {
                    float w = traits[s + INVERSE_MASS];
                    motion[s + VX] = Velocity.afterImpulse(motion[s + VX], w, a);
                    motion[s + VY] = Velocity.afterImpulse(motion[s + VY], w, b);
                }
                case Commands.ANGLE -> turning.angle[slot] = records[k + Commands.FIRST];
                case Commands.ANGULAR_VELOCITY -> turning.angularVelocity[slot] = a;
                case Commands.ANGULAR_IMPULSE -> turning.applyImpulse(slot, a, b);
                case Commands.DEPART -> depart(s, a, b, records, k);
                case Commands.ARRIVE -> {
                    arrive(s, a, b);
                    wakeNear(slot); // a path is shorter than the way if that is a large share of a period
                    slot = slotOf[circleId];
                }
                case Commands.WAKE -> {
                    // it is awake
                }
                default -> throw new AssertionError("unknown operation " + records[k + Commands.OPCODE]);
            }
            if (sleepers != null) {
                sleepers.restart(slot);
                wakeNear(records[k + Commands.OPCODE], slot);
            }
        }
    }

    // ---- sleep

    /** A field of a circle has changed. */
    private void changed(CircleField field, int circleId) {
        if (asking != null && field == CircleField.KIND) {
            wake(slotOf[circleId]);
        }
        if (sleepers == null) {
            return;
        }
        boolean meets = field == CircleField.KIND || field == CircleField.GROUP || field.isOfSurface();
        if (!meets && !field.isOfMotion()) {
            sleepers.suspect(circleId); // its force
            return;
        }
        sleepers.restart(wake(slotOf[circleId]));
        if (meets) {
            wakeNear(slotOf[circleId]);
        }
    }

    /** Before a change of a circle, and behind it: wakes those that may lose what carries them, or be pushed. */
    private void wakeNear(int operation, int slot) {
        switch (operation) {
            case Commands.POSITION, Commands.RADIUS, Commands.GROW, Commands.MASS, Commands.ANGULAR_VELOCITY ->
                wakeNear(slot);
            default -> {
                // the others lie as they did
            }
        }
    }

    /** Wakes circles that sleep and may touch one that changes. */
    private void wakeNear(int changed) {
        int s = CircleRow.of(changed);
        float x = circle[s + X];
        float y = circle[s + Y];
        float r = circle[s + RADIUS];
        if (sleepers != null && rigids != null) {
            rigids.wakeNear(-1, x, y, r, periodX, periodY);
        }
        wakeNear(id[changed], x, y, r); // slots change as circles wake
    }

    /** The same of what is at a place, and reaches so far; itself: the circle that it is, or -1. */
    private void wakeNear(int itself, float x, float y, float r) {
        if (sleepers == null || sleepers.count == 0) {
            return;
        }
        float far = Sleep.NEIGHBOURS * r;
        resting.find(near, arena, x - far, x + far, y - far, y + far, Sleep.NEIGHBOURS);
        for (int k = 0; k < near.count; k++) {
            near.slots[k] = id[near.slots[k]]; // slots change as circles wake
        }
        for (int k = 0; k < near.count; k++) {
            wakeIfNear(near.slots[k], itself, x, y, r);
        }
        for (int k = drowsyCount - 1; k >= 0; k--) {
            wakeIfNear(drowsy[k], itself, x, y, r);
        }
    }

    private void wakeIfNear(int other, int changed, float x, float y, float r) {
        if (other == changed || slotOf[other] < 0 || !sleepers.isAsleep(other)) {
            return;
        }
        int s = CircleRow.of(slotOf[other]);
        float wayX = x - circle[s + X];
        float wayY = y - circle[s + Y];
        float far = Sleep.NEIGHBOURS * (circle[s + RADIUS] + r);
        if (Math.abs(wraps ? CircleMath.shortWay(wayX, periodX) : wayX) <= far
                && Math.abs(wraps ? CircleMath.shortWay(wayY, periodY) : wayY) <= far) {
            sleepers.restart(wake(slotOf[other]));
        }
    }

    /** Wakes circles by their kinds, and at walls. */
    private void wakeBy(Commands commands) {
        if (sleepers != null && rigids != null) {
            rigids.wakeBy(commands);
        }
        for (int slot = n - 1; slot >= 0 && sleepers != null && sleepers.count > 0; slot--) {
            int s = CircleRow.of(slot);
            if (sleepers.isAsleep(id[slot])
                    && commands.wakes(
                            fields.getInt(CircleField.KIND, id[slot]), traits[s + WALL_X], traits[s + WALL_Y])) {
                sleepers.restart(wake(slot));
                slot = Math.min(slot + 1, n); // another one has come to the place
            }
        }
    }

    /** The inverse mass of a circle, also of one that sleeps. */
    public float ownInverseMass(int slot) {
        return CircleMath.inverseMass(circle[CircleRow.of(slot) + MASS]);
    }

    @Override
    public boolean sleeps(int circleId) {
        return sleepers.isAsleep(circleId);
    }

    @Override
    public boolean rest(int circleId, int otherId) {
        return (sleepers.isAsleep(circleId) || sleepers.isAsleep(otherId))
                && isStatic(slotOf[circleId])
                && isStatic(slotOf[otherId]);
    }

    /** A circle falls asleep, with the acceleration by gravity and its force; until the next step it lies where it is. */
    public void sleep(int slot, float knownX, float knownY) {
        int s = CircleRow.of(slot);
        sleepers.sleep(id[slot], knownX, knownY);
        motion[s + VX] = 0f;
        motion[s + VY] = 0f;
        traits[s + INVERSE_MASS] = 0f;
        if (turning != null) {
            turning.angularVelocity[slot] = 0f;
        }
    }

    /** Circles of the awake slots that sleep are to rest from the next step on. */
    public void noteDrowsy() {
        noteSleep();
        for (int slot = 0; slot < awake; slot++) {
            if (sleepers.isAsleep(id[slot])) {
                if (drowsyCount == drowsy.length) {
                    drowsy = Arrays.copyOf(drowsy, 2 * drowsyCount);
                }
                drowsy[drowsyCount++] = id[slot];
                sleepers.count++;
            }
        }
    }

    /** Others sleep than before, or other circles are static. */
    private void noteSleep() {
        if (sleepers != null) {
            sleepers.version++;
        }
    }

    public int drowsy() {
        return drowsyCount;
    }

    public int drowsyAt(int k) {
        return drowsy[k];
    }

    public void forgetDrowsy() {
        drowsyCount = 0;
    }

    private void depart(int s, float x, float y, int[] records, int k) {
        float dt = Float.intBitsToFloat(records[k + Commands.THIRD]);
        float periodX = Float.intBitsToFloat(records[k + Commands.FOURTH]);
        float periodY = Float.intBitsToFloat(records[k + Commands.FIFTH]);
        traits[s + WALL_X] = motion[s + VX];
        traits[s + WALL_Y] = motion[s + VY];
        motion[s + VX] = Velocity.travelSpeed(circle[s + X], x, dt, periodX);
        motion[s + VY] = Velocity.travelSpeed(circle[s + Y], y, dt, periodY);
    }

    private void arrive(int s, float x, float y) {
        circle[s + X] = x;
        circle[s + Y] = y;
        motion[s + DX] = 0;
        motion[s + DY] = 0;
        motion[s + VX] = traits[s + WALL_X];
        motion[s + VY] = traits[s + WALL_Y];
        traits[s + WALL_X] = 0;
        traits[s + WALL_Y] = 0;
    }

    private void add(int circleId, int[] records, int k) {
        int slot = awake++;
        if (slot < n) {
            move(slot, n);
        }
        n++;
        int s = CircleRow.of(slot);
        circle[s + X] = Float.intBitsToFloat(records[k + Commands.ADD_X]);
        circle[s + Y] = Float.intBitsToFloat(records[k + Commands.ADD_Y]);
        circle[s + RADIUS] = Float.intBitsToFloat(records[k + Commands.ADD_RADIUS]);
        circle[s + MASS] = Float.intBitsToFloat(records[k + Commands.ADD_MASS]);
        motion[s + DX] = 0;
        motion[s + DY] = 0;
        motion[s + VX] = Float.intBitsToFloat(records[k + Commands.ADD_VX]);
        motion[s + VY] = Float.intBitsToFloat(records[k + Commands.ADD_VY]);
        traits[s + INVERSE_MASS] = CircleMath.inverseMass(circle[s + MASS]);
        traits[s + RESTITUTION] = Float.intBitsToFloat(records[k + Commands.ADD_RESTITUTION]);
        id[slot] = circleId;
        slotOf[circleId] = slot;
        fields.clear(circleId);
        forget(slot);
        if (turning != null) {
            turning.add(slot);
        }
        if (sleepers != null) {
            sleepers.forget(circleId);
            if (isStatic(slot)) {
                wakeNear(slot);
            }
        }
        proposeRest(slotOf[circleId]);
    }

    private void proposeRest(int slot) {
        if (isStatic(slot)) {
            resting.propose();
        }
    }

    private void forget(int slot) {
        firstCached[slot] = -1;
        fresh[slot] = true;
        traits[CircleRow.of(slot) + WALL_X] = 0;
        traits[CircleRow.of(slot) + WALL_Y] = 0;
        if (turning != null) {
            turning.forget(slot);
        }
        forgetPieces(slot);
    }

    private void forgetPieces(int slot) {
        if (pieces != null) {
            pieces.forget(slot);
        }
        if (sleepers != null) {
            sleepers.forgetPieces(id[slot]);
        }
    }

    private void remove(int slot) {
        if (sleepers != null) {
            sleepers.count -= sleepers.isAsleep(id[slot]) ? 1 : 0;
            sleepers.forget(id[slot]);
        }
        slotOf[id[slot]] = -1;
        int hole = slot;
        if (slot >= awake) {
            resting.remove(id[slot]);
        } else if (slot != --awake) {
            move(awake, slot);
            hole = awake;
        }
        if (hole != --n) {
            move(n, hole);
        }
    }

    /** Moves a circle to a slot that has none. */
    private void move(int from, int to) {
        System.arraycopy(circle, CircleRow.of(from), circle, CircleRow.of(to), CircleRow.STRIDE);
        System.arraycopy(motion, CircleRow.of(from), motion, CircleRow.of(to), CircleRow.STRIDE);
        System.arraycopy(traits, CircleRow.of(from), traits, CircleRow.of(to), CircleRow.STRIDE);
        id[to] = id[from];
        firstCached[to] = firstCached[from];
        fresh[to] = fresh[from];
        if (turning != null) {
            turning.move(from, to);
        }
        if (pieces != null) {
            pieces.move(from, to);
        }
        slotOf[id[to]] = to;
    }

    private void exchange(int slot, int other) {
        if (slot == other) {
            return;
        }
        for (int k = 0; k < CircleRow.STRIDE; k++) {
            exchange(circle, CircleRow.of(slot) + k, CircleRow.of(other) + k);
            exchange(motion, CircleRow.of(slot) + k, CircleRow.of(other) + k);
            exchange(traits, CircleRow.of(slot) + k, CircleRow.of(other) + k);
        }
        exchange(id, slot, other);
        exchange(firstCached, slot, other);
        boolean isFresh = fresh[slot];
        fresh[slot] = fresh[other];
        fresh[other] = isFresh;
        if (turning != null) {
            turning.exchange(slot, other);
        }
        if (pieces != null) {
            pieces.exchange(slot, other);
        }
        slotOf[id[slot]] = slot;
        slotOf[id[other]] = other;
    }

    static void exchange(float[] values, int one, int other) {
        float value = values[one];
        values[one] = values[other];
        values[other] = value;
    }

    static void exchange(int[] values, int one, int other) {
        int value = values[one];
        values[one] = values[other];
        values[other] = value;
    }

    /** Makes a circle take part in steps, until it comes to rest again; returns its slot from now on. */
    public int wake(int slot) {
        int to = slot;
        if (slot >= awake) {
            resting.remove(id[slot]);
            to = awake++;
            exchange(slot, to);
        }
        if (sleepers != null && sleepers.isAsleep(id[to])) {
            traits[CircleRow.of(to) + INVERSE_MASS] = ownInverseMass(to);
            sleepers.setRest(id[to], 0);
            sleepers.count--;
            noteSleep();
            sleepers.giveBack(id[to], impulseCache);
        }
        proposeRest(to);
        return to;
    }

    /** Lets a circle rest that does not. */
    public void rest(int slot) {
        resting.add(slot);
        exchange(slot, --awake);
    }

    /** Where the row of a circle's kind begins in {@link #kindMotion}. */
    public int motionRow(int slot) {
        return KindMotion.of(fields.getInt(CircleField.KIND, id[slot]));
    }

    /** What a circle has of its own in place of its kind's, or NaN. */
    public float own(CircleField field, int slot) {
        return ownMotion ? fields.getFloat(field, id[slot]) : Float.NaN;
    }

    private float gravityGain(int slot, int ofKind, float gravity, StepConstants k) {
        float scale = own(CircleField.GRAVITY_SCALE, slot);
        return Float.isNaN(scale) ? kindMotion[motionRow(slot) + ofKind] : Velocity.gravityGain(gravity, scale, k.h);
    }

    /** The share of a circle's velocity that a sub-step leaves; row: of its kind. */
    public float dampingFactor(int slot, int row, StepConstants k) {
        float own = Velocity.dampingFactor(own(CircleField.DAMPING, slot), k.h);
        return CircleMath.orOfKind(own, kindMotion[row + KindMotion.DAMPING_FACTOR]);
    }

    public float greatestSpeed(int slot, int row) {
        return CircleMath.orOfKind(own(CircleField.GREATEST_SPEED, slot), kindMotion[row + KindMotion.GREATEST_SPEED]);
    }

    /** What gravity and a force add to a circle's speed along x in a sub-step. */
    public float gainX(int slot, StepConstants k) {
        return gainX(slot, traits[CircleRow.of(slot) + INVERSE_MASS], k);
    }

    /** The same of a circle of some inverse mass. */
    public float gainX(int slot, float w, StepConstants k) {
        return kindMotion == null
                ? k.gravityStepX
                : gain(slot, gravityGain(slot, KindMotion.GAIN_X, k.gravityX, k), CircleField.FORCE_X, w, k);
    }

    /** What gravity and a force add to a circle's speed along y in a sub-step. */
    public float gainY(int slot, StepConstants k) {
        return gainY(slot, traits[CircleRow.of(slot) + INVERSE_MASS], k);
    }

    /** The same of a circle of some inverse mass. */
    public float gainY(int slot, float w, StepConstants k) {
        return kindMotion == null
                ? k.gravityStepY
                : gain(slot, gravityGain(slot, KindMotion.GAIN_Y, k.gravityY, k), CircleField.FORCE_Y, w, k);
    }

    private float gain(int slot, float gravityGain, CircleField force, float w, StepConstants k) {
        return Velocity.gain(gravityGain, fields.getFloat(force, id[slot]), w, k.h);
    }

    /** The same, but 0 for a static circle. */
    public float fallX(int slot, StepConstants k) {
        return isStatic(slot) ? 0f : gainX(slot, k);
    }

    /** The same along y. */
    public float fallY(int slot, StepConstants k) {
        return isStatic(slot) ? 0f : gainY(slot, k);
    }

    /** How much greater the x of one slot is than that of another. */
    public float differenceX(int slot, int other) {
        float d = circle[CircleRow.of(other) + X] - circle[CircleRow.of(slot) + X];
        return wraps ? CircleMath.shortWay(d, periodX) : d;
    }

    /** How much greater the y of one slot is than that of another. */
    public float differenceY(int slot, int other) {
        float d = circle[CircleRow.of(other) + Y] - circle[CircleRow.of(slot) + Y];
        return wraps ? CircleMath.shortWay(d, periodY) : d;
    }

    /** Whether a static circle moves: of several that carry a circle from one time on, the one of the lowest slot does. */
    public boolean hasMovingStatic() {
        for (int slot = 0; slot < awake; slot++) {
            int s = CircleRow.of(slot);
            if (isStatic(slot) && (motion[s + VX] != 0f || motion[s + VY] != 0f)) {
                return true;
            }
        }
        return false;
    }

    /** Notes that two circles are near to each other, if the step senses circles. */
    public void noteSeen(int slot, int other) {
        boolean[] noted = seen;
        if (noted != null) {
            noted[slot] = true;
            noted[other] = true;
        }
    }

    /** Whether a circle has an infinite mass. */
    public boolean isStatic(int slot) {
        return traits[CircleRow.of(slot) + INVERSE_MASS] == 0f;
    }

    /** Whether a circle is static, and looks at others that are. */
    public boolean asks(int slot) {
        return asking != null && isStatic(slot) && !isAsleep(slot) && StepReports.asks(asking, kind(slot));
    }

    public boolean isAsleep(int slot) {
        return sleepers != null && sleepers.isAsleep(id[slot]);
    }

    private int kind(int slot) {
        return fields.getInt(CircleField.KIND, id[slot]);
    }

    /** How far a circle may leave its free path if nothing is in its way. */
    public float freeAllowance(int slot) {
        return jointed != null && jointed[slot]
                ? Float.POSITIVE_INFINITY
                : Tuning.CLAMP_ALLOWANCE * circle[CircleRow.of(slot) + RADIUS];
    }

    /** How near to a wall the centre of the circle of a row may be. */
    public float margin(int row) {
        return traits[row + INVERSE_MASS] == 0f ? 0f : circle[row + RADIUS];
    }

    /**
     * Brings circles that the walls have left outside to the nearest place inside, if the step does not push them there. Wakes those that sleep
     * and reach out of the calm bounds.
     */
    public void confine(Bounds from, Bounds to, Bounds calm) {
        for (int slot = 0; slot < n; slot++) {
            int s = CircleRow.of(slot);
            float margin = ownInverseMass(slot) == 0f ? 0f : circle[s + RADIUS];
            float x = confined(circle[s + X], from.minX(), to.minX(), from.maxX(), to.maxX(), margin);
            float y = confined(circle[s + Y], from.minY(), to.minY(), from.maxY(), to.maxY(), margin);
            boolean movesX = x != circle[s + X];
            boolean movesY = y != circle[s + Y];
            boolean wakes = movesX || movesY || isAsleep(slot) && !isWithin(calm, s);
            if (movesX) {
                circle[s + X] = x;
                motion[s + DX] = 0f;
            }
            if (movesY) {
                circle[s + Y] = y;
                motion[s + DY] = 0f;
            }
            if (wakes && (slot >= awake || sleepers != null)) {
                int woken = wake(slot); // in the place of one that rests comes one that has been looked at
                if (sleepers != null) {
                    sleepers.restart(woken);
                }
            }
        }
    }

    private boolean isWithin(Bounds calm, int row) {
        float far = Sleep.NEIGHBOURS * circle[row + RADIUS];
        return circle[row + X] - far >= calm.minX()
                && circle[row + X] + far <= calm.maxX()
                && circle[row + Y] - far >= calm.minY()
                && circle[row + Y] + far <= calm.maxY();
    }

    private static float confined(float x, float fromMin, float min, float fromMax, float max, float margin) {
        float low = min + Walls.marginAtWall(fromMin, min, margin);
        return CircleMath.clamp(x, low, max - Walls.marginAtWall(fromMax, max, margin));
    }

    /** Saves circles from a slot on as those from k on. */
    public void save(int slot, SavedState into, int k, int count) {
        System.arraycopy(circle, CircleRow.of(slot), into.circle, CircleRow.of(k), CircleRow.of(count));
        System.arraycopy(motion, CircleRow.of(slot), into.motion, CircleRow.of(k), CircleRow.of(count));
        System.arraycopy(traits, CircleRow.of(slot), into.traits, CircleRow.of(k), CircleRow.of(count));
        if (turning != null) {
            turning.save(slot, into, k, count);
        }
        for (int c = 0; sleepers != null && c < count; c++) {
            sleepers.save(id[slot + c], into, k + c);
        }
    }

    /** Takes over saved circles, for which there is room, without cached impulses; slots are in the order of the ids. */
    public void load(SavedState from) {
        n = from.circles;
        System.arraycopy(from.circle, 0, circle, 0, CircleRow.of(n));
        System.arraycopy(from.motion, 0, motion, 0, CircleRow.of(n));
        System.arraycopy(from.traits, 0, traits, 0, CircleRow.of(n));
        System.arraycopy(from.id, 0, id, 0, n);
        Arrays.fill(firstCached, 0, n, -1);
        Arrays.fill(fresh, 0, n, false);
        fields.copy(from.fields);
        if (turning != null) {
            turning.load(from);
        }
        if (pieces != null) {
            pieces.load(from.pieceContacts, id, n);
        }
        Arrays.fill(slotOf, -1);
        for (int slot = 0; slot < n; slot++) {
            slotOf[id[slot]] = slot;
        }
        awake = n;
        resting.restart();
        drowsyCount = 0;
        if (allSleepers != null) {
            loadSleepers(from);
        }
    }

    private void loadSleepers(SavedState from) {
        allSleepers.load(from);
        if (from.parameters() != null) { // else all circles go, and the world stays as it is
            setArena(from.parameters().bounds());
            setSleeps(from.sleeps);
        }
        for (int slot = 0; slot < n; slot++) {
            if (allSleepers.isAsleep(id[slot])) {
                traits[CircleRow.of(slot) + INVERSE_MASS] = 0f;
                drowsy[drowsyCount++] = id[slot];
                allSleepers.count++;
            }
        }
    }

    /** Sets the arena of what follows. */
    public void setArena(Bounds next) {
        arena = next;
        wraps = next.wraps();
        periodX = next.periodX();
        periodY = next.periodY();
        images.set(periodX, periodY);
    }

    public long hash() {
        long sum = 0;
        for (int slot = 0; slot < n; slot++) {
            int s = CircleRow.of(slot);
            long h = StateHash.absorb(StateHash.circle(), id[slot]);
            for (int k = 0; k < CircleRow.STRIDE; k++) {
                h = StateHash.absorb(h, circle[s + k]);
            }
            for (int k = 0; k < CircleRow.STRIDE; k++) {
                h = StateHash.absorb(h, motion[s + k]);
            }
            for (int k = RESTITUTION; k < CircleRow.STRIDE; k++) {
                h = StateHash.absorb(h, traits[s + k]);
            }
            sum += h;
            if (turning != null) {
                sum += turning.hash(slot);
            }
            if (sleepers != null) {
                sum += sleepers.hash(id[slot]);
            }
        }
        return sum;
    }

    /**
     * Copies a range of slots into the spare arrays in a new order. {@link #swap} then makes them the state, if all slots have been
     * copied.
     */
    public void permute(int[] order, int from, int to) {
        for (int slot = from; slot < to; slot++) {
            int old = order[slot];
            System.arraycopy(circle, CircleRow.of(old), circleSpare, CircleRow.of(slot), CircleRow.STRIDE);
            System.arraycopy(motion, CircleRow.of(old), motionSpare, CircleRow.of(slot), CircleRow.STRIDE);
            System.arraycopy(traits, CircleRow.of(old), traitsSpare, CircleRow.of(slot), CircleRow.STRIDE);
            idSpare[slot] = id[old];
            firstCachedSpare[slot] = firstCached[old];
            freshSpare[slot] = fresh[old];
            if (turning != null) {
                turning.permute(old, slot);
            }
            if (pieces != null) {
                pieces.permute(old, slot);
            }
            slotOf[id[old]] = slot;
        }
    }

    /** Copies circles that rest, the first of which is 0, into the spare arrays. */
    public void copyResting(int first, int end) {
        copy(awake + first, awake + end, false);
    }

    /** Copies a range of slots from the spare arrays instead of {@link #swap}. */
    public void takeBack(int from, int to) {
        copy(from, to, true);
    }

    private void copy(int from, int to, boolean back) {
        int rows = CircleRow.of(to - from);
        copy(circle, circleSpare, CircleRow.of(from), rows, back);
        copy(motion, motionSpare, CircleRow.of(from), rows, back);
        copy(traits, traitsSpare, CircleRow.of(from), rows, back);
        copy(id, idSpare, from, to - from, back);
        copy(firstCached, firstCachedSpare, from, to - from, back);
        copy(fresh, freshSpare, from, to - from, back);
        if (turning != null) {
            turning.copy(from, to, back);
        }
        if (pieces != null) {
            pieces.copy(from, to, back);
        }
    }

    /** Copies a range of an array to its spare, or back. */
    static void copy(Object array, Object spare, int from, int many, boolean back) {
        System.arraycopy(back ? spare : array, from, back ? array : spare, from, many);
    }

    public void swap() {
        float[] f = circle;
        circle = circleSpare;
        circleSpare = f;
        f = motion;
        motion = motionSpare;
        motionSpare = f;
        f = traits;
        traits = traitsSpare;
        traitsSpare = f;
        int[] i = id;
        id = idSpare;
        idSpare = i;
        i = firstCached;
        firstCached = firstCachedSpare;
        firstCachedSpare = i;
        boolean[] b = fresh;
        fresh = freshSpare;
        freshSpare = b;
        if (turning != null) {
            turning.swap();
        }
        if (pieces != null) {
            pieces.swap();
        }
    }
}
