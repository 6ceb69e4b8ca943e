package io.github.circles2d.thesis;

import java.nio.FloatBuffer;
import java.util.Arrays;

/** The circles that were added and wait for the next start, laid out as the device wants them. */
public final class CircleList {
    /** Floats a circle in the device's circle buffer: x, y, radius, mass. */
    static final int BODY = 4;

    /** Floats a circle in the device's velocity buffer: vx, vy. */
    static final int VELOCITY = 2;

    private float[] bodies = new float[16 * BODY];
    private float[] velocities = new float[16 * VELOCITY];
    private int size;

    /**
     * Adds a circle: positions and velocities from -1e6 to 1e6, radius and mass from 1e-6 to 1e6. Throws
     * IllegalArgumentException if one of them is out of its range; nothing is added then.
     */
    public void add(float x, float y, float radius, float mass, float vx, float vy) {
        Ranges.circle(x, y, radius, mass, vx, vy);
        if (size * BODY == bodies.length) {
            // Compare with the last array allocated, so a failed growth is retried.
            velocities = Arrays.copyOf(velocities, 2 * VELOCITY * size);
            bodies = Arrays.copyOf(bodies, 2 * BODY * size);
        }
        int body = size * BODY;
        bodies[body] = x;
        bodies[body + 1] = y;
        bodies[body + 2] = radius;
        bodies[body + 3] = mass;
        velocities[size * VELOCITY] = vx;
        velocities[size * VELOCITY + 1] = vy;
        size++;
    }

    /** Forgets all circles. */
    public void clear() {
        size = 0;
    }

    /** The number of circles. */
    public int size() {
        return size;
    }

    /** Writes x, y, radius and mass of every circle to the start of a buffer. */
    void copyBodies(FloatBuffer target) {
        target.duplicate().put(bodies, 0, size * BODY);
    }

    /** Writes vx and vy of every circle to the start of a buffer. */
    void copyVelocities(FloatBuffer target) {
        target.duplicate().put(velocities, 0, size * VELOCITY);
    }
}
