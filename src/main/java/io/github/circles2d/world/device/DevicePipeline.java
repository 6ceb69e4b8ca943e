package io.github.circles2d.world.device;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.DeviceMemoryException;
import io.github.circles2d.opencl.OpenClException;
import io.github.circles2d.opencl.Session;
import io.github.circles2d.world.Pipeline;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.circles.SavedState;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.GridLevels;
import io.github.circles2d.world.model.StepConstants;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.Map;
import java.util.TreeMap;

/**
 * The World engine on an OpenCL device. Steps are enqueued and not waited for; the next call that needs their result looks
 * at their status first. They are enqueued for the case that is common: there is room for the contacts, no circle is fast,
 * none stands in a crowd. A step that meets another case is refused: it changes nothing, nor do those behind it. The host then
 * enlarges the buffers, or enqueues the missing steps with what the case needs.
 */
public final class DevicePipeline implements Pipeline {
    // Ints of the status, as in World.cl.
    private static final int OUT_OF_ROOM = 0;
    private static final int CONTACTS = 1;
    private static final int STEPS_DONE = 2;
    private static final int FAST = 3;
    private static final int CROWDED = 4;
    private static final int TILE_PEAK = 5;
    private static final int TILE_COPIES = 7;
    private static final int PLACES = 9;
    private static final int APART = 8;

    /** After so many steps the host looks at their status before it goes on, so that the queue stays short. */
    private static final int MOST_PENDING = 64;

    /** After so many batches of steps without a fast circle, or a crowd, steps are made without heed of them again. */
    private static final int CALM = 16;

    /** Contacts a circle for which room is made, before it is tried whether crowds can be thinned out. */
    private static final int ROOM_PER_CIRCLE = 24;

    private static final int LEAST_ROOM = 4096;

    private final Session session;
    private final DeviceArrays buffers;
    private final StageKernels kernels;
    private final StepParameters parameters = new StepParameters();
    private final CommandsStage commands;
    private final GridStage grid;
    private final ContinuousCollisionStage sweep;
    private final ContactsStage contacts;
    private final SolverStage solver;
    private final Tiles tiles;
    private final Plan plan;

    /** Null where the plan is another. */
    private final PersistentGpu resident;

    /** Null where the plan is another. */
    private final PersistentCpu lanes;

    private final Readback readback;
    private final RequestedPositions requested;
    private final StepStatistics stats;
    private final int[] status = new int[DeviceArrays.STATUS_INTS];
    private final IntBuffer statusView = IntBuffer.wrap(status);

    private int slots;
    private int circles;

    /** What the next load needs; null except between making room for it and loading. */
    private StateTransfer.Links links;

    /** What the steps that were enqueued last are made by; null where they are made in another way. */
    private PersistentCpu lanesEnqueued;

    /** Whether the steps that were enqueued last are made by tiles. */
    private boolean tiled;

    /** Places of contacts in the last step, which remembered impulses are numbered by. */
    private int remembered;

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
        this(device, capacity, profiling, Plan.choose(device));
    }

    DevicePipeline(Device device, int capacity, boolean profiling, Plan plan) {
        this.plan = plan;
        session = Session.open(device, profiling);
        try {
            buffers = new DeviceArrays(session, capacity, plan == Plan.TILES || plan == Plan.RESIDENT);
            kernels = new StageKernels(session, plan);
            commands = new CommandsStage(session, kernels, buffers);
            Scan scan = new Scan(kernels);
            grid = new GridStage(kernels, buffers, scan);
            sweep = new ContinuousCollisionStage(kernels);
            contacts = new ContactsStage(kernels, buffers, scan);
            solver = new SolverStage(kernels);
            tiles = new Tiles(kernels, buffers, scan, device);
            resident = plan == Plan.RESIDENT ? new PersistentGpu(kernels, device) : null;
            lanes = plan == Plan.LANES ? new PersistentCpu(kernels, device) : null;
            readback = new Readback(session, kernels, buffers);
            requested = new RequestedPositions(session, kernels, buffers);
            stats = new StepStatistics(kernels, buffers);
            buffers.get(DeviceArrays.STATUS).write(0, statusView);
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
        return StageKernels.source(true, true).fingerprint();
    }

    /** Sets the size of work-groups, which has no effect on results. */
    DevicePipeline workGroupSize(int size) {
        kernels.workGroupSize(size);
        return this;
    }

    /** What makes steps by lanes; null where the plan is another. */
    PersistentCpu lanes() {
        return lanes;
    }

    @Override
    public void makeRoom(Commands changes) {
        settle();
        if (slots + changes.added() > buffers.slotRoom()) {
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
            int operation = changes.records()[r * Commands.STRIDE];
            circles += operation == Commands.ADD ? 1 : operation == Commands.REMOVE ? -1 : 0;
        }
        slots = commands.apply(changes, slots);
    }

    @Override
    public void step(StepConstants constants, GridLevels shape, int steps) {
        if (circles == 0) {
            settle();
            slots = 0;
            commands.slotsInOrder();
            return;
        }
        if (pendingSteps == 0 || !continues(constants, shape)) {
            settle();
            // Copies: the caller may change both before these steps are known to have found room.
            levels.copy(shape);
            subSteps = constants.subSteps;
            warmScale = constants.warmScale;
            parameters.set(constants, shape);
            buffers.ensureBuckets(levels.buckets());
        }
        for (int left = steps; left > 0; ) {
            if (pendingSteps == MOST_PENDING) {
                settle();
            }
            int count = Math.min(left, MOST_PENDING - pendingSteps);
            enqueue(count);
            left -= count;
        }
    }

    /** Whether steps are as those that are pending: then they need not wait for these, which takes a round trip. */
    private boolean continues(StepConstants constants, GridLevels shape) {
        return warmScale == 1f && constants.warmScale == 1f && parameters.areOf(constants, shape);
    }

    private int slotsBehindPending() {
        return pendingSteps == 0 ? slots : circles;
    }

    private void enqueue(int steps) {
        // Behind pending steps the state is as a step leaves it, and the length of the step before is that of the step.
        int from = slotsBehindPending();
        float warm = pendingSteps == 0 ? warmScale : 1f;
        pendingSteps += steps;
        lanesEnqueued = lanes != null && thinning == 0 && PersistentCpu.suits(levels) ? lanes : null;
        boolean small = resident != null && thinning == 0 && PersistentGpu.suits(circles);
        int atOnce = small ? resident.mostGroups() : 0;
        tiled = plan != Plan.COLOURS && lanes == null && tiles.choose(levels, parameters, atOnce, thinning > 0);
        parameters.setPlan(sweeping > 0, thinning > 0, tiled);
        if (lanesEnqueued != null) {
            parameters.setWarmScale(warm);
            parameters.send(buffers);
            kernels.bind(buffers, from, circles);
            lanes.run(levels, circles, steps);
            return;
        }
        if (tiled && small) {
            parameters.setWarmScale(warm);
            parameters.send(buffers);
            kernels.bind(buffers, from, circles);
            resident.run(tiles.tiles(), circles, steps);
            return;
        }
        for (int step = 0; step < steps; step++) {
            parameters.setWarmScale(step == 0 ? warm : 1f);
            parameters.send(buffers);
            kernels.bind(buffers, from, circles);
            grid.build(levels, from, circles);
            if (sweeping > 0) {
                sweep.sweep(levels, circles);
            }
            if (tiled) {
                tiles.list(levels, circles, thinning > 0);
                tiles.solve(circles, subSteps);
            } else {
                contacts.list(levels, circles, thinning > 0);
                solver.solve(levels, circles, subSteps);
            }
            from = circles;
        }
    }

    /** Sees to it that the steps asked for have been made. */
    private void settle() {
        while (pendingSteps > 0) {
            buffers.get(DeviceArrays.STATUS).read(statusView);
            int done = status[STEPS_DONE] - stepsSeen;
            stepsSeen = status[STEPS_DONE];
            if (done > 0) {
                slots = circles;
                commands.slotsInOrder();
                warmScale = 1f;
            }
            pendingSteps -= done;
            tiles.learn(status[TILE_PEAK], thinning > 0);
            if (pendingSteps == 0) {
                remembered = Math.max(status[CONTACTS], status[PLACES]);
                stats.stepped(circles, status[CONTACTS], tiled, lanesEnqueued);
                sweeping = status[FAST] != 0 && sweeping > 0 ? CALM : Math.max(0, sweeping - 1);
                thinning = status[CROWDED] != 0 ? CALM : Math.max(0, thinning - 1);
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
        if (sweeping == 0 && status[FAST] != 0) {
            sweeping = CALM;
        }
        if (status[OUT_OF_ROOM] != 0 && status[CONTACTS] > buffers.contactRoom()) {
            // Lanes ask for room by the fullest band, which is no sign of a crowd; they tell of crowds by themselves.
            if (thinning == 0
                    && lanesEnqueued == null
                    && status[CONTACTS] > LEAST_ROOM + (long) ROOM_PER_CIRCLE * circles) {
                thinning = CALM;
            } else {
                buffers.ensureContacts(status[CONTACTS]);
            }
        }
        if (status[OUT_OF_ROOM] != 0) {
            buffers.ensureCopies(status[TILE_COPIES]);
        }
        if (thinning == 0 && status[CROWDED] != 0) {
            thinning = CALM;
        }
        status[TILE_COPIES] = 0;
        if (status[APART] != 0) {
            lanes.calledOff();
        }
        status[APART] = 0;
        status[OUT_OF_ROOM] = 0;
        status[FAST] = 0;
        status[CROWDED] = 0;
        status[TILE_PEAK] = 0;
        // All of it, as it was read: Oclgrind takes the rest of a buffer that is written in part for uninitialised.
        buffers.get(DeviceArrays.STATUS).write(0, statusView);
    }

    @Override
    public void readCircles(HandleTable roster, float[] to) {
        settle();
        readback.circles(roster, slots, to);
    }

    @Override
    public FloatBuffer positions(HandleTable roster) {
        settle();
        return readback.positions(roster, slots);
    }

    @Override
    public void requestPositions(HandleTable roster) {
        requested.request(roster, slotsBehindPending(), stepsSeen + pendingSteps);
    }

    @Override
    public boolean positionsArrived() {
        return requested.arrived();
    }

    @Override
    public FloatBuffer takePositions() {
        if (!requested.arrived()) {
            // A step before the request had been refused. Now it is made, and the positions are laid out behind it.
            settle();
            requested.arrived();
        }
        return requested.take();
    }

    @Override
    public void readVelocities(HandleTable roster, float[] to) {
        settle();
        readback.velocities(roster, slots, to);
    }

    @Override
    public void finish() {
        settle();
    }

    @Override
    public void confine(Bounds bounds) {
        settle();
        commands.confine(bounds, slots);
    }

    @Override
    public long hash() {
        settle();
        return new StateTransfer(buffers, slots, remembered).hash();
    }

    @Override
    public void save(SavedState into) {
        settle();
        new StateTransfer(buffers, slots, remembered).save(into);
    }

    @Override
    public void makeRoom(SavedState from) {
        settle();
        if (from.circles > buffers.slotRoom() || from.impulses > buffers.contactRoom()) {
            stats.keep();
        }
        buffers.ensureSlots(from.circles, slots);
        buffers.ensureIds(from.ids);
        buffers.ensureContacts(from.impulses);
        links = new StateTransfer.Links(from, buffers);
    }

    @Override
    public void load(SavedState from) {
        settle();
        StateTransfer.load(from, buffers, links);
        links = null;
        slots = from.circles;
        commands.slotsInOrder();
        circles = from.circles;
        remembered = from.impulses;
        stats.stepped(0, 0, false, null);
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
