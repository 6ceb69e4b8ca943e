package io.github.circles2d.world.snapshots;

import io.github.circles2d.world.circles.KindTable;
import io.github.circles2d.world.model.KindField;
import io.github.circles2d.world.model.PairTable;
import java.nio.ByteBuffer;

/**
 * The kinds of circles in a snapshot: a section of {@link ParameterSections}, if some kind is not as it is at first.
 *
 * <pre>
 * section    int number of values, number of responses; for each value that is not the initial one, in ascending order of kind and
 *            field: byte kind, byte number of the field, int value; for each response that is set, in ascending order of both kinds:
 *            byte lesser kind, byte greater kind, byte setting
 * </pre>
 */
final class KindSection {
    /** An array: an iterator for each kind would be garbage whenever a compiler does not see through it. */
    private static final KindField[] FIELDS = KindField.values();

    private static final int VALUE = 2 + Integer.BYTES;
    private static final int RESPONSE = 3;

    private KindSection() {}

    static boolean isNeeded(KindTable kinds) {
        return kinds.used() + kinds.settings() > 0;
    }

    static void write(KindTable kinds, ByteBuffer out) {
        out.putInt(kinds.used()).putInt(kinds.settings());
        for (int kind = 0; kind < PairTable.KINDS; kind++) {
            for (KindField field : FIELDS) {
                if (kinds.get(field, kind) != field.initial()) {
                    out.put((byte) kind).put((byte) field.number()).putInt(kinds.get(field, kind));
                }
            }
        }
        for (int a = 0; a < PairTable.KINDS; a++) {
            for (int b = a; b < PairTable.KINDS; b++) {
                if (kinds.setting(a, b) != KindTable.BY_MASK) {
                    out.put((byte) a).put((byte) b).put((byte) kinds.setting(a, b));
                }
            }
        }
    }

    /** Reads the section behind its number, into kinds that are as they are at first, and checks it. */
    static void read(ByteBuffer in, KindTable kinds) {
        int values = in.getInt();
        int responses = in.getInt();
        boolean fit = values >= 0
                && responses >= 0
                && (long) values + responses > 0
                && (long) VALUE * values + (long) RESPONSE * responses <= in.remaining();
        if (!fit) {
            throw SnapshotCodec.refused(
                    "it cannot hold " + values + " values and " + responses + " responses of kinds");
        }
        int before = -1;
        for (int k = 0; k < values; k++) {
            int kind = Byte.toUnsignedInt(in.get());
            int number = Byte.toUnsignedInt(in.get());
            before = ascending(before, kind << Byte.SIZE | number);
            readValue(kinds, kind, field(number), in.getInt());
        }
        before = -1;
        for (int k = 0; k < responses; k++) {
            int a = Byte.toUnsignedInt(in.get());
            int b = Byte.toUnsignedInt(in.get());
            before = ascending(before, a << Byte.SIZE | b);
            int setting = in.get();
            SnapshotCodec.require(
                    a <= b && setting != KindTable.BY_MASK && KindTable.isSetting(setting),
                    "a response of kinds is out of range");
            kinds.setSetting(a, b, setting);
        }
    }

    private static int ascending(int before, int next) {
        SnapshotCodec.require(next > before, "its kinds are not in order");
        return next;
    }

    private static KindField field(int number) {
        KindField field = KindField.ofNumber(number);
        if (field == null) {
            throw SnapshotCodec.refused("no field of a kind has the number " + number);
        }
        return field;
    }

    private static void readValue(KindTable kinds, int kind, KindField field, int value) {
        SnapshotCodec.require(value != field.initial(), "it has an initial value of a kind");
        field.check(value);
        kinds.set(field, kind, value);
    }
}
