package io.github.circles2d;

import io.github.circles2d.world.bodies.RigidStep;
import io.github.circles2d.world.bodies.RigidTouches;

/**
 * What {@link Bodies} have begun to touch, and touch no more, since the last call of {@link Bodies#events}: other bodies, circles, pieces of terrain and
 * walls.
 *
 * <pre>{@code
 * world.bodies().report(true);
 * world.step(1 / 60f);
 * BodyEvents events = world.bodies().events();
 * for (int i = 0; i < events.size(); i++) {
 *     if (events.isBegin(i) && events.speed(i) > 3) {
 *         thud(events.x(i), events.y(i));
 *     }
 * }
 * }</pre>
 *
 * <p><b>A pair touches</b> in a step if it has pushed each other in it, at however many points. So a bounce is a begin in one step, and an end in the
 * next. A body, circle or piece that is removed ends what it touches at once.
 *
 * <p><b>Sensors:</b> a pair that only senses each other ({@link Kind#setSensor}, {@link Response#SENSE}) touches in a step if both have come together
 * in it, also if one is wholly inside the other, sleeps, or flies right through: then it begins in this step, and ends in the next. Both go
 * evenly from where they are as the step begins to where it leaves them. The impulse is 0. Joints make no difference. A piece with one side (a line of
 * a chain, an arc, a one-way segment) notices who comes from its front alone, by the centroid, until they part. A pair that comes to push each other,
 * or no longer does, since kinds have changed, ends as one and begins as the other.
 *
 * <p><b>Order:</b> of the steps and calls; in a step two bodies come first, then pieces, walls and circles, in the order of ids; then, likewise, what is
 * only sensed. It is the same for any number of threads.
 *
 * <p>There is one object per world, which each call of {@link Bodies#events} fills again; steps do not touch it. Reading it makes no garbage.
 */
public final class BodyEvents {
    /** What a body touches. */
    public enum Partner {
        /** Another body. */
        BODY,

        /** A piece of {@link Terrain}. */
        PIECE,

        /** A wall of the bounds. */
        WALL,

        /** A circle. */
        CIRCLE
    }

    /** In the order of the types of {@link RigidStep}. */
    private static final Partner[] PARTNERS = Partner.values();

    private static final Wall[] WALLS = Wall.values();

    private final RigidTouches rows = new RigidTouches();

    BodyEvents() {}

    RigidTouches rows() {
        return rows;
    }

    /**
     * The number of events.
     *
     * @return at least 0
     */
    public int size() {
        return rows.count();
    }

    /**
     * Whether a touch has begun.
     *
     * @param event its number, from 0 on
     * @return false if it has ended
     * @throws IndexOutOfBoundsException if there is no such event
     */
    public boolean isBegin(int event) {
        return rows.begins(event);
    }

    /**
     * The body.
     *
     * @param event its number, from 0 on
     * @return its handle; of two bodies that of the lower id; stale if the body has been removed
     * @throws IndexOutOfBoundsException if there is no such event
     */
    public long body(int event) {
        return rows.body(event);
    }

    /**
     * What the body touches.
     *
     * @param event its number, from 0 on
     * @return what {@link #other} or {@link #wall} names
     * @throws IndexOutOfBoundsException if there is no such event
     */
    public Partner partner(int event) {
        return PARTNERS[rows.type(event)];
    }

    /**
     * The body, circle or piece that the body touches.
     *
     * @param event its number, from 0 on
     * @return its handle, stale if it has been removed; 0 if it is a wall
     * @throws IndexOutOfBoundsException if there is no such event
     */
    public long other(int event) {
        return partner(event) == Partner.WALL ? 0 : rows.other(event);
    }

    /**
     * The wall that the body touches.
     *
     * @param event its number, from 0 on
     * @return the wall; null if it is none
     * @throws IndexOutOfBoundsException if there is no such event
     */
    public Wall wall(int event) {
        return partner(event) == Partner.WALL ? WALLS[(int) rows.other(event)] : null;
    }

    /**
     * Where a pair has begun to touch: of several points that which is pressed most; of what is sensed the point of the body that is nearest to the
     * other. If they overlap as the step begins, it is only near.
     *
     * @param event its number, from 0 on
     * @return x of the point; 0 of an end
     * @throws IndexOutOfBoundsException if there is no such event
     */
    public float x(int event) {
        return rows.value(event, RigidStep.TOUCH_X);
    }

    /**
     * Where a pair has begun to touch; see {@link #x}.
     *
     * @param event its number, from 0 on
     * @return y of the point; 0 of an end
     * @throws IndexOutOfBoundsException if there is no such event
     */
    public float y(int event) {
        return rows.value(event, RigidStep.TOUCH_Y);
    }

    /**
     * The direction from the body to what it touches, at that point.
     *
     * @param event its number, from 0 on
     * @return x of a direction of length 1; 0 of an end
     * @throws IndexOutOfBoundsException if there is no such event
     */
    public float normalX(int event) {
        return rows.value(event, RigidStep.TOUCH_NX);
    }

    /**
     * The direction from the body to what it touches; see {@link #normalX}.
     *
     * @param event its number, from 0 on
     * @return y of a direction of length 1; 0 of an end
     * @throws IndexOutOfBoundsException if there is no such event
     */
    public float normalY(int event) {
        return rows.value(event, RigidStep.TOUCH_NY);
    }

    /**
     * How hard the pair pushed at that point, the greatest impulse in a sub-step.
     *
     * @param event its number, from 0 on
     * @return mass times velocity, more than 0; 0 of an end, and of what is only sensed
     * @throws IndexOutOfBoundsException if there is no such event
     */
    public float impulse(int event) {
        return rows.value(event, RigidStep.TOUCH_IMPULSE);
    }

    /**
     * How fast the pair approached at that point.
     *
     * @param event its number, from 0 on
     * @return lengths per second, at least 0; 0 of an end
     * @throws IndexOutOfBoundsException if there is no such event
     */
    public float speed(int event) {
        return rows.value(event, RigidStep.TOUCH_SPEED);
    }
}
