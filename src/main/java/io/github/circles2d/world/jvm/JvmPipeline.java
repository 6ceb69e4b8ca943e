package io.github.circles2d.world.jvm;

import static io.github.circles2d.world.model.CircleRow.VX;
import static io.github.circles2d.world.model.CircleRow.VY;

import io.github.circles2d.world.bodies.RigidStep;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.circles.IdMask;
import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.joints.BrokenJoints;
import io.github.circles2d.world.joints.SavedJointStates;
import io.github.circles2d.world.jvm.bodies.RigidPasses;
import io.github.circles2d.world.jvm.bodies.RigidSensing;
import io.github.circles2d.world.jvm.bodies.WakingByBodies;
import io.github.circles2d.world.jvm.grid.Ahead;
import io.github.circles2d.world.jvm.grid.ContinuousCollision;
import io.github.circles2d.world.jvm.grid.Grid;
import io.github.circles2d.world.jvm.joints.JointPasses;
import io.github.circles2d.world.jvm.joints.RestingJoints;
import io.github.circles2d.world.jvm.pieces.PieceSearch;
import io.github.circles2d.world.jvm.solver.Contacts;
import io.github.circles2d.world.jvm.solver.Solver;
import io.github.circles2d.world.jvm.solver.Touches;
import io.github.circles2d.world.jvm.state.PieceContacts;
import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.jvm.threads.ColdStart;
import io.github.circles2d.world.jvm.threads.Team;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.ContactSettings;
import io.github.circles2d.world.model.Features;
import io.github.circles2d.world.model.GridLevels;
import io.github.circles2d.world.model.JointStep;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.StepInput;
import io.github.circles2d.world.model.StepReports;
import io.github.circles2d.world.model.TerrainStep;
import io.github.circles2d.world.shared.Pipeline;
import io.github.circles2d.world.snapshots.SavedState;
import io.github.circles2d.world.terrain.SavedPieceContacts;
import java.nio.FloatBuffer;
import java.util.Map;

/** The World engine in plain Java. Tests compare every other pipeline with it. */
public final class JvmPipeline implements Pipeline {
    /** Circles that a thread has at least: with fewer, waiting for each other costs more than it saves. */
    public static final int LEAST_SHARE = 512;

    /** Shares of circles that a thread saves at least: to save a circle takes about a fifth of its step. */
    private static final int SAVED_SHARE = 8;

    /**
     * Many circles are saved by at least so many threads, if there are as many, else by one: several must count impulses first, which takes
     * half as long again.
     */
    public static final int LEAST_SAVERS = 4;

    private static final int GRID = 0;
    private static final int SWEEP = 1;
    private static final int CONTACTS = 2;
    private static final int SOLVER = 3;

    final State state = new State();
    final GridLevels levels = new GridLevels();
    private final Extent extent;

    /** Whether the grid of the step has been fitted to where the circles are. */
    private boolean fits;

    /** The levels of all circles; {@link #levels} has room for those that do not rest. */
    private GridLevels shape;

    private final Team team;
    final Grid grid;
    final Contacts contacts;
    private final ContinuousCollision sweep;
    private final Solver solver;
    private final Saving saving;

    /** Null as long as there has been no terrain. */
    private PieceSearch pieces;

    private TerrainStep terrain;

    /** Null as long as there has been no joint. */
    private JointPasses joints;

    private JointStep jointStep;

    /** Null as long as there has been no rigid body. */
    private RigidStep rigids;

    private RigidPasses rigidPasses;

    /** Null as long as nobody has been told what rigid bodies touch while kinds did not only push each other. */
    private RigidSensing rigidSensing;

    /** Whether rigid bodies have no part in the step: all sleep, and nothing moves. */
    private boolean rigidIdle;

    /** Null if circles never sleep. */
    private Waking waking;

    /** By id, at the end of a step: whether a joint drives the circle; null without joints. */
    private boolean[] driven;

    /** What decides which kinds fall asleep. */
    private float[] kindSleep;

    /** Whether a circle has fallen asleep in the step. */
    private volatile boolean someFellAsleep;

    private final StageTimes times;
    private final int leastShare;
    private final Runnable work = this::makeStep;
    private final Team.Work fallAsleep = this::fallAsleep;

    /** What the step is to be made with. */
    StepConstants constants;

    private StepInput stepInput;
    private StepReports reports;

    /** Records what is reported; null if nobody is told. */
    private Recorder recorder;

    /** What is to record from the next call of {@link #report} on. */
    private Recorder nextRecorder;

    private final Positions positions = new Positions();

    /** The positions requested last, and those taken last, which a caller may still look into. */
    private Positions requested = new Positions();

    private Positions taken = new Positions();

    /** Whether the positions taken last were taken by id: the next ones probably are, too, and are copied so. */
    private boolean takenById;

    /** The least share is {@link #LEAST_SHARE} but in tests. */
    public JvmPipeline(int threads, int leastShare, int capacity, boolean profiling) {
        team = new Team(threads);
        this.leastShare = leastShare;
        times = new StageTimes(profiling, "Grid", "ContinuousCollision", "Contacts", "Solver");
        grid = new Grid(state, levels, team);
        extent = new Extent(state, team);
        Ahead[] ahead = Ahead.ofWorkers(team);
        contacts = new Contacts(state, grid, levels, team, ahead);
        sweep = new ContinuousCollision(state, grid, levels, team, ahead);
        solver = new Solver(state, grid, contacts, levels, team);
        saving = new Saving(state, contacts.impulseCache(), team);
        state.ensure(capacity);
    }

    /** From now on no circle rests, which changes no bit; for tests. */
    public void keepAwake() {
        state.resting.turnOff();
    }

    /** Whether the grid of the last step was fitted to where the circles are: a device may have tested other pairs; for tests. */
    public boolean fitsGrid() {
        return fits;
    }

    @Override
    public void prepare(ContactSettings settings, Features features) {
        if (features.turning()) {
            startTurning();
        }
        if (features.terrain()) {
            startTerrain();
        }
        if (features.joints() && joints == null) {
            joints = new JointPasses(state, team);
        }
        if (features.sleeping() && waking == null) {
            state.startSleep(contacts.impulseCache());
            waking = new Waking(state, grid, contacts);
        }
    }

    @Override
    public void prepare(RigidStep bodies) {
        rigids = bodies;
        state.rigids = bodies;
        if (rigidPasses == null) {
            rigidPasses = new RigidPasses(state, team, leastShare);
        }
    }

    private void startTerrain() {
        state.startTerrain();
        if (pieces == null) {
            pieces = new PieceSearch(state, team);
        }
    }

    private void startTurning() {
        contacts.impulseCache().ensureRows();
        state.startTurning();
    }

    @Override
    public void makeRoom(Commands commands) {
        state.makeRoom(commands);
    }

    @Override
    public void apply(Commands commands) {
        state.apply(commands);
    }

    @Override
    public void step(StepInput input, GridLevels all, int count) {
        shape = all;
        constants = input.constants;
        stepInput = input;
        reports = input.reports;
        terrain = input.terrain;
        jointStep = input.joints;
        solver.join(constants.joints ? joints : null);
        solver.push(constants.rigid ? rigidPasses : null);
        kindSleep = input.sleep.rows;
        boolean parts = constants.joints && jointStep.parts;
        state.jointed = null;
        state.parting = parts ? jointStep : null;
        state.partingStates = parts ? joints.states : null;
        state.setArena(constants.arena);
        state.setSleeps(constants.sleeping);
        state.filtering = constants.filtering;
        state.responses = input.responses;
        state.kindMotion = constants.driving ? input.motion.rows : null;
        state.ownMotion = constants.ownMotion;
        if (constants.turning) {
            state.turning.take(input.surfaces);
        }
        state.asking = recorder == null ? null : recorder.asking(reports);
        Touches touches = recorder == null ? null : recorder.touches(reports);
        contacts.touches = touches;
        solver.record(touches);
        if (pieces != null) {
            pieces.touches = touches == null ? null : touches.pieces;
        }
        for (int step = 0; step < count; step++) {
            constants.warmScale = step > 0 ? 1f : constants.warmScale;
            int ofCircles = Math.max(1, state.awake / leastShare);
            int wanted = constants.rigid ? Math.max(ofCircles, rigidPasses.workers(rigids)) : ofCircles;
            int workers = Math.min(team.most(), wanted);
            team.setFew(ofCircles == 1);
            long begun = System.nanoTime();
            team.run(ColdStart.workers(workers), work);
            ColdStart.made(System.nanoTime() - begun);
        }
    }

    private void begin() {
        times.begin();
        if (state.sleepers != null) {
            waking.settle(constants, terrain, pieces);
        }
        state.resting.settle(constants, reports.seekingVersion);
        makeRoom();
    }

    private void makeRoom() {
        levels.copy(shape);
        fits = (state.awake < state.n || levels.areRoomy()) && !state.hasMovingStatic();
        if (fits) {
            extent.measure();
            levels.fit(state.awake, extent.width, extent.height);
        }
        grid.ensure();
        contacts.ensure();
        sweep.ensure();
        if (constants.terrain) {
            pieces.ensure();
        }
        if (constants.joints) {
            joints.ensure(jointStep, constants);
        }
        if (recorder != null) {
            recorder.ensure(reports);
        }
    }

    private void makeStep() {
        begin();
        grid.build(constants);
        rigidIdle = false;
        boolean sleep = state.sleepers != null && (state.sleepers.count > 0 || constants.rigid && rigids.anySleeps());
        boolean found = sleep && !wake();
        times.end(GRID);
        state.seen = null;
        if (records()) {
            recorder.begin();
        }
        if (constants.rigid) {
            rigids.touches = 0;
            rigids.touchesStay = true;
            if (rigids.listener != null && constants.filtering && rigidSensing == null) {
                rigidSensing = new RigidSensing(state);
            }
            if (rigidSensing != null) {
                rigidSensing.begin(rigids, stepInput);
            }
        }
        if (constants.joints) {
            joints.begin();
            joints.beginRigid(jointStep);
        }
        sweep.sweep(constants);
        if (constants.terrain) {
            pieces.find(terrain, constants.turning);
        }
        times.end(SWEEP);
        if (!found || grid.anyFast()) { // continuous collision changes how far circles look
            contacts.findResting();
        }
        contacts.beginResting(constants);
        boolean crowded = contacts.wereCrowded();
        if (!crowded) {
            contacts.find();
            crowded = contacts.overflowed();
        }
        if (!crowded) {
            solver.prepare(constants, terrain);
            crowded = contacts.crowded();
        }
        if (crowded) {
            contacts.findShare();
            solver.prepare(constants, terrain);
        }
        contacts.settleResting();
        if (constants.rigid) {
            solver.push(rigidIdle ? null : rigidPasses);
        }
        if (constants.rigid && !rigidIdle) {
            if (!found || grid.anyFast()) { // continuous collision has changed how fast circles are
                findRigid();
            }
            rigidPasses.begin(constants.sleeping ? kindSleep : null);
        }
        times.end(CONTACTS);
        solver.solve();
        if (constants.rigid && !rigidIdle) {
            rigidPasses.end();
        }
        if (constants.joints) {
            joints.end();
        }
        if (constants.rigid && rigids.listener != null) {
            if (rigidSensing != null) {
                rigidSensing.end(constants, constants.terrain ? terrain : null);
            }
            rigids.listener.stepped();
        }
        if (records()) {
            recorder.end(terrain, constants);
        }
        if (state.sleepers != null) {
            fallAsleep();
        }
        times.end(SOLVER);
    }

    /** Whether somebody is told what circles touch; of steps without circles the caller tells. */
    private boolean records() {
        return recorder != null && state.n > 0;
    }

    /** Finds the circles that rest near to others, and wakes some. If there are any, the grid is another one, and the finding void: returns true. */
    private boolean wake() {
        contacts.findResting();
        RestingJoints held = constants.joints ? joints.resting : null;
        rigidIdle = constants.rigid
                && waking.isIdle(held)
                && rigidPasses.isIdle(rigids, constants, terrain, joinsRigids() ? jointStep : null);
        WakingByBodies bodies = constants.rigid && !rigidIdle ? rigidPasses.waking : null;
        if (bodies != null) {
            findRigid();
            bodies.begin(rigids, constants);
        }
        boolean some = waking.wake(constants, terrain, pieces, held, bodies);
        if (some) {
            makeRoom();
            grid.build(constants);
        }
        return some;
    }

    private boolean joinsRigids() {
        return constants.joints && jointStep.rigidCount > 0;
    }

    private void findRigid() {
        boolean joined = joinsRigids();
        rigidPasses.find(rigids, constants, terrain, joined ? jointStep : null, joined ? joints.states : null);
    }

    private void fallAsleep() {
        driven = constants.joints ? joints.resting.findDriven() : null;
        team.all(fallAsleep);
        if (constants.joints) {
            joints.resting.end(contacts.impulseCache());
        }
        if (someFellAsleep) {
            someFellAsleep = false;
            state.noteDrowsy();
        }
    }

    private void fallAsleep(int worker) {
        int from = team.part(state.awake, worker);
        int to = team.part(state.awake, worker + 1);
        if (FallingAsleep.find(state, kindSleep, driven, from, to, constants)) {
            someFellAsleep = true;
        }
    }

    @Override
    public void makeRoomToReport(ContactEvents events) {
        nextRecorder = new Recorder(state, grid, levels, contacts, team, events);
    }

    @Override
    public void report(ContactEvents events) {
        recorder = events == null ? null : nextRecorder;
        nextRecorder = null;
        if (recorder != null) {
            recorder.start();
        }
    }

    @Override
    public void finish() {
        // a step has been made when step returns
    }

    @Override
    public void confine(Bounds from, Bounds to, Bounds calm) {
        state.confine(from, to, calm);
    }

    @Override
    public long hash() {
        long sum = state.hash();
        for (int slot = 0; slot < state.n; slot++) {
            sum += contacts.impulseCache().hash(slot);
        }
        return sum;
    }

    @Override
    public void readCircles(HandleTable handles, float[] to) {
        int k = 0;
        for (int id = 0; id < handles.end(); id++) {
            if (handles.lives(id)) {
                System.arraycopy(state.circle, CircleRow.of(state.slotOf[id]), to, CircleRow.of(k++), CircleRow.STRIDE);
            }
        }
    }

    @Override
    public FloatBuffer positions(HandleTable handles, boolean byId) {
        positions.copy(state, handles, byId);
        return byId ? positions.byId(positions.living) : positions.together();
    }

    @Override
    public void makeRoomForPositions(HandleTable handles) {
        requested.makeRoom(handles);
    }

    @Override
    public void requestPositions(HandleTable handles) {
        requested.copy(state, handles, takenById);
    }

    @Override
    public boolean positionsArrived() {
        return true;
    }

    @Override
    public FloatBuffer takePositions(IdMask shown) {
        FloatBuffer view = shown == null ? requested.together() : requested.byId(shown);
        Positions next = taken;
        taken = requested;
        requested = next;
        takenById = shown != null;
        return view;
    }

    @Override
    public void readVelocities(HandleTable handles, float[] to) {
        int k = 0;
        for (int id = 0; id < handles.end(); id++) {
            if (handles.lives(id)) {
                int s = CircleRow.of(state.slotOf[id]);
                to[2 * k] = state.motion[s + VX];
                to[2 * k + 1] = state.motion[s + VY];
                k++;
            }
        }
    }

    @Override
    public void readAngles(HandleTable handles, int[] to) {
        int k = 0;
        for (int id = 0; id < handles.end(); id++) {
            if (handles.lives(id)) {
                to[k++] = state.turning.angle[state.slotOf[id]];
            }
        }
    }

    @Override
    public void readAngularVelocities(HandleTable handles, float[] to) {
        int k = 0;
        for (int id = 0; id < handles.end(); id++) {
            if (handles.lives(id)) {
                to[k++] = state.turning.angularVelocity[state.slotOf[id]];
            }
        }
    }

    @Override
    public int awake(int circles) {
        return state.sleepers == null ? circles : Math.min(state.awake, circles);
    }

    @Override
    public boolean isAsleep(int id) {
        return state.sleepers != null && state.sleepers.isAsleep(id);
    }

    @Override
    public void readAsleep(long[] byId) {
        for (int slot = 0; state.sleepers != null && slot < state.n; slot++) {
            int id = state.id[slot];
            byId[id >> 6] |= state.sleepers.isAsleep(id) ? 1L << id : 0L;
        }
    }

    @Override
    public void saveIds(SavedState into) {
        into.setCircles(state.n);
        if (state.pieces == null) {
            System.arraycopy(state.id, 0, into.id, 0, state.n); // as they lie, which is faster
            return;
        }
        int k = 0;
        for (int id = 0; id < state.slotOf.length; id++) {
            if (state.slotOf[id] >= 0) {
                into.id[k++] = id;
            }
        }
    }

    @Override
    public void save(SavedState into) {
        into.setTurns(state.turning != null);
        into.setSleeps(state.sleepers != null);
        saving.save(into, Math.min(team.most(), into.circles / (SAVED_SHARE * leastShare)));
    }

    @Override
    public void savePieceContacts(SavedPieceContacts into) {
        into.clear();
        if (state.pieces != null) {
            for (int id = 0; id < state.slotOf.length; id++) {
                int slot = state.slotOf[id];
                if (slot >= 0 && state.sleepers != null && state.sleepers.pieces(id) > 0) {
                    PieceContacts.save(id, state.sleepers, into);
                } else if (slot >= 0) {
                    state.pieces.save(slot, id, into);
                }
            }
        }
    }

    @Override
    public void saveJoints(SavedJointStates into) {
        if (joints == null) {
            into.begin(0);
        } else {
            joints.states.save(into);
        }
    }

    @Override
    public void takeBroken(BrokenJoints into) {
        if (joints == null) {
            into.begin(0);
        } else {
            joints.states.takeBroken(into);
        }
    }

    @Override
    public void makeRoom(SavedState from) {
        if (joints != null) {
            joints.states.ensure(from.jointStates.joints);
        }
        contacts.impulseCache().ensure(from.impulses);
        if (from.turns) {
            contacts.impulseCache().ensureRows();
        }
        state.makeRoom(from);
    }

    @Override
    public void load(SavedState from) {
        if (rigidPasses != null) {
            rigidPasses.waking.lookAtAll();
        }
        state.load(from);
        contacts.load(from);
        if (joints != null) {
            joints.states.load(from.jointStates);
        }
    }

    @Override
    public void leave() {
        recorder = null;
    }

    @Override
    public long candidatePairs() {
        return contacts.candidatePairs();
    }

    @Override
    public int contacts() {
        return contacts.count;
    }

    @Override
    public int greatestContacts() {
        return contacts.greatest();
    }

    @Override
    public long bytesHeld() {
        long recorded = recorder == null ? 0 : recorder.bytes();
        return state.bytes()
                + (pieces == null ? 0 : pieces.bytes())
                + (joints == null ? 0 : joints.bytes())
                + (rigidPasses == null ? 0 : rigidPasses.bytes())
                + (rigidSensing == null ? 0 : rigidSensing.bytes())
                + grid.bytes()
                + contacts.bytes()
                + sweep.bytes()
                + recorded;
    }

    @Override
    public Map<String, Double> stageMillis() {
        return times.millis();
    }

    @Override
    public String device() {
        return "Java " + System.getProperty("java.version") + ", " + team.most()
                + (team.most() == 1 ? " thread" : " threads");
    }

    @Override
    public void close() {
        team.close();
    }
}
