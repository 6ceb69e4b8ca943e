package io.github.circles2d.world.snapshots;

import io.github.circles2d.world.circles.BulkCopies;
import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.circles.Handle;
import io.github.circles2d.world.circles.StateHash;
import io.github.circles2d.world.circles.WorldParameters;
import io.github.circles2d.world.model.AxisEdge;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.Limits;
import java.nio.Buffer;
import java.nio.BufferOverflowException;
import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/**
 * Snapshots as bytes, little-endian: a header, a record of every id in use so far, in ascending order, the fields of circles that are
 * not the initial ones ({@link FieldSections}), what most worlds have not ({@link ParameterSections}), and the pairs that touch if events
 * are reported ({@link TouchSection}). Equal states have equal bytes, whatever they were computed on.
 *
 * <pre>
 * header     int magic, version, length of all in bytes, circles, ids, impulses;
 *            float bounds (4), gravity (2), restitution; int sub-steps, from bit 8
 *            on the edge of x, from bit 12 on that of y ({@link AxisEdge}); float length of the last step; int number of sections
 *            behind the records, 0 in snapshots of versions without them; long check
 * free id    byte flags; varint generation if it is not 0
 * circle     byte flags; float x, y, radius, mass, remainder x, y, velocity x, y; if the flags say so: varint generation,
 *            float restitution (else the world's), wall impulse x, wall impulse y; number of impulses in the flags, or 7 and
 *            a varint of those above 7; for each impulse, as the circle of lower id: varint of the higher id minus the one
 *            before (its own id at first), float impulse
 * </pre>
 *
 * <p>A circle takes 33 bytes and an impulse 6 to 9, so a circle of a settled pile, with about two contacts, takes at most 64.
 * Reading checks every value as {@link Limits} does. So every state that is read is one that calls could have led to: it is finite
 * and within the bounds, and every impulse belongs to two circles that exist.
 */
public final class SnapshotCodec {
    private static final int MAGIC = 0x57324443; // "CD2W" in the bytes of a file
    private static final int VERSION = 1;

    // Where some fields of the header begin.
    private static final int LENGTH_AT = 8;
    private static final int CIRCLES_AT = 12;
    private static final int SECTIONS_AT = 60;
    static final int CHECK_AT = 64;

    /** Bytes of the header. */
    public static final int HEADER = 72;

    // The int of the header that has the sub-steps, and the edges of each axis.
    private static final int SUB_STEPS_MASK = 0xFF;
    private static final int EDGE_X_SHIFT = 8;
    private static final int EDGE_Y_SHIFT = 12;
    private static final int EDGE_MASK = 0xF;
    private static final AxisEdge[] EDGES = AxisEdge.values();

    // Flags of a record; the number of impulses takes the bits above them.
    private static final int LIVES = 1;
    private static final int HAS_GENERATION = 2;
    private static final int HAS_RESTITUTION = 4;
    private static final int HAS_WALL_X = 8;
    private static final int HAS_WALL_Y = 16;
    private static final int IMPULSES_SHIFT = 5;

    /** The flags say this number if there are as many impulses or more. */
    private static final int MANY = 7;

    /** More bytes than an id has in most worlds. */
    private static final long USUAL = 80;

    private static final int MOST = Integer.MAX_VALUE - 8;

    // Fewest bytes of a record.
    private static final int LEAST_CIRCLE = 1 + 2 * CircleRow.STRIDE * Float.BYTES;
    private static final int LEAST_IMPULSE = 1 + Float.BYTES;

    private SnapshotCodec() {}

    // ---- writing

    /**
     * Writes a snapshot from position 0 on, and returns it, ready to be read: in the little-endian buffer, or in a longer one if that has too little
     * room. Its check is 0 until {@link #addCheck}. Throws {@link IllegalStateException} if it is more than a buffer holds.
     */
    public static ByteBuffer encode(SavedState s, ByteBuffer room) {
        ByteBuffer out = room;
        while (true) {
            try {
                ((Buffer) out).clear();
                write(s, out);
                ((Buffer) out).flip();
                return out;
            } catch (BufferOverflowException e) {
                if (out.capacity() == MOST) {
                    throw new IllegalStateException(
                            "a snapshot of more than " + MOST + " bytes is more than a buffer holds", e);
                }
                long more = Math.max(HEADER + USUAL * s.ids, out.capacity() * 3L / 2);
                out = ByteBuffer.allocate((int) Math.min(MOST, more)).order(ByteOrder.LITTLE_ENDIAN);
            }
        }
    }

    /** Completes a snapshot. */
    public static void addCheck(ByteBuffer snapshot) {
        snapshot.putLong(CHECK_AT, check(snapshot, snapshot.limit()));
    }

    private static void write(SavedState s, ByteBuffer out) {
        WorldParameters p = s.parameters();
        out.putInt(MAGIC)
                .putInt(VERSION)
                .putInt(0)
                .putInt(s.circles)
                .putInt(s.ids)
                .putInt(s.impulses);
        out.putFloat(p.bounds().minX()).putFloat(p.bounds().minY());
        out.putFloat(p.bounds().maxX()).putFloat(p.bounds().maxY());
        out.putFloat(p.gravityX()).putFloat(p.gravityY()).putFloat(p.restitution());
        out.putInt(packed(p.subSteps(), p.bounds())).putFloat(p.previousTimeStep());
        out.putInt(0).putLong(0);
        int circle = 0;
        int impulse = 0;
        for (int id = 0; id < s.ids; id++) {
            if (circle == s.circles || s.id[circle] != id) {
                out.put((byte) (s.generation[id] == 0 ? 0 : HAS_GENERATION));
                if (s.generation[id] != 0) {
                    Varint.put(out, s.generation[id]);
                }
                continue;
            }
            int end = impulse;
            while (end < s.impulses && s.lo[end] == id) {
                end++;
            }
            writeCircle(s, circle++, impulse, end, out);
            impulse = end;
        }
        int sections = FieldSections.write(s, out) + ParameterSections.write(s, out);
        out.putInt(SECTIONS_AT, sections + TouchSection.write(s.touches, out));
        out.putInt(LENGTH_AT, out.position());
    }

    private static int flags(SavedState s, int circle) {
        int row = CircleRow.STRIDE * circle;
        float worlds = s.parameters().restitution();
        return LIVES
                | (s.generation[s.id[circle]] != 0 ? HAS_GENERATION : 0)
                | (differ(s.traits[row + CircleRow.RESTITUTION], worlds) ? HAS_RESTITUTION : 0)
                | (differ(s.traits[row + CircleRow.WALL_X], 0f) ? HAS_WALL_X : 0)
                | (differ(s.traits[row + CircleRow.WALL_Y], 0f) ? HAS_WALL_Y : 0);
    }

    private static boolean differ(float a, float b) {
        return Float.floatToRawIntBits(a) != Float.floatToRawIntBits(b);
    }

    private static void writeCircle(SavedState s, int circle, int from, int end, ByteBuffer out) {
        int flags = flags(s, circle);
        int id = s.id[circle];
        out.put((byte) (flags | Math.min(end - from, MANY) << IMPULSES_SHIFT));
        int row = CircleRow.STRIDE * circle;
        for (int k = 0; k < CircleRow.STRIDE; k++) {
            out.putFloat(s.circle[row + k]);
        }
        for (int k = 0; k < CircleRow.STRIDE; k++) {
            out.putFloat(s.motion[row + k]);
        }
        if ((flags & HAS_GENERATION) != 0) {
            Varint.put(out, s.generation[id]);
        }
        if ((flags & HAS_RESTITUTION) != 0) {
            out.putFloat(s.traits[row + CircleRow.RESTITUTION]);
        }
        if ((flags & HAS_WALL_X) != 0) {
            out.putFloat(s.traits[row + CircleRow.WALL_X]);
        }
        if ((flags & HAS_WALL_Y) != 0) {
            out.putFloat(s.traits[row + CircleRow.WALL_Y]);
        }
        if (end - from >= MANY) {
            Varint.put(out, end - from - MANY);
        }
        int previous = id;
        for (int k = from; k < end; k++) {
            Varint.put(out, s.hi[k] - previous);
            previous = s.hi[k];
            out.putFloat(s.normalImpulse[k]);
        }
    }

    /** Mixes all bytes but those of the check itself. */
    static long check(ByteBuffer in, int length) {
        long h = MAGIC;
        int k = 0;
        for (; k + Integer.BYTES <= length; k += Integer.BYTES) {
            boolean ofCheck = k >= CHECK_AT && k < CHECK_AT + Long.BYTES;
            h = StateHash.absorb(h, ofCheck ? 0 : in.getInt(k));
        }
        for (; k < length; k++) {
            h = StateHash.absorb(h, in.get(k));
        }
        return StateHash.absorb(h, length);
    }

    // ---- reading

    /**
     * Reads a snapshot from the position on, which stays, checks all of it, and returns its length. Another thread may write to the
     * buffer. Throws {@link IllegalArgumentException} if it is no snapshot or a damaged one; the state then has no meaning.
     */
    public static int read(ByteBuffer from, SavedState s) {
        ByteBuffer in = copy(from.slice().order(ByteOrder.LITTLE_ENDIAN));
        int length = in.limit();
        require(in.getLong(CHECK_AT) == check(in, length), "it is damaged: its check does not fit");
        decode(in, s, null);
        checkPairs(s);
        TurnSections.checkImpulses(s);
        checkTargets(s);
        checkGrowth(s);
        TerrainSection.checkChains(s.terrain);
        JointSection.checkColours(s);
        JointSection.checkRigids(s);
        RigidSection.checkSleep(s);
        return length;
    }

    /** Reads a little-endian snapshot, from position 0 to the limit, without its check. Known parameters, or null, are not made again. */
    static void decode(ByteBuffer in, SavedState s, WorldParameters known) {
        try {
            decodeAll(in, s, known);
        } catch (BufferUnderflowException e) {
            throw refused("it ends early");
        }
    }

    private static void decodeAll(ByteBuffer in, SavedState s, WorldParameters known) {
        int length = in.limit();
        ((Buffer) in).position(CIRCLES_AT);
        int circles = in.getInt();
        int ids = in.getInt();
        int impulses = in.getInt();
        boolean fits = circles >= 0
                && ids >= circles
                && ids <= Limits.CIRCLES
                && impulses >= 0
                && ids + (LEAST_CIRCLE - 1L) * circles + (long) LEAST_IMPULSE * impulses <= length - HEADER;
        if (!fits) { // a message that is not needed would be garbage
            require(false, "it cannot hold " + circles + " circles, " + ids + " ids and " + impulses + " impulses");
        }
        s.setParameters(known == null ? readParameters(in) : known);
        int sections = in.getInt(SECTIONS_AT);
        s.setIds(ids);
        s.setCircles(circles);
        TurnSections.clear(s);
        s.setSleeps(false);
        s.ensureImpulses(impulses);
        s.impulses = 0;
        ((Buffer) in).position(HEADER);
        int circle = 0;
        for (int id = 0; id < ids; id++) {
            circle = readRecord(in, s, id, circle, circles, impulses);
        }
        require(circle == circles, "its records do not fit its header");
        FieldSections.read(in, s, sections);
        require(s.impulses == impulses && in.position() == length, "its records do not fit its header");
    }

    /** Copies a snapshot: what is checked in the copy still holds when it is used. */
    private static ByteBuffer copy(ByteBuffer from) {
        require(
                from.limit() >= HEADER,
                "it has no room for the header: " + from.limit()
                        + " bytes; a buffer must be flipped when a snapshot has been written into it");
        require(from.getInt() == MAGIC, "it does not begin as one");
        int version = from.getInt();
        if (version != VERSION) {
            throw later("its version is " + version + ", and this one reads version " + VERSION);
        }
        int length = from.getInt();
        require(
                length >= HEADER && length <= from.limit(),
                "its length is " + length + ", but there are " + from.limit() + " bytes");
        byte[] bytes = new byte[length];
        BulkCopies.get(from, bytes);
        return ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
    }

    private static WorldParameters readParameters(ByteBuffer in) {
        Bounds walled = Limits.bounds(in.getFloat(), in.getFloat(), in.getFloat(), in.getFloat());
        float gravityX = Limits.within("gravity x", in.getFloat(), -Limits.SPEED, Limits.SPEED);
        float gravityY = Limits.within("gravity y", in.getFloat(), -Limits.SPEED, Limits.SPEED);
        float restitution = Limits.restitution(in.getFloat());
        int packed = in.getInt();
        int subSteps = Limits.within("the number of sub-steps", packed & SUB_STEPS_MASK, 1, Limits.SUB_STEPS);
        Bounds bounds = Limits.edges(walled.with(edge(packed >> EDGE_X_SHIFT), edge(packed >> EDGE_Y_SHIFT)));
        require(packed == packed(subSteps, bounds), "its sub-steps and edges are none");
        float step = in.getFloat();
        if (step != 0) {
            Limits.within("the time step", step, Limits.LEAST_STEP, Limits.GREATEST_STEP);
        }
        return new WorldParameters(bounds, gravityX, gravityY, restitution, subSteps, step);
    }

    /** The sub-steps and the edges, which are 0 for walls, as one int of the header. */
    private static int packed(int subSteps, Bounds bounds) {
        return subSteps
                | bounds.edgeX().ordinal() << EDGE_X_SHIFT
                | bounds.edgeY().ordinal() << EDGE_Y_SHIFT;
    }

    private static AxisEdge edge(int bits) {
        return EDGES[Math.min(bits & EDGE_MASK, EDGES.length - 1)];
    }

    private static int readRecord(ByteBuffer in, SavedState s, int id, int circle, int circles, int impulses) {
        int flags = getByte(in);
        if ((flags & LIVES) == 0) {
            require((flags & ~HAS_GENERATION) == 0, "a free id has a circle's flags");
            s.generation[id] = getGeneration(in, (flags & HAS_GENERATION) != 0);
            return circle;
        }
        require(circle < circles, "there are more circles than it says");
        s.id[circle] = id;
        int row = CircleRow.STRIDE * circle;
        for (int k = 0; k < CircleRow.STRIDE; k++) {
            s.circle[row + k] = in.getFloat();
        }
        for (int k = 0; k < CircleRow.STRIDE; k++) {
            s.motion[row + k] = in.getFloat();
        }
        s.generation[id] = getGeneration(in, (flags & HAS_GENERATION) != 0);
        float worlds = s.parameters().restitution();
        s.traits[row + CircleRow.INVERSE_MASS] = CircleMath.inverseMass(s.circle[row + CircleRow.MASS]);
        s.traits[row + CircleRow.RESTITUTION] = (flags & HAS_RESTITUTION) != 0 ? in.getFloat() : worlds;
        s.traits[row + CircleRow.WALL_X] = (flags & HAS_WALL_X) != 0 ? in.getFloat() : 0f;
        s.traits[row + CircleRow.WALL_Y] = (flags & HAS_WALL_Y) != 0 ? in.getFloat() : 0f;
        checkCircle(s, row);
        readImpulses(in, s, id, flags >> IMPULSES_SHIFT, impulses);
        return circle + 1;
    }

    private static void readImpulses(ByteBuffer in, SavedState s, int id, int inFlags, int impulses) {
        long count = inFlags < MANY ? inFlags : MANY + (Integer.toUnsignedLong(Varint.get(in)));
        require(count <= impulses - s.impulses, "there are more impulses than it says");
        long hi = id;
        for (long k = 0; k < count; k++) {
            long more = Integer.toUnsignedLong(Varint.get(in));
            hi += more;
            require(more > 0 && hi < s.ids, "an impulse has no second circle");
            float normalImpulse = in.getFloat();
            require(normalImpulse >= 0 && normalImpulse <= Limits.CACHED_IMPULSE, "an impulse is out of range");
            s.lo[s.impulses] = id;
            s.hi[s.impulses] = (int) hi;
            s.normalImpulse[s.impulses++] = normalImpulse;
        }
    }

    private static void checkCircle(SavedState s, int row) {
        Bounds bounds = s.parameters().bounds();
        float x = s.circle[row + CircleRow.X];
        float y = s.circle[row + CircleRow.Y];
        Limits.place(x, y, bounds);
        Limits.radius(s.circle[row + CircleRow.RADIUS], bounds);
        Limits.mass(s.circle[row + CircleRow.MASS]);
        checkRemainder(x, s.motion[row + CircleRow.DX]);
        checkRemainder(y, s.motion[row + CircleRow.DY]);
        Limits.velocity(s.motion[row + CircleRow.VX], s.motion[row + CircleRow.VY]);
        Limits.restitution(s.traits[row + CircleRow.RESTITUTION]);
        checkWallImpulse(s.traits[row + CircleRow.WALL_X]);
        checkWallImpulse(s.traits[row + CircleRow.WALL_Y]);
    }

    private static void checkWallImpulse(float speed) {
        Limits.within("a wall's impulse", speed, -Limits.WALL_IMPULSE, Limits.WALL_IMPULSE);
    }

    /** What rounding has left of a coordinate is at most half a unit of its last place. */
    static void checkRemainder(float coordinate, float remainder) {
        float most = 0.5f * Math.ulp(coordinate);
        Limits.within("a remainder", remainder, -most, most);
    }

    /** Every impulse belongs to two circles that are there. */
    private static void checkPairs(SavedState s) {
        boolean[] lives = new boolean[s.ids];
        for (int k = 0; k < s.circles; k++) {
            lives[s.id[k]] = true;
        }
        for (int k = 0; k < s.impulses; k++) {
            require(lives[s.hi[k]], "an impulse has no second circle");
        }
    }

    /** Only static circles travel, and only to places within the bounds. */
    private static void checkTargets(SavedState s) {
        for (int k = 0; k < s.circles; k++) {
            long target = s.fields.get(CircleField.TARGET, s.id[k]);
            if (target != CircleField.TARGET.initial()) {
                require(
                        s.traits[CircleRow.STRIDE * k + CircleRow.INVERSE_MASS] == 0,
                        "a circle travels that is not static");
                Limits.place(
                        CircleField.placeX(target),
                        CircleField.placeY(target),
                        s.parameters().bounds());
            }
        }
    }

    /** Circles grow to radii that are allowed, in a number of steps that is. */
    private static void checkGrowth(SavedState s) {
        for (int id = 0; id < s.fields.end(CircleField.GROWTH); id++) {
            long growth = s.fields.get(CircleField.GROWTH, id);
            if (growth != CircleField.GROWTH.initial()) {
                Limits.growth(
                        CircleField.growthRadius(growth),
                        CircleField.growthSteps(growth),
                        s.parameters().bounds());
            }
        }
    }

    /** A generation that is 0 unless it is there. */
    static int getGeneration(ByteBuffer in, boolean has) {
        if (!has) {
            return 0;
        }
        int generation = Varint.get(in);
        require(generation != 0 && generation != Handle.LAST_GENERATION + 1, "a generation is out of range");
        return generation;
    }

    static int getByte(ByteBuffer in) {
        return Byte.toUnsignedInt(in.get());
    }

    static void require(boolean holds, String message) {
        if (!holds) {
            throw refused(message);
        }
    }

    static IllegalArgumentException later(String what) {
        return new IllegalArgumentException("this snapshot is from a later version of circles2d, or damaged: " + what);
    }

    /** For a message that is put together: to do so where nothing is refused would be garbage of each read. */
    static IllegalArgumentException refused(String message) {
        return new IllegalArgumentException("this is no snapshot of a world: " + message);
    }
}
