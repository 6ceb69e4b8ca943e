package io.github.circles2d.reference;

import static io.github.circles2d.reference.Numbers.dot;
import static io.github.circles2d.reference.Numbers.length;
import static io.github.circles2d.reference.Numbers.minus;
import static io.github.circles2d.reference.Numbers.unit;

/** What two circles that are only sensed did in a step, by their straight paths from its start to its end. */
final class Sensing {
    private static final float COINCIDENT = 1e-6f;

    private Sensing() {}

    static Touch touch(Circle lower, Circle higher, float dt) {
        Arena arena = lower.arena;
        float[] lowerPath = arena.way(lower.start, lower.base);
        float[] d = arena.way(lower.start, higher.start);
        float[] u = minus(arena.way(higher.start, higher.base), lowerPath);
        float sum = lower.radius + higher.radius;
        float closest = dot(u, u) > 0f ? Numbers.clamp(-dot(d, u) / dot(u, u), 0f, 1f) : 0f;
        Touch touch = new Touch();
        touch.separation = length(after(closest, d, u)) - sum;
        touch.slack = Touch.SLACK * sum;
        float t = touch.touches() ? timeOfTouch(d, u, sum) : closest;
        float[] m = after(t, d, u);
        int hash = new Contact.Pair(lower, higher).hash();
        float[] parting = {(hash & 1023) - 511.5f, (hash >>> 10 & 1023) - 511.5f};
        touch.normal = unit(length(m) > COINCIDENT * sum ? m : parting);
        touch.normalVelocity = dot(touch.normal, new float[] {u[0] / dt, u[1] / dt});
        touch.sensedSpeed = touch.normalVelocity < 0f ? -touch.normalVelocity : 0f;
        for (int a = 0; a < 2; a++) {
            float centre = lower.start[a] + t * lowerPath[a];
            touch.point[a] = centre + touch.normal[a] * (lower.radius + 0.5f * (length(m) - sum));
        }
        return touch;
    }

    private static float[] after(float share, float[] d, float[] u) {
        return new float[] {d[0] + share * u[0], d[1] + share * u[1]};
    }

    private static float timeOfTouch(float[] d, float[] u, float sum) {
        float b = -dot(d, u);
        float gap = dot(d, d) - sum * sum;
        float root = Numbers.sqrt(Numbers.max(b * b - dot(u, u) * gap, 0f));
        return gap > 0f && b > 0f ? Numbers.min(gap / (b + root), 1f) : 0f;
    }
}
