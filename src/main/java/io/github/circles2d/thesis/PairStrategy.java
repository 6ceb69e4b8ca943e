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

    /** For the classes of this package alone. */
    PairStrategy() {}

    /**
     * Returns the source of the kernels.
     *
     * @param circles the number of circles that they will serve
     * @return the source
     */
    public abstract KernelSource source(int circles);

    /** Returns the size of the table for a number of circles. */
    long tableBytes(int circles) {
        return 0;
    }

    /** Makes and fills the table. */
    void open(Session session, int circles) {}

    /** Makes the kernel that finds the minimum translation vector of every pair, with its arguments. */
    abstract Kernel detect(Program program, State state);

    /** The arguments of {@link #detect}, of a kernel that needs no table. */
    static Kernel detectBySlot(Kernel kernel, State state) {
        return kernel.arg(0, state.circle)
                .arg(1, state.collision)
                .arg(2, state.slots)
                .arg(3, state.circles);
    }

    /** The arguments of {@link #resolve}, likewise. */
    static Kernel resolveBySlot(Kernel kernel, State state, float restitution) {
        return kernel.arg(0, state.circle)
                .arg(1, state.collision)
                .arg(2, state.velocities)
                .arg(3, state.slots)
                .arg(4, state.circles)
                .arg(5, restitution);
    }

    /** Makes the kernel that parts overlapping pairs and exchanges their impulses, with its arguments. */
    abstract Kernel resolve(Program program, State state, float restitution);

    /** Counts the slots that are mapped wrongly, on the device; may leave anything in the collision buffer. */
    long countWrongSlots(Session session, Program program, State state) {
        return 0;
    }

    /** Releases the table. */
    @Override
    public void close() {}

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
