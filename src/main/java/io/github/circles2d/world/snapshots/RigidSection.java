package io.github.circles2d.world.snapshots;

import io.github.circles2d.world.bodies.KeptContacts;
import io.github.circles2d.world.bodies.OutlineShape;
import io.github.circles2d.world.bodies.RigidExtras;
import io.github.circles2d.world.bodies.RigidLimits;
import io.github.circles2d.world.bodies.RigidStep;
import io.github.circles2d.world.bodies.SavedRigids;
import io.github.circles2d.world.circles.KindTable;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.model.Sleep;
import io.github.circles2d.world.model.WallMotion;
import java.nio.Buffer;
import java.nio.ByteBuffer;
import java.util.Arrays;

/**
 * Rigid bodies in a snapshot: a section of {@link ParameterSections}, if there is or has been one.
 *
 * <pre>
 * section    int ids of bodies; int outlines, in the order of the first bodies that have them; for each: varint number of its words, int each;
 *            for each id: byte flags; if the flags say so: varint generation; of a body: varint outline, byte kind, varint with a bit for each value
 *            of {@link SavedRigids} that is not 0, int each of these;
 *            int contacts; for each, in ascending order: byte type, varint body, varint what it touches, int each of the rest of its key, float each
 *            of its impulses;
 *            int pairs that touched in the last step, if that is reported; for each likewise: byte type, perhaps with that of what is sensed,
 *            varint body, varint what it touched
 * </pre>
 */
final class RigidSection {
    // flags
    private static final int LIVES = 1;
    private static final int HAS_GENERATION = 2;

    /** Flags, outline, kind, values. */
    private static final int LEAST_BODY = 4;

    private static final int REST_OF_KEY = KeptContacts.KEYS - RigidStep.TOUCH_KEYS;
    private static final int LEAST_CONTACT = 3 + Integer.BYTES * (REST_OF_KEY + KeptContacts.IMPULSES);

    private RigidSection() {}

    // ---- writing

    /** A bit for each value that is not 0. */
    private static int values(SavedRigids r, int body) {
        int bits = 0;
        for (int k = 0; k < SavedRigids.VALUES; k++) {
            bits |= r.values[SavedRigids.VALUES * body + k] == 0 ? 0 : 1 << k;
        }
        return bits;
    }

    /** Writes the section behind its number. */
    static void write(SavedRigids r, ByteBuffer out) {
        out.putInt(r.ids).putInt(r.outlineCount);
        for (int k = 0; k < r.outlineCount; k++) {
            int[] words = r.outlines[k].words();
            Varint.put(out, words.length);
            for (int word : words) {
                out.putInt(word);
            }
        }
        for (int body = 0; body < r.ids; body++) {
            int generation = r.generation[body];
            out.put((byte) ((r.lives(body) ? LIVES : 0) | (generation == 0 ? 0 : HAS_GENERATION)));
            if (generation != 0) {
                Varint.put(out, generation);
            }
            if (r.lives(body)) {
                writeBody(r, body, out);
            }
        }
        KeptContacts contacts = r.contacts;
        out.putInt(contacts.count);
        for (int k = 0; k < contacts.count; k++) {
            writePair(contacts.keys, KeptContacts.KEYS * k, out);
            out.putInt(contacts.formAndFeature(k)).putInt(contacts.featureOfB(k));
            out.putFloat(contacts.impulse(k)).putFloat(contacts.grip(k));
        }
        out.putInt(r.touching);
        for (int k = 0; k < r.touching; k++) {
            writePair(r.touchingKeys, RigidStep.TOUCH_KEYS * k, out);
        }
    }

    private static void writeBody(SavedRigids r, int body, ByteBuffer out) {
        Varint.put(out, r.outline[body]);
        out.put((byte) r.kind[body]);
        int values = values(r, body);
        Varint.put(out, values);
        for (int k = 0; k < SavedRigids.VALUES; k++) {
            if ((values & 1 << k) != 0) {
                out.putInt(r.values[SavedRigids.VALUES * body + k]);
            }
        }
    }

    private static void writePair(int[] keys, int at, ByteBuffer out) {
        out.put((byte) keys[at + RigidStep.TYPE]);
        Varint.put(out, keys[at + RigidStep.A]);
        Varint.put(out, keys[at + RigidStep.B]);
    }

    // ---- reading

    /** Reads the section behind its number, and checks it. */
    static void read(ByteBuffer in, SavedState s) {
        SavedRigids r = s.rigids;
        int ids = getInt(in);
        int outlines = getInt(in);
        if (!(ids > 0 && ids <= RigidLimits.MOST && ids <= in.remaining() && outlines >= 0 && outlines <= ids)) {
            throw SnapshotCodec.refused("it cannot hold " + ids + " ids of bodies and " + outlines + " outlines");
        }
        r.setIds(ids);
        r.ensureOutlines(outlines);
        for (r.outlineCount = 0; r.outlineCount < outlines; r.outlineCount++) {
            readOutline(in, s);
        }
        int next = 0;
        for (int body = 0; body < ids; body++) {
            next = readId(in, s, body, next);
        }
        SnapshotCodec.require(next == outlines, "no body has an outline");
        readContacts(in, s);
        readTouching(in, s);
    }

    private static int getInt(ByteBuffer in) {
        SnapshotCodec.require(in.remaining() >= Integer.BYTES, "it ends early");
        return in.getInt();
    }

    /** Takes an equal outline that is there already: another one would be garbage of each frame. */
    private static void readOutline(ByteBuffer in, SavedState s) {
        SavedRigids r = s.rigids;
        int count = Varint.get(in);
        SnapshotCodec.require(
                count > 0 && count <= OutlineShape.MOST_WORDS && count <= in.remaining() / Integer.BYTES,
                "an outline has no words, or too many");
        int at = in.position();
        OutlineShape known = null;
        for (int k = r.outlineCount; known == null && k < r.outlines.length; k++) {
            if (r.outlines[k] != null && isSame(in, at, count, r.outlines[k].words())) {
                known = r.outlines[k];
                r.outlines[k] = r.outlines[r.outlineCount];
            }
        }
        if (known == null) {
            known = newOutline(in, at, count);
        }
        for (int k = 0; k < r.outlineCount; k++) {
            SnapshotCodec.require(!isSame(in, at, count, r.outlines[k].words()), "two outlines are one");
        }
        RigidLimits.reach(known, s.parameters().bounds());
        r.outlines[r.outlineCount] = known;
        ((Buffer) in).position(at + Integer.BYTES * count);
    }

    private static boolean isSame(ByteBuffer in, int at, int count, int[] words) {
        boolean same = words.length == count;
        for (int k = 0; same && k < count; k++) {
            same = in.getInt(at + Integer.BYTES * k) == words[k];
        }
        return same;
    }

    private static OutlineShape newOutline(ByteBuffer in, int at, int count) {
        int[] words = new int[count];
        for (int k = 0; k < count; k++) {
            words[k] = in.getInt(at + Integer.BYTES * k);
        }
        return OutlineShape.of(words);
    }

    /** Returns how many outlines bodies so far have. */
    private static int readId(ByteBuffer in, SavedState s, int body, int outlines) {
        SavedRigids r = s.rigids;
        int flags = SnapshotCodec.getByte(in);
        SnapshotCodec.require((flags & ~(LIVES | HAS_GENERATION)) == 0, "a body has unknown flags");
        r.generation[body] = SnapshotCodec.getGeneration(in, (flags & HAS_GENERATION) != 0);
        r.outline[body] = SavedRigids.NO_BODY;
        if ((flags & LIVES) == 0) {
            return outlines;
        }
        SnapshotCodec.require(in.remaining() >= LEAST_BODY - 1, "it ends within a body");
        int outline = Varint.get(in);
        SnapshotCodec.require(outline >= 0 && outline <= outlines && outline < r.outlineCount, "a body has no outline");
        r.outline[body] = outline;
        r.kind[body] = KindTable.check(SnapshotCodec.getByte(in));
        int values = Varint.get(in);
        SnapshotCodec.require(values >>> SavedRigids.VALUES == 0, "a body has unknown values");
        SnapshotCodec.require(in.remaining() >= Integer.BYTES * Integer.bitCount(values), "it ends within a body");
        for (int k = 0; k < SavedRigids.VALUES; k++) {
            boolean has = (values & 1 << k) != 0;
            int value = has ? in.getInt() : 0;
            SnapshotCodec.require(!has || value != 0, "it has a 0 of a body");
            r.values[SavedRigids.VALUES * body + k] = value;
        }
        check(r, body, s.parameters().bounds());
        return Math.max(outlines, outline + 1);
    }

    private static void check(SavedRigids r, int body, Bounds bounds) {
        float x = r.real(body, SavedRigids.X);
        float y = r.real(body, SavedRigids.Y);
        Limits.place(x, y, bounds);
        SnapshotCodec.checkRemainder(x, r.real(body, SavedRigids.REST_X));
        SnapshotCodec.checkRemainder(y, r.real(body, SavedRigids.REST_Y));
        Limits.velocity(r.real(body, SavedRigids.VX), r.real(body, SavedRigids.VY));
        Limits.within(
                "the angular velocity",
                r.real(body, SavedRigids.OMEGA),
                -Limits.ANGULAR_VELOCITY,
                Limits.ANGULAR_VELOCITY);
        RigidLimits.mass(r.real(body, SavedRigids.MASS));
        RigidLimits.inertia(
                r.real(body, SavedRigids.INERTIA), r.real(body, SavedRigids.MASS), r.outlines[r.outline[body]]);
        Limits.restitution(r.real(body, SavedRigids.RESTITUTION));
        Limits.force(r.real(body, SavedRigids.FORCE_X), r.real(body, SavedRigids.FORCE_Y));
        Limits.within("torque", r.real(body, SavedRigids.TORQUE), -Limits.TORQUE, Limits.TORQUE);
        Limits.force(
                r.real(body, SavedRigids.EXTRAS + RigidExtras.FORCE_X),
                r.real(body, SavedRigids.EXTRAS + RigidExtras.FORCE_Y));
        Limits.within("torque", r.real(body, SavedRigids.EXTRAS + RigidExtras.TORQUE), -Limits.TORQUE, Limits.TORQUE);
    }

    /** Checks how bodies sleep. It is known whether they do. */
    static void checkSleep(SavedState s) {
        SavedRigids r = s.rigids;
        for (int body = 0; body < r.ids; body++) {
            if (r.lives(body)) {
                checkSleep(r, body, s.parameters().sleeps());
            }
        }
    }

    private static void checkSleep(SavedRigids r, int body, boolean sleeps) {
        int first = SavedRigids.VALUES * body + SavedRigids.EXTRAS;
        int bits = 0;
        for (int k = RigidExtras.REST; k <= RigidExtras.SPIN_OFFSET; k++) {
            bits |= r.values[first + k];
        }
        int rest = r.values[first + RigidExtras.REST];
        SnapshotCodec.require(bits == 0 || sleeps && rest != 0, "a body comes to rest that never does");
        if (bits == 0) {
            return;
        }
        boolean asleep = Sleep.isAsleep(rest);
        float most = asleep ? Float.MAX_VALUE : Limits.COORDINATE;
        Limits.within("a drift of a body", r.real(body, SavedRigids.EXTRAS + RigidExtras.DRIFT_X), -most, most);
        Limits.within("a drift of a body", r.real(body, SavedRigids.EXTRAS + RigidExtras.DRIFT_Y), -most, most);
        Limits.within(
                "a known angular acceleration",
                r.real(body, SavedRigids.EXTRAS + RigidExtras.KNOWN_SPIN),
                -Float.MAX_VALUE,
                Float.MAX_VALUE);
        int spinOffset = r.values[first + RigidExtras.SPIN_OFFSET];
        int moves = r.values[SavedRigids.VALUES * body + SavedRigids.VX]
                | r.values[SavedRigids.VALUES * body + SavedRigids.VY]
                | r.values[SavedRigids.VALUES * body + SavedRigids.OMEGA];
        SnapshotCodec.require(!asleep || moves == 0, "a body sleeps that moves");
        SnapshotCodec.require(
                asleep
                        ? SleepSection.isOffset(r.values[first + RigidExtras.TURNED])
                                && Math.abs((long) spinOffset) <= Sleep.MOST_PARTS
                        : spinOffset == 0 && r.values[first + RigidExtras.KNOWN_SPIN] == 0,
                "a body sleeps that is far out of balance");
    }

    private static void readContacts(ByteBuffer in, SavedState s) {
        SavedRigids r = s.rigids;
        int count = getInt(in);
        SnapshotCodec.require(
                count >= 0 && (long) LEAST_CONTACT * count <= in.remaining(), "it cannot hold so many contacts");
        KeptContacts contacts = r.contacts;
        contacts.ensure(count);
        contacts.count = count;
        for (int k = 0; k < count; k++) {
            int at = KeptContacts.KEYS * k;
            readPair(in, s, contacts.keys, at, false);
            SnapshotCodec.require(
                    in.remaining() >= Integer.BYTES * (REST_OF_KEY + KeptContacts.IMPULSES),
                    "it ends within a contact");
            contacts.keys[at + KeptContacts.FORM_AND_FEATURE] = in.getInt();
            contacts.keys[at + KeptContacts.FEATURE_OF_B] = in.getInt();
            requireOrder(contacts.keys, KeptContacts.KEYS, k);
            SnapshotCodec.require(
                    hasFeature(r, contacts.a(k), contacts.formAndFeature(k)), "a contact is at no part of its body");
            contacts.impulses[KeptContacts.IMPULSES * k] = readImpulse(in, 0f);
            contacts.impulses[KeptContacts.IMPULSES * k + 1] = readImpulse(in, -Limits.CACHED_IMPULSE);
        }
    }

    private static float readImpulse(ByteBuffer in, float least) {
        return Limits.within("an impulse of a body", in.getFloat(), least, Limits.CACHED_IMPULSE);
    }

    /** Whether the body of a contact has a feature. */
    private static boolean hasFeature(SavedRigids r, int body, int formAndFeature) {
        OutlineShape shape = r.outlines[r.outline[body]];
        int form = KeptContacts.form(formAndFeature);
        int there = form == KeptContacts.SWAPPED
                ? shape.lines().length / OutlineShape.LINE_STRIDE
                : shape.corners().length / OutlineShape.CORNER_STRIDE;
        return form >= KeptContacts.CORNER_ON_LINE
                && form <= KeptContacts.BOTH
                && KeptContacts.feature(formAndFeature) < there;
    }

    private static void readTouching(ByteBuffer in, SavedState s) {
        SavedRigids r = s.rigids;
        int count = getInt(in);
        SnapshotCodec.require(count >= 0 && 3L * count <= in.remaining(), "it cannot hold so many touching bodies");
        r.setTouching(count);
        for (int k = 0; k < count; k++) {
            readPair(in, s, r.touchingKeys, RigidStep.TOUCH_KEYS * k, true);
            requireOrder(r.touchingKeys, RigidStep.TOUCH_KEYS, k);
        }
    }

    /** Reads the pair of a contact, or of a touch, which may be sensed. */
    private static void readPair(ByteBuffer in, SavedState s, int[] keys, int at, boolean isTouch) {
        SavedRigids r = s.rigids;
        int type = SnapshotCodec.getByte(in);
        boolean isSensed = isTouch && type >= RigidStep.SENSED && type != RigidStep.SENSED + RigidStep.BODY_WALL;
        int a = Varint.get(in);
        int b = Varint.get(in);
        boolean isThere =
                switch (isSensed ? type - RigidStep.SENSED : type) {
                    case RigidStep.BODY_BODY -> isBody(r, b) && b > a;
                    case RigidStep.BODY_PIECE -> b >= 0 && b < s.terrain.pieceIds && s.terrain.lives(b);
                    case RigidStep.BODY_WALL -> b >= 0 && b < WallMotion.COUNT;
                    case RigidStep.BODY_CIRCLE -> Arrays.binarySearch(s.id, 0, s.circles, b) >= 0;
                    default -> false;
                };
        SnapshotCodec.require(isThere && isBody(r, a), "a contact of a body has no body, or nothing that it touches");
        keys[at + RigidStep.TYPE] = type;
        keys[at + RigidStep.A] = a;
        keys[at + RigidStep.B] = b;
    }

    private static boolean isBody(SavedRigids r, int id) {
        return id >= 0 && id < r.ids && r.lives(id);
    }

    /** Keys ascend. */
    private static void requireOrder(int[] keys, int stride, int k) {
        if (k > 0) {
            int order = 0;
            for (int at = stride * k; order == 0 && at < stride * (k + 1); at++) {
                order = Integer.compare(keys[at], keys[at - stride]);
            }
            SnapshotCodec.require(order > 0, "contacts of bodies are not in order");
        }
    }
}
