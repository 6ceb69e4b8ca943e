package io.github.circles2d.world.jvm;

import io.github.circles2d.world.bodies.KeptContacts;
import io.github.circles2d.world.bodies.RigidStep;
import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.joints.BrokenJoints;
import io.github.circles2d.world.joints.SavedJointStates;
import io.github.circles2d.world.jvm.bodies.RigidPasses;
import io.github.circles2d.world.jvm.bodies.RigidSensing;
import io.github.circles2d.world.jvm.state.JointStates;
import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.jvm.threads.Team;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.JointRow;
import io.github.circles2d.world.model.JointStep;
import io.github.circles2d.world.model.KindSurface;
import io.github.circles2d.world.model.StepInput;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;

/**
 * The rigid bodies of a world whose circles are on a device. The same classes make their part of a step as where all is on the JVM; they work on copies
 * of those circles that are near to bodies. {@code BodyStage} brings these here and back, between the passes of the device.
 */
public final class HostBodies implements AutoCloseable {
    /** Words of a circle as it comes near: see {@link #add}. */
    public static final int NEAR_WORDS = 40;

    /** Words of a circle that bodies may sense: id, kind, group, radius, x and y as the step begins, and as it ends. */
    public static final int SENSED_WORDS = 8;

    /** Words of a circle at a body, which travel in each pass: motion, load, surface speed, impulse on it, allowance, how far it has turned. */
    public static final int ROW_WORDS = 12;

    // words of a circle as it comes near; what is of four floats is as CircleRow has it
    private static final int ID = 0;
    private static final int KIND = 1;
    private static final int GROUP = 2;
    private static final int FORCE_X = 3;
    private static final int FORCE_Y = 4;
    private static final int SLOT = 5;
    private static final int SPIN = 6;
    private static final int INVERSE_INERTIA = 7;
    private static final int CIRCLE = 8;
    private static final int MOTION = 12;
    private static final int TRAITS = 16;
    private static final int OWN_MOTION = 20;
    private static final int ANGLE = 23;
    private static final int SURFACE = 24;

    // words of a circle that bodies may sense, behind its group
    private static final int SENSED_RADIUS = 3;
    private static final int SENSED_FROM = 4;
    private static final int SENSED_TO = 6;

    // words of a circle at a body
    private static final int ROW_MOTION = 0;
    private static final int ROW_LOAD = 4;
    private static final int ROW_SPIN = 8;
    private static final int ROW_SPIN_IMPULSE = 9;
    private static final int ROW_ALLOWANCE = 10;
    private static final int ROW_TURNED = 11;

    private final Team team;
    private final State state = new State();
    private final RigidPasses passes;

    /** Who wakes before a step. */
    public final HostWaking waking;

    private final RigidSensing sensing = new RigidSensing(state);

    /** What joints that hold bodies keep. */
    private final JointStates states = new JointStates();

    private StepInput input;
    private RigidStep bodies;
    private int workers;
    private int subStep;
    private boolean last;

    /** By place among the circles near to bodies: where the device has it. */
    private int[] deviceSlot = new int[0];

    /** The places of those that passes look at. */
    private int[] atBodies = new int[0];

    private int atBodiesCount;

    /** By place: whether it is among those; only while these are put down. */
    private boolean[] isAtBodies = new boolean[0];

    /** The circles that joints hold to bodies: ids, of which one may come more than once. */
    private int[] held = new int[0];

    private int heldCount;

    /** The same of circles with contacts that stay, since their bodies sleep. */
    private int[] resting = new int[0];

    private int restingCount;

    /** What workers make together. */
    private enum Part {
        FIND_BODIES,
        FIND_CONTACTS,
        BEGIN,
        DRIVE_BODIES,
        SOLVE_BODIES,
        SOLVE_CIRCLES,
        RELAX_BODIES,
        RELAX_CIRCLES,
        END
    }

    private Part part;
    private final Runnable make = this::make;

    /** Takes no more threads than that. */
    public HostBodies(int threads) {
        team = new Team(threads);
        state.startTurning();
        passes = new RigidPasses(state, team, JvmPipeline.LEAST_SHARE);
        waking = new HostWaking(state, passes.waking);
    }

    private void run(Part which) {
        part = which;
        team.run(workers, make);
    }

    private void make() {
        switch (part) {
            case FIND_BODIES -> {
                JointStep joints = joined() ? input.joints : null;
                passes.findBodies(bodies, input.constants, input.terrain, joints, joints == null ? null : states);
            }
            case FIND_CONTACTS -> {
                passes.findContacts();
                findCirclesAtBodies();
            }
            case BEGIN -> {
                sensing.beginWithoutCircles(bodies, input);
                passes.begin(input.constants.sleeping ? input.sleep.rows : null);
            }
            case DRIVE_BODIES -> passes.integrateVelocities();
            case SOLVE_BODIES -> passes.solve(subStep);
            case SOLVE_CIRCLES -> passes.solveCircles();
            case RELAX_BODIES -> {
                passes.integratePositions(subStep);
                passes.relax(subStep, last);
            }
            case RELAX_CIRCLES -> passes.relaxCircles(last);
            case END -> {
                passes.end();
                states.endStep();
            }
        }
    }

    /** Sets what steps are made with, until the next call. */
    public void use(StepInput of, RigidStep these) {
        input = of;
        bodies = of.constants.rigid ? these : null;
        if (bodies == null) {
            return;
        }
        states.ensure(of.joints.joints);
        findHeld();
        workers = Math.max(1, Math.min(team.most(), passes.workers(these)));
    }

    /** Finds the circles that joints hold to bodies, before each step: some may have broken in the one before. */
    public void findHeld() {
        heldCount = 0;
        int joined = joined() ? input.joints.rigidCount : 0;
        if (held.length < joined) {
            held = new int[joined + (joined >> 1)];
        }
        for (int n = 0; n < joined; n++) {
            int joint = input.joints.rigidOrder[n];
            int circle = heldBy(joint);
            if (circle != JointRow.NONE && !states.hasBroken(joint, input.joints)) {
                held[heldCount++] = circle;
            }
        }
    }

    /** The circle that a joint holds to a body, or {@link JointRow#NONE}. */
    private int heldBy(int joint) {
        int traits = JointRow.traits(joint);
        int a = input.joints.traits[traits + JointRow.A];
        return a != JointRow.NONE ? a : input.joints.traits[traits + JointRow.B];
    }

    /** How many times joints hold circles to bodies. */
    public int held() {
        return heldCount;
    }

    /** Puts the ids of these circles. */
    public void putHeld(IntBuffer to) {
        to.put(held, 0, heldCount);
    }

    /** Behind a step: the same without those whose joint has broken; returns how many. */
    public int putStillHeld(IntBuffer to) {
        int many = 0;
        for (int n = 0; heldCount > 0 && n < input.joints.rigidCount; n++) {
            int joint = input.joints.rigidOrder[n];
            int circle = heldBy(joint);
            if (circle != JointRow.NONE
                    && states.serial[joint] == input.joints.traits[JointRow.traits(joint) + JointRow.SERIAL]) {
                to.put(circle);
                many++;
            }
        }
        return many;
    }

    /** How many times circles are named that come to the host wherever they are: those, and what rests at bodies that sleep. */
    public int named() {
        return heldCount + restingCount;
    }

    /** Puts their ids, those that joints hold first. */
    public void putNamed(IntBuffer to) {
        to.put(held, 0, heldCount).put(resting, 0, restingCount);
    }

    private void findResting() {
        restingCount = 0;
        if (!input.constants.sleeping) {
            return;
        }
        KeptContacts contacts = bodies.contacts;
        if (resting.length < contacts.count) {
            resting = new int[contacts.count + (contacts.count >> 1)];
        }
        for (int c = 0; c < contacts.count; c++) {
            if (contacts.type(c) == RigidStep.BODY_CIRCLE && bodies.isAsleep(contacts.a(c))) {
                resting[restingCount++] = contacts.b(c);
            }
        }
    }

    /** Whether steps have bodies. */
    public boolean areThere() {
        return bodies != null;
    }

    /** Begins a step: finds in which boxes bodies may meet circles. */
    public void findBoxes(float warmScale) {
        input.constants.warmScale = warmScale;
        state.setArena(input.constants.arena);
        state.filtering = input.constants.filtering;
        state.responses = input.responses;
        state.kindMotion = input.constants.driving ? input.motion.rows : null;
        state.ownMotion = input.constants.ownMotion;
        state.turning.surfaces = input.surfaces.rows;
        forgetCircles();
        findResting();
        run(Part.FIND_BODIES);
    }

    /** How many boxes there are. */
    public int boxes() {
        return passes.boxCount();
    }

    /** Puts four floats for each box: least x and y, greatest x and y. */
    public void putBoxes(FloatBuffer to) {
        to.put(passes.boxes(), 0, 4 * passes.boxCount());
    }

    private void forgetCircles() {
        for (int k = 0; k < state.n; k++) {
            state.slotOf[state.id[k]] = -1;
        }
        state.n = 0;
        state.awake = 0;
    }

    /** Takes copies of so many circles that may be near to bodies, {@link #NEAR_WORDS} each, and finds contacts. */
    public void findContacts(int circles, IntBuffer words, int at) {
        state.ensure(circles);
        if (deviceSlot.length < circles) {
            deviceSlot = new int[state.capacity()];
            atBodies = new int[state.capacity()];
            isAtBodies = new boolean[state.capacity()];
        }
        addAll(circles, words, at, false);
        state.awake = state.n;
        if (input.constants.sleeping) {
            addAll(circles, words, at, true);
        }
        run(Part.FIND_CONTACTS);
    }

    /** Those that sleep lie behind the others, as where all is on the JVM. */
    private void addAll(int circles, IntBuffer words, int at, boolean asleep) {
        for (int k = 0; k < circles; k++) {
            int row = at + NEAR_WORDS * k;
            boolean sleeps = input.constants.sleeping
                    && real(words, row + TRAITS + CircleRow.INVERSE_MASS) == 0f
                    && CircleMath.inverseMass(real(words, row + CIRCLE + CircleRow.MASS)) != 0f;
            if (sleeps == asleep) {
                add(words, row);
            }
        }
    }

    private void add(IntBuffer words, int at) {
        int id = words.get(at + ID);
        state.ensureIds(id + 1);
        if (state.slotOf[id] >= 0) {
            return; // it is near, and a joint holds it
        }
        int slot = state.n++;
        deviceSlot[slot] = words.get(at + SLOT);
        state.id[slot] = id;
        state.slotOf[id] = slot;
        set(CircleField.KIND, id, words.get(at + KIND));
        set(CircleField.GROUP, id, words.get(at + GROUP));
        set(CircleField.FORCE_X, id, words.get(at + FORCE_X));
        set(CircleField.FORCE_Y, id, words.get(at + FORCE_Y));
        if (state.ownMotion) {
            set(CircleField.GRAVITY_SCALE, id, words.get(at + OWN_MOTION));
            set(CircleField.DAMPING, id, words.get(at + OWN_MOTION + 1));
            set(CircleField.GREATEST_SPEED, id, words.get(at + OWN_MOTION + 2));
        }
        int s = CircleRow.of(slot);
        for (int e = 0; e < CircleRow.STRIDE; e++) {
            state.circle[s + e] = real(words, at + CIRCLE + e);
            state.motion[s + e] = real(words, at + MOTION + e);
            state.traits[s + e] = real(words, at + TRAITS + e);
            state.load[s + e] = 0f;
        }
        state.turning.spin[s + CircleRow.SURFACE_SPEED] = real(words, at + SPIN);
        state.turning.spin[s + CircleRow.INVERSE_INERTIA] = real(words, at + INVERSE_INERTIA);
        state.turning.spin[s + CircleRow.TURNED] = 0f;
        state.turning.angle[slot] = words.get(at + ANGLE);
        for (int e = 0; e < KindSurface.STRIDE; e++) {
            state.turning.circleSurfaces[KindSurface.of(slot) + e] = real(words, at + SURFACE + e);
        }
        if (input.constants.sleeping) { // who sleeps has its surface from here
            for (int e = 0; e < CircleField.surfaces(); e++) {
                set(CircleField.surface(e), id, words.get(at + SURFACE + KindSurface.OF_CIRCLES + e));
            }
        }
    }

    /** All values of a circle are set whenever it comes near, so what it had before does not matter. */
    private void set(CircleField field, int id, int bits) {
        if (bits != (int) field.initial() || id < state.fields.end(field)) {
            state.fields.ensure(field, id + 1);
            state.fields.set(field, id, bits);
        }
    }

    private static float real(IntBuffer words, int at) {
        return Float.intBitsToFloat(words.get(at));
    }

    private void findCirclesAtBodies() {
        atBodiesCount = passes.circles(atBodies);
        for (int k = 0; k < atBodiesCount && heldCount > 0; k++) {
            isAtBodies[atBodies[k]] = true;
        }
        for (int k = 0; k < heldCount; k++) {
            int slot = state.slotOf[held[k]];
            if (!isAtBodies[slot]) {
                isAtBodies[slot] = true;
                atBodies[atBodiesCount++] = slot;
            }
        }
        for (int k = 0; k < atBodiesCount && heldCount > 0; k++) {
            isAtBodies[atBodies[k]] = false;
        }
    }

    // ---- who wakes

    /** Whether bodies and circles sleep in the world. */
    public boolean sleep() {
        return input.constants.sleeping;
    }

    /** Whether a body sleeps. */
    public boolean anySleeps() {
        return bodies.anySleeps();
    }

    /** Whether a step changes nothing of bodies if no circle moves, and tells nobody of touches. */
    public boolean areIdle() {
        forgetCircles();
        return bodies == null
                || input.constants.sleeping
                        && bodies.listener == null
                        && passes.isIdle(bodies, input.constants, input.terrain, joined() ? input.joints : null);
    }

    /** Begins to wake bodies, once contacts have been found. */
    public void beginWaking() {
        waking.begin(bodies, input.constants);
    }

    /** Puts what presses circles that sleep and is about to push them. */
    public void putSleepers(IntBuffer to, int at) {
        waking.put(to, at, deviceSlot);
    }

    private boolean wakeAlone() {
        beginWaking();
        waking.passOnAlone();
        return waking.end();
    }

    // ---- circles at bodies

    /** How many circles may touch bodies in the step, or nearly. */
    public int circles() {
        return atBodiesCount;
    }

    /** Puts where the device has them. */
    public void putSlots(IntBuffer to) {
        for (int k = 0; k < atBodiesCount; k++) {
            to.put(deviceSlot[atBodies[k]]);
        }
    }

    /** Takes them as they are now, {@link #ROW_WORDS} floats each. */
    public void take(FloatBuffer from) {
        for (int k = 0; k < atBodiesCount; k++) {
            int at = ROW_WORDS * k;
            int s = CircleRow.of(atBodies[k]);
            for (int e = 0; e < CircleRow.STRIDE; e++) {
                state.motion[s + e] = from.get(at + ROW_MOTION + e);
                state.load[s + e] = from.get(at + ROW_LOAD + e);
            }
            state.turning.spin[s + CircleRow.SURFACE_SPEED] = from.get(at + ROW_SPIN);
            state.turning.spin[s + CircleRow.SPIN_IMPULSE] = from.get(at + ROW_SPIN_IMPULSE);
            state.motionClamp[s + CircleRow.ALLOWANCE] = from.get(at + ROW_ALLOWANCE);
            state.turning.spin[s + CircleRow.TURNED] = from.get(at + ROW_TURNED);
        }
    }

    /** Puts them as they have become. */
    public void put(FloatBuffer to) {
        for (int k = 0; k < atBodiesCount; k++) {
            int at = ROW_WORDS * k;
            int s = CircleRow.of(atBodies[k]);
            for (int e = 0; e < CircleRow.STRIDE; e++) {
                to.put(at + ROW_MOTION + e, state.motion[s + e]);
                to.put(at + ROW_LOAD + e, state.load[s + e]);
            }
            to.put(at + ROW_SPIN, state.turning.spin[s + CircleRow.SURFACE_SPEED]);
            to.put(at + ROW_SPIN_IMPULSE, state.turning.spin[s + CircleRow.SPIN_IMPULSE]);
            to.put(at + ROW_ALLOWANCE, state.motionClamp[s + CircleRow.ALLOWANCE]);
        }
    }

    // ---- passes, as RigidPasses has them

    /** Begins the passes, once circles have what they carry on from the step before. */
    public void begin() {
        waking.keep();
        bodies.touches = 0;
        bodies.touchesStay = true;
        run(Part.BEGIN);
    }

    /** Begins a sub-step: what drives bodies. */
    public void driveBodies() {
        run(Part.DRIVE_BODIES);
    }

    /** Visits joints, and contacts of bodies with each other and with what is no circle, with bias. */
    public void solveBodies(int sub) {
        subStep = sub;
        run(Part.SOLVE_BODIES);
    }

    /** Visits contacts with circles, which have ended their biased pass. */
    public void solveCircles() {
        run(Part.SOLVE_CIRCLES);
    }

    /** Moves bodies, behind circles, and visits joints and contacts of bodies without bias. */
    public void relaxBodies(int sub, boolean ofLast) {
        subStep = sub;
        last = ofLast;
        run(Part.RELAX_BODIES);
    }

    /** Visits contacts with circles, which have ended their relaxing pass. */
    public void relaxCircles() {
        run(Part.RELAX_CIRCLES);
    }

    /** Bodies take what they have become. */
    public void end() {
        run(Part.END);
    }

    // ---- sensors

    /** Whether circles are sought, behind a step, that bodies may sense. */
    public boolean seeksCircles() {
        return sensing.seeksCircles();
    }

    /** How many boxes there are of bodies that may sense circles in the step. */
    public int sensingBoxes() {
        return sensing.boxCount();
    }

    /** Puts them as {@link #putBoxes}. */
    public void putSensingBoxes(FloatBuffer to) {
        to.put(sensing.boxes(), 0, 4 * sensing.boxCount());
    }

    /** Takes so many circles that may be in these boxes, {@link #SENSED_WORDS} each. */
    public void takeSensed(int circles, IntBuffer words, int at) {
        forgetCircles();
        state.ensure(circles);
        for (int k = 0; k < circles; k++) {
            int from = at + SENSED_WORDS * k;
            int id = words.get(from + ID);
            state.ensureIds(id + 1);
            state.id[k] = id;
            state.slotOf[id] = k;
            state.n = k + 1;
            set(CircleField.KIND, id, words.get(from + KIND));
            set(CircleField.GROUP, id, words.get(from + GROUP));
            int s = CircleRow.of(k);
            state.circle[s + CircleRow.RADIUS] = real(words, from + SENSED_RADIUS);
            state.circle[s + CircleRow.X] = real(words, from + SENSED_TO);
            state.circle[s + CircleRow.Y] = real(words, from + SENSED_TO + 1);
            sensing.noteCircle(id, real(words, from + SENSED_FROM), real(words, from + SENSED_FROM + 1));
        }
    }

    /** Tells of touches of the step, if somebody wants to know. */
    public void tell() {
        if (bodies.listener != null) {
            sensing.end(input.constants, input.constants.terrain ? input.terrain : null);
            bodies.listener.stepped();
        }
    }

    // ---- joints that hold bodies

    private boolean joined() {
        return input.constants.joints && input.joints.rigidCount > 0;
    }

    /** Makes room for what joints keep. */
    public void makeRoomForJoints(int joints) {
        states.ensure(joints);
    }

    /** Takes over what joints keep, for which there is room. */
    public void loadJoints(SavedJointStates from) {
        states.load(from);
        passes.waking.lookAtAll();
    }

    /** Saves what joints keep that hold bodies, in the place of what a device has for them. */
    public void saveJoints(SavedJointStates into) {
        if (input == null || input.joints.rigidCount == 0) {
            return;
        }
        into.extend(input.joints.joints); // a device knows of no joints before it has made a step with circles
        for (int n = 0; n < input.joints.rigidCount; n++) {
            states.save(input.joints.rigidOrder[n], into);
        }
    }

    /** Adds the joints that have broken since the last time. */
    public void takeBroken(BrokenJoints into) {
        states.addBroken(into);
    }

    /** Makes a step in which no circle is near. */
    public void stepAlone(float warmScale, int subSteps) {
        findBoxes(warmScale);
        findContacts(0, null, 0);
        if (input.constants.sleeping && bodies.anySleeps() && wakeAlone()) {
            findBoxes(warmScale);
            findContacts(0, null, 0);
        }
        begin();
        for (int sub = 0; sub < subSteps; sub++) {
            driveBodies();
            solveBodies(sub);
            solveCircles();
            relaxBodies(sub, sub == subSteps - 1);
            relaxCircles();
        }
        end();
        tell();
    }

    public long bytes() {
        return state.bytes()
                + passes.bytes()
                + sensing.bytes()
                + states.bytes()
                + waking.bytes()
                + 4L * (deviceSlot.length + atBodies.length + held.length + resting.length)
                + isAtBodies.length;
    }

    @Override
    public void close() {
        team.close();
    }
}
