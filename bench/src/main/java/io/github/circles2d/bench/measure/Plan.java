package io.github.circles2d.bench.measure;

import io.github.circles2d.PairIndexing;
import io.github.circles2d.bench.engines.Engines;
import io.github.circles2d.bench.jmh.CopyBenchmark;
import io.github.circles2d.bench.jmh.PeerBenchmark;
import io.github.circles2d.bench.jmh.StrategyBenchmark;
import io.github.circles2d.bench.jmh.TransferBenchmark;
import io.github.circles2d.bench.jmh.WorldBenchmark;
import io.github.circles2d.bench.results.ResultsFolder;
import io.github.circles2d.bench.results.ResultsFolder.Kind;
import io.github.circles2d.bench.results.Table;
import io.github.circles2d.opencl.Device;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeSet;
import java.util.function.Predicate;

/** The list of the work. Small sizes come first: they tell how long the large ones will take. */
final class Plan {
    private static final List<Integer> THESIS_SIZES = List.of(1250, 2500, 5000, 10_000, 15_000);

    /** The thesis's, and beyond to where an int can no longer number the slots or the memory ends. */
    private static final List<Integer> STRATEGY_SIZES =
            List.of(1250, 2500, 5000, 10_000, 15_000, 20_000, 30_000, 46_000, 65_000);

    /** Beyond what engines can do that test every pair; see {@link #scales}. */
    private static final List<Integer> LARGE_CROWDS = List.of(100_000, 1_000_000);

    private static final int LARGE_CROWD = 100_000;

    private static final List<Integer> QUICK_SIZES = List.of(1250, 2500, 5000);

    /** In a short look only engines run it whose time grows about as n does. */
    private static final int QUICK_CROWD = 5000;

    private static final List<Integer> WORLD_SIZES = List.of(1250, 5000, 15_000, 100_000, 1_000_000, 10_000_000);

    /** From here on World on a CPU makes fewer steps, and runs less; it runs up to here. */
    private static final int LARGE_WORLD = 1_000_000;

    /** The size at which circles come and go. */
    private static final int STORM_SIZE = 15_000;

    /** Steps in which the overlaps of the start come apart. */
    private static final int SKIPPED = 100;

    private static final long MIB = 1 << 20;

    private final Options options;
    private final Map<String, Device> devices;
    private final ResultsFolder folder;
    private final boolean quick;
    private final Map<String, String> hopeless = new HashMap<>();
    private final List<Work> work = new ArrayList<>();

    private Plan(Options options, Map<String, Device> devices, ResultsFolder folder) {
        this.options = options;
        this.devices = devices;
        this.folder = folder;
        quick = options.quick();
    }

    /** Lists the work that the options ask for on the devices given. */
    static List<Work> of(Options options, Map<String, Device> devices, ResultsFolder folder) {
        Plan plan = new Plan(options, devices, folder);
        for (Options.Part part : options.parts()) {
            switch (part) {
                case COPY -> devices.forEach(plan::addCopies);
                case ACCURACY -> devices.forEach(plan::addAccuracy);
                case STRATEGIES -> plan.addStrategies();
                case TRANSFER -> devices.keySet().forEach(plan::addTransfers);
                case WORLD ->
                    options.sizes(plan.quick ? List.of(1250, 5000) : WORLD_SIZES)
                            .forEach(plan::addWorld);
                case PEERS -> plan.addPeers();
                case SERIES -> plan.addSeries();
            }
        }
        return plan.work;
    }

    /** JMH's work, unless there is a figure and only missing ones are asked for. */
    private void add(Task task) {
        if (isAskedFor(task)) {
            boolean many = task.kind() == Kind.WORLD;
            JmhWork.Effort effort = quick ? JmhWork.Effort.QUICK : many ? JmhWork.Effort.BRISK : JmhWork.Effort.FULL;
            work.add(new JmhWork(task, effort, folder, hopeless));
        }
    }

    private boolean isAskedFor(Task task) {
        return !options.missing() || !folder.hasFigure(task.kind(), task.key());
    }

    private void addCopies(String name, Device device) {
        for (long mib : quick ? new long[] {8, 64} : new long[] {1, 4, 16, 64, 256, 1024}) {
            long bytes = mib * MIB;
            if (3 * bytes <= device.memoryBytes() && bytes <= device.maxBufferBytes()) {
                Map<String, String> key = Table.columns("device", name, "bytes", Long.toString(bytes));
                String benchmark = CopyBenchmark.class.getName() + ".copy";
                add(new Task(Kind.COPY, key, 1, benchmark, key, 0, mib < 256 ? 20 : 5, 0.3 * mib));
            }
        }
    }

    private void addAccuracy(String name, Device device) {
        List<Integer> sizes = options.sizes(quick ? THESIS_SIZES : STRATEGY_SIZES);
        work.add(new AccuracyWork(name, device, sizes, quick ? 5 : 120, folder));
    }

    private void addStrategies() {
        for (int n : options.sizes(quick ? QUICK_SIZES : STRATEGY_SIZES)) {
            devices.forEach((name, device) -> {
                for (PairIndexing indexing : EnumSet.complementOf(EnumSet.of(PairIndexing.AUTO))) {
                    for (String mode : strategyModes(n)) {
                        add(strategy(n, name, device.kind() == Device.Kind.CPU, indexing, mode));
                    }
                }
            });
        }
    }

    private List<String> strategyModes(int n) {
        if (!quick) {
            return List.of("loop", "deviceOnly", "profiled");
        }
        return n == 2500 ? List.of("loop", "profiled") : List.of("loop");
    }

    private Task strategy(int n, String device, boolean cpu, PairIndexing indexing, String mode) {
        String number = Integer.toString(n);
        double slots = n * (n - 1.0) / 2;
        // As many steps as make a fixed number of visits to slots, within bounds: the same on every machine.
        double steps = quick ? Math.max(5, Math.min(50, 1e8 / slots)) : Math.max(10, Math.min(200, 2.5e9 / slots));
        String strategy = Integer.toString(indexing.strategy());
        return new Task(
                Kind.STRATEGIES,
                Table.columns("device", device, "strategy", strategy, "n", number, "mode", mode),
                2,
                StrategyBenchmark.class.getName() + "." + mode,
                Table.columns("device", device, "indexing", indexing.name(), "n", number),
                0,
                (int) steps,
                slots * (cpu ? 1e-5 : 1e-7) + 0.05);
    }

    /** As many bytes as circles that World reads, and more. */
    private void addTransfers(String device) {
        for (int bytes : quick ? new int[] {1 << 20} : new int[] {20_000, 240_000, 1 << 20, 16 << 20, 128 << 20}) {
            addTransfers(device, "read", bytes);
        }
        if (!quick) {
            addTransfers(device, "write", 16 << 20);
        }
    }

    private void addTransfers(String device, String direction, int size) {
        String bytes = Integer.toString(size);
        for (TransferBenchmark.Memory memory : TransferBenchmark.Memory.values()) {
            String name = memory.name().toLowerCase(Locale.ROOT);
            add(new Task(
                    Kind.TRANSFER,
                    Table.columns("device", device, "direction", direction, "memory", name, "bytes", bytes),
                    1,
                    TransferBenchmark.class.getName() + "." + direction,
                    Table.columns("device", device, "memory", memory.name(), "bytes", bytes),
                    0,
                    size < 1 << 20 ? 500 : 20,
                    0.02 + 2e-7 * size));
        }
    }

    /** World's runs of a size, on GPUs first; before them the state that they start from. */
    private void addWorld(int n) {
        int before = work.size();
        for (Contender who : Contender.worlds(devices)) {
            boolean gpu = who.isOnGpu();
            if (options.wants(who.engine()) && (gpu || n <= LARGE_WORLD)) {
                worldModes(who, n).forEach(mode -> add(world(who.engine(), n, gpu, mode)));
            }
        }
        if (work.size() > before) {
            work.add(before, new StartWork(((JmhWork) work.get(before)).task(), SKIPPED));
        }
    }

    /** What is worth measuring: on the JVM a read is a copy within the heap, and steps in one call save nothing. */
    private List<String> worldModes(Contender who, int n) {
        boolean gpu = who.isOnGpu();
        String modes = "steps frames readPositions requestPositions readArray readBuffer profiled";
        if (quick) {
            modes = "steps";
        } else if (!gpu && n >= LARGE_WORLD) {
            modes = "steps profiled";
        } else if (n > LARGE_WORLD) {
            modes = "steps readPositions requestPositions readArray profiled";
        } else if (who.engine().equals(Engines.WORLD_JVM)) {
            modes = "steps readArray profiled";
        } else if (!gpu) {
            modes = "steps frames readArray profiled";
        }
        return List.of((n == STORM_SIZE ? modes + " storm1 storm10" : modes).split(" "));
    }

    private static Task world(String engine, int n, boolean gpu, String mode) {
        String number = Integer.toString(n);
        Map<String, String> parameters =
                Table.columns("engine", engine, "n", number, "skipped", Integer.toString(SKIPPED));
        String percent = mode.replaceAll("[a-zA-Z]+", "");
        if (!percent.isEmpty()) {
            parameters.put("percent", percent);
        }
        // The same for all that are compared at an n: on a CPU the largest crowds would take minutes.
        int steps = n < STORM_SIZE ? 500 : n < 100_000 ? 200 : n < LARGE_WORLD ? 100 : gpu ? 50 : 20;
        return new Task(
                Kind.WORLD,
                Table.columns("engine", engine, "n", number, "mode", mode),
                1,
                WorldBenchmark.class.getName() + "." + mode.replaceAll("[0-9]+", ""),
                parameters,
                0,
                steps,
                gpu ? 0.2 + 1e-6 * n : 0.3 + (engine.equals(Engines.WORLD_JVM) ? 4e-4 : 1e-3) * n);
    }

    private void addPeers() {
        List<String> engines = new ArrayList<>(Engines.PEERS);
        engines.add(Engines.WORLD_JVM);
        devices.keySet().forEach(device -> engines.addAll(Engines.own(device)));
        engines.removeIf(engine -> !options.wants(engine));
        List<String> scaling = engines.stream().filter(Plan::scales).toList();
        List<Integer> sizes = options.sizes(quick ? List.of(1250) : THESIS_SIZES).stream()
                .filter(n -> n < LARGE_CROWD && !(quick && n == QUICK_CROWD))
                .toList();
        if (quick) {
            // What takes longest comes last: it may have to be left out.
            addPeers(sizes, scaling, n -> true);
            addPeers(options.sizes(QUICK_SIZES), scaling, n -> n == QUICK_CROWD);
            engines.removeAll(scaling);
            addPeers(sizes, engines, n -> true);
        } else {
            addPeers(sizes, engines, n -> true);
            addPeers(options.sizes(LARGE_CROWDS), scaling, n -> n >= LARGE_CROWD);
            // At 1,250 the two scenes are the same. Few steps: engines that solve their contacts take a second for one
            // of them,
            // and it never comes to rest anyway.
            sizes.stream()
                    .filter(n -> n != 1250)
                    .forEach(n -> engines.forEach(
                            engine -> add(peer(engine, "thesis", n, 10, 20, 100 * Math.pow(n / 2500.0, 2)))));
        }
    }

    private void addPeers(List<Integer> sizes, List<String> engines, Predicate<Integer> wanted) {
        sizes.stream()
                .filter(wanted)
                .forEach(n -> engines.forEach(engine -> {
                    int steps = quick || n >= LARGE_CROWD ? 100 : 500;
                    int skipped = 100;
                    if (engine.equals("gdx-box2d") && n >= 15_000) {
                        // A step takes it a tenth of a second and more.
                        steps = n < LARGE_CROWD ? 100 : 10;
                        skipped = steps;
                    }
                    add(peer(engine, "packed", n, skipped, steps, guess(engine, n)));
                }));
    }

    /** Whether an engine's time grows about as the number of circles does. */
    private static boolean scales(String engine) {
        return engine.startsWith("world")
                || List.of("gdx-box2d", Engines.JAVA_GRID).contains(engine);
    }

    /** Ms a step on the scene packed. */
    private static double guess(String engine, int n) {
        double small = List.of("jbox2d", "dyn4j").contains(engine) ? 12 : 3;
        return small * Math.pow(n / 1250.0, scales(engine) ? 1.2 : 2);
    }

    private static Task peer(String engine, String scene, int n, int skipped, int steps, double guess) {
        Map<String, String> parameters = Table.columns("engine", engine, "scene", scene, "n", Integer.toString(n));
        Map<String, String> key = new LinkedHashMap<>(parameters);
        key.put("steps", Integer.toString(steps));
        parameters.put("skipped", Integer.toString(skipped));
        double growth = scales(engine) && scene.equals("packed") ? 1.5 : 2;
        String benchmark = PeerBenchmark.class.getName() + ".step";
        return new Task(Kind.PEERS, key, growth, benchmark, parameters, skipped, steps, guess);
    }

    /** Size by size, series by series, the fastest engines first, so that little is missing where the time ends. */
    private void addSeries() {
        List<Contender> all = Contender.all(devices);
        TreeSet<Integer> sizes = new TreeSet<>();
        options.scenes().forEach(series -> sizes.addAll(options.sizes(series.sizes())));
        for (int n : sizes) {
            for (Series series : options.scenes()) {
                if (options.sizes(series.sizes()).contains(n)) {
                    all.forEach(who -> addSeries(who, series, n));
                }
            }
        }
    }

    /** A million circles are World's unless sizes are named: a step takes the others seconds. */
    private void addSeries(Contender who, Series series, int n) {
        if (options.wants(who.engine())
                && (who.isWorld() || n < LARGE_WORLD || !options.sizes().isEmpty())) {
            Map<String, String> key = who.key(series, n);
            Task task =
                    new Task(Kind.SERIES, key, 1.5, "", Map.of(), series.skipped, Series.STEPS, guess(who.engine(), n));
            if (isAskedFor(task)) {
                work.add(new SeriesWork(task, options.patience(), folder));
            }
        }
    }
}
