package io.github.circles2d.playground;

import io.github.circles2d.Joints;
import io.github.circles2d.World;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** The circle that was clicked last with the tool that grabs, and its numbers. */
final class Selection {
    private static final int MOST_JOINTS = 4;

    private long circle;
    private float[] loads = new float[0];

    /** Takes another circle; 0 for none. */
    void set(long next) {
        circle = next;
    }

    /** The circle; 0 if there is none, or it has gone. */
    long circle(World world) {
        if (circle != 0 && !world.contains(circle)) {
            circle = 0;
        }
        return circle;
    }

    /** Where it is and what it does, a line for each; none if no circle is selected. */
    List<String> lines(World world) {
        long one = circle(world);
        if (one == 0) {
            return List.of();
        }
        int id = World.id(one);
        boolean isStatic = world.mass(one) == Float.POSITIVE_INFINITY;
        List<String> lines = new ArrayList<>();
        lines.add(format("circle %,d, kind %d", id, world.kindOf(one)));
        lines.add(format("position  %.2f, %.2f", world.x(one), world.y(one)));
        lines.add(format("velocity  %.2f, %.2f", world.vx(one), world.vy(one)));
        lines.add(format("angle  %.2f, turns %.2f a second", world.angle(one), world.angularVelocity(one)));
        lines.add(format("radius %.3g, ", world.radius(one))
                + (isStatic ? "static" : format("mass %.3g", world.mass(one))));
        if (loads.length < 2 * world.idLimit()) {
            loads = new float[2 * world.idLimit()];
        }
        world.readLoadsById(loads, null);
        lines.add(format("contacts  %.0f, force %.3g", loads[2 * id], loads[2 * id + 1]));
        long[] joints = new long[MOST_JOINTS];
        int count = world.joints().ofCircle(one, joints);
        StringBuilder kinds = new StringBuilder();
        for (int k = 0; k < Math.min(count, MOST_JOINTS); k++) {
            kinds.append(k == 0 ? ", id " : ", ").append(Joints.id(joints[k]));
        }
        lines.add("joints  " + count + kinds + (count > MOST_JOINTS ? " ..." : ""));
        return lines;
    }

    private static String format(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }
}
