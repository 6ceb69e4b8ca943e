package io.github.circles2d.fuzz;

import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.nio.LongBuffer;
import java.util.Arrays;
import java.util.function.Function;
import java.util.function.ToIntFunction;
import java.util.stream.Collectors;

/** Values that are no handles. */
final class Values {
    private Values() {}

    /** A number, a constant or an array. */
    record Constant(Object value) implements Value {
        @Override
        public Object find(Player first) {
            return value;
        }

        @Override
        public String toString() {
            return value instanceof float[]
                    ? "new float[] " + Text.of(value)
                    : value instanceof int[] ? "new int[] " + Text.of(value) : Text.of(value);
        }
    }

    /** An array that a call fills, of a length that depends on the world. */
    record Filled(Class<?> type, String length, ToIntFunction<Player> lengths) implements Value {
        @Override
        public Object find(Player first) {
            return lengths.applyAsInt(first);
        }

        @Override
        public Object on(Player player, Object found) {
            int n = (Integer) found;
            return type == FloatBuffer.class
                    ? FloatBuffer.allocate(n)
                    : type == LongBuffer.class
                            ? LongBuffer.allocate(n)
                            : java.lang.reflect.Array.newInstance(type.getComponentType(), n);
        }

        @Override
        public String toString() {
            return type.isArray()
                    ? "new " + type.getComponentType() + "[" + length + "]"
                    : type.getSimpleName() + ".allocate(" + length + ")";
        }
    }

    /** An object of each world. */
    record Own(String text, Function<Player, Object> object) implements Value {
        @Override
        public Object find(Player first) {
            return null;
        }

        @Override
        public Object on(Player player, Object found) {
            return object.apply(player);
        }

        @Override
        public String toString() {
            return text;
        }
    }

    /** An array of objects that calls make. */
    record Several(Class<?> type, Value[] values) implements Value {
        @Override
        public Object find(Player first) {
            return Values.find(values, first);
        }

        @Override
        public Object on(Player player, Object found) throws Throwable {
            Object array = java.lang.reflect.Array.newInstance(type, values.length);
            Object[] objects = Values.on(values, player, (Object[]) found);
            System.arraycopy(objects, 0, array, 0, objects.length);
            return array;
        }

        @Override
        public String toString() {
            return "new " + type.getSimpleName() + "[] "
                    + Arrays.stream(values).map(Value::toString).collect(Collectors.joining(", ", "{", "}"));
        }
    }

    /** Room for a snapshot, which the player keeps. */
    record NewSnapshot() implements Value {
        @Override
        public Object find(Player first) {
            return null;
        }

        @Override
        public Object on(Player player, Object found) {
            ByteBuffer bytes = ByteBuffer.allocate(player.world.snapshotBytes());
            player.snapshots.add(bytes);
            return bytes;
        }

        @Override
        public String toString() {
            return "newSnapshot()";
        }
    }

    /** An earlier snapshot, which another world has made; damaged, if a bit of it is named. */
    record Snapshot(int number, int bit) implements Value {
        @Override
        public Object find(Player first) {
            return first.snapshots.isEmpty() ? -1 : number % first.snapshots.size();
        }

        @Override
        public Object on(Player player, Object found) {
            int which = (Integer) found;
            if (which < 0) {
                return ByteBuffer.allocate(bit < 0 ? 0 : bit % 100);
            }
            byte[] bytes = player.next.snapshots.get(which).array().clone();
            if (bit >= 0) {
                bytes[bit / 8 % bytes.length] ^= (byte) (1 << bit % 8);
            }
            return ByteBuffer.wrap(bytes);
        }

        @Override
        public String toString() {
            return "snapshot(" + number + (bit < 0 ? "" : ", damaged at " + bit) + ")";
        }
    }

    /** Values together. */
    static Object[] find(Value[] values, Player first) {
        return Arrays.stream(values).map(value -> value.find(first)).toArray();
    }

    static Object[] on(Value[] values, Player player, Object[] found) throws Throwable {
        Object[] objects = new Object[values.length];
        for (int k = 0; k < values.length; k++) {
            objects[k] = values[k].on(player, found[k]);
        }
        return objects;
    }
}
