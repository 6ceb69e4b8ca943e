package io.github.circles2d.world.device.memory;

import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.circles.CircleFields;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;

/**
 * The struct of the fields of a circle that all steps read: an int for each, named by the row of {@link CircleField}. Those that
 * steps read if circles can rotate have no memory in other worlds: they lie in {@link DeviceArray#HOME_OWN}. Likewise those by which circles
 * move in another way than those of their kind, in {@link DeviceArray#OWN_MOTION}.
 */
public final class FieldsStruct {
    static final String NAME = "CircleFields";

    /** The first of those that other worlds do not have; they come last, those of motion behind those of turning. */
    private static final int FIRST_TURNING = CircleField.OF_STEPS.indexOf(CircleField.FRICTION);

    private static final int FIRST_MOTION = CircleField.OF_STEPS.indexOf(CircleField.GRAVITY_SCALE);

    private static final List<CircleField> FIELDS = CircleField.OF_STEPS.subList(0, FIRST_TURNING);

    private static final List<CircleField> TURNING = CircleField.OF_STEPS.subList(FIRST_TURNING, FIRST_MOTION);

    private static final List<CircleField> MOTION =
            CircleField.OF_STEPS.subList(FIRST_MOTION, CircleField.OF_STEPS.size());

    /** Floats of an element of {@link DeviceArray#HOME_OWN}, and of {@link DeviceArray#OWN_MOTION}. */
    public static final int STRIDE = 4;

    /** Ints of the struct: at least one, since a struct of OpenCL C is not empty. */
    private static final int WORDS = Math.max(1, FIELDS.size());

    static final int BYTES = Integer.BYTES * WORDS;

    private FieldsStruct() {}

    /** The place of such a field among those of its kind. */
    static int turningPlace(CircleField field) {
        return TURNING.indexOf(field);
    }

    /** Likewise. */
    static int motionPlace(CircleField field) {
        return MOTION.indexOf(field);
    }

    /** The struct in OpenCL C, and the initial values of its members. */
    static String text() {
        String members =
                FIELDS.stream().map(f -> "    int " + f.label() + ";\n").collect(Collectors.joining());
        String initial = FIELDS.stream()
                .map(f -> "(int) 0x" + Integer.toHexString((int) f.initial()))
                .collect(Collectors.joining(", "));
        boolean none = FIELDS.isEmpty();
        return "typedef struct {\n" + (none ? "    int none; // steps read no fields\n" : members) + "} " + NAME + ";\n"
                + "#define INITIAL_FIELDS {" + (none ? "0" : initial) + "}\n"
                + "#define TURNING_FIELDS " + FIRST_TURNING + " // the number of the first field that lies in homeOwn\n"
                + "#define INITIAL_OWN " + initial(TURNING) + "\n"
                + "#define MOTION_FIELDS " + FIRST_MOTION + " // the number of the first field that lies in ownMotion\n"
                + "#define INITIAL_MOTION " + initial(MOTION) + "\n";
    }

    private static String initial(List<CircleField> fields) {
        String[] values = new String[STRIDE];
        Arrays.fill(values, "0.0f");
        fields.forEach(f -> values[fields.indexOf(f)] = "as_float(0x" + Integer.toHexString((int) f.initial()) + ")");
        return "(float4)(" + String.join(", ", values) + ")";
    }

    /** The bits of an element of {@link DeviceArray#OWN_MOTION} of a new circle. */
    static int[] initialMotion() {
        int[] values = new int[STRIDE];
        MOTION.forEach(f -> values[motionPlace(f)] = (int) f.initial());
        return values;
    }

    /** Ints of the structs of so many circles. */
    public static int words(int ids) {
        return WORDS * ids;
    }

    /** Of so many ids. */
    public static void pack(CircleFields from, int ids, int[] to) {
        for (int k = 0; k < FIELDS.size(); k++) {
            for (int id = 0; id < ids; id++) {
                to[WORDS * id + k] = from.getInt(FIELDS.get(k), id);
            }
        }
    }

    /** The fields that are there only if circles can rotate, by circle, for {@link DeviceArray#HOME_OWN}. */
    public static void packTurning(CircleFields from, int[] ids, int circles, int[] to) {
        for (int k = 0; k < circles; k++) {
            for (int place = 0; place < TURNING.size(); place++) {
                to[STRIDE * k + place] = from.getInt(TURNING.get(place), ids[k]);
            }
        }
    }

    /** Of so many ids, for {@link DeviceArray#OWN_MOTION}. */
    public static void packMotion(CircleFields from, int ids, int[] to) {
        for (int id = 0; id < ids; id++) {
            for (int place = 0; place < MOTION.size(); place++) {
                to[STRIDE * id + place] = from.getInt(MOTION.get(place), id);
            }
        }
    }
}
