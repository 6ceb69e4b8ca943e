package io.github.circles2d.world;

import io.github.circles2d.world.circles.HandleTable;

/** What single reads are answered from: the last bulk read-back, for as long as it holds. */
public final class LastReading {
    private final Pipeline pipeline;
    private final HandleTable roster;
    private final Runnable beforeReading;
    private float[] circles = new float[0];
    private float[] velocities = new float[0];
    private boolean circlesCurrent;
    private boolean velocitiesCurrent;

    /**
     * Nothing read yet.
     *
     * @param pipeline what to read from
     * @param roster which ids live
     * @param beforeReading what brings the pipeline up to date
     */
    public LastReading(Pipeline pipeline, HandleTable roster, Runnable beforeReading) {
        this.pipeline = pipeline;
        this.roster = roster;
        this.beforeReading = beforeReading;
    }

    /** Circles have come, gone or changed. */
    public void forgetCircles() {
        circlesCurrent = false;
    }

    /** Velocities have changed. */
    public void forgetVelocities() {
        velocitiesCurrent = false;
    }

    /**
     * Circles as of now.
     *
     * @return x, y, radius, mass of each, in ascending order of ids; may be longer; valid until the next change
     */
    public float[] circles() {
        if (!circlesCurrent) {
            beforeReading.run();
            if (circles.length < 4 * roster.size()) {
                circles = new float[4 * roster.size()];
            }
            pipeline.readCircles(roster, circles);
            circlesCurrent = true;
        }
        return circles;
    }

    /**
     * Velocities as of now.
     *
     * @return vx, vy of each, in ascending order of ids; may be longer; valid until the next change
     */
    public float[] velocities() {
        if (!velocitiesCurrent) {
            beforeReading.run();
            if (velocities.length < 2 * roster.size()) {
                velocities = new float[2 * roster.size()];
            }
            pipeline.readVelocities(roster, velocities);
            velocitiesCurrent = true;
        }
        return velocities;
    }
}
