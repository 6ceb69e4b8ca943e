package io.github.circles2d.reference;

import java.util.List;

/** Keeps fast circles from passing through others: clamps the motion of a step. */
final class ContinuousCollision {
    private static final float TRAVEL = 64f;
    private static final float SWEEP_RATIO = 16f;
    private static final float LEASH = 0.5f;

    private ContinuousCollision() {}

    static void clampMotion(List<Circle> circles, Grid grid) {
        for (Circle c : circles) {
            c.farthest = mostOfPath(c);
            c.timeOfImpact = 1f;
        }
        for (Circle c : circles) {
            if (c.isFast() && !c.isStatic()) {
                lookAhead(c, circles, grid);
            }
        }
        for (Circle c : circles) {
            boolean stops = c.timeOfImpact < c.farthest;
            float share = stops ? c.timeOfImpact : c.farthest;
            c.x.freePath = share * c.x.path;
            c.y.freePath = share * c.y.path;
            c.allowance = stops ? 0f : LEASH * c.radius;
        }
    }

    /** The share of its path that a circle goes at most. */
    private static float mostOfPath(Circle c) {
        float most = TRAVEL * c.radius;
        return c.pathLength > most ? most / c.pathLength : 1f;
    }

    private static void lookAhead(Circle c, List<Circle> circles, Grid grid) {
        for (Circle other : circles) {
            if (other != c && mayPass(c, other)) {
                float t = timeOfImpact(c, other);
                if (t < 1f && isInSight(c, other, grid)) {
                    meet(c, other, t);
                }
            }
        }
    }

    private static void meet(Circle c, Circle other, float t) {
        if (c.isNear(other)) {
            c.farthest = Numbers.min(t, c.farthest);
        } else if (other.pathLength <= c.pathLength || !other.isFast()) {
            c.timeOfImpact = Numbers.min(t, c.timeOfImpact);
            if (other.isFast()) {
                other.timeOfImpact = Numbers.min(t, other.timeOfImpact);
            }
        }
    }

    private static boolean mayPass(Circle c, Circle other) {
        float ux = c.x.path - other.x.path;
        float uy = c.y.path - other.y.path;
        float half = 0.5f * (c.radius + other.radius);
        return ux * ux + uy * uy > half * half && other.radius * SWEEP_RATIO >= c.radius;
    }

    /** Whether a circle lies in the cells around the path of another. */
    private static boolean isInSight(Circle c, Circle other, Grid grid) {
        float most = mostOfPath(c);
        float largest = grid.largestRadius(other.level);
        float margin = (c.radius + largest) + Numbers.max(most * c.pathLength, largest);
        float endX = c.x.base + most * c.x.path;
        float endY = c.y.base + most * c.y.path;
        return grid.covers(
                Numbers.min(c.x.base, endX) - margin,
                Numbers.min(c.y.base, endY) - margin,
                Numbers.max(c.x.base, endX) + margin,
                Numbers.max(c.y.base, endY) + margin,
                other);
    }

    /** The share of their paths after which two circles touch; 2 if they do not. */
    private static float timeOfImpact(Circle c, Circle other) {
        float dx = other.x.base - c.x.base;
        float dy = other.y.base - c.y.base;
        float ux = c.x.path - other.x.path;
        float uy = c.y.path - other.y.path;
        float radii = c.radius + other.radius;
        float approach = dx * ux + dy * uy;
        float gap = (dx * dx + dy * dy) - radii * radii;
        float discriminant = approach * approach - (ux * ux + uy * uy) * gap;
        boolean touch = approach > 0f && discriminant >= 0f;
        return touch ? Numbers.max(gap, 0f) / (approach + (float) Math.sqrt(discriminant)) : 2f;
    }
}
