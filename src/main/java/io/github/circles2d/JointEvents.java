package io.github.circles2d;

import io.github.circles2d.world.joints.GoneJoints;

/**
 * The joints that went by themselves since the last call of {@link Joints#events}: since they broke, or with what they held. Calls that remove
 * joints are in none.
 *
 * <pre>{@code
 * joints.report(true);
 * world.step(1 / 60f);
 * JointEvents gone = joints.events();
 * for (int i = 0; i < gone.size(); i++) {
 *     if (gone.reason(i) == JointEvents.Reason.BROKEN) {
 *         snap(gone.circle(i), gone.force(i));
 *     }
 * }
 * }</pre>
 *
 * <p><b>Order:</b> of the steps and calls, and in a step, or of a circle or body, of the ids of the joints. It is the same on every back end and
 * device.
 *
 * <p>There is one object per world, which each call of {@link Joints#events} fills again; steps do not touch it. Reading it makes no garbage.
 */
public final class JointEvents {
    /** Why a joint went. */
    public enum Reason {
        /** Its force or its torque was too great in a step. */
        BROKEN,

        /** A circle of it was removed. */
        CIRCLE_REMOVED,

        /** The body of terrain of its anchor, or another body that it held, was removed. */
        BODY_REMOVED
    }

    private static final Reason[] REASONS = Reason.values();

    private final GoneJoints rows = new GoneJoints();

    JointEvents() {}

    GoneJoints rows() {
        return rows;
    }

    /** {@return the number of events, at least 0} */
    public int size() {
        return rows.count();
    }

    /**
     * The joint.
     *
     * @param event its number, from 0 on
     * @return its handle, which is stale
     * @throws IndexOutOfBoundsException if there is no such event
     */
    public long joint(int event) {
        return rows.joint(event);
    }

    /**
     * The first circle or body of the joint.
     *
     * @param event its number, from 0 on
     * @return its handle; stale if the circle or body has been removed
     * @throws IndexOutOfBoundsException if there is no such event
     */
    public long circle(int event) {
        return rows.circle(event);
    }

    /**
     * The other circle or body of the joint.
     *
     * @param event its number, from 0 on
     * @return its handle; stale if the circle or body has been removed; 0 if the joint held one alone
     * @throws IndexOutOfBoundsException if there is no such event
     */
    public long other(int event) {
        return rows.other(event);
    }

    /**
     * The force by which the joint broke.
     *
     * @param event its number, from 0 on
     * @return the mean force of the step, at least 0; 0 if it did not break
     * @throws IndexOutOfBoundsException if there is no such event
     */
    public float force(int event) {
        return rows.force(event);
    }

    /**
     * The torque by which the joint broke.
     *
     * @param event its number, from 0 on
     * @return the mean torque of the step on the first circle; 0 if it did not break
     * @throws IndexOutOfBoundsException if there is no such event
     */
    public float torque(int event) {
        return rows.torque(event);
    }

    /**
     * Why the joint went.
     *
     * @param event its number, from 0 on
     * @return the reason
     * @throws IndexOutOfBoundsException if there is no such event
     */
    public Reason reason(int event) {
        return REASONS[rows.reason(event)];
    }
}
