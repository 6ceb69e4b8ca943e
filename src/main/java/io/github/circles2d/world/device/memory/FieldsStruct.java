package io.github.circles2d.world.device.memory;

import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.circles.CircleFields;
import java.util.List;
import java.util.stream.Collectors;

/** The struct of the fields of a circle that steps read: an int for each, named by the row of {@link CircleField}. */
public final class FieldsStruct {
    static final String NAME = "CircleFields";

    private static final List<CircleField> FIELDS = CircleField.OF_STEPS;

    /** Ints of the struct: at least one, since a struct of OpenCL C is not empty. */
    private static final int WORDS = Math.max(1, FIELDS.size());

    static final int BYTES = Integer.BYTES * WORDS;

    private FieldsStruct() {}

    /** The struct in OpenCL C, and the initial values of its members. */
    static String text() {
        String members =
                FIELDS.stream().map(f -> "    int " + f.label() + ";\n").collect(Collectors.joining());
        String initial = FIELDS.stream()
                .map(f -> "(int) 0x" + Integer.toHexString((int) f.initial()))
                .collect(Collectors.joining(", "));
        boolean none = FIELDS.isEmpty();
        return "typedef struct {\n" + (none ? "    int none; // steps read no fields\n" : members) + "} " + NAME + ";\n"
                + "#define INITIAL_FIELDS {" + (none ? "0" : initial) + "}\n";
    }

    /** Ints for the structs of circles. */
    public static int[] room(int ids) {
        return new int[WORDS * ids];
    }

    /** By id, to what {@link #room} has given. */
    public static void pack(CircleFields from, int[] to) {
        for (int k = 0; k < FIELDS.size(); k++) {
            for (int id = 0; id < to.length / WORDS; id++) {
                to[WORDS * id + k] = from.getInt(FIELDS.get(k), id);
            }
        }
    }
}
