package io.github.circles2d.world.shared;

import io.github.circles2d.world.joints.SavedJointStates;
import io.github.circles2d.world.model.CircleRow;

/** The last bulk read-back, which answers reads of single values until the state changes. */
public final class LastReading {
    private final WorldParts world;
    private float[] circles = new float[0];
    private float[] velocities = new float[0];
    private int[] angles = new int[0];
    private float[] angularVelocities = new float[0];
    private boolean circlesCurrent;
    private boolean velocitiesCurrent;
    private boolean anglesCurrent;
    private boolean angularVelocitiesCurrent;
    private final SavedJointStates joints = new SavedJointStates();
    private boolean jointsCurrent;

    /** How often circles have changed. */
    private long changes;

    /** How often circles have been read. */
    private long number;

    LastReading(WorldParts world) {
        this.world = world;
    }

    /** Circles have come, gone or changed. */
    void forgetCircles() {
        circlesCurrent = false;
        changes++;
    }

    void forgetVelocities() {
        velocitiesCurrent = false;
    }

    void forgetTurns() {
        anglesCurrent = false;
        angularVelocitiesCurrent = false;
    }

    void forgetJoints() {
        jointsCurrent = false;
    }

    /** Circles as of now: x, y, radius, mass of each, in ascending order of ids; may be longer; valid until the next change. */
    public float[] circles() {
        if (!circlesCurrent) {
            if (circles.length < CircleRow.STRIDE * world.handles.size()) {
                circles = new float[CircleRow.STRIDE * world.handles.size()];
            }
            readCircles(circles);
            circlesCurrent = true;
            number++;
        }
        return circles;
    }

    /** Reads circles as of now into an array that has room. */
    public void readCircles(float[] to) {
        world.pending.settle();
        world.clock.begin();
        world.pipeline.readCircles(world.handles, to);
        world.clock.end();
    }

    /** Reads velocities likewise. */
    public void readVelocities(float[] to) {
        world.pending.settle();
        world.clock.begin();
        world.pipeline.readVelocities(world.handles, to);
        world.clock.end();
    }

    /** Which state circles are in: a greater number whenever circles have changed. */
    public long changes() {
        return changes;
    }

    /** Which reading {@link #circles()} has given last: another number for each reading, never 0; 0 before the first. */
    public long number() {
        return number;
    }

    /** Velocities as of now: vx, vy of each, in ascending order of ids; may be longer; valid until the next change. */
    public float[] velocities() {
        if (!velocitiesCurrent) {
            if (velocities.length < 2 * world.handles.size()) {
                velocities = new float[2 * world.handles.size()];
            }
            readVelocities(velocities);
            velocitiesCurrent = true;
        }
        return velocities;
    }

    /**
     * Angles as of now, in units of a turn's 2^-32, in ascending order of ids; may be longer; valid until the next change. Null if no
     * circle has turned.
     */
    public int[] angles() {
        if (!anglesCurrent && settleTurns()) {
            if (angles.length < world.handles.size()) {
                angles = new int[world.handles.size()];
            }
            world.clock.begin();
            world.pipeline.readAngles(world.handles, angles);
            world.clock.end();
            anglesCurrent = true;
        }
        return world.needs.turns() ? angles : null;
    }

    /** Angular velocities as of now, likewise. */
    public float[] angularVelocities() {
        if (!angularVelocitiesCurrent && settleTurns()) {
            if (angularVelocities.length < world.handles.size()) {
                angularVelocities = new float[world.handles.size()];
            }
            world.clock.begin();
            world.pipeline.readAngularVelocities(world.handles, angularVelocities);
            world.clock.end();
            angularVelocitiesCurrent = true;
        }
        return world.needs.turns() ? angularVelocities : null;
    }

    /** What joints keep from the last step; of those whose serials are of joints that there are. Valid until the next change. */
    public SavedJointStates joints() {
        if (!jointsCurrent) {
            world.pending.settle();
            world.pipeline.saveJoints(joints);
            jointsCurrent = true;
        }
        return joints;
    }

    /** Makes the state what calls have led to, and returns whether circles turn. Where they cannot, there is nothing to wait for. */
    private boolean settleTurns() {
        if (world.needs.turns() || world.needs.beginsToTurn()) {
            world.pending.settle();
        }
        return world.needs.turns();
    }
}
