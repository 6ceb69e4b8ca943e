package io.github.circles2d.world.joints;

import io.github.circles2d.world.bodies.OutlineShape;
import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.model.JointRules;
import io.github.circles2d.world.model.Limits;

/** Which joints there can be. */
public final class JointLimits {
    /** How far a point of a body is from its centroid at most, along each axis, by the reach of its outline. */
    private static final float POINT_REACH = 100f;

    private JointLimits() {}

    /** Of two circles. */
    public static void circles(JointForm form, int a, int b, HandleTable handles) {
        circles(form);
        if (a == b) {
            throw new IllegalArgumentException(
                    "both circles have the handle " + handles.handle(a) + ", but a joint holds two different ones");
        }
        if (handles.isStatic(a) && handles.isStatic(b)) {
            throw new IllegalArgumentException("the circles with the handles " + handles.handle(a) + " and "
                    + handles.handle(b) + " are both static, but one of them must move");
        }
    }

    /** Of two circles, whichever they are. */
    public static void circles(JointForm form) {
        if (!JointRules.takesCircles(form.traits)) {
            throw new IllegalArgumentException(
                    "a " + form.name() + " cannot hold two circles, but must hold one to " + form.place(false));
        }
    }

    /** Of two things, of which one is a body that is pushed. */
    public static void things(JointForm form) {
        if (JointRules.takesNothing(form.traits) && !JointRules.takesCircles(form.traits)) {
            throw new IllegalArgumentException(
                    "a " + form.name() + " cannot hold a body to another end, but must hold it to " + form.place(true));
        }
    }

    /** Of a body that is pushed, or of a circle, and a place. */
    public static void anchor(JointForm form, boolean ofBody, float x, float y) {
        if (!JointRules.takesAnchor(form.traits)) {
            throw new IllegalArgumentException("a " + form.name() + " takes no anchor, but " + mustHold(form, ofBody));
        }
        JointSetting.ANCHOR.check(form.traits, x, y);
    }

    /** Of a body that is pushed, or of a circle, and the world, without a place. */
    public static void alone(JointForm form, boolean ofBody) {
        if (!JointRules.takesNothing(form.traits)) {
            throw new IllegalArgumentException("a " + form.name() + " " + mustHold(form, ofBody));
        }
    }

    private static String mustHold(JointForm form, boolean ofBody) {
        return "must hold " + (ofBody ? "a body to " : "a circle to ") + form.place(ofBody);
    }

    /** A point of a body that is pushed, in its coordinates. */
    public static void point(float x, float y, OutlineShape outline) {
        float most = POINT_REACH * outline.reach();
        Limits.within("x of the point on the body", x, -most, most);
        Limits.within("y of the point on the body", y, -most, most);
    }

    /** The place of a weld of a body that is pushed, in the coordinates of that. */
    static void weld(float x, float y, OutlineShape outline) {
        float most = POINT_REACH * outline.reach();
        if (!(Math.abs(x) <= most && Math.abs(y) <= most)) {
            throw new IllegalArgumentException("the middle of the weld is at " + x + ", " + y
                    + " from the centroid of a body, but must be within " + most + " along each axis");
        }
    }

    /** Refuses a circle that is static. */
    public static void moves(int a, HandleTable handles) {
        if (handles.isStatic(a)) {
            throw new IllegalArgumentException(
                    "the circle with the handle " + handles.handle(a) + " is static, but must move");
        }
    }

    /** So many more. */
    public static void room(int more, int size) {
        if (more > JointRules.JOINTS - size) {
            throw new IllegalArgumentException(
                    "a world has at most " + JointRules.JOINTS + " joints, not " + ((long) size + more));
        }
    }
}
