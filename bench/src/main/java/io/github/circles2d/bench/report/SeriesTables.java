package io.github.circles2d.bench.report;

import io.github.circles2d.bench.engines.Engines;
import io.github.circles2d.bench.results.Numbers;
import io.github.circles2d.bench.results.ResultsFolder;
import io.github.circles2d.bench.results.ResultsFolder.Kind;
import io.github.circles2d.bench.series.Contender;
import io.github.circles2d.bench.series.Outside;
import io.github.circles2d.bench.series.Series;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
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
        List<String> devices = Tables.devices(folder);
        boolean gpu = false;
        for (String device : devices) {
            boolean isGpu = Tables.kind(folder, device).equals("GPU");
            gpu |= isGpu;
            if (isGpu) {
                all.add(new Contender(Engines.world(device), Contender.NO_THREADS));
            }
        }
        if (!gpu) {
            all.add(new Contender(Engines.WORLD_JVM, folder.machine("cores")));
            all.add(new Contender(Engines.WORLD_JVM, "1"));
            all.add(new Contender(BOX2D_V3, folder.machine("cores")));
            all.add(new Contender(BOX2D_V3, "1"));
            Contender.PEERS.forEach(peer -> all.add(new Contender(peer, "1")));
        }
        for (Map<String, String> row : folder.table(Kind.SERIES).rows()) {
            all.add(new Contender(row.get("engine"), row.get("threads")));
        }
        return all.stream().filter(who -> !who.threads().isEmpty()).collect(Collectors.toList());
    }

    /** A row, or null where there is none. */
    static Map<String, String> run(ResultsFolder folder, Contender who, Series series, int n) {
        List<Map<String, String>> rows = folder.table(Kind.SERIES)
                .rows(
                        "engine",
                        who.engine(),
                        "series",
                        series.title,
                        "n",
                        Integer.toString(n),
                        "threads",
                        who.threads());
        return rows.isEmpty() ? null : rows.get(0);
    }

    /** Whether a row has a figure. */
    static boolean ok(Map<String, String> run) {
        return run != null && run.get("status").equals("ok");
    }

    /** The median step of every engine on every machine at every n, and the depth that it leaves; of those that were measured. */
    static Grid steps(List<ResultsFolder> folders, Series series) {
        List<String> header = new ArrayList<>(List.of("engine", "threads", "machine"));
        series.sizes().forEach(n -> header.add("ms, n = " + Numbers.whole(n)));
        series.sizes().forEach(n -> header.add("depth, n = " + Numbers.whole(n)));
        Grid grid = Grid.ofNumbers(header.toArray(new String[0]));
        for (ResultsFolder folder : folders) {
            for (Contender who : contenders(folder)) {
                if (tried(folder, who, series)) {
                    List<String> row = new ArrayList<>(List.of(who.engine(), who.threads(), folder.name()));
                    series.sizes().forEach(n -> row.add(millis(run(folder, who, series, n))));
                    series.sizes().forEach(n -> row.add(depth(run(folder, who, series, n))));
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
            if (!who.isEmpty()) {
                text.append("- Not measured on ")
                        .append(folder.name())
                        .append(": ")
                        .append(who)
                        .append(".\n");
            }
        }
        return text.toString();
    }

    private static boolean tried(ResultsFolder folder, Contender who, Series series) {
        return series.sizes().stream().anyMatch(n -> run(folder, who, series, n) != null);
    }

    /** The headline: World and Box2D on all machines, at every n of the first series; of those that were measured. */
    static Grid headline(List<ResultsFolder> folders) {
        Series series = Series.values()[0];
        List<String> header = new ArrayList<>(List.of("engine", "threads", "machine"));
        series.sizes().forEach(n -> header.add("ms, n = " + Numbers.whole(n)));
        Grid grid = Grid.ofNumbers(header.toArray(new String[0]));
        for (ResultsFolder folder : folders) {
            for (Contender who : contenders(folder)) {
                String engine = who.engine();
                boolean headlined = engine.startsWith("world") && !who.threads().equals("1")
                        || engine.equals(BOX2D_V3)
                        || engine.equals("gdx-box2d");
                if (headlined && tried(folder, who, series)) {
                    List<String> row = new ArrayList<>(List.of(engine, who.threads(), folder.name()));
                    series.sizes().forEach(n -> row.add(millis(run(folder, who, series, n))));
                    grid.add(row);
                }
            }
        }
        return grid;
    }

    /** The median of a step; of one that was given up, about what its first steps took; or in words why there is none. */
    static String millis(Map<String, String> run) {
        if (run == null) {
            return NOT_MEASURED;
        }
        if (ok(run)) {
            return Numbers.brief(Numbers.parse(run.get("median_ms")));
        }
        String status = run.get("status");
        if (!LeftOut.is(run)) {
            return status.contains(":") ? status.substring(0, status.indexOf(':')) : status;
        }
        return run.get("mean_ms").isEmpty()
                ? NOT_MEASURED
                : "about " + Numbers.brief(Numbers.parse(run.get("mean_ms")));
    }

    private static String depth(Map<String, String> run) {
        if (!ok(run)) {
            return "-";
        }
        int outside = Integer.parseInt(run.get("outside"));
        return Numbers.brief(Numbers.parse(run.get("mean_depth")))
                + (outside > 0 ? ", " + Numbers.whole(outside) + " outside" : "");
    }

    /** What the rows of engines outside Maven say of their making, with the machines. */
    static String outside(List<ResultsFolder> folders) {
        Map<String, Set<String>> made = new LinkedHashMap<>();
        for (ResultsFolder folder : folders) {
            for (Map<String, String> row : folder.table(Kind.SERIES).rows()) {
                if (row.get("remarks").startsWith(Outside.MARK)) {
                    made.computeIfAbsent(
                                    "**" + row.get("engine") + "**, " + row.get("remarks"),
                                    key -> new LinkedHashSet<>())
                            .add(folder.name());
                }
            }
        }
        return made.entrySet().stream()
                .map(entry -> "- " + entry.getKey() + " (" + String.join(", ", entry.getValue()) + ").\n")
                .collect(Collectors.joining());
    }

    /** Why there is no figure, of what failed or did not fit. */
    static String failures(List<ResultsFolder> folders, Series series) {
        StringBuilder text = new StringBuilder();
        for (ResultsFolder folder : folders) {
            for (Map<String, String> row : folder.table(Kind.SERIES).rows("series", series.title)) {
                if (!ok(row) && !LeftOut.is(row)) {
                    String who = new Contender(row.get("engine"), row.get("threads")).toString();
                    text.append("- ").append(who).append(", n = ").append(Numbers.whole(Long.parseLong(row.get("n"))));
                    text.append(", ")
                            .append(folder.name())
                            .append(": ")
                            .append(row.get("status"))
                            .append(".\n");
                }
            }
        }
        return text.toString();
    }
}
