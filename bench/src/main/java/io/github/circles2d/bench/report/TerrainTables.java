package io.github.circles2d.bench.report;

import io.github.circles2d.bench.results.Numbers;
import io.github.circles2d.bench.results.Table;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;

/** The tables of what terrain costs, from the folder {@code terrain} of the results. */
final class TerrainTables {
    private TerrainTables() {}

    /** Steps with terrain by those of what it is compared with; misses of what is asked are bold. Empty if the folder has no such file. */
    static String cost(Path folder) {
        StringBuilder text = new StringBuilder(
                        "| machine | case | circles | pieces | contacts | of the other | ms | of the other |")
                .append(" times as long | of the shortest steps | ms more | asked |\n")
                .append("|---|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|---|\n");
        List<Map<String, String>> rows = Table.rowsOf(folder.resolve("cost.csv"), List.of("machine", "case", "n"));
        for (Map<String, String> row : rows) {
            String askedRatio = row.get("asked_ratio");
            String askedMore = row.get("asked_more_ms");
            text.append("| ").append(row.get("machine")).append(" | ").append(row.get("case"));
            for (String number : List.of("n", "pieces", "contacts", "other_contacts")) {
                text.append(" | ").append(Numbers.whole(row.get(number)));
            }
            text.append(" | ").append(Numbers.brief(row.get("ms")));
            text.append(" | ").append(Numbers.brief(row.get("other_ms")));
            text.append(" | ").append(marked(row.get("ratio"), askedRatio));
            text.append(" | ").append(row.get("ratio_of_minima"));
            text.append(" | ").append(marked(row.get("more_ms"), askedMore));
            text.append(" | ").append(askedRatio.isEmpty() ? askedMore + " ms more" : askedRatio + " times");
            text.append(" |\n");
        }
        return rows.isEmpty() ? "" : text.toString();
    }

    /** World beside Box2D v3 on the same levels; misses are bold. Empty if the folder has no such file. */
    static String engines(Path folder) {
        StringBuilder text = new StringBuilder(
                        "| level | circles | Box2D v3, ms | World before, ms | World on the JVM, ms | World is faster by | asked |\n")
                .append("|---|--:|--:|--:|--:|--:|--:|\n");
        List<Map<String, String>> rows = Table.rowsOf(folder.resolve("engines.csv"), List.of("level", "n"));
        for (Map<String, String> row : rows) {
            double factor = Numbers.parse(row.get("box2d_ms")) / Numbers.parse(row.get("world_ms"));
            String shown = Numbers.brief(factor);
            text.append("| ").append(row.get("level"));
            text.append(" | ").append(Numbers.whole(row.get("n")));
            text.append(" | ").append(Numbers.brief(row.get("box2d_ms")));
            text.append(" | ").append(Numbers.brief(row.get("before_ms")));
            text.append(" | ").append(Numbers.brief(row.get("world_ms")));
            text.append(" | ").append(factor < Numbers.parse(row.get("asked")) ? "**" + shown + "**" : shown);
            text.append(" | ").append(row.get("asked"));
            text.append(" |\n");
        }
        return rows.isEmpty() ? "" : text.toString();
    }

    /** A number, bold if it is greater than it may be. */
    static String marked(String number, String most) {
        return Numbers.parse(number) > Numbers.parse(most) ? "**" + number + "**" : number;
    }
}
