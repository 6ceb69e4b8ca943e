package io.github.circles2d.world;

import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.model.CircleRow;

/** The last bulk read-back, which answers reads of single values until the state changes. */
final class LastReading {
    private final Pipeline pipeline;
    private final HandleTable handles;
    private final Runnable beforeReading;
    private float[] circles = new float[0];
    private float[] velocities = new float[0];
    private boolean circlesCurrent;
    private boolean velocitiesCurrent;

    /** How often circles have changed. */
    private long changes;

    /** How often circles have been read. */
    private long number;

    /**
     * Nothing read yet.
     *
     * @param pipeline what to read from
     * @param handles which ids live
     * @param beforeReading what brings the pipeline up to date
     */
    LastReading(Pipeline pipeline, HandleTable handles, Runnable beforeReading) {
        this.pipeline = pipeline;
        this.handles = handles;
        this.beforeReading = beforeReading;
    }

    /** Circles have come, gone or changed. */
    void forgetCircles() {
        circlesCurrent = false;
        changes++;
    }

    /** Velocities have changed. */
    void forgetVelocities() {
        velocitiesCurrent = false;
    }

    /**
     * Circles as of now.
     *
     * @return x, y, radius, mass of each, in ascending order of ids; may be longer; valid until the next change
     */
    float[] circles() {
        if (!circlesCurrent) {
            beforeReading.run();
            if (circles.length < CircleRow.STRIDE * handles.size()) {
                circles = new float[CircleRow.STRIDE * handles.size()];
            }
            pipeline.readCircles(handles, circles);
            circlesCurrent = true;
            number++;
        }
        return circles;
    }

    /**
     * Which state circles are in.
     *
     * @return a greater number whenever circles have changed
     */
    long changes() {
        return changes;
    }

    /**
     * Which reading {@link #circles()} has given last.
     *
     * @return another number for each reading, never 0; 0 before the first
     */
    long number() {
        return number;
    }

    /**
     * Velocities as of now.
     *
     * @return vx, vy of each, in ascending order of ids; may be longer; valid until the next change
     */
    float[] velocities() {
        if (!velocitiesCurrent) {
            beforeReading.run();
            if (velocities.length < 2 * handles.size()) {
                velocities = new float[2 * handles.size()];
            }
            pipeline.readVelocities(handles, velocities);
            velocitiesCurrent = true;
        }
        return velocities;
    }
}
