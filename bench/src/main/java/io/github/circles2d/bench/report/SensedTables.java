package io.github.circles2d.bench.report;

import io.github.circles2d.bench.results.Numbers;
import io.github.circles2d.bench.results.Table;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;

/** The table of what sensed pairs cost, from the folder {@code events} of the results. */
final class SensedTables {
    private SensedTables() {}

    /** Steps that report by silent ones; misses of what is asked are bold. Empty if the folder has no such file. */
    static String cost(Path folder) {
        StringBuilder text = new StringBuilder(
                        "| machine | case | grains | larger circles | silent, ms | reporting, ms |")
                .append(" times as long | of the shortest steps | asked |\n|---|---|--:|--:|--:|--:|--:|--:|--:|\n");
        List<Map<String, String>> rows = Table.rowsOf(folder.resolve("sensed.csv"), List.of("machine", "case", "n"));
        for (Map<String, String> row : rows) {
            String asked = row.get("asked");
            text.append("| ").append(row.get("machine")).append(" | ").append(row.get("case"));
            text.append(" | ").append(Numbers.whole(row.get("n")));
            text.append(" | ").append(Numbers.whole(row.get("others")));
            text.append(" | ").append(Numbers.brief(row.get("silent_ms")));
            text.append(" | ").append(Numbers.brief(row.get("reporting_ms")));
            text.append(" | ").append(TerrainTables.marked(row.get("ratio"), asked));
            text.append(" | ").append(row.get("ratio_of_minima"));
            text.append(" | ").append(asked).append(" |\n");
        }
        return rows.isEmpty() ? "" : text.toString();
    }
}
