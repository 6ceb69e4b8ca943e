package io.github.circles2d.bench.sweep;

import io.github.circles2d.bench.engines.Engines;
import io.github.circles2d.bench.jmh.TransferBenchmark;
import io.github.circles2d.bench.jmh.WorldBenchmark;
import io.github.circles2d.bench.results.ResultsFolder;
import io.github.circles2d.opencl.Device;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/** The runs of World, and of the transfers that its reads are made of. */
final class WorldPlan {
    private static final List<Integer> SIZES = List.of(1250, 5000, 15_000, 100_000, 1_000_000, 10_000_000);

    private static final List<Integer> QUICK_SIZES = List.of(1250, 5000);

    /** From here on what runs on a CPU makes fewer steps, and runs less. */
    private static final int LARGE = 1_000_000;

    /** Up to here on a CPU. */
    private static final int LARGEST_ON_CPU = 1_000_000;

    /** The size at which circles come and go, in percent of them before each step. */
    private static final int STORM_SIZE = 15_000;

    private static final List<Integer> STORMS = List.of(1, 10);

    /** Steps in which the overlaps of the start come apart. */
    private static final int SKIPPED = 100;

    private final Options options;
    private final Map<String, Device> devices;

    WorldPlan(Options options, Map<String, Device> devices) {
        this.options = options;
        this.devices = devices;
    }

    /** Runs that cost about the same by n. */
    static String series(String engine, String mode) {
        return "world " + engine + " " + mode;
    }

    List<Integer> sizes() {
        return options.sizes(options.quick() ? QUICK_SIZES : SIZES);
    }

    /** The runs of a size, on GPUs first. */
    List<Task> tasks(int n) {
        List<Task> tasks = new ArrayList<>();
        devices.forEach((name, device) -> {
            if (device.kind() != Device.Kind.CPU) {
                addAll(Engines.world(name), n, true, tasks);
            }
        });
        addAll(Engines.WORLD_JVM, n, false, tasks);
        devices.forEach((name, device) -> {
            if (device.kind() == Device.Kind.CPU) {
                addAll(Engines.world(name), n, false, tasks);
            }
        });
        return tasks;
    }

    private void addAll(String engine, int n, boolean gpu, List<Task> tasks) {
        boolean asked = options.engines().isEmpty() || options.engines().contains(engine);
        if (!asked || (n > LARGEST_ON_CPU && !gpu)) {
            return;
        }
        for (String mode : modes(engine, n, gpu)) {
            tasks.add(task(engine, n, gpu, mode, mode, Map.of()));
        }
        if (n == STORM_SIZE) {
            for (int percent : STORMS) {
                String share = Integer.toString(percent);
                tasks.add(task(engine, n, gpu, "storm" + share, "storm", Map.of("percent", share)));
            }
        }
    }

    /** What is worth measuring: on the JVM a read is a copy within the heap, and steps in one call save nothing. */
    private List<String> modes(String engine, int n, boolean gpu) {
        if (options.quick()) {
            return List.of("steps");
        }
        if (!gpu && n >= LARGE) {
            return List.of("steps", "profiled");
        }
        if (n > LARGE) {
            return List.of("steps", "readPositions", "requestPositions", "readArray", "profiled");
        }
        if (gpu) {
            return List.of(
                    "steps", "frames", "readPositions", "requestPositions", "readArray", "readBuffer", "profiled");
        }
        return engine.equals(Engines.WORLD_JVM)
                ? List.of("steps", "readArray", "profiled")
                : List.of("steps", "frames", "readArray", "profiled");
    }

    private static Task task(
            String engine, int n, boolean gpu, String mode, String method, Map<String, String> furtherParameters) {
        Map<String, String> key = new LinkedHashMap<>();
        key.put("engine", engine);
        key.put("n", Integer.toString(n));
        key.put("mode", mode);
        Map<String, String> parameters = new LinkedHashMap<>(furtherParameters);
        parameters.put("engine", engine);
        parameters.put("n", Integer.toString(n));
        parameters.put("skipped", Integer.toString(SKIPPED));
        double guess = gpu ? 0.2 + 1e-6 * n : 0.3 + (engine.equals(Engines.WORLD_JVM) ? 4e-4 : 1e-3) * n;
        return new Task(
                ResultsFolder.Kind.WORLD,
                key,
                series(engine, mode),
                n,
                1,
                WorldBenchmark.class.getName() + "." + method,
                parameters,
                0,
                steps(n, gpu),
                guess);
    }

    /** The same for all that are compared at an n: on a CPU the largest crowds would take minutes. */
    private static int steps(int n, boolean gpu) {
        if (n < STORM_SIZE) {
            return 500;
        }
        if (n < 100_000) {
            return 200;
        }
        if (n < LARGE) {
            return 100;
        }
        return gpu ? 50 : 20;
    }

    /** The transfers of every device: as many bytes as circles that World reads, and more. */
    static List<Task> transfers(Options options, Map<String, Device> devices) {
        List<Integer> sizes =
                options.quick() ? List.of(1 << 20) : List.of(20_000, 240_000, 1 << 20, 16 << 20, 128 << 20);
        List<Task> tasks = new ArrayList<>();
        devices.forEach((name, device) -> {
            for (int bytes : sizes) {
                for (TransferBenchmark.Memory memory : TransferBenchmark.Memory.values()) {
                    tasks.add(transfer(name, "read", memory, bytes));
                }
            }
            if (!options.quick()) {
                for (TransferBenchmark.Memory memory : TransferBenchmark.Memory.values()) {
                    tasks.add(transfer(name, "write", memory, 16 << 20));
                }
            }
        });
        return tasks;
    }

    private static Task transfer(String device, String direction, TransferBenchmark.Memory memory, int bytes) {
        Map<String, String> key = new LinkedHashMap<>();
        key.put("device", device);
        key.put("direction", direction);
        key.put("memory", memory.name().toLowerCase(Locale.ROOT));
        key.put("bytes", Integer.toString(bytes));
        return new Task(
                ResultsFolder.Kind.TRANSFER,
                key,
                "transfer " + device + " " + direction + " " + memory,
                bytes,
                1,
                TransferBenchmark.class.getName() + "." + direction,
                Map.of("device", device, "memory", memory.name(), "bytes", Integer.toString(bytes)),
                0,
                bytes < 1 << 20 ? 500 : 20,
                0.02 + 2e-7 * bytes);
    }
}
