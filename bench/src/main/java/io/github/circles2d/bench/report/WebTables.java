package io.github.circles2d.bench.report;

import io.github.circles2d.bench.results.Numbers;
import io.github.circles2d.bench.results.ResultsFolder;
import io.github.circles2d.bench.results.ResultsFolder.Kind;
import io.github.circles2d.bench.results.Table;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;

/** World on the JVM and in WebAssembly beside engines for JavaScript. */
final class WebTables {
    static final String WORLD = "world";

    private static final String NO_FIGURE = "-";

    private WebTables() {}

    /** Engine and what it runs in, of each that has rows. */
    static List<Map<String, String>> entrants(ResultsFolder folder) {
        return folder.table(Kind.WEB).rows().stream()
                .map(row -> Table.columns("engine", row.get("engine"), "runs_in", row.get("runs_in")))
                .distinct()
                .toList();
    }

    /** The median step, and the depth that is left; of a run that was given up, about what a step took. */
    static Grid steps(ResultsFolder folder) {
        List<String> header = new ArrayList<>(List.of("engine", "in"));
        List<Integer> sizes = sizes(folder);
        for (String what : List.of("µs", "depth")) {
            sizes.forEach(n -> header.add(what + ", n = " + Numbers.whole(n)));
        }
        Grid grid = Grid.ofNumbers(header.toArray(new String[0]));
        for (Map<String, String> who : entrants(folder)) {
            List<String> cells = new ArrayList<>(who.values());
            sizes.forEach(n -> cells.add(micros(run(folder, who, n))));
            sizes.forEach(n -> cells.add(depth(run(folder, who, n))));
            grid.add(cells);
        }
        return grid;
    }

    /** Each median as a multiple of that of World on the JVM. */
    static Grid ratios(ResultsFolder folder) {
        List<String> header = new ArrayList<>(List.of("engine", "in"));
        List<Integer> sizes = sizes(folder);
        sizes.forEach(n -> header.add("n = " + Numbers.whole(n)));
        Grid grid = Grid.ofNumbers(header.toArray(new String[0]));
        Map<String, String> jvm = Table.columns("engine", WORLD, "runs_in", "JVM");
        for (Map<String, String> who : entrants(folder)) {
            List<String> cells = new ArrayList<>(who.values());
            sizes.forEach(n -> cells.add(ratio(run(folder, who, n), run(folder, jvm, n))));
            if (!who.equals(jvm)) {
                grid.add(cells);
            }
        }
        return grid;
    }

    /** What each engine ran in, with versions. */
    static String programs(ResultsFolder folder) {
        return entrants(folder).stream()
                .map(who -> folder.table(Kind.WEB)
                        .row("engine", who.get("engine"), "runs_in", who.get("runs_in"))
                        .get("remarks"))
                .distinct()
                .collect(Collectors.joining(", "));
    }

    private static List<Integer> sizes(ResultsFolder folder) {
        return folder.table(Kind.WEB).values("n").stream()
                .map(Integer::valueOf)
                .sorted()
                .toList();
    }

    private static Map<String, String> run(ResultsFolder folder, Map<String, String> who, int n) {
        return folder.table(Kind.WEB)
                .row("engine", who.get("engine"), "runs_in", who.get("runs_in"), "n", Integer.toString(n));
    }

    private static String micros(Map<String, String> run) {
        if (Tables.ok(run)) {
            return Numbers.brief(run.get("median_us"));
        }
        return run == null ? NO_FIGURE : "about " + Numbers.brief(run.get("mean_us"));
    }

    private static String depth(Map<String, String> run) {
        if (!Tables.ok(run)) {
            return NO_FIGURE;
        }
        String outside = run.get("outside");
        return Numbers.brief(run.get("mean_depth"))
                + (outside.equals("0") ? "" : ", " + Numbers.whole(outside) + " outside");
    }

    private static String ratio(Map<String, String> run, Map<String, String> jvm) {
        if (!Tables.ok(run) || !Tables.ok(jvm)) {
            return NO_FIGURE;
        }
        double ratio = Numbers.parse(run.get("median_us")) / Numbers.parse(jvm.get("median_us"));
        return String.format(Locale.ROOT, ratio < 9.95 ? "%.2f" : "%.0f", ratio);
    }
}
