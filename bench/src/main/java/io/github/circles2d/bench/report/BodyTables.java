package io.github.circles2d.bench.report;

import io.github.circles2d.bench.results.Numbers;
import io.github.circles2d.bench.results.Table;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;

/** The table of what bodies cost that are pushed, from the folder {@code bodies} of the results. */
final class BodyTables {
    private BodyTables() {}

    /** Steps of World and of Box2D. Empty if the folder has no such file. */
    static String cost(Path folder) {
        return table(folder.resolve("cost.csv"), "World on the JVM", "ms", "Box2D v3", "box2d_ms");
    }

    /** Steps on the JVM and on a GPU. Empty if the folder has no such file. */
    static String devices(Path folder) {
        return table(folder.resolve("device.csv"), "JVM", "jvm_ms", "GPU", "device_ms");
    }

    private static String table(Path file, String one, String columnOfOne, String other, String columnOfOther) {
        StringBuilder text = new StringBuilder("| scene | bodies | circles | ")
                .append(one)
                .append(", ms | ")
                .append(other)
                .append(", ms |\n|---|--:|--:|--:|--:|\n");
        List<Map<String, String>> rows = Table.rowsOf(file, List.of("scene"));
        for (Map<String, String> row : rows) {
            text.append("| ").append(row.get("scene"));
            for (String column : List.of("bodies", "circles")) {
                text.append(" | ").append(Numbers.whole(row.get(column)));
            }
            for (String column : List.of(columnOfOne, columnOfOther)) {
                text.append(" | ").append(row.get(column));
            }
            text.append(" |\n");
        }
        return rows.isEmpty() ? "" : text.toString();
    }
}
