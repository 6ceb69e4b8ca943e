package io.github.circles2d.fuzz;

import java.util.Arrays;
import java.util.StringJoiner;

/** Values as a developer can paste them into a test. */
final class Text {
    private Text() {}

    static String of(Object value) {
        if (value instanceof Float f) {
            return Float.isNaN(f)
                    ? "Float.NaN"
                    : Float.isInfinite(f) ? "Float." + (f > 0 ? "POSITIVE" : "NEGATIVE") + "_INFINITY" : f + "f";
        }
        if (value instanceof Long) {
            return value + "L";
        }
        if (value instanceof float[] floats) {
            StringJoiner text = new StringJoiner(", ", "{", "}");
            for (float each : floats) {
                text.add(of(each));
            }
            return text.toString();
        }
        if (value instanceof int[] ints) {
            return Arrays.toString(ints).replace('[', '{').replace(']', '}');
        }
        if (value instanceof Enum<?> constant) {
            return constant.getDeclaringClass().getSimpleName() + "." + constant.name();
        }
        return String.valueOf(value);
    }
}
