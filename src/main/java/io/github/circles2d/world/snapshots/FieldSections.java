package io.github.circles2d.world.snapshots;

import io.github.circles2d.world.circles.CircleField;
import java.nio.ByteBuffer;

/**
 * The fields of circles in a snapshot: a section for each field of which some circle has not the initial value, in the order of
 * their numbers.
 *
 * <pre>
 * section    int number of the field, number of values; for each value, in ascending order of the ids: varint of the id minus the
 *            one before (-1 at first), int or long value
 * </pre>
 */
final class FieldSections {
    /** No list, whose iterators would be garbage of each snapshot. */
    private static final CircleField[] ALL = CircleField.ALL.toArray(CircleField[]::new);

    private FieldSections() {}

    /** Returns how many sections these are. */
    static int write(SavedState s, ByteBuffer out) {
        int sections = 0;
        for (CircleField field : ALL) {
            int values = s.fields.used(field);
            if (values > 0) {
                sections++;
                out.putInt(field.number()).putInt(values);
                int previous = -1;
                for (int id = 0; id < s.fields.end(field); id++) {
                    long value = s.fields.get(field, id);
                    if (value != field.initial()) {
                        Varint.put(out, id - previous);
                        previous = id;
                        putValue(out, field, value);
                    }
                }
            }
        }
        return sections;
    }

    private static void putValue(ByteBuffer out, CircleField field, long value) {
        if (field.words() == 1) {
            out.putInt((int) value);
        } else {
            out.putLong(value);
        }
    }

    /**
     * Reads sections behind the records of the ids, those of {@link ParameterSections} and {@link TouchSection} too, and checks
     * them.
     */
    static void read(ByteBuffer in, SavedState s, int sections) {
        s.fields.clearAll();
        s.kinds.clear();
        s.touches.clear();
        s.terrain.clear();
        s.pieceContacts.clear();
        s.joints.clear();
        s.jointStates.begin(0);
        s.rigids.clear();
        if (sections < 0) {
            throw SnapshotCodec.refused("it cannot have " + sections + " sections");
        }
        int before = 0;
        for (int k = 0; k < sections; k++) {
            int number = in.getInt();
            SnapshotCodec.require(number > before, "its fields are not in order");
            before = number;
            if (number == TouchSection.NUMBER) {
                TouchSection.read(in, s, in.getInt());
            } else if (number >= ParameterSections.FIRST) {
                ParameterSections.read(in, s, number);
            } else {
                readSection(in, s, field(number), in.getInt());
            }
        }
    }

    private static CircleField field(int number) {
        CircleField field = CircleField.ofNumber(number);
        if (field == null) {
            throw SnapshotCodec.later("it has a field of circles with the unknown number " + number);
        }
        return field;
    }

    private static void readSection(ByteBuffer in, SavedState s, CircleField field, int values) {
        int least = 1 + Integer.BYTES * field.words();
        if (!(values > 0 && values <= s.circles && (long) values * least <= in.remaining())) {
            throw SnapshotCodec.refused("it cannot hold " + values + " values of a field");
        }
        s.fields.ensure(field, s.ids);
        long id = -1;
        int circle = 0;
        for (int k = 0; k < values; k++) {
            long more = Integer.toUnsignedLong(Varint.get(in));
            id += more;
            while (circle < s.circles && s.id[circle] < id) {
                circle++;
            }
            SnapshotCodec.require(
                    more > 0 && circle < s.circles && s.id[circle] == id, "a value of a field has no circle");
            long value = field.words() == 1 ? in.getInt() : in.getLong();
            SnapshotCodec.require(value != field.initial(), "it has an initial value of a field");
            field.check(value);
            s.fields.set(field, (int) id, value);
        }
    }
}
