package io.github.circles2d.bench.sweep;

import io.github.circles2d.bench.results.Numbers;
import io.github.circles2d.bench.results.ResultsFolder;
import java.io.IOException;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * How near the stages of World on a device come to the memory's roof: the time in which the device copies as many bytes as the
 * stage must move ({@link WorldTraffic}), over the stage's time. The copy is the measured one whose traffic is nearest to that
 * of one pass, so that caches count alike.
 */
final class WorldRoof {
    private static final List<String> OTHERS = List.of("scan_us", "sweep_us", "other_us");

    private WorldRoof() {}

    /** Writes the table of the stages from the others of the folder. */
    static void write(ResultsFolder folder) throws IOException {
        folder.clear(ResultsFolder.Kind.WORLD_STAGES);
        for (Map<String, String> run :
                folder.table(ResultsFolder.Kind.WORLD).rows("mode", "profiled", "status", "ok")) {
            String engine = run.get("engine");
            List<Map<String, String>> copies = engine.contains("@")
                    ? folder.table(ResultsFolder.Kind.COPY)
                            .rows("device", engine.substring(engine.indexOf('@') + 1), "status", "ok")
                    : List.of();
            for (WorldTraffic stage : WorldTraffic.STAGES) {
                put(folder, run, stage.stage(), stage.column(), stage, copies);
            }
            for (String column : OTHERS) {
                String name =
                        column.substring(0, 1).toUpperCase(Locale.ROOT) + column.substring(1, column.indexOf('_'));
                put(folder, run, name, column, null, List.of());
            }
        }
    }

    private static void put(
            ResultsFolder folder,
            Map<String, String> run,
            String name,
            String column,
            WorldTraffic stage,
            List<Map<String, String>> copies)
            throws IOException {
        double micros = Numbers.parse(run.get(column));
        if (!(micros > 0)) {
            return;
        }
        Map<String, String> row = new LinkedHashMap<>();
        row.put("engine", run.get("engine"));
        row.put("n", run.get("n"));
        row.put("stage", name);
        row.put("time_us", Numbers.exact(micros));
        if (stage != null && !copies.isEmpty()) {
            double moved = stage.movedBytes(Double.parseDouble(run.get("n")), Numbers.parse(run.get("contacts")));
            double pass = moved / stage.passes();
            Map<String, String> copy = copies.stream()
                    .min(Comparator.comparingDouble(
                            c -> Math.abs(Math.log(2.0 * Long.parseLong(c.get("bytes")) / pass))))
                    .orElseThrow();
            double roof = moved / (Numbers.parse(copy.get("gb_per_s")) * 1e3);
            row.put("moved_bytes", Numbers.exact(moved));
            row.put("copy_gb_per_s", copy.get("gb_per_s"));
            row.put("roof_us", Numbers.exact(roof));
            row.put("share_of_roof", Numbers.exact(roof / micros));
        }
        folder.put(ResultsFolder.Kind.WORLD_STAGES, row);
    }
}
