package io.github.circles2d.fuzz;

import io.github.circles2d.Bodies;
import io.github.circles2d.Edge;
import io.github.circles2d.Events;
import io.github.circles2d.Joints;
import io.github.circles2d.World;
import java.util.Arrays;

/** What holds whatever calls have been made: all is finite, and where the edges of a world leave it. */
public final class Soundness {
    private static final float GREATEST = 1e9f;

    private Soundness() {}

    /** Requires it of circles, bodies and joints. */
    static void require(World world, String when) {
        float[] circles = new float[4 * world.size()];
        float[] velocities = new float[2 * world.size()];
        world.read(circles);
        world.readVelocities(velocities);
        for (int k = 0; k < world.size(); k++) {
            require(
                    isWithin(world, circles[4 * k], circles[4 * k + 1])
                            && areSpeeds(velocities[2 * k], velocities[2 * k + 1]),
                    "a circle",
                    Arrays.toString(Arrays.copyOfRange(circles, 4 * k, 4 * k + 4)) + " "
                            + Arrays.toString(Arrays.copyOfRange(velocities, 2 * k, 2 * k + 2)) + " after " + when);
        }
        Bodies bodies = world.bodies();
        long[] handles = new long[bodies.size()];
        bodies.readHandles(handles);
        for (long body : handles) {
            require(
                    isWithin(world, bodies.x(body), bodies.y(body))
                            && areSpeeds(bodies.vx(body), bodies.vy(body), bodies.angularVelocity(body)),
                    "a body",
                    bodies.x(body) + ", " + bodies.y(body) + ", " + bodies.vx(body) + ", " + bodies.vy(body) + ", "
                            + bodies.angularVelocity(body) + " after " + when);
        }
        require(world.joints(), when);
    }

    private static void require(Joints joints, String when) {
        float[] ends = new float[4 * joints.size()];
        joints.readEnds(ends);
        for (float each : ends) {
            require(Float.isFinite(each), "an end of a joint", each + " after " + when);
        }
        for (int id = 0; id < joints.idLimit(); id++) {
            long joint = joints.handle(id);
            boolean isSound = joint == 0
                    || !Float.isNaN(joints.force(joint))
                            && !Float.isNaN(joints.torque(joint))
                            && Float.isFinite(joints.length(joint));
            require(isSound, "a joint", id + " after " + when);
        }
    }

    /** Requires it of events, and returns them. */
    public static Events require(Events events) {
        for (int i = 0; i < events.size(); i++) {
            boolean isSound = events.speed(i) >= 0
                    && events.speed(i) < Float.POSITIVE_INFINITY
                    && events.slipSpeed(i) >= 0
                    && events.slipSpeed(i) < Float.POSITIVE_INFINITY
                    && Math.abs(events.impulse(i)) < Float.POSITIVE_INFINITY
                    && Math.abs(events.x(i)) < 1e10f
                    && Math.abs(events.y(i)) < 1e10f
                    && Math.abs(events.normalX(i)) < 1.001f
                    && Math.abs(events.normalY(i)) < 1.001f
                    && (events.side(i) == null && events.piece(i) == 0) == (events.b(i) != 0);
            require(isSound, "an event", "number " + i);
        }
        return events;
    }

    private static void require(boolean isSound, String what, String values) {
        if (!isSound) {
            throw new Mismatch(what + " is not sound", values);
        }
    }

    private static boolean areSpeeds(float... speeds) {
        for (float each : speeds) {
            if (!(Math.abs(each) <= GREATEST)) {
                return false;
            }
        }
        return true;
    }

    private static boolean isWithin(World world, float x, float y) {
        return isWithin(x, world.edgeX(), world.minX(), world.maxX())
                && isWithin(y, world.edgeY(), world.minY(), world.maxY());
    }

    private static boolean isWithin(float value, Edge edge, float low, float high) {
        return switch (edge) {
            case WALL -> value >= low && value <= high;
            case WRAP -> value >= low && value < high;
            case OPEN -> Math.abs(value) <= GREATEST;
        };
    }
}
