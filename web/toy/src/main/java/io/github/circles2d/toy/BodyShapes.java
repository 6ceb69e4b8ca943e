package io.github.circles2d.toy;

import io.github.circles2d.Bodies;
import io.github.circles2d.Outline;
import java.util.HashMap;
import java.util.Map;
import org.teavm.jso.typedarrays.Float32Array;

/** Where the outlines of bodies that are pushed are: x, y and a number of the body for each point, as soft bodies are drawn. */
final class BodyShapes {
    private static final int STRIDE = 3;

    /** Behind the numbers of soft bodies. */
    private static final int FIRST_NUMBER = 1_000;

    /** How far a drawn line may be from an arc, in reaches of the outline. */
    private static final float TOLERANCE = 0.01f;

    private final Map<Outline, float[]> outlines = new HashMap<>();
    private float[] poses = new float[0];

    /** The points of soft bodies, and behind them those of bodies. */
    Float32Array append(Float32Array blobs, Bodies bodies) {
        if (bodies.size() == 0) {
            return blobs;
        }
        int ids = bodies.idLimit();
        if (poses.length < 3 * ids) {
            poses = new float[3 * (ids + ids / 2)];
        }
        bodies.readById(poses, null);
        int count = 0;
        for (int id = 0; id < ids; id++) {
            count += Float.isNaN(poses[3 * id]) ? 0 : points(bodies, id).length / 2;
        }
        Float32Array all = new Float32Array(blobs.getLength() + STRIDE * count);
        all.set(blobs);
        int at = blobs.getLength();
        for (int id = 0; id < ids; id++) {
            if (!Float.isNaN(poses[3 * id])) {
                at = place(points(bodies, id), id, all, at);
            }
        }
        return all;
    }

    private float[] points(Bodies bodies, int id) {
        return outlines.computeIfAbsent(bodies.outline(bodies.handle(id)), one -> one.points(TOLERANCE * one.reach()));
    }

    private int place(float[] points, int id, Float32Array all, int from) {
        float cos = (float) Math.cos(poses[3 * id + 2]);
        float sin = (float) Math.sin(poses[3 * id + 2]);
        int at = from;
        for (int k = 0; k < points.length; k += 2) {
            all.set(at++, poses[3 * id] + cos * points[k] - sin * points[k + 1]);
            all.set(at++, poses[3 * id + 1] + sin * points[k] + cos * points[k + 1]);
            all.set(at++, FIRST_NUMBER + id);
        }
        return at;
    }

    /** The body around a place; 0 if there is none. */
    long at(Bodies bodies, float x, float y) {
        for (int id = 0; id < bodies.idLimit(); id++) {
            long body = bodies.handle(id);
            if (body != 0 && contains(points(bodies, id), bodies, body, x, y)) {
                return body;
            }
        }
        return 0;
    }

    /** Whether a place is in an outline: a ray to the right crosses it an odd number of times. */
    private static boolean contains(float[] points, Bodies bodies, long body, float x, float y) {
        double cos = Math.cos(bodies.angle(body));
        double sin = Math.sin(bodies.angle(body));
        double dx = x - bodies.x(body);
        double dy = y - bodies.y(body);
        double px = cos * dx + sin * dy;
        double py = cos * dy - sin * dx;
        boolean inside = false;
        for (int k = 0, before = points.length - 2; k < points.length; before = k, k += 2) {
            if (points[k + 1] > py != points[before + 1] > py) {
                double share = (py - points[k + 1]) / (points[before + 1] - points[k + 1]);
                inside ^= px < points[k] + share * (points[before] - points[k]);
            }
        }
        return inside;
    }
}
