package io.github.circles2d.world.device;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.DeviceBuffer;
import io.github.circles2d.opencl.OpenCl;
import io.github.circles2d.opencl.Session;
import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import io.github.circles2d.world.DeviceSearches;
import io.github.circles2d.world.Simulation;
import io.github.circles2d.world.SimulationScenes;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.WorldParameters;
import io.github.circles2d.world.device.memory.DeviceArray;
import io.github.circles2d.world.device.memory.DeviceArrays;
import io.github.circles2d.world.device.memory.Scan;
import io.github.circles2d.world.device.memory.StageKernels;
import io.github.circles2d.world.device.memory.Status;
import io.github.circles2d.world.device.memory.WorldSource;
import io.github.circles2d.world.device.plan.Plan;
import io.github.circles2d.world.device.plan.Plans;
import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.jvm.JvmPipeline;
import io.github.circles2d.world.model.AxisEdge;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.KindField;
import io.github.circles2d.world.model.Tuning;
import io.github.circles2d.world.queries.CastSearch;
import io.github.circles2d.world.queries.QueryShape;
import io.github.circles2d.world.search.QueryFilter;
import io.github.circles2d.world.shared.Pipeline;
import java.nio.IntBuffer;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.TreeSet;

/**
 * Makes steps of a small world in a JVM whose OpenCL driver is Oclgrind, which reports to standard error; prints the kernels
 * that have run. Oclgrind interprets each work-item, also those past a kernel's count, so small work-groups are quick.
 * Arguments: the world, and its size: {@code smallest}, which makes fewer steps than {@code small}, or {@code large}.
 */
final class OclgrindWorlds {
    /** Work-items of a work-group in a world that is not large, if its kernel leaves that open. */
    private static final int SMALL_GROUP = 8;

    /**
     * Worlds in which Oclgrind 21.10 says of what is initialised that it is not: what the host writes to a part of a buffer, as when
     * circles are loaded or pairs that touch are sent, or a world begins to turn or gets terrain or joints; and all that comes of it.
     */
    static final Set<String> MISJUDGED = Set.of(
            "changes",
            "edges",
            "turning",
            "terrain",
            "terrain of tiles",
            "joints",
            "joints of tiles",
            "bodies",
            "bodies of tiles",
            "bodies that sleep",
            "bodies that sleep, of tiles",
            "sleep",
            "sleep of tiles");

    private final Device device;
    private final boolean small;

    /** Of a step. A kernel asks of a sub-step no more than whether it is the first and whether it is the last: two are both of that. */
    private final int subSteps;

    /** Of a call. */
    private final int steps;

    private OclgrindWorlds(Device device, String size) {
        this.device = device;
        small = !size.equals("large");
        subSteps = small ? 1 : 2;
        steps = size.equals("smallest") ? 1 : 2;
    }

    public static void main(String[] args) {
        Device device = OpenCl.devices().get(0);
        if (!device.platform().contains("Oclgrind")) {
            throw new IllegalStateException("not Oclgrind but " + device);
        }
        Set<String> kernels = new OclgrindWorlds(device, args[1]).run(args[0]);
        System.out.println("kernels " + String.join(" ", kernels));
        System.out.println("done");
    }

    private Set<String> run(String world) {
        Set<String> kernels = new TreeSet<>();
        switch (world) {
            case "COLOURS" -> {
                kernels.addAll(scan());
                kernels.addAll(events(Plans.COLOURS, Scenes.mixed(small ? 20 : 40, 2)));
            }
            case "levels in an arena that is not folded" -> kernels.addAll(levels());
            case "a table of pairs that grows" -> kernels.addAll(growingTable());
            case "changes" -> kernels.addAll(changes(Scenes.mixed(small ? 20 : 40, 1)));
            case "TILES" -> {
                kernels.addAll(steps(Plans.TILES, Scenes.thesis(60, 1), 1 / 60f, 2, 2));
                kernels.addAll(events(Plans.TILES, Scenes.thesis(40, 1)));
                kernels.addAll(listedTiles());
            }
            case "PERSISTENT_GPU" -> {
                kernels.addAll(persistent(Plans.PERSISTENT_GPU));
                kernels.addAll(events(Plans.PERSISTENT_GPU, Scenes.thesis(40, 1)));
            }
            case "queries" -> {
                // No more circles than there is memory for at first: of arrays that grew, Oclgrind says that nobody
                // wrote them.
                kernels.addAll(queries(Scenes.mixed(small ? 20 : 60, 3)));
            }
            case "levels of tiles" -> {
                kernels.addAll(steps(Plans.TILES, Scenes.mixed(20, 1), 1 / 60f, 2, 2));
                kernels.addAll(events(Plans.TILES, Scenes.mixed(20, 2)));
            }
            case "levels of PERSISTENT_GPU" -> {
                kernels.addAll(steps(Plans.PERSISTENT_GPU, Scenes.mixed(20, 1), 1 / 60f, 2, 2));
                kernels.addAll(events(Plans.PERSISTENT_GPU, Scenes.mixed(20, 2)));
            }
            case "wide" -> {
                // As few as have two blocks of buckets to sum up; eight tiles.
                kernels.addAll(steps(Plans.PERSISTENT_GPU, Scenes.gas(1024, 1), 1e-4f, 1, 1));
            }
            case "fast" -> kernels.addAll(steps(Plans.COLOURS, Scenes.gas(20, 1), 1f, small ? 1 : 2, subSteps));
            case "crowd" -> {
                kernels.addAll(crowd(Plans.COLOURS, false));
                kernels.addAll(heaps());
            }
            case "levels in a crowd" -> {
                for (Plans plans : List.of(Plans.TILES, Plans.PERSISTENT_GPU)) {
                    kernels.addAll(crossCrowd(plans));
                }
                kernels.addAll(crowd(Plans.COLOURS, true));
            }
            case "edges" -> {
                kernels.addAll(edges(Plans.COLOURS));
                kernels.addAll(edges(Plans.PERSISTENT_GPU));
            }
            case "turning" -> kernels.addAll(turning(Scenes.mixed(20, 1)));
            case "terrain" -> kernels.addAll(terrain(Plans.COLOURS, Scenes.mixed(20, 1), true));
            case "terrain of tiles" -> {
                kernels.addAll(terrain(Plans.TILES, Scenes.thesis(20, 1), false));
                kernels.addAll(terrain(Plans.PERSISTENT_GPU, Scenes.thesis(20, 1), false));
            }
            case "joints" -> kernels.addAll(joints(Plans.COLOURS, Scenes.mixed(20, 1), true));
            case "bodies" -> kernels.addAll(bodies(Plans.COLOURS));
            case "bodies of tiles" -> kernels.addAll(bodies(Plans.TILES));
            case "bodies that sleep" -> kernels.addAll(sleepingBodies(Plans.COLOURS));
            case "bodies that sleep, of tiles" -> kernels.addAll(sleepingBodies(Plans.TILES));
            case "sleep" -> {
                if (steps > 1) {
                    kernels.addAll(sleep(Plans.COLOURS, false));
                }
                kernels.addAll(sleep(Plans.COLOURS, true));
            }
            case "sleep of tiles" -> kernels.addAll(sleep(Plans.TILES, false));
            case "joints of tiles" -> {
                kernels.addAll(joints(Plans.PERSISTENT_GPU, Scenes.thesis(20, 1), false));
                kernels.addAll(joints(Plans.TILES, Scenes.mixed(20, 1), true));
            }
            default -> throw new IllegalArgumentException(world);
        }
        return kernels;
    }

    /** Two steps of a tile that stays in local memory; then one that is refused for fast circles at first. */
    private Set<String> persistent(Plans plans) {
        Set<String> kernels = new TreeSet<>(steps(plans, Scenes.thesis(60, 1), 1 / 60f, 2, 2));
        kernels.addAll(steps(plans, Scenes.gas(20, 1), 1f, small ? 1 : 2, small ? 1 : 2));
        return kernels;
    }

    private DevicePipeline pipeline(Plans plans) {
        return pipeline(plans, 0);
    }

    private DevicePipeline pipeline(Plans plans, int capacity) {
        return pipeline(plans.of(device), capacity);
    }

    private DevicePipeline pipeline(List<Plan> plans, int capacity) {
        int workGroupSize = small ? SMALL_GROUP : StageKernels.USUAL_GROUPS;
        return new DevicePipeline(device, capacity, true, plans, workGroupSize, true);
    }

    /** Tiles are listed, as behind one that held too much. */
    private Set<String> listedTiles() {
        List<Plan> plans = Plans.TILES.of(device);
        plans.forEach(plan -> plan.learn(new Plan.TileUse(101, 0, false), false));
        return steps(pipeline(plans, 0), Scenes.thesis(40, 1), 1 / 60f, 1, small ? 1 : 2);
    }

    /**
     * All circles meet: more than pairs are kept of; or, with levels, fewer circles. There is room for their contacts from the start:
     * arrays that grow are misjudged.
     */
    private Set<String> crowd(Plans plans, boolean withLevels) {
        DevicePipeline pipeline = pipeline(plans, 2100);
        Scene scene = Scenes.onePoint(withLevels ? 47 : 64, 1);
        try (Twins twins = Twins.load(scene, subSteps, jvm(), pipeline)) {
            if (withLevels) {
                twins.set(Commands.RADIUS, 0, 4 * scene.radius(0), 0);
            }
            twins.step(1 / 60f, 1);
            twins.assertEqual(plans + ", a crowd");
            twins.assertSameFigures();
            return pipeline.kernelNanos().keySet();
        }
    }

    private Set<String> steps(Plans plans, Scene scene, float dt, int steps, int subSteps) {
        return steps(pipeline(plans), scene, dt, steps, subSteps);
    }

    private Set<String> steps(DevicePipeline pipeline, Scene scene, float dt, int steps, int subSteps) {
        try (Twins twins = Twins.load(scene, subSteps, jvm(), pipeline)) {
            // Adding a thousand circles replaces the buffer of commands by a larger one. Oclgrind 21.10 calls what the
            // host writes to that one unwritten, though kernels read it, and with it the kinds of all circles.
            // The other worlds have kinds on the same kernels.
            if (scene.size() < 1000) {
                twins.giveKinds();
            }
            twins.step(dt, steps);
            twins.assertEqual(scene.name());
            twins.assertSameFigures();
            return pipeline.kernelNanos().keySet();
        }
    }

    /** Unlike radii in a small arena, and no static circle: then the circles of a bucket are in the order of their ids. */
    private Set<String> levels() {
        Scene scene = Scenes.mixed(small ? 20 : 40, 8, 2);
        DevicePipeline pipeline = pipeline(Plans.COLOURS, scene.size());
        try (Twins twins = Twins.load(scene, subSteps, jvm(), pipeline)) {
            twins.step(scene.timeStep(), steps);
            twins.assertEqual(scene.name());
            return pipeline.kernelNanos().keySet();
        }
    }

    private Set<String> crossCrowd(Plans plans) {
        DevicePipeline pipeline = pipeline(plans);
        try (Twins twins = Twins.empty(new Bounds(0, 0, 1, 1), jvm(), pipeline)) {
            twins.addCrossCrowd(Tuning.CROWD + 1);
            twins.step(1 / 60f, 2);
            twins.assertEqual(plans + ", a crowd of cross contacts");
            return pipeline.kernelNanos().keySet();
        }
    }

    /** A crowd of few contacts, which is refused by one plan and made by tiles. */
    private Set<String> heaps() {
        DevicePipeline pipeline = pipeline(Plans.PERSISTENT_GPU, 600);
        try (Twins twins = Twins.empty(new Bounds(0, 0, 1, 1), jvm(), pipeline)) {
            twins.addCrowd(1 + Tuning.CROWD / 2);
            twins.step(1 / 60f, 1);
            twins.assertEqual("a circle between heaps");
            return pipeline.kernelNanos().keySet();
        }
    }

    /** Changes and restores between steps that report, so the host sends the pairs that touch. */
    private Set<String> changes(Scene scene) {
        DevicePipeline pipeline = pipeline(Plans.COLOURS);
        SplittableRandom random = new SplittableRandom(3);
        try (Twins twins = Twins.load(scene, subSteps, jvm(), pipeline)) {
            twins.report(ContactEvents.ALL);
            for (int k = 0; k < 2; k++) {
                twins.step(scene.timeStep(), 1);
                twins.assertSameFigures();
                twins.assertSameEvents(scene.name());
                twins.change(scene, random);
                twins.exchange();
                twins.confine();
                twins.assertSameReadings();
                twins.assertEqual(scene.name());
            }
            return pipeline.kernelNanos().keySet();
        }
    }

    /**
     * Circles of several levels, of which some are static, and walls grip and turn. The world turns before it has circles: few arrays that
     * the host has written take part. Two sub-steps: one is the first but not the last, the other the last but not the first.
     */
    private Set<String> turning(Scene scene) {
        DevicePipeline pipeline = pipeline(Plans.COLOURS, scene.size());
        SplittableRandom random = new SplittableRandom(4);
        Bounds bounds = new Bounds(scene.minX(), scene.minY(), scene.maxX(), scene.maxY());
        try (Twins twins = Twins.empty(bounds, 2, jvm(), pipeline)) {
            twins.changeSurfaces(random);
            for (int i = 0; i < scene.size(); i++) {
                twins.add(scene.x(i), scene.y(i), scene.radius(i), 1, 0.1f * (i % 10), 0, -1);
            }
            for (int k = 0; k < (steps == 1 ? 1 : 3); k++) {
                twins.step(scene.timeStep(), 1);
                if (k == 0) {
                    twins.giveKinds();
                    twins.giveMotions();
                    twins.step(scene.timeStep(), 1);
                }
                twins.changeSurfaces(random);
                twins.set(Commands.RADIUS, k, scene.radius(k), 0);
            }
            twins.report(ContactEvents.ALL);
            twins.step(scene.timeStep(), steps);
            twins.assertSameEvents(scene.name());
            twins.assertSameTurns(scene.name());
            twins.assertEqual(scene.name());
            return pipeline.kernelNanos().keySet();
        }
    }

    /** Random pieces, at rest and on bodies that move, some of which come and go. */
    private Set<String> terrain(Plans plans, Scene scene, boolean turns) {
        DevicePipeline pipeline = pipeline(plans);
        SplittableRandom random = new SplittableRandom(6);
        try (Twins twins = Twins.load(scene, subSteps, jvm(), pipeline)) {
            for (int k = 0; k < 3; k++) {
                for (int changes = 0; changes < 20; changes++) {
                    twins.changeTerrain(random);
                }
                if (k == 1) {
                    twins.sense(0, 1);
                    twins.setKind(KindField.SENSES_STATIC, 1, 1);
                    twins.set(Commands.MASS, 4, Float.POSITIVE_INFINITY, 0);
                    twins.report(ContactEvents.ALL);
                }
                if (turns && k == 1) {
                    twins.changeSurfaces(random);
                }
                twins.set(Commands.RADIUS, k, 1.1f * scene.radius(k), 0);
                twins.step(5 * scene.timeStep(), steps);
                twins.assertEqual(scene.name() + " with terrain, step " + k);
            }
            if (twins.pieces() == 0) {
                throw new IllegalStateException("there is no terrain");
            }
            twins.assertSameTurns(scene.name());
            return pipeline.kernelNanos().keySet();
        }
    }

    /** Circles that fell asleep on the host, of which some wake, and another one falls asleep. all: with friction, terrain and joints. */
    private Set<String> sleep(Plans plans, boolean all) {
        DevicePipeline pipeline = pipeline(plans, 64);
        Bounds bounds = new Bounds(0, 0, 2, 2);
        try (Twins asleep = Twins.sleeping(bounds, subSteps, 10, jvm());
                Twins twins = Twins.sleeping(bounds, subSteps, 10, jvm(), pipeline)) {
            if (all) {
                asleep.setKind(KindField.FRICTION, 0, Float.floatToRawIntBits(0.5f));
                asleep.addPlate(1, 0.05f, 1, false);
            }
            for (int k = 0; k < 8; k++) {
                asleep.add(0.2f + 0.21f * k, k % 2 == 0 ? 0.15f : 0.3f, 0.1f, 1, 0, 0, 0);
            }
            asleep.step(1 / 60f, 300);
            twins.takeOver(asleep);
            if (twins.assertSameSleepers(plans + ", at first") < 2) {
                throw new IllegalStateException("few sleep");
            }
            twins.report(ContactEvents.ALL);
            twins.step(1 / 60f, 1);
            twins.add(1, 0.6f, 0.1f, 1, 0, 0, -9);
            if (all) {
                twins.addRod(0, 1);
            }
            twins.step(1 / 60f, steps);
            twins.assertEqual(plans + ", a ball");
            twins.move(7, 1, 1);
            twins.wakeAll();
            twins.step(1 / 60f, 1);
            twins.assertEqual(plans + ", one moved");
            twins.assertSameEvents(plans + ", one moved");
            return pipeline.kernelNanos().keySet();
        }
    }

    /** A step without joints; then joints of every form: in batches, in none, and split ones; some break. */
    private Set<String> joints(Plans plans, Scene scene, boolean turns) {
        DevicePipeline pipeline = pipeline(plans);
        SplittableRandom random = new SplittableRandom(6);
        Bounds bounds = new Bounds(scene.minX(), scene.minY(), scene.maxX(), scene.maxY());
        JointTwins joints = new JointTwins(bounds, scene.radius(0));
        int split = 0;
        int batches = 0;
        int inNoBatch = 0;
        int broken = 0;
        Set<String> kernels;
        try (Twins twins = Twins.load(scene, subSteps, joints.on(jvm(), pipeline))) {
            twins.step(scene.timeStep(), 1);
            for (int k = 0; k < 3; k++) {
                if (turns && k == 1) {
                    twins.letChangesTurn();
                    twins.changeSurfaces(random);
                    joints.turning = true;
                }
                joints.fragile = k == 1;
                joints.make(k == 0 ? 8 : 60 + 30 * k, scene.size(), 1, random);
                split += joints.split();
                batches += joints.batches();
                inNoBatch += joints.inNoBatch();
                for (int step = 0; step < steps; step++) {
                    joints.moveAnchors(random);
                    twins.step(scene.timeStep(), 1);
                    String when = scene.name() + " with joints, step " + k;
                    twins.assertEqual(when);
                    joints.assertSameStates(when);
                    broken += joints.assertSameBroken(when, scene.size());
                }
            }
            kernels = pipeline.kernelNanos().keySet();
        }
        if (split == 0 || batches == 0 || inNoBatch == 0 || broken == 0) {
            throw new IllegalStateException(
                    split + " split joints, " + batches + " batches, " + inNoBatch + " in none, " + broken + " broken");
        }
        return kernels;
    }

    /** Bodies that are pushed, among circles. */
    private Set<String> bodies(Plans plans) {
        DevicePipeline pipeline = pipeline(plans);
        WorldParameters parameters = new WorldParameters(new Bounds(0, 0, 12, 12), 0, -10, 0, subSteps, 0);
        try (Simulation one = new Simulation(jvm(), parameters);
                Simulation other = new Simulation(pipeline, parameters)) {
            BodyChanges[] each = {new BodyChanges(one, 20), new BodyChanges(other, 20)};
            for (int step = 0; step < 2 * steps; step++) {
                for (BodyChanges world : each) {
                    world.change(step);
                    world.simulation().step(1 / 60f, 1);
                }
                if (one.hash() != other.hash()) {
                    throw new IllegalStateException(plans + " with bodies, step " + step);
                }
            }
            return pipeline.kernelNanos().keySet();
        }
    }

    /** Bodies and circles that fell asleep on the host, of which some wake. */
    private Set<String> sleepingBodies(Plans plans) {
        DevicePipeline pipeline = pipeline(plans);
        WorldParameters parameters =
                new WorldParameters(new Bounds(0, 0, 12, 8), 0, -10, 0.1f, subSteps, 0).sleeping(true);
        try (Simulation asleep = new Simulation(jvm(), parameters);
                Simulation one = new Simulation(jvm(), parameters);
                Simulation other = new Simulation(pipeline, parameters)) {
            SleepingBodies before = new SleepingBodies(asleep, 0);
            before.fill();
            asleep.step(1 / 60f, 600);
            SleepingBodies[] each = {before.goOn(one), before.goOn(other)};
            each[1].awake();
            for (int step = 0; step < 2 * steps; step++) {
                for (SleepingBodies world : each) {
                    world.disturb(step);
                    world.simulation().step(1 / 60f, 1);
                }
                if (one.hash() != other.hash()) {
                    throw new IllegalStateException(plans + " with bodies that sleep, step " + step);
                }
            }
            if (each[1].mostSleepers() < 3 || each[1].mostSleepingBodies() < 3) {
                throw new IllegalStateException("few sleep");
            }
            return pipeline.kernelNanos().keySet();
        }
    }

    /** Fast circles in a world of which one axis wraps and the other is open. */
    private Set<String> edges(Plans plans) {
        Scene scene = Scenes.gas(20, 1);
        DevicePipeline pipeline = pipeline(plans);
        try (Twins twins = Twins.load(scene, subSteps, jvm(), pipeline)) {
            twins.restoreWithEdges(AxisEdge.WRAP, AxisEdge.OPEN);
            twins.step(0.3f, 2);
            twins.assertEqual(scene.name());
            return pipeline.kernelNanos().keySet();
        }
    }

    /** Steps that record what contacts do; those behind the first ones also what sensors notice. */
    private Set<String> events(Plans plans, Scene scene) {
        DevicePipeline pipeline = pipeline(plans);
        try (Twins twins = Twins.load(scene, subSteps, jvm(), pipeline)) {
            twins.report(ContactEvents.ALL);
            int events = 0;
            for (int k = 0; k < 3; k++) {
                if (k == 1) {
                    twins.giveSensors(200, 5);
                    twins.setKind(KindField.SENSES_STATIC, 200, 1);
                    twins.set(Commands.MASS, 5, Float.POSITIVE_INFINITY, 0);
                    twins.set(Commands.MASS, 6, Float.POSITIVE_INFINITY, 0);
                }
                twins.step(5 * scene.timeStep(), steps);
                events += twins.assertSameEvents(scene.name());
            }
            if (events == 0) {
                throw new IllegalStateException("nothing has touched");
            }
            twins.remove(1); // the pairs of a circle that goes are asked for
            twins.step(scene.timeStep(), 1);
            twins.assertSameEvents(scene.name() + " after a removal");
            twins.assertEqual(scene.name());
            return pipeline.kernelNanos().keySet();
        }
    }

    /**
     * More pairs touch than three quarters of the first table of them, and some touched in the step before: circles fly into a heap. They
     * are sensed alone, so no other array grows.
     */
    private Set<String> growingTable() {
        int heap = 20;
        int flying = 9;
        DevicePipeline pipeline = pipeline(Plans.COLOURS, heap + flying);
        try (Twins twins = Twins.empty(new Bounds(0, 0, 1, 1), 2, jvm(), pipeline)) {
            twins.report(ContactEvents.ALL);
            twins.sense(0, 0);
            for (int circle = 0; circle < heap; circle++) {
                twins.add(0.5f, 0.5f, 0.02f, 1, 0, 0, 0);
            }
            for (int circle = 0; circle < flying; circle++) {
                twins.add(0.3f, 0.5f, 0.02f, 1, 0, 6, 0);
            }
            for (int k = 0; k < 3; k++) {
                twins.step(1 / 60f, 1);
                twins.assertSameEvents("step " + k);
            }
            twins.assertSameTouching(0, 0);
            twins.assertEqual("many pairs");
            return pipeline.kernelNanos().keySet();
        }
    }

    /** Queries on the device: of each shape, of all circles and of some. */
    private Set<String> queries(Scene scene) {
        DevicePipeline pipeline = pipeline(Plans.COLOURS);
        try (Simulation simulation = DeviceSearches.always(SimulationScenes.simulation(scene, 1, pipeline));
                Simulation host = SimulationScenes.simulation(scene, 1, jvm())) {
            float[] numbers = new float[2 * QueryShape.MOST_NUMBERS];
            for (int k = 0; k < numbers.length; k++) {
                numbers[k] = (scene.maxX() - scene.minX()) * (k + 1) / (numbers.length + 1);
            }
            int found = 0;
            for (QueryShape shape : QueryShape.values()) {
                found += query(simulation, shape, numbers);
                if (query(host, shape, numbers) != query(simulation, shape, numbers)) {
                    throw new IllegalStateException("the host finds other circles by " + shape);
                }
            }
            if (found == 0 || DeviceSearches.answered(simulation) != 4 * QueryShape.values().length) {
                throw new IllegalStateException("the device has not found anything");
            }
            return pipeline.kernelNanos().keySet();
        }
    }

    private static int query(Simulation simulation, QueryShape shape, float[] numbers) {
        long[] handles = new long[1000];
        float[] hits = new float[CastSearch.HIT_STRIDE * handles.length];
        int found = 0;
        for (QueryFilter filter : new QueryFilter[] {null, simulation.searches.filter(null, 1)}) {
            found += switch (shape) {
                case POINT -> simulation.searches.one(filter, shape, numbers, 2, handles, null);
                case NEAREST -> simulation.searches.nearest(filter, numbers, 2, 100, 3, handles, hits);
                default ->
                    simulation.searches.all(
                            filter, shape, numbers, 2, new int[2], handles, shape.isCast() ? hits : null);
            };
        }
        return found;
    }

    private static Pipeline jvm() {
        return new JvmPipeline(1, JvmPipeline.LEAST_SHARE, 0, false);
    }

    /** Sums up more blocks than a work-group has work-items, or than a small world has; the last one is not full. */
    private Set<String> scan() {
        int count = small ? 300 : 2 * 2048 + 100;
        int[] counts = new int[count];
        Arrays.fill(counts, 3);
        try (Session session = Session.open(device, true)) {
            StageKernels kernels = new StageKernels(session, WorldSource.of(List.of()), StageKernels.USUAL_GROUPS);
            DeviceBuffer buffer = session.allocate("counts", 4L * count);
            buffer.write(0, IntBuffer.wrap(counts));
            DeviceBuffer starts = session.allocate("starts", 4L * count);
            DeviceArrays arrays = new DeviceArrays(session, 1, false);
            new Status().write(arrays);
            DeviceBuffer status = arrays.get(DeviceArray.STATUS);
            new Scan(kernels).run(buffer, count, session.allocate("sums", 4L * Scan.blocks(count)), starts, status);
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
