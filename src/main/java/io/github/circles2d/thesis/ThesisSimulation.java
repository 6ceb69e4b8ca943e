package io.github.circles2d.thesis;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.DeviceBuffer;
import io.github.circles2d.opencl.HostBuffer;
import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.opencl.KernelSource;
import io.github.circles2d.opencl.Program;
import io.github.circles2d.opencl.Session;

/**
 * The buffers and the kernels of a running simulation. A step makes no garbage; a read makes the arrays that it
 * returns and nothing else.
 */
public final class ThesisSimulation implements AutoCloseable {
    private final Session session;
    private final PairStrategy strategy;
    private final int size;
    private final long slotItems;
    private final float[] interleaved;
    private DeviceBuffer circle;
    private DeviceBuffer velocities;
    private DeviceBuffer gravity;
    private DeviceBuffer collision;
    private HostBuffer transfer;
    private Kernel update;
    private Kernel detect;
    private Kernel resolve;
    /** On a GPU, where the circles can be put in rows before they are read; else null. */
    private Kernel rows;

    private long wrongSlots;

    /** The kernel that puts the circles in rows. */
    static final String ROWS_KERNEL = "thesis/CircleRows.cl";

    /** How many work-items a compute unit of a GPU runs at once, at most. */
    private static final int ITEMS_OF_A_UNIT = 2048;

    private ThesisSimulation(Session session, PairStrategy strategy, int size) {
        this.session = session;
        this.strategy = strategy;
        this.size = size;
        slotItems = slotItems(session.device(), PairSlots.count(size));
        interleaved = new float[CircleList.BODY * size];
    }

    /** What to compile for a strategy and a number of circles, with what suits the device defined. */
    public static KernelSource source(PairStrategy strategy, int size, Device device) {
        KernelSource source = strategy.source(size);
        return device.kind() == Device.Kind.GPU ? source.and(ROWS_KERNEL).define("FEW_WORK_ITEMS", true) : source;
    }

    /** Work-items for the slots: what {@link #source} has the kernels expect. */
    private static long slotItems(Device device, long slots) {
        return device.kind() == Device.Kind.GPU
                ? Math.min(slots, (long) device.computeUnits() * ITEMS_OF_A_UNIT)
                : slots;
    }

    /**
     * Builds a simulation, before its first step, of the compiled {@link #source}; whether it fits has been checked. It
     * closes the strategy.
     */
    public static ThesisSimulation start(
            Session session, Program program, PairStrategy strategy, CircleList circles, Parameters parameters) {
        ThesisSimulation simulation = new ThesisSimulation(session, strategy, circles.size());
        try {
            simulation.fillBuffers(circles, parameters);
            simulation.makeKernels(program, parameters);
            return simulation;
        } catch (RuntimeException | Error e) {
            simulation.close();
            throw e;
        }
    }

    private void fillBuffers(CircleList circles, Parameters parameters) {
        circle = session.allocate("circle", MemoryNeed.bodyBytes(size));
        velocities = session.allocate("velocities", MemoryNeed.velocityBytes(size));
        gravity = session.allocate("gravity", MemoryNeed.GRAVITY_BYTES);
        collision = session.allocate("collision", MemoryNeed.collisionBytes(size));
        strategy.open(session, size);
        transfer = session.hostBuffer(Math.max(MemoryNeed.GRAVITY_BYTES, circle.bytes()));

        transfer.floats().put(0, parameters.gravityX).put(1, parameters.gravityY);
        gravity.write(0, transfer, 0, gravity.bytes());
        circles.copyVelocities(transfer.floats());
        velocities.write(0, transfer, 0, velocities.bytes());
        circles.copyBodies(transfer.floats());
        circle.write(0, transfer, 0, circle.bytes());
    }

    private void makeKernels(Program program, Parameters parameters) {
        PairStrategy.State state = new PairStrategy.State(size, circle, velocities, collision);
        update = program.kernel("update_position")
                .arg(0, circle)
                .arg(1, velocities)
                .arg(2, gravity)
                .arg(3, size)
                .arg(4, parameters.timeStep)
                .arg(5, parameters.restitution);
        detect = strategy.detect(program, state);
        resolve = strategy.resolve(program, state, parameters.restitution);
        wrongSlots = strategy.countWrongSlots(session, program, state);
        // Between two steps the collision buffer is free: the rows go there, where it is large enough.
        if (session.device().kind() == Device.Kind.GPU && collision.bytes() >= circle.bytes()) {
            rows = program.kernel("rows_of_circles")
                    .arg(0, circle)
                    .arg(1, collision)
                    .arg(2, size);
        }
    }

    /** Enqueues a step: update, detect, resolve. */
    public void step() {
        update.run(size);
        detect.run(slotItems);
        resolve.run(slotItems);
    }

    /** New rows x, y, radius, mass. */
    public float[][] circles() {
        return rows == null ? circlesOutOfInterleaved() : circlesOutOfRows();
    }

    private float[][] circlesOutOfRows() {
        rows.run(size);
        collision.read(0, transfer, 0, circle.bytes());
        float[][] circles = new float[CircleList.BODY][size];
        for (int row = 0; row < CircleList.BODY; row++) {
            transfer.floats().get(row * size, circles[row]);
        }
        return circles;
    }

    /** Where the host is the device, another kernel costs more than this pass. */
    private float[][] circlesOutOfInterleaved() {
        circle.read(0, transfer, 0, circle.bytes());
        transfer.floats().get(0, interleaved, 0, CircleList.BODY * size);
        float[] x = new float[size];
        float[] y = new float[size];
        float[] radius = new float[size];
        float[] mass = new float[size];
        // One pass over the interleaved values: at n = 15,000 a pass a row took as long as the transfer.
        for (int i = 0, k = 0; i < size; i++, k += CircleList.BODY) {
            x[i] = interleaved[k];
            y[i] = interleaved[k + 1];
            radius[i] = interleaved[k + 2];
            mass[i] = interleaved[k + 3];
        }
        return new float[][] {x, y, radius, mass};
    }

    /** New rows vx, vy. */
    public float[][] velocities() {
        velocities.read(0, transfer, 0, velocities.bytes());
        transfer.floats().get(0, interleaved, 0, CircleList.VELOCITY * size);
        float[] vx = new float[size];
        float[] vy = new float[size];
        for (int i = 0; i < size; i++) {
            vx[i] = interleaved[CircleList.VELOCITY * i];
            vy[i] = interleaved[CircleList.VELOCITY * i + 1];
        }
        return new float[][] {vx, vy};
    }

    /** How many slots the strategy maps wrongly, counted at the start. */
    public long wrongSlots() {
        return wrongSlots;
    }

    /** The bytes of device memory that closing gives back. */
    public long deviceBytes() {
        return circle.bytes() + velocities.bytes() + gravity.bytes() + collision.bytes() + strategy.tableBytes(size);
    }

    /** Releases everything that was made, also of a simulation that was made in part. Later calls do nothing. */
    @Override
    public void close() {
        close(rows, resolve, detect, update, transfer, strategy, collision, gravity, velocities, circle);
    }

    private static void close(AutoCloseable... parts) {
        RuntimeException failure = null;
        for (AutoCloseable part : parts) {
            try {
                if (part != null) {
                    part.close();
                }
            } catch (Exception e) {
                if (failure == null) {
                    failure = new IllegalStateException("could not release a simulation", e);
                } else {
                    failure.addSuppressed(e);
                }
            }
        }
        if (failure != null) {
            throw failure;
        }
    }
}
