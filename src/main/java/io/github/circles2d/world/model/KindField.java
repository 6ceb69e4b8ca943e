package io.github.circles2d.world.model;

import java.util.List;

/** The table of what a kind of circles has, one row each. A value is an int; a float is meant by its bits. */
public enum KindField {
    /** The bits that others look for in their masks. */
    CATEGORY(1, 1, Check.ANY_INT),

    MASK(2, -1, Check.ANY_INT),

    /** 1 if what its circles would meet is sensed instead. */
    SENSOR(3, 0, value -> Limits.within("sensor", value, 0, 1)),

    /** The restitution that circles get with the kind, or NaN for none. */
    RESTITUTION(4, Check.NONE, Check.orNone(Limits::restitution)),

    /** What gravity is multiplied by for the kind, a float. */
    GRAVITY_SCALE(5, Float.floatToRawIntBits(1), ofFloat("gravity scale", -Limits.GRAVITY_SCALE, Limits.GRAVITY_SCALE)),

    /** Damping, 1/s, a float. */
    DAMPING(6, 0, ofFloat("damping", 0, Limits.VELOCITY_DAMPING)),

    /** Greatest speed, a float. */
    GREATEST_SPEED(
            7, Float.floatToRawIntBits(Float.POSITIVE_INFINITY), ofFloat("greatest speed", 0, Float.POSITIVE_INFINITY)),

    /** The friction of circles that have none of their own, or NaN for the world's. */
    FRICTION(8, Check.NONE, Check.orNone(Limits::friction)),

    /** The rolling resistance of circles that have none of their own, or NaN for the world's. */
    ROLLING_RESISTANCE(9, Check.NONE, Check.orNone(Limits::rollingResistance)),

    /** Speed of the surface besides that of turning, positive anticlockwise, a float. */
    BELT_SPEED(10, 0, ofFloat("belt speed", -Limits.SPEED, Limits.SPEED)),

    /** The order of {@code Inertia}. */
    INERTIA(11, 0, value -> Limits.within("inertia", value, 0, 2)),

    /** Damping of angular velocities, 1/s, a float. */
    ANGULAR_DAMPING(12, 0, ofFloat("angular damping", 0, Limits.VELOCITY_DAMPING)),

    /** 1 if circles pass pieces of terrain from behind. */
    ONE_WAY(13, 0, value -> Limits.within("one-way", value, 0, 1)),

    /** 1 if circles never fall asleep. */
    AWAKE(14, 0, value -> Limits.within("awake", value, 0, 1)),

    /** 1 if its static circles sense static circles and pieces of bodies, too. */
    SENSES_STATIC(15, 0, value -> Limits.within("senses static", value, 0, 1));

    public static final List<KindField> ALL = List.of(values());

    /** The values of all kinds. */
    public interface Values {
        int get(KindField field, int kind);

        float getFloat(KindField field, int kind);
    }

    /** What is allowed of a field. */
    private interface Check {
        Check ANY_INT = value -> {};

        /** The bits that stand for no value of a float. */
        int NONE = Float.floatToRawIntBits(Float.NaN);

        /** A float, or none. */
        static Check orNone(FloatCheck check) {
            return value -> {
                if (value != NONE) {
                    check.of(Float.intBitsToFloat(value));
                }
            };
        }

        void of(int value);
    }

    private interface FloatCheck {
        float of(float value);
    }

    private static Check ofFloat(String label, float least, float greatest) {
        return value -> Limits.within(label, Float.intBitsToFloat(value), least, greatest);
    }

    private final int number;
    private final int initial;
    private final Check check;

    /** Snapshots and the hash know the field by its number: greater than those before, and never changed. */
    KindField(int number, int initial, Check check) {
        this.number = number;
        this.initial = initial;
        this.check = check;
    }

    /** What snapshots, logs and the hash know the field by. */
    public int number() {
        return number;
    }

    /** The field of a number; null if there is none. */
    public static KindField ofNumber(int number) {
        for (int k = 0; k < ALL.size(); k++) { // an iterator would be garbage whenever a snapshot is read
            if (ALL.get(k).number == number) {
                return ALL.get(k);
            }
        }
        return null;
    }

    public int initial() {
        return initial;
    }

    /** Whether it changes velocities. */
    public boolean moves() {
        return this == GRAVITY_SCALE || this == DAMPING || this == GREATEST_SPEED;
    }

    /** Whether circles grip or carry others by it; inertia and angular damping do nothing where nothing turns. */
    public boolean grips() {
        return this == FRICTION || this == ROLLING_RESISTANCE || this == BELT_SPEED;
    }

    /** Throws {@link IllegalArgumentException} if the value is out of range. */
    public void check(int value) {
        check.of(value);
    }
}
