package io.github.circles2d.reference;

import static io.github.circles2d.reference.Numbers.dot;
import static io.github.circles2d.reference.Numbers.max;
import static io.github.circles2d.reference.Numbers.min;
import static io.github.circles2d.reference.Numbers.minus;

/** Static circles that move take along what they come upon. */
final class Carrying {
    private static final float RUN_OVER = 0.75f;
    private static final float NEVER = 2f;

    private final Grid grid;

    Carrying(Grid grid) {
        this.grid = grid;
    }

    void start(Circle c) {
        c.carryTime = NEVER;
        c.carrier = null;
    }

    /** Whether a static circle moves so far that it does not leave another to their contact. */
    static boolean pushes(Circle carrier, Circle c) {
        return carrier.pathLength > Circle.CAP * c.radius;
    }

    /** The share of its path that a circle goes if nothing carries it. */
    static float freeShare(Circle c) {
        return min(c.timeOfImpact, c.contactTime);
    }

    /** A static circle that moves meets another, which goes its free share of its path and waits there. */
    void meet(Circle carrier, Circle c, boolean nearWithoutImpact) {
        float t = timeOfCarry(carrier, c);
        boolean contactHas = nearWithoutImpact || ContinuousCollision.areCloser(carrier, c, Circle.MARGIN);
        boolean carries = pushes(carrier, c) ? t <= 1f : t < 1f && !contactHas;
        if (!carries || t > c.carryTime) {
            return;
        }
        boolean first = t < c.carryTime || c.carrier == null || grid.isBefore(carrier, c.carrier);
        c.carrier = first ? carrier : c.carrier;
        c.carryTime = t;
    }

    private static float timeOfCarry(Circle carrier, Circle c) {
        float radii = carrier.radius + c.radius;
        float[] d = carrier.wayTo(c);
        float t = ContinuousCollision.timeOfImpact(d, minus(carrier.path, c.path), radii);
        float share = freeShare(c);
        if (t < share) {
            return t;
        }
        float[] waiting = {d[0] + share * c.path[0], d[1] + share * c.path[1]};
        t = max(ContinuousCollision.timeOfImpact(waiting, carrier.path, radii), share);
        if (t < 1f && isRunOver(waiting, carrier, c)) {
            return t;
        }
        boolean meets = ContinuousCollision.timeOfImpact(d, carrier.path, radii) < 1f;
        return meets && isRunOver(d, carrier, c) ? 1f : NEVER;
    }

    /** Whether a circle at d from where the carrier began is deep in it, or behind it, where the carrier ends. */
    private static boolean isRunOver(float[] d, Circle carrier, Circle c) {
        float[] end = minus(d, carrier.path);
        float notDeep = (carrier.radius + c.radius) - RUN_OVER * c.radius;
        return dot(end, carrier.path) < 0f || !(dot(end, end) > notDeep * notDeep);
    }
}
