package io.github.circles2d;

import io.github.circles2d.reference.JointPlan;
import io.github.circles2d.reference.JointPlan.Kind;
import java.util.SplittableRandom;

/** The joints of the scenes on record, with the terrain that some of them have. They hold circles by their order in the scene. */
final class GoldenJoints {
    static final int PLANKS = 60;

    static final int OF_BLOB = 8;

    static final int LINKS = 15;

    private static final int GROUND = 0;

    private GoldenJoints() {}

    private static long[] circles(WorldCalls world) {
        long[] handles = new long[world.size()];
        world.readHandles(handles);
        return handles;
    }

    private static JointPlan rigid() {
        return JointPlan.of(Kind.DISTANCE);
    }

    private static JointPlan spring(float frequency, float damping) {
        return JointPlan.of(Kind.SPRING, frequency, damping);
    }

    /** Planks from wall to wall; ropes keep the outer ones near to the walls. */
    static void bridge(WorldCalls world) {
        long[] c = circles(world);
        world.addJoint(c[0], 0f, 0.4f, rigid());
        for (int k = 1; k < PLANKS; k++) {
            world.addJoint(c[k - 1], c[k], rigid());
        }
        world.addJoint(c[PLANKS - 1], 1f, 0.4f, rigid());
        world.addJoint(c[9], 0f, 0.4f, JointPlan.of(Kind.LIMITS).withLimits(0f, 10.1f / (PLANKS + 1)));
        world.addJoint(c[PLANKS - 10], 1f, 0.4f, JointPlan.of(Kind.LIMITS).withLimits(0f, 10.1f / (PLANKS + 1)));
    }

    /** Blobs of springs fall through a funnel. */
    static void blobs(WorldCalls world) {
        world.addSegment(GROUND, 0.1f, 0.8f, 0.46f, 0.3f, 0f, 0);
        world.addSegment(GROUND, 0.54f, 0.3f, 0.9f, 0.8f, 0f, 0);
        world.addSegment(GROUND, 0.35f, 0.12f, 0.65f, 0.1f, 0.01f, 0);
        long[] c = circles(world);
        for (int blob = 0; blob < c.length / OF_BLOB; blob++) {
            for (int k = 0; k < OF_BLOB; k++) {
                long circle = c[OF_BLOB * blob + k];
                world.addJoint(circle, c[OF_BLOB * blob + (k + 1) % OF_BLOB], spring(20f, 0.5f));
                world.addJoint(circle, c[OF_BLOB * blob + (k + 2) % OF_BLOB], spring(12f, 0.3f));
                if (k < OF_BLOB / 2) {
                    world.addJoint(
                            circle,
                            c[OF_BLOB * blob + k + OF_BLOB / 2],
                            spring(5f, 0.7f).withLimits(0.01f, 0.02f));
                }
            }
        }
    }

    /** Ropes from the middle, of which those with heavy ends break as they swing. */
    static void ropes(WorldCalls world) {
        long[] c = circles(world);
        for (int k = 0; k < c.length; k++) {
            int rope = k / LINKS;
            JointPlan plan = (rope % 3 == 2 ? spring(10f, 0.5f) : rigid())
                    .breakingAt(35f + rope % 5, Float.POSITIVE_INFINITY)
                    .colliding(rope % 4 == 3);
            if (k % LINKS == 0) {
                world.addJoint(c[k], 0.5f, 0.5f + 0.45f * rope / (c.length / LINKS), plan);
            } else {
                world.addJoint(c[k - 1], c[k], plan);
            }
        }
    }

    /** More spokes than colours; some are soft, and some turn with the hub, which is pinned, and which a motor turns. */
    static void wheel(WorldCalls world) {
        long[] c = circles(world);
        for (int k = 1; k < c.length; k++) {
            JointPlan plan =
                    switch (k % 5) {
                        case 0 -> spring(8f, 0.2f);
                        case 1 -> JointPlan.of(Kind.WELD);
                        case 2 -> JointPlan.of(Kind.LIMITS).withLimits(0.3f, 0.36f);
                        default -> rigid();
                    };
            world.addJoint(c[0], c[k], plan);
        }
        world.addJoint(c[0], 0.5f, 0.5f, JointPlan.of(Kind.SOFT_PIN, 4f, 0.5f));
        world.addJoint(c[0], JointPlan.of(Kind.MOTOR, 3f, 0.5f));
    }

    /** A chain around the world, ropes between circles far apart, and circles on bodies that cross the seams. */
    static void seams(WorldCalls world) {
        long[] c = circles(world);
        for (int k = 0; k < 60; k++) {
            world.addJoint(c[k], c[(k + 1) % 60], spring(3f, 1f).withLength(0.02f));
        }
        for (int k = 60; k + 7 < 400; k += 5) {
            world.addJoint(c[k], c[k + 7], JointPlan.of(Kind.LIMITS).withLimits(0.02f, 0.1f));
        }
        for (int k = 0; k < 4; k++) {
            long body = world.addBody(0.1f + 0.3f * k, 0.9f, k);
            world.addSegment(body, -0.03f, 0f, 0.03f, 0f, 0f, 0);
            world.setBodyVelocity(body, 0.3f * (k - 1), 0.2f * (k + 1), 2f * k - 1f);
            world.addJointToBody(c[500 + k], body, 0.05f, 0.02f, JointPlan.of(Kind.PIN));
            world.addJointToBody(c[510 + k], body, -0.1f, 0f, JointPlan.of(Kind.MOUSE, 5f, 1f, 1e3f));
            world.addJointToBody(c[520 + k], body, 0f, 0.1f, spring(2f, 0.3f).withLength(0.05f));
        }
        world.addJoint(c[530], 0f, 0f, JointPlan.of(Kind.PIN));
        world.addJoint(c[531], c[532], JointPlan.of(Kind.WELD));
    }

    /** Carts with a driven wheel, on slopes; rods hold their loads, welds those of every third one. */
    static void carts(WorldCalls world) {
        world.addSegment(GROUND, 1f, 0.06f, 0.4f, 0.02f, 0f, 0);
        world.addSegment(GROUND, 0.6f, 0.15f, 0f, 0.22f, 0f, 0);
        long[] c = circles(world);
        for (int k = 0; k + 2 < c.length; k += 3) {
            boolean welded = k % 9 == 0;
            world.addJoint(c[k], c[k + 2], rigid());
            world.addJoint(c[k], c[k + 1], welded ? JointPlan.of(Kind.WELD) : rigid());
            world.addJoint(c[k + 1], c[k + 2], welded ? rigid() : spring(12f, 0.6f));
            world.addJoint(
                    c[k], c[k + 1], JointPlan.of(Kind.MOTOR, -12f, 0.02f).breakingAt(Float.POSITIVE_INFINITY, 1f));
            world.addJoint(c[k + 1], JointPlan.of(Kind.SERVO, 0.3f * k, 3f, 0.4f, 0.05f));
            if (k % 4 == 0) {
                world.addJoint(c[k + 2], JointPlan.of(Kind.FRICTION, 0.2f, 0.001f));
            }
        }
    }

    /** A net of springs over a pile. */
    static void net(WorldCalls world) {
        long[] c = circles(world);
        for (int k = 0; k + 41 < c.length; k += 2) {
            world.addJoint(c[k], c[k + 1], spring(6f, 0.4f));
            world.addJoint(c[k], c[k + 40], rigid().breakingAt(400f, Float.POSITIVE_INFINITY));
        }
    }

    /** Circles go and come, joints too, and what they are changes. */
    static void rejoin(GoldenScene.Run run) {
        GoldenChange.churn(run);
        WorldCalls world = run.calls();
        SplittableRandom random = run.random();
        long[] c = circles(world);
        for (int k = 0; k < 4; k++) {
            long circle = c[random.nextInt(c.length)];
            long other = c[random.nextInt(c.length)];
            float at = random.nextInt(1 << 20) * 0x1p-20f;
            if (circle != other) {
                long joint =
                        world.addJoint(circle, other, spring(1f + 3f * at, at).withLength(0.1f * at));
                world.setJointLimits(joint, 0f, 0.1f + at);
            }
            long mouse = world.addJoint(circle, at, 0.8f, JointPlan.of(Kind.MOUSE, 2f, 1f, 20f));
            world.setJointAnchor(mouse, 1f - at, 0.5f);
            if (k % 2 == 0) {
                world.removeJoint(mouse);
            }
        }
    }
}
