package io.github.circles2d.reference;

/** Two circles that may meet within the step. The normal is a unit vector from the circle of lower id to the other. */
final class Contact extends Constraint {
    private static final float COINCIDENT = 1e-6f;

    /** The ids of the two circles. */
    record Pair(int lower, int higher) {
        /** A well-mixed number of the two ids. */
        int hash() {
            return mix(mix(lower) + higher);
        }

        /** The finalizer of MurmurHash3. */
        private static int mix(int h) {
            int a = (h ^ h >>> 16) * 0x85ebca6b;
            int b = (a ^ a >>> 13) * 0xc2b2ae35;
            return b ^ b >>> 16;
        }
    }

    final Pair pair;
    final int level;
    final int colour;
    private final Circle lower;
    private final Circle higher;
    private float normalX;
    private float normalY;

    Contact(Circle lower, Circle higher, int colour, StepParameters step) {
        super(
                step,
                step.contactSoftness,
                lower.radius + higher.radius,
                Numbers.max(lower.restitution, higher.restitution),
                lower.inverseMass() + higher.inverseMass());
        this.lower = lower;
        this.higher = higher;
        this.colour = colour;
        pair = new Pair(lower.id, higher.id);
        level = Math.min(lower.level, higher.level);
        int hash = pair.hash();
        float x = (hash & 1023) - 511.5f;
        float y = (hash >>> 10 & 1023) - 511.5f;
        normalX = x / Numbers.length(x, y);
        normalY = y / Numbers.length(x, y);
    }

    void measure() {
        float dx = (higher.x.base - lower.x.base) + (higher.x.displacement - lower.x.displacement);
        float dy = (higher.y.base - lower.y.base) + (higher.y.displacement - lower.y.displacement);
        float distance = Numbers.length(dx, dy);
        if (distance > COINCIDENT * radii) {
            normalX = dx / distance;
            normalY = dy / distance;
        }
        separation = distance - radii;
    }

    /** Adds the normal impulse to those that the two circles begin their next sub-step with, and marks them as loaded then. */
    void warmStart(boolean carries) {
        lower.x.impulses -= normalX * normalImpulse;
        lower.y.impulses -= normalY * normalImpulse;
        higher.x.impulses += normalX * normalImpulse;
        higher.y.impulses += normalY * normalImpulse;
        lower.loadedNext |= carries;
        higher.loadedNext |= carries;
    }

    @Override
    float normalVelocity() {
        return normalX * (higher.x.velocity - lower.x.velocity) + normalY * (higher.y.velocity - lower.y.velocity);
    }

    @Override
    float normalVelocityBeforeImpulses() {
        return normalX * (higher.x.velocityBeforeImpulses - lower.x.velocityBeforeImpulses)
                + normalY * (higher.y.velocityBeforeImpulses - lower.y.velocityBeforeImpulses);
    }

    @Override
    boolean isLoaded() {
        return lower.loaded || higher.loaded;
    }

    @Override
    void apply(float impulse) {
        lower.x.velocity -= normalX * (lower.inverseMass() * impulse);
        lower.y.velocity -= normalY * (lower.inverseMass() * impulse);
        higher.x.velocity += normalX * (higher.inverseMass() * impulse);
        higher.y.velocity += normalY * (higher.inverseMass() * impulse);
    }
}
