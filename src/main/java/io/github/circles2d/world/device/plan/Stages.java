package io.github.circles2d.world.device.plan;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.opencl.Session;
import io.github.circles2d.world.device.memory.BodyArrays;
import io.github.circles2d.world.device.memory.DeviceArray;
import io.github.circles2d.world.device.memory.DeviceArrays;
import io.github.circles2d.world.device.memory.EventArrays;
import io.github.circles2d.world.device.memory.Scan;
import io.github.circles2d.world.device.memory.StageKernels;
import io.github.circles2d.world.device.memory.StepParameters;
import io.github.circles2d.world.device.memory.TouchArrays;
import io.github.circles2d.world.jvm.HostBodies;
import io.github.circles2d.world.model.GridLevels;
import java.util.List;
import java.util.function.Supplier;

/** What the plans of a pipeline share: its kernels, arrays and parameters, and the first stages of a step that has one launch per stage. */
public final class Stages {
    /** Work-items of a kernel that has nothing to do in most steps. */
    private static final int MOST_CARRY_ITEMS = 1 << 15;

    private final Device device;
    private final StageKernels kernels;
    private final List<String> ofSomeSteps;
    private final DeviceArrays arrays;
    private final StepParameters parameters;

    // Grid.cl; world.jvm.Grid does the same
    private final Kernel gridCount;
    private final Kernel gridScatter;
    private final Kernel gridGather;

    // ContinuousCollision.cl; world.jvm.ContinuousCollision does the same
    private final Supplier<Kernel> sweepPrepare;
    private final Supplier<Kernel> sweepLook;
    private final Supplier<Kernel> sweepCarry;
    private final Supplier<Kernel> sweepClamp;

    // Neighbours.cl and ContactList.cl: contacts in no order within a group
    private final Supplier<Kernel> contactsCrowd;
    private final Kernel contactsCount;
    private final Supplier<Kernel> contactsCountByLevel;
    private final Supplier<Kernel> contactsCountBySheet;
    private final Supplier<Kernel> contactsCountByLevelAndSheet;
    private final Kernel contactsList;

    /** Null in a world without terrain. */
    private final Kernel pieces;

    /** Null in a world without joints. */
    private final JointKernels joints;

    /** Null in a world whose circles never sleep. */
    private final SleepStage sleep;

    /** Null in a world without bodies that are pushed. */
    private final BodyStage bodies;

    /** What impulses of the step before are multiplied by. */
    private float warmScale;

    /** Whether circles fall asleep in the steps that were enqueued last. */
    private boolean sleeping;

    private final Scan scan;

    /** Null until it is asked for. */
    private Kernel degrees;

    /** Where steps note what contacts do, decide what they report, and find pairs that are only sensed; null if they report nothing. */
    private TouchArrays touches;

    private EventArrays reporting;
    private EventStage events;
    private SensingStage sensing;

    /** Without bodies that are pushed, those and their arrays are null. */
    public Stages(
            Session session,
            StageKernels kernels,
            List<String> ofSomeSteps,
            DeviceArrays arrays,
            StepParameters parameters,
            HostBodies bodies,
            BodyArrays bodyArrays) {
        device = session.device();
        this.bodies = bodies == null
                ? null
                : new BodyStage(
                        kernels,
                        session,
                        bodies,
                        bodyArrays,
                        arrays.features().joints(),
                        arrays.features().sleeping());
        this.kernels = kernels;
        this.ofSomeSteps = ofSomeSteps;
        this.arrays = arrays;
        this.parameters = parameters;
        scan = new Scan(kernels);
        gridCount = kernels.staged("grid_count");
        gridScatter = kernels.staged("grid_scatter");
        gridGather = kernels.staged("grid_gather");
        sweepPrepare = kernels.later("continuousCollision_prepare");
        sweepLook = kernels.later("continuousCollision_look");
        sweepCarry = kernels.later("continuousCollision_carry");
        sweepClamp = kernels.later("continuousCollision_clamp");
        contactsCrowd = kernels.later("contacts_crowd");
        contactsCount = kernels.staged("contacts_count");
        contactsCountByLevel = kernels.later("contacts_countByLevel");
        contactsCountBySheet = kernels.later("contacts_countBySheet");
        contactsCountByLevelAndSheet = kernels.later("contacts_countByLevelAndSheet");
        contactsList = kernels.staged("contacts_list");
        pieces = arrays.features().terrain() ? kernels.staged("pieces_find") : null;
        joints = arrays.features().joints() ? new JointKernels(kernels, parameters.joints()) : null;
        sleep = arrays.features().sleeping()
                ? new SleepStage(
                        kernels, parameters.joints(), arrays.features().joints(), bodies == null ? null : bodyArrays)
                : null;
    }

    /** Sets where the steps to come note what contacts do, and decide what they report; null if they report nothing. */
    public void report(TouchArrays noted, EventArrays decided) {
        if (reporting != decided) {
            events = decided == null ? null : new EventStage(kernels, arrays, scan, decided);
            sensing = decided == null ? null : new SensingStage(kernels, arrays, decided);
        }
        touches = noted;
        reporting = decided;
    }

    /** Where steps note what contacts do; null if they report nothing. */
    public TouchArrays touches() {
        return touches;
    }

    /** Where steps decide what they report; null if they report nothing. */
    public EventArrays reporting() {
        return reporting;
    }

    /** What decides which events there are, behind a step of any plan. */
    public EventStage events() {
        return events;
    }

    /** What finds the pairs that are only sensed, around a step of any plan. */
    public SensingStage sensing() {
        return sensing;
    }

    /** What makes the passes over joints; null in a world without them. */
    JointKernels joints() {
        return joints;
    }

    /** The bodies that are pushed in a step that nothing refuses any more but what has come before; null if there are none, or it is refused. */
    BodyStage findBodies(int circles) {
        return bodies != null && bodies.find(warmScale, circles) ? bodies : null;
    }

    /** Whether bodies that are pushed, if there are any, leave all as it is unless something is new. */
    public boolean bodiesAreIdle() {
        return bodies == null || bodies.areIdle();
    }

    /** Whether the steps to come have joints. */
    public boolean haveJoints() {
        return parameters.joints().any();
    }

    public Device device() {
        return device;
    }

    Kernel kernel(String name) {
        return kernels.staged(name);
    }

    /** A kernel that only some steps launch. */
    Supplier<Kernel> later(String name) {
        return kernels.later(name);
    }

    /** Whether steps need a part of the kernels that has not been compiled. */
    public boolean lackKernels(Steps steps) {
        for (String part : ofSomeSteps) {
            if (need(steps, part) && !kernels.has(part)) {
                return true;
            }
        }
        return false;
    }

    /** Compiles what steps need, before any of them is enqueued. */
    public void compile(Steps steps) {
        for (String part : ofSomeSteps) {
            if (need(steps, part)) {
                kernels.compile(part);
            }
        }
    }

    private boolean need(Steps steps, String part) {
        return switch (part) {
            case Plans.LEVELS -> !steps.haveOneLevel();
            case Plans.FAST -> steps.sweeping();
            case Plans.CROWDS -> steps.thinning() || steps.levels().haveSheets();
            case Plans.WAKING -> steps.waking();
            case Plans.SENSING -> steps.sensing();
            default -> joints != null && joints.need(part);
        };
    }

    /** The parts of the kernels that only some steps need, or none. */
    public List<String> ofSomeSteps() {
        return ofSomeSteps;
    }

    /** Whether the kernels record what contacts do. */
    boolean recording() {
        return kernels.recording();
    }

    /** Gives a kernel, if it records what contacts do, where it does: its arguments from one of its own on. */
    Kernel record(Kernel kernel, int first) {
        if (recording()) {
            touches.bind(kernel, first);
        }
        return kernel;
    }

    /** Gives a kernel that tells of what was recorded where to: its arguments from one of its own on. */
    Kernel tell(Kernel kernel, int first) {
        touches.bind(kernel, first);
        return reporting.bind(kernel, first + TouchArrays.ARGUMENTS);
    }

    /** Makes room for the tiles of steps, and notes their size and number. */
    void prepare(TileSizes sizes, Steps steps) {
        arrays.ensureTiles(sizes.tiles());
        sizes.describe(steps, parameters);
    }

    /** Hands over what steps are made with that one launch makes, by tiles or not. */
    void begin(Steps steps, boolean tiled) {
        parameters.setWay(steps.sweeping(), steps.thinning(), tiled);
        send(steps.warmScale(), steps.slots(), steps.circles());
    }

    /** Up to the list of contacts; rest enqueues the rest of a step. */
    void enqueueEach(Steps steps, boolean tiled, Runnable rest) {
        parameters.setWay(steps.sweeping(), steps.thinning(), tiled);
        int slots = steps.slots();
        int circles = steps.circles();
        sleeping = steps.sleeping();
        for (int step = 0; step < steps.count(); step++) {
            warmScale = step == 0 ? steps.warmScale() : 1f;
            send(warmScale, slots, circles);
            buildGrid(steps.levels(), slots, circles, steps.waking());
            if (bodies != null && bodies.wakes(steps)) {
                bodies.wake(sleep, steps.waking(), warmScale, circles);
            } else if (steps.waking()) {
                sleep.wake(circles);
            }
            if (joints != null) {
                joints.find();
            }
            if (bodies != null) {
                bodies.free();
            }
            if (steps.sweeping()) {
                sweep(steps.levels(), circles);
            }
            if (pieces != null) {
                pieces.run(circles);
            }
            listContacts(steps.levels(), circles, steps.thinning());
            rest.run();
            if (!steps.reportsBehind()) {
                end(circles);
            }
            slots = circles;
        }
    }

    private void buildGrid(GridLevels levels, int slots, int circles, boolean waking) {
        gridCount.run(slots);
        scan.run(arrays, levels.buckets() + 1, DeviceArray.BUCKET_START);
        gridScatter.run(slots);
        if (arrays.features().sleeping()) {
            gridGather.arg(StageKernels.own(0), waking ? 1 : 0);
        }
        gridGather.run(circles);
    }

    private void sweep(GridLevels levels, int circles) {
        sweepPrepare.get().run(circles);
        sweepLook.get().run((levels.usedCount + 1L) * circles);
        for (int note = 0; note < 2; note++) {
            sweepCarry.get().arg(StageKernels.own(0), note).run(Math.min(circles, MOST_CARRY_ITEMS));
        }
        sweepClamp.get().run(circles);
    }

    private void listContacts(GridLevels levels, int circles, boolean thinning) {
        if (thinning) {
            contactsCrowd.get().run(circles);
        }
        boolean bySheet = levels.haveSheets();
        if (levels.usedCount == 1) {
            (bySheet ? contactsCountBySheet.get() : contactsCount).run(circles);
        } else {
            (bySheet ? contactsCountByLevelAndSheet : contactsCountByLevel)
                    .get()
                    .run((long) levels.usedCount * circles);
        }
        scan.run(arrays, levels.groups(circles) + 1, DeviceArray.GROUP_START);
        contactsList.run(2L * circles);
    }

    /** Lets circles fall asleep, behind a step and what it reports. */
    public void end(int circles) {
        if (sleeping) {
            if (bodies != null) {
                bodies.keepAwake(sleep);
            }
            sleep.end(circles);
        }
    }

    private void send(float scale, int slots, int circles) {
        parameters.setWarmScale(scale);
        parameters.send(arrays);
        kernels.bind(arrays, slots, circles);
    }

    /** Counts the contacts of each circle into ranks, which are all zeros before. */
    void countDegrees(DeviceArray pairs, int contacts) {
        if (degrees == null) {
            degrees = kernels.plain("contacts_degrees");
        }
        degrees.arg(0, arrays.get(pairs))
                .arg(1, contacts)
                .arg(2, arrays.get(DeviceArray.RANK))
                .run(contacts);
    }
}
