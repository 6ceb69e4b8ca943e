package io.github.circles2d;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.DeviceMemoryException;
import io.github.circles2d.opencl.KernelSource;
import io.github.circles2d.opencl.OpenCl;
import io.github.circles2d.opencl.OpenClException;
import io.github.circles2d.opencl.OpenClUnavailableException;
import io.github.circles2d.opencl.Program;
import io.github.circles2d.opencl.Session;
import io.github.circles2d.thesis.CircleList;
import io.github.circles2d.thesis.ComputedPairs;
import io.github.circles2d.thesis.ExactPairs;
import io.github.circles2d.thesis.LookupTablePairs;
import io.github.circles2d.thesis.MemoryNeed;
import io.github.circles2d.thesis.PairSlots;
import io.github.circles2d.thesis.PairStrategy;
import io.github.circles2d.thesis.Parameters;
import io.github.circles2d.thesis.RowSearchPairs;
import io.github.circles2d.thesis.ThesisSimulation;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.System.Logger.Level;
import java.util.Map;
import java.util.Objects;

/**
 * The engine of S. Young, "Memory Organization and Buffer Construction for GPGPU for 2D Physics" (honours thesis, Memorial
 * University of Newfoundland, 2014): n rigid, non-rotating circles in the unit square under gravity, simulated on an
 * OpenCL device. Every unordered pair is tested in every step, so a step costs O(n&sup2;) and n is at most {@value
 * #MAX_CIRCLES}. It is there for study, teaching and benchmarks.
 *
 * <p>A step moves every circle and reflects it at the walls, finds the minimum translation vector of every overlapping
 * pair, and then parts each such pair and exchanges its impulse. The behaviour of the thesis is kept, with its consequences.
 * Pairs that share a circle are resolved in a race, so results differ from run to run in a crowd. A bounce off one wall
 * scales both components of the velocity. Impulses act on separating pairs too. Three things are not kept. A slot that
 * strategy 0 maps wrongly is skipped, so it touches no memory outside the buffers. A pair with coincident centres,
 * which has no direction to part in, gets no minimum translation vector in that step. And no n overflows an int.
 *
 * <p>Use: add circles, {@link #init}, then call {@link #loop} once a frame. Positions and radii are in widths of the arena,
 * times in seconds, masses in any one unit. Within the ranges that the methods name, all values stay finite for 1,000 steps
 * and more. The methods may be called from any thread; they run one at a time. After {@link #close} every other method
 * throws {@link IllegalStateException}.
 */
public final class Circles2D implements AutoCloseable {
    /** The greatest number of circles: the largest whose slots an int can number. */
    public static final int MAX_CIRCLES = PairSlots.MAX_CIRCLES;

    private static final System.Logger LOG = System.getLogger(Circles2D.class.getName());

    /** As in the thesis. The ranges of the input keep all numbers in the kernels finite. */
    private static final String BUILD_OPTION = "-cl-finite-math-only";

    private final Session session;
    private final CircleList circles = new CircleList();
    private PairIndexing indexing;
    private ThesisSimulation simulation;
    private boolean closed;

    /**
     * Creates an engine without circles.
     *
     * @param gpu true for the best device, which is a GPU if there is one; false for a CPU device
     * @throws OpenClUnavailableException if there is no such device; the message says what is missing and what to install
     */
    public Circles2D(boolean gpu) {
        this(gpu ? OpenCl.bestDevice() : OpenCl.cpuDevice());
    }

    /**
     * Creates an engine without circles.
     *
     * @param device the device to run on
     * @throws OpenClException if the driver refuses
     */
    public Circles2D(Device device) {
        this(device, false);
    }

    /**
     * Creates an engine without circles.
     *
     * @param device the device to run on
     * @param profiling whether to measure the device time of every kernel; costs an event a kernel
     * @throws OpenClException if the driver refuses
     * @see #profileNanos
     */
    public Circles2D(Device device, boolean profiling) {
        session = Session.open(device, profiling);
    }

    /**
     * Adds a circle at rest, which takes part from the next {@link #init} on.
     *
     * @param x horizontal position of the centre, from -1e6 to 1e6
     * @param y vertical position of the centre, upwards, from -1e6 to 1e6
     * @param r radius, from 1e-6 to 1e6
     * @param mass from 1e-6 to 1e6
     * @throws IllegalArgumentException if one of them is out of its range; nothing is added then
     */
    public void addCircle(float x, float y, float r, float mass) throws IllegalArgumentException {
        addCircle(x, y, r, mass, 0, 0);
    }

    /**
     * Adds a moving circle, which takes part from the next {@link #init} on.
     *
     * @param x horizontal position of the centre, from -1e6 to 1e6
     * @param y vertical position of the centre, upwards, from -1e6 to 1e6
     * @param r radius, from 1e-6 to 1e6
     * @param mass from 1e-6 to 1e6
     * @param vx horizontal velocity in arena widths a second, from -1e6 to 1e6
     * @param vy vertical velocity in arena widths a second, from -1e6 to 1e6
     * @throws IllegalArgumentException if one of them is out of its range; nothing is added then
     */
    public synchronized void addCircle(float x, float y, float r, float mass, float vx, float vy) {
        requireOpen();
        circles.add(x, y, r, mass, vx, vy);
    }

    /** Forgets all circles that were added. A simulation that was initialised goes on with its own until the next init. */
    public synchronized void clear() {
        requireOpen();
        circles.clear();
    }

    /**
     * Prepares the simulation by the thesis's number for the pair indexing.
     *
     * @param timeStep seconds a step, from 1e-6 to 1
     * @param strategy 0 computed, 1 look-up table, 2 row search, 3 exact
     * @param restitution share of the speed that an impact leaves, for circles and walls alike: 0 inelastic to 1 elastic
     * @param gravity acceleration (x, y) in arena widths per second squared, two values from -1e4 to 1e4
     * @throws IOException if the kernel sources cannot be read
     * @throws IllegalArgumentException if an argument is out of its range
     * @throws DeviceMemoryException if the circles do not fit
     * @throws OpenClException if the driver refuses
     * @see #init(float, PairIndexing, float, float[])
     */
    public void init(float timeStep, int strategy, float restitution, float[] gravity) throws IOException {
        init(timeStep, PairIndexing.ofStrategy(strategy), restitution, gravity);
    }

    /**
     * Prepares the simulation: builds the buffers, compiles the kernels, and starts all circles where and as fast as they
     * were added. It may be called again, also with other circles, and then releases what the last call built.
     *
     * <p>With an argument out of range, too many circles, or kernels that cannot be read or compiled, the engine stays as it
     * was. If the driver fails later, in making the buffers, the engine is left without a simulation, as before the first
     * init.
     *
     * @param timeStep seconds a step, from 1e-6 to 1
     * @param indexing how a slot finds its pair; {@link PairIndexing#AUTO} is chosen here, before the first step
     * @param restitution share of the speed that an impact leaves, for circles and walls alike: 0 inelastic to 1 elastic
     * @param gravity acceleration (x, y) in arena widths per second squared, two values from -1e4 to 1e4
     * @throws IOException if the kernel sources cannot be read
     * @throws IllegalArgumentException if an argument is out of its range
     * @throws DeviceMemoryException if the circles do not fit; the message says how many bytes they need, how many the device
     *     has, and how many circles would fit
     * @throws OpenClException if the driver refuses
     */
    public synchronized void init(float timeStep, PairIndexing indexing, float restitution, float[] gravity)
            throws IOException {
        requireOpen();
        Objects.requireNonNull(indexing, "indexing");
        Parameters parameters = Parameters.of(timeStep, restitution, gravity);
        long held = simulation == null ? 0 : simulation.deviceBytes();
        long free = session.freeBytes() + held;
        PairIndexing chosen = indexing == PairIndexing.AUTO ? choose(free) : indexing;
        PairStrategy strategy = strategyOf(chosen);
        MemoryNeed.of(strategy, circles.size()).requireRoom(session.device(), free);
        Program program = session.build(source(strategy), BUILD_OPTION);
        release();
        // The simulation's kernels outlive the program that made them.
        try (program) {
            simulation = ThesisSimulation.start(session, program, strategy, circles, parameters);
        }
        this.indexing = chosen;
        warnOfWrongSlots();
    }

    /**
     * Computes one step and reads the circles back.
     *
     * @return a new array of four rows of n values: x, y, radius, mass, in the order in which the circles were added
     * @throws IllegalStateException before the first init
     * @throws OpenClException if the driver fails
     */
    public synchronized float[][] loop() {
        ThesisSimulation running = running();
        running.step();
        return running.circles();
    }

    /**
     * Enqueues one step and neither waits for it nor reads anything back.
     *
     * @throws IllegalStateException before the first init
     * @throws OpenClException if the driver refuses
     */
    public synchronized void step() {
        running().step();
    }

    /**
     * Waits until the device has done all steps.
     *
     * @throws OpenClException if one of them failed
     */
    public synchronized void finish() {
        requireOpen();
        session.finish();
    }

    /**
     * Reads the velocities after the last step.
     *
     * @return a new array of two rows of n values: vx, vy, in the order in which the circles were added
     * @throws IllegalStateException before the first init
     * @throws OpenClException if the driver fails
     */
    public synchronized float[][] velocities() {
        return running().velocities();
    }

    /**
     * Waits for the device and returns how long it has worked on each kernel since this engine was created.
     *
     * @return nanoseconds by name of the kernel; empty unless the engine was created for profiling
     * @throws OpenClException if a step failed
     */
    public synchronized Map<String, Long> profileNanos() {
        requireOpen();
        return session.profileNanos();
    }

    /**
     * Returns the number of circles that were added: those that the next init takes.
     *
     * @return 0 or more
     */
    public synchronized int size() {
        requireOpen();
        return circles.size();
    }

    /**
     * Returns how slots find their pairs.
     *
     * @return the indexing of the last init; never {@link PairIndexing#AUTO}, but the one that AUTO has taken
     * @throws IllegalStateException before the first init
     */
    public synchronized PairIndexing indexing() {
        running();
        return indexing;
    }

    /**
     * Returns the device that the engine runs on.
     *
     * @return its description
     */
    public synchronized Device device() {
        requireOpen();
        return session.device();
    }

    /**
     * Returns how many slots the indexing in use maps wrongly for this number of circles on this device. {@link #init}
     * counts them there, and logs a warning if there are any.
     *
     * @return the number of pairs that can never collide; 0 for all indexings but {@link PairIndexing#COMPUTED}
     * @throws IllegalStateException before the first init
     */
    public synchronized long wrongSlots() {
        return running().wrongSlots();
    }

    /** Waits for the device and releases everything. Later calls do nothing. */
    @Override
    public synchronized void close() {
        if (!closed) {
            closed = true;
            simulation = null;
            session.close();
        }
    }

    private KernelSource source(PairStrategy strategy) throws IOException {
        try {
            return ThesisSimulation.source(strategy, circles.size(), session.device());
        } catch (UncheckedIOException e) {
            throw e.getCause();
        } catch (IllegalArgumentException e) {
            throw new IOException(e.getMessage(), e);
        }
    }

    private PairIndexing choose(long freeBytes) {
        Device device = session.device();
        IndexingChoice choice = IndexingChoice.of(
                device, circles.size(), indexing -> MemoryNeed.of(strategyOf(indexing), circles.size())
                        .fits(device, freeBytes));
        LOG.log(
                Level.DEBUG,
                "Circles2D with pair indexing {0} on {1}: {2}",
                choice.indexing(),
                device.name(),
                choice.reason());
        return choice.indexing();
    }

    /** Identifies the kernels of an indexing. */
    static String kernels(PairIndexing indexing, Device device) {
        return ThesisSimulation.source(strategyOf(indexing), 1000, device).fingerprint();
    }

    private static PairStrategy strategyOf(PairIndexing indexing) {
        switch (indexing) {
            case COMPUTED:
                return new ComputedPairs();
            case LOOKUP_TABLE:
                return new LookupTablePairs();
            case ROW_SEARCH:
                return new RowSearchPairs();
            case EXACT:
                return new ExactPairs();
            default:
                throw new AssertionError(indexing);
        }
    }

    private void warnOfWrongSlots() {
        long wrong = simulation.wrongSlots();
        if (wrong != 0) {
            LOG.log(
                    Level.WARNING,
                    "pair indexing {0} maps {1} of {2} slots wrongly for {3} circles on {4}: those pairs cannot collide",
                    indexing,
                    wrong,
                    PairSlots.count(circles.size()),
                    circles.size(),
                    session.device().name());
        }
    }

    private void release() {
        if (simulation != null) {
            ThesisSimulation old = simulation;
            simulation = null;
            try {
                // The device holds on to buffers until the steps that use them have ended.
                session.finish();
            } finally {
                old.close();
            }
        }
    }

    private ThesisSimulation running() {
        requireOpen();
        if (simulation == null) {
            throw new IllegalStateException("there is no simulation yet: call init first");
        }
        return simulation;
    }

    private void requireOpen() {
        if (closed) {
            throw new IllegalStateException("this Circles2D is closed");
        }
    }
}
