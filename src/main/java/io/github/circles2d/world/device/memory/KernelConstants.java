package io.github.circles2d.world.device.memory;

import java.lang.reflect.Field;
import java.lang.reflect.Modifier;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;

/** The public numbers of a class of the host, as kernels have them: by their names in Java, which say there what they mean. */
final class KernelConstants {
    /** The length of a row is no place in it. */
    private static final String LENGTH = "STRIDE";

    private KernelConstants() {}

    /** Defines ints and floats, all or those that are named: {@code #define PREFIX_NAME value}. */
    static String of(Class<?> table, String prefix, String... names) {
        StringBuilder text = heading(table);
        for (Field constant : constants(table, names)) {
            define(text, prefix, constant, literal(value(constant)));
        }
        return text.toString();
    }

    /** Defines places in a row that kernels have as vectors of four, likewise: {@code #define PREFIX_NAME vectors[1].s2} for 6. */
    static String places(Class<?> table, String prefix, String vectors, String... names) {
        StringBuilder text = heading(table);
        for (Field constant : constants(table, names)) {
            if (!constant.getName().equals(LENGTH)) {
                int place = (Integer) value(constant);
                define(text, prefix, constant, vectors + "[" + place / 4 + "].s" + place % 4);
            }
        }
        return text.toString();
    }

    private static StringBuilder heading(Class<?> table) {
        return new StringBuilder("// " + table.getSimpleName() + ".java\n");
    }

    private static void define(StringBuilder text, String prefix, Field constant, String value) {
        text.append("#define " + prefix + constant.getName() + " " + value + "\n");
    }

    /** By name: reflection has no order. */
    private static List<Field> constants(Class<?> table, String... names) {
        List<Field> constants = Arrays.stream(table.getFields())
                .filter(field -> Modifier.isStatic(field.getModifiers())
                        && (field.getType() == int.class || field.getType() == float.class)
                        && (names.length == 0 || List.of(names).contains(field.getName())))
                .sorted(Comparator.comparing(Field::getName))
                .toList();
        if (names.length > 0 && constants.size() != names.length) {
            throw new IllegalStateException(table + " has not all of " + List.of(names));
        }
        return constants;
    }

    private static Object value(Field constant) {
        try {
            return constant.get(null);
        } catch (IllegalAccessException e) {
            throw new IllegalStateException(constant + " must be public, of a public class", e);
        }
    }

    /** A float keeps every bit. */
    private static String literal(Object value) {
        if (value instanceof Float number) {
            return Float.isInfinite(number)
                    ? number > 0 ? "INFINITY" : "(-INFINITY)"
                    : "(" + Float.toHexString(number) + "f)";
        }
        return (Integer) value < 0 ? "(" + value + ")" : value.toString();
    }
}
