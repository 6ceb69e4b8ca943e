package io.github.circles2d.reference;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.function.BiConsumer;

/** One step of at least one circle. */
final class Step {
    private static final int CROWD = 32;

    private final List<Circle> circles;
    private final StepParameters k;
    private final List<Contact> contacts = new ArrayList<>();

    /** Circles are in the order of their ids. */
    Step(List<Circle> circles, StepParameters k) {
        this.circles = circles;
        this.k = k;
    }

    /** Makes the step; cached impulses are multiplied by a scale, then replaced by those that the step ends with. */
    void make(Map<Contact.Pair, Float> impulseCache, float warmScale) {
        Grid grid = new Grid(circles, k.x, k.y);
        circles.forEach(this::planMotion);
        ContinuousCollision.clampMotion(circles, grid);
        findContacts(grid);
        prepare(impulseCache, warmScale);
        for (int subStep = 0; subStep < k.subSteps; subStep++) {
            circles.forEach(this::integrateVelocities);
            contacts.forEach(Contact::solve);
            circles.forEach(this::integratePositions);
            contacts.forEach(Step::relax);
        }
        circles.forEach(this::finalizePositions);
        storeImpulses(impulseCache);
    }

    private void planMotion(Circle c) {
        float fallX = c.isStatic() ? 0f : k.fall(k.gravityStepX);
        float fallY = c.isStatic() ? 0f : k.fall(k.gravityStepY);
        c.plan(c.x.velocity * k.dt + fallX, c.y.velocity * k.dt + fallY);
    }

    // ---- contacts
    // ----------------------------------------------------------------------------------------------------

    private void findContacts(Grid grid) {
        circles.forEach(c -> c.candidates = 0);
        forEachCandidate((lower, higher) -> {
            lower.candidates += higher.level <= lower.level ? 1 : 0;
            higher.candidates += lower.level <= higher.level ? 1 : 0;
        });
        forEachCandidate((lower, higher) -> {
            int fewer = Math.min(lower.candidates, higher.candidates);
            int hash = new Contact.Pair(lower.id, higher.id).hash();
            if (fewer <= CROWD || (hash >>> 16) * (long) fewer < CROWD * 65_536L) {
                contacts.add(new Contact(lower, higher, grid.colour(lower, higher), k));
            }
        });
        contacts.sort(Step::order);
    }

    private static int order(Contact a, Contact b) {
        if (a.level != b.level) {
            return b.level - a.level;
        }
        if (a.colour != b.colour) {
            return a.colour - b.colour;
        }
        return a.pair.lower() != b.pair.lower() ? a.pair.lower() - b.pair.lower() : a.pair.higher() - b.pair.higher();
    }

    /** Goes through all pairs that are near to each other, unless both are static. Sorted by x, so that few pairs are tried. */
    private void forEachCandidate(BiConsumer<Circle, Circle> action) {
        Circle[] sorted = circles.toArray(new Circle[0]);
        Arrays.sort(sorted, Comparator.comparingDouble(Circle::left));
        for (int i = 0; i < sorted.length; i++) {
            Circle a = sorted[i];
            for (int j = i + 1; j < sorted.length && sorted[j].left() <= a.right(); j++) {
                Circle b = sorted[j];
                if (a.isNear(b) && !(a.isStatic() && b.isStatic())) {
                    action.accept(a.id < b.id ? a : b, a.id < b.id ? b : a);
                }
            }
        }
    }

    private void prepare(Map<Contact.Pair, Float> impulseCache, float warmScale) {
        for (Circle c : circles) {
            clearImpulses(c);
            c.x.wall = new Wall(c, c.x, k.x, k);
            c.y.wall = new Wall(c, c.y, k.y, k);
        }
        for (Contact contact : contacts) {
            contact.normalImpulse = impulseCache.getOrDefault(contact.pair, 0f) * warmScale;
            contact.measure();
            contact.warmStart(contact.carries());
        }
    }

    private static void clearImpulses(Circle c) {
        c.x.impulses = 0f;
        c.y.impulses = 0f;
        c.loadedNext = false;
    }

    private void storeImpulses(Map<Contact.Pair, Float> impulseCache) {
        impulseCache.clear();
        for (Contact contact : contacts) {
            if (contact.normalImpulse > 0f) {
                impulseCache.put(contact.pair, contact.normalImpulse);
            }
        }
    }

    // ---- sub-steps
    // ---------------------------------------------------------------------------------------------------

    private void integrateVelocities(Circle c) {
        c.loaded = !c.isStatic() && (c.loadedNext || c.x.wallImpulse != 0f || c.y.wallImpulse != 0f);
        integrateVelocity(c, c.x, k.gravityStepX);
        integrateVelocity(c, c.y, k.gravityStepY);
    }

    private static void integrateVelocity(Circle c, Circle.Axis axis, float gravityStep) {
        if (c.isStatic()) {
            axis.velocityBeforeImpulses = axis.velocity;
            return;
        }
        axis.velocityBeforeImpulses = axis.velocity + gravityStep;
        axis.velocity = Numbers.limitSpeed(axis.velocityBeforeImpulses + c.inverseMass() * axis.impulses);
        axis.wall.measure();
        axis.wall.apply(axis.wall.normalImpulse);
        axis.wall.solve();
    }

    private void integratePositions(Circle c) {
        c.x.velocity = Numbers.limitSpeed(c.x.velocity);
        c.y.velocity = Numbers.limitSpeed(c.y.velocity);
        float toX = c.x.displacement + c.x.velocity * k.h;
        float toY = c.y.displacement + c.y.velocity * k.h;
        if (!c.isStatic() && toX * toX + toY * toY > c.allowance * c.allowance) {
            float share = nearestShare(toX, toY, c.x.freePath, c.y.freePath);
            float offX = toX - share * c.x.freePath;
            float offY = toY - share * c.y.freePath;
            float off = Numbers.length(offX, offY);
            if (off > c.allowance) {
                toX = share * c.x.freePath + c.allowance / off * offX;
                toY = share * c.y.freePath + c.allowance / off * offY;
            }
        }
        move(c, c.x, toX, k.x);
        move(c, c.y, toY, k.y);
        clearImpulses(c);
    }

    /** Where on a path a point is nearest, as a share of the path. */
    private static float nearestShare(float x, float y, float pathX, float pathY) {
        float square = pathX * pathX + pathY * pathY;
        return square > 0f ? Numbers.clamp((x * pathX + y * pathY) / square, 0f, 1f) : 0f;
    }

    private static void move(Circle c, Circle.Axis axis, float to, StepParameters.Walls walls) {
        float low = walls.low() + c.margin();
        float high = walls.high() - c.margin();
        float coordinate = axis.base + to;
        axis.displacement = coordinate < low ? low - axis.base : coordinate > high ? high - axis.base : to;
        if (!c.isStatic()) {
            axis.wall.measure();
            axis.wall.relax();
            axis.wall.storeImpulse();
        } else if (axis.displacement != to) {
            axis.velocity = 0f;
        }
    }

    private static void relax(Contact contact) {
        contact.measure();
        if (contact.relax()) {
            contact.warmStart(true);
        }
    }

    private void finalizePositions(Circle c) {
        finalizePosition(c.x, k.x.low() + c.margin(), k.x.high() - c.margin());
        finalizePosition(c.y, k.y.low() + c.margin(), k.y.high() - c.margin());
    }

    private static void finalizePosition(Circle.Axis axis, float low, float high) {
        float sum = axis.base + axis.displacement;
        float inside = Numbers.clamp(sum, low, high);
        float part = sum - axis.base;
        float lost = (axis.base - (sum - part)) + (axis.displacement - part);
        axis.displacement = inside == sum ? lost : 0f;
        axis.base = inside;
        axis.velocity = Numbers.limitSpeed(axis.velocity);
    }
}
