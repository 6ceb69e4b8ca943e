package io.github.circles2d.world;

import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.circles.WorldParameters;
import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.GridLevels;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.model.StepConstants;
import java.util.Collections;

/**
 * Drives a {@link Pipeline}: it makes steps, and has the state as of now made before it is read. It is the inside of {@code World},
 * whose documentation says what each call does and throws. The calls on circles, the reads and the snapshots have a class each:
 * {@link Circles}, {@link Readings}, {@link Reports}, {@link Snapshots}.
 *
 * <p>{@link Guard} guards every call. A call makes room before it changes the state: if memory runs out, nothing has changed.
 */
public final class Simulation implements AutoCloseable {
    final Pipeline pipeline;
    final Guard guard;
    final HandleTable handles = new HandleTable();
    final Commands commands = new Commands();
    final ContactEvents events = new ContactEvents();
    final LastReading last;
    private final Circles circles;
    private final Readings readings;
    private final Reports reports;
    private final Snapshots snapshots;
    private final GridLevels levels = new GridLevels();
    private final StepConstants constants = new StepConstants();

    Bounds bounds;
    private float gravityX;
    private float gravityY;
    float defaultRestitution;
    private int subSteps;
    private float previousTimeStep;

    /** Whether the last step had no circles; also if there has been none, or none since a restore. */
    private boolean emptyStep = true;

    /**
     * A world without circles.
     *
     * @param pipeline what holds the state and makes the steps; closed with this object
     * @param start bounds, gravity, restitution and sub-steps, which have been checked
     */
    public Simulation(Pipeline pipeline, WorldParameters start) {
        this.pipeline = pipeline;
        guard = new Guard(pipeline);
        last = new LastReading(pipeline, handles, this::settle);
        circles = new Circles(this);
        readings = new Readings(this);
        reports = new Reports(this);
        snapshots = new Snapshots(this);
        setParameters(start);
    }

    /** The calls on circles. */
    public Circles circles() {
        return circles;
    }

    /** The reads. */
    public Readings readings() {
        return readings;
    }

    /** The calls on events. */
    public Reports reports() {
        return reports;
    }

    /** The snapshots. */
    public Snapshots snapshots() {
        return snapshots;
    }

    /** Changes gravity. */
    public void setGravity(float x, float y) {
        guard.enter();
        try {
            Limits.gravity(x, y);
            snapshots.forget();
            gravityX = x;
            gravityY = y;
        } finally {
            guard.user = null;
        }
    }

    /** Gravity along x. */
    public float gravityX() {
        guard.enter();
        try {
            return gravityX;
        } finally {
            guard.user = null;
        }
    }

    /** Gravity along y. */
    public float gravityY() {
        guard.enter();
        try {
            return gravityY;
        } finally {
            guard.user = null;
        }
    }

    /** Moves the walls, and brings circles that are left outside to the nearest place inside. */
    public void setBounds(float minX, float minY, float maxX, float maxY) {
        guard.enter();
        try {
            Bounds next = Limits.bounds(minX, minY, maxX, maxY);
            if (handles.size() > 0) {
                Limits.within(
                        "the greatest radius", handles.greatestRadius(), next.leastRadius(), next.greatestRadius());
                Limits.within("the least radius", handles.leastRadius(), next.leastRadius(), next.greatestRadius());
            }
            applyCommands();
            changed();
            guard.changing = true;
            pipeline.confine(next);
            bounds = next;
            guard.changing = false;
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** Where the walls are. */
    public Bounds bounds() {
        guard.enter();
        try {
            return bounds;
        } finally {
            guard.user = null;
        }
    }

    /** The restitution that new circles get. */
    public float defaultRestitution() {
        guard.enter();
        try {
            return defaultRestitution;
        } finally {
            guard.user = null;
        }
    }

    /** The number of sub-steps of a step. */
    public int subSteps() {
        guard.enter();
        try {
            return subSteps;
        } finally {
            guard.user = null;
        }
    }

    /** Makes steps. */
    public void step(float timeStep, int steps) {
        guard.enter();
        try {
            Limits.within("the time step", timeStep, Limits.LEAST_STEP, Limits.GREATEST_STEP);
            Limits.within("the number of steps", steps, 1, Integer.MAX_VALUE);
            applyCommands();
            guard.changing = true;
            emptyStep = handles.size() == 0;
            if (!emptyStep) {
                changed();
                float before = previousTimeStep == 0 ? timeStep : previousTimeStep;
                constants.set(timeStep, subSteps, gravityX, gravityY, bounds, before);
                levels.layOut(bounds, handles.greatestRadius(), handles.population());
                pipeline.step(constants, levels, steps);
            } else if (events.isOn()) {
                finishSteps();
                guard.changing = true;
                events.emptySteps(steps);
            }
            snapshots.forget();
            previousTimeStep = timeStep;
            guard.changing = false;
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** Waits until all steps that were asked for have been made. */
    public void finish() {
        guard.enter();
        try {
            finishSteps();
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** The hash of the state. */
    public long hash() {
        guard.enter();
        try {
            settle();
            return pipeline.hash() + handles.fields().hash();
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** The figures as of now. */
    public Figures figures() {
        guard.enter();
        try {
            finishSteps();
            return new Figures(
                    handles.size(),
                    emptyStep ? 0 : pipeline.candidatePairs(),
                    emptyStep ? 0 : pipeline.contacts(),
                    emptyStep ? 0 : pipeline.greatestContacts(),
                    pipeline.bytesHeld() + events.bytes(),
                    Collections.unmodifiableMap(pipeline.stageMillis()),
                    pipeline.device());
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** What there is besides circles. */
    WorldParameters parameters() {
        return new WorldParameters(bounds, gravityX, gravityY, defaultRestitution, subSteps, previousTimeStep);
    }

    /** A snapshot has taken the place of all that was. */
    void restored(WorldParameters p) {
        setParameters(p);
        emptyStep = true;
    }

    private void setParameters(WorldParameters p) {
        bounds = p.bounds();
        gravityX = p.gravityX();
        gravityY = p.gravityY();
        defaultRestitution = p.restitution();
        subSteps = p.subSteps();
        previousTimeStep = p.previousTimeStep();
    }

    /** Circles have changed, and all that was read or saved of them is out of date. */
    void changed() {
        last.forgetCircles();
        last.forgetVelocities();
        snapshots.forget();
    }

    /** Makes room for changes to come, so that none fails half-way. */
    void expect(int more) {
        if (commands.count() >= Commands.MANY) {
            applyCommands();
        }
        commands.ensure(more);
    }

    /** Hands the changes that wait to the pipeline. */
    void applyCommands() {
        if (commands.count() > 0) {
            finishSteps();
            pipeline.makeRoom(commands);
            if (events.isOn()) {
                events.makeRoom(commands);
            }
            guard.changing = true;
            if (events.isOn()) {
                events.apply(commands, handles);
            }
            pipeline.apply(commands);
            commands.clear();
            guard.changing = false;
        }
    }

    /** Waits for all steps, and is told if one has failed. */
    void finishSteps() {
        guard.changing = true;
        pipeline.finish();
        guard.changing = false;
    }

    /** Makes the state what calls have led to, so that reading it changes nothing. */
    void settle() {
        applyCommands();
        finishSteps();
    }

    /** Ends the simulation and closes its pipeline. */
    @Override
    public void close() {
        guard.takeTurn();
        try {
            guard.closed = true;
            pipeline.close();
        } finally {
            guard.user = null;
        }
    }
}
