package io.github.circles2d.world.joints;

import io.github.circles2d.world.model.JointRow;

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
        boolean axial = (traits & JointRow.LINEAR) == JointRow.AXIAL;
        row[JointRow.LENGTH] = axial && has(traits, JointRow.RIGID | JointRow.ELASTIC) ? Float.NaN : 0f;
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

    /** For people: what it can hold a circle to. */
    String place() {
        if (takesAnchor(traits)) {
            return takesCircles(traits) ? "another one or to an anchor" : "an anchor";
        }
        return !takesCircles(traits)
                ? "the world"
                : takesNothing(traits) ? "another one or to the world" : "another one";
    }

    // ---- by {@link JointRow#FORM}
    // -----------------------------------------------------------------------------------------

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

    /** Whether it concerns how circles turn. */
    static boolean turns(int traits) {
        return has(traits, JointRow.ANGULAR | JointRow.ACROSS);
    }

    /** Whether it has a place if it holds a circle to none. */
    static boolean takesAnchor(int traits) {
        int linear = traits & JointRow.LINEAR;
        return linear == JointRow.POINT || linear == JointRow.AXIAL && !has(traits, JointRow.ACROSS);
    }

    /** Whether it may hold two circles. */
    static boolean takesCircles(int traits) {
        int linear = traits & JointRow.LINEAR;
        return linear != JointRow.POINT && linear != JointRow.DRAG;
    }

    /** Whether it may hold a circle to the world without a place. */
    static boolean takesNothing(int traits) {
        return !takesAnchor(traits) && !has(traits, JointRow.ACROSS);
    }
}
