package io.github.circles2d.bench.report;

import io.github.circles2d.bench.results.Numbers;
import io.github.circles2d.bench.results.ResultsFolder;
import io.github.circles2d.bench.results.ResultsFolder.Kind;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
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

    /** The strategies of a device, n by n, with the modes that are missing where not all are; empty if nothing is. */
    static String strategies(ResultsFolder folder, String device) {
        Map<Integer, Map<String, List<String>>> modes = new TreeMap<>();
        Map<Integer, Map<String, Integer>> all = new TreeMap<>();
        for (Map<String, String> row : folder.table(Kind.STRATEGIES).rows("device", device)) {
            int n = Integer.parseInt(row.get("n"));
            all.computeIfAbsent(n, key -> new TreeMap<>()).merge(row.get("strategy"), 1, Integer::sum);
            if (is(row)) {
                modes.computeIfAbsent(n, key -> new TreeMap<>())
                        .computeIfAbsent(row.get("strategy"), key -> new ArrayList<>())
                        .add(row.get("mode"));
            }
        }
        Map<Integer, String> missing = new TreeMap<>();
        modes.forEach((n, strategies) -> missing.put(
                n,
                (strategies.size() == 1 ? "strategy " : "strategies ")
                        + strategies.entrySet().stream()
                                .map(entry -> entry.getKey()
                                        + (entry.getValue().size() == all.get(n).get(entry.getKey())
                                                ? ""
                                                : " (" + String.join(" and ", entry.getValue()) + ")"))
                                .collect(Collectors.joining(", "))));
        return list(missing);
    }

    /** The engines on a scene, n by n; empty if none is missing. */
    static String engines(ResultsFolder folder, String scene) {
        Map<Integer, String> missing = new TreeMap<>();
        for (Map<String, String> row : folder.table(Kind.PEERS).rows("scene", scene)) {
            if (is(row)) {
                missing.merge(Integer.valueOf(row.get("n")), row.get("engine"), (a, b) -> a + ", " + b);
            }
        }
        return list(missing);
    }

    /** World's runs, n by n; empty if none is missing. */
    static String world(ResultsFolder folder) {
        Map<Integer, Map<String, List<String>>> modes = new TreeMap<>();
        for (Map<String, String> row : folder.table(Kind.WORLD).rows()) {
            if (is(row)) {
                modes.computeIfAbsent(Integer.valueOf(row.get("n")), n -> new LinkedHashMap<>())
                        .computeIfAbsent(row.get("engine"), engine -> new ArrayList<>())
                        .add(row.get("mode"));
            }
        }
        Map<Integer, String> missing = new TreeMap<>();
        modes.forEach((n, engines) -> missing.put(
                n,
                engines.entrySet().stream()
                        .map(entry -> entry.getKey() + " (" + String.join(", ", entry.getValue()) + ")")
                        .collect(Collectors.joining(", "))));
        return list(missing);
    }

    /** A line for all n that lack the same. */
    private static String list(Map<Integer, String> missing) {
        Map<String, List<String>> sizes = new LinkedHashMap<>();
        missing.forEach((n, what) ->
                sizes.computeIfAbsent(what, key -> new ArrayList<>()).add(Numbers.whole(n)));
        if (sizes.isEmpty()) {
            return "";
        }
        return sizes.entrySet().stream()
                .map(entry -> "- n = " + String.join(", ", entry.getValue()) + ": " + entry.getKey() + "\n")
                .collect(Collectors.joining(
                        "", "Left out, because it would have taken longer than the sweep was given:\n\n", "\n"));
    }
}
