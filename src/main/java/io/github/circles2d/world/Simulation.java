package io.github.circles2d.world;

import io.github.circles2d.world.changes.AdmittedChanges;
import io.github.circles2d.world.changes.Bodies;
import io.github.circles2d.world.changes.BulkChanges;
import io.github.circles2d.world.changes.Circles;
import io.github.circles2d.world.changes.Clearing;
import io.github.circles2d.world.changes.FieldCalls;
import io.github.circles2d.world.changes.Forces;
import io.github.circles2d.world.changes.Growth;
import io.github.circles2d.world.changes.JointCalls;
import io.github.circles2d.world.changes.Kinds;
import io.github.circles2d.world.changes.Nets;
import io.github.circles2d.world.changes.NewCircles;
import io.github.circles2d.world.changes.NextStep;
import io.github.circles2d.world.changes.Pieces;
import io.github.circles2d.world.changes.PreparedChanges;
import io.github.circles2d.world.changes.Travels;
import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.circles.CircleFields;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.circles.KindTable;
import io.github.circles2d.world.circles.WorldParameters;
import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.joints.JointTables;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.ContactSettings;
import io.github.circles2d.world.model.GridLevels;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.StepInput;
import io.github.circles2d.world.model.SurfaceSettings;
import io.github.circles2d.world.model.WallMotion;
import io.github.circles2d.world.reads.JointReads;
import io.github.circles2d.world.reads.Loads;
import io.github.circles2d.world.reads.Readings;
import io.github.circles2d.world.reports.Reports;
import io.github.circles2d.world.saves.Journal;
import io.github.circles2d.world.saves.Snapshots;
import io.github.circles2d.world.search.Searches;
import io.github.circles2d.world.search.TerrainView;
import io.github.circles2d.world.shared.Breaking;
import io.github.circles2d.world.shared.CallLog;
import io.github.circles2d.world.shared.Copies;
import io.github.circles2d.world.shared.Guard;
import io.github.circles2d.world.shared.LastReading;
import io.github.circles2d.world.shared.LoggedCall;
import io.github.circles2d.world.shared.Needs;
import io.github.circles2d.world.shared.PendingWork;
import io.github.circles2d.world.shared.Pipeline;
import io.github.circles2d.world.shared.WorldSettings;
import io.github.circles2d.world.shared.WorldState;
import io.github.circles2d.world.terrain.TerrainTables;
import java.util.Collections;

/**
 * Drives a {@link Pipeline}: it makes steps, and has the state as of now made before it is read. It is the inside of {@code World},
 * whose documentation says what each call does and throws. The calls on circles, the reads and the snapshots have a class each:
 * {@link Circles}, {@link Kinds}, {@link Readings}, {@link Reports}, {@link Searches}, {@link Snapshots}.
 *
 * <p>{@link Guard} guards every call. A call makes room before it changes the state: if memory runs out, nothing has changed.
 */
public final class Simulation implements AutoCloseable {
    private final Pipeline pipeline;
    private final Guard guard;
    private final HandleTable handles = new HandleTable();
    private final Commands commands = new Commands();
    private final ContactEvents events = new ContactEvents();
    private final StepInput input = new StepInput();
    private final KindTable kindTable = new KindTable();
    private final WorldSettings settings;
    private final CallLog log;
    private final Needs needs;
    private final PendingWork pending;
    private final Copies copies;
    private final WorldState state;
    private final Forces forces;
    private final Growth growth;
    private final NextStep nextStep;
    private final TerrainTables terrain;
    private final JointTables joints;
    private final Kinds kinds;
    private final Pieces pieces;
    private final Bodies bodies;
    private final JointCalls jointCalls;
    private final JointReads jointReads;
    private final Clearing clearing;
    private final NewCircles newCircles;
    private final Nets nets;
    private final Circles circles;
    private final FieldCalls fields;
    private final BulkChanges bulk;
    private final Readings readings;
    private final Loads loads;
    private final Reports reports;
    private final Snapshots snapshots;
    private final Journal journal;
    private final Searches searches;
    private final Searches terrainSearches;
    private final GridLevels levels = new GridLevels();
    private long stepCount;

    /** A world without circles; closes the pipeline. The parameters have been checked. */
    public Simulation(Pipeline pipeline, WorldParameters start) {
        this.pipeline = pipeline;
        guard = new Guard(pipeline);
        settings = new WorldSettings(events, start);
        log = new CallLog(pipeline, guard, commands);
        terrain = new TerrainTables(input.terrain, settings.bounds());
        events.setPieces(terrain.pieces);
        joints = new JointTables(input.joints, handles, terrain);
        needs = new Needs(pipeline, kindTable, terrain, joints, settings);
        Breaking breaking = new Breaking(pipeline, guard, joints, settings);
        pending = new PendingWork(pipeline, guard, handles, commands, events, log, breaking, needs);
        state = new WorldState(pipeline, handles, kindTable, events, settings, terrain, joints, needs);
        copies = new Copies(pending, state, new LastReading(pipeline, handles, pending, needs));
        pieces = new Pieces(guard, terrain, joints, log, pending, copies, settings);
        bodies = new Bodies(guard, terrain, joints, log, pending, copies, settings);
        jointCalls = new JointCalls(guard, handles, terrain, joints, log, pending, copies);
        jointReads = new JointReads(guard, handles, joints, pending, copies.last(), settings);
        kinds = new Kinds(guard, kindTable, handles.fields(), log, copies, settings);
        forces = new Forces(guard, handles, commands, log, copies, needs);
        growth = new Growth(guard, handles, commands, log, copies, settings);
        Travels travels = new Travels(handles, commands);
        nextStep = new NextStep(commands, forces, travels, growth);
        clearing = new Clearing(guard, handles, events, log, pending, copies, joints, state);
        AdmittedChanges admitted = new AdmittedChanges(guard, handles, commands, log, copies, travels, joints, needs);
        PreparedChanges changes =
                new PreparedChanges(handles, commands, pending, settings, kinds, travels, joints, admitted);
        newCircles = new NewCircles(guard, handles, commands, pending, copies, settings, kinds);
        nets = new Nets(guard, handles, terrain, joints, log, pending, copies, settings, newCircles);
        circles = new Circles(guard, handles, commands, pending, copies, settings, nextStep, changes);
        fields = new FieldCalls(guard, handles, commands, log, pending, copies, kinds, needs);
        TerrainView view = new TerrainView(terrain, input.terrain, kindTable, handles.fields(), settings);
        bulk = new BulkChanges(guard, handles, kindTable, copies, settings, changes, view);
        readings = new Readings(guard, handles, pipeline, pending, copies.last());
        loads = new Loads(guard, handles, copies, settings);
        reports = new Reports(guard, pipeline, handles, events, pending, copies);
        snapshots = new Snapshots(guard, log, pending, copies, nextStep, state);
        journal = new Journal(guard, log, pending, copies);
        searches = new Searches(guard, pipeline, handles, kindTable, pending, copies.last(), settings);
        terrainSearches = new Searches(guard, handles, kindTable, settings, view);
        try {
            needs.prepare();
        } catch (RuntimeException | Error e) {
            pipeline.close();
            throw e;
        }
    }

    /** The calls that add circles. */
    public NewCircles newCircles() {
        return newCircles;
    }

    /** The call that adds circles that joints hold. */
    public Nets nets() {
        return nets;
    }

    /** The calls on circles that are there. */
    public Circles circles() {
        return circles;
    }

    /** The calls on kinds of circles. */
    public Kinds kinds() {
        return kinds;
    }

    /** The calls on single fields of circles. */
    public FieldCalls fields() {
        return fields;
    }

    /** The calls on forces that act once. */
    public Forces forces() {
        return forces;
    }

    /** The calls on circles that grow. */
    public Growth growth() {
        return growth;
    }

    /** The calls on pieces of terrain. */
    public Pieces pieces() {
        return pieces;
    }

    /** The calls on bodies of terrain. */
    public Bodies bodies() {
        return bodies;
    }

    /** The calls that change joints. */
    public JointCalls joints() {
        return jointCalls;
    }

    /** The reads of joints. */
    public JointReads jointReads() {
        return jointReads;
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

    public Snapshots snapshots() {
        return snapshots;
    }

    /** The log of calls, if there is one. */
    public Journal journal() {
        return journal;
    }

    public Searches searches() {
        return searches;
    }

    /** The searches for pieces of terrain. */
    public Searches terrainSearches() {
        return terrainSearches;
    }

    public void setGravity(float x, float y) {
        guard.enter();
        try {
            Limits.gravity(x, y);
            copies.forgetSaved();
            log.call(LoggedCall.GRAVITY, x, y, 0, 0);
            settings.setGravity(x, y);
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    public float gravityX() {
        guard.check();
        return settings.gravityX();
    }

    public float gravityY() {
        guard.check();
        return settings.gravityY();
    }

    /** Moves the walls: the next step pushes the circles that they meet. */
    public void setBounds(float minX, float minY, float maxX, float maxY) {
        guard.enter();
        try {
            Bounds before = settings.bounds();
            Bounds next = Limits.bounds(minX, minY, maxX, maxY).with(before.edgeX(), before.edgeY());
            Limits.moved(before, next);
            if (handles.size() > 0) {
                Limits.room("the greatest radius of a circle", handles.greatestRadius(), next);
                Limits.room("the least radius of a circle", handles.leastRadius(), next);
                nextStep.requireRoom(next);
            }
            pending.apply();
            copies.forget();
            Bounds start =
                    WallMotion.start(settings.wallStart(), next, handles.size() > 0 ? handles.greatestRadius() : 0f);
            log.call(LoggedCall.BOUNDS, minX, minY, maxX, maxY);
            guard.changing = true;
            pipeline.confine(start.walls(), next.walls());
            nextStep.confine(next.walls());
            settings.setBounds(start, next);
            guard.changing = false;
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    /** Where the walls are. */
    public Bounds bounds() {
        guard.check();
        return settings.bounds();
    }

    /** Gives a wall another surface; {@link WallMotion#of} numbers the walls. */
    public void setWallSurface(int wall, float friction, float rollingResistance, float beltSpeed) {
        guard.enter();
        try {
            Limits.within("the number of the wall", wall, 0, WallMotion.COUNT - 1);
            SurfaceSettings next = settings.surfaces().withWall(wall, friction, rollingResistance, beltSpeed);
            copies.forgetSaved();
            log.call(
                    LoggedCall.WALL_SURFACE,
                    wall,
                    Float.floatToRawIntBits(friction),
                    Float.floatToRawIntBits(rollingResistance),
                    Float.floatToRawIntBits(beltSpeed));
            settings.setSurfaces(next);
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    /** The surfaces of circles that have none of their own, nor by their kind, and of walls. */
    public SurfaceSettings surfaces() {
        guard.check();
        return settings.surfaces();
    }

    /** The restitution that new circles get. */
    public float defaultRestitution() {
        guard.check();
        return settings.defaultRestitution();
    }

    public int subSteps() {
        guard.check();
        return settings.subSteps();
    }

    public ContactSettings contacts() {
        guard.check();
        return settings.contacts();
    }

    public void step(float timeStep, int steps) {
        guard.enter();
        int made = 0;
        try {
            Limits.within("the time step", timeStep, Limits.LEAST_STEP, Limits.GREATEST_STEP);
            Limits.within("the number of steps", steps, 1, Integer.MAX_VALUE);
            log.step(timeStep, steps);
            while (made < steps && nextStepDiffers()) {
                makeDifferentStep(timeStep);
                made++;
            }
            if (made < steps) {
                makeSteps(timeStep, steps - made);
            }
            log.stepped(steps);
            stepCount += steps;
        } catch (RuntimeException | Error thrown) {
            guard.changing |= made > 0; // some of the steps have been made, and others never will
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    /** The number of steps that have been made, whatever state has been restored. */
    public long stepCount() {
        return stepCount;
    }

    /** Whether a static circle travels, a wall or terrain moves, a force is applied, or a circle grows in it. */
    private boolean nextStepDiffers() {
        return !nextStep.isEmpty() || settings.wallsMove() || terrain.moves();
    }

    /** Makes the step to which all that belongs that the calls before have asked for in one step alone. */
    private void makeDifferentStep(float timeStep) {
        nextStep.makeRoom();
        guard.changing = true;
        nextStep.begin(timeStep, settings.bounds());
        log.skipCommands();
        guard.changing = false;
        try {
            makeSteps(timeStep, 1);
        } catch (RuntimeException | Error e) {
            if (!guard.changing) {
                nextStep.undo();
                log.commandsDropped();
            }
            throw e;
        }
        guard.changing = true;
        settings.stopWalls();
        nextStep.end();
        log.skipCommands();
        guard.changing = false;
    }

    private void makeSteps(float timeStep, int steps) {
        if (timeStep != settings.lastStep()) {
            pending.settleJoints(); // the length of the step says by which force a joint broke
        }
        pending.prepareNeeds();
        terrain.makeRoom(settings.subSteps());
        joints.makeRoom(settings.subSteps());
        pending.apply(); // last: a step that lacks memory before it takes its changes back, which the pipeline must
        // not have
        boolean hasCircles = handles.size() > 0;
        if (hasCircles) {
            pipeline.prepareSteps();
        }
        guard.changing = true;
        state.figures().stepped(hasCircles);
        if (hasCircles) {
            copies.forget();
            prepareInput(timeStep);
            levels.layOut(settings.bounds(), handles.greatestRadius(), handles.population(), handles.hasStatics());
            pipeline.step(input, levels, steps);
        } else if (events.isOn()) {
            pending.finish();
            guard.changing = true;
            events.emptySteps(steps);
        }
        if (events.isOn()) {
            events.queue().asked(steps);
        }
        terrain.end(timeStep, settings.subSteps());
        copies.forgetSaved();
        settings.setTimeStep(timeStep);
        guard.changing = false;
    }

    private void prepareInput(float timeStep) {
        StepConstants constants = input.constants;
        settings.computeConstants(constants, timeStep);
        constants.filtering = kinds.filter();
        input.responses.set(kindTable.responses(), kindTable.version());
        constants.driving = kindTable.moves() || forces.drive();
        if (constants.driving) {
            input.motion.update(constants, kindTable, kindTable.version());
        }
        constants.turning = needs.turns();
        if (constants.turning) {
            CircleFields fields = handles.fields();
            boolean own = fields.isUsed(CircleField.FRICTION) || fields.isUsed(CircleField.ROLLING_RESISTANCE);
            boolean torques = fields.isUsed(CircleField.TORQUE) || fields.isUsed(CircleField.APPLIED_TORQUE);
            input.surfaces.update(constants, kindTable, kindTable.version(), own, torques);
        }
        constants.terrain = terrain.isThere();
        if (constants.terrain) {
            terrain.begin(constants, kindTable);
        }
        constants.joints = joints.isThere();
        if (constants.joints) {
            joints.begin(constants);
        }
        events.prepare(kindTable, input.reports);
    }

    /** Checks that calls can be made: that nobody has closed the simulation, and that it has its state. */
    public void check() {
        guard.check();
    }

    /** Waits until all steps that were asked for have been made. */
    public void finish() {
        guard.enter();
        try {
            pending.finish();
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    public long hash() {
        guard.enter();
        try {
            return copies.hash();
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    public Figures figures() {
        guard.enter();
        try {
            pending.finish();
            boolean hold = state.figures().hold();
            return new Figures(
                    handles.size(),
                    hold ? pipeline.candidatePairs() : 0,
                    hold ? pipeline.contacts() : 0,
                    hold ? pipeline.greatestContacts() : 0,
                    pipeline.bytesHeld() + events.bytes() + terrain.bytes() + joints.bytes(),
                    Collections.unmodifiableMap(pipeline.stageMillis()),
                    pipeline.device());
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    /** Ends the simulation and closes its pipeline. */
    @Override
    public void close() {
        guard.close();
    }
}
