package io.github.circles2d.world.snapshots;

import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.ContactRows;
import io.github.circles2d.world.model.Limits;
import java.nio.ByteBuffer;
import java.util.Arrays;

/**
 * What circles turn by in a snapshot: two sections of {@link ParameterSections}, if there is something. A state in which nothing has turned
 * has none, whether or not a pipeline is ready for it. Zeros are left out, by their bits.
 *
 * <pre>
 * section    of circles: int number of circles that have something; for each, ascending: varint of the id minus the one before (-1 at
 *            first), byte flags; for each flag from bit 0 on: int angle, float angular velocity, floats of walls by {@link ContactRows}
 *            of impulses: int number of impulses that have something; for each, ascending: varint of the number of the impulse minus the
 *            one before (-1 at first), with a bit behind it for each row that is its flag; for each flag: float impulse of the row
 * </pre>
 */
final class TurnSections {

    private static final int HAS_ANGLE = 1;
    private static final int HAS_VELOCITY = 2;
    private static final int WALL_SHIFT = 2;
    private static final int CIRCLE_FLAGS = (1 << WALL_SHIFT + ContactRows.OF_WALLS) - 1;
    private static final int LEAST_CIRCLE = 2 + Float.BYTES;

    private static final int ROW_BITS = ContactRows.COUNT;
    private static final int ROW_FLAGS = (1 << ROW_BITS) - 1;
    private static final int LEAST_IMPULSE = 1 + Float.BYTES;

    private TurnSections() {}

    // ---- writing

    /** Circles that have something. */
    static int circles(SavedState s) {
        int count = 0;
        for (int k = 0; s.turns && k < s.circles; k++) {
            count += flagsOfCircle(s, k) == 0 ? 0 : 1;
        }
        return count;
    }

    /** Impulses that have something. */
    static int impulses(SavedState s) {
        int count = 0;
        for (int k = 0; s.turns && k < s.impulses; k++) {
            count += flagsOfImpulse(s, k) == 0 ? 0 : 1;
        }
        return count;
    }

    private static int flagsOfCircle(SavedState s, int k) {
        int flags = (s.angle[k] == 0 ? 0 : HAS_ANGLE) | (isZero(s.angularVelocity[k]) ? 0 : HAS_VELOCITY);
        for (int wall = 0; wall < ContactRows.OF_WALLS; wall++) {
            flags |= isZero(s.wallRows[ContactRows.ofWalls(k) + wall]) ? 0 : 1 << WALL_SHIFT + wall;
        }
        return flags;
    }

    private static int flagsOfImpulse(SavedState s, int k) {
        int flags = 0;
        for (int row = 0; row < ContactRows.COUNT; row++) {
            flags |= isZero(s.rows[ContactRows.of(k) + row]) ? 0 : 1 << row;
        }
        return flags;
    }

    private static boolean isZero(float value) {
        return Float.floatToRawIntBits(value) == 0;
    }

    private static int key(int more, int flags) {
        return more << ROW_BITS | flags;
    }

    /** Writes the section of circles behind its number. */
    static void writeCircles(SavedState s, ByteBuffer out) {
        out.putInt(circles(s));
        int previous = -1;
        for (int k = 0; k < s.circles; k++) {
            int flags = flagsOfCircle(s, k);
            if (flags != 0) {
                Varint.put(out, s.id[k] - previous);
                previous = s.id[k];
                out.put((byte) flags);
                if ((flags & HAS_ANGLE) != 0) {
                    out.putInt(s.angle[k]);
                }
                if ((flags & HAS_VELOCITY) != 0) {
                    out.putFloat(s.angularVelocity[k]);
                }
                for (int wall = 0; wall < ContactRows.OF_WALLS; wall++) {
                    if ((flags >> WALL_SHIFT + wall & 1) != 0) {
                        out.putFloat(s.wallRows[ContactRows.ofWalls(k) + wall]);
                    }
                }
            }
        }
    }

    /** Writes the section of impulses behind its number. */
    static void writeImpulses(SavedState s, ByteBuffer out) {
        out.putInt(impulses(s));
        int previous = -1;
        for (int k = 0; k < s.impulses; k++) {
            int flags = flagsOfImpulse(s, k);
            if (flags != 0) {
                Varint.put(out, key(k - previous, flags));
                previous = k;
                for (int row = 0; row < ContactRows.COUNT; row++) {
                    if ((flags >> row & 1) != 0) {
                        out.putFloat(s.rows[ContactRows.of(k) + row]);
                    }
                }
            }
        }
    }

    // ---- reading

    /** Nothing turns, until a section says so. */
    static void clear(SavedState s) {
        s.setTurns(false);
    }

    private static void begin(SavedState s) {
        if (!s.turns) {
            s.setTurns(true);
            s.ensureImpulses(s.impulses);
            Arrays.fill(s.angle, 0, s.circles, 0);
            Arrays.fill(s.angularVelocity, 0, s.circles, 0f);
            Arrays.fill(s.wallRows, 0, ContactRows.ofWalls(s.circles), 0f);
            Arrays.fill(s.rows, 0, ContactRows.of(s.impulses), 0f);
        }
    }

    /** Reads the section of circles behind its number, and checks it; circles and impulses have been read. */
    static void readCircles(ByteBuffer in, SavedState s) {
        int count = count(in, s.circles, LEAST_CIRCLE);
        begin(s);
        long id = -1;
        int circle = 0;
        for (int k = 0; k < count; k++) {
            long more = Integer.toUnsignedLong(Varint.get(in));
            id += more;
            while (circle < s.circles && s.id[circle] < id) {
                circle++;
            }
            SnapshotCodec.require(more > 0 && circle < s.circles && s.id[circle] == id, "what turns has no circle");
            int flags = SnapshotCodec.getByte(in);
            SnapshotCodec.require(flags != 0 && flags <= CIRCLE_FLAGS, "a circle that turns has no such flags");
            if ((flags & HAS_ANGLE) != 0) {
                s.angle[circle] = in.getInt();
                SnapshotCodec.require(s.angle[circle] != 0, "it has an angle of 0");
            }
            if ((flags & HAS_VELOCITY) != 0) {
                s.angularVelocity[circle] = within("an angular velocity", value(in), Limits.ANGULAR_VELOCITY);
            }
            for (int wall = 0; wall < ContactRows.OF_WALLS; wall++) {
                if ((flags >> WALL_SHIFT + wall & 1) != 0) {
                    s.wallRows[ContactRows.ofWalls(circle) + wall] =
                            within("an impulse along a wall", value(in), Limits.WALL_IMPULSE);
                }
            }
        }
    }

    /** The same of impulses, whose ranges {@link #checkImpulses} checks. */
    static void readImpulses(ByteBuffer in, SavedState s) {
        int count = count(in, s.impulses, LEAST_IMPULSE);
        begin(s);
        long impulse = -1;
        for (int k = 0; k < count; k++) {
            long key = Integer.toUnsignedLong(Varint.get(in));
            long more = key >> ROW_BITS;
            int flags = (int) key & ROW_FLAGS;
            impulse += more;
            SnapshotCodec.require(more > 0 && impulse < s.impulses && flags != 0, "rows have no impulse");
            for (int row = 0; row < ContactRows.COUNT; row++) {
                if ((flags >> row & 1) != 0) {
                    s.rows[ContactRows.of((int) impulse) + row] = value(in);
                }
            }
        }
    }

    private static int count(ByteBuffer in, int most, int least) {
        int count = in.getInt();
        if (!(count > 0 && count <= most && (long) count * least <= in.remaining())) {
            throw SnapshotCodec.refused("it cannot hold " + count + " values of what turns");
        }
        return count;
    }

    private static float value(ByteBuffer in) {
        float value = in.getFloat();
        SnapshotCodec.require(!isZero(value), "it has a 0 of what turns");
        return value;
    }

    private static float within(String what, float value, float most) {
        return Limits.within(what, value, -most, most);
    }

    /** Their ranges depend on the radii of their circles. All impulses belong to two circles that are there, whose contact acts. */
    static void checkImpulses(SavedState s) {
        for (int k = 0; k < s.impulses; k++) {
            float acting = s.turns
                    ? ContactRows.actingImpulse(s.normalImpulse[k], s.rows, ContactRows.of(k), 1)
                    : s.normalImpulse[k];
            SnapshotCodec.require(acting > 0f, "an impulse is out of range");
            if (s.turns && flagsOfImpulse(s, k) != 0) {
                float r = Math.min(radius(s, s.lo[k]), radius(s, s.hi[k]));
                for (int row = 0; row < ContactRows.COUNT; row++) {
                    ContactRows.check(row, s.rows[ContactRows.of(k) + row], r);
                }
            }
        }
    }

    private static float radius(SavedState s, int id) {
        return s.circle[CircleRow.of(Arrays.binarySearch(s.id, 0, s.circles, id)) + CircleRow.RADIUS];
    }
}
