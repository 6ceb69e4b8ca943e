package io.github.circles2d.world;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.Session;
import java.nio.IntBuffer;
import java.util.Map;
import java.util.TreeMap;

/**
 * The World engine on an OpenCL device. Steps are enqueued and not waited for; the next call that needs their result looks
 * at their status first. A step that found more contacts than there was room for has changed nothing, nor have those behind
 * it: the buffers are enlarged then, and the steps that are missing enqueued again.
 */
public final class ClPipeline implements Pipeline {
    private static final int CONTACTS_NEEDED = 1;
    private static final int STEPS_DONE = 2;
    private static final int TILE_PEAK = 3;

    /** After so many steps the host looks at their status before it goes on, so that the queue stays short. */
    private static final int MOST_PENDING = 64;

    private final Session session;
    private final boolean profiling;
    private final ClBuffers buffers;
    private final ClKernels kernels;
    private final ClParameters parameters = new ClParameters();
    private final ClCommands commands;
    private final ClGrid grid;
    private final ClContacts contacts;
    private final ClSolver solver;
    private final ClTiles tiles;
    private final ClPlan plan;

    /** Null where the plan is another. */
    private final ClResident resident;

    private final ClReadback readback;
    private final ClStats stats;
    private final int[] status = new int[ClBuffers.STATUS_INTS];
    private final IntBuffer statusView = IntBuffer.wrap(status);

    private int slots;
    private int circles;

    /** The steps that have been enqueued and not been looked at. */
    private int pendingSteps;

    private final Levels levels = new Levels();
    private int subSteps;
    private float warmScale;

    /**
     * An empty world.
     *
     * @param device what to run on
     * @param capacity number of circles to make room for
     * @param profiling whether to measure the time of each stage
     */
    public ClPipeline(Device device, int capacity, boolean profiling) {
        this(device, capacity, profiling, ClPlan.choose(device));
    }

    ClPipeline(Device device, int capacity, boolean profiling, ClPlan plan) {
        this.profiling = profiling;
        this.plan = plan;
        session = Session.open(device, profiling);
        try {
            buffers = new ClBuffers(session, capacity);
            kernels = new ClKernels(session, plan == ClPlan.RESIDENT);
            commands = new ClCommands(session, kernels, buffers);
            ClScan scan = new ClScan(kernels);
            grid = new ClGrid(kernels, buffers, scan);
            contacts = new ClContacts(kernels, buffers, scan);
            solver = new ClSolver(kernels);
            tiles = new ClTiles(kernels, buffers, scan, device);
            resident = plan == ClPlan.RESIDENT ? new ClResident(kernels, device) : null;
            readback = new ClReadback(session, kernels, buffers);
            stats = new ClStats(kernels, buffers);
            resetStatus();
        } catch (RuntimeException e) {
            session.close();
            throw e;
        }
    }

    @Override
    public void apply(Commands changes) {
        settle();
        if (changes.count() == 0) {
            return;
        }
        slots = commands.apply(changes, slots);
        for (int r = 0; r < changes.count(); r++) {
            int operation = changes.records()[r * Commands.STRIDE];
            circles += operation == Commands.ADD ? 1 : operation == Commands.REMOVE ? -1 : 0;
        }
    }

    @Override
    public void step(StepConstants constants, Levels shape, int steps) {
        settle();
        if (circles == 0) {
            slots = 0;
            return;
        }
        // Copies: the caller may change both before these steps are known to have found room.
        levels.copy(shape);
        subSteps = constants.subSteps;
        warmScale = constants.warmScale;
        parameters.set(constants, shape);
        buffers.ensureBuckets(levels.buckets());
        for (int left = steps; left > 0; left -= pendingSteps) {
            settle();
            pendingSteps = Math.min(left, MOST_PENDING);
            enqueue();
        }
    }

    private void enqueue() {
        boolean small = resident != null && ClResident.suits(circles);
        int atOnce = small ? ClResident.mostGroups(session.device()) : 0;
        boolean tiled = plan != ClPlan.COLOURS && tiles.choose(levels, parameters, atOnce);
        if (tiled && small) {
            parameters.setWarmScale(warmScale);
            parameters.send(buffers);
            kernels.bind(buffers, slots, circles);
            resident.run(tiles.tiles(), circles, pendingSteps);
            return;
        }
        int from = slots;
        for (int step = 0; step < pendingSteps; step++) {
            // From the second step on, the length of the step before is that of the step.
            parameters.setWarmScale(step == 0 ? warmScale : 1f);
            parameters.send(buffers);
            kernels.bind(buffers, from, circles);
            grid.build(levels, from, circles);
            if (tiled) {
                tiles.list(levels, circles);
                tiles.solve(circles, subSteps);
            } else {
                contacts.list(levels, circles);
                solver.solve(levels, circles, subSteps);
            }
            from = circles;
        }
    }

    /** Sees to it that the steps asked for have been made. */
    private void settle() {
        while (pendingSteps > 0) {
            buffers.get(ClBuffers.STATUS).read(statusView);
            int done = status[STEPS_DONE];
            if (done > 0) {
                slots = circles;
                warmScale = 1f;
            }
            pendingSteps -= done;
            tiles.learn(status[TILE_PEAK]);
            resetStatus();
            if (pendingSteps > 0) {
                buffers.ensureContacts(status[CONTACTS_NEEDED]);
                enqueue();
            }
        }
    }

    private void resetStatus() {
        buffers.get(ClBuffers.STATUS).write(0, IntBuffer.wrap(new int[ClBuffers.STATUS_INTS]));
    }

    @Override
    public void readCircles(Roster roster, float[] to) {
        settle();
        readback.circles(roster, slots, to);
    }

    @Override
    public void readVelocities(Roster roster, float[] to) {
        settle();
        readback.velocities(roster, slots, to);
    }

    @Override
    public void confine(Bounds bounds) {
        settle();
        commands.confine(bounds, slots);
    }

    @Override
    public long hash() {
        settle();
        return new ClState(buffers, slots).hash();
    }

    @Override
    public long candidatePairs() {
        settle();
        return stats.candidatePairs(levels, circles);
    }

    @Override
    public int contacts() {
        settle();
        return stats.contacts(levels);
    }

    @Override
    public int greatestContacts() {
        settle();
        return stats.greatestContacts(levels, circles);
    }

    @Override
    public long bytesHeld() {
        return session.allocatedBytes();
    }

    @Override
    public Map<String, Double> stageMillis() {
        if (!profiling) {
            return Map.of();
        }
        Map<String, Double> millis = new TreeMap<>();
        session.profileNanos().forEach((kernel, nanos) -> millis.merge(stageOf(kernel), nanos * 1e-6, Double::sum));
        return millis;
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
    public void close() {
        session.close();
    }
}
