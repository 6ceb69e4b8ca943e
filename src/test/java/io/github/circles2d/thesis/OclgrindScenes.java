package io.github.circles2d.thesis;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.DeviceBuffer;
import io.github.circles2d.opencl.HostBuffer;
import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.opencl.KernelSource;
import io.github.circles2d.opencl.OpenCl;
import io.github.circles2d.opencl.Program;
import io.github.circles2d.opencl.Session;
import java.nio.IntBuffer;

/** Runs kernels in a JVM whose OpenCL driver is Oclgrind; what it finds goes to standard error, not to the exit status. */
final class OclgrindScenes {
    private OclgrindScenes() {}

    public static void main(String[] args) {
        Device device = OpenCl.devices().get(0);
        if (!device.platform().contains("Oclgrind")) {
            throw new IllegalStateException("not Oclgrind but " + device);
        }
        switch (args[0]) {
            case "pairs":
                // 98 circles: the last work-group of every kernel is not full.
                runEveryStrategy(device, TestScene.isolatedPairs(7, 3));
                updateAtTheWalls(device);
                probeIndexings(device);
                break;
            case "crowd":
                runEveryStrategy(device, TestScene.crowd(60, 0.08f, 3));
                break;
            case "wrong slots":
                runWrongSlots(device);
                break;
            case "control":
                writePastTheEnd(device);
                break;
            default:
                throw new IllegalArgumentException(args[0]);
        }
        System.out.println("done");
    }

    private static void runEveryStrategy(Device device, TestScene scene) {
        for (boolean fewWorkItems : new boolean[] {false, true}) {
            for (PairStrategy strategy : ThesisStages.strategies()) {
                try (ThesisStages stages =
                        new ThesisStages(device, strategy, fewWorkItems, scene, 1 / 60f, 0.5f, 0, -0.01f)) {
                    for (int k = 0; k < 2; k++) {
                        stages.update();
                        stages.detect();
                        stages.resolve();
                    }
                    stages.circles();
                    stages.rows();
                }
            }
        }
    }

    private static void updateAtTheWalls(Device device) {
        TestScene scene = TestScene.atTheWalls(300, 5);
        try (ThesisStages stages = new ThesisStages(device, new ExactPairs(), scene, 1 / 60f, 0.5f, 0, -0.01f)) {
            stages.update();
            stages.circles();
        }
    }

    private static void probeIndexings(Device device) {
        for (int n : new int[] {2, 3, 33}) {
            try (PairProbe probe = new PairProbe(device, n)) {
                probe.countWrong("computed", probe.noTable());
                probe.countWrong("exact", probe.noTable());
                probe.countWrong("rows", probe.rows());
                probe.countWrong("pairs", probe.lookupTable());
                probe.map("computed", probe.noTable());
                probe.mapSome("computed", probe.noTable(), new int[] {0});
                probe.map("exact", probe.noTable());
                probe.mapSome("exact", probe.noTable(), new int[] {0});
                probe.map("rows", probe.rows());
                probe.mapSome("rows", probe.rows(), new int[] {0});
                probe.map("pairs", probe.lookupTable());
                probe.mapSome("pairs", probe.lookupTable(), new int[] {0});
            }
        }
    }

    /**
     * Strategy 0 for so many circles that it maps some slots wrongly, on the first slots alone, which are enough to meet some
     * and few enough for Oclgrind. The circles all overlap, so that the resolve kernel has to look at every pair.
     */
    private static void runWrongSlots(Device device) {
        int circles = 15_000;
        int slots = 40_000;
        try (Session session = Session.open(device)) {
            DeviceBuffer circle = session.allocate("circle", MemoryNeed.bodyBytes(circles));
            DeviceBuffer velocities = session.allocate("velocities", MemoryNeed.velocityBytes(circles));
            DeviceBuffer collision = session.allocate("collision", MemoryNeed.SLOT_BYTES * slots);
            DeviceBuffer wrong = session.allocate("wrong", Integer.BYTES);
            TestScene crowd = TestScene.crowd(circles, 1, 3);
            CircleList list = crowd.circles();
            try (HostBuffer host = session.hostBuffer(circle.bytes())) {
                list.copyBodies(host.floats());
                circle.write(0, host, 0, circle.bytes());
                list.copyVelocities(host.floats());
                velocities.write(0, host, 0, velocities.bytes());
            }
            wrong.write(0, IntBuffer.allocate(1));
            Program program = session.build(new ComputedPairs().source(circles), "-cl-finite-math-only");
            program.kernel("count_wrong_slots")
                    .arg(0, wrong)
                    .arg(1, slots)
                    .arg(2, circles)
                    .run(slots);
            program.kernel("detect_collisions")
                    .arg(0, circle)
                    .arg(1, collision)
                    .arg(2, slots)
                    .arg(3, circles)
                    .run(slots);
            program.kernel("resolve_collisions")
                    .arg(0, circle)
                    .arg(1, collision)
                    .arg(2, velocities)
                    .arg(3, slots)
                    .arg(4, circles)
                    .arg(5, 0.5f)
                    .run(slots);
            IntBuffer count = IntBuffer.allocate(1);
            wrong.read(count);
            System.out.println("wrong slots " + count.get(0));
        }
    }

    /** Shows that something is reported at all. */
    private static void writePastTheEnd(Device device) {
        try (Session session = Session.open(device)) {
            KernelSource source = KernelSource.ofText(
                    "control", "__kernel void past_the_end(__global int *a) { a[get_global_id(0)] = 1; }");
            Kernel kernel = session.build(source).kernel("past_the_end");
            kernel.arg(0, session.allocate("a", 16)).run(5, 1);
            session.finish();
        }
    }
}
