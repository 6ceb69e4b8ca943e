package io.github.circles2d.world.joints;

import static java.lang.Float.intBitsToFloat;

import io.github.circles2d.world.model.JointRow;
import io.github.circles2d.world.model.JointRules;
import io.github.circles2d.world.model.Limits;

/** What a joint does, whatever it holds. */
public final class JointForm {
    // what callers call it
    public static final int DISTANCE = 0;
    public static final int SPRING = 1;
    public static final int LIMITS = 2;
    public static final int PIN = 3;
    public static final int MOTOR = 4;
    public static final int SERVO = 5;
    public static final int FRICTION = 6;
    public static final int WELD = 7;

    // in a log: the traits, numbers of JointRow from the length to the torque that breaks it, and these
    private static final int FREQUENCY = 9;
    private static final int DAMPING_RATIO = 10;
    private static final int ANGLE = 11;

    /** Ints in a log. */
    public static final int WORDS = 12;

    private static final String[] NAMES = {
        "distance joint", "spring", "joint with limits", "pin", "motor", "servo", "friction joint", "weld"
    };

    /** {@link JointRow#FORM} */
    int traits;

    /** As {@link JointRow}; a length that is NaN is that of the ends when the joint comes. */
    final float[] row = new float[JointRow.STRIDE];

    /** Hertz; of a spring. */
    float frequency;

    float dampingRatio;

    /** Of a servo, in units of an angle. */
    int angle;

    /** Without limits of forces; it never breaks, and its length is that of the ends when it comes. */
    public JointForm(int traits) {
        this.traits = traits;
        row[JointRow.LENGTH] = isAxial(traits) && has(traits, JointRow.RIGID | JointRow.ELASTIC) ? Float.NaN : 0f;
        row[JointRow.MAX_LENGTH] = Float.POSITIVE_INFINITY;
        row[JointRow.MAX_FORCE] = Float.POSITIVE_INFINITY;
        row[JointRow.MAX_TORQUE] = Float.POSITIVE_INFINITY;
        row[JointRow.BREAK_FORCE] = Float.POSITIVE_INFINITY;
        row[JointRow.BREAK_TORQUE] = Float.POSITIVE_INFINITY;
    }

    public JointForm copy() {
        JointForm copy = new JointForm(traits);
        System.arraycopy(row, 0, copy.row, 0, row.length);
        copy.frequency = frequency;
        copy.dampingRatio = dampingRatio;
        copy.angle = angle;
        return copy;
    }

    /** Changes it, and returns it; checks the values. */
    public JointForm set(JointSetting setting, float a, float b) {
        setting.check(traits, a, b);
        traits = setting.traits(traits, a, b);
        setting.write(row, 0, a, b);
        if (setting == JointSetting.SPRING) {
            frequency = a + 0f;
            dampingRatio = b + 0f;
        } else if (setting == JointSetting.ANGLE) {
            angle = JointSetting.angle(a);
        }
        return this;
    }

    public int traits() {
        return traits;
    }

    /** A row of {@link JointRow}. */
    public float value(int which) {
        return row[which];
    }

    public float frequency() {
        return frequency;
    }

    public float dampingRatio() {
        return dampingRatio;
    }

    /** In units. */
    public int angle() {
        return angle;
    }

    public int kind() {
        return kind(traits);
    }

    // ---- in logs

    /** An int of the form in a log. */
    public int word(int k) {
        return switch (k) {
            case 0 -> traits;
            case FREQUENCY -> Float.floatToRawIntBits(frequency);
            case DAMPING_RATIO -> Float.floatToRawIntBits(dampingRatio);
            case ANGLE -> angle;
            default -> Float.floatToRawIntBits(row[JointRow.LENGTH + k - 1]);
        };
    }

    /** The form that ints of a log make, whose values are checked; null if there is no such form. */
    public static JointForm of(int[] words) {
        int traits = words[0];
        if (!JointRules.isForm(traits)) {
            return null;
        }
        JointForm form = new JointForm(traits & ~(JointRow.LOWER | JointRow.UPPER | JointRow.BREAKABLE));
        int kind = form.kind();
        float length = value(words, JointRow.LENGTH);
        if (Float.isNaN(form.row[JointRow.LENGTH]) && !Float.isNaN(length)) {
            form.row[JointRow.LENGTH] = Limits.within("the length", length, 0f, JointRules.LENGTH) + 0f;
        }
        if (kind == LIMITS || kind == SPRING) {
            form.set(JointSetting.LIMITS, value(words, JointRow.MIN_LENGTH), value(words, JointRow.MAX_LENGTH));
        }
        if (form.springs()) {
            form.set(JointSetting.SPRING, intBitsToFloat(words[FREQUENCY]), intBitsToFloat(words[DAMPING_RATIO]));
        }
        if (kind == MOTOR) {
            form.set(JointSetting.SPEED, value(words, JointRow.SPEED), 0);
        }
        if (kind == PIN || kind == FRICTION) {
            form.set(JointSetting.MAX_FORCE, value(words, JointRow.MAX_FORCE), 0);
        }
        if (JointRules.turns(traits) && kind != WELD) {
            form.set(JointSetting.MAX_TORQUE, value(words, JointRow.MAX_TORQUE), 0);
        }
        form.set(JointSetting.BREAKING, value(words, JointRow.BREAK_FORCE), value(words, JointRow.BREAK_TORQUE));
        form.angle = kind == SERVO ? words[ANGLE] : 0;
        return form.traits == traits ? form : null;
    }

    private static float value(int[] words, int which) {
        return intBitsToFloat(words[1 + which - JointRow.LENGTH]);
    }

    // ---- for people and for calls

    /** Whether it takes something from the circles as they are when it comes. */
    public boolean looks() {
        return Float.isNaN(row[JointRow.LENGTH]) || has(traits, JointRow.ACROSS);
    }

    /** Whether it has a spring. */
    public boolean springs() {
        return has(traits, JointRow.ELASTIC);
    }

    /** For people. */
    public String name() {
        return name(traits);
    }

    /** For people: what it can hold a body to, or a circle. */
    String place(boolean ofBody) {
        boolean anchor = JointRules.takesAnchor(traits);
        boolean circles = JointRules.takesCircles(traits);
        if (!anchor && !JointRules.takesNothing(traits)) {
            return ofBody ? "another body or a circle" : "another one";
        }
        String place = anchor ? "an anchor" : "the world";
        if (ofBody) {
            return anchor || circles ? "another body, a circle or " + place : place;
        }
        return circles ? "another one or to " + place : place;
    }

    // ---- by {@link JointRow#FORM}

    /** One of the numbers above. */
    static int kind(int traits) {
        switch (traits & JointRow.LINEAR) {
            case JointRow.AXIAL -> {
                if (has(traits, JointRow.ACROSS)) {
                    return WELD;
                }
                return has(traits, JointRow.RIGID) ? DISTANCE : has(traits, JointRow.ELASTIC) ? SPRING : LIMITS;
            }
            case JointRow.POINT -> {
                return PIN;
            }
            case JointRow.DRAG -> {
                return FRICTION;
            }
            default -> {
                return (traits & JointRow.ANGULAR) == JointRow.TURN_SPEED ? MOTOR : SERVO;
            }
        }
    }

    /** For people. */
    public static String name(int traits) {
        return NAMES[kind(traits)];
    }

    static boolean has(int traits, int flag) {
        return (traits & flag) != 0;
    }

    /** Whether it acts along the line between its ends. */
    public static boolean isAxial(int traits) {
        return (traits & JointRow.LINEAR) == JointRow.AXIAL;
    }
}
