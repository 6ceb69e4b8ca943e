package io.github.circles2d.calibration;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.stream.Collectors;

/**
 * All that has been measured. Immutable.
 *
 * @param entries one for each workload, variant and runner
 */
public record Timings(List<Entry> entries) {
    /** Nothing measured. */
    public static final Timings NONE = new Timings(List.of());

    /** By so much must a later candidate be faster than an earlier one: less is noise. */
    private static final double CLEARLY = 1.05;

    /**
     * One curve.
     *
     * @param workload what was timed
     * @param variant of Circles2D, the pair indexing; of World, the ratio of radii, as {@link CurvesByRatio#variant} names it
     * @param runner what it ran on
     * @param curve the times
     */
    public record Entry(Workload workload, String variant, Runner runner, Curve curve) {
        /**
         * Checks the ratio of radii.
         *
         * @param workload what was timed
         * @param variant how it was done
         * @param runner what it ran on
         * @param curve the times
         * @throws IllegalArgumentException if the workload is World and the variant is no ratio of radii
         */
        public Entry {
            if (workload == Workload.WORLD) {
                CurvesByRatio.ratio(variant);
            }
        }

        private boolean replaces(Entry other) {
            return workload == other.workload
                    && variant.equals(other.variant)
                    && runner.name().equals(other.runner.name());
        }
    }

    /**
     * Copies the list.
     *
     * @param entries one for each workload, variant and runner
     */
    public Timings {
        entries = List.copyOf(entries);
    }

    /**
     * Finds a curve.
     *
     * @param workload what was timed
     * @param variant how it was done; empty where there is one way
     * @param runner what it ran on, in that very version
     * @return the curve, if it was measured
     */
    public Optional<Curve> find(Workload workload, String variant, Runner runner) {
        return entries.stream()
                .filter(entry ->
                        entry.workload == workload && entry.variant.equals(variant) && entry.runner.equals(runner))
                .map(Entry::curve)
                .findFirst();
    }

    /**
     * Finds the times of World on a runner.
     *
     * @param runner what it ran on, in that very version
     * @return the times, if at least those of like radii were measured
     */
    public Optional<CurvesByRatio> world(Runner runner) {
        Map<Double, Curve> curves = new TreeMap<>();
        for (Entry entry : entries) {
            if (entry.workload == Workload.WORLD && entry.runner.equals(runner)) {
                curves.putIfAbsent(CurvesByRatio.ratio(entry.variant), entry.curve);
            }
        }
        return curves.containsKey(Crowd.LIKE) ? Optional.of(new CurvesByRatio(curves)) : Optional.empty();
    }

    /**
     * Returns the times of World on all runners.
     *
     * @return the times of each of which at least those of like radii were measured
     */
    public List<CurvesByRatio> worlds() {
        return entries.stream()
                .map(Entry::runner)
                .distinct()
                .flatMap(runner -> world(runner).stream())
                .toList();
    }

    /**
     * Adds newer timings. They replace those of the same runners, also of other versions of them.
     *
     * @param newer what was measured later
     * @return both
     */
    public Timings and(Timings newer) {
        List<Entry> all = new ArrayList<>(entries);
        all.removeIf(old -> newer.entries.stream().anyMatch(entry -> entry.replaces(old)));
        all.addAll(newer.entries);
        return new Timings(all);
    }

    /**
     * Leaves out what a workload took on a runner, in any version of it.
     *
     * @param workload what was timed
     * @param runner the runner's name
     * @return the others
     */
    public Timings without(Workload workload, String runner) {
        return new Timings(entries.stream()
                .filter(entry ->
                        entry.workload != workload || !entry.runner.name().equals(runner))
                .toList());
    }

    /**
     * Picks the candidate that takes the least time; of those within 5 % of it, the first.
     *
     * @param candidates their curves, the preferred ones first; not empty
     * @param circles number of circles
     * @param <T> a candidate
     * @return one of them
     */
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

    /**
     * Says what {@link #fastest} decides by.
     *
     * @param candidates their curves
     * @param crowd whose times they are
     * @param name how to call a candidate
     * @param <T> a candidate
     * @return the times in words
     */
    public static <T> String words(Map<T, Curve> candidates, Crowd crowd, Function<T, String> name) {
        return candidates.entrySet().stream()
                .map(candidate -> String.format(
                        Locale.ROOT,
                        "%s %.3g",
                        name.apply(candidate.getKey()),
                        candidate.getValue().millis(crowd.circles())))
                .collect(Collectors.joining(", ", "by calibration, ms a frame of " + crowd + ": ", ""));
    }
}
