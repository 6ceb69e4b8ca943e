package io.github.circles2d;

import io.github.circles2d.calibration.Curve;
import io.github.circles2d.calibration.Timings;
import io.github.circles2d.opencl.Device;
import java.io.UncheckedIOException;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;

/**
 * What {@link PairIndexing#AUTO} stands for, and why.
 *
 * @param indexing the indexing, never AUTO and never COMPUTED
 * @param reason why it was taken
 */
record IndexingChoice(PairIndexing indexing, String reason) {
    /** The indexings that are right for every slot; what needs no table first, for it starts sooner and fits more often. */
    static final List<PairIndexing> CANDIDATES =
            List.of(PairIndexing.EXACT, PairIndexing.ROW_SEARCH, PairIndexing.LOOKUP_TABLE);

    /** Takes the fastest on a device, among those that fit into its memory. */
    static IndexingChoice of(Device device, int circles, Predicate<PairIndexing> fits) {
        Timings timings = Calibration.timings();
        Map<PairIndexing, Curve> measured = new LinkedHashMap<>();
        if (!timings.entries().isEmpty()) {
            try {
                for (PairIndexing indexing : CANDIDATES) {
                    timings.find(indexing.name(), Runners.circles2d(device, indexing))
                            .ifPresent(curve -> measured.put(indexing, curve));
                }
            } catch (IllegalArgumentException | UncheckedIOException e) {
                measured.clear(); // Kernels that cannot be read: init says so.
            }
        }
        return of(measured, device.kind(), circles, fits);
    }

    /** Takes the fastest of those that were measured and fit; by the rule where not every one that fits was measured. */
    static IndexingChoice of(
            Map<PairIndexing, Curve> measured, Device.Kind kind, int circles, Predicate<PairIndexing> fits) {
        List<PairIndexing> fitting = CANDIDATES.stream().filter(fits).toList();
        if (fitting.isEmpty()) {
            return new IndexingChoice(PairIndexing.EXACT, "no other needs less memory");
        }
        if (!measured.keySet().containsAll(fitting)) {
            return byRule(kind, fits);
        }
        Map<PairIndexing, Curve> candidates = new LinkedHashMap<>();
        fitting.forEach(indexing -> candidates.put(indexing, measured.get(indexing)));
        return new IndexingChoice(
                Timings.fastest(candidates, circles), Timings.words(candidates, circles, PairIndexing::name));
    }

    /**
     * On CPUs of 2 and 16 cores a loop with the table takes 0.4 to 0.6 of the time that it takes with any formula, at every size.
     * On an NVIDIA H200, where the table is one thing more to read, it takes 1.1 to 1.4 times as long.
     */
    private static IndexingChoice byRule(Device.Kind kind, Predicate<PairIndexing> fits) {
        String because = "; not calibrated: Calibration.run() would measure it";
        if (kind != Device.Kind.CPU) {
            return new IndexingChoice(PairIndexing.EXACT, "the fastest on most GPUs" + because);
        }
        return fits.test(PairIndexing.LOOKUP_TABLE)
                ? new IndexingChoice(PairIndexing.LOOKUP_TABLE, "the fastest on most CPUs" + because)
                : new IndexingChoice(PairIndexing.EXACT, "the table of pairs does not fit" + because);
    }
}
