package io.github.circles2d.bench.measure;

import io.github.circles2d.bench.results.Numbers;
import io.github.circles2d.bench.results.ResultsFolder;
import io.github.circles2d.bench.results.ResultsFolder.Kind;
import io.github.circles2d.bench.results.Table;
import java.io.IOException;
import java.util.Comparator;
import java.util.List;
import java.util.Map;

/**
 * How near kernels and World's stages come to the memory's roof: the time in which the device copies as many bytes as they must move,
 * over their time. The copy is the measured one whose traffic is nearest to that of one pass, so that caches count alike.
 */
final class Roof {
    /** Stages whose bytes are not counted, by their columns. */
    private static final Map<String, String> OTHERS =
            Table.columns("Scan", "scan_us", "Sweep", "sweep_us", "Other", "other_us");

    /** Stages of a plan that makes whole steps in one launch. */
    private static final List<String> WHOLE_STEPS = List.of("Resident", "Other");

    private Roof() {}

    /** Writes both tables from the others of the folder. */
    static void write(ResultsFolder folder) throws IOException {
        for (Map<String, String> run : folder.table(Kind.STRATEGIES).rows("mode", "profiled", "status", "ok")) {
            double moved = PairTraffic.of(run.get("indexing"), Long.parseLong(run.get("n")))
                    .movedBytes();
            Map<String, String> copy = nearestCopy(folder, run.get("device"), moved);
            if (copy != null) {
                putKernels(folder, run, moved, copy.get("gb_per_s"));
            }
        }
        folder.clear(Kind.WORLD_STAGES);
        for (Map<String, String> run : folder.table(Kind.WORLD).rows("mode", "profiled", "status", "ok")) {
            for (WorldTraffic stage : WorldTraffic.STAGES) {
                putStage(folder, run, stage.stage(), stage.column(), stage);
            }
            for (Map.Entry<String, String> other : OTHERS.entrySet()) {
                putStage(folder, run, other.getKey(), other.getValue(), null);
            }
        }
    }

    private static Map<String, String> nearestCopy(ResultsFolder folder, String device, double bytes) {
        List<Map<String, String>> copies = folder.table(Kind.COPY).rows("device", device, "status", "ok");
        return copies.stream()
                .min(Comparator.comparingDouble(
                        copy -> Math.abs(Math.log(2.0 * Long.parseLong(copy.get("bytes")) / bytes))))
                .orElse(null);
    }

    private static void putKernels(ResultsFolder folder, Map<String, String> run, double moved, String bandwidth)
            throws IOException {
        double roof = moved / (Numbers.parse(bandwidth) * 1e6);
        double kernels = (Numbers.parse(run.get("update_us"))
                        + Numbers.parse(run.get("detect_us"))
                        + Numbers.parse(run.get("resolve_us")))
                / 1000;
        Map<String, String> row = Table.columns("device", run.get("device"), "strategy", run.get("strategy"));
        row.putAll(Table.columns("n", run.get("n"), "moved_bytes", Long.toString((long) moved)));
        row.putAll(Table.columns("copy_gb_per_s", bandwidth, "roof_ms", Numbers.exact(roof)));
        row.put("kernels_ms", Numbers.exact(kernels));
        row.put("share_of_roof", Numbers.exact(roof / kernels));
        folder.put(Kind.ROOF, row);
    }

    private static void putStage(
            ResultsFolder folder, Map<String, String> run, String name, String column, WorldTraffic stage)
            throws IOException {
        double micros = Numbers.parse(run.get(column));
        if (!(micros > 0) || !(WorldTraffic.byStages(run) || WHOLE_STEPS.contains(name))) {
            return;
        }
        String engine = run.get("engine");
        Map<String, String> row = Table.columns("engine", engine, "n", run.get("n"), "stage", name);
        row.put("time_us", Numbers.exact(micros));
        if (stage != null && engine.contains("@")) {
            double moved = stage.movedBytes(Double.parseDouble(run.get("n")), Numbers.parse(run.get("contacts")));
            Map<String, String> copy =
                    nearestCopy(folder, engine.substring(engine.indexOf('@') + 1), moved / stage.passes());
            if (copy != null) {
                double roof = moved / (Numbers.parse(copy.get("gb_per_s")) * 1e3);
                row.put("moved_bytes", Numbers.exact(moved));
                row.put("copy_gb_per_s", copy.get("gb_per_s"));
                row.put("roof_us", Numbers.exact(roof));
                row.put("share_of_roof", Numbers.exact(roof / micros));
            }
        }
        folder.put(Kind.WORLD_STAGES, row);
    }
}
