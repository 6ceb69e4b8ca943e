package io.github.circles2d.world.device.plan;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.opencl.KernelSource;
import io.github.circles2d.world.device.memory.DeviceArray;
import io.github.circles2d.world.device.memory.EventArrays;
import io.github.circles2d.world.device.memory.StageKernels;
import io.github.circles2d.world.device.memory.TileRecord;
import io.github.circles2d.world.device.memory.TouchArrays;
import java.util.List;
import java.util.Set;

/** One launch per stage, and per pass over all contacts of a level; {@code kernels/world/tiles/Tiles.cl} says how. */
public final class Tiles implements Plan, SubSteps.Passes {
    /** Local memory that a work-group takes. */
    private static final int LOCAL_BYTES = 40 << 10;

    /** The same where circles turn. */
    private static final int LOCAL_BYTES_TO_TURN = 44 << 10;

    /** The most work-items of a work-group that decides what steps report. */
    private static final int EVENT_GROUP = StageKernels.SMALL_GROUPS ? 16 : 512;

    /** Circles for each work-group that decides what steps report: with more of them launches cost less than the barriers gain. */
    private static final int CIRCLES_PER_GROUP = 2_000;

    /** Cells of the smallest tile that others are cut into. */
    private static final int CELLS_OF_SMALLEST = 4;

    private final TileSizes sizes;
    private Stages stages;
    private Kernel cut;
    private Kernel link;
    private Kernel arrange;
    private Kernel solve;
    private Kernel relax;
    private SubSteps subSteps;
    private Kernel startSlots;
    private Kernel solveLevels;
    private Kernel moveSlots;
    private Kernel relaxLevels;
    private Kernel finishSlots;
    private Kernel storeImpulses;

    /** Null if steps do not record what contacts do. */
    private Kernel tell;

    private Kernel decide;
    private int deciders;
    private int eventGroup;

    Tiles(TileSizes sizes) {
        this.sizes = sizes;
    }

    public static boolean fit(Device device) {
        return device.localMemoryBytes() >= LOCAL_BYTES && device.maxWorkGroupSize() >= TileRecord.GROUP;
    }

    /** Whether tiles have room for circles that turn. */
    static boolean holdTurning(Device device) {
        return device.localMemoryBytes() >= LOCAL_BYTES_TO_TURN;
    }

    /** Many GPUs run no more than 256 work-items of events in a work-group, and their compilers refuse more. */
    static int eventGroup(int most) {
        return Math.min(EVENT_GROUP, most);
    }

    @Override
    public List<String> files() {
        return List.of(
                "world/tiles/TileLevels.cl",
                "world/tiles/TileEvents.cl",
                "world/stages/Joints.cl",
                "world/stages/Sleeping.cl");
    }

    @Override
    public KernelSource define(KernelSource source) {
        return source.define("HALO_COLUMNS", TileSizes.HALO_COLUMNS);
    }

    @Override
    public boolean usesTileArrays() {
        return true;
    }

    @Override
    public Set<String> ownKernels() {
        return Set.of(
                "contacts_cutTiles",
                "contacts_link",
                "contacts_arrange",
                "contacts_orderListed",
                "solver_solveTile",
                "solver_relaxTile",
                "solver_startSlots",
                "solver_solveLevels",
                "solver_moveSlots",
                "solver_relaxLevels",
                "solver_finishSlots",
                "solver_storeImpulses",
                "touches_tellByTile",
                "events_decideByTile");
    }

    @Override
    public void load(Stages shared) {
        stages = shared;
        cut = stages.kernel("contacts_cutTiles");
        link = stages.kernel("contacts_link");
        arrange = stages.kernel("contacts_arrange");
        solve = stages.kernel("solver_solveTile");
        relax = stages.kernel("solver_relaxTile");
        subSteps = new SubSteps(stages);
        startSlots = stages.kernel("solver_startSlots");
        solveLevels = stages.kernel("solver_solveLevels");
        moveSlots = stages.kernel("solver_moveSlots");
        relaxLevels = stages.kernel("solver_relaxLevels");
        finishSlots = stages.kernel("solver_finishSlots");
        storeImpulses = stages.kernel("solver_storeImpulses");
        tell = stages.recording() ? stages.kernel("touches_tellByTile") : null;
        decide = stages.recording() ? stages.kernel("events_decideByTile") : null;
        eventGroup = eventGroup(stages.device().maxWorkGroupSize());
        deciders = Math.min(PersistentGpu.mostGroups(stages.device()), EventArrays.MOST_DECIDERS);
    }

    @Override
    public boolean suits(Steps steps) {
        return sizes.suit(steps);
    }

    @Override
    public void enqueue(Steps steps) {
        sizes.choose(steps);
        stages.prepare(sizes, steps);
        stages.enqueueEach(steps, true, () -> makeSubSteps(steps));
    }

    private void makeSubSteps(Steps steps) {
        if (sizes.cut()) {
            cut.run(steps.levels().buckets() / CELLS_OF_SMALLEST);
        }
        link.run(2L * steps.circles());
        stages.record(arrange.arg(StageKernels.own(0), sizes.cut() ? 1 : 0), 1).run(items(), TileRecord.GROUP);
        BodyStage bodies = stages.findBodies(steps.circles());
        if (steps.sharePasses()) {
            // Kernels that are for bodies, too, do not take the sums of heavy circles as the circles start or move.
            subSteps.begin(steps, steps.bodies());
            subSteps.make(steps, steps.bodies(), bodies, this);
        } else {
            passes(steps);
        }
        storeImpulses.run(2L * steps.circles());
        if (decidesEvents(steps)) {
            decide();
        }
    }

    @Override
    public void start(Steps steps, int sub) {
        runEach(startSlots, steps, sub);
    }

    @Override
    public void solve(Steps steps, int sub) {
        runTiles(solveLevels, sub);
    }

    @Override
    public void move(Steps steps, int sub) {
        runEach(moveSlots, steps, sub);
    }

    @Override
    public void relax(Steps steps, int sub, boolean last) {
        runTiles(relaxLevels, sub);
    }

    @Override
    public void finish(Steps steps) {
        finishSlots.run(steps.circles());
    }

    private void runEach(Kernel kernel, Steps steps, int sub) {
        stages.record(kernel.arg(StageKernels.own(0), sub), 1).run(steps.circles());
    }

    private void runTiles(Kernel kernel, int sub) {
        stages.record(kernel.arg(StageKernels.own(0), sub), 1).run(items(), TileRecord.GROUP);
    }

    private long items() {
        return (long) sizes.tiles() * TileRecord.GROUP;
    }

    @Override
    public boolean decidesEvents(Steps steps) {
        return steps.recording()
                && !steps.sensing()
                && steps.circles() <= (long) CIRCLES_PER_GROUP * deciders
                && decide.maxWorkGroupSize() >= eventGroup;
    }

    private void decide() {
        EventArrays events = stages.reporting();
        stages.tell(decide, 0)
                .arg(StageKernels.own(TouchArrays.ARGUMENTS + EventArrays.ARGUMENTS), events.blockSums())
                .run((long) deciders * eventGroup, eventGroup);
        events.nextStep();
    }

    @Override
    public void tell(int circles) {
        stages.tell(tell, 0).run(items(), TileRecord.GROUP);
    }

    private void passes(Steps steps) {
        stages.record(solve, 1);
        stages.record(relax, 1);
        for (int sub = 0; sub < steps.subSteps(); sub++) {
            solve.arg(StageKernels.own(0), sub).run(items(), TileRecord.GROUP);
            relax.arg(StageKernels.own(0), sub).run(items(), TileRecord.GROUP);
        }
    }

    @Override
    public void countDegrees(int contacts) {
        stages.countDegrees(DeviceArray.ORDERED, contacts);
    }

    @Override
    public void learn(Plan.TileUse use, boolean thinning) {
        sizes.learn(use, thinning);
    }
}
