package io.github.circles2d.world.device;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.TestScale;
import io.github.circles2d.world.device.memory.StageKernels;
import io.github.circles2d.world.device.plan.PersistentGpu;
import io.github.circles2d.world.device.plan.Plan;
import io.github.circles2d.world.device.plan.Plans;
import io.github.circles2d.world.device.plan.Tiles;
import io.github.circles2d.world.jvm.JvmPipeline;
import io.github.circles2d.world.model.ContactSettings;
import io.github.circles2d.world.model.Features;
import io.github.circles2d.world.model.StepInput;
import io.github.circles2d.world.shared.Pipeline;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Consumer;

/** Empty pipelines on devices, by plans that need not be those that the device would follow. */
final class Pipelines {
    /** What a world has memory and kernels for only once it needs them. In a quick run edges, too, so that worlds with edges share programs. */
    static final Features INSIDE = inside(!TestScale.LONG);

    /** The same with edges, whether there are some or not: so worlds that report share programs with those that have edges. */
    static final Features INSIDE_EDGES = inside(true);

    private Pipelines() {}

    private static Features inside(boolean edges) {
        return Features.EDGES
                .when(edges)
                .and(Features.TURNING)
                .and(Features.TERRAIN)
                .and(Features.JOINTS)
                .and(Features.SLEEPING)
                .and(Features.OWN_MOTION);
    }

    /** Makes pipelines on devices ready for all that a world can have inside, in mid-life. In an exhaustive run they compile what they need. */
    static void makeReady(Pipeline... pipelines) {
        for (Pipeline pipeline : pipelines) {
            if (pipeline instanceof DevicePipeline && !TestScale.EXHAUSTIVE) {
                pipeline.prepare(ContactSettings.DEFAULT, INSIDE);
            }
        }
    }

    /** Those of {@link #ready(Device, Features)} without edges. */
    static Pipeline[] ready(Device device) {
        return ready(device, INSIDE);
    }

    /**
     * The pipeline in Java, and one for each plan that a device can follow; in a quick run by colours alone, whose program is shorter. Those on
     * devices are ready from the start, so that tests of surfaces, of terrain and of joints share programs.
     */
    static Pipeline[] ready(Device device, Features features) {
        return TestScale.LONG
                ? all(device, features)
                : new Pipeline[] {java(), of(device, colours(device), false, features)};
    }

    /** The plans by colours, with the program that tests share: in a quick run that of colours alone. */
    static List<Plan> colours(Device device) {
        return TestScale.LONG ? plans(device, Plans.COLOURS) : Plans.COLOURS.of(device);
    }

    /** The pipeline in Java, and one for each plan that a device can follow. */
    static Pipeline[] all(Device device, Features features) {
        List<Pipeline> pipelines = new ArrayList<>();
        pipelines.add(java());
        pipelines.add(of(device, plans(device, Plans.COLOURS), false, features));
        if (Tiles.fit(device)) {
            pipelines.add(of(device, plans(device, Plans.TILES), false, features));
        }
        if (PersistentGpu.groupsWait(device)) {
            pipelines.add(of(device, plans(device, Plans.PERSISTENT_GPU), false, features));
        }
        return pipelines.toArray(Pipeline[]::new);
    }

    private static Pipeline java() {
        return new JvmPipeline(1, JvmPipeline.LEAST_SHARE, 0, false);
    }

    static DevicePipeline of(Device device, Plans plans) {
        return of(device, plans, false);
    }

    static DevicePipeline of(Device device, Plans plans, boolean profiling) {
        return of(device, plans(device, plans), profiling);
    }

    /** Those by colours have the program of those by tiles: a driver compiles what both have once. */
    static List<Plan> plans(Device device, Plans plans) {
        if (plans != Plans.COLOURS || !Tiles.fit(device)) {
            return plans.of(device);
        }
        List<Plan> all = new ArrayList<>(Plans.TILES.of(device));
        all.replaceAll(plan -> plan instanceof Tiles ? new CompiledOnly(plan) : plan);
        return all;
    }

    static DevicePipeline of(Device device, List<Plan> plans, boolean profiling) {
        return of(device, plans, profiling, Features.NONE);
    }

    /** One that is ready for features from the start; an exhaustive run compiles for each world what it has. */
    static DevicePipeline of(Device device, List<Plan> plans, boolean profiling, Features features) {
        Features first = TestScale.EXHAUSTIVE ? Features.NONE : features;
        return new DevicePipeline(device, 0, profiling, plans, StageKernels.USUAL_GROUPS, true, first);
    }

    /** The same pipelines with a feature, whose steps are prepared further. */
    static Pipeline[] with(Features feature, Consumer<StepInput> prepare, Pipeline... pipelines) {
        return Arrays.stream(pipelines)
                .map(pipeline -> Proxy.newProxyInstance(
                        Pipeline.class.getClassLoader(),
                        new Class<?>[] {Pipeline.class},
                        (proxy, method, arguments) -> call(pipeline, method, arguments, feature, prepare)))
                .toArray(Pipeline[]::new);
    }

    private static Object call(
            Pipeline pipeline, Method method, Object[] arguments, Features feature, Consumer<StepInput> prepare)
            throws Throwable {
        if (method.getName().equals("step")) {
            prepare.accept((StepInput) arguments[0]);
        } else if (method.getName().equals("prepare")) {
            arguments[1] = ((Features) arguments[1]).and(feature);
        }
        try {
            return method.invoke(pipeline, arguments);
        } catch (InvocationTargetException e) {
            throw e.getCause();
        }
    }
}
