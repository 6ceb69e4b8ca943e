package io.github.circles2d.fuzz;

/** Copies of arrays, so that no world writes to those of another. */
final class Copy {
    private Copy() {}

    static Object of(Object value) {
        if (value instanceof float[] floats) {
            return floats.clone();
        }
        if (value instanceof long[] longs) {
            return longs.clone();
        }
        return value instanceof int[] ints ? ints.clone() : value;
    }
}
