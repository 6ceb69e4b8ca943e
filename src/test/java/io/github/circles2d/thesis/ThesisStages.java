package io.github.circles2d.thesis;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.DeviceBuffer;
import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.opencl.KernelSource;
import io.github.circles2d.opencl.Program;
import io.github.circles2d.opencl.Session;
import java.nio.FloatBuffer;
import java.util.Arrays;
import java.util.List;

/** The three kernels of a strategy, run one by one on state that the test can set and see. */
final class ThesisStages implements AutoCloseable {
    private final Session session;
    /** Fewer than most scenes have slots, so that each work-item has several; and not a divisor of their number. */
    private static final int FEW = 256;

    private final int slots;
    private final int slotItems;
    private final DeviceBuffer circle;
    private final DeviceBuffer velocities;
    private final DeviceBuffer collision;
    private final PairStrategy strategy;
    private final Kernel update;
    private final Kernel detect;
    private final Kernel resolve;
    private final Kernel rows;

    /** Every strategy, freshly made: an object serves one simulation. */
    static List<PairStrategy> strategies() {
        return List.of(new ComputedPairs(), new LookupTablePairs(), new RowSearchPairs(), new ExactPairs());
    }

    /** The kernels as they are compiled for the device's kind. */
    ThesisStages(Device device, PairStrategy strategy, TestScene scene, float h, float e, float gx, float gy) {
        this(device, strategy, device.kind() == Device.Kind.GPU, scene, h, e, gx, gy);
    }

    /** The kernels with few work-items, each for several slots, or with one a slot. */
    ThesisStages(
            Device device,
            PairStrategy strategy,
            boolean fewWorkItems,
            TestScene scene,
            float h,
            float e,
            float gx,
            float gy) {
        session = Session.open(device);
        this.strategy = strategy;
        int n = scene.size();
        slots = (int) PairSlots.count(n);
        circle = session.allocate("circle", MemoryNeed.bodyBytes(n));
        velocities = session.allocate("velocities", MemoryNeed.velocityBytes(n));
        collision = session.allocate("collision", MemoryNeed.collisionBytes(n));
        DeviceBuffer gravity = session.allocate("gravity", MemoryNeed.GRAVITY_BYTES);
        gravity.write(FloatBuffer.wrap(new float[] {gx, gy}));
        strategy.open(session, n);
        slotItems = fewWorkItems ? Math.min(slots, FEW) : slots;
        KernelSource source = strategy.source(n).and(ThesisSimulation.ROWS_KERNEL);
        Program program =
                session.build(fewWorkItems ? source.define("FEW_WORK_ITEMS", true) : source, "-cl-finite-math-only");
        PairStrategy.State state = new PairStrategy.State(n, circle, velocities, collision);
        update = program.kernel("update_position")
                .arg(0, circle)
                .arg(1, velocities)
                .arg(2, gravity)
                .arg(3, n)
                .arg(4, h)
                .arg(5, e);
        detect = strategy.detect(program, state);
        resolve = strategy.resolve(program, state, e);
        rows = program.kernel("rows_of_circles").arg(0, circle).arg(2, n);
        set(scene.x, scene.y, scene.radius, scene.mass, scene.vx, scene.vy);
        // Rubbish, which the detect kernels must clear away.
        float[] rubbish = new float[2 * slots];
        Arrays.fill(rubbish, 0.25f);
        collision.write(FloatBuffer.wrap(rubbish));
    }

    /** Puts the circles where the oracle has them. */
    void setStateOf(ThesisOracle oracle) {
        set(oracle.x, oracle.y, oracle.radius, oracle.mass, oracle.vx, oracle.vy);
    }

    void setCollisionsOf(ThesisOracle oracle) {
        collision.write(FloatBuffer.wrap(interleave(oracle.mtvX, oracle.mtvY)));
    }

    private void set(float[] x, float[] y, float[] r, float[] m, float[] vx, float[] vy) {
        circle.write(FloatBuffer.wrap(interleave(x, y, r, m)));
        velocities.write(FloatBuffer.wrap(interleave(vx, vy)));
    }

    void update() {
        update.run(circle.bytes() / 16);
    }

    void detect() {
        detect.run(slotItems);
    }

    void resolve() {
        resolve.run(slotItems);
    }

    /** Returns x, y, radius, mass. */
    float[][] circles() {
        return read(circle, 4);
    }

    /** Returns x, y, radius and mass as the kernel puts them in rows. */
    float[] rows() {
        int n = (int) (circle.bytes() / MemoryNeed.bodyBytes(1));
        float[] result = new float[CircleList.BODY * n];
        try (DeviceBuffer target = session.allocate("rows", circle.bytes())) {
            rows.arg(1, target).run(n);
            target.read(FloatBuffer.wrap(result));
        }
        return result;
    }

    /** Returns vx, vy. */
    float[][] velocities() {
        return read(velocities, 2);
    }

    /** Returns the x and the y of every slot. */
    float[][] collisions() {
        return read(collision, 2);
    }

    @Override
    public void close() {
        strategy.close();
        session.close();
    }

    private static float[] interleave(float[]... rows) {
        float[] all = new float[rows.length * rows[0].length];
        for (int i = 0; i < rows[0].length; i++) {
            for (int k = 0; k < rows.length; k++) {
                all[rows.length * i + k] = rows[k][i];
            }
        }
        return all;
    }

    private static float[][] read(DeviceBuffer buffer, int width) {
        float[] all = new float[(int) (buffer.bytes() / Float.BYTES)];
        buffer.read(FloatBuffer.wrap(all));
        float[][] rows = new float[width][all.length / width];
        for (int i = 0; i < all.length; i++) {
            rows[i % width][i / width] = all[i];
        }
        return rows;
    }
}
