package io.github.circles2d.world.device.memory;

import java.util.ArrayList;
import java.util.List;

/**
 * A struct of the kernels that the host fills from a T. It has one row per field; the rows give the text of the struct and pack the
 * values.
 */
final class HostStruct<T> {
    /** Packs the values of a field. */
    interface Values<T> {
        void pack(T from, Words to);
    }

    /** Ints to pack into, one after the other; floats as their bits. */
    static final class Words {
        private final int[] words;
        private int at;

        private Words(int[] words) {
            this.words = words;
        }

        Words put(int value) {
            words[at++] = value;
            return this;
        }

        Words put(float value) {
            return put(Float.floatToRawIntBits(value));
        }

        Words put(int[] values) {
            for (int value : values) {
                put(value);
            }
            return this;
        }

        Words put(boolean[] values) {
            for (boolean value : values) {
                put(value ? 1 : 0);
            }
            return this;
        }

        Words put(float[] values) {
            for (float value : values) {
                put(value);
            }
            return this;
        }
    }

    private record Field<T>(String type, String name, int at, int words, Values<T> values, String comment) {}

    private final String name;
    private final List<Field<T>> fields = new ArrayList<>();
    private int words;

    HostStruct(String name) {
        this.name = name;
    }

    /** Adds a field of one word. */
    HostStruct<T> field(String type, String field, Values<T> values, String comment) {
        return field(type, field, 1, values, comment);
    }

    /** Adds a field of several words: an array, which has its length in brackets behind its name, or a struct. */
    HostStruct<T> field(String type, String field, int count, Values<T> values, String comment) {
        fields.add(new Field<>(type, field, words, count, values, comment));
        words += count;
        return this;
    }

    /** Adds an int that {@link #pack} leaves alone. */
    HostStruct<T> apart(String field, String comment) {
        return apart(field, 1, comment);
    }

    /** The same of an array of ints, which has its length in brackets behind its name. */
    HostStruct<T> apart(String field, int count, String comment) {
        return field("int", field, count, (from, to) -> to.at += count, comment);
    }

    /** Number of ints that the struct takes. */
    int words() {
        return words;
    }

    /** The position of a field among the ints. */
    int at(String field) {
        for (Field<T> candidate : fields) {
            if (candidate.name.equals(field)) {
                return candidate.at;
            }
        }
        throw new IllegalArgumentException(name + " has no field " + field);
    }

    void pack(T from, int[] to) {
        Words target = new Words(to);
        for (Field<T> field : fields) {
            target.at = field.at;
            field.values.pack(from, target);
            if (target.at != field.at + field.words) {
                throw new IllegalStateException(name + "." + field.name + " has not " + field.words + " values");
            }
        }
    }

    /** The struct in OpenCL C. */
    String text() {
        StringBuilder text = new StringBuilder("typedef struct {\n");
        for (Field<T> field : fields) {
            text.append("    " + field.type + " " + field.name + "; // " + field.comment + "\n");
        }
        return text.append("} " + name + ";\n").toString();
    }
}
