package io.github.circles2d.bench.report;

import io.github.circles2d.bench.results.Numbers;
import io.github.circles2d.bench.results.Table;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;

/** The table of steps beside other work, from the folder {@code busy} of the results. */
final class BusyTables {
    private BusyTables() {}

    /** Steps with the default number of threads by those with one; misses of what is asked are bold. Empty if the folder has no such file. */
    static String steps(Path folder) {
        StringBuilder text = new StringBuilder(
                        "| n | beside | one thread, ms | default, ms | times as long | in the worst round |")
                .append(" mean of one thread, ms | mean of the default, ms | asked |\n")
                .append("|--:|---|--:|--:|--:|--:|--:|--:|--:|\n");
        List<Map<String, String>> rows = Table.rowsOf(folder.resolve("steps.csv"), List.of("n", "beside"));
        for (Map<String, String> row : rows) {
            String asked = row.get("asked");
            text.append("| ").append(Numbers.whole(row.get("n")));
            text.append(" | ").append(row.get("beside"));
            text.append(" | ").append(Numbers.brief(row.get("one_ms")));
            text.append(" | ").append(Numbers.brief(row.get("default_ms")));
            text.append(" | ").append(TerrainTables.marked(row.get("ratio"), asked));
            text.append(" | ").append(row.get("worst_ratio"));
            text.append(" | ").append(Numbers.brief(row.get("one_mean_ms")));
            text.append(" | ").append(Numbers.brief(row.get("default_mean_ms")));
            text.append(" | ").append(asked).append(" |\n");
        }
        return rows.isEmpty() ? "" : text.toString();
    }
}
