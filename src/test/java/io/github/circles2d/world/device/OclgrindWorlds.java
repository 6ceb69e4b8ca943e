package io.github.circles2d.world.device;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.DeviceBuffer;
import io.github.circles2d.opencl.OpenCl;
import io.github.circles2d.opencl.Session;
import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import io.github.circles2d.world.Pipeline;
import io.github.circles2d.world.device.memory.Scan;
import io.github.circles2d.world.device.memory.StageKernels;
import io.github.circles2d.world.device.memory.WorldSource;
import io.github.circles2d.world.device.plan.Plans;
import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.jvm.JvmPipeline;
import io.github.circles2d.world.model.AxisEdge;
import java.nio.IntBuffer;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.TreeSet;

/**
 * Makes steps of a small world in a JVM whose OpenCL driver is Oclgrind, which reports to standard error; prints the kernels
 * that have run. Oclgrind interprets each work-item, also those past a kernel's count, so small work-groups are quick.
 * Arguments: the world, and its size, {@code small} or {@code large}.
 */
final class OclgrindWorlds {
    /** Work-items of a work-group in a world of size small, if its kernel leaves that open. */
    private static final int SMALL_GROUP = 8;

    private final Device device;
    private final boolean small;

    private OclgrindWorlds(Device device, boolean small) {
        this.device = device;
        this.small = small;
    }

    public static void main(String[] args) {
        Device device = OpenCl.devices().get(0);
        if (!device.platform().contains("Oclgrind")) {
            throw new IllegalStateException("not Oclgrind but " + device);
        }
        Set<String> kernels = new OclgrindWorlds(device, args[1].equals("small")).run(args[0]);
        System.out.println("kernels " + String.join(" ", kernels));
        System.out.println("done");
    }

    private Set<String> run(String world) {
        Set<String> kernels = new TreeSet<>();
        switch (world) {
            case "COLOURS":
                kernels.addAll(scan());
                kernels.addAll(changes(Scenes.mixed(small ? 20 : 40, 1)));
                kernels.addAll(events(Scenes.mixed(small ? 20 : 40, 2)));
                break;
            case "TILES":
                kernels.addAll(steps(Plans.TILES, Scenes.thesis(60, 1), 1 / 60f, 2, small ? 2 : 4));
                break;
            case "PERSISTENT_GPU":
                kernels.addAll(persistent(Plans.PERSISTENT_GPU));
                break;
            case "PERSISTENT_CPU":
                kernels.addAll(persistent(Plans.PERSISTENT_CPU));
                break;
            case "wide":
                // As few as have two blocks of buckets to sum up; eight tiles.
                kernels.addAll(steps(Plans.PERSISTENT_GPU, Scenes.gas(1024, 1), 1e-4f, 1, 1));
                break;
            case "fast":
                kernels.addAll(steps(Plans.COLOURS, Scenes.gas(20, 1), 1f, small ? 1 : 2, small ? 1 : 4));
                break;
            case "crowd":
                // 780 pairs: more than there is room for at first.
                kernels.addAll(steps(Plans.TILES, Scenes.onePoint(40, 1), 1 / 60f, 1, small ? 1 : 4));
                kernels.addAll(steps(Plans.PERSISTENT_GPU, Scenes.onePoint(40, 1), 1 / 60f, 1, small ? 1 : 4));
                break;
            case "edges":
                kernels.addAll(edges(Plans.COLOURS));
                kernels.addAll(edges(Plans.PERSISTENT_CPU));
                kernels.addAll(edges(Plans.PERSISTENT_GPU));
                break;
            default:
                throw new IllegalArgumentException(world);
        }
        return kernels;
    }

    /** Two steps of a tile that stays in local memory; then one that is refused for fast circles at first. */
    private Set<String> persistent(Plans plans) {
        Set<String> kernels = new TreeSet<>(steps(plans, Scenes.thesis(60, 1), 1 / 60f, 2, small ? 2 : 4));
        kernels.addAll(steps(plans, Scenes.gas(20, 1), 1f, small ? 1 : 2, small ? 1 : 2));
        return kernels;
    }

    private DevicePipeline pipeline(Plans plans) {
        int workGroupSize = small ? SMALL_GROUP : StageKernels.USUAL_GROUPS;
        return new DevicePipeline(device, 0, true, plans.of(device), workGroupSize);
    }

    private Set<String> steps(Plans plans, Scene scene, float dt, int steps, int subSteps) {
        DevicePipeline pipeline = pipeline(plans);
        try (Twins twins = Twins.load(scene, subSteps, jvm(), pipeline)) {
            // All of a crowd meet: it must stay one. Of a thousand circles Oclgrind 21.10 says that nobody has written
            // the kind of one,
            // which the host has: not understood. The other worlds have kinds on the same kernels.
            if (!scene.name().equals(Scenes.onePoint(1, 1).name()) && scene.size() < 1000) {
                twins.giveKinds();
            }
            twins.step(dt, steps);
            twins.assertEqual(scene.name());
            twins.assertSameFigures();
            return pipeline.kernelNanos().keySet();
        }
    }

    private Set<String> changes(Scene scene) {
        DevicePipeline pipeline = pipeline(Plans.COLOURS);
        SplittableRandom random = new SplittableRandom(3);
        try (Twins twins = Twins.load(scene, small ? 1 : 4, jvm(), pipeline)) {
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

    /** Fast circles in a world of which one axis wraps and the other is open. */
    private Set<String> edges(Plans plans) {
        Scene scene = Scenes.gas(20, 1);
        DevicePipeline pipeline = pipeline(plans);
        try (Twins twins = Twins.load(scene, small ? 1 : 4, jvm(), pipeline)) {
            twins.restoreWithEdges(AxisEdge.WRAP, AxisEdge.OPEN);
            twins.step(0.3f, 2);
            twins.assertEqual(scene.name());
            return pipeline.kernelNanos().keySet();
        }
    }

    /** Steps that record what contacts do. */
    private Set<String> events(Scene scene) {
        DevicePipeline pipeline = pipeline(Plans.COLOURS);
        try (Twins twins = Twins.load(scene, small ? 1 : 4, jvm(), pipeline)) {
            twins.report(ContactEvents.ALL);
            int events = 0;
            for (int k = 0; k < 3; k++) {
                twins.step(5 * scene.timeStep(), 2);
                events += twins.assertSameEvents(scene.name());
            }
            if (events == 0) {
                throw new IllegalStateException("nothing has touched");
            }
            twins.assertEqual(scene.name());
            return pipeline.kernelNanos().keySet();
        }
    }

    private static Pipeline jvm() {
        return new JvmPipeline(1, JvmPipeline.LEAST_SHARE, 0, false);
    }

    /** Sums up more counts than a small world has: a last block that is not full. */
    private Set<String> scan() {
        int count = 2 * 2048 + 100;
        int[] counts = new int[count];
        Arrays.fill(counts, 3);
        try (Session session = Session.open(device, true)) {
            StageKernels kernels = new StageKernels(session, WorldSource.of(List.of()), StageKernels.USUAL_GROUPS);
            DeviceBuffer buffer = session.allocate("counts", 4L * count);
            buffer.write(0, IntBuffer.wrap(counts));
            DeviceBuffer starts = session.allocate("starts", 4L * count);
            new Scan(kernels).run(buffer, count, session.allocate("sums", 4L * Scan.blocks(count)), starts);
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
