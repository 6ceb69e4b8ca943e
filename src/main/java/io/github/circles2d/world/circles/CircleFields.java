package io.github.circles2d.world.circles;

import io.github.circles2d.world.model.Features;
import java.util.Arrays;
import java.util.List;

/**
 * The values of fields of all circles, by id. An id without a circle has the initial values. A field takes no memory until a
 * circle has got another value than the initial one.
 */
public final class CircleFields {
    /** No list, whose iterators would be garbage of each call. */
    private final CircleField[] fields;

    /** By field: the values by id. What is behind the end has the initial value. */
    private final int[][] words = new int[CircleField.ALL.size()][0];

    public CircleFields(List<CircleField> fields) {
        this.fields = fields.toArray(CircleField[]::new);
    }

    /** Makes room for ids up to this number, so that {@link #set} cannot fail. If there is none, no value has changed. */
    public void ensure(CircleField field, int ids) {
        int held = words[field.ordinal()].length / field.words();
        if (ids > held) {
            grow(field, (int) Math.min(Math.max(ids, held * 3L / 2), (Integer.MAX_VALUE - 8) / field.words()));
        }
    }

    private void grow(CircleField field, int circles) {
        int[] old = words[field.ordinal()];
        int each = field.words();
        if (circles > old.length / each) {
            int[] longer = Arrays.copyOf(old, each * circles);
            for (int id = old.length / each; id < circles; id++) {
                put(longer, each, id, field.initial());
            }
            words[field.ordinal()] = longer;
        }
    }

    /**
     * Makes room for the values of another object, so that {@link #copy} does not run out of memory. No more than that one has: two that copy
     * each other in turns would grow for ever.
     */
    public void makeRoom(CircleFields from) {
        for (CircleField field : fields) {
            grow(field, from.words[field.ordinal()].length / field.words());
        }
    }

    /** Takes over the values of another object, which holds the same fields or more. */
    public void copy(CircleFields from) {
        makeRoom(from);
        for (CircleField field : fields) {
            int[] theirs = from.words[field.ordinal()];
            int[] own = words[field.ordinal()];
            System.arraycopy(theirs, 0, own, 0, theirs.length);
            for (int id = theirs.length / field.words(); id < own.length / field.words(); id++) {
                put(own, field.words(), id, field.initial());
            }
        }
    }

    public long get(CircleField field, int id) {
        int[] own = words[field.ordinal()];
        int at = field.words() * id;
        if (at >= own.length) {
            return field.initial();
        }
        return field.words() == 1 ? own[at] : own[at] & 0xFFFFFFFFL | (long) own[at + 1] << Integer.SIZE;
    }

    /** The value of a circle, of a field of one word. */
    public int getInt(CircleField field, int id) {
        int[] own = words[field.ordinal()];
        return id < own.length ? own[id] : (int) field.initial();
    }

    public float getFloat(CircleField field, int id) {
        return Float.intBitsToFloat(getInt(field, id));
    }

    /** How many circles have another value than the initial one. */
    public int used(CircleField field) {
        int count = 0;
        for (int id = 0; id < end(field); id++) {
            count += get(field, id) != field.initial() ? 1 : 0;
        }
        return count;
    }

    /** Sets the value of a circle, for which there is room. */
    public void set(CircleField field, int id, long value) {
        put(words[field.ordinal()], field.words(), id, value);
    }

    private static void put(int[] to, int each, int id, long value) {
        to[each * id] = (int) value;
        if (each > 1) {
            to[each * id + 1] = (int) (value >> Integer.SIZE);
        }
    }

    /** Gives a circle the initial values. */
    public void clear(int id) {
        for (CircleField field : fields) {
            if (field.words() * id < words[field.ordinal()].length) {
                set(field, id, field.initial());
            }
        }
    }

    /** Gives all circles the initial values. */
    public void clearAll() {
        for (CircleField field : fields) {
            for (int id = 0; id < end(field); id++) {
                set(field, id, field.initial());
            }
        }
    }

    /** Memory of the values. */
    public long bytes() {
        long sum = 0;
        for (CircleField field : fields) {
            sum += (long) Integer.BYTES * words[field.ordinal()].length;
        }
        return sum;
    }

    /** Whether a circle has, or has had, another value than the initial one. */
    public boolean isUsed(CircleField field) {
        return end(field) > 0;
    }

    /** The same of surfaces. */
    public boolean areSurfacesUsed() {
        for (int k = 0; k < CircleField.surfaces(); k++) {
            if (isUsed(CircleField.surface(k))) {
                return true;
            }
        }
        return false;
    }

    /** The same of the fields by which circles move in another way than those of their kind. */
    public boolean areMotionsUsed() {
        for (CircleField field : fields) {
            if (field.isOfMotion() && isUsed(field)) {
                return true;
            }
        }
        return false;
    }

    /** What steps must be ready for by the values that circles have. */
    public Features features() {
        Features features = Features.NONE;
        for (CircleField field : fields) {
            if (!features.have(field.features()) && used(field) > 0) {
                features = features.and(field.features());
            }
        }
        return features;
    }

    /** The ids from which on all circles have the initial value of a field. */
    public int end(CircleField field) {
        return words[field.ordinal()].length / field.words();
    }

    /** The part of the fields in the hash of the state: one number for each value that is not the initial one. */
    public long hash() {
        long sum = 0;
        for (CircleField field : fields) {
            for (int id = 0; id < end(field); id++) {
                long value = get(field, id);
                if (value != field.initial()) {
                    sum += StateHash.field(field.number(), id, value);
                }
            }
        }
        return sum;
    }
}
