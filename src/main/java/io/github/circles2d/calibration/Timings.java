package io.github.circles2d.calibration;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;

/** All that has been measured: an entry for each indexing and runner. Immutable. */
public record Timings(List<Entry> entries) {
    /** Nothing measured. */
    public static final Timings NONE = new Timings(List.of());

    /** By so much must a later candidate be faster than an earlier one: less is noise. */
    private static final double CLEARLY = 1.05;

    /** The times of an indexing, by its name, on a runner. */
    public record Entry(String indexing, Runner runner, Curve curve) {
        private boolean replaces(Entry other) {
            return indexing.equals(other.indexing) && runner.name().equals(other.runner.name());
        }
    }

    /** Copies the list. */
    public Timings {
        entries = List.copyOf(entries);
    }

    /** The curve of an indexing on a runner, in that very version, if it was measured. */
    public Optional<Curve> find(String indexing, Runner runner) {
        return entries.stream()
                .filter(entry -> entry.indexing.equals(indexing) && entry.runner.equals(runner))
                .map(Entry::curve)
                .findFirst();
    }

    /** Adds newer timings. They replace those of the same runners, also of other versions of them. */
    public Timings and(Timings newer) {
        List<Entry> all = new ArrayList<>(entries);
        all.removeIf(old -> newer.entries.stream().anyMatch(entry -> entry.replaces(old)));
        all.addAll(newer.entries);
        return new Timings(all);
    }

    /** The candidate that takes the least time; of those within 5 % of it, the first. There must be some. */
    public static <T> T fastest(Map<T, Curve> candidates, int circles) {
        double least = candidates.values().stream()
                .mapToDouble(curve -> curve.millis(circles))
                .min()
                .orElseThrow();
        return candidates.entrySet().stream()
                .filter(candidate -> candidate.getValue().millis(circles) <= CLEARLY * least)
                .findFirst()
                .orElseThrow()
                .getKey();
    }

    /** Says in words what {@link #fastest} decides by. */
    public static <T> String words(Map<T, Curve> candidates, int circles, Function<T, String> name) {
        return candidates.entrySet().stream()
                .map(candidate -> String.format(
                        Locale.ROOT,
                        "%s %.3g",
                        name.apply(candidate.getKey()),
                        candidate.getValue().millis(circles)))
                .collect(Collectors.joining(", ", "by calibration, ms a loop of " + circles + " circles: ", ""));
    }

    /**
     * What loops ran on, in two lines: the device and how it was used, and everything else that its speed depends on, such
     * as driver, kernels and library. Figures of one version say nothing of another.
     */
    public record Runner(String name, String version) {
        /** Makes both fit into a field of the file. */
        public Runner {
            name = oneLine(name);
            version = oneLine(version);
        }

        private static String oneLine(String text) {
            return text.replaceAll("\\s+", " ").trim();
        }
    }
}
