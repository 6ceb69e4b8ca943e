package io.github.circles2d.reference;

import static io.github.circles2d.reference.Numbers.max;
import static io.github.circles2d.reference.Numbers.min;
import static io.github.circles2d.reference.Numbers.minus;

/** Static circles that move take along what they come upon. */
final class Carrying {
    private final Grid grid;

    Carrying(Grid grid) {
        this.grid = grid;
    }

    void start(Circle c) {
        c.carryTime = 1f;
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
        if (!(t < 1f) || !pushes(carrier, c) && contactHas || t > c.carryTime) {
            return;
        }
        boolean first = t < c.carryTime || c.carrier == null || grid.isBefore(carrier, c.carrier);
        c.carrier = first ? carrier : c.carrier;
        c.carryTime = t;
    }

    private static float timeOfCarry(Circle carrier, Circle c) {
        float radii = carrier.radius + c.radius;
        float[] d = minus(c.base, carrier.base);
        float t = ContinuousCollision.timeOfImpact(d, minus(carrier.path, c.path), radii);
        float share = freeShare(c);
        if (t <= share) {
            return t;
        }
        float[] waiting = {d[0] + share * c.path[0], d[1] + share * c.path[1]};
        return max(ContinuousCollision.timeOfImpact(waiting, carrier.path, radii), share);
    }
}
