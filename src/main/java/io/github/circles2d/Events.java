package io.github.circles2d;

import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.events.EventRows;

/**
 * What happened between circles, and between circles and walls, since the last call of {@link World#events}. {@link World#report} says
 * what of it is told.
 *
 * <pre>{@code
 * world.report(Events.BEGIN | Events.HIT);
 * world.step(1 / 60f);
 * Events events = world.events();
 * for (int i = 0; i < events.size(); i++) {
 *     if (events.type(i) == Events.HIT && events.speed(i) > 5) {
 *         crack(events.a(i), events.b(i), events.x(i), events.y(i));
 *     }
 * }
 * }</pre>
 *
 * <p><b>Touching:</b> a pair touches after a step if an impulse acted between the two within it, or if their surfaces met or
 * overlapped at the start or the end of a sub-step. It {@link #BEGIN begins} if it did not touch after the step before. It goes on
 * touching until a step in which nothing of that happens ends with a gap of more than 0.5 % of the sum of the radii (at a wall:
 * of the diameter); then it {@link #END ends}. So a pile at rest is silent. Two static circles never touch, nor do circles that ignore
 * each other by their kinds or groups ({@link Kind}). A circle that is added where it touches another begins with the next
 * step. A circle that is moved away, or removed, ends with the next step, a removed one under its old handle. In a crowd, where a
 * circle has more than some thirty neighbours, only the pairs that World solves count.
 *
 * <p><b>Sensors:</b> two circles that only sense each other ({@link Kind#setSensor}, {@link Response#SENSE}) begin and end, and never hit. They
 * touch in a step if they do so at any time in it, on straight paths from where they were at its start to where they are at its end. So a bullet
 * that flies right through a small sensor in a step begins in this step, and ends in the next. The numbers of a begin are those of the
 * moment when they first touch in the step; the speed is that at which the two approach, by their paths, and the impulse is 0. A circle
 * that is moved by {@link World#teleport}, or one that is not static by {@link World#setPosition}, touches nothing on its way. A crowd
 * hides nothing from a sensor. Between a sensor and a wall there are the events of any circle at a wall.
 *
 * <p><b>Which pairs</b> are told of, kinds decide: {@link World#report(int)} asks for all pairs, {@link World#report(int, int, int)} for those
 * of two kinds, and {@link World#reportWalls} for walls and the circles of a kind. A pair of which nothing is reported is not followed: it
 * ends in silence if its circles get such kinds, and begins if it touches when it is reported again.
 *
 * <p><b>Hits:</b> a pair {@link #HIT hits} if an impulse acted and its approach speed is at least {@link World#setHitSpeed}, whether
 * or not it touched before. A hit that a step leaves half done is finished by the next step, and reported there, once: so it may
 * come a step after its begin.
 *
 * <p><b>What is exact:</b> {@link #speed} is the greatest approach speed of the sub-steps in which the pair touched, along the normal,
 * from the velocities before any impulse of the sub-step. {@link #impulse} is the sum of all impulses of the steps of the hit, those
 * included that carry a load. If nothing else acts on the two, it is the change of their momentum, up to rounding for a bounce,
 * and up to one part in 64 for a circle that sticks. An impulse that acts after a hit has been reported is in no event. A wall that is
 * hit has the same numbers; the speed is relative to a wall that moves. A circle that is fast stops where it touches, and bounces in the next step: it may begin, with speed
 * and impulse 0, a step before it hits. For damage, take hits; for damage at any speed, set a hit speed of 0.
 *
 * <p><b>Circles that are gone:</b> the list is of what happened, so a circle may be in several events, and a game that removes circles
 * while it reads finds them again under stale handles: {@link World#contains} tells. It is false for the 0 of a wall too.
 *
 * <p><b>Order:</b> step, lower id, higher id (walls after circles), then begin, hit, end. Events of a removed circle come before those
 * of one that has its id now. The events and their order are the same on every back end, device and number of threads.
 *
 * <p>There is one object per world, which each call of {@link World#events} and {@link World#takeEvents} fills again; steps do not touch it. Reading it makes
 * no garbage.
 */
public final class Events {
    /** Type: two surfaces begin to touch. */
    public static final int BEGIN = ContactEvents.BEGIN;

    /** Type: two surfaces hit each other. */
    public static final int HIT = ContactEvents.HIT;

    /** Type: two surfaces do not touch any more. Such an event has neither numbers nor a place. */
    public static final int END = ContactEvents.END;

    /** Not a type: for {@link World#report}, to report walls too. */
    public static final int WALL = ContactEvents.WALL;

    /** A wall. */
    public enum Side {
        /** The left wall. */
        LEFT,
        /** The right wall. */
        RIGHT,
        /** The lower wall. */
        LOWER,
        /** The upper wall. */
        UPPER
    }

    private static final Side[] SIDES = Side.values();

    private EventRows rows = new EventRows();

    Events() {}

    Events of(EventRows taken) {
        rows = taken;
        return this;
    }

    EventRows rows() {
        return rows;
    }

    /**
     * The number of events.
     *
     * @return at least 0
     */
    public int size() {
        return rows.size();
    }

    /**
     * What happened.
     *
     * @param event its number, from 0 on
     * @return {@link #BEGIN}, {@link #HIT} or {@link #END}
     */
    public int type(int event) {
        return rows.type(event);
    }

    /**
     * When it happened.
     *
     * @param event its number, from 0 on
     * @return the number of the step: 0 for the first since {@link World#events} was called before, or since the request that was taken;
     *     2^31 - 1 for that step and all later ones
     */
    public int step(int event) {
        return rows.step(event);
    }

    /**
     * The circle of lower id, or the circle at a wall.
     *
     * @param event its number, from 0 on
     * @return its handle; stale if the circle has been removed
     */
    public long a(int event) {
        return rows.a(event);
    }

    /**
     * The circle of higher id.
     *
     * @param event its number, from 0 on
     * @return its handle; stale if the circle has been removed; 0 for a wall
     */
    public long b(int event) {
        return rows.b(event);
    }

    /**
     * The wall.
     *
     * @param event its number, from 0 on
     * @return which; null if there are two circles
     */
    public Side side(int event) {
        int side = rows.side(event);
        return side < 0 ? null : SIDES[side];
    }

    /**
     * How fast the two approached each other along the normal.
     *
     * @param event its number, from 0 on
     * @return lengths per second, at least 0; 0 for an end
     */
    public float speed(int event) {
        return rows.speed(event);
    }

    /**
     * By how much the two pushed each other in all.
     *
     * @param event its number, from 0 on
     * @return an impulse, mass times length per second, at least 0; 0 for an end
     */
    public float impulse(int event) {
        return rows.impulse(event);
    }

    /**
     * The place: half-way between the surfaces when they approached fastest, or after the step, if that is the same within 0.5 % of the
     * sum of the radii.
     *
     * @param event its number, from 0 on
     * @return x; 0 for an end
     */
    public float x(int event) {
        return rows.x(event);
    }

    /**
     * The place; see {@link #x}.
     *
     * @param event its number, from 0 on
     * @return y; 0 for an end
     */
    public float y(int event) {
        return rows.y(event);
    }

    /**
     * The direction from circle a to circle b, or to the wall.
     *
     * @param event its number, from 0 on
     * @return x of a unit vector; 0 for an end
     */
    public float normalX(int event) {
        return rows.normalX(event);
    }

    /**
     * The direction; see {@link #normalX}.
     *
     * @param event its number, from 0 on
     * @return y of a unit vector; 0 for an end
     */
    public float normalY(int event) {
        return rows.normalY(event);
    }
}
