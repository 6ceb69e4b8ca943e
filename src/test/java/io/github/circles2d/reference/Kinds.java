package io.github.circles2d.reference;

import io.github.circles2d.Response;
import java.util.Arrays;
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

    /** The number of a field: the bits of the friction of circles that have none of their own. */
    static final int FRICTION = 8;

    /** The number of a field: the bits of the rolling resistance likewise. */
    static final int ROLLING_RESISTANCE = 9;

    /** The number of a field: the bits of the speed that the surface has besides that of turning. */
    static final int BELT_SPEED = 10;

    /** The number of a field: 0 for discs, 1 for rings, 2 for circles that friction does not turn. */
    static final int INERTIA = 11;

    /** The number of a field: the bits of the damping of angular velocities. */
    static final int ANGULAR_DAMPING = 12;

    /** The number of a field: 1 for terrain that circles pass from behind. */
    static final int ONE_WAY = 13;

    /** Not 0 if circles never fall asleep. */
    static final int AWAKE = 14;

    /** Not 0 if static circles sense static ones and pieces of bodies. */
    static final int SENSES_STATIC = 15;

    private static final int KINDS = 256;

    private static final int[] AT_FIRST = atFirst();

    private static final long KIND = 0x6B696E64A5C3D21FL;
    private static final long RESPONSE = 0x726573706F6E7365L;

    /** Of each kind, its fields. */
    private final int[][] values = new int[KINDS][];

    /** What is set of two kinds, by the lesser one times 256 plus the greater one. */
    private final Map<Integer, Response> matrix = new TreeMap<>();

    Kinds() {
        Arrays.setAll(values, kind -> AT_FIRST.clone());
    }

    /** By the number of a field; there is no field 0. */
    private static int[] atFirst() {
        int[] fields = new int[SENSES_STATIC + 1];
        fields[CATEGORY] = 1;
        fields[MASK] = -1;
        fields[RESTITUTION] = Float.floatToIntBits(Float.NaN);
        fields[GRAVITY_SCALE] = Float.floatToIntBits(1f);
        fields[GREATEST_SPEED] = Float.floatToIntBits(Float.POSITIVE_INFINITY);
        fields[FRICTION] = Float.floatToIntBits(Float.NaN);
        fields[ROLLING_RESISTANCE] = Float.floatToIntBits(Float.NaN);
        return fields;
    }

    void set(int kind, int field, int value) {
        values[kind][field] = value;
    }

    float getFloat(int kind, int field) {
        return Float.intBitsToFloat(get(kind, field));
    }

    float gravityScale(Circle c) {
        return Float.isNaN(c.gravityScale) ? getFloat(c.kind, GRAVITY_SCALE) : c.gravityScale;
    }

    float damping(Circle c) {
        return Float.isNaN(c.damping) ? getFloat(c.kind, DAMPING) : c.damping;
    }

    float greatestSpeed(Circle c) {
        return Float.isNaN(c.greatestSpeed) ? getFloat(c.kind, GREATEST_SPEED) : c.greatestSpeed;
    }

    int get(int kind, int field) {
        return values[kind][field];
    }

    float restitution(int kind, float otherwise) {
        float own = getFloat(kind, RESTITUTION);
        return Float.isNaN(own) ? otherwise : own;
    }

    /** By the inverse mass: that of a disc, of a ring, of what does not turn. */
    float inverseInertia(int kind) {
        return new float[] {2f, 1f, 0f}[get(kind, INERTIA)];
    }

    private static int pair(int a, int b) {
        return KINDS * Math.min(a, b) + Math.max(a, b);
    }

    void setResponse(int a, int b, Response response) {
        matrix.put(pair(a, b), response);
        matrix.values().removeAll(Set.of(Response.BY_MASK));
    }

    /** Whether two circles that are near may be a contact. */
    boolean mayMeet(Circle a, Circle b) {
        return response(a, b) == Response.SOLID && !a.parted.contains(b);
    }

    /** What two circles do to each other. */
    Response response(Circle a, Circle b) {
        if (a.group != 0 && a.group == b.group) {
            return Response.IGNORE;
        }
        Response response = response(a.kind, b.kind);
        boolean stay = a.isStatic() && b.isStatic();
        return stay && !(response == Response.SENSE && asks(a.kind, b.kind)) ? Response.IGNORE : response;
    }

    /** Whether what does not move is sensed, too. */
    boolean asks(int a, int b) {
        return get(a, SENSES_STATIC) != 0 || get(b, SENSES_STATIC) != 0;
    }

    /** What a circle and a piece of two kinds do to each other, and two circles unless more is known of them. */
    Response response(int a, int b) {
        Response response = matrix.getOrDefault(pair(a, b), Response.BY_MASK);
        if (response != Response.BY_MASK) {
            return response;
        }
        if (!accepts(a, b) || !accepts(b, a)) {
            return Response.IGNORE;
        }
        return switch (get(a, SENSOR) + get(b, SENSOR)) {
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
        for (int kind = 0; kind < KINDS; kind++) {
            for (int field = 1; field < AT_FIRST.length; field++) {
                if (get(kind, field) != AT_FIRST[field]) {
                    long h = ReferenceWorld.absorb(ReferenceWorld.absorb(KIND, field), kind);
                    sum += ReferenceWorld.absorb(h, get(kind, field));
                }
            }
        }
        for (Map.Entry<Integer, Response> entry : matrix.entrySet()) {
            long h = ReferenceWorld.absorb(
                    ReferenceWorld.absorb(RESPONSE, entry.getKey() / KINDS), entry.getKey() % KINDS);
            sum += ReferenceWorld.absorb(h, entry.getValue().ordinal());
        }
        return sum;
    }
}
