package io.github.circles2d.reference;

import static io.github.circles2d.reference.Numbers.dot;
import static io.github.circles2d.reference.Numbers.max;
import static io.github.circles2d.reference.Numbers.min;
import static io.github.circles2d.reference.Numbers.minus;

import java.util.List;

/** Keeps fast circles from passing through others: clamps the motion of a step. */
final class ContinuousCollision {
    private static final float TRAVEL = 64f;
    private static final float SWEEP_RATIO = 16f;
    private static final float CLAMP_ALLOWANCE = 0.5f;

    private ContinuousCollision() {}

    static void clampMotion(List<Circle> circles, Grid grid) {
        for (Circle c : circles) {
            c.limit = firstLimit(c);
            c.timeOfImpact = 1f;
        }
        for (Circle c : circles) {
            if (c.isFast() && !c.isStatic()) {
                circles.forEach(other -> look(c, other, grid));
            }
        }
        for (Circle c : circles) {
            for (int a = 0; a < 2; a++) {
                c.freePath[a] = min(c.timeOfImpact, c.limit) * c.path[a];
            }
            c.allowance = c.timeOfImpact < c.limit ? 0f : CLAMP_ALLOWANCE * c.radius;
        }
    }

    /** The share of its path that a circle goes at most, if it meets nothing. */
    private static float firstLimit(Circle c) {
        float most = TRAVEL * c.radius;
        return c.pathLength > most ? most / c.pathLength : 1f;
    }

    private static void look(Circle c, Circle other, Grid grid) {
        float[] u = minus(c.path, other.path);
        float half = 0.5f * (c.radius + other.radius);
        float t = timeOfImpact(c, other, u);
        if (dot(u, u) <= half * half || other.radius * SWEEP_RATIO < c.radius || t >= 1f || !sees(c, other, grid)) {
            return;
        }
        if (c.isNear(other)) {
            c.limit = min(t, c.limit);
        } else if (other.pathLength <= c.pathLength || !other.isFast()) {
            c.timeOfImpact = min(t, c.timeOfImpact);
            other.timeOfImpact = other.isFast() ? min(t, other.timeOfImpact) : other.timeOfImpact;
        }
    }

    /** The share of their paths after which two circles touch; 2 if they do not. */
    private static float timeOfImpact(Circle c, Circle other, float[] u) {
        float[] d = minus(other.base, c.base);
        float radii = c.radius + other.radius;
        float b = dot(d, u);
        float gap = dot(d, d) - radii * radii;
        float discriminant = b * b - dot(u, u) * gap;
        boolean touch = b > 0f && discriminant >= 0f;
        return touch ? max(gap, 0f) / (b + Numbers.sqrt(discriminant)) : 2f;
    }

    /** Whether a circle lies in the cells around the path of another. */
    private static boolean sees(Circle c, Circle other, Grid grid) {
        float share = firstLimit(c);
        float top = grid.largestRadius(other.level);
        float margin = (c.radius + top) + max(share * c.pathLength, top);
        boolean sees = true;
        for (int a = 0; a < 2; a++) {
            float end = c.base[a] + share * c.path[a];
            sees &= grid.covers(a, min(c.base[a], end) - margin, max(c.base[a], end) + margin, other);
        }
        return sees;
    }
}
