package io.github.circles2d.world.device;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.TestScale;
import io.github.circles2d.world.device.memory.StageKernels;
import io.github.circles2d.world.device.plan.Plan;
import io.github.circles2d.world.device.plan.Plans;
import io.github.circles2d.world.device.plan.Tiles;
import io.github.circles2d.world.jvm.JvmPipeline;
import io.github.circles2d.world.model.ContactSettings;
import io.github.circles2d.world.model.Features;
import io.github.circles2d.world.shared.Pipeline;
import java.util.ArrayList;
import java.util.List;

/** Empty pipelines on devices, by plans that need not be those that the device would follow. */
final class Pipelines {
    /** What a world has memory and kernels for only once it needs them. In a quick run edges, too, so that worlds with edges share programs. */
    static final Features INSIDE = Features.of(!TestScale.LONG, true, true, true, true, true);

    private Pipelines() {}

    /**
     * Those on devices are ready for all that a world can have inside, so that tests of surfaces, of terrain and of joints share programs.
     * An exhaustive run compiles for each world what it has.
     */
    static Pipeline[] ready(Pipeline... pipelines) {
        for (Pipeline pipeline : pipelines) {
            if (pipeline instanceof DevicePipeline && !TestScale.EXHAUSTIVE) {
                pipeline.prepare(ContactSettings.DEFAULT, INSIDE);
            }
        }
        return pipelines;
    }

    /** The pipeline in Java, and one for each plan that a device can follow; in a quick run by colours alone, whose program is shorter. */
    static Pipeline[] ready(Device device) {
        if (!TestScale.LONG) {
            return ready(
                    new JvmPipeline(1, JvmPipeline.LEAST_SHARE, 0, false), of(device, Plans.COLOURS.of(device), false));
        }
        return ready(PipelinesAgreeTest.pipelines(device));
    }

    static DevicePipeline of(Device device, Plans plans) {
        return of(device, plans, false);
    }

    static DevicePipeline of(Device device, Plans plans, boolean profiling) {
        return of(device, plans(device, plans), profiling);
    }

    /** Those by colours have the program of those by tiles: a driver compiles what both have once. */
    private static List<Plan> plans(Device device, Plans plans) {
        if (plans != Plans.COLOURS || !Tiles.fit(device)) {
            return plans.of(device);
        }
        List<Plan> all = new ArrayList<>(Plans.TILES.of(device));
        all.replaceAll(plan -> plan instanceof Tiles ? new CompiledOnly(plan) : plan);
        return all;
    }

    static DevicePipeline of(Device device, List<Plan> plans, boolean profiling) {
        return new DevicePipeline(device, 0, profiling, plans, StageKernels.USUAL_GROUPS, true);
    }
}
