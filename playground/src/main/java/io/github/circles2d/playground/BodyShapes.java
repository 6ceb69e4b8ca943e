package io.github.circles2d.playground;

import io.github.circles2d.Bodies;
import io.github.circles2d.FixedStep;
import io.github.circles2d.Outline;
import io.github.circles2d.World;
import java.util.Map;
import java.util.WeakHashMap;

/** Where the outlines of the bodies that are pushed are, as they are drawn: between two steps. It keeps its arrays. */
final class BodyShapes {
    /** How far a drawn line may be from an arc, in reaches of the outline. */
    private static final float TOLERANCE = 0.01f;

    /** Points of outlines around their centroids: outlines are shared. */
    private final Map<Outline, float[]> outlines = new WeakHashMap<>();

    private final Polygons shapes = new Polygons();
    private float[] poses = new float[0];
    private float[] velocities = new float[0];
    private long[] handles = new long[0];
    private double energy;

    /** Reads the bodies of a world, where they are between two steps. */
    void read(World world, FixedStep loop, Shades shades, PaintMode paint) {
        shapes.clear();
        energy = 0;
        Bodies bodies = world.bodies();
        int ids = bodies.idLimit();
        if (poses.length < 3 * ids) {
            poses = new float[3 * (ids + (ids >> 1))];
            velocities = new float[poses.length];
            handles = new long[poses.length];
        }
        if (bodies.size() == 0) {
            return;
        }
        loop.bodies(poses, null);
        bodies.readVelocitiesById(velocities, null);
        int count = 0;
        for (int id = 0; id < ids; id++) {
            if (poses[3 * id] == poses[3 * id]) {
                long body = bodies.handle(id);
                handles[count++] = body;
                measure(world, body, 3 * id);
                int colour = paint == PaintMode.SPEED
                        ? shades.speed(velocities[3 * id], velocities[3 * id + 1])
                        : Shades.tint(id);
                shapes.begin(bodies.isAwake(body) ? colour : Shades.asleep(colour));
                place(points(bodies.outline(body)), 3 * id);
            }
        }
    }

    private void measure(World world, long body, int at) {
        double vx = velocities[at];
        double vy = velocities[at + 1];
        double spin = velocities[at + 2];
        double height = Sandbox.height(world, poses[at], poses[at + 1]);
        Bodies bodies = world.bodies();
        energy += bodies.mass(body) * (0.5 * (vx * vx + vy * vy) + height) + 0.5 * bodies.inertia(body) * spin * spin;
    }

    private float[] points(Outline outline) {
        return outlines.computeIfAbsent(outline, one -> one.points(TOLERANCE * one.reach()));
    }

    private void place(float[] points, int pose) {
        float cos = (float) Math.cos(poses[pose + 2]);
        float sin = (float) Math.sin(poses[pose + 2]);
        for (int k = 0; k < points.length; k += 2) {
            shapes.add(
                    poses[pose] + cos * points[k] - sin * points[k + 1],
                    poses[pose + 1] + sin * points[k] + cos * points[k + 1]);
        }
    }

    Polygons shapes() {
        return shapes;
    }

    /** Of all bodies: that of their motion, and that of their height. */
    double energy() {
        return energy;
    }

    /** The body whose outline is around a place, as it was read last; 0 if there is none. */
    long at(float x, float y) {
        for (int k = shapes.count() - 1; k >= 0; k--) {
            if (contains(k, x, y)) {
                return handles[k];
            }
        }
        return 0;
    }

    private boolean contains(int polygon, float x, float y) {
        boolean inside = false;
        int end = shapes.from(polygon + 1);
        for (int k = shapes.from(polygon), before = end - 1; k < end; before = k++) {
            if (shapes.y(k) > y != shapes.y(before) > y) {
                float share = (y - shapes.y(k)) / (shapes.y(before) - shapes.y(k));
                inside ^= x < shapes.x(k) + share * (shapes.x(before) - shapes.x(k));
            }
        }
        return inside;
    }
}
