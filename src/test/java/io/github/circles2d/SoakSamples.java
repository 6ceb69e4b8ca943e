package io.github.circles2d;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.MemoryUsage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/**
 * What a process holds, sample by sample, and whether it grows. Of what goes up and down, the least of the last third is
 * compared with the least of the first third, after a sixth of all samples for the process to warm up in.
 */
final class SoakSamples {
    static final String HEADER =
            "minutes,steps,heap used,heap committed,resident,threads,descriptors,engine bytes,engines";

    /** What may grow by this much, besides a twentieth of itself, before it counts as growth. */
    private enum Column {
        HEAP_USED(4 << 20),
        HEAP_COMMITTED(Long.MAX_VALUE / 2), // for people: the collector takes what it is given
        RESIDENT(16 << 20),
        THREADS(2),
        DESCRIPTORS(2),
        ENGINE_BYTES(1 << 20);

        private final long slack;

        Column(long slack) {
            this.slack = slack;
        }
    }

    private final List<long[]> samples = new ArrayList<>();

    /** Takes a sample after a garbage collection, and returns it as a part of a line. */
    String take(long engineBytes, long engines) throws IOException {
        System.gc();
        MemoryUsage heap = ManagementFactory.getMemoryMXBean().getHeapMemoryUsage();
        long[] sample = {
            heap.getUsed(),
            heap.getCommitted(),
            1024 * status("VmRSS:"),
            status("Threads:"),
            files("/proc/self/fd"),
            engineBytes
        };
        add(sample);
        StringBuilder line = new StringBuilder();
        for (long value : sample) {
            line.append(value).append(',');
        }
        return line.append(engines).toString();
    }

    /** Adds a sample, a number for each column. */
    void add(long... sample) {
        samples.add(sample);
    }

    /** Names what has grown, with its figures; empty if nothing has. */
    List<String> growth() {
        List<long[]> warm = samples.subList(samples.size() / 6, samples.size());
        int third = warm.size() / 3;
        List<String> grown = new ArrayList<>();
        for (Column column : Column.values()) {
            long first = least(warm.subList(0, third), column);
            long last = least(warm.subList(warm.size() - third, warm.size()), column);
            if (last > first + first / 20 + column.slack) {
                grown.add(column + " has grown from " + first + " to " + last);
            }
        }
        return grown;
    }

    private static long least(List<long[]> samples, Column column) {
        return samples.stream()
                .mapToLong(sample -> sample[column.ordinal()])
                .min()
                .orElseThrow();
    }

    /** A number of this process that Linux knows; 0 elsewhere. */
    private static long status(String name) throws IOException {
        Path file = Path.of("/proc/self/status");
        if (!Files.exists(file)) {
            return 0;
        }
        try (Stream<String> lines = Files.lines(file)) {
            return lines.filter(line -> line.startsWith(name))
                    .mapToLong(line -> Long.parseLong(line.replaceAll("\\D", "")))
                    .findFirst()
                    .orElse(0);
        }
    }

    private static long files(String folder) throws IOException {
        if (!Files.exists(Path.of(folder))) {
            return 0;
        }
        try (Stream<Path> files = Files.list(Path.of(folder))) {
            return files.count();
        }
    }
}
