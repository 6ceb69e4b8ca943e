package io.github.circles2d.world.device.memory;

import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.circles.CircleFields;
import java.util.Arrays;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.Collectors;

/**
 * The struct of the fields of a circle that all steps read: an int for each, named by the row of {@link CircleField}. Those that
 * steps read if circles can rotate have no memory in other worlds: they lie in {@link DeviceArray#HOME_OWN}. Likewise those by which circles
 * move in another way than those of their kind, in {@link DeviceArray#OWN_MOTION}.
 */
public final class FieldsStruct {
    static final String NAME = "CircleFields";

    private static final List<CircleField> FIELDS = those(f -> !f.isOfTurning() && !f.isOfMotion());

    private static final List<CircleField> TURNING = those(CircleField::isOfTurning);

    private static final List<CircleField> MOTION = those(CircleField::isOfMotion);

    /** Floats of an element of {@link DeviceArray#HOME_OWN}, and of {@link DeviceArray#OWN_MOTION}. */
    public static final int STRIDE = 4;

    /** Ints of the struct: at least one, since a struct of OpenCL C is not empty. */
    private static final int WORDS = Math.max(1, FIELDS.size());

    static final int BYTES = Integer.BYTES * WORDS;

    private FieldsStruct() {}

    /** They come in this order, since a number in a command finds a place. */
    private static List<CircleField> those(Predicate<CircleField> are) {
        return CircleField.OF_STEPS.stream().filter(are).collect(Collectors.toUnmodifiableList());
    }

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
                + "#define TURNING_FIELDS " + FIELDS.size() + " // the number of the first field that lies in homeOwn\n"
                + "#define SURFACE_FIELDS " + CircleField.surfaces()
                + " // those of surfaces, which come first in homeOwn\n"
                + "#define INITIAL_OWN " + initial(TURNING) + "\n"
                + "#define MOTION_FIELDS " + (FIELDS.size() + TURNING.size())
                + " // the number of the first field that lies in ownMotion\n"
                + "#define INITIAL_MOTION " + initial(MOTION) + "\n";
    }

    private static String initial(List<CircleField> fields) {
        return Arrays.stream(initialBits(fields))
                .mapToObj(bits -> "as_float(0x" + Integer.toHexString(bits) + ")")
                .collect(Collectors.joining(", ", "(float4)(", ")"));
    }

    private static int[] initialBits(List<CircleField> fields) {
        int[] bits = new int[STRIDE];
        for (int place = 0; place < fields.size(); place++) {
            bits[place] = (int) fields.get(place).initial();
        }
        return bits;
    }

    /** The bits of an element of {@link DeviceArray#HOME_OWN} of a new circle. */
    static int[] initialTurning() {
        return initialBits(TURNING);
    }

    /** The bits of an element of {@link DeviceArray#OWN_MOTION} of a new circle. */
    static int[] initialMotion() {
        return initialBits(MOTION);
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
