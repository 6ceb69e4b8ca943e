package io.github.circles2d;

import io.github.circles2d.reference.JointPlan;
import io.github.circles2d.reference.JointPlan.Kind;
import java.util.SplittableRandom;

/** What a caller does to a heap most of which sleeps: seldom, so that it comes to rest in between. */
final class GoldenSleep {
    /** The changes from one that does something to the next. */
    private static final int CALM = 20;

    private static final int GROUND = 0;

    private GoldenSleep() {}

    /** The number of such a change, from 1 on; 0 for one that does nothing. */
    private static int number(GoldenScene.Run run) {
        int change = run.steps() / GoldenChange.PERIOD;
        return change % CALM == 0 ? change / CALM : 0;
    }

    /** A ball falls on the heap: a light one, or a heavy and fast one. */
    static void ball(GoldenScene.Run run) {
        int n = number(run);
        if (n > 0) {
            boolean isLight = n % 2 == 1;
            run.calls().add(0.2f * n % 1f, 0.85f, isLight ? 0.02f : 0.04f, isLight ? 1f : 40f, 0f, isLight ? 0f : -3f);
        }
    }

    /** A circle falls, again and again, for some time; then nothing does. */
    static void pour(GoldenScene.Run run) {
        int change = run.steps() / GoldenChange.PERIOD;
        if (change >= CALM && change / CALM % 2 == 1 && change % 2 == 0) {
            float x = 0.45f + 0.1f * GoldenChange.unit(run.random());
            run.calls().add(x, 0.9f, 0.02f + 0.01f * GoldenChange.unit(run.random()), 3f, 0f, -0.5f);
        }
    }

    /** Some circles of the lowest row go, or one of them shrinks. */
    static void support(GoldenScene.Run run) {
        int n = number(run);
        if (n == 0) {
            return;
        }
        long[] handles = run.readHandles();
        float[] circles = run.readCircles();
        int gone = 0;
        for (int i = 0; i < handles.length && gone < 3; i++) {
            if (circles[4 * i + 1] < 0.05f && run.random().nextInt(3) == 0) {
                gone++;
                if (n % 2 == 1) {
                    run.calls().remove(handles[i]);
                } else {
                    run.calls().setRadius(handles[i], 0.8f * circles[4 * i + 2]);
                }
            }
        }
    }

    /** Gravity leans a little further, is gone for some time, or is what it was. */
    static void tilt(GoldenScene.Run run) {
        switch (number(run)) {
            case 1 -> run.calls().setGravity(0.1f, -1f);
            case 2 -> run.calls().setGravity(0.35f, -0.94f);
            case 3 -> run.calls().setGravity(0f, 0f);
            case 4 -> run.calls().setGravity(0f, -1f);
            default -> {}
        }
    }

    /** One call of each sort that wakes, and some that do not. */
    static void calls(GoldenScene.Run run) {
        int n = number(run);
        if (n == 0) {
            return;
        }
        WorldCalls world = run.calls();
        SplittableRandom random = run.random();
        long[] handles = run.readHandles();
        long some = handles[random.nextInt(handles.length)];
        world.setTag(some, n);
        switch (n) {
            case 1 -> world.explode(0.5f, 0f, 0.2f, 0.5f, 1f);
            case 2 -> world.setForce(some, 3f, 2f);
            case 3 -> {
                world.wake(some);
                world.setPosition(handles[0], 0.5f, 0.7f);
            }
            case 4 -> world.setFriction(some, 1f);
            case 5 -> world.setSleeps(0, false);
            case 6 -> world.setSleeps(0, true);
            default -> world.wakeAll();
        }
    }

    /** A ball falls on a pyramid, a crate of its lowest row goes, others are driven and woken, and gravity tilts. */
    static void crates(GoldenScene.Run run) {
        WorldCalls world = run.calls();
        long[] crates = world.rigids();
        long ball = run.readHandles()[0];
        switch (number(run)) {
            case 1 -> {
                world.teleport(ball, 0.55f, 0.7f);
                world.setVelocity(ball, 0f, 0f);
            }
            case 2 -> world.removeRigid(crates[3]);
            case 3 -> {
                world.driveRigid(crates[0], 0.001f, 0f, 0f);
                world.wakeRigid(crates[crates.length - 1]);
            }
            case 4 -> world.setGravity(0.2f, -0.98f);
            default -> {}
        }
    }

    /** As {@link #ball}; the time step becomes another one from time to time. */
    static void timeStep(GoldenScene.Run run) {
        if (number(run) > 0) {
            GoldenChange.timeStep(run);
        }
        ball(run);
    }

    /** A floor with a ditch, and a plate in it, on which circles lie. */
    static void ground(WorldCalls world) {
        world.addSegment(GROUND, 0f, 0.1f, 0.3f, 0.1f, 0f, 0);
        world.addSegment(GROUND, 0.7f, 0.1f, 1f, 0.1f, 0f, 0);
        long plate = world.addBody(0.5f, 0.02f, 0f);
        world.addSegment(plate, -0.15f, 0f, 0.15f, 0f, 0.01f, 0);
    }

    /** The plate rises slowly, stands, and sinks. */
    static void lift(GoldenScene.Run run) {
        int n = number(run);
        if (n > 0) {
            run.calls().setBodyVelocity(1L << 32 | 1 << 28 | 1, 0f, new float[] {0f, 0.02f, 0f, -0.05f}[n % 4], 0f);
        }
    }

    /** A rope from the ceiling, whose end lies in the heap. */
    static void rope(WorldCalls world) {
        long[] handles = new long[world.size()];
        world.readHandles(handles);
        JointPlan rod = JointPlan.of(Kind.LIMITS).withLimits(0f, 0.1f);
        long upper = 0;
        for (int k = 0; k < 5; k++) {
            long bead = k == 4 ? handles[142] : world.add(0.5f, 0.95f - 0.08f * k, 0.02f, 2f, 0f, 0f);
            if (k == 0) {
                world.addJoint(bead, 0.5f, 1f, rod);
            } else {
                world.addJoint(upper, bead, rod);
            }
            upper = bead;
        }
    }

    /** Somebody pulls at the rope. */
    static void pull(GoldenScene.Run run) {
        if (number(run) > 0) {
            run.calls().applyImpulse(run.readHandles()[142], 0f, 4f);
        }
    }

    /** A bridge over the heap, with a wheel that a motor turns; a soft body and a bar of welded circles in the heap. */
    static void joints(WorldCalls world) {
        world.setMotion(0, 1f, 1f, 100f);
        long[] handles = new long[world.size()];
        world.readHandles(handles);
        long before = 0;
        for (int k = 0; k < 8; k++) {
            long bead = world.add(0.15f + 0.1f * k, 0.8f, 0.02f, 2f, 0f, 0f);
            if (k == 0) {
                world.addJoint(bead, 0.05f, 0.8f, JointPlan.of(Kind.DISTANCE));
            } else {
                world.addJoint(
                        before,
                        bead,
                        k == 4 ? JointPlan.of(Kind.LIMITS).withLimits(0f, 0.11f) : JointPlan.of(Kind.DISTANCE));
            }
            before = bead;
        }
        world.addJoint(before, 0.95f, 0.8f, JointPlan.of(Kind.SPRING, 2f, 1f));
        for (int k = 0; k < 6; k++) {
            world.addJoint(handles[k], handles[k + 1], JointPlan.of(Kind.SPRING, 3f, 0.7f));
            world.addJoint(
                    handles[20 + k], handles[21 + k], JointPlan.of(Kind.WELD).breakingAt(60f, 60f));
        }
        world.addJoint(handles[40], JointPlan.of(Kind.MOTOR, 0.5f, 1f));
    }

    /** A ball falls on the bridge, or a joint changes, breaks or goes. */
    static void changeJoints(GoldenScene.Run run) {
        int n = number(run);
        WorldCalls world = run.calls();
        switch (n) {
            case 0 -> {}
            case 2 -> world.setJointSpeed(joint(21), 0f);
            case 3 -> world.setJointLength(joint(5), 0.08f);
            case 4 -> world.setJointSpring(joint(8), 5f, 1f);
            case 5 -> world.removeJoint(joint(3));
            default -> world.add(0.42f + 0.1f * n % 0.3f, 0.95f, 0.025f, 5f, 0f, -0.5f);
        }
    }

    private static long joint(int id) {
        return 1L << 32 | 1 << 30 | id;
    }
}
