package io.github.circles2d.world.circles;

import io.github.circles2d.world.model.Features;
import io.github.circles2d.world.model.KindField;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.model.PairTable;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Collectors;

/**
 * The table of the fields that only calls change, one row each. From a row follow the field's memory and its part of the hash
 * ({@link CircleFields}), of snapshots and, if steps read it, of the kernels' struct {@code CircleFields}.
 *
 * <p>A value is a whole number; a float is meant by its bits. Every new circle has the initial value. A field whose range fits
 * into an int takes one word of memory for a circle, else two. Steps can read fields of one word.
 */
public enum CircleField {
    /** A number that the caller gives a circle. */
    TAG(1, "tag", 0, Long.MIN_VALUE, Long.MAX_VALUE, false),

    /** The kind, which says what the circle meets: a row of {@link KindTable}. */
    KIND(2, "kind", 0, 0, PairTable.KINDS - 1, true),

    /** The exclusion group: circles of one group do not meet. 0 is no group. */
    GROUP(3, "group", 0, Integer.MIN_VALUE, Integer.MAX_VALUE, true),

    /** The force that is set for the circle, along x. For steps, with what is applied in the one that is made. */
    FORCE_X(4, "forceX", Part.OF_ALL, Limits.FORCE, true),

    /** The same along y. */
    FORCE_Y(5, "forceY", Part.OF_ALL, Limits.FORCE, true),

    /** The force that is applied in the next step alone, along x. */
    APPLIED_X(6, "applied force x", Part.OF_ALL, Limits.FORCE, false),

    /** The same along y. */
    APPLIED_Y(7, "applied force y", Part.OF_ALL, Limits.FORCE, false),

    /** Where a static circle travels in the next step, by {@link #place}; at first nowhere. {@code Travels} alone sets it. */
    TARGET(9, "target", -1, Long.MIN_VALUE, Long.MAX_VALUE, false),

    /** The radius that a circle grows to, and in how many steps, by {@link #growth}, or 0. {@code world.Growth} alone sets it. */
    GROWTH(10, "growth", 0, Long.MIN_VALUE, Long.MAX_VALUE, false),

    /** The circle's own friction, or NaN for that of its kind. */
    FRICTION(11, "friction", KindField.FRICTION, Part.SURFACE, 0, Limits.FRICTION),

    /** The circle's own rolling resistance, or NaN for that of its kind. */
    ROLLING_RESISTANCE(
            12, "rollingResistance", KindField.ROLLING_RESISTANCE, Part.SURFACE, 0, Limits.ROLLING_RESISTANCE),

    /** The torque that is set for the circle. For steps, with what is applied in the one that is made. */
    TORQUE(13, "torque", Part.TORQUE, Limits.TORQUE, true),

    /** The torque that is applied in the next step alone. */
    APPLIED_TORQUE(14, "applied torque", Part.TORQUE, Limits.TORQUE, false),

    /** What gravity is multiplied by for the circle, or NaN for what its kind has. */
    GRAVITY_SCALE(
            15, "gravityScale", KindField.GRAVITY_SCALE, Part.MOTION, -Limits.GRAVITY_SCALE, Limits.GRAVITY_SCALE),

    /** The circle's own damping, 1/s, or NaN for that of its kind. */
    DAMPING(16, "damping", KindField.DAMPING, Part.MOTION, 0, Limits.VELOCITY_DAMPING),

    /** The circle's own greatest speed, which may be infinite, or NaN for that of its kind. */
    GREATEST_SPEED(17, "greatestSpeed", KindField.GREATEST_SPEED, Part.MOTION, 0, Float.POSITIVE_INFINITY);

    /** The bits that stand for no value of a float. */
    public static final int NONE = Float.floatToRawIntBits(Float.NaN);

    public static final List<CircleField> ALL = List.of(values());

    /** The fields that steps read; their places in this list number them in commands and in the kernels' struct. */
    public static final List<CircleField> OF_STEPS = Arrays.stream(values())
            .filter(f -> f.ofSteps)
            .sorted(Comparator.comparing(f -> f.part))
            .collect(Collectors.toUnmodifiableList());

    /** The fields of surfaces, in the order of these. No list, whose iterators would be garbage of each call. */
    private static final CircleField[] SURFACE =
            Arrays.stream(values()).filter(CircleField::isOfSurface).toArray(CircleField[]::new);

    /** Which worlds have a field: all; those in which circles can rotate; those in which circles move in another way than their kind. */
    private enum Part {
        OF_ALL(Features.NONE),
        SURFACE(Features.TURNING),
        TORQUE(Features.TURNING),
        MOTION(Features.OWN_MOTION);

        private final Features features;

        Part(Features features) {
            this.features = features;
        }
    }

    private final int number;
    private final String label;
    private final long initial;
    private final long least;
    private final long greatest;
    private final boolean ofSteps;
    private final Part part;

    /** Null if kinds have no such value. */
    private final KindField ofKind;

    /** Greatest magnitude of a float; 0 if the field is a whole number. */
    private final float most;

    /**
     * Snapshots and the hash know the field by its number: greater than those before, and never changed. Messages and kernels know the
     * label. All pipelines have the values of fields that steps read.
     */
    CircleField(int number, String label, long initial, long least, long greatest, boolean ofSteps) {
        this.number = number;
        this.label = label;
        this.initial = initial;
        this.least = least;
        this.greatest = greatest;
        this.ofSteps = ofSteps;
        part = Part.OF_ALL;
        ofKind = null;
        most = 0;
    }

    /** A float, by its bits, 0 at first; most is the greatest magnitude. */
    CircleField(int number, String label, Part part, float most, boolean ofSteps) {
        this.number = number;
        this.label = label;
        initial = 0;
        least = Integer.MIN_VALUE;
        greatest = Integer.MAX_VALUE;
        this.ofSteps = ofSteps;
        this.part = part;
        ofKind = null;
        this.most = most;
    }

    /** A float that steps read in place of the kind's, none at first: from 0 on, or of a magnitude of up to most. */
    CircleField(int number, String label, KindField ofKind, Part part, float least, float most) {
        this.number = number;
        this.label = label;
        initial = Float.floatToRawIntBits(Float.NaN);
        this.least = least < 0 ? Integer.MIN_VALUE : 0;
        greatest = Integer.MAX_VALUE;
        ofSteps = true;
        this.part = part;
        this.ofKind = ofKind;
        this.most = most;
    }

    /** Whether a value is the bits of a float. */
    public boolean isFloat() {
        return most > 0;
    }

    /** A float as the bits of a value. There is one zero. */
    public static int bits(float value) {
        return Float.floatToRawIntBits(value + 0f);
    }

    public static long place(float x, float y) {
        return Float.floatToRawIntBits(x) & 0xFFFFFFFFL | (long) Float.floatToRawIntBits(y) << Integer.SIZE;
    }

    public static float placeX(long place) {
        return Float.intBitsToFloat((int) place);
    }

    public static float placeY(long place) {
        return Float.intBitsToFloat((int) (place >> Integer.SIZE));
    }

    public static long growth(float radius, int steps) {
        return Float.floatToRawIntBits(radius) & 0xFFFFFFFFL | (long) steps << Integer.SIZE;
    }

    public static float growthRadius(long growth) {
        return Float.intBitsToFloat((int) growth);
    }

    public static int growthSteps(long growth) {
        return (int) (growth >> Integer.SIZE);
    }

    /** What snapshots, the hash and logs know the field by. */
    public int number() {
        return number;
    }

    /** The field of a number; null if there is none. */
    public static CircleField ofNumber(int number) {
        for (int k = 0; k < ALL.size(); k++) { // an iterator would be garbage whenever a snapshot is read
            if (ALL.get(k).number == number) {
                return ALL.get(k);
            }
        }
        return null;
    }

    /** The name in messages and in kernels. */
    public String label() {
        return label;
    }

    public long initial() {
        return initial;
    }

    /** The least value that is allowed. */
    public long least() {
        return least;
    }

    /** The greatest value that is allowed. */
    public long greatest() {
        return greatest;
    }

    public boolean isOfSteps() {
        return ofSteps;
    }

    /** What steps must be ready for once a circle has another value than the initial one. */
    public Features features() {
        return part.features;
    }

    /** Whether circles can rotate once one has another value than the initial one. */
    public boolean isOfTurning() {
        return part.features.turning();
    }

    /** Whether circles move in another way than those of their kind once one has another value than the initial one. */
    public boolean isOfMotion() {
        return part.features.ownMotion();
    }

    /** Whether it is a part of the circle's surface. */
    public boolean isOfSurface() {
        return part == Part.SURFACE;
    }

    /** How many fields surfaces have. */
    public static int surfaces() {
        return SURFACE.length;
    }

    /** Field number k of surfaces. */
    public static CircleField surface(int k) {
        return SURFACE[k];
    }

    /** The field of kinds that counts for circles with no value of their own; null if kinds have no such value. */
    public KindField ofKind() {
        return ofKind;
    }

    /** Ints that a value takes. */
    public int words() {
        return least >= Integer.MIN_VALUE && greatest <= Integer.MAX_VALUE ? 1 : 2;
    }

    /** Throws {@link IllegalArgumentException} if the value is out of range. */
    public void check(long value) {
        if (value < least || value > greatest) {
            throw new IllegalArgumentException(
                    "the " + label + " is " + value + ", but must be from " + least + " to " + greatest);
        }
        if (isFloat() && value != initial) {
            float asFloat = Float.intBitsToFloat((int) value);
            if (!(Math.abs(asFloat) <= most)) { // a message that is not needed would be garbage
                Limits.within("the " + label, asFloat, -most, most);
            }
        }
    }
}
