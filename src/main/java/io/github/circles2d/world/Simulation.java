package io.github.circles2d.world;

import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.circles.KindTable;
import io.github.circles2d.world.circles.WorldParameters;
import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.ContactSettings;
import io.github.circles2d.world.model.GridLevels;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.WallMotion;
import java.util.Collections;

/**
 * Drives a {@link Pipeline}: it makes steps, and has the state as of now made before it is read. It is the inside of {@code World},
 * whose documentation says what each call does and throws. The calls on circles, the reads and the snapshots have a class each:
 * {@link Circles}, {@link Kinds}, {@link Readings}, {@link Reports}, {@link Searches}, {@link Snapshots}.
 *
 * <p>{@link Guard} guards every call. A call makes room before it changes the state: if memory runs out, nothing has changed.
 */
public final class Simulation implements AutoCloseable {
    final Pipeline pipeline;
    final Guard guard;
    final HandleTable handles = new HandleTable();
    final Commands commands = new Commands();
    final ContactEvents events = new ContactEvents();
    final KindTable kindTable = new KindTable();
    final Forces forces = new Forces(handles, commands);
    final LastReading last;
    private final Kinds kinds;
    final Travels travels = new Travels(handles, commands);
    final Growth growth;
    private final Clearing clearing;
    final PreparedChanges changes;
    private final Circles circles;
    private final BulkChanges bulk;
    private final Readings readings;
    private final Loads loads;
    private final Reports reports;
    private final Snapshots snapshots;
    final Journal journal;
    private final Searches searches;
    private final GridLevels levels = new GridLevels();
    private final StepConstants constants = new StepConstants();

    Bounds bounds;

    /** Where the walls start in the next step: where they were, or where they are if they jumped. */
    private Bounds wallStart;

    private float gravityX;
    private float gravityY;
    float defaultRestitution;
    private int subSteps;
    private ContactSettings contacts;
    private float previousTimeStep;

    /** What {@link #parameters} gave last. */
    private WorldParameters parameters;

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
        kinds = new Kinds(this);
        growth = new Growth(this);
        clearing = new Clearing(this);
        changes = new PreparedChanges(this);
        circles = new Circles(this);
        bulk = new BulkChanges(this);
        readings = new Readings(this);
        loads = new Loads(this);
        reports = new Reports(this);
        snapshots = new Snapshots(this);
        journal = new Journal(this);
        searches = new Searches(this);
        setParameters(start);
        try {
            pipeline.prepare(contacts, !bounds.isWalled());
        } catch (RuntimeException | Error e) {
            pipeline.close();
            throw e;
        }
    }

    /** The calls on circles. */
    public Circles circles() {
        return circles;
    }

    /** The calls on kinds of circles. */
    public Kinds kinds() {
        return kinds;
    }

    /** The calls on circles that grow. */
    public Growth growth() {
        return growth;
    }

    /** The call that removes all circles. */
    public Clearing clearing() {
        return clearing;
    }

    /** The calls that change many circles at once. */
    public BulkChanges bulk() {
        return bulk;
    }

    /** The reads. */
    public Readings readings() {
        return readings;
    }

    /** The reads of how hard circles are pressed. */
    public Loads loads() {
        return loads;
    }

    /** The calls on events. */
    public Reports reports() {
        return reports;
    }

    /** The snapshots. */
    public Snapshots snapshots() {
        return snapshots;
    }

    /** The log of calls, if there is one. */
    public Journal journal() {
        return journal;
    }

    /** The searches for circles. */
    public Searches searches() {
        return searches;
    }

    /** Changes gravity. */
    public void setGravity(float x, float y) {
        guard.enter();
        try {
            Limits.gravity(x, y);
            snapshots.forget();
            journal.call(LoggedCall.GRAVITY, x, y, 0, 0);
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

    /** Moves the walls: the next step pushes the circles that they meet. */
    public void setBounds(float minX, float minY, float maxX, float maxY) {
        guard.enter();
        try {
            Bounds next = Limits.bounds(minX, minY, maxX, maxY).with(bounds.edgeX(), bounds.edgeY());
            Limits.moved(bounds, next);
            if (handles.size() > 0) {
                Limits.within(
                        "the greatest radius", handles.greatestRadius(), next.leastRadius(), next.greatestRadius());
                Limits.within("the least radius", handles.leastRadius(), next.leastRadius(), next.greatestRadius());
                growth.requireRoom(next);
            }
            applyCommands();
            changed();
            journal.call(LoggedCall.BOUNDS, minX, minY, maxX, maxY);
            Bounds start = WallMotion.start(wallStart, next, handles.size() > 0 ? handles.greatestRadius() : 0f);
            guard.changing = true;
            pipeline.confine(start.walls(), next.walls());
            travels.confine(next.walls());
            wallStart = start;
            bounds = next;
            events.setArena(next);
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

    /** How contacts are. */
    public ContactSettings contacts() {
        guard.enter();
        try {
            return contacts;
        } finally {
            guard.user = null;
        }
    }

    /** The length of a sub-step of the last step; 0 before the first. */
    float lastSubStep() {
        return previousTimeStep / subSteps;
    }

    /** Makes steps. */
    public void step(float timeStep, int steps) {
        guard.enter();
        try {
            Limits.within("the time step", timeStep, Limits.LEAST_STEP, Limits.GREATEST_STEP);
            Limits.within("the number of steps", steps, 1, Integer.MAX_VALUE);
            journal.step(timeStep, steps);
            int made = 0;
            while (made < steps && nextStepDiffers()) {
                makeDifferentStep(timeStep);
                made++;
            }
            if (made < steps) {
                makeSteps(timeStep, steps - made);
            }
            journal.stepped(steps);
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /**
     * Whether the next step differs from those behind it: some static circle travels, a wall moves, a force is applied, or a circle
     * grows.
     */
    private boolean nextStepDiffers() {
        return !travels.isEmpty() || !forces.isEmpty() || wallStart.differs(bounds) || !growth.isEmpty();
    }

    /** Makes the step to which all that belongs that the calls before have asked for in one step alone. */
    private void makeDifferentStep(float timeStep) {
        forces.begin();
        commands.ensure(growth.count() + travels.count());
        growth.makeRoom();
        travels.makeRoom();
        guard.changing = true;
        growth.begin();
        travels.depart(timeStep, bounds);
        journal.skipCommands();
        guard.changing = false;
        try {
            makeSteps(timeStep, 1);
        } catch (RuntimeException | Error e) {
            if (!guard.changing) {
                travels.stay();
                growth.undo();
                journal.logged = Math.min(journal.logged, commands.count());
            }
            throw e;
        }
        guard.changing = true;
        wallStart = bounds;
        growth.end();
        travels.arrive();
        forces.end();
        journal.skipCommands();
        guard.changing = false;
    }

    private void makeSteps(float timeStep, int steps) {
        applyCommands();
        guard.changing = true;
        emptyStep = handles.size() == 0;
        if (!emptyStep) {
            changed();
            float before = previousTimeStep == 0 ? timeStep : previousTimeStep;
            constants.set(timeStep, subSteps, gravityX, gravityY, wallStart, bounds, before, contacts);
            constants.setPairs(kinds.filter(), kindTable.responses(), kindTable.version());
            constants.setMotion(kindTable.moves() || forces.drive(), kindTable);
            events.prepare(kindTable, constants);
            levels.layOut(bounds, handles.greatestRadius(), handles.population(), handles.hasStatics());
            pipeline.step(constants, levels, steps);
        } else if (events.isOn()) {
            finishSteps();
            guard.changing = true;
            events.emptySteps(steps);
        }
        if (events.isOn()) {
            events.asked(steps);
        }
        snapshots.forget();
        previousTimeStep = timeStep;
        guard.changing = false;
    }

    /** Checks that calls can be made: that nobody has closed the simulation, and that it has its state. */
    public void check() {
        guard.enter();
        guard.user = null;
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
            return currentHash();
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** The hash of the state, for callers that are inside already. */
    long currentHash() {
        settle();
        return pipeline.hash()
                + handles.fields().hash()
                + kindTable.hash()
                + WorldParameters.hash(bounds, wallStart, contacts);
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
        if (parameters == null
                || !parameters.has(
                        bounds,
                        gravityX,
                        gravityY,
                        defaultRestitution,
                        subSteps,
                        previousTimeStep,
                        contacts,
                        wallStart)) {
            parameters = new WorldParameters(
                    bounds, gravityX, gravityY, defaultRestitution, subSteps, previousTimeStep, contacts, wallStart);
        }
        return parameters;
    }

    /** A snapshot has taken the place of all that was. */
    void restored(WorldParameters p) {
        setParameters(p);
        parameters = p;
        forgetFigures();
    }

    /** The figures are no longer those of a step. */
    void forgetFigures() {
        emptyStep = true;
    }

    private void setParameters(WorldParameters p) {
        bounds = p.bounds();
        events.setArena(bounds);
        wallStart = p.wallStart();
        gravityX = p.gravityX();
        gravityY = p.gravityY();
        defaultRestitution = p.restitution();
        subSteps = p.subSteps();
        contacts = p.contacts();
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
            journal.writeCommands();
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
            journal.logged = 0;
            guard.changing = false;
        }
    }

    /** Waits for all steps, and is told if one has failed. */
    void finishSteps() {
        guard.changing = true;
        pipeline.finish();
        guard.changing = false;
    }

    /** Waits for the events of all steps so far. */
    void finishEvents() {
        guard.changing = true;
        pipeline.finishEvents();
        guard.changing = false;
    }

    /** Asks for the events of all steps so far. */
    void requestEvents() {
        guard.changing = true;
        pipeline.requestEvents();
        guard.changing = false;
    }

    /** Waits for the events that were requested. */
    void finishRequestedEvents() {
        guard.changing = true;
        pipeline.finishRequestedEvents();
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
