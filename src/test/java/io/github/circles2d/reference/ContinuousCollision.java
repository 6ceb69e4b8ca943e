package io.github.circles2d.reference;

import static io.github.circles2d.reference.Numbers.dot;
import static io.github.circles2d.reference.Numbers.length;
import static io.github.circles2d.reference.Numbers.max;
import static io.github.circles2d.reference.Numbers.min;
import static io.github.circles2d.reference.Numbers.minus;

import java.util.List;

/** Keeps fast circles from passing through others: clamps the motion of a step. */
final class ContinuousCollision {
    private static final float TRAVEL = 64f;
    private static final float SWEEP_RATIO = 16f;
    private static final float CLAMP_ALLOWANCE = 0.5f;
    private static final float HOLD = 0.075f;
    private static final float ASIDE = 0.1f;
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
            c.pusher = null;
        }
        for (boolean pushers : new boolean[] {false, true}) {
            for (Circle c : circles) {
                if (c.pathLength > c.leastPath) {
                    circles.stream().filter(other -> other != c).forEach(other -> look(c, other, pushers));
                }
            }
        }
        circles.stream().filter(c -> !c.isStatic()).forEach(this::setClamp);
    }

    /** The share of its path after which a circle that goes farther than its radius touches a wall. */
    private float timeOfWalls(Circle c) {
        float first = 1f;
        for (int a = 0; a < 2 && !c.isStatic() && c.pathLength > c.radius; a++) {
            float low = (k.min()[a] + c.radius) - c.base[a];
            float high = (k.max()[a] - c.radius) - c.base[a];
            float p = c.path[a];
            first = min(p < low ? max(low, p) / p : p > high ? min(high, p) / p : 1f, first);
        }
        return max(first, 0f);
    }

    private void look(Circle c, Circle other, boolean pushers) {
        float[] u = minus(c.path, other.path);
        float[] d = minus(other.base, c.base);
        if (!kinds.mayMeet(c, other)
                || !(length2(u) > c.leastPath * c.leastPath)
                || !c.isStatic() && !other.isStatic() && !(other.radius * SWEEP_RATIO >= c.radius)) {
            return;
        }
        float reachToStatic = (c.radius + c.pathLength) + other.radius;
        if (other.isStatic() && length2(d) < reachToStatic * reachToStatic) {
            c.allowance = min(CLAMP_ALLOWANCE * c.radius, c.allowance);
        }
        boolean pushes = c.isStatic() && c.pathLength > Circle.CAP * other.radius
                || other.isStatic() && other.pathLength > Circle.CAP * c.radius;
        float radii = c.radius + other.radius;
        float least = 0.5f * Circle.CAP * radii;
        float t = timeOfImpact(d, u, radii - GRAZE * radii) < 1f ? timeOfImpact(d, u, radii) : 2f;
        if (!(t < 1f) || c.isNear(other) && !pushes && !(length2(u) > least * least)) {
            return;
        }
        boolean atStatic = c.isStatic() || other.isStatic();
        float slack = atStatic ? Circle.MARGIN : HOLD;
        float close = (c.radius + slack * c.radius) + (other.radius + slack * other.radius);
        if (!pushes && length2(d) < close * close) {
            if (!c.isStatic()) {
                hold(c, other, t);
            }
        } else if (pushers) {
            notePusher(c, other, t);
            notePusher(other, c, t);
        } else if (atStatic || other.pathLength <= c.pathLength || !(other.pathLength > other.leastPath)) {
            stop(c, t);
            if (c.isStatic() || other.pathLength > other.leastPath) {
                stop(other, t);
            }
        }
    }

    private static float length2(float[] a) {
        return dot(a, a);
    }

    /** A circle so close to another leaves it to their contact, but goes no farther along its path. */
    private static void hold(Circle c, Circle other, float t) {
        c.contactTime = min(t, c.contactTime);
        c.stands |= other.isStatic();
        float allowance = CLAMP_ALLOWANCE * c.radius;
        if (!other.isStatic()) {
            boolean small = other.radius < c.radius;
            allowance = small ? CLAMP_ALLOWANCE * other.radius : Numbers.clamp(c.pathLength, allowance, c.radius);
        }
        c.allowance = min(allowance, c.allowance);
    }

    private static void stop(Circle c, float t) {
        c.timeOfImpact = c.isStatic() ? 1f : min(t, c.timeOfImpact);
    }

    private void notePusher(Circle pusher, Circle c, float t) {
        if (pusher.isStatic() && pusher.pathLength > 0f && t == c.timeOfImpact) {
            c.pusher = c.pusher == null || grid.isBefore(pusher, c.pusher) ? pusher : c.pusher;
        }
    }

    /** The share of their paths after which two circles touch; 2 if they do not. */
    private static float timeOfImpact(float[] d, float[] u, float radii) {
        float b = dot(d, u);
        float gap = dot(d, d) - radii * radii;
        float discriminant = b * b - dot(u, u) * gap;
        boolean touch = b > 0f && discriminant >= 0f;
        return touch ? max(gap, 0f) / (b + Numbers.sqrt(discriminant)) : 2f;
    }

    private void setClamp(Circle c) {
        float share = c.stands ? 1f : c.contactTime;
        c.allowance = c.contactTime < 1f ? c.allowance : CLAMP_ALLOWANCE * c.radius;
        c.isPushed = false;
        for (int a = 0; a < 2; a++) {
            c.freePath[a] = share * c.path[a];
        }
        if (c.timeOfImpact < c.contactTime) {
            float rest = 1f - c.timeOfImpact;
            for (int a = 0; a < 2; a++) {
                float own = c.timeOfImpact * c.path[a];
                c.freePath[a] = c.pusher == null ? own : own + rest * c.pusher.path[a];
                c.velocity[a] -= rest * (c.gain[a] * k.subSteps());
            }
            c.allowance = 0f;
            c.stands = false;
            c.isPushed = c.pusher != null && c.pusher.pathLength > Circle.CAP * c.radius;
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
