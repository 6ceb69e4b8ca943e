package io.github.circles2d.bench.report;

import io.github.circles2d.bench.results.Numbers;
import io.github.circles2d.bench.results.Table;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;

/** The tables of what joints cost, from the folder {@code joints} of the results. */
final class JointTables {
    private JointTables() {}

    /** Steps with joints by those of the same circles without; misses of what is asked are bold. Empty if the folder has no such file. */
    static String cost(Path folder) {
        StringBuilder text = new StringBuilder(
                        "| machine | case | circles | joints | contacts | of the other | ms | of the other |")
                .append(" times as long | of the shortest steps | asked |\n")
                .append("|---|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n");
        List<Map<String, String>> rows = Table.rowsOf(folder.resolve("cost.csv"), List.of("machine", "case", "n"));
        for (Map<String, String> row : rows) {
            String asked = row.get("asked_ratio");
            text.append("| ").append(row.get("machine")).append(" | ").append(row.get("case"));
            for (String number : List.of("n", "joints", "contacts", "other_contacts")) {
                text.append(" | ").append(Numbers.whole(row.get(number)));
            }
            text.append(" | ").append(Numbers.brief(row.get("ms")));
            text.append(" | ").append(Numbers.brief(row.get("other_ms")));
            text.append(" | ").append(TerrainTables.marked(row.get("ratio"), asked));
            text.append(" | ").append(row.get("ratio_of_minima"));
            text.append(" | ").append(asked).append(" |\n");
        }
        return rows.isEmpty() ? "" : text.toString();
    }

    /** Frames with more and more soft blobs; those that take too long are bold. Empty if the folder has no such file. */
    static String swarm(Path folder) {
        StringBuilder text = new StringBuilder(
                        "| machine | blobs | circles | joints | ms a frame | longest | frames a second |\n")
                .append("|---|--:|--:|--:|--:|--:|--:|\n");
        List<Map<String, String>> rows = Table.rowsOf(folder.resolve("swarm.csv"), List.of("machine", "blobs"));
        for (Map<String, String> row : rows) {
            text.append("| ").append(row.get("machine"));
            for (String number : List.of("blobs", "circles", "joints")) {
                text.append(" | ").append(Numbers.whole(row.get(number)));
            }
            text.append(" | ").append(TerrainTables.marked(row.get("ms"), "16.67"));
            text.append(" | ").append(row.get("longest_ms"));
            text.append(" | ").append(row.get("frames_a_second")).append(" |\n");
        }
        return rows.isEmpty() ? "" : text.toString();
    }
}
