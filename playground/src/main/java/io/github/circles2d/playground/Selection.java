package io.github.circles2d.playground;

import io.github.circles2d.Joints;
import io.github.circles2d.World;
import java.nio.FloatBuffer;
import java.util.ArrayList;
import java.util.List;

/** The circle that was clicked last with the tool that grabs, and its numbers. */
final class Selection {
    private static final int MOST_JOINTS = 4;

    /** The ring that marks it, in its radii. */
    private static final float AROUND = 1.25f;

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

    /** A ring around it, where it is shown. */
    void mark(Sandbox sandbox, List<Mark> marks) {
        World world = sandbox.world();
        long one = circle(world);
        if (one != 0) {
            FloatBuffer at = sandbox.loop().positions(null);
            int x = 2 * World.id(one);
            boolean shown = x < at.limit() && at.get(x) == at.get(x);
            marks.add(Mark.ring(
                    shown ? at.get(x) : world.x(one),
                    shown ? at.get(x + 1) : world.y(one),
                    AROUND * world.radius(one),
                    1));
        }
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
        lines.add(Figures.format("circle %,d, kind %d%s", id, world.kindOf(one), world.isAwake(one) ? "" : ", asleep"));
        lines.add(Figures.format("position  %.2f, %.2f", world.x(one), world.y(one)));
        lines.add(Figures.format("velocity  %.2f, %.2f", world.vx(one), world.vy(one)));
        lines.add(Figures.format("angle  %.2f, turns %.2f a second", world.angle(one), world.angularVelocity(one)));
        lines.add(Figures.format("radius %.3g, ", world.radius(one))
                + (isStatic ? "static" : Figures.format("mass %.3g", world.mass(one))));
        if (loads.length < 2 * world.idLimit()) {
            loads = new float[2 * world.idLimit()];
        }
        world.readLoadsById(loads, null);
        lines.add(Figures.format("contacts  %.0f, force %.3g", loads[2 * id], loads[2 * id + 1]));
        long[] joints = new long[MOST_JOINTS];
        int count = world.joints().ofCircle(one, joints);
        StringBuilder kinds = new StringBuilder();
        for (int k = 0; k < Math.min(count, MOST_JOINTS); k++) {
            kinds.append(k == 0 ? ", id " : ", ").append(Joints.id(joints[k]));
        }
        lines.add("joints  " + count + kinds + (count > MOST_JOINTS ? " ..." : ""));
        return lines;
    }
}
