package io.github.circles2d.reference;

import static io.github.circles2d.reference.Numbers.dot;
import static io.github.circles2d.reference.Numbers.length;
import static io.github.circles2d.reference.Numbers.max;
import static io.github.circles2d.reference.Numbers.min;
import static io.github.circles2d.reference.Numbers.minus;

import java.util.List;
import java.util.stream.Stream;

/** Keeps fast circles from passing through others: clamps the motion of a step. */
final class ContinuousCollision {
    private static final float TRAVEL = 64f;
    private static final float SWEEP_RATIO = 16f;
    private static final float CLAMP_ALLOWANCE = 0.5f;
    private static final float HOLD = 0.075f;
    private static final float ASIDE = 0.1f;
    private static final float DULL = 0.1f;
    private static final float GRAZE = 0.01f;

    private final List<Circle> circles;
    private final Grid grid;
    private final StepParameters k;
    private final Kinds kinds;

    ContinuousCollision(List<Circle> circles, Grid grid, StepParameters k, Kinds kinds) {
        this.kinds = kinds;
        this.circles = circles;
        this.grid = grid;
        this.k = k;
    }

    /** A static circle stops at the bounds. */
    static void cutStaticPath(Circle c, StepParameters k) {
        for (int a = 0; a < 2; a++) {
            float to = c.base[a] + c.path[a];
            c.path[a] = to < k.min()[a] ? k.min()[a] - c.base[a] : to > k.max()[a] ? k.max()[a] - c.base[a] : c.path[a];
        }
        c.pathLength = length(c.path);
    }

    /** What a circle that is not static moves in the step if it meets no other circle: no path leads far, or along into a wall. */
    static void cutPath(Circle c, StepParameters k) {
        float slack = c.radius + Circle.MARGIN * c.radius;
        boolean far = length(c.path) > c.radius;
        for (int a = 0; a < 2 && far; a++) {
            boolean intoWall = c.path[a] < 0f && c.base[a] - k.min()[a] < slack
                    || c.path[a] > 0f && k.max()[a] - c.base[a] < slack;
            c.path[a] = intoWall ? 0f : c.path[a];
        }
        float most = TRAVEL * c.radius;
        float share = length(c.path) > most ? most / length(c.path) : 1f;
        c.pathLength = share * length(c.path);
        c.path[0] *= share;
        c.path[1] *= share;
    }

    void clampMotion() {
        for (Circle c : circles) {
            c.leastPath = Circle.CAP * (c.isStatic() ? 0.5f * grid.finestRadius() : c.radius);
            c.contactTime = 1f;
            c.timeOfImpact = timeOfWalls(c);
            c.allowance = Float.POSITIVE_INFINITY;
            c.stands = false;
        }
        circles.stream().filter(c -> isFast(c) && !c.isStatic()).forEach(c -> others(c)
                .forEach(other -> look(c, other)));
        Carrying carrying = new Carrying(grid);
        List<Circle> carriers =
                circles.stream().filter(c -> c.isStatic() && c.pathLength > 0f).toList();
        for (Circle c : circles) {
            carrying.start(c);
            if (!c.isStatic()) {
                carriers.stream()
                        .filter(carrier -> carries(carrier, c))
                        .forEach(carrier -> carrying.meet(carrier, c, isNearWithoutImpact(carrier, c)));
            }
        }
        circles.stream().filter(c -> !c.isStatic()).forEach(this::setClamp);
    }

    private Stream<Circle> others(Circle c) {
        return circles.stream().filter(other -> other != c);
    }

    private static boolean isFast(Circle c) {
        return c.pathLength > c.leastPath;
    }

    /** Whether two circles may meet, and the faster one looks for the other. */
    private boolean carries(Circle carrier, Circle c) {
        float[] u = minus(c.path, carrier.path);
        return kinds.mayMeet(carrier, c)
                && (isFast(carrier) && c.pathLength <= carrier.pathLength + Circle.CAP * c.radius
                        || isFast(c) && length2(u) > c.leastPath * c.leastPath);
    }

    /** The share of its path after which a circle that goes farther than its radius touches a wall. */
    private float timeOfWalls(Circle c) {
        float first = 1f;
        for (int a = 0; a < 2 && !c.isStatic() && c.pathLength > c.radius; a++) {
            float minIn = comesIn(k.minIn()[a], c);
            float maxIn = comesIn(k.maxIn()[a], c);
            float low = ((k.min()[a] - minIn) + c.radius) - c.base[a];
            float high = ((k.max()[a] + maxIn) - c.radius) - c.base[a];
            float p = minIn > 0f ? c.path[a] - minIn : c.path[a];
            float q = maxIn > 0f ? c.path[a] + maxIn : c.path[a];
            first = min(p < 0f && p < low ? low / p : q > 0f && q > high ? high / q : 1f, first);
        }
        return max(first, 0f);
    }

    /** How far a wall comes in that a circle feels. */
    private static float comesIn(float in, Circle c) {
        return Wall.moves(in, c) ? max(in, 0f) : 0f;
    }

    private void look(Circle c, Circle other) {
        float[] u = minus(c.path, other.path);
        float[] d = c.wayTo(other);
        boolean atStatic = other.isStatic();
        if (!(length2(u) > c.leastPath * c.leastPath)
                || !kinds.mayMeet(c, other)
                || !atStatic && !(other.radius * SWEEP_RATIO >= c.radius)) {
            return;
        }
        float reachToStatic = (c.radius + c.pathLength) + other.radius;
        if (atStatic && length2(d) < reachToStatic * reachToStatic) {
            c.allowance = min(CLAMP_ALLOWANCE * c.radius, c.allowance);
        }
        boolean pushed = atStatic && Carrying.pushes(other, c);
        float graze = (2f * GRAZE) * min(c.radius, other.radius);
        float t = timeOfImpact(d, u, c.radius + other.radius, graze);
        if (!(t < 1f) || pushed || isNearWithoutImpact(c, other)) {
            return;
        }
        float lost = 1f - max(c.restitution, other.restitution);
        float least = DULL * c.radius;
        boolean dull = length2(new float[] {lost * u[0], lost * u[1]}) > least * least;
        if (!atStatic && dull && length2(u) > c.radius * c.radius && !isFast(other)) {
            float[] toItsEnd = {d[0] + other.path[0], d[1] + other.path[1]};
            t = min(timeOfTouch(toItsEnd, c.path, (c.radius + other.radius) + graze), t);
        }
        if (c.isNear(other) && areCloser(c, other, atStatic ? Circle.MARGIN : HOLD)) {
            hold(c, other, t, dull);
        } else if (atStatic) {
            c.timeOfImpact = other.pathLength > 0f ? c.timeOfImpact : min(t, c.timeOfImpact);
        } else if (other.pathLength <= c.pathLength || !isFast(other)) {
            c.timeOfImpact = min(t, c.timeOfImpact);
            other.timeOfImpact = isFast(other) ? min(t, other.timeOfImpact) : other.timeOfImpact;
        }
    }

    /** Whether two circles have a contact and move little against each other. */
    private static boolean isNearWithoutImpact(Circle a, Circle b) {
        float least = 0.5f * Circle.CAP * (a.radius + b.radius);
        return a.isNear(b) && !(length2(minus(a.path, b.path)) > least * least);
    }

    static boolean areCloser(Circle a, Circle b, float slack) {
        float close = (a.radius + slack * a.radius) + (b.radius + slack * b.radius);
        return length2(a.wayTo(b)) < close * close;
    }

    private static float length2(float[] a) {
        return dot(a, a);
    }

    /** A circle so close to another leaves it to their contact, but goes no farther along its path. */
    private static void hold(Circle c, Circle other, float t, boolean dull) {
        c.contactTime = min(t, c.contactTime);
        c.stands |= other.isStatic();
        float allowance = CLAMP_ALLOWANCE * c.radius;
        if (!other.isStatic()) {
            float back = Numbers.clamp(c.pathLength, allowance, c.radius);
            allowance = other.radius < c.radius ? CLAMP_ALLOWANCE * other.radius : dull ? allowance : back;
        }
        c.allowance = min(allowance, c.allowance);
    }

    /** The share of their paths after which two circles touch that do more than graze each other; 2 if they do not. */
    static float timeOfImpact(float[] d, float[] u, float radii) {
        return timeOfImpact(d, u, radii, GRAZE * radii);
    }

    private static float timeOfImpact(float[] d, float[] u, float radii, float graze) {
        return timeOfTouch(d, u, radii - graze) < 1f ? timeOfTouch(d, u, radii) : 2f;
    }

    static float timeOfTouch(float[] d, float[] u, float radii) {
        float b = dot(d, u);
        float gap = dot(d, d) - radii * radii;
        float discriminant = b * b - dot(u, u) * gap;
        boolean touch = b > 0f && discriminant >= 0f;
        return touch ? max(gap, 0f) / (b + Numbers.sqrt(discriminant)) : 2f;
    }

    private void setClamp(Circle c) {
        float share = c.stands ? 1f : c.contactTime;
        float free = c.jointed ? Float.POSITIVE_INFINITY : CLAMP_ALLOWANCE * c.radius;
        c.allowance = c.contactTime < 1f ? c.allowance : free;
        c.isPushed = false;
        for (int a = 0; a < 2; a++) {
            c.freePath[a] = share * c.path[a];
        }
        boolean stops = c.timeOfImpact < c.contactTime || c.carryTime < 1f;
        float own = min(Carrying.freeShare(c), c.carryTime);
        if (c.carrier != null || stops) {
            for (int a = 0; a < 2; a++) {
                float alone = own * c.path[a];
                c.freePath[a] = c.carrier == null ? alone : alone + (1f - c.carryTime) * c.carrier.path[a];
            }
            c.allowance = 0f;
            c.stands = false;
            c.isPushed = c.carrier != null && Carrying.pushes(c.carrier, c);
        }
        if (stops) {
            for (int a = 0; a < 2; a++) {
                c.velocity[a] -= (1f - own) * (c.gain[a] * k.subSteps());
            }
            c.speculativeDistance = c.radius + Circle.MARGIN * c.radius;
        }
    }

    /** Changes a displacement of a circle to what its clamp allows. */
    static void clamp(Circle c, float[] to) {
        if (c.isPushed) {
            to[0] = c.freePath[0];
            to[1] = c.freePath[1];
        } else if (c.stands) {
            float along = along(to, c.freePath);
            for (int a = 0; a < 2 && along > c.contactTime; a++) {
                to[a] -= (along - c.contactTime) * c.freePath[a];
            }
            float share = min(Numbers.clamp(along(to, c.freePath), 0f, 1f), c.contactTime);
            bringNear(to, share, c.freePath, along > 0f ? ASIDE * c.allowance : c.allowance);
        } else if (dot(to, to) > c.allowance * c.allowance) {
            bringNear(to, Numbers.clamp(along(to, c.freePath), 0f, 1f), c.freePath, c.allowance);
        }
    }

    private static float along(float[] to, float[] path) {
        float square = dot(path, path);
        return square > 0f ? dot(to, path) / square : 0f;
    }

    private static void bringNear(float[] to, float share, float[] path, float allowance) {
        float[] on = {share * path[0], share * path[1]};
        float[] off = minus(to, on);
        float distance = length(off);
        for (int a = 0; a < 2 && distance > allowance; a++) {
            to[a] = on[a] + allowance / distance * off[a];
        }
    }
}
