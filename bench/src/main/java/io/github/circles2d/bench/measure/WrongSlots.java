package io.github.circles2d.bench.measure;

import io.github.circles2d.Circles2D;
import io.github.circles2d.PairIndexing;
import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.DeviceBuffer;
import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.opencl.KernelSource;
import io.github.circles2d.opencl.Program;
import io.github.circles2d.opencl.Session;
import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import java.io.IOException;
import java.nio.IntBuffer;

/**
 * Counts wrong slots of the computed indexing by the kernel with which Circles2D counts them, but for many n in a row, and
 * for those whose collision buffer would not fit.
 */
final class WrongSlots implements AutoCloseable {
    private final Device device;
    private final Session session;
    private final DeviceBuffer number;
    private final Kernel kernel;
    private final IntBuffer value = IntBuffer.allocate(1);

    WrongSlots(Device device) {
        this.device = device;
        session = Session.open(device);
        number = session.allocate("number of wrong slots", Integer.BYTES);
        Program program =
                session.build(KernelSource.of("CirclePhysV2.cl", "thesis/WrongSlots.cl"), "-cl-finite-math-only");
        kernel = program.kernel("count_wrong_slots");
    }

    /** The wrong slots of n circles. */
    long count(int n) {
        int slots = Math.toIntExact(n * (n - 1L) / 2);
        number.write(0, value.put(0, 0));
        kernel.arg(0, number).arg(1, slots).arg(2, n).run(slots);
        number.read(value);
        return value.get(0);
    }

    /** What the engine itself says. */
    long countOfEngine(int n) throws IOException {
        Scene scene = Scenes.packed(n, Scenes.SEED);
        try (Circles2D engine = new Circles2D(device)) {
            for (int i = 0; i < n; i++) {
                engine.addCircle(scene.x(i), scene.y(i), scene.radius(i), scene.mass(i));
            }
            engine.init(scene.timeStep(), PairIndexing.COMPUTED, scene.restitution(), new float[] {0, 0});
            return engine.wrongSlots();
        }
    }

    @Override
    public void close() {
        session.close();
    }
}
