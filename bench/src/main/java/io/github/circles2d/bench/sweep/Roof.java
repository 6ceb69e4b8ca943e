package io.github.circles2d.bench.sweep;

import io.github.circles2d.bench.results.Numbers;
import io.github.circles2d.bench.results.ResultsFolder;
import java.io.IOException;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * How near the kernels come to the memory's roof: the time in which the device copies as many bytes as a step must move,
 * over the kernels' time. The copy is the measured one whose traffic is nearest, so that caches count alike.
 */
final class Roof {
    private Roof() {}

    /** Writes the roof's table from the others of the folder. */
    static void write(ResultsFolder folder) throws IOException {
        for (Map<String, String> run :
                folder.table(ResultsFolder.Kind.STRATEGIES).rows("mode", "profiled", "status", "ok")) {
            List<Map<String, String>> copies =
                    folder.table(ResultsFolder.Kind.COPY).rows("device", run.get("device"), "status", "ok");
            if (!copies.isEmpty()) {
                folder.put(ResultsFolder.Kind.ROOF, row(run, copies));
            }
        }
    }

    private static Map<String, String> row(Map<String, String> run, List<Map<String, String>> copies) {
        long n = Long.parseLong(run.get("n"));
        long moved = PairTraffic.of(run.get("indexing"), n).movedBytes();
        Map<String, String> copy = copies.stream()
                .min(Comparator.comparingDouble(
                        row -> Math.abs(Math.log(2.0 * Long.parseLong(row.get("bytes")) / moved))))
                .orElseThrow();
        double roof = moved / (Numbers.parse(copy.get("gb_per_s")) * 1e6);
        double kernels = (Numbers.parse(run.get("update_us"))
                        + Numbers.parse(run.get("detect_us"))
                        + Numbers.parse(run.get("resolve_us")))
                / 1000;
        Map<String, String> row = new LinkedHashMap<>();
        row.put("device", run.get("device"));
        row.put("strategy", run.get("strategy"));
        row.put("n", run.get("n"));
        row.put("moved_bytes", Long.toString(moved));
        row.put("copy_gb_per_s", copy.get("gb_per_s"));
        row.put("roof_ms", Numbers.exact(roof));
        row.put("kernels_ms", Numbers.exact(kernels));
        row.put("share_of_roof", Numbers.exact(roof / kernels));
        return row;
    }
}
