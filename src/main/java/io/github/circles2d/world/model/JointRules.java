package io.github.circles2d.world.model;

/** The forms that joints have, and the values that they take. */
public final class JointRules {
    public static final int JOINTS = 1 << 20;

    /** Hertz. */
    public static final float FREQUENCY = 1e4f;

    public static final float DAMPING_RATIO = 1e3f;

    /** More than any two ends are apart. */
    public static final float LENGTH = 4e9f;

    private static final int DETAILS =
            JointRow.RIGID | JointRow.ELASTIC | JointRow.LOWER | JointRow.UPPER | JointRow.ACROSS;
    private static final int ALL = JointRow.LINEAR | DETAILS | JointRow.ANGULAR | JointRow.COLLIDE | JointRow.BREAKABLE;

    private JointRules() {}

    /** Whether some joint has a form. */
    public static boolean isForm(int form) {
        int details = form & DETAILS;
        int angular = form & JointRow.ANGULAR;
        boolean fits =
                switch (form & JointRow.LINEAR) {
                    case JointRow.AXIAL -> isAxial(details, angular);
                    case JointRow.POINT -> (details == JointRow.RIGID || details == JointRow.ELASTIC) && angular == 0;
                    case JointRow.DRAG -> details == 0 && angular == JointRow.TURN_SPEED;
                    default ->
                        angular == JointRow.TURN_SPEED && details == 0
                                || angular == JointRow.TURN_ANGLE && details == JointRow.ELASTIC;
                };
        return fits && (form & ~ALL) == 0;
    }

    private static boolean isAxial(int details, int angular) {
        if ((details & JointRow.ACROSS) != 0) {
            return details == (JointRow.RIGID | JointRow.ACROSS) && angular == JointRow.TURN_RIGID;
        }
        return angular == 0 && (details == JointRow.RIGID || (details & JointRow.RIGID) == 0);
    }

    /** Whether a form may hold two circles. */
    public static boolean takesCircles(int form) {
        int linear = form & JointRow.LINEAR;
        return linear != JointRow.POINT && linear != JointRow.DRAG;
    }

    /** Whether a form may hold a circle to a place. */
    public static boolean takesAnchor(int form) {
        int linear = form & JointRow.LINEAR;
        return linear == JointRow.POINT || linear == JointRow.AXIAL && (form & JointRow.ACROSS) == 0;
    }

    /** Whether a form may hold a circle to the world, without a place. */
    public static boolean takesNothing(int form) {
        int linear = form & JointRow.LINEAR;
        return linear == 0 || linear == JointRow.DRAG;
    }

    /** Whether a form concerns how circles turn. */
    public static boolean turns(int form) {
        return (form & (JointRow.ANGULAR | JointRow.ACROSS)) != 0;
    }
}
