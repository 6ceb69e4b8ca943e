package io.github.circles2d.world.device.plan;

import static java.util.Map.entry;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.KernelSource;
import io.github.circles2d.world.device.memory.WorldSource;
import io.github.circles2d.world.model.Readiness;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Function;
import java.util.function.Predicate;

/**
 * The table of the plans that a device follows. A device has the first row that takes it. The first plan of the row that suits a
 * step makes it; the last plan suits all steps.
 */
public enum Plans {
    PERSISTENT_GPU(
            device -> isGpu(device) && Tiles.fit(device) && PersistentGpu.groupsWait(device),
            device -> gpu(device) + ", of a vendor whose work-groups can wait for each other",
            device -> {
                TileSizes sizes = new TileSizes(device.computeUnits(), Tiles.holdTurning(device));
                return List.of(new PersistentGpu(sizes), new Tiles(sizes), new ByColours());
            }),
    TILES(
            device -> isGpu(device) && Tiles.fit(device),
            Plans::gpu,
            device -> List.of(
                    new Tiles(new TileSizes(device.computeUnits(), Tiles.holdTurning(device))), new ByColours())),
    COLOURS(
            device -> true,
            device -> isGpu(device) ? gpu(device) + ", too few for tiles" : "the others are for GPUs",
            device -> List.of(new ByColours()));

    /** The part of the kernels of calls between steps. */
    public static final String CALLS = "calls";

    /** The part of the kernels that decide what steps report. */
    public static final String REPORTS = "reports";

    /** The part of the kernels that find static circles that sense each other, and pieces. */
    public static final String STATICS = "statics";

    /** The part of the kernels that all steps need which are made by the last plan. */
    public static final String STEPS = "steps";

    /** The part of the kernels of continuous collision. */
    static final String FAST = "fast";

    /** The part of the kernels of steps in which circles have several levels. */
    static final String LEVELS = "levels";

    /** The part of the kernels of steps in which many circles are at one place. */
    static final String CROWDS = "crowds";

    /** The part of the kernels of steps in which circles may wake. */
    static final String WAKING = "waking";

    /** The part of the kernels that visit joints which a work-group visits together. */
    static final String JOINT_BATCHES = "jointBatches";

    /** The part of the kernels that visit other joints, a colour at a time. */
    static final String JOINT_COLOURS = "jointColours";

    /** The part of the kernels of joints that are split. */
    static final String SPLIT_JOINTS = "splitJoints";

    /** The part of the kernels that find pairs which are only sensed. */
    static final String SENSING = "sensing";

    /** The part of the kernels that work out figures of a step. */
    private static final String STATISTICS = "statistics";

    private static final Map<String, String> PARTS = Map.ofEntries(
            entry("contacts_candidates", STATISTICS),
            entry("contacts_degrees", STATISTICS),
            entry("contacts_countByLevel", LEVELS),
            entry("contacts_countBySheet", CROWDS),
            entry("contacts_countByLevelAndSheet", CROWDS),
            entry("contacts_crowd", CROWDS),
            entry("sleeping_press", WAKING),
            entry("sleeping_hold", WAKING),
            entry("sleeping_pressByBodies", WAKING),
            entry("sleeping_wake", WAKING),
            entry("sleeping_spread", WAKING),
            entry("sleeping_keep", WAKING),
            entry("joints_passBatches", JOINT_BATCHES),
            entry("joints_passColour", JOINT_COLOURS),
            entry("joints_passSplit", SPLIT_JOINTS),
            entry("joints_takeSums", SPLIT_JOINTS),
            entry("sensing_find", SENSING));

    private static final System.Logger LOG = System.getLogger(Plans.class.getName());

    private final Predicate<Device> takes;
    private final Function<Device, String> reason;
    private final Function<Device, List<Plan>> plans;

    Plans(Predicate<Device> takes, Function<Device, String> reason, Function<Device, List<Plan>> plans) {
        this.takes = takes;
        this.reason = reason;
        this.plans = plans;
    }

    /** The row of a device, with the reason in the log. */
    public static Plans choose(Device device) {
        for (Plans row : values()) {
            if (row.takes.test(device)) {
                LOG.log(
                        System.Logger.Level.DEBUG,
                        "World on {0} uses plan {1}: {2}",
                        device.name(),
                        row,
                        row.reason.apply(device));
                return row;
            }
        }
        throw new AssertionError("the last row takes every device");
    }

    /** The plans of this row, in the order in which a step looks at them. */
    public List<Plan> of(Device device) {
        return plans.apply(device);
    }

    /** The plan that makes steps: the first that suits them. */
    public static Plan first(List<Plan> plans, Steps steps) {
        for (Plan plan : plans) {
            if (plan.suits(steps)) {
                return plan;
            }
        }
        throw new IllegalStateException("none of the plans suits " + steps);
    }

    /** The part of the kernels that a plan needs besides those of the plans behind it; null if it needs none. */
    public static String partOf(Plan plan) {
        return plan.ownKernels().isEmpty() ? null : plan.getClass().getSimpleName();
    }

    /** The part that a kernel belongs to: those of a plan, of calls between steps, of reports, of static circles, of some or of all steps. */
    public static String partOf(List<Plan> plans, String kernel) {
        for (Plan plan : plans) {
            if (plan.ownKernels().contains(kernel)) {
                return partOf(plan);
            }
        }
        String part = PARTS.get(kernel);
        if (part != null) {
            return part;
        }
        return switch (kernel.substring(0, kernel.indexOf('_'))) {
            case "commands", "readback" -> CALLS;
            case "events", "sensing" -> REPORTS;
            case "statics" -> STATICS;
            case "continuousCollision" -> FAST;
            case "cross" -> LEVELS;
            default -> STEPS;
        };
    }

    /** The parts that only some steps need, or none, in the order in which they are compiled beside. */
    public static List<String> ofSomeSteps(Readiness variant) {
        List<String> parts = new ArrayList<>(List.of(STATISTICS, LEVELS, FAST));
        if (variant.features().joints()) {
            parts.addAll(List.of(JOINT_BATCHES, JOINT_COLOURS, SPLIT_JOINTS));
        }
        if (variant.reporting()) {
            parts.add(SENSING);
        }
        if (variant.features().sleeping()) {
            parts.add(WAKING);
        }
        parts.add(CROWDS);
        return List.copyOf(parts);
    }

    /** One plan of each kind. */
    public static List<Plan> all() {
        TileSizes sizes = new TileSizes(1, true);
        return List.of(new PersistentGpu(sizes), new Tiles(sizes), new ByColours());
    }

    /** The source of plans: of what all share, and of no other file than theirs. */
    public static KernelSource source(List<Plan> plans) {
        Set<String> files = new LinkedHashSet<>();
        plans.forEach(plan -> files.addAll(plan.files()));
        KernelSource source = WorldSource.of(files);
        for (Plan plan : plans) {
            source = plan.define(source);
        }
        return source;
    }

    /** The same, with what they must know of a device. */
    public static KernelSource source(List<Plan> plans, Device device) {
        return BodyStage.define(JointKernels.define(SleepStage.define(source(plans))))
                .define("PTX", PersistentGpu.groupsWait(device))
                .define("EVENT_GROUP", Tiles.eventGroup(device.maxWorkGroupSize()));
    }

    private static boolean isGpu(Device device) {
        return device.kind() == Device.Kind.GPU;
    }

    private static String gpu(Device device) {
        return "a GPU with " + device.localMemoryBytes() + " bytes of local memory";
    }
}
