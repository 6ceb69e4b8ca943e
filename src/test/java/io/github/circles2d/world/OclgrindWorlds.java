package io.github.circles2d.world;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.DeviceBuffer;
import io.github.circles2d.opencl.OpenCl;
import io.github.circles2d.opencl.Session;
import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import java.nio.IntBuffer;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.TreeSet;

/**
 * Makes steps of small worlds in a JVM whose OpenCL driver is Oclgrind, which reports to standard error; prints the kernels
 * that have run.
 */
final class OclgrindWorlds {
    private OclgrindWorlds() {}

    public static void main(String[] args) {
        Device device = OpenCl.devices().get(0);
        if (!device.platform().contains("Oclgrind")) {
            throw new IllegalStateException("not Oclgrind but " + device);
        }
        Set<String> kernels = new TreeSet<>(scan(device));
        switch (args[0]) {
            case "COLOURS":
                kernels.addAll(changes(device, Scenes.mixed(40, 1)));
                break;
            case "TILES":
                kernels.addAll(steps(device, ClPlan.TILES, Scenes.thesis(60, 1), 1 / 60f, 2, 4));
                break;
            case "RESIDENT":
                // Two steps of a tile that stays in local memory; then one that is refused for fast circles at first.
                kernels.addAll(steps(device, ClPlan.RESIDENT, Scenes.thesis(60, 1), 1 / 60f, 2, 4));
                kernels.addAll(steps(device, ClPlan.RESIDENT, Scenes.gas(20, 1), 1f, 2, 2));
                break;
            case "LANES":
                kernels.addAll(steps(device, ClPlan.LANES, Scenes.thesis(60, 1), 1 / 60f, 2, 4));
                kernels.addAll(steps(device, ClPlan.LANES, Scenes.gas(20, 1), 1f, 2, 2));
                break;
            case "wide":
                // As few as have two blocks of buckets to sum up; eight tiles.
                kernels.addAll(steps(device, ClPlan.RESIDENT, Scenes.gas(1024, 1), 1e-4f, 1, 1));
                break;
            case "fast":
                kernels.addAll(steps(device, ClPlan.COLOURS, Scenes.gas(20, 1), 1f, 2, 4));
                break;
            case "crowd":
                // 780 pairs: more than there is room for at first.
                kernels.addAll(steps(device, ClPlan.TILES, Scenes.onePoint(40, 1), 1 / 60f, 1, 4));
                kernels.addAll(steps(device, ClPlan.RESIDENT, Scenes.onePoint(40, 1), 1 / 60f, 1, 4));
                break;
            default:
                throw new IllegalArgumentException(args[0]);
        }
        System.out.println("kernels " + String.join(" ", kernels));
        System.out.println("done");
    }

    private static Set<String> steps(Device device, ClPlan plan, Scene scene, float dt, int steps, int subSteps) {
        ClPipeline pipeline = new ClPipeline(device, 0, true, plan);
        try (Twins twins = Twins.load(scene, jvm(), pipeline)) {
            twins.subSteps(subSteps).step(dt, steps);
            twins.assertEqual(scene.name());
            twins.assertSameFigures();
            return pipeline.kernelNanos().keySet();
        }
    }

    private static Set<String> changes(Device device, Scene scene) {
        ClPipeline pipeline = new ClPipeline(device, 0, true, ClPlan.COLOURS);
        SplittableRandom random = new SplittableRandom(3);
        try (Twins twins = Twins.load(scene, jvm(), pipeline)) {
            for (int k = 0; k < 2; k++) {
                twins.step(scene.timeStep(), 1);
                twins.assertSameFigures();
                twins.change(scene, random);
                twins.exchange();
                twins.confine();
                twins.assertSameReadings();
                twins.assertEqual(scene.name());
            }
            return pipeline.kernelNanos().keySet();
        }
    }

    private static Pipeline jvm() {
        return new JvmPipeline(1, JvmPipeline.LEAST_SHARE, 0, false);
    }

    /** Sums up more counts than a small world has: a last block that is not full. */
    private static Set<String> scan(Device device) {
        int count = 2 * 2048 + 100;
        int[] counts = new int[count];
        java.util.Arrays.fill(counts, 3);
        try (Session session = Session.open(device, true)) {
            ClKernels kernels = new ClKernels(session, ClPlan.COLOURS);
            DeviceBuffer buffer = session.allocate("counts", 4L * count);
            buffer.write(0, IntBuffer.wrap(counts));
            DeviceBuffer starts = session.allocate("starts", 4L * count);
            new ClScan(kernels).run(buffer, count, session.allocate("sums", 4L * ClScan.blocks(count)), starts);
            int[] sums = new int[count];
            starts.read(IntBuffer.wrap(sums));
            buffer.read(IntBuffer.wrap(counts));
            for (int k = 0; k < count; k++) {
                if (sums[k] != 3 * k || counts[k] != 0) {
                    throw new IllegalStateException("the sum before " + k + " is " + sums[k] + ", left " + counts[k]);
                }
            }
            return session.profileNanos().keySet();
        }
    }
}
