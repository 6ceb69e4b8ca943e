package io.github.circles2d.bench.report;

import io.github.circles2d.bench.engines.Engines;
import io.github.circles2d.bench.measure.Contender;
import io.github.circles2d.bench.measure.Outside;
import io.github.circles2d.bench.measure.Series;
import io.github.circles2d.bench.results.Numbers;
import io.github.circles2d.bench.results.ResultsFolder;
import io.github.circles2d.bench.results.ResultsFolder.Kind;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.BiPredicate;
import java.util.stream.Collectors;

/** World and other engines, series by series. What has no figure yet has its place all the same. */
final class SeriesTables {
    /** Box2D 3 in C: Maven does not have it, so its figures come by way of {@link Outside}. */
    static final String BOX2D_V3 = "box2d-v3";

    private static final String NOT_MEASURED = "not measured";

    private SeriesTables() {}

    /** Who has or should have figures on a machine: World on its GPUs, and on a machine without a GPU all others. */
    static List<Contender> contenders(ResultsFolder folder) {
        Set<Contender> all = new LinkedHashSet<>();
        String cores = folder.machine("cores");
        for (String device : Tables.devices(folder)) {
            if (Tables.kind(folder, device).equals("GPU")) {
                all.add(new Contender(Engines.world(device), Contender.NO_THREADS));
            }
        }
        if (all.stream().noneMatch(Contender::isOnGpu)) {
            for (String engine : List.of(Engines.WORLD_JVM, BOX2D_V3)) {
                all.add(new Contender(engine, cores));
                all.add(new Contender(engine, "1"));
            }
            Contender.PEERS.forEach(peer -> all.add(new Contender(peer, "1")));
        }
        for (Map<String, String> row : folder.table(Kind.SERIES).rows()) {
            all.add(new Contender(row.get("engine"), row.get("threads")));
        }
        return all.stream().filter(who -> !who.threads().isEmpty()).toList();
    }

    /** A row, or null if there is none. */
    static Map<String, String> run(ResultsFolder folder, Contender who, Series series, int n) {
        return folder.table(Kind.SERIES)
                .row("engine", who.engine(), "series", series.title, "n", "" + n, "threads", who.threads());
    }

    /** The median step of every engine on every machine at every n, and the depth that it leaves; of those that were measured. */
    static Grid steps(List<ResultsFolder> folders, Series series) {
        return grid(folders, series, true, (folder, who) -> tried(folder, who, series));
    }

    /** The headline: World and Box2D on all machines, at every n of the first series; of those that were measured. */
    static Grid headline(List<ResultsFolder> folders) {
        Series series = Series.values()[0];
        return grid(
                folders,
                series,
                false,
                (folder, who) -> (who.isWorld() && !who.threads().equals("1")
                                || List.of(BOX2D_V3, "gdx-box2d").contains(who.engine()))
                        && tried(folder, who, series));
    }

    private static Grid grid(
            List<ResultsFolder> folders, Series series, boolean depths, BiPredicate<ResultsFolder, Contender> wanted) {
        List<String> header = new ArrayList<>(List.of("engine", "threads", "machine"));
        for (String what : depths ? List.of("ms", "depth") : List.of("ms")) {
            series.sizes().forEach(n -> header.add(what + ", n = " + Numbers.whole(n)));
        }
        Grid grid = Grid.ofNumbers(header.toArray(new String[0]));
        for (ResultsFolder folder : folders) {
            for (Contender who : contenders(folder)) {
                if (wanted.test(folder, who)) {
                    List<String> row = new ArrayList<>(List.of(who.engine(), who.threads(), folder.name()));
                    series.sizes().forEach(n -> row.add(millis(run(folder, who, series, n))));
                    series.sizes().stream()
                            .filter(n -> depths)
                            .forEach(n -> row.add(depth(run(folder, who, series, n))));
                    grid.add(row);
                }
            }
        }
        return grid;
    }

    /** Who has no row yet in a series, machine by machine; empty if there is nobody. */
    static String notMeasured(List<ResultsFolder> folders, Series series) {
        StringBuilder text = new StringBuilder();
        for (ResultsFolder folder : folders) {
            String who = contenders(folder).stream()
                    .filter(contender -> !tried(folder, contender, series))
                    .map(Contender::toString)
                    .collect(Collectors.joining(", "));
            text.append(who.isEmpty() ? "" : "- Not measured on " + folder.name() + ": " + who + ".\n");
        }
        return text.toString();
    }

    private static boolean tried(ResultsFolder folder, Contender who, Series series) {
        return series.sizes().stream().anyMatch(n -> run(folder, who, series, n) != null);
    }

    /** The median of a step; of one that was given up, about what its first steps took; or in words why there is none. */
    private static String millis(Map<String, String> run) {
        if (run == null || LeftOut.is(run) && run.get("mean_ms").isEmpty()) {
            return NOT_MEASURED;
        }
        if (LeftOut.is(run)) {
            return "about " + Numbers.brief(run.get("mean_ms"));
        }
        return Tables.ok(run)
                ? Numbers.brief(run.get("median_ms"))
                : run.get("status").replaceFirst(":.*", "");
    }

    private static String depth(Map<String, String> run) {
        if (!Tables.ok(run)) {
            return "-";
        }
        String outside = run.get("outside");
        return Numbers.brief(run.get("mean_depth"))
                + (outside.equals("0") ? "" : ", " + Numbers.whole(outside) + " outside");
    }

    /** What the rows of engines outside Maven say of their making, with the machines. */
    static String outside(List<ResultsFolder> folders) {
        Map<String, Set<String>> made = new LinkedHashMap<>();
        for (ResultsFolder folder : folders) {
            for (Map<String, String> row : folder.table(Kind.SERIES).rows()) {
                if (row.get("remarks").startsWith(Outside.MARK)) {
                    String what = "- **" + row.get("engine") + "**, " + row.get("remarks");
                    made.computeIfAbsent(what, key -> new LinkedHashSet<>()).add(folder.name());
                }
            }
        }
        return made.entrySet().stream()
                .map(entry -> entry.getKey() + " (" + String.join(", ", entry.getValue()) + ").\n")
                .collect(Collectors.joining());
    }

    /** Why there is no figure, of what failed or did not fit. */
    static String failures(List<ResultsFolder> folders, Series series) {
        StringBuilder text = new StringBuilder();
        for (ResultsFolder folder : folders) {
            for (Map<String, String> row : folder.table(Kind.SERIES).rows("series", series.title)) {
                if (!Tables.ok(row) && !LeftOut.is(row)) {
                    text.append("- " + new Contender(row.get("engine"), row.get("threads")) + ", n = "
                            + Numbers.whole(row.get("n")) + ", " + folder.name() + ": " + row.get("status") + ".\n");
                }
            }
        }
        return text.toString();
    }
}
