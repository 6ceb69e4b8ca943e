package io.github.circles2d.world.joints;

import io.github.circles2d.world.model.JointRow;
import io.github.circles2d.world.model.JointRules;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.model.Surface;

/** What can be set of a joint, by one or two values; 0 for those that it does not have. */
public enum JointSetting {
    /** x and y: of the world, or of the body of terrain. */
    ANCHOR(1),

    LENGTH(2),

    /** The least length, and the greatest one, which may be infinite. */
    LIMITS(3),

    /** Hertz and damping ratio. */
    SPRING(4),

    /** Radians per second. */
    SPEED(5),

    /** Radians. */
    ANGLE(6),

    MAX_FORCE(7),

    MAX_TORQUE(8),

    /** The force and the torque. */
    BREAKING(9),

    /** 1 or 0. */
    COLLIDING(10);

    private static final JointSetting[] BY_NUMBER = new JointSetting[11];

    static {
        for (JointSetting setting : values()) {
            BY_NUMBER[setting.number] = setting;
        }
    }

    /** In logs: never changed. */
    public final int number;

    JointSetting(int number) {
        this.number = number;
    }

    /** Null if there is none. */
    public static JointSetting of(int number) {
        return number >= 0 && number < BY_NUMBER.length ? BY_NUMBER[number] : null;
    }

    /** In units. */
    static int angle(float radians) {
        return Surface.units(radians);
    }

    /** Refuses values that are out of range, and joints that do not have this. */
    void check(int form, float a, float b) {
        switch (this) {
            case ANCHOR -> {
                require(JointRules.takesAnchor(form), form, "anchor");
                Limits.within("x", a, -Limits.COORDINATE, Limits.COORDINATE);
                Limits.within("y", b, -Limits.COORDINATE, Limits.COORDINATE);
            }
            case LENGTH -> {
                boolean has = JointForm.kind(form) == JointForm.DISTANCE || JointForm.kind(form) == JointForm.SPRING;
                require(has, form, "length to set");
                Limits.within("the length", a, 0f, Limits.COORDINATE);
            }
            case LIMITS -> {
                boolean has = JointForm.kind(form) == JointForm.LIMITS || JointForm.kind(form) == JointForm.SPRING;
                require(has, form, "limits");
                Limits.within("the greatest length", b, 0f, Float.POSITIVE_INFINITY);
                Limits.within("the least length", a, 0f, Limits.COORDINATE);
                if (a > b) {
                    throw new IllegalArgumentException(
                            "the least length is " + a + ", but must be at most the greatest length, " + b);
                }
            }
            case SPRING -> {
                require(JointForm.has(form, JointRow.ELASTIC), form, "spring");
                Limits.within("the frequency", a, 0f, JointRules.FREQUENCY);
                Limits.within("the damping ratio", b, 0f, JointRules.DAMPING_RATIO);
            }
            case SPEED -> {
                require(JointForm.kind(form) == JointForm.MOTOR, form, "speed");
                Limits.within("the speed", a, -Limits.ANGULAR_VELOCITY, Limits.ANGULAR_VELOCITY);
            }
            case ANGLE -> {
                require(JointForm.kind(form) == JointForm.SERVO, form, "angle");
                Limits.within("the angle", a, -Limits.ANGLE, Limits.ANGLE);
            }
            case MAX_FORCE -> {
                boolean has = JointForm.kind(form) == JointForm.PIN || JointForm.kind(form) == JointForm.FRICTION;
                require(has, form, "greatest force");
                notNegative("the greatest force", a);
            }
            case MAX_TORQUE -> {
                boolean has = JointRules.turns(form) && JointForm.kind(form) != JointForm.WELD;
                require(has, form, "greatest torque");
                notNegative("the greatest torque", a);
            }
            case BREAKING -> {
                notNegative("the force that breaks it", a);
                notNegative("the torque that breaks it", b);
            }
            case COLLIDING -> Limits.within("whether circles collide", a, 0f, 1f);
        }
    }

    static void require(boolean has, int form, String what) {
        if (!has) {
            throw new IllegalArgumentException("a " + JointForm.name(form) + " has no " + what);
        }
    }

    private static void notNegative(String what, float value) {
        Limits.within(what, value, 0f, Float.POSITIVE_INFINITY);
    }

    /** The form of a joint whose values have been checked. */
    int traits(int form, float a, float b) {
        return switch (this) {
            case LIMITS -> with(with(form, JointRow.LOWER, a > 0f), JointRow.UPPER, b < Float.POSITIVE_INFINITY);
            case BREAKING -> with(form, JointRow.BREAKABLE, a < Float.POSITIVE_INFINITY || b < Float.POSITIVE_INFINITY);
            case COLLIDING -> with(form, JointRow.COLLIDE, a != 0f);
            default -> form;
        };
    }

    private static int with(int form, int flag, boolean set) {
        return set ? form | flag : form & ~flag;
    }

    /** Writes the values into a row, as {@link JointRow}. There is one zero. Returns whether they are other ones than there were. */
    boolean write(float[] rows, int row, float a, float b) {
        return switch (this) {
            case LENGTH -> write(rows, row + JointRow.LENGTH, a);
            case LIMITS -> write(rows, row + JointRow.MIN_LENGTH, a) | write(rows, row + JointRow.MAX_LENGTH, b);
            case SPEED -> write(rows, row + JointRow.SPEED, a);
            case MAX_FORCE -> write(rows, row + JointRow.MAX_FORCE, a);
            case MAX_TORQUE -> write(rows, row + JointRow.MAX_TORQUE, a);
            case BREAKING -> write(rows, row + JointRow.BREAK_FORCE, a) | write(rows, row + JointRow.BREAK_TORQUE, b);
            default -> false; // it is elsewhere
        };
    }

    private static boolean write(float[] rows, int at, float value) {
        boolean changes = rows[at] != value;
        rows[at] = value + 0f;
        return changes;
    }
}
