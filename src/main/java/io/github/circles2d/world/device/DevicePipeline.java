package io.github.circles2d.world.device;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.DeviceMemoryException;
import io.github.circles2d.opencl.KernelSource;
import io.github.circles2d.opencl.OpenClException;
import io.github.circles2d.opencl.Session;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.circles.IdMask;
import io.github.circles2d.world.circles.SavedState;
import io.github.circles2d.world.device.memory.DeviceArrays;
import io.github.circles2d.world.device.memory.EventArrays;
import io.github.circles2d.world.device.memory.StageKernels;
import io.github.circles2d.world.device.memory.Status;
import io.github.circles2d.world.device.memory.StatusWord;
import io.github.circles2d.world.device.memory.StepParameters;
import io.github.circles2d.world.device.plan.Plan;
import io.github.circles2d.world.device.plan.Plans;
import io.github.circles2d.world.device.plan.Stages;
import io.github.circles2d.world.device.plan.Steps;
import io.github.circles2d.world.device.plan.TileUse;
import io.github.circles2d.world.device.queries.DeviceSearch;
import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.ContactSettings;
import io.github.circles2d.world.model.GridLevels;
import io.github.circles2d.world.model.StepInput;
import io.github.circles2d.world.queries.RemoteSearch;
import io.github.circles2d.world.shared.Pipeline;
import java.nio.FloatBuffer;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * The World engine on an OpenCL device. It enqueues steps and does not wait for them; the next call that needs their result looks
 * at their status first. Steps are enqueued for the common case: there is room for the contacts, no circle is fast, and no circle
 * stands in a crowd. A step that meets another case is refused: it changes nothing, and neither do the steps behind it. The host
 * then enlarges the arrays, or enqueues the missing steps with what the case needs.
 */
public final class DevicePipeline implements Pipeline {
    /** After so many steps the host looks at their status before it goes on, so that the queue stays short. */
    private static final int MOST_PENDING = 64;

    /** After so many batches of steps without a fast circle, or a crowd, steps are made without heed of them again. */
    private static final int CALM = 16;

    /** Contacts a circle for which room is made, before it is tried whether crowds can be thinned out. */
    private static final int ROOM_PER_CIRCLE = 24;

    private static final int LEAST_ROOM = 4096;

    private final Session session;
    private final DeviceArrays arrays;
    private final StageKernels kernels;
    private final StepParameters parameters = new StepParameters();
    private final int workGroupSize;
    private final CommandsStage commands;

    /** The kernels that have been compiled, by the special cases that they are for. */
    private final Map<String, StageKernels> variants = new HashMap<>();

    /** By the same keys: what the plans share with these kernels. */
    private final Map<String, Stages> stagesOf = new HashMap<>();

    /** What the plans share, with the kernels of one variant. */
    private Stages stages;

    /** What is reported of steps; null if nobody is told. */
    private ReportReader reader;

    /** The first of them that suits a step makes it. */
    private final List<Plan> plans;

    private final Readback readback;
    private final RequestedPositions requested;
    private final DeviceSearch search;
    private final StepStatistics stats;
    private final Status status = new Status();

    private int slots;
    private int circles;

    /** What the next load needs; null except between making room for it and loading. */
    private StateTransfer.Links links;

    /** What makes the steps that were enqueued last; null before the first. */
    private Plan plan;

    /** Contacts of the last step, which cached impulses are numbered by. */
    private int cachedContacts;

    /** Whether the plans have been compiled for contacts of any settings. */
    private boolean tuned;

    /** Whether the plans have been compiled for axes without walls. */
    private boolean isEdged;

    /** The steps that have been enqueued and not been looked at. */
    private int pendingSteps;

    /** Steps written home when it was looked last. */
    private int stepsSeen;

    /** For how many more batches steps heed fast circles; 0 where they do not. */
    private int sweeping;

    /** For how many more batches steps thin crowds out; 0 where they do not. */
    private int thinning;

    private final GridLevels levels = new GridLevels();
    private int subSteps;
    private float warmScale;

    /**
     * An empty world.
     *
     * @param device what to run on
     * @param capacity number of circles to make room for
     * @param profiling whether to measure the time of each stage
     */
    public DevicePipeline(Device device, int capacity, boolean profiling) {
        this(device, capacity, profiling, Plans.choose(device).of(device), StageKernels.USUAL_GROUPS);
    }

    DevicePipeline(Device device, int capacity, boolean profiling, List<Plan> plans, int workGroupSize) {
        this.plans = plans;
        this.workGroupSize = workGroupSize;
        session = Session.open(device, profiling);
        try {
            arrays = new DeviceArrays(session, capacity, plans.stream().anyMatch(Plan::usesTileArrays));
            stats = new StepStatistics(arrays);
            kernels = compile(false, false, false, false);
            variants.put("", kernels);
            commands = new CommandsStage(session, kernels, arrays);
            load(false, false, null);
            readback = new Readback(session, kernels, arrays);
            requested = new RequestedPositions(session, kernels, arrays);
            search = new DeviceSearch(session, arrays, () -> slots, () -> circles);
            status.write(arrays);
        } catch (RuntimeException | Error e) {
            session.close();
            throw e;
        }
    }

    /**
     * Identifies the kernels of this version.
     *
     * @return a fingerprint of their source
     */
    public static String kernels() {
        return Plans.source(Plans.all()).fingerprint();
    }

    /** Lets the plans use kernels for contacts of any settings, for axes without walls, and for steps that report, or others. */
    private void load(boolean anySettings, boolean edges, ReportReader ofReports) {
        boolean reporting = ofReports != null && ofReports.isActive();
        boolean recording = reporting && ofReports.isRecording();
        String variant = (anySettings ? "tuned " : "")
                + (edges ? "edges " : "")
                + (recording ? "recording" : reporting ? "reporting" : "");
        StageKernels loaded =
                variants.computeIfAbsent(variant, key -> compile(anySettings, edges, reporting, recording));
        stages = stagesOf.computeIfAbsent(variant, key -> new Stages(session.device(), loaded, arrays, parameters));
        stages.report(recording ? ofReports.touches() : null, reporting ? ofReports.deciding() : null);
        stats.use(loaded);
        plans.forEach(each -> each.load(stages));
        loaded.bind(arrays, slotsBehindPending(), circles); // counts of the last step may be asked for before the next
    }

    /** Loads other kernels for steps that report something else. It compiles at the first report: that takes long, and few worlds report. */
    private void loadForReports() {
        boolean active = reader != null && reader.isActive();
        EventArrays wanted = active ? reader.deciding() : null;
        boolean recordingNow = stages.touches() != null;
        if (stages.reporting() != wanted || (active && reader.isRecording() != recordingNow)) {
            load(tuned, isEdged, reader);
        }
    }

    private StageKernels compile(boolean anySettings, boolean edges, boolean reporting, boolean recording) {
        KernelSource source = Plans.source(plans, session.device());
        source = anySettings ? source.define("TUNED", 1) : source;
        source = edges ? source.define("EDGES", 1) : source;
        return new StageKernels(session, source, workGroupSize, reporting, recording);
    }

    /** Compiles the plans anew if contacts, or the edges, need what the kernels have as constants, which is rare. */
    @Override
    public void prepare(ContactSettings contacts, boolean edges) {
        boolean tunes = tuned || contacts.areTuned();
        boolean edged = isEdged || edges;
        if (tunes != tuned || edged != isEdged) {
            settle();
            load(tunes, edged, reader);
            tuned = tunes;
            isEdged = edged;
        }
    }

    @Override
    public void makeRoom(Commands changes) {
        settle();
        if (slots + changes.added() > arrays.slotCapacity()) {
            stats.keep();
        }
        commands.makeRoom(changes, slots);
    }

    @Override
    public void apply(Commands changes) {
        if (changes.count() == 0) {
            return;
        }
        settle();
        for (int r = 0; r < changes.count(); r++) {
            int operation = changes.operation(r);
            circles += operation == Commands.ADD ? 1 : operation == Commands.REMOVE ? -1 : 0;
        }
        slots = commands.apply(changes, slots, circles);
    }

    @Override
    public void step(StepInput input, GridLevels shape, int steps) {
        if (circles == 0) {
            settle();
            slots = 0;
            commands.slotsInOrder();
            return;
        }
        if (pendingSteps == 0 || !continues(input, shape)) {
            settle();
            // Copies: the caller may change both before these steps are known to have found room.
            levels.copy(shape);
            subSteps = input.constants.subSteps;
            warmScale = input.constants.warmScale;
            parameters.set(input, shape);
            if (reader != null) {
                reader.learn(input.reports);
            }
            loadForReports();
            arrays.ensureBuckets(levels.groups(circles));
            if (reader != null) {
                reader.prepare(input.reports, stages, status);
            }
        }
        for (int left = steps; left > 0; ) {
            if (pendingSteps == MOST_PENDING) {
                settle();
            }
            int count = Math.min(left, MOST_PENDING - pendingSteps);
            enqueue(count);
            left -= count;
        }
        if (reader != null && !reader.isActive()) {
            reader.publishSilent(stepsSeen + pendingSteps);
        }
    }

    /** Whether steps are as those that are pending: then they need not wait for these, which takes a round trip. */
    private boolean continues(StepInput input, GridLevels shape) {
        return warmScale == 1f
                && input.constants.warmScale == 1f
                && parameters.areOf(input, shape)
                && (reader == null || reader.areOf(input.reports));
    }

    private int slotsBehindPending() {
        return pendingSteps == 0 ? slots : circles;
    }

    private void enqueue(int steps) {
        for (int left = steps; left > 0; ) {
            left -= enqueueAtOnce(left);
        }
    }

    /** Enqueues steps that need nothing in between; returns how many of those wanted. */
    private int enqueueAtOnce(int most) {
        boolean reports = reader != null && reader.isActive();
        Steps wanted = steps(most, reports);
        plan = Plans.first(plans, wanted);
        if (!reports) {
            pendingSteps += most;
            plan.enqueue(wanted);
            return most;
        }
        Steps enqueued = plan.decidesEvents(wanted) ? wanted : steps(1, true);
        reader.before(stages, plan, enqueued, stepsSeen + pendingSteps);
        pendingSteps += enqueued.count();
        plan.enqueue(enqueued);
        reader.behind(stages, plan, enqueued);
        return enqueued.count();
    }

    private Steps steps(int count, boolean reports) {
        return new Steps(
                count,
                levels,
                slotsBehindPending(),
                circles,
                subSteps,
                // Behind pending steps the state is as a step leaves it, and the length of the step before is that of
                // the step.
                pendingSteps == 0 ? warmScale : 1f,
                sweeping > 0,
                thinning > 0,
                reports && reader.isRecording(),
                reports && reader.isSensing());
    }

    /** Sees to it that the steps asked for have been made. */
    private void settle() {
        while (pendingSteps > 0) {
            status.read(arrays);
            int done = status.get(StatusWord.STEPS_DONE) - stepsSeen;
            stepsSeen += done;
            if (done > 0) {
                slots = circles;
                commands.slotsInOrder();
                warmScale = 1f;
                if (reader != null) {
                    reader.made(status, stepsSeen, stages, plan, circles);
                }
            }
            if (reader != null) {
                reader.beginBatch();
            }
            pendingSteps -= done;
            for (Plan each : plans) {
                each.learn(TileUse.of(status), thinning > 0);
            }
            if (pendingSteps == 0) {
                cachedContacts = status.get(StatusWord.CONTACTS);
                stats.stepped(plan, circles, cachedContacts);
                sweeping = status.has(StatusWord.FAST) && sweeping > 0 ? CALM : Math.max(0, sweeping - 1);
                thinning = status.has(StatusWord.CROWDED) ? CALM : Math.max(0, thinning - 1);
            } else {
                adapt();
                int refused = pendingSteps;
                pendingSteps = 0;
                int beforeRequest = requested.missing(stepsSeen);
                if (beforeRequest > 0) {
                    enqueue(beforeRequest);
                    requested.layOut(circles);
                }
                if (refused > beforeRequest) {
                    enqueue(refused - beforeRequest);
                }
            }
        }
    }

    /** Sees to it that the step that has been refused can be made. */
    private void adapt() {
        int contacts = status.get(StatusWord.CONTACTS);
        if (sweeping == 0 && status.has(StatusWord.FAST)) {
            sweeping = CALM;
        }
        if (thinning == 0 && status.has(StatusWord.CROWDED)) {
            thinning = CALM; // the room that the step asked for is for all pairs of the crowd
        } else if (status.has(StatusWord.OUT_OF_ROOM) && contacts > arrays.contactCapacity()) {
            if (thinning == 0 && contacts > LEAST_ROOM + (long) ROOM_PER_CIRCLE * circles) {
                thinning = CALM;
            } else {
                arrays.ensureContacts(contacts);
            }
        }
        if (status.has(StatusWord.OUT_OF_ROOM) && !arrays.ensureCopies(status.get(StatusWord.TILE_COPIES))) {
            // Steps without tiles need no copies.
            for (Plan each : plans) {
                each.learn(TileUse.NONE_DO, thinning > 0);
            }
        }
        status.clear(
                StatusWord.TILE_COPIES,
                StatusWord.OUT_OF_ROOM,
                StatusWord.FAST,
                StatusWord.CROWDED,
                StatusWord.TILE_PEAK);
        status.write(arrays);
    }

    @Override
    public void readCircles(HandleTable handles, float[] to) {
        settle();
        readback.circles(handles, slots, to);
    }

    @Override
    public FloatBuffer positions(HandleTable handles, boolean byId) {
        settle();
        return readback.positions(handles, byId, slots);
    }

    @Override
    public void requestPositions(HandleTable handles) {
        requested.request(handles, slotsBehindPending(), stepsSeen + pendingSteps);
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
        readback.velocities(handles, slots, to);
    }

    @Override
    public void report(ContactEvents events) {
        settle();
        ReportReader next = events == null ? null : new ReportReader(session, events, arrays, stepsSeen);
        if (stages.reporting() != null) {
            load(tuned, isEdged, null);
        }
        if (reader != null) {
            reader.close();
        }
        reader = next;
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
        reader.request(stepsSeen + pendingSteps);
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
    public void confine(Bounds from, Bounds to) {
        settle();
        commands.confine(from, to, slots);
    }

    @Override
    public long hash() {
        settle();
        return new StateTransfer(arrays, slots, cachedContacts).hash();
    }

    @Override
    public void save(SavedState into) {
        settle();
        new StateTransfer(arrays, slots, cachedContacts).save(into);
    }

    @Override
    public void makeRoom(SavedState from) {
        settle();
        if (from.circles > arrays.slotCapacity() || from.impulses > arrays.contactCapacity()) {
            stats.keep();
        }
        arrays.ensureSlots(from.circles, slots);
        arrays.ensureIds(from.ids);
        arrays.ensureContacts(from.impulses);
        links = new StateTransfer.Links(from, arrays);
    }

    @Override
    public void load(SavedState from) {
        settle();
        StateTransfer.load(from, arrays, links);
        links = null;
        slots = from.circles;
        commands.slotsInOrder();
        circles = from.circles;
        cachedContacts = from.impulses;
        stats.loaded();
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
        return session.allocatedBytes();
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
    public boolean isLostBy(Throwable cause) {
        return cause instanceof OpenClException && !(cause instanceof DeviceMemoryException);
    }

    @Override
    public void close() {
        session.close();
    }
}
