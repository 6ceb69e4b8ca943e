package io.github.circles2d.bench.report;

import io.github.circles2d.bench.results.Numbers;
import io.github.circles2d.bench.results.ResultsFolder;
import io.github.circles2d.bench.results.ResultsFolder.Kind;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.stream.Collectors;

/** What a sweep left out, for want of time, in few lines. */
final class LeftOut {
    private LeftOut() {}

    /** Whether a row has no figure because its run would have taken too long. */
    static boolean is(Map<String, String> row) {
        return row.get("status").startsWith("left out");
    }

    /** Whether a row has no figure because a smaller size of the same did not fit into the memory. */
    static boolean followsFromASmallerSize(Map<String, String> row) {
        return row.get("status").equals(ResultsFolder.SMALLER_DOES_NOT_FIT);
    }

    /** The strategies of a device, with the modes that are missing if not all are; empty if nothing is. */
    static String strategies(ResultsFolder folder, String device) {
        return list(folder.table(Kind.STRATEGIES).rows("device", device), "strategy", missing -> {
            String what = missing.entrySet().stream()
                    .sorted(Map.Entry.comparingByKey())
                    .map(entry -> entry.getKey() + modes(entry.getValue(), " and ", folder, device))
                    .collect(Collectors.joining(", "));
            return (missing.size() == 1 ? "strategy " : "strategies ") + what;
        });
    }

    /** The modes of the rows of a strategy that are missing, or nothing if there are no others. */
    private static String modes(List<Map<String, String>> rows, String and, ResultsFolder folder, String device) {
        String n = rows.get(0).get("n");
        String strategy = rows.get(0).get("strategy");
        int all = folder.table(Kind.STRATEGIES)
                .rows("device", device, "n", n, "strategy", strategy)
                .size();
        return rows.size() == all ? "" : " (" + modes(rows, and) + ")";
    }

    private static String modes(List<Map<String, String>> rows, String and) {
        return rows.stream().map(row -> row.get("mode")).collect(Collectors.joining(and));
    }

    /** The engines on a scene; empty if none is missing. */
    static String engines(ResultsFolder folder, String scene) {
        return list(
                folder.table(Kind.PEERS).rows("scene", scene),
                "engine",
                missing -> String.join(", ", missing.keySet()));
    }

    /** World's runs; empty if none is missing. */
    static String world(ResultsFolder folder) {
        return list(folder.table(Kind.WORLD).rows(), "engine", missing -> missing.entrySet().stream()
                .map(entry -> entry.getKey() + " (" + modes(entry.getValue(), ", ") + ")")
                .collect(Collectors.joining(", ")));
    }

    /** A line for all n that lack the same, in the words for the rows of an n that are missing, by a column. */
    private static String list(
            List<Map<String, String>> rows,
            String column,
            Function<Map<String, List<Map<String, String>>>, String> words) {
        Map<Integer, Map<String, List<Map<String, String>>>> missing = rows.stream()
                .filter(LeftOut::is)
                .collect(Collectors.groupingBy(
                        row -> Integer.valueOf(row.get("n")),
                        TreeMap::new,
                        Collectors.groupingBy(row -> row.get(column), LinkedHashMap::new, Collectors.toList())));
        Map<String, List<String>> sizes = new LinkedHashMap<>();
        missing.forEach((n, what) -> sizes.computeIfAbsent(words.apply(what), key -> new ArrayList<>())
                .add(Numbers.whole(n)));
        String lines = sizes.entrySet().stream()
                .map(entry -> "- n = " + String.join(", ", entry.getValue()) + ": " + entry.getKey() + "\n")
                .collect(Collectors.joining());
        return lines.isEmpty()
                ? ""
                : "Left out, because it would have taken longer than the sweep was given:\n\n" + lines + "\n";
    }
}
