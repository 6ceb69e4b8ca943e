package io.github.circles2d.thesis;

import io.github.circles2d.opencl.DeviceBuffer;
import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.opencl.KernelSource;
import io.github.circles2d.opencl.Program;
import io.github.circles2d.opencl.Session;

/**
 * One way for a work-item to find the pair of its slot: a table on the device, where it needs one, and the two kernels that
 * are built for it. An object serves one simulation.
 */
public abstract class PairStrategy implements AutoCloseable {
    /** The thesis's kernels, with the helpers that all others use. */
    static final String THESIS_KERNELS = "CirclePhysV2.cl";

    private final String detectKernel;
    private final String resolveKernel;

    /** Null if the strategy needs none, or has not been opened. */
    private DeviceBuffer table;

    /** For the classes of this package alone: names of the two kernels. */
    PairStrategy(String detectKernel, String resolveKernel) {
        this.detectKernel = detectKernel;
        this.resolveKernel = resolveKernel;
    }

    /** The source of the kernels that will serve a number of circles. */
    public abstract KernelSource source(int circles);

    /** Returns the size of the table for a number of circles. */
    long tableBytes(int circles) {
        return 0;
    }

    /** Makes and fills the table. */
    void open(Session session, int circles) {}

    /** Makes the table, which is closed with the strategy. */
    final DeviceBuffer makeTable(Session session, String name, int circles) {
        table = session.allocate(name, tableBytes(circles));
        return table;
    }

    /** Returns the table, once it is open. */
    final DeviceBuffer table() {
        return table;
    }

    /** Whether kernels take the number of circles. */
    boolean takesCircles() {
        return true;
    }

    /** Makes the kernel that finds the minimum translation vector of every pair, with its arguments. */
    Kernel detect(Program program, State state) {
        Kernel kernel = program.kernel(detectKernel).arg(0, state.circle).arg(1, state.collision);
        bindPairs(kernel, 2, state);
        return kernel;
    }

    /** Makes the kernel that parts overlapping pairs and exchanges their impulses, with its arguments. */
    Kernel resolve(Program program, State state, float restitution) {
        Kernel kernel = program.kernel(resolveKernel)
                .arg(0, state.circle)
                .arg(1, state.collision)
                .arg(2, state.velocities);
        return kernel.arg(bindPairs(kernel, 3, state), restitution);
    }

    /** Sets the arguments by which a kernel finds pairs, from one on. Returns the next. */
    private int bindPairs(Kernel kernel, int first, State state) {
        int next = first;
        if (table != null) {
            kernel.arg(next++, table);
        }
        kernel.arg(next++, state.slots);
        if (takesCircles()) {
            kernel.arg(next++, state.circles);
        }
        return next;
    }

    /** Counts the slots that are mapped wrongly, on the device; may leave anything in the collision buffer. */
    long countWrongSlots(Session session, Program program, State state) {
        return 0;
    }

    /** Releases the table. */
    @Override
    public void close() {
        if (table != null) {
            table.close();
        }
    }

    /** What the kernels work on. */
    static final class State {
        final int circles;
        final int slots;
        final DeviceBuffer circle;
        final DeviceBuffer velocities;
        final DeviceBuffer collision;

        State(int circles, DeviceBuffer circle, DeviceBuffer velocities, DeviceBuffer collision) {
            this.circles = circles;
            this.slots = Math.toIntExact(PairSlots.count(circles));
            this.circle = circle;
            this.velocities = velocities;
            this.collision = collision;
        }
    }
}
