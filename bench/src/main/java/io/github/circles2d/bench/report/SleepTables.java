package io.github.circles2d.bench.report;

import io.github.circles2d.bench.results.Numbers;
import io.github.circles2d.bench.results.Table;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;

/** The table of what circles cost that sleep or are static, from the folder {@code sleep} of the results. */
final class SleepTables {
    private SleepTables() {}

    /** Steps of the two worlds of each scene, and of Box2D where it made them. Empty if the folder has no such file. */
    static String cost(Path folder) {
        StringBuilder text = new StringBuilder("| machine | scene | n | awake | µs without | µs with ")
                .append("| Box2D v3 without sleep | Box2D v3 with sleep |\n|---|---|--:|--:|--:|--:|--:|--:|\n");
        List<Map<String, String>> rows = Table.rowsOf(folder.resolve("cost.csv"), List.of("machine", "scene", "n"));
        for (Map<String, String> row : rows) {
            text.append("| ").append(row.get("machine")).append(" | ").append(row.get("scene"));
            text.append(" | ")
                    .append(Numbers.whole(row.get("n")))
                    .append(" | ")
                    .append(Numbers.whole(row.get("awake")));
            for (String column : List.of("without_us", "with_us", "box2d_without_us", "box2d_with_us")) {
                text.append(" | ").append(row.get(column));
            }
            text.append(" |\n");
        }
        return rows.isEmpty() ? "" : text.toString();
    }
}
