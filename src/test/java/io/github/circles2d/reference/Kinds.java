package io.github.circles2d.reference;

import io.github.circles2d.Response;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;

/** What kinds of circles are, and what the circles of two kinds do to each other. */
final class Kinds {
    /** The number of a field: the bits that the masks of others look for. */
    static final int CATEGORY = 1;

    /** The number of a field: the categories that the kind meets. */
    static final int MASK = 2;

    /** The number of a field: 1 for a sensor. */
    static final int SENSOR = 3;

    /** The number of a field: the bits of the restitution that circles get with the kind. */
    static final int RESTITUTION = 4;

    /** The number of a field: the bits of what gravity is multiplied by. */
    static final int GRAVITY_SCALE = 5;

    /** The number of a field: the bits of the damping. */
    static final int DAMPING = 6;

    /** The number of a field: the bits of the greatest speed. */
    static final int GREATEST_SPEED = 7;

    private static final Map<Integer, Integer> AT_FIRST = Map.of(
            CATEGORY, 1,
            MASK, -1,
            SENSOR, 0,
            RESTITUTION, Float.floatToIntBits(Float.NaN),
            GRAVITY_SCALE, Float.floatToIntBits(1f),
            DAMPING, 0,
            GREATEST_SPEED, Float.floatToIntBits(Float.POSITIVE_INFINITY));

    private static final long KIND = 0x6B696E64A5C3D21FL;
    private static final long RESPONSE = 0x726573706F6E7365L;

    /** A field of a kind. */
    private record Field(int kind, int number) {}

    /** What is not as at first. */
    private final Map<Field, Integer> values = new java.util.HashMap<>();

    /** What is set of two kinds, by the lesser one times 256 plus the greater one. */
    private final Map<Integer, Response> matrix = new TreeMap<>();

    void set(int kind, int field, int value) {
        values.put(new Field(kind, field), value);
        values.entrySet()
                .removeIf(entry -> AT_FIRST.get(entry.getKey().number()).equals(entry.getValue()));
    }

    float getFloat(int kind, int field) {
        return Float.intBitsToFloat(get(kind, field));
    }

    int get(int kind, int field) {
        return values.getOrDefault(new Field(kind, field), AT_FIRST.get(field));
    }

    float restitution(int kind, float otherwise) {
        float own = getFloat(kind, RESTITUTION);
        return Float.isNaN(own) ? otherwise : own;
    }

    private static int pair(int a, int b) {
        return 256 * Math.min(a, b) + Math.max(a, b);
    }

    void setResponse(int a, int b, Response response) {
        matrix.put(pair(a, b), response);
        matrix.values().removeAll(Set.of(Response.BY_MASK));
    }

    /** Whether two circles that are near may be a contact. */
    boolean mayMeet(Circle a, Circle b) {
        return response(a, b) == Response.SOLID;
    }

    /** What two circles do to each other. */
    Response response(Circle a, Circle b) {
        if (a.isStatic() && b.isStatic() || a.group != 0 && a.group == b.group) {
            return Response.IGNORE;
        }
        Response response = matrix.getOrDefault(pair(a.kind, b.kind), Response.BY_MASK);
        if (response != Response.BY_MASK) {
            return response;
        }
        if (!accepts(a.kind, b.kind) || !accepts(b.kind, a.kind)) {
            return Response.IGNORE;
        }
        return switch (get(a.kind, SENSOR) + get(b.kind, SENSOR)) {
            case 0 -> Response.SOLID;
            case 1 -> Response.SENSE;
            default -> Response.IGNORE;
        };
    }

    private boolean accepts(int kind, int other) {
        return (get(kind, MASK) & get(other, CATEGORY)) != 0;
    }

    long hash() {
        long sum = 0;
        for (Map.Entry<Field, Integer> entry : values.entrySet()) {
            long h = ReferenceWorld.absorb(KIND, entry.getKey().number());
            sum += ReferenceWorld.absorb(ReferenceWorld.absorb(h, entry.getKey().kind()), entry.getValue());
        }
        for (Map.Entry<Integer, Response> entry : matrix.entrySet()) {
            long h = ReferenceWorld.absorb(ReferenceWorld.absorb(RESPONSE, entry.getKey() / 256), entry.getKey() % 256);
            sum += ReferenceWorld.absorb(h, entry.getValue().ordinal());
        }
        return sum;
    }
}
