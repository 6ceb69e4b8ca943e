package io.github.circles2d.world;

import io.github.circles2d.world.changes.Bodies;
import io.github.circles2d.world.changes.BulkChanges;
import io.github.circles2d.world.changes.Circles;
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
import io.github.circles2d.world.changes.RigidBulk;
import io.github.circles2d.world.changes.RigidCalls;
import io.github.circles2d.world.changes.Surroundings;
import io.github.circles2d.world.changes.Travels;
import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.circles.CircleFields;
import io.github.circles2d.world.circles.WorldParameters;
import io.github.circles2d.world.model.GridLevels;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.reads.CircleContacts;
import io.github.circles2d.world.reads.IdReads;
import io.github.circles2d.world.reads.JointReads;
import io.github.circles2d.world.reads.Loads;
import io.github.circles2d.world.reads.Readings;
import io.github.circles2d.world.reads.RigidReads;
import io.github.circles2d.world.reports.Reports;
import io.github.circles2d.world.saves.Journal;
import io.github.circles2d.world.saves.Snapshots;
import io.github.circles2d.world.search.BodyView;
import io.github.circles2d.world.search.Searches;
import io.github.circles2d.world.search.TerrainView;
import io.github.circles2d.world.shared.Calls;
import io.github.circles2d.world.shared.Guard;
import io.github.circles2d.world.shared.Moves;
import io.github.circles2d.world.shared.Pipeline;
import io.github.circles2d.world.shared.WorldParts;
import io.github.circles2d.world.shared.WorldSettings;
import java.util.Collections;
import java.util.Map;

/**
 * Drives a {@link Pipeline}: it makes steps, and has the state as of now made before it is read. It is the inside of {@code World},
 * whose documentation says what each call does and throws. The calls stand by topic in the classes of the public fields, all of which
 * share the {@link WorldParts}.
 *
 * <p>{@link Guard} guards every call. A call makes room before it changes the state: if memory runs out, nothing has changed.
 */
public final class Simulation implements AutoCloseable {
    public final Calls calls;
    public final NewCircles newCircles;
    public final Nets nets;
    public final Circles circles;
    public final BulkChanges bulk;
    public final FieldCalls fields;
    public final Kinds kinds;
    public final Forces forces;
    public final Growth growth;
    public final Pieces pieces;
    public final Bodies bodies;
    public final JointCalls joints;
    public final RigidCalls rigids;
    public final RigidBulk rigidBulk;
    public final RigidReads rigidReads;
    public final IdReads pieceIds;
    public final IdReads bodyIds;
    public final IdReads rigidIds;
    public final IdReads jointIds;
    public final Readings readings;
    public final Loads loads;
    public final CircleContacts contacts;
    public final JointReads jointReads;
    public final Reports reports;
    public final Snapshots snapshots;
    public final Journal journal;
    public final Searches searches;
    public final Searches terrainSearches;
    public final Searches bodySearches;

    public final Moves moves;

    private final WorldParts world;
    private final NextStep nextStep;
    private final GridLevels levels = new GridLevels();
    private long stepCount;

    /** A world without circles; closes the pipeline. The parameters have been checked. */
    public Simulation(Pipeline pipeline, WorldParameters start) {
        world = new WorldParts(pipeline, start);
        calls = world.calls;
        moves = world.moves;
        kinds = new Kinds(world);
        forces = new Forces(world);
        growth = new Growth(world);
        Travels travels = new Travels(world);
        nextStep = new NextStep(world, forces, travels, growth);
        moves.alsoCarry(nextStep::carry);
        PreparedChanges changes = new PreparedChanges(world, kinds, travels);
        newCircles = new NewCircles(world, kinds);
        nets = new Nets(world, newCircles);
        circles = new Circles(world, nextStep, changes);
        TerrainView view = new TerrainView(world);
        BodyView bodyView = new BodyView(world);
        bulk = new BulkChanges(world, changes, view, bodyView);
        fields = new FieldCalls(world, kinds);
        new Surroundings(world, nextStep);
        pieces = new Pieces(world);
        bodies = new Bodies(world);
        joints = new JointCalls(world);
        rigids = new RigidCalls(world, kinds);
        rigidBulk = new RigidBulk(world, rigids);
        rigidReads = new RigidReads(world);
        pieceIds = new IdReads(world, world.terrain.pieces.ids);
        bodyIds = new IdReads(world, world.terrain.bodies.ids);
        rigidIds = new IdReads(world, world.rigids.ids);
        jointIds = new IdReads(world, world.joints.table.ids);
        readings = new Readings(world);
        loads = new Loads(world);
        contacts = new CircleContacts(world);
        jointReads = new JointReads(world);
        reports = new Reports(world);
        snapshots = new Snapshots(world, nextStep);
        journal = new Journal(world);
        searches = Searches.forCircles(world);
        terrainSearches = Searches.forThings(world, view);
        bodySearches = Searches.forThings(world, bodyView);
        try {
            world.needs.prepare();
        } catch (RuntimeException | Error e) {
            pipeline.close();
            throw e;
        }
    }

    public void step(float timeStep, int steps) {
        world.guard.enter();
        int made = 0;
        try {
            Limits.within("the time step", timeStep, Limits.LEAST_STEP, Limits.GREATEST_STEP);
            Limits.within("the number of steps", steps, 1, Integer.MAX_VALUE);
            world.log.step(timeStep, steps);
            world.clock.beginStep();
            while (made < steps && nextStepDiffers()) {
                makeDifferentStep(timeStep);
                made++;
            }
            if (made < steps) {
                makeSteps(timeStep, steps - made);
            }
            world.log.stepped(steps);
            stepCount += steps;
            world.clock.end();
        } catch (RuntimeException | Error thrown) {
            world.guard.changing |= made > 0; // some of the steps have been made, and others never will
            throw world.guard.failed(thrown);
        } finally {
            world.guard.leave();
        }
    }

    /** The settings, which only calls here change. */
    public WorldSettings settings() {
        world.guard.check();
        return world.settings;
    }

    /** The number of steps that have been made, whatever state has been restored. */
    public long stepCount() {
        return stepCount;
    }

    /** Whether a static circle travels, a wall or terrain moves, a force is applied, or a circle grows in it. */
    private boolean nextStepDiffers() {
        return !nextStep.isEmpty()
                || world.settings.wallsMove()
                || world.terrain.bodies.anyMoves()
                || world.rigids.pushes();
    }

    /** Makes the step to which all that belongs that the calls before have asked for in one step alone. */
    private void makeDifferentStep(float timeStep) {
        nextStep.makeRoom();
        world.guard.changing = true;
        nextStep.begin(timeStep, world.settings.bounds());
        world.guard.changing = false;
        try {
            makeSteps(timeStep, 1);
        } catch (RuntimeException | Error e) {
            if (!world.guard.changing) {
                nextStep.undo();
            }
            throw e;
        }
        world.guard.changing = true;
        world.settings.stopWalls();
        nextStep.end();
        world.rigids.releaseAll();
        world.guard.changing = false;
    }

    private void makeSteps(float timeStep, int steps) {
        if (timeStep != world.settings.lastStep()) {
            world.pending.settleJoints(); // the length of the step says by which force a joint broke
        }
        world.pending.prepareNeeds();
        world.terrain.makeRoom(world.settings.subSteps());
        world.joints.makeRoom(world.settings.subSteps());
        world.rigids.makeRoom(world.handles.end(), world.terrain.pieces.ids.end(), world.settings.sleeps());
        world.pending
                .apply(); // last: a step that lacks memory before it takes its changes back, which the pipeline must
        // not have
        boolean circles = world.handles.size() > 0;
        boolean acts = circles || world.rigids.isThere();
        if (acts) {
            world.events.prepare(world.kinds, world.input.reports);
            world.moves.beforeSteps(steps);
            prepareSteps();
        }
        world.guard.changing = true;
        world.state.stepped(circles);
        world.rigids.steps();
        if (acts) {
            world.copies.forget();
            prepareInput(timeStep);
            levels.layOut(
                    world.settings.bounds(),
                    world.handles.greatestRadius(),
                    world.handles.population(),
                    world.handles.hasStatics());
            world.pipeline.step(world.input, levels, steps);
        }
        world.settings.stepped(timeStep); // before anybody looks for joints that have broken
        if (!circles && world.events.isOn()) {
            world.pending.finish();
            world.guard.changing = true;
            world.events.emptySteps(steps);
        }
        if (world.events.isOn()) {
            world.events.queue().asked(steps);
        }
        world.terrain.end(timeStep, world.settings.subSteps());
        world.copies.forgetSaved();
        world.guard.changing = false;
    }

    private void prepareSteps() {
        try {
            world.pipeline.prepareSteps(world.input.reports);
        } catch (RuntimeException e) {
            world.moves.goHome(e);
        }
    }

    private void prepareInput(float timeStep) {
        StepConstants constants = world.input.constants;
        world.settings.computeConstants(constants, timeStep);
        constants.filtering = kinds.filter();
        world.input.responses = world.kinds.responses();
        world.input.responsesVersion = world.kinds.version();
        constants.ownMotion = world.needs.ownMotion();
        constants.driving = world.kinds.moves() || forces.drive() || constants.ownMotion;
        if (constants.driving) {
            world.input.motion.update(constants, world.kinds, world.kinds.version());
        }
        if (constants.sleeping) {
            world.input.sleep.update(world.kinds, world.kinds.version());
        }
        constants.turning = world.needs.turns();
        if (constants.turning) {
            CircleFields fields = world.handles.fields();
            boolean own = fields.areSurfacesUsed();
            boolean torques = fields.isUsed(CircleField.TORQUE) || fields.isUsed(CircleField.APPLIED_TORQUE);
            world.input.surfaces.update(constants, world.kinds, world.kinds.version(), own, torques);
        }
        constants.terrain = world.terrain.isThere();
        if (constants.terrain) {
            world.terrain.begin(constants, world.kinds);
        }
        constants.joints = world.joints.isThere();
        if (constants.joints) {
            world.joints.begin(constants);
        }
        constants.rigid = world.rigids.isThere();
    }

    /** Checks that calls can be made: that nobody has closed the simulation, and that it has its state. */
    public void check() {
        world.guard.check();
    }

    /** Waits until all steps that were asked for have been made. */
    public void finish() {
        world.guard.enter();
        try (world.guard) {
            world.pending.finish();
        }
    }

    public long hash() {
        world.guard.enter();
        try (world.guard) {
            return world.copies.hash();
        }
    }

    public Figures figures() {
        world.guard.enter();
        try (world.guard) {
            world.pending.finish();
            boolean hold = world.state.figuresHold();
            return new Figures(
                    world.handles.size(),
                    hold ? world.pipeline.candidatePairs() : 0,
                    hold ? world.pipeline.contacts() : 0,
                    hold ? world.pipeline.greatestContacts() : 0,
                    readings.awake(),
                    world.rigids.step.count,
                    world.rigids.step.awake(),
                    world.rigids.step.contacts.pairs(),
                    world.pipeline.bytesHeld()
                            + world.events.bytes()
                            + world.terrain.bytes()
                            + world.joints.bytes()
                            + world.rigids.bytes(),
                    Collections.unmodifiableMap(world.pipeline.stageMillis()),
                    world.pipeline.device());
        }
    }

    /** Ends the simulation and closes its pipeline. */
    @Override
    public void close() {
        world.guard.takeTurn();
        try (world.guard) {
            world.guard.end();
            world.moves.close();
        }
    }

    /**
     * Figures of a simulation, and of its last step: pairs whose distance the broad phase tested, contacts, the greatest number of contacts of one
     * circle, circles that neither sleep nor are static; bodies that are pushed, those that do not sleep, their pairs with contacts. Memory is
     * in bytes; times by stage since the start, in milliseconds, are empty unless profiling.
     */
    public record Figures(
            int circles,
            long candidatePairs,
            int contacts,
            int greatestContacts,
            int awake,
            int bodies,
            int awakeBodies,
            int bodyContacts,
            long bytesHeld,
            Map<String, Double> stageMillis,
            String device) {}
}
