package io.github.circles2d;

import io.github.circles2d.reference.BodyOutline;
import io.github.circles2d.reference.ChainShape;
import io.github.circles2d.reference.JointPlan;
import io.github.circles2d.reference.JointPlan.Kind;
import java.util.SplittableRandom;

/** The bodies that are pushed of the scenes on record, with the terrain that some of them have, and what a caller does to them. */
final class GoldenBodies {
    static final int OF_PYRAMID = 36;
    static final int DOMINOES = 14;
    static final int CRATES = 8;
    static final int CROSSED = 12;
    static final int MIXED = 18;
    static final int ON_LIFTS = 12;
    static final int ON_ENDS = 20;

    private static final float PI = (float) Math.PI;
    private static final int GROUND = 0;

    /** A kind that bounces, and that balls of the same kind pass. */
    private static final int BOUNCY = 4;

    private static final int TEETH = 10;

    private GoldenBodies() {}

    /** Eight rows of crates. */
    static void pyramid(WorldCalls world) {
        BodyOutline crate = BodyOutline.box(0.06f, 0.06f);
        for (int row = 0; row < 8; row++) {
            for (int k = 0; k < 8 - row; k++) {
                world.addRigid(crate, 0.3f + 0.07f * k + 0.035f * row, 0.03f + 0.06f * row, 0f, 0.0036f, 0);
            }
        }
    }

    /** The ball comes again from the left, and heavier each time. */
    static void ball(GoldenScene.Run run) {
        int change = run.steps() / GoldenChange.PERIOD;
        long ball = run.readHandles()[0];
        if (change % 20 == 10) {
            run.calls().setMass(ball, 0.004f + 0.0004f * change);
            run.calls().teleport(ball, 0.05f, 0.1f + 0.002f * change);
            run.calls().setVelocity(ball, 1.5f, 0.3f);
        }
    }

    /** Planks and others that cross, in pairs and in stars of three. */
    static void crossed(WorldCalls world) {
        for (int k = 0; k < CROSSED; k++) {
            BodyOutline plank =
                    k % 4 == 3 ? BodyOutline.capsule(0.2f, 0.012f) : BodyOutline.box(0.24f, 0.02f + 0.004f * (k % 3));
            float x = 0.2f + 0.3f * (k % 3) + 0.01f * (k / 3);
            world.addRigid(plank, x, 0.3f + 0.02f * (k / 3), 0.35f * k + 0.9f * (k / 3), 0.002f, 0);
        }
    }

    /** One of the planks comes to lie across another one. */
    static void cross(GoldenScene.Run run) {
        WorldCalls world = run.calls();
        long[] bodies = world.rigids();
        int change = run.steps() / GoldenChange.PERIOD;
        if (change % 6 == 5) {
            world.teleportRigid(bodies[change % CROSSED], 0.3f + 0.05f * (change % 9), 0.25f, 0.5f * change);
            world.teleportRigid(
                    bodies[(change + 4) % CROSSED], 0.31f + 0.05f * (change % 9), 0.26f, 0.8f * change + 1f);
        }
    }

    static void dominoes(WorldCalls world) {
        BodyOutline domino = BodyOutline.box(0.012f, 0.1f).round(0.001f);
        for (int k = 0; k < DOMINOES; k++) {
            world.addRigid(domino, 0.2f + 0.055f * k, 0.05f, 0f, 0.0012f, 0);
        }
    }

    /** Crates and planks from light to heavy above a pit. */
    static void crates(WorldCalls world) {
        for (int k = 0; k < CRATES; k++) {
            BodyOutline outline = k % 3 == 2 ? BodyOutline.box(0.2f, 0.03f) : BodyOutline.box(0.09f, 0.07f);
            world.addRigid(outline, 0.14f + 0.24f * (k % 4), 0.72f + 0.15f * (k / 4), 0.4f * k, 1f + k * k, 0);
        }
    }

    /** Two gears, so heavy that they stay where they are; their teeth have play. */
    static void gears(WorldCalls world) {
        float[] points = new float[8 * TEETH];
        for (int k = 0; k < 4 * TEETH; k++) {
            double angle = 2 * StrictMath.PI / TEETH * (k / 4 + new double[] {-0.26, -0.12, 0.12, 0.26}[k % 4]);
            double r = k % 4 == 1 || k % 4 == 2 ? 0.17 : 0.13;
            points[2 * k] = (float) (r * StrictMath.cos(angle));
            points[2 * k + 1] = (float) (r * StrictMath.sin(angle));
        }
        world.setMotion(BOUNCY, 0f, 0f, Float.POSITIVE_INFINITY);
        BodyOutline gear = BodyOutline.polygon(points);
        long driver = world.addRigid(gear, 0.35f, 0.6f, 0f, 1000f, BOUNCY);
        long driven = world.addRigid(gear, 0.658f, 0.6f, PI + PI / TEETH, 1000f, BOUNCY);
        world.setRigidInertia(driver, 0.01f);
        world.setRigidInertia(driven, 0.01f);
    }

    static void drive(GoldenScene.Run run) {
        long[] gears = run.calls().rigids();
        run.calls().setRigidVelocity(gears[0], 0f, 0f, run.steps() < 500 ? 2f : -3f);
        run.calls().pressRigid(gears[1], 0f, 0f, 0.01f);
    }

    private static BodyOutline outline(int k) {
        float s = 0.04f + 0.002f * k;
        float half = 0.5f * s;
        return switch (k % 6) {
            case 0 -> BodyOutline.box(s, 0.7f * s);
            case 1 -> BodyOutline.capsule(s, 0.3f * s);
            case 2 -> BodyOutline.polygon(0f, 0f, s, 0f, 0.4f * s, s).round(0.08f * s);
            case 3 ->
                BodyOutline.polygon(
                        -half, -half, half, -half, half, half, 0.3f * s, half, 0.3f * s, -0.2f * s, -0.3f * s,
                        -0.2f * s, -0.3f * s, half, -half, half);
            case 4 -> BodyOutline.closed(half, 0f, new float[] {0f, 0f, PI}, new float[] {0f, 0f, PI});
            default ->
                BodyOutline.closed(
                        -half, 0f, new float[] {0f, -0.3f * s}, new float[] {half, 0f}, new float[] {0f, 0f, PI});
        };
    }

    private static void add(WorldCalls world, float x, float y, int k) {
        world.addRigid(outline(k), x, y, 0.7f * k, 0.5f + 0.25f * (k % 5), k % 5 == 3 ? BOUNCY : 0);
    }

    private static void grid(WorldCalls world, float left, float bottom, float apart) {
        world.setKindRestitution(BOUNCY, 0.9f);
        for (int k = 0; k < MIXED; k++) {
            add(world, left + apart * (k % 5), bottom + apart * (k / 5), k);
        }
    }

    /** In a drum with twelve paddles that turns. */
    static void drum(WorldCalls world) {
        GoldenTerrain.drum(world);
        grid(world, 0.26f, 0.3f, 0.12f);
    }

    static void mixed(WorldCalls world) {
        grid(world, 0.12f, 0.2f, 0.18f);
    }

    /** In three groups; some are in none. */
    static void groups(WorldCalls world) {
        mixed(world);
        long[] bodies = world.rigids();
        for (int k = 0; k < MIXED; k++) {
            world.setRigidGroup(bodies[k], k % 4);
        }
    }

    /** Forces that last, and some at a point; a body and a circle get other groups. */
    static void steer(GoldenScene.Run run) {
        WorldCalls world = run.calls();
        long[] bodies = world.rigids();
        long[] circles = run.readHandles();
        int change = run.steps() / GoldenChange.PERIOD;
        float x = change % 5 - 2f;
        float y = change % 7;
        world.driveRigid(bodies[change * 5 % bodies.length], x, y, 0.01f * x);
        world.pressRigidAt(bodies[change % bodies.length], 5f * x, 4f * y, 0.5f, 0.9f);
        world.setRigidGroup(bodies[change * 7 % bodies.length], change % 4);
        world.setGroup(circles[change % circles.length], change % 3 + 1);
    }

    /** All sorts of joints, between bodies, of bodies and circles, and at places of the world and of a body of terrain that turns. */
    static void machines(WorldCalls world) {
        mixed(world);
        long[] bodies = world.rigids();
        long[] circles = circles(world);
        long mill = world.addBody(0.5f, 0.85f, 0.2f);
        world.setBodyVelocity(mill, 0.01f, -0.005f, 1.5f);
        for (int k = 0; k < 4; k++) { // a chain, which hangs on the mill
            world.addRigidJoint(bodies[k], 0.03f, 0f, bodies[k + 1], -0.03f, 0.005f, of(Kind.PIN));
        }
        world.addRigidJointToBody(bodies[0], -0.03f, 0f, mill, 0.08f, 0f, of(Kind.PIN));
        world.addRigidJointToPlace(bodies[5], 0.02f, 0.01f, 0.3f, 0.6f, of(Kind.PIN));
        world.addJoint(bodies[5], of(Kind.MOTOR, 4f, 0.02f));
        world.addRigidJoint(bodies[6], 0.02f, 0f, bodies[7], -0.02f, 0.01f, of(Kind.SPRING, 6f, 0.3f));
        world.addRigidJoint(bodies[6], 0f, 0f, bodies[8], 0f, 0f, of(Kind.WELD).breakingAt(60f, 3f));
        world.addRigidJointToCircle(bodies[9], 0.04f, -0.03f, circles[0], of(Kind.PIN));
        world.addRigidJointToCircle(bodies[9], -0.04f, -0.03f, circles[1], of(Kind.SOFT_PIN, 8f, 0.7f));
        world.addJoint(circles[0], bodies[9], of(Kind.MOTOR, -6f, 0.05f));
        world.addJoint(circles[2], bodies[10], of(Kind.WELD));
        world.addRigidJointToPlace(
                bodies[11], 0f, 0.03f, 0.7f, 0.9f, of(Kind.LIMITS).withLimits(0.05f, 0.25f));
        world.addRigidJointToPlace(bodies[12], 0.01f, 0.02f, 0.5f, 0.5f, of(Kind.MOUSE, 5f, 1f, 40f));
        world.addJoint(bodies[13], of(Kind.SERVO, 0.5f, 3f, 0.5f, 0.05f));
        world.addJoint(bodies[13], bodies[14], of(Kind.SERVO, -0.5f, 40f, 1f, 0.02f));
        world.addJoint(bodies[15], of(Kind.FRICTION, 4f, 0.02f));
        world.addRigidJoint(
                bodies[16], 0f, 0.02f, bodies[17], 0f, -0.02f, of(Kind.DISTANCE).colliding(true));
    }

    private static JointPlan of(Kind kind, float... numbers) {
        return JointPlan.of(kind, numbers);
    }

    private static long[] circles(WorldCalls world) {
        long[] circles = new long[world.size()];
        world.readHandles(circles);
        return circles;
    }

    /** The mouse goes round; joints come, go and change. */
    static void rejoin(GoldenScene.Run run) {
        WorldCalls world = run.calls();
        long[] bodies = world.rigids();
        int change = run.steps() / GoldenChange.PERIOD;
        long body = bodies[change * 5 % bodies.length];
        long other = bodies[change * 7 % bodies.length];
        float x = 0.1f * (change % 9);
        world.addRigidJointToPlace(
                body,
                0.01f,
                0f,
                x,
                0.5f,
                of(Kind.MOUSE, 2f + change % 5, 0.7f, 10f).breakingAt(9f, 1f));
        world.addRigidJointToPlace(
                body, 0f, 0.02f, x, 0.9f, of(Kind.LIMITS).withLimits(0f, 0.6f).breakingAt(30f, 1f));
        if (body != other) {
            Kind kind = change % 3 == 0 ? Kind.PIN : change % 3 == 1 ? Kind.WELD : Kind.DISTANCE;
            world.addRigidJoint(
                    body,
                    0.01f,
                    0.01f,
                    other,
                    0f,
                    0f,
                    of(kind).breakingAt(3f, 0.2f).colliding(change % 2 == 0));
        }
        world.pushRigid(other, 0.3f, 0.5f, 0.5f, 0.5f);
        if (change % 20 == 19) {
            world.removeRigid(other);
            add(world, x, 0.5f, change % MIXED);
        }
    }

    /** Land with slopes, thick segments, an arch and a bowl, off which bodies fall. */
    static void onLand(WorldCalls world) {
        world.addChain(
                GROUND,
                new ChainShape(
                        0.98f,
                        0.15f,
                        new float[][] {{0.8f, 0.05f}, {0.6f, 0.05f, -PI}, {0.3f, 0.06f}, {0.15f, 0.06f, 2f}},
                        false),
                0,
                new long[4]);
        world.addSegment(GROUND, 0.05f, 0.5f, 0.35f, 0.42f, 0.01f, 0);
        world.addArc(GROUND, 0.75f, 0.4f, 0.1f, PI, 2f * PI, ArcSide.INNER, 0);
        world.addArc(GROUND, 0.5f, 0.2f, 0.05f, 0f, 2f * PI, ArcSide.OUTER, 0);
        grid(world, 0.12f, 0.6f, 0.17f);
    }

    /** Half discs, lenses, discs and boxes that bounce as they turn, over bare ends of segments. */
    static void onEnds(WorldCalls world) {
        world.setKindRestitution(BOUNCY, 0.7f);
        for (int k = 0; k < 5; k++) {
            world.addSegment(GROUND, 0.1f + 0.2f * k, 0.05f, 0.1f + 0.2f * k, 0.3f, 0.005f * (k % 2), 0);
        }
        for (int k = 0; k < ON_ENDS; k++) {
            float s = 0.07f + 0.004f * (k % 5);
            float half = 0.5f * s;
            BodyOutline outline =
                    switch (k % 4) {
                        case 0 -> BodyOutline.closed(half, 0f, new float[] {0f, 0f, PI}, new float[] {0f, 0f, PI});
                        case 1 -> BodyOutline.closed(-half, 0f, new float[] {half, 0f}, new float[] {0f, 0f, PI});
                        case 2 -> BodyOutline.lens(s);
                        default -> BodyOutline.box(s, 0.6f * s);
                    };
            float x = 0.1f + 0.2f * (k % 5) + (k % 4 == 0 ? 0f : 0.004f);
            long body = world.addRigid(outline, x, 0.38f + 0.13f * (k / 5), 0.9f * k, 1f, k % 4 == 3 ? BOUNCY : 0);
            world.setRigidVelocity(body, 0f, 0f, k % 4 == 0 ? 0f : 1.5f * (k % 3));
        }
    }

    /** Crates, capsules and planks on lifts that bodies pass from below, over a belt, under a boulder. */
    static void onLifts(WorldCalls world) {
        GoldenTerrain.lifts(world);
        world.setSurface(GoldenTerrain.BELT, 0.8f, 0.01f, 0.3f);
        world.addSegment(GROUND, 0.9f, 0.02f, 0.1f, 0.02f, 0.01f, GoldenTerrain.BELT);
        world.setResponse(BOUNCY, 0, Response.IGNORE);
        for (int k = 0; k < ON_LIFTS; k++) {
            BodyOutline outline =
                    switch (k % 3) {
                        case 0 -> BodyOutline.box(0.06f, 0.05f);
                        case 1 -> BodyOutline.capsule(0.05f, 0.02f);
                        default -> BodyOutline.box(0.14f, 0.02f);
                    };
            world.addRigid(
                    outline, 0.15f + 0.24f * (k % 4), 0.12f + 0.25f * (k / 4), 0f, 0.1f, k % 4 == 3 ? BOUNCY : 0);
        }
        world.setRigidVelocity(world.rigids()[1], 0f, 2f, 0f);
    }

    /** Bodies bounce more and more, and one of them gets a push. */
    static void bounce(GoldenScene.Run run) {
        WorldCalls world = run.calls();
        long[] bodies = world.rigids();
        int change = run.steps() / GoldenChange.PERIOD;
        long body = bodies[change % bodies.length];
        world.setRigidRestitution(body, change < 60 ? change / 60f : 1f);
        world.turnRigid(bodies[change * 5 % bodies.length], 1e-3f);
        world.pushRigid(body, 0.3f, 0.4f, 0.98f, 0.3f);
    }

    /** All calls on bodies. */
    static void churn(GoldenScene.Run run) {
        WorldCalls world = run.calls();
        SplittableRandom random = run.random();
        long[] bodies = world.rigids();
        long body = bodies[random.nextInt(bodies.length)];
        float x = 0.1f + 0.8f * GoldenChange.unit(random);
        float y = 0.1f + 0.8f * GoldenChange.unit(random);
        switch (run.steps() / GoldenChange.PERIOD % 12) {
            case 0 -> world.setRigidVelocity(body, x - 0.5f, y, 20f * x - 10f);
            case 1 -> world.teleportRigid(body, x, y, 6f * x);
            case 2 -> world.pushRigid(body, 0.3f * x, 0.3f * y, 0.5f, 0.5f);
            case 3 -> world.turnRigid(body, 1e-3f * x);
            case 4 -> world.pressRigid(body, 20f * x, 30f * y, 0.1f * (x - y));
            case 5 -> world.setRigidKind(body, random.nextBoolean() ? BOUNCY : 0);
            case 6 -> world.setRigidRestitution(body, x);
            case 7 -> world.setRigidInertia(body, x < 0.3f ? Float.POSITIVE_INFINITY : 2f * x);
            case 8 -> {
                world.removeRigid(body);
                add(world, x, y, random.nextInt(MIXED));
            }
            case 9 -> world.setRigidTag(body, run.steps());
            case 10 -> world.setResponse(BOUNCY, BOUNCY, random.nextBoolean() ? Response.IGNORE : Response.SOLID);
            default -> world.setGravity(x - 0.5f, 0.2f - y);
        }
    }
}
