package io.github.circles2d.reference;

import java.util.HashMap;
import java.util.Map;
import java.util.function.Function;

/** A circle and the nearer wall of an axis. The circle counts as one of mass 1, so impulses are speeds. */
final class Wall extends Constraint {
    private static final float WALL_STIFFNESS = 2f;

    private final Circle c;
    private final int axis;

    /** The distance from the wall to the base. */
    private final float height;

    /** The direction away from the wall: 1 for the lower wall, -1 for the upper. */
    private final float normal;

    /** The direction of the tangent: 1 towards greater coordinates. */
    private final float along;

    /** The speed of the wall's surface, towards greater coordinates. */
    private final float belt;

    /** That of the circle, for a mass of 1. */
    private final float inverseInertia;

    /** What it does in the step. */
    final Touch touch = new Touch();

    /** What the wall comes in during the step. */
    private final float in;

    /** The speed of the wall inwards, for this circle: it jumps if its way is longer than the radius. */
    private final float speed;

    Wall(Circle c, int axis, StepParameters step) {
        super(step, WALL_STIFFNESS, Math.abs(step.gravity()[axis]), 2f * c.radius, c.restitution, 1f);
        this.c = c;
        this.axis = axis;
        float aboveMin = c.base[axis] - step.min()[axis];
        float belowMax = step.max()[axis] - c.base[axis];
        height = Numbers.min(belowMax, aboveMin);
        normal = aboveMin <= belowMax ? 1f : -1f;
        in = normal > 0f ? step.minIn()[axis] : step.maxIn()[axis];
        speed = speed(normal);
        normalImpulse = Numbers.max(normal * c.wallImpulse[axis], 0f);
        along = axis == 0 ? normal : -normal;
        belt = step.surfaces().belt(number(normal));
        float inverseInertia = c.turn.inverseInertia / c.inverseMass();
        frictionCoefficient = Numbers.sqrt(c.turn.friction * step.surfaces().wallFriction(number(normal)));
        tangentMass = 1f / (1f + inverseInertia);
        float resistance = Numbers.max(c.turn.rollingResistance, step.surfaces().wallRollingResistance(number(normal)));
        rollingCoefficient = inverseInertia > 0f ? resistance : 0f;
        rollingMass = 1f / inverseInertia;
        friction = c.wallFriction[axis];
        rolling = c.wallRolling[axis];
        this.inverseInertia = inverseInertia;
    }

    /** Begins the sub-step with the grips of the one before, if the wall presses. */
    void warmStartGrips() {
        if (!(normalImpulse > 0f)) {
            friction = 0f;
            rolling = 0f;
        } else if (friction != 0f || rolling != 0f) {
            forgetGrips();
            c.velocity[1 - axis] += along * friction;
            c.turn.speed += inverseInertia * (rolling - friction);
        }
        storeGrips();
    }

    private void storeGrips() {
        c.wallFriction[axis] = friction;
        c.wallRolling[axis] = rolling;
    }

    @Override
    float slip(float speed) {
        return slip(speed, c.turn.speed);
    }

    private float slip(float speed, float surfaceSpeed) {
        return (speed - surfaceSpeed) - c.turn.belt;
    }

    @Override
    float tangentSpeed() {
        return tangentSpeed(c.velocity);
    }

    private float tangentSpeed(float[] velocity) {
        return along * (velocity[1 - axis] - belt);
    }

    /** How fast the surfaces slide along each other at a velocity and a speed of the circle's surface; 0 without friction. */
    float slipOf(float[] velocity, float surfaceSpeed) {
        return frictionCoefficient > 0f ? Math.abs(slip(tangentSpeed(velocity), surfaceSpeed)) : 0f;
    }

    @Override
    float rollingSpeed() {
        return c.turn.speed;
    }

    @Override
    void applyFriction(float impulse) {
        c.velocity[1 - axis] += along * impulse;
        c.turn.speed += inverseInertia * -impulse;
    }

    @Override
    void applyRolling(float impulse) {
        c.turn.speed += inverseInertia * impulse;
    }

    /** The speed inwards of the wall on a side. */
    private float speed(float side) {
        float travel = side > 0f ? step.minIn()[axis] : step.maxIn()[axis];
        return moves(travel, c) ? Numbers.limitSpeed(travel / step.dt()) : 0f;
    }

    /** Whether a circle feels the velocity of a wall. */
    static boolean moves(float in, Circle c) {
        return in != 0f && Math.abs(in) <= c.radius;
    }

    /** By where the wall is at the end of a sub-step. */
    void measure(int subStep) {
        separation = ((height - c.radius) + normal * c.displacement[axis]) + step.behind(in, subStep);
    }

    /** The biased visit of a wall that has been measured; in the frame of the wall, by where it is before the sub-step. */
    void solveInFrame() {
        float v = normal * c.velocity[axis];
        float before = normal * c.velocityBeforeImpulses[axis];
        boolean staysClear = separation > 0f
                && normalImpulse == 0f
                && separation * step.inverseH() + v >= 0f
                && separation + before * step.h() >= 0f;
        if (staysClear) {
            bounceSpeed = 0f;
            return;
        }
        separation += moves(in, c) ? step.sweep(in) : 0f;
        solve();
    }

    /**
     * Stops the circle if the farther wall has cut its displacement.
     *
     * @param displacement the displacement before the walls cut it
     */
    void stopAtFarWall(float displacement) {
        if (normal > 0f ? c.displacement[axis] < displacement : c.displacement[axis] > displacement) {
            c.velocity[axis] = 0f;
        }
    }

    /**
     * Looks at the touch after a visit of both walls. The approach is that to a wall that may move.
     *
     * @param velocity the velocity along the axis with which the circle approached
     * @param gained what the visit added to it
     * @param slip how fast the surfaces slid then
     */
    void look(float velocity, float gained, float slip) {
        float impulse = normal * gained;
        touch.impulse += impulse;
        if (impulse > 0f || separation <= 0f) {
            float place = c.base[1 - axis] + c.displacement[1 - axis];
            float approach = Numbers.max(-(normal * velocity - speed), 0f);
            touch.seen(approach, slip, direction(normal), point(normal, place), true);
        }
    }

    /** From the circle to the wall. */
    private float[] direction(float side) {
        return axis == 0 ? new float[] {-side, 0f} : new float[] {0f, -side};
    }

    private float[] point(float side, float place) {
        float at = side > 0f ? step.min()[axis] : step.max()[axis];
        return axis == 0 ? new float[] {at, place} : new float[] {place, at};
    }

    /** The touches after the step, by the number of the wall: of this one, and of the one that is nearer now. */
    Map<Integer, Touch> touchesAfterStep() {
        float nearer = c.base[axis] - step.min()[axis] <= step.max()[axis] - c.base[axis] ? 1f : -1f;
        Map<Integer, Touch> touches = new HashMap<>();
        if (touch.approach >= 0f) {
            touches.put(number(normal), touch);
            touch.impulse = c.mass * touch.impulse;
            atEnd(touch, normal);
        }
        if (!touches.containsKey(number(nearer))) {
            Touch other = new Touch();
            other.separation = nearer > 0f
                    ? ((c.base[axis] - step.min()[axis]) - c.radius) + c.displacement[axis]
                    : ((step.max()[axis] - c.base[axis]) - c.radius) - c.displacement[axis];
            other.slack = Touch.SLACK * radii;
            atEnd(other, nearer);
            touches.put(number(nearer), other);
        }
        return touches;
    }

    private void atEnd(Touch ended, float side) {
        ended.end(direction(side), point(side, c.base[1 - axis]));
        ended.threshold = squaredHitSpeed();
        ended.normalVelocity = side * c.velocity[axis] - speed(side);
    }

    /** Left, right, lower, upper. */
    private int number(float side) {
        return 2 * axis + (side > 0f ? 0 : 1);
    }

    void storeImpulse() {
        c.wallImpulse[axis] = bounceSpeed > 0f ? 0f : normal * normalImpulse;
        storeGrips();
    }

    @Override
    float normalVelocity(Function<Circle, float[]> velocity) {
        return normal * velocity.apply(c)[axis] - speed;
    }

    @Override
    boolean isLoaded() {
        return c.loaded;
    }

    @Override
    void apply(float impulse) {
        c.velocity[axis] += normal * impulse;
    }

    /** Lets the circle fly on to the wall before it turns, unless it flies farther than its radius in a step. */
    @Override
    void applyFreeBounce(float impulse) {
        float speed = -normalVelocity(circle -> circle.velocity);
        if (separation > 0f && speed * step.dt() <= c.radius) {
            c.displacement[axis] -= normal * impulse * (separation / speed);
        }
        apply(impulse);
    }
}
