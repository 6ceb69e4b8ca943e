package io.github.circles2d.world.circles;

import io.github.circles2d.world.model.AxisEdge;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.ContactRows;
import io.github.circles2d.world.model.ContactSettings;
import io.github.circles2d.world.model.JointState;
import io.github.circles2d.world.model.KindField;
import io.github.circles2d.world.model.SurfaceSettings;

/**
 * The 64-bit hash of a state: the sum of one mixed number per circle, one per entry of the impulse cache, one per field of a
 * circle ({@link CircleField}) or of a kind ({@link KindField}) that has not its initial value, one per pair of kinds whose response
 * is set, one for the walls if the next step moves them, one per circle that comes to rest, one for {@link ContactSettings} and one for
 * {@link SurfaceSettings} if they are not the default, and one per circle and per impulse that has what circles turn by. A sum of
 * integers does not depend on its order, so every back end can form it in parallel. It depends on ids and not on slots.
 *
 * <p>A circle enters with its id, x, y, radius, mass, the remainders of x and y, vx, vy, restitution, and the wall impulses x and y; an
 * impulse with the lower id, the higher id and itself; a field with its number, the id, and the lower and the upper half of its value; a
 * field of a kind with its number, the kind and its value; a pair of kinds with the lesser one, the greater one and 1 for solid, 2 for
 * ignored, 3 for sensed; walls with where they start: min x, min y, max x, max y; edges, if not all are walls, with those of x and y
 * ({@link AxisEdge}) and the bounds; settings with their numbers in order; a circle that turns with its id, angle, angular velocity and the
 * impulses of its walls by {@link ContactRows}; an impulse whose contact has other rows with the lower id, the higher id and theirs, of rows behind
 * rolling only those that are not 0, with their places; a joint with its id, form, colour, circles, body, reference angles, its saved values and
 * its row of {@link JointState}; a rigid body with its id, kind, saved values and the words of its outline; a contact of one with its key and its
 * impulses. All floats enter as their bits.
 */
public final class StateHash {
    private static final long CIRCLE = 0x636972636C653264L;
    private static final long IMPULSE = 0x696D70756C736573L;
    private static final long FIELD = 0x666965E5C2D1F01DL;
    private static final long KIND = 0x6B696E64A5C3D21FL;
    private static final long RESPONSE = 0x726573706F6E7365L;
    private static final long WALLS = 0x77616C6C73746172L;
    private static final long CONTACTS = 0x636F6E7461637473L;
    private static final long EDGES = 0x6564676573324432L;
    private static final long SURFACES = 0x7375726661636573L;
    private static final long TURN = 0x7475726E696E6721L;
    private static final long ROWS = 0x6772697065332121L;
    private static final long PIECE = 0x7069656365733264L;
    private static final long BODY = 0x626F646965733264L;
    private static final long PIECE_CONTACT = 0x6F6E7069656365L;
    private static final long SLEEP = 0x736C656570696E67L;
    private static final long JOINT = 0x6A6F696E74733264L;
    private static final long RIGID = 0x7269676964733264L;
    private static final long RIGID_CONTACT = 0x7269676964746F75L;
    private static final long MULTIPLIER = 0x9E3779B97F4A7C15L;

    /** Number of the first rows, whose impulses every term of rows has, also if they are 0. */
    private static final int FIRST_ROWS = ContactRows.ROLLING + 1;

    private StateHash() {}

    public static long circle() {
        return CIRCLE;
    }

    public static long impulse() {
        return IMPULSE;
    }

    /** The number of a field's value. */
    static long field(int number, int id, long value) {
        long h = absorb(absorb(FIELD, number), id);
        return absorb(absorb(h, (int) value), (int) (value >> Integer.SIZE));
    }

    /** The number of a field's value of a kind. */
    static long kind(int number, int kind, int value) {
        return absorb(absorb(absorb(KIND, number), kind), value);
    }

    /** The number of a pair of kinds. */
    static long response(int a, int b, int setting) {
        return absorb(absorb(absorb(RESPONSE, a), b), setting);
    }

    /** The number of walls that start somewhere else than they are. */
    static long walls(Bounds start) {
        long h = absorb(absorb(WALLS, start.minX()), start.minY());
        return absorb(absorb(h, start.maxX()), start.maxY());
    }

    /** The number of bounds of which some edge is no wall. */
    static long edges(Bounds b) {
        long h = absorb(absorb(EDGES, b.edgeX().ordinal()), b.edgeY().ordinal());
        return absorb(absorb(absorb(absorb(h, b.minX()), b.minY()), b.maxX()), b.maxY());
    }

    /** The number of settings of contacts. */
    static long contacts(ContactSettings s) {
        long h = absorb(absorb(CONTACTS, s.restitutionThreshold()), s.frequency());
        return absorb(absorb(h, s.damping()), s.pushOutSpeed());
    }

    /** The number of surfaces that grip. */
    static long surfaces(SurfaceSettings s) {
        long h = SURFACES;
        for (int k = 0; k < SurfaceSettings.VALUES; k++) {
            h = absorb(h, s.value(k));
        }
        return h;
    }

    /** The number of a circle that turns; 0 if it has not turned. */
    public static long turn(int id, int angle, float angularVelocity, float[] wallRows, int from) {
        int any = angle | Float.floatToRawIntBits(angularVelocity);
        long h = absorb(absorb(absorb(TURN, id), angle), angularVelocity);
        any |= bits(wallRows, from, ContactRows.OF_WALLS);
        return any == 0 ? 0 : absorbRows(h, wallRows, from, ContactRows.OF_WALLS, ContactRows.OF_WALL * FIRST_ROWS);
    }

    /** The number of the impulses of a contact's rows, from a place on; 0 if all are. */
    public static long rows(int lower, int higher, float[] impulses, int at) {
        long h = absorb(absorb(ROWS, lower), higher);
        return bits(impulses, at, ContactRows.COUNT) == 0
                ? 0
                : absorbRows(h, impulses, at, ContactRows.COUNT, FIRST_ROWS);
    }

    private static int bits(float[] impulses, int from, int count) {
        int bits = 0;
        for (int k = from; k < from + count; k++) {
            bits |= Float.floatToRawIntBits(impulses[k]);
        }
        return bits;
    }

    /**
     * Absorbs the impulses of rows. Those behind the first rows are absorbed with their place, and only if they are not 0: so a row that is
     * added changes the hash of no world that does not use it.
     */
    static long absorbRows(long hash, float[] impulses, int from, int count, int ofFirstRows) {
        long h = hash;
        for (int k = 0; k < count; k++) {
            float impulse = impulses[from + k];
            if (k < ofFirstRows) {
                h = absorb(h, impulse);
            } else if (Float.floatToRawIntBits(impulse) != 0) {
                h = absorb(absorb(h, k), impulse);
            }
        }
        return h;
    }

    /** The number of how a circle comes to rest; 0 if it moves. */
    public static long rest(int id, int rest, float driftX, float driftY, int turned) {
        int any = rest | turned | Float.floatToRawIntBits(driftX) | Float.floatToRawIntBits(driftY);
        long h = absorb(absorb(absorb(absorb(SLEEP, id), rest), driftX), driftY);
        return any == 0 ? 0 : absorb(h, turned);
    }

    /** What the number of a piece of terrain begins with. */
    public static long piece() {
        return PIECE;
    }

    /** What the number of a body of terrain begins with. */
    public static long body() {
        return BODY;
    }

    /** The number of a contact of a circle with a piece of terrain; its rows have the impulses from a place on. */
    public static long pieceContact(int circle, int piece, int side, float impulse, float[] rows, int at) {
        long h = absorb(absorb(absorb(absorb(PIECE_CONTACT, circle), piece), side), impulse);
        return absorbRows(h, rows, at, ContactRows.COUNT, FIRST_ROWS);
    }

    /** What the number of a joint begins with. */
    public static long joint() {
        return JOINT;
    }

    /** What the number of a rigid body begins with. */
    public static long rigid() {
        return RIGID;
    }

    /** What the number of a contact of a rigid body begins with. */
    public static long rigidContact() {
        return RIGID_CONTACT;
    }

    public static long absorb(long hash, int word) {
        long h = (hash ^ (word & 0xFFFFFFFFL)) * MULTIPLIER;
        return h ^ (h >>> 32);
    }

    public static long absorb(long hash, float value) {
        return absorb(hash, Float.floatToRawIntBits(value));
    }
}
