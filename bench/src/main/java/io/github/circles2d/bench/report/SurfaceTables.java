package io.github.circles2d.bench.report;

import io.github.circles2d.bench.results.Numbers;
import io.github.circles2d.bench.results.Table;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;

/** The tables of what surfaces cost, from the folder {@code surfaces} of the results. */
final class SurfaceTables {
    private SurfaceTables() {}

    /** Steps with friction by steps without; misses of what is asked are bold. Empty if the folder has no such file. */
    static String cost(Path folder) {
        StringBuilder text = new StringBuilder(
                        "| machine | radii | n | µs without | µs with friction | times as long |")
                .append(" of the shortest steps | with rolling resistance, too |\n|---|---|--:|--:|--:|--:|--:|--:|\n");
        List<Map<String, String>> rows = Table.rowsOf(folder.resolve("cost.csv"), List.of("machine", "radii", "n"));
        for (Map<String, String> row : rows) {
            String ratio = row.get("friction_ratio");
            boolean misses = Numbers.parse(ratio) > Numbers.parse(row.get("asked"));
            text.append("| ").append(row.get("machine")).append(" | ").append(row.get("radii"));
            text.append(" | ").append(Numbers.whole(row.get("n")));
            text.append(" | ").append(whole(row.get("without_us")));
            text.append(" | ").append(whole(row.get("friction_us")));
            text.append(" | ").append(misses ? "**" + ratio + "**" : ratio);
            text.append(" | ").append(row.get("friction_ratio_of_minima"));
            text.append(" | ").append(row.get("rolling_ratio")).append(" |\n");
        }
        return rows.isEmpty() ? "" : text.toString();
    }

    /** World beside Box2D v3, both with friction. Empty if the folder has no such file. */
    static String engines(Path folder) {
        StringBuilder text = new StringBuilder(
                "| n | Box2D v3, ms | World on the JVM, ms | World is faster by |\n|--:|--:|--:|--:|\n");
        List<Map<String, String>> rows = Table.rowsOf(folder.resolve("engines.csv"), List.of("n"));
        for (Map<String, String> row : rows) {
            double factor = Numbers.parse(row.get("box2d_ms")) / Numbers.parse(row.get("world_ms"));
            text.append("| ").append(Numbers.whole(row.get("n")));
            text.append(" | ").append(row.get("box2d_ms"));
            text.append(" | ").append(row.get("world_ms"));
            text.append(" | ").append(Numbers.brief(factor)).append(" |\n");
        }
        return rows.isEmpty() ? "" : text.toString();
    }

    private static String whole(String number) {
        return number.isEmpty() ? "" : Numbers.whole(number);
    }
}
