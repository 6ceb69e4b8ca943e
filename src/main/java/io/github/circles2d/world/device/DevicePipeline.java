package io.github.circles2d.world.device;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.KernelSource;
import io.github.circles2d.opencl.Session;
import io.github.circles2d.world.bodies.RigidStep;
import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.circles.IdMask;
import io.github.circles2d.world.device.memory.BodyArrays;
import io.github.circles2d.world.device.memory.DeviceArray;
import io.github.circles2d.world.device.memory.DeviceArrays;
import io.github.circles2d.world.device.memory.StageKernels;
import io.github.circles2d.world.device.memory.StepParameters;
import io.github.circles2d.world.device.plan.Plan;
import io.github.circles2d.world.device.plan.Plans;
import io.github.circles2d.world.device.plan.Stages;
import io.github.circles2d.world.device.queries.DeviceSearch;
import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.joints.BrokenJoints;
import io.github.circles2d.world.joints.SavedJointStates;
import io.github.circles2d.world.jvm.HostBodies;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.ContactSettings;
import io.github.circles2d.world.model.Features;
import io.github.circles2d.world.model.GridLevels;
import io.github.circles2d.world.model.Readiness;
import io.github.circles2d.world.model.StepInput;
import io.github.circles2d.world.model.StepReports;
import io.github.circles2d.world.queries.RemoteSearch;
import io.github.circles2d.world.shared.Pipeline;
import io.github.circles2d.world.snapshots.SavedState;
import io.github.circles2d.world.terrain.SavedPieceContacts;
import java.lang.ref.SoftReference;
import java.nio.FloatBuffer;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Consumer;

/**
 * The World engine on an OpenCL device. {@link StepQueue} enqueues steps and does not wait for them; the next call that needs their
 * result looks at their status first.
 */
public final class DevicePipeline implements Pipeline {
    /** Threads that make what bodies do on the host. */
    private static final int MOST_THREADS = Math.min(8, Runtime.getRuntime().availableProcessors());

    private final Session session;
    private final DeviceArrays arrays;
    private StageKernels kernels;
    private final StepParameters parameters = new StepParameters();
    private final int workGroupSize;
    private final CommandsStage commands;

    /** The kernels, in parts that are compiled when they are needed. */
    private final Map<Readiness, StageKernels> variants = new HashMap<>();

    /** What the plans share with these kernels. */
    private final Map<Readiness, Stages> stagesOf = new HashMap<>();

    /** What the plans share, with the kernels of one variant. Null before anything has been prepared for steps. */
    private Stages stages;

    /** What is reported of steps; null if nobody is told. */
    private ReportReader reader;

    /** All plans, whether ready or not. */
    private final List<Plan> plans;

    /** Whether the kernels are compiled in parts. If all are waited for, POCL takes a third of the time for one program. */
    private final boolean inParts;

    /** The first of them that suits a step makes it. */
    private final ReadyPlans ready;

    private final Readback readback;
    private final RequestedPositions requested;
    private final DeviceSearch search;
    private final StepStatistics stats;
    private final StepQueue.Home home = new StepQueue.Home();
    private final JointTransfer joints;
    private final StepQueue queue;

    /** Null, as their arrays, as long as there have been no bodies that are pushed. */
    private HostBodies hostBodies;

    private BodyArrays bodyArrays;

    /** The bodies that steps change. */
    private RigidStep rigids;

    /** Whether circles may have come to rest, in a pipeline that is ready for that. */
    private boolean sleeps;

    /** Of the changes to come. */
    private Bounds arena = new Bounds(0, 0, 1, 1);

    /** What the next load needs; null except between making room for it and loading. */
    private StateTransfer.Links links;

    /** Memory of the last load, and of the last save or hash, if it is still there. */
    private SoftReference<StateTransfer.Links> memoryOfLoad = new SoftReference<>(null);

    private SoftReference<StateTransfer> memoryOfSave = new SoftReference<>(null);

    /** Whether the plans have been compiled for contacts of any settings. */
    private boolean tuned;

    /** The features that the kernels are for. */
    private Features loaded = Features.NONE;

    /** Whether the kernels of steps have been asked for. */
    private boolean steps;

    /**
     * Opens a device.
     *
     * @param waits whether the first step waits for the kernels of the fastest plan
     */
    public DevicePipeline(Device device, int capacity, boolean profiling, boolean waits) {
        this(device, capacity, profiling, Plans.choose(device).of(device), StageKernels.USUAL_GROUPS, waits);
    }

    DevicePipeline(Device device, int capacity, boolean profiling, List<Plan> plans, int workGroupSize, boolean waits) {
        this(device, capacity, profiling, plans, workGroupSize, waits, Features.NONE);
    }

    /** Ready for features from the start: nothing is compiled without them. */
    DevicePipeline(
            Device device,
            int capacity,
            boolean profiling,
            List<Plan> plans,
            int workGroupSize,
            boolean waits,
            Features features) {
        this.plans = plans;
        inParts = !waits && plans.size() > 1;
        ready = new ReadyPlans(plans, waits);
        this.workGroupSize = workGroupSize;
        session = Session.open(device, profiling);
        try {
            arrays = new DeviceArrays(session, capacity, plans.stream().anyMatch(Plan::usesTileArrays));
            stats = new StepStatistics(arrays);
            joints = new JointTransfer(arrays);
            arrays.ensure(features);
            loaded = features(features.edges());
            kernels = kernelsOf(new Readiness(false, loaded, false, false));
            commands = new CommandsStage(session, kernels, arrays);
            readback = new Readback(session, kernels, arrays);
            requested = new RequestedPositions(session, kernels, arrays);
            search = new DeviceSearch(session, arrays, () -> home.slots, () -> home.circles);
            queue = new StepQueue(arrays, home, ready.list(), commands, requested, stats);
            stats.use(kernels);
            readBackWith(kernels);
        } catch (RuntimeException | Error e) {
            session.close();
            throw e;
        }
    }

    /** A fingerprint of this version's kernels. */
    public static String kernels() {
        return Plans.source(Plans.all()).fingerprint();
    }

    /**
     * Lets the plans use kernels for contacts of any settings, for axes without walls, and for steps that report, or others; and for features,
     * if there is memory for them.
     */
    private void load(boolean anySettings, boolean edges, ReportReader ofReports) {
        boolean reporting = ofReports != null && ofReports.isActive();
        boolean recording = reporting && ofReports.isRecording();
        Features features = features(edges);
        Readiness variant = new Readiness(anySettings, features, reporting, recording);
        StageKernels loading = kernelsOf(variant);
        compile(loading, reporting);
        kernels = loading;
        stats.use(loading);
        commands.use(loading);
        loaded = features;
        readBackWith(loading);
        if (steps) {
            stages = stagesOf.computeIfAbsent(variant, key -> newStages(key, loading));
            queue.use(stages, reader);
            stages.report(recording ? ofReports.touches() : null, reporting ? ofReports.deciding() : null);
            ready.use(stages, loading);
        }
        bind(loading);
    }

    private Stages newStages(Readiness variant, StageKernels loading) {
        HostBodies bodies = loaded.bodies() ? hostBodies : null;
        return new Stages(session, loading, Plans.ofSomeSteps(variant), arrays, parameters, bodies, bodyArrays);
    }

    /** Reads back what circles with the features that are loaded have besides. */
    private void readBackWith(StageKernels loading) {
        if (loaded.turning()) {
            readback.useTurning(loading);
        }
        if (loaded.sleeping()) {
            readback.useSleeping(loading);
        }
    }

    /** Before something uses the kernels: if a compiler refuses them, nothing has changed. */
    private void compile(StageKernels loading, boolean reporting) {
        if (!has(loading, steps, reporting)) {
            CompilerNotice.during(
                    () -> compileParts(loading, steps, reporting),
                    session.device().name());
        }
    }

    /** Binds kernels to the arrays: counts of the last step may be asked for before the next. */
    private void bind(StageKernels loading) {
        loading.bind(arrays, queue.slotsBehindPending(), home.circles);
    }

    /** Those that there is memory for. */
    private Features features(boolean edges) {
        return arrays.features().and(Features.EDGES.when(edges));
    }

    private StageKernels kernelsOf(Readiness variant) {
        return variants.computeIfAbsent(variant, this::newKernels);
    }

    private StageKernels newKernels(Readiness variant) {
        Features features = variant.features();
        KernelSource source = Plans.source(plans, session.device());
        source = variant.tuned() ? source.define("TUNED", 1) : source;
        source = features.edges() ? source.define("EDGES", 1) : source;
        source = features.turning() ? source.define("TURNING", 1) : source;
        source = features.terrain() ? source.define("TERRAIN", 1) : source;
        source = features.joints() ? source.define("JOINTS", 1) : source;
        source = features.sleeping() ? source.define("SLEEPING", 1) : source;
        source = features.bodies() ? source.define("BODIES", 1) : source;
        source = features.ownMotion() ? source.define("OWN_MOTION", 1) : source;
        return new StageKernels(
                session,
                source,
                workGroupSize,
                variant.reporting(),
                variant.recording(),
                inParts ? kernel -> Plans.partOf(plans, kernel) : null);
    }

    @Override
    public boolean isReady(Readiness wanted) {
        Readiness variant = withWhatThereIs(wanted);
        StageKernels all = variants.get(variant);
        StageKernels silent = variants.get(variant.silent());
        return all != null
                && silent != null
                && has(silent, true, false)
                && has(all, true, wanted.reporting())
                && Plans.ofSomeSteps(variant).stream().allMatch(all::has)
                && plans.stream().map(Plans::partOf).allMatch(part -> part == null || all.has(part));
    }

    private static boolean has(StageKernels of, boolean ofSteps, boolean reporting) {
        return of.has(Plans.CALLS) && (!ofSteps || of.has(Plans.STEPS)) && (!reporting || of.has(Plans.REPORTS));
    }

    /** The silent kernels too: features are made ready before it is told what steps report. */
    @Override
    public void compile(Readiness wanted) {
        Readiness variant = withWhatThereIs(wanted);
        compileParts(kernelsOf(variant.silent()), true, false);
        StageKernels all = kernelsOf(variant);
        compileParts(all, true, wanted.reporting());
        Plans.ofSomeSteps(variant).forEach(all::compile);
        for (Plan plan : plans) {
            if (Plans.partOf(plan) != null) {
                all.compile(Plans.partOf(plan));
            }
        }
    }

    private static void compileParts(StageKernels of, boolean ofSteps, boolean reporting) {
        of.compile(Plans.CALLS);
        if (ofSteps) {
            of.compile(Plans.STEPS);
        }
        if (reporting) {
            of.compile(Plans.REPORTS);
        }
    }

    /** What is prepared once stays so. */
    private Readiness withWhatThereIs(Readiness wanted) {
        return new Readiness(
                tuned || wanted.tuned(), loaded.and(wanted.features()), wanted.reporting(), wanted.recording());
    }

    @Override
    public void prepare(RigidStep bodies) {
        if (hostBodies == null) {
            bodyArrays = new BodyArrays(session);
            hostBodies = new HostBodies(MOST_THREADS);
        }
        rigids = bodies;
    }

    /** Compiles the plans anew if contacts or features need what the kernels do not have, which is rare. */
    @Override
    public void prepare(ContactSettings contacts, Features features) {
        boolean tunes = tuned || contacts.areTuned();
        Features all = loaded.and(features);
        if (tunes != tuned || !all.equals(loaded)) {
            settle();
            makeRoomFor(tunes, all);
            load(tunes, all.edges(), reader);
            tuned = tunes;
        }
    }

    /** Compiles the kernels of steps if there are none yet: a world may get features before its first step, and needs no kernels without them. */
    @Override
    public void prepareSteps(StepReports reports) {
        ready.requireKernels();
        if (reader != null && !reader.areOf(reports)) {
            settle();
            reader.learn(reports);
        }
        if (!steps) {
            settle();
            steps = true;
            try {
                load(tuned, loaded.edges(), reader);
            } catch (RuntimeException | Error e) {
                steps = false;
                throw e;
            }
        } else if (!areLoadedFor(reader)) {
            settle();
            load(tuned, loaded.edges(), reader);
        }
        if (reader != null) {
            reader.compile(stages);
        }
    }

    /** Whether the kernels of steps report what a reader takes. Others are compiled at the first report: that takes long, and few worlds report. */
    private boolean areLoadedFor(ReportReader ofReports) {
        boolean active = ofReports != null && ofReports.isActive();
        return stages.reporting() == (active ? ofReports.deciding() : null)
                && (stages.touches() != null) == (active && ofReports.isRecording());
    }

    private void start(Features features) {
        Features all = loaded.and(features);
        if (!all.equals(loaded)) {
            makeRoomFor(tuned, all);
            load(tuned, loaded.edges(), reader);
        }
    }

    /** If a compiler refuses the kernels, or there is no memory, the world does not have the features. */
    private void makeRoomFor(boolean anySettings, Features features) {
        boolean reporting = reader != null && reader.isActive();
        compile(
                kernelsOf(new Readiness(anySettings, features, reporting, reporting && reader.isRecording())),
                reporting);
        stats.keep(); // the figures of the last step are worked out from arrays that give way
        arrays.ensure(features);
    }

    @Override
    public void makeRoom(Commands changes) {
        settle();
        if (home.slots + changes.added() > arrays.slotCapacity()) {
            stats.keep();
        }
        start(features(changes));
        commands.makeRoom(changes, home.slots);
    }

    private static Features features(Commands changes) {
        Features features = Features.NONE;
        for (int r = 0; r < changes.count(); r++) {
            int operation = changes.operation(r);
            features = features.and(Features.TURNING.when(Commands.turns(operation)));
            if (operation == Commands.FIELD) {
                CircleField field = CircleField.OF_STEPS.get(changes.first(r));
                features = features.and(field.features());
            }
        }
        return features;
    }

    @Override
    public void apply(Commands changes) {
        if (changes.isEmpty()) {
            return;
        }
        settle();
        queue.stir();
        for (int r = 0; r < changes.count(); r++) {
            int operation = changes.operation(r);
            home.circles += operation == Commands.ADD ? 1 : operation == Commands.REMOVE ? -1 : 0;
        }
        home.slots = commands.apply(changes, home.slots, home.circles, arena, sleeps ? rigids : null);
    }

    @Override
    public void step(StepInput input, GridLevels shape, int count) {
        if (home.circles == 0) {
            settle();
            home.slots = 0;
            commands.slotsInOrder();
            if (input.constants.rigid) {
                arena = input.constants.arena;
                sleeps = input.constants.sleeping;
                stepBodiesAlone(input, count);
            }
            return;
        }
        prepareSteps(input.reports);
        if (hostBodies != null) {
            settle(); // steps without bodies
            hostBodies.use(input, rigids);
        }
        if (queue.isQuiet() && reader == null && continues(input, shape) && stages.bodiesAreIdle()) {
            return;
        }
        if (!queue.canContinue() || !continues(input, shape) || ready.haveNews()) {
            settle();
            if (ready.haveNews()) {
                ready.takeNews();
                bind(kernels);
            }
            arena = input.constants.arena;
            sleeps = input.constants.sleeping;
            queue.begin(shape, input.constants);
            parameters.set(input, shape);
            arrays.ensureBuckets(shape.groups(home.circles));
            parameters.ensureRoom(arrays);
            if (reader != null) {
                reader.prepare(input.reports, stages, queue.status());
            }
        }
        if (input.constants.rigid) {
            queue.stir();
        }
        queue.add(count);
        if (input.constants.rigid) {
            settle(); // calls change bodies at once
        }
        if (reader != null && !reader.isActive()) {
            reader.publishSilent(queue.enqueued());
        }
    }

    private void stepBodiesAlone(StepInput input, int count) {
        hostBodies.use(input, rigids);
        for (int step = 0; step < count; step++) {
            hostBodies.stepAlone(step == 0 ? input.constants.warmScale : 1f, input.constants.subSteps);
        }
    }

    /** Whether the pending batch can take these steps, which saves a round trip. */
    private boolean continues(StepInput input, GridLevels shape) {
        return input.constants.warmScale == 1f
                && parameters.areOf(input, shape)
                && (reader == null || reader.areOf(input.reports));
    }

    private void settle() {
        queue.settle();
    }

    /** The plans that steps may go to by now. */
    List<Plan> readyPlans() {
        return ready.list();
    }

    @Override
    public void readCircles(HandleTable handles, float[] to) {
        settle();
        readback.circles(handles, home.slots, to);
    }

    @Override
    public FloatBuffer positions(HandleTable handles, boolean byId) {
        settle();
        return readback.positions(handles, byId, home.slots);
    }

    @Override
    public void requestPositions(HandleTable handles) {
        requested.request(handles, queue.slotsBehindPending(), queue.enqueued());
    }

    @Override
    public boolean positionsArrived() {
        return requested.arrived();
    }

    @Override
    public FloatBuffer takePositions(IdMask shown) {
        if (!requested.arrived()) {
            // A step before the request had been refused. Now it is made, and the positions are laid out behind it.
            settle();
            requested.arrived();
        }
        return requested.take(shown);
    }

    @Override
    public void readVelocities(HandleTable handles, float[] to) {
        settle();
        readback.velocities(handles, home.slots, to);
    }

    @Override
    public void readAngles(HandleTable handles, int[] to) {
        settle();
        readback.angles(handles, home.slots, to);
    }

    @Override
    public void readAngularVelocities(HandleTable handles, float[] to) {
        settle();
        readback.angularVelocities(handles, home.slots, to);
    }

    @Override
    public int awake(int circles) {
        return queue.awake(circles);
    }

    @Override
    public boolean isAsleep(int id) {
        settle();
        return arrays.features().sleeping() && readback.isAsleep(id);
    }

    @Override
    public void readAsleep(long[] byId) {
        if (arrays.features().sleeping()) {
            settle();
            readback.asleep(byId);
        }
    }

    @Override
    public void report(ContactEvents events) {
        settle();
        ReportReader next = events == null ? null : new ReportReader(session, events, arrays, queue.seen());
        if (reader != null && stages != null && stages.reporting() != null) {
            load(tuned, loaded.edges(), null);
        }
        if (reader != null) {
            reader.close();
        }
        reader = next;
        queue.use(stages, reader);
    }

    @Override
    public void finishEvents() {
        if (reader != null && reader.isActive()) {
            settle();
        }
    }

    @Override
    public void requestEvents() {
        if (reader == null) {
            return;
        }
        if (reader.hasRequest() && !reader.finishRequest()) {
            settle();
        }
        reader.request(queue.enqueued());
    }

    @Override
    public void finishRequestedEvents() {
        if (reader == null || !reader.hasRequest() || !reader.finishRequest()) {
            settle();
        }
    }

    @Override
    public void finish() {
        settle();
    }

    @Override
    public void confine(Bounds from, Bounds to, Bounds calm) {
        settle();
        queue.stir();
        commands.confine(from, to, calm, home.slots);
        arena = to;
    }

    @Override
    public long hash() {
        settle();
        return copy().hash();
    }

    @Override
    public void saveIds(SavedState into) {
        settle();
        into.setCircles(home.circles);
        int k = 0;
        for (int id : Readback.ints(arrays.get(DeviceArray.HOME_ID), home.slots)) {
            if (id >= 0) {
                into.id[k++] = id;
            }
        }
        if (arrays.features().terrain()) {
            Arrays.sort(into.id, 0, k);
        }
    }

    @Override
    public void save(SavedState into) {
        settle();
        copy().save(into);
    }

    private StateTransfer copy() {
        StateTransfer transfer = memoryOfSave.get();
        if (transfer == null) {
            transfer = new StateTransfer(arrays);
            memoryOfSave = new SoftReference<>(transfer);
        }
        return transfer.copy(home.slots, home.cachedContacts, sleeps);
    }

    @Override
    public void savePieceContacts(SavedPieceContacts into) {
        into.clear();
        if (arrays.features().terrain()) {
            settle();
            new PieceTransfer(arrays, home.slots).save(into);
        }
    }

    @Override
    public void saveJoints(SavedJointStates into) {
        settle();
        joints.save(into);
        if (hostBodies != null) {
            hostBodies.saveJoints(into);
        }
    }

    @Override
    public void takeBroken(BrokenJoints into) {
        settle();
        joints.takeBroken(into, queue.status(), queue.seen());
        if (hostBodies != null) {
            hostBodies.takeBroken(into);
        }
    }

    @Override
    public void makeRoom(SavedState from) {
        settle();
        int contacts = Math.max(from.impulses, from.pieceContacts.count);
        if (from.circles > arrays.slotCapacity() || contacts > arrays.contactCapacity()) {
            stats.keep();
        }
        start(Features.TURNING.when(from.turns));
        arrays.ensureSlots(from.circles, home.slots);
        arrays.ensureIds(from.ids);
        arrays.ensureContacts(contacts);
        joints.makeRoom(from.jointStates);
        if (hostBodies != null) {
            hostBodies.makeRoomForJoints(from.jointStates.joints);
        }
        links = links();
        links.ensure(from, arrays);
    }

    private StateTransfer.Links links() {
        StateTransfer.Links held = memoryOfLoad.get();
        if (held == null) {
            held = new StateTransfer.Links();
            memoryOfLoad = new SoftReference<>(held);
        }
        return held;
    }

    @Override
    public void load(SavedState from) {
        settle();
        queue.load();
        StateTransfer.load(from, arrays, links);
        links = null;
        joints.load(from.jointStates, queue.status(), queue.seen());
        if (hostBodies != null) {
            hostBodies.loadJoints(from.jointStates);
        }
        sleeps = from.sleeps;
        if (from.parameters() != null) {
            sleeps = from.parameters().sleeps();
            arena = from.parameters().bounds();
        }
        home.slots = from.circles;
        commands.slotsInOrder();
        home.circles = from.circles;
        home.cachedContacts = from.impulses;
        stats.loaded();
    }

    @Override
    public void leave() {
        settle();
        requested.arrived();
        if (reader != null) {
            reader.close();
            reader = null;
            queue.use(stages, null);
        }
    }

    /** Tables of the host are told apart by versions, which those of another world have, too. */
    @Override
    public void forget() {
        settle();
        parameters.forget();
        session.forgetProfile();
        session.watch(failure -> {});
    }

    @Override
    public RemoteSearch search() {
        return search;
    }

    @Override
    public long candidatePairs() {
        settle();
        return stats.candidatePairs();
    }

    @Override
    public int contacts() {
        settle();
        return stats.contacts();
    }

    @Override
    public int greatestContacts() {
        settle();
        return stats.greatestContacts();
    }

    @Override
    public long bytesHeld() {
        return session.allocatedBytes() + (hostBodies == null ? 0 : hostBodies.bytes());
    }

    @Override
    public Map<String, Double> stageMillis() {
        Map<String, Double> millis = new TreeMap<>();
        kernelNanos().forEach((kernel, nanos) -> millis.merge(stageOf(kernel), nanos * 1e-6, Double::sum));
        return millis;
    }

    /** Time on the device by kernel; empty unless profiling. */
    Map<String, Long> kernelNanos() {
        settle();
        return session.profileNanos();
    }

    private static String stageOf(String kernel) {
        String prefix = kernel.substring(0, kernel.indexOf('_'));
        return Character.toUpperCase(prefix.charAt(0)) + prefix.substring(1);
    }

    @Override
    public String device() {
        return session.device().toString();
    }

    @Override
    public void watch(Consumer<Throwable> whom) {
        session.watch(whom);
    }

    @Override
    public void close() {
        ready.close();
        session.close();
        if (hostBodies != null) {
            hostBodies.close();
        }
    }
}
