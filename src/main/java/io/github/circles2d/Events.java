package io.github.circles2d;

import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.events.EventRows;

/**
 * The contacts of circles, of circles and walls, and of circles and pieces of {@link Terrain}, since the last call of {@link World#events}:
 * which began, hit and ended.
 * {@link World#report} sets the types that a world reports. Contacts of circles and {@link Bodies} are in {@link BodyEvents} alone.
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
 * <p><img src="doc-files/contact.svg" alt="Two circles that overlap: the normal points from a to b, friction acts across it, and the depth is how far they overlap">
 *
 * <p><b>Touching:</b> a pair touches after a step if an impulse acted between the two within it, or if their surfaces met or
 * overlapped at the start or the end of a sub-step. It {@link #BEGIN begins} if it did not touch after the step before. It {@link #END
 * ends} with the first step in which nothing of that happens, and after which the gap is more than 0.5 % of the sum of the radii (at a
 * wall: of the diameter). So a pile at rest is silent. Two static circles never touch, unless they sense each other ({@link Kind#setSensesStatic}), nor do circles that ignore each other by their
 * kinds or groups ({@link Kind}). If a circle is added at a place where it touches another, the pair begins with the next step. If a
 * circle is moved away or removed, its pairs end with the next step, those of a removed one under its old handle. In a crowd, where
 * circles have more than 60 others near them, only the pairs that World solves count.
 *
 * <p><b>Sensors:</b> two circles that only sense each other ({@link Kind#setSensor}, {@link Response#SENSE}) begin and end, and never hit. They
 * touch in a step if they do so at any time in it, on straight paths from their places at its start to those at its end. So a bullet
 * that flies right through a small sensor in a step begins in this step, and ends in the next. The numbers of a begin are those of the
 * moment when the two first touch in the step. The speed is that at which they approach, by their paths; the impulse is 0. A circle
 * that {@link World#teleport} moves touches nothing on its way, nor does one that is not static and that {@link World#setPosition}
 * moves. A sensor notices all circles of a crowd. A sensor at a wall has the events of any circle at a wall.
 *
 * <p><b>Terrain:</b> a circle and a piece are a pair, as a circle and a wall are, with the gap of a wall. Who rolls along a chain ends with
 * one piece and begins with the next. A piece that moves with its body counts as a wall that moves does. A piece that only senses a circle
 * notices it as a sensor does. A line of a chain, an arc and a one-way segment notice who comes from their free side alone: who was wholly there
 * when it last did not touch them. So a pass from there begins once, at any speed, and a pass from behind never. If a piece is removed, its pairs end with the next
 * step, under its old handle. Static circles touch no terrain, unless they sense a piece of a body ({@link Kind#setSensesStatic}).
 *
 * <p><b>Kinds decide</b> which pairs are reported: {@link World#report(int)} asks for all pairs, {@link World#report(int, int, int)} for
 * those of two kinds, and {@link World#reportWalls} for walls and the circles of a kind. A piece of terrain has a kind, too. A pair of which no type is reported is not
 * followed: it ends in silence if its circles get such kinds, and begins if it touches when it is reported again.
 *
 * <p><b>Hits:</b> a pair {@link #HIT hits} if an impulse acted and its approach speed is at least {@link World#setHitSpeed}, whether
 * or not it touched before. If a step leaves a hit half done, the next step finishes and reports it, once. So a hit may come a step after
 * its begin.
 *
 * <p><b>Exact meaning:</b> {@link #speed} is the greatest approach speed of the sub-steps in which the pair touched, along the normal,
 * from the velocities before any impulse of the sub-step. {@link #slipSpeed} is the speed of their surfaces along each other in that
 * sub-step, from the velocities and the turning before any impulse, and from belts. {@link #impulse} is the sum of all impulses of the
 * steps of the hit, those included that carry a load. If nothing else acts on the two, it is the change of their momentum, up to rounding for a bounce,
 * and up to one part in 64 for a circle that sticks. An impulse that acts after a hit has been reported is in no event. A hit of a wall
 * has the same numbers; the speed is relative to a wall that moves. A fast circle stops where it touches, and bounces in the next step:
 * so it may begin, with speed and impulse 0, a step before it hits. For damage, take hits; for damage at any speed, set a hit speed of 0.
 *
 * <p><b>Removed circles:</b> a circle may be in several events. If a game removes circles while it reads, later events name them by
 * stale handles: {@link World#contains} is false for these. It is false for the 0 of a wall or piece, too.
 *
 * <p><b>Order:</b> step, lower id, higher id (walls after circles, pieces after walls by their ids), then begin, hit, end. Events of a removed circle come before those
 * of a circle that has its id now. The events and their order are the same on every back end, device and number of threads.
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

    /** {@return the number of events, at least 0} */
    public int size() {
        return rows.size();
    }

    /**
     * The type of an event.
     *
     * @param event its number, from 0 on
     * @return {@link #BEGIN}, {@link #HIT} or {@link #END}
     * @throws IndexOutOfBoundsException if there is no such event
     */
    public int type(int event) {
        return rows.type(event);
    }

    /**
     * The step of an event.
     *
     * @param event its number, from 0 on
     * @return the number of the step: 0 for the first step since the call of {@link World#events} before, or since the request that was
     *     taken; 2^31 - 1 for that step and all later ones
     * @throws IndexOutOfBoundsException if there is no such event
     */
    public int step(int event) {
        return rows.step(event);
    }

    /**
     * The circle of lower id, or the circle at a wall.
     *
     * @param event its number, from 0 on
     * @return its handle; stale if the circle has been removed
     * @throws IndexOutOfBoundsException if there is no such event
     */
    public long a(int event) {
        return rows.a(event);
    }

    /**
     * The circle of higher id.
     *
     * @param event its number, from 0 on
     * @return its handle; stale if the circle has been removed; 0 for a wall and for a piece of terrain
     * @throws IndexOutOfBoundsException if there is no such event
     */
    public long b(int event) {
        return rows.b(event);
    }

    /**
     * The other circle of an event, for who asks about one circle.
     *
     * @param event its number, from 0 on
     * @param circle the handle of one of its circles
     * @return the handle of the other one; stale if the circle has been removed; 0 for a wall and for a piece of terrain
     * @throws IllegalArgumentException if the circle is none of the event's
     * @throws IndexOutOfBoundsException if there is no such event
     */
    public long other(int event, long circle) {
        long a = rows.a(event);
        long b = rows.b(event);
        if (circle != a && (circle != b || b == 0)) {
            throw new IllegalArgumentException("the circle with the handle " + circle + " is not in the event " + event
                    + ", but must be " + a + (b == 0 ? "" : " or " + b));
        }
        return circle == a ? b : a;
    }

    /**
     * The piece of terrain.
     *
     * @param event its number, from 0 on
     * @return its handle; stale if the piece has been removed; 0 if there are two circles, or a wall
     * @throws IndexOutOfBoundsException if there is no such event
     */
    public long piece(int event) {
        return rows.piece(event);
    }

    /**
     * The wall.
     *
     * @param event its number, from 0 on
     * @return which; null if there are two circles, or a piece of terrain
     * @throws IndexOutOfBoundsException if there is no such event
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
     * @throws IndexOutOfBoundsException if there is no such event
     */
    public float speed(int event) {
        return rows.speed(event);
    }

    /**
     * How fast the surfaces slid along each other when they approached fastest, for the sound of a hit.
     *
     * @param event its number, from 0 on
     * @return lengths per second, at least 0; 0 for an end, and if one of the two has no friction ({@link Kind#setFriction})
     * @throws IndexOutOfBoundsException if there is no such event
     */
    public float slipSpeed(int event) {
        return rows.slipSpeed(event);
    }

    /**
     * The sum of the impulses by which the two pushed each other.
     *
     * @param event its number, from 0 on
     * @return an impulse, mass times length per second, at least 0; 0 for an end
     * @throws IndexOutOfBoundsException if there is no such event
     */
    public float impulse(int event) {
        return rows.impulse(event);
    }

    /**
     * The place: half-way between the surfaces when they approached fastest. If the place after the step is the same within 0.5 % of the
     * sum of the radii, it is that one.
     *
     * @param event its number, from 0 on
     * @return x; 0 for an end
     * @throws IndexOutOfBoundsException if there is no such event
     */
    public float x(int event) {
        return rows.x(event);
    }

    /**
     * The place; see {@link #x}.
     *
     * @param event its number, from 0 on
     * @return y; 0 for an end
     * @throws IndexOutOfBoundsException if there is no such event
     */
    public float y(int event) {
        return rows.y(event);
    }

    /**
     * The direction from circle a to circle b, to the wall or to the piece.
     *
     * @param event its number, from 0 on
     * @return x of a unit vector; 0 for an end
     * @throws IndexOutOfBoundsException if there is no such event
     */
    public float normalX(int event) {
        return rows.normalX(event);
    }

    /**
     * The direction; see {@link #normalX}.
     *
     * @param event its number, from 0 on
     * @return y of a unit vector; 0 for an end
     * @throws IndexOutOfBoundsException if there is no such event
     */
    public float normalY(int event) {
        return rows.normalY(event);
    }
}
