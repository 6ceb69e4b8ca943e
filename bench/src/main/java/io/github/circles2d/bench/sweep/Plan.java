package io.github.circles2d.bench.sweep;

import io.github.circles2d.PairIndexing;
import io.github.circles2d.bench.engines.Engines;
import io.github.circles2d.bench.jmh.CopyBenchmark;
import io.github.circles2d.bench.jmh.PeerBenchmark;
import io.github.circles2d.bench.jmh.StrategyBenchmark;
import io.github.circles2d.bench.results.Numbers;
import io.github.circles2d.bench.results.ResultsFolder;
import io.github.circles2d.bench.results.Table;
import io.github.circles2d.opencl.Device;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.EnumSet;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/** The list of a sweep's work. Small sizes come first: they tell how long the large ones will take. */
final class Plan {
    private static final List<Integer> THESIS_SIZES = List.of(1250, 2500, 5000, 10_000, 15_000);

    /** Beyond the thesis, to where an int can no longer number the slots or the memory ends. */
    private static final List<Integer> BEYOND = List.of(20_000, 30_000, 46_000, 65_000);

    /** Beyond what engines can do that test every pair; see {@link #scales}. */
    private static final List<Integer> LARGE_CROWDS = List.of(100_000, 1_000_000);

    private static final List<Integer> QUICK_SIZES = List.of(1250, 2500, 5000);

    /** In a short look only engines run it whose time grows about as n does. */
    private static final int QUICK_CROWD = 5000;

    private static final long MIB = 1 << 20;

    private final Options options;
    private final Map<String, Device> devices;
    private final ResultsFolder folder;
    private final JmhWork.Effort effort;
    private final Map<String, String> hopeless = new HashMap<>();
    private final List<Work> work = new ArrayList<>();

    private Plan(Options options, Map<String, Device> devices, ResultsFolder folder) {
        this.options = options;
        this.devices = devices;
        this.folder = folder;
        effort = options.quick() ? JmhWork.Effort.QUICK : JmhWork.Effort.FULL;
    }

    /** Lists the work that the options ask for on the devices given. */
    static List<Work> of(Options options, Map<String, Device> devices, ResultsFolder folder) {
        Plan plan = new Plan(options, devices, folder);
        for (Options.Part part : options.parts()) {
            switch (part) {
                case COPY:
                    plan.addCopies();
                    break;
                case ACCURACY:
                    plan.addAccuracy();
                    break;
                case STRATEGIES:
                    plan.addStrategies();
                    break;
                case TRANSFER:
                    WorldPlan.transfers(options, devices).forEach(plan::add);
                    break;
                case WORLD:
                    plan.addWorld();
                    break;
                case PEERS:
                    plan.addPeers();
                    break;
                default:
                    throw new AssertionError(part);
            }
        }
        return plan.work;
    }

    /** Tells what earlier sweeps have left in the folder about how long things take. */
    static void remember(ResultsFolder folder, Pace pace) {
        for (Map<String, String> row : bySize(folder.table(ResultsFolder.Kind.STRATEGIES))) {
            pace.remember(
                    strategySeries(row.get("indexing"), row.get("device")),
                    Long.parseLong(row.get("n")),
                    Numbers.parse(row.get("mean_ms")));
        }
        for (Map<String, String> row : bySize(folder.table(ResultsFolder.Kind.PEERS))) {
            pace.remember(
                    peerSeries(row.get("engine"), row.get("scene")),
                    Long.parseLong(row.get("n")),
                    Numbers.parse(row.get("mean_ms")));
        }
        for (Map<String, String> row : bySize(folder.table(ResultsFolder.Kind.WORLD))) {
            pace.remember(
                    WorldPlan.series(row.get("engine"), row.get("mode")),
                    Long.parseLong(row.get("n")),
                    Numbers.parse(row.get("mean_ms")));
        }
    }

    private static List<Map<String, String>> bySize(Table table) {
        List<Map<String, String>> rows = table.rows("status", "ok");
        rows.sort(Comparator.comparingLong(row -> Long.parseLong(row.get("n"))));
        return rows;
    }

    private static String strategySeries(String indexing, String device) {
        return "strategy " + indexing + " on " + device;
    }

    private static String peerSeries(String engine, String scene) {
        return engine + " " + scene;
    }

    private void addCopies() {
        List<Long> sizes = options.quick()
                ? List.of(8 * MIB, 64 * MIB)
                : List.of(MIB, 4 * MIB, 16 * MIB, 64 * MIB, 256 * MIB, 1024 * MIB);
        for (Map.Entry<String, Device> device : devices.entrySet()) {
            for (long bytes : sizes) {
                if (3 * bytes > device.getValue().memoryBytes()
                        || bytes > device.getValue().maxBufferBytes()) {
                    continue;
                }
                Map<String, String> key = new LinkedHashMap<>();
                key.put("device", device.getKey());
                key.put("bytes", Long.toString(bytes));
                add(new Task(
                        ResultsFolder.Kind.COPY,
                        key,
                        "copy " + device.getKey(),
                        bytes,
                        1,
                        CopyBenchmark.class.getName() + ".copy",
                        Map.of("device", device.getKey(), "bytes", Long.toString(bytes)),
                        0,
                        bytes < 256 * MIB ? 20 : 5,
                        0.3 * bytes / MIB));
            }
        }
    }

    private void addAccuracy() {
        List<Integer> sizes = new ArrayList<>(THESIS_SIZES);
        if (!options.quick()) {
            sizes.addAll(BEYOND);
        }
        devices.forEach((name, device) ->
                work.add(new AccuracyWork(name, device, options.sizes(sizes), options.quick() ? 5 : 120, folder)));
    }

    private void addStrategies() {
        List<Integer> sizes = new ArrayList<>(options.quick() ? QUICK_SIZES : THESIS_SIZES);
        if (!options.quick()) {
            sizes.addAll(BEYOND);
        }
        for (int n : options.sizes(sizes)) {
            for (Map.Entry<String, Device> device : devices.entrySet()) {
                for (PairIndexing indexing : EnumSet.complementOf(EnumSet.of(PairIndexing.AUTO))) {
                    for (String mode : modes(n)) {
                        add(strategy(n, device.getKey(), device.getValue(), indexing, mode));
                    }
                }
            }
        }
    }

    private List<String> modes(int n) {
        if (!options.quick()) {
            return List.of("loop", "deviceOnly", "profiled");
        }
        return n == 2500 ? List.of("loop", "profiled") : List.of("loop");
    }

    private Task strategy(int n, String name, Device device, PairIndexing indexing, String mode) {
        Map<String, String> key = new LinkedHashMap<>();
        key.put("device", name);
        key.put("strategy", Integer.toString(indexing.strategy()));
        key.put("n", Integer.toString(n));
        key.put("mode", mode);
        double slots = n * (n - 1.0) / 2;
        double guess = slots * (device.kind() == Device.Kind.CPU ? 1e-5 : 1e-7) + 0.05;
        return new Task(
                ResultsFolder.Kind.STRATEGIES,
                key,
                strategySeries(indexing.name(), name),
                n,
                2,
                StrategyBenchmark.class.getName() + "." + mode,
                Map.of("device", name, "indexing", indexing.name(), "n", Integer.toString(n)),
                0,
                strategySteps(slots),
                guess);
    }

    /** As many steps as make a fixed number of visits to slots, within bounds: the same on every machine. */
    private int strategySteps(double slots) {
        return options.quick()
                ? (int) Math.max(5, Math.min(50, 1e8 / slots))
                : (int) Math.max(10, Math.min(200, 2.5e9 / slots));
    }

    /** Each size begins with the state that all its runs start from. */
    private void addWorld() {
        WorldPlan world = new WorldPlan(options, devices);
        for (int n : world.sizes()) {
            List<Task> tasks = world.tasks(n);
            int before = work.size();
            tasks.forEach(this::add);
            if (work.size() > before) {
                work.add(before, new StartWork(tasks.get(0)));
            }
        }
    }

    private void addPeers() {
        List<String> engines = new ArrayList<>(Engines.PEERS);
        engines.add(Engines.WORLD_JVM);
        devices.keySet().forEach(device -> engines.addAll(Engines.own(device)));
        if (!options.engines().isEmpty()) {
            engines.retainAll(options.engines());
        }
        List<Integer> sizes = options.sizes(options.quick() ? List.of(1250) : THESIS_SIZES).stream()
                .filter(n -> n < LARGE_CROWDS.get(0) && !(options.quick() && n == QUICK_CROWD))
                .collect(Collectors.toList());
        if (options.quick()) {
            // What takes longest comes last: it may have to be left out.
            sizes.forEach(n -> engines.stream().filter(Plan::scales).forEach(engine -> add(packed(engine, n))));
            if (options.sizes(QUICK_SIZES).contains(QUICK_CROWD)) {
                engines.stream().filter(Plan::scales).forEach(engine -> add(packed(engine, QUICK_CROWD)));
            }
            engines.removeIf(Plan::scales);
        }
        for (int n : sizes) {
            engines.forEach(engine -> add(packed(engine, n)));
        }
        if (!options.quick()) {
            for (int n : options.sizes(LARGE_CROWDS)) {
                engines.stream()
                        .filter(engine -> n >= LARGE_CROWDS.get(0) && scales(engine))
                        .forEach(engine -> add(packed(engine, n)));
            }
            // At 1,250 the two scenes are the same.
            sizes.stream().filter(n -> n != 1250).forEach(n -> engines.forEach(engine -> add(overfull(engine, n))));
        }
    }

    /** Whether an engine's time grows about as the number of circles does. */
    private static boolean scales(String engine) {
        return engine.startsWith("world")
                || List.of("gdx-box2d", Engines.JAVA_GRID).contains(engine);
    }

    private Task packed(String engine, int n) {
        double small = List.of("jbox2d", "dyn4j").contains(engine) ? 12 : 3;
        double guess = small * Math.pow(n / 1250.0, scales(engine) ? 1.2 : 2);
        if (engine.equals("gdx-box2d") && n >= 15_000) {
            // A step takes it a tenth of a second and more.
            int steps = n < LARGE_CROWDS.get(0) ? 100 : 10;
            return peer(engine, "packed", n, steps, steps, guess);
        }
        int steps = options.quick() || n >= LARGE_CROWDS.get(0) ? 100 : 500;
        return peer(engine, "packed", n, 100, steps, guess);
    }

    /** Few steps: engines that solve their contacts take a second for one of them, and it never comes to rest anyway. */
    private Task overfull(String engine, int n) {
        return peer(engine, "thesis", n, 10, 20, 100 * Math.pow(n / 2500.0, 2));
    }

    private static Task peer(String engine, String scene, int n, int skipped, int steps, double guess) {
        Map<String, String> key = new LinkedHashMap<>();
        key.put("engine", engine);
        key.put("scene", scene);
        key.put("n", Integer.toString(n));
        key.put("steps", Integer.toString(steps));
        Map<String, String> parameters = new LinkedHashMap<>(key);
        parameters.remove("steps");
        parameters.put("skipped", Integer.toString(skipped));
        return new Task(
                ResultsFolder.Kind.PEERS,
                key,
                peerSeries(engine, scene),
                n,
                scales(engine) && scene.equals("packed") ? 1.5 : 2,
                PeerBenchmark.class.getName() + ".step",
                parameters,
                skipped,
                steps,
                guess);
    }

    private void add(Task task) {
        if (options.missing() && folder.hasFigure(task.kind(), task.key())) {
            return;
        }
        boolean many = effort == JmhWork.Effort.FULL && task.kind() == ResultsFolder.Kind.WORLD;
        work.add(new JmhWork(task, many ? JmhWork.Effort.BRISK : effort, folder, hopeless));
    }
}
