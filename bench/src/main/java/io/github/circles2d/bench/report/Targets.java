package io.github.circles2d.bench.report;

import io.github.circles2d.bench.engines.Engines;
import io.github.circles2d.bench.results.Numbers;
import io.github.circles2d.bench.results.ResultsFolder;
import io.github.circles2d.bench.results.ResultsFolder.Kind;
import io.github.circles2d.bench.results.Table;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Predicate;

/** What World's speed was meant to be, from {@code targets.csv}, against what it is. */
final class Targets {
    /** A circle in the largest crowd may cost this many times what it costs among 100,000. */
    private static final double GROWTH = 1.5;

    private static final int GROWTH_FROM = 100_000;

    private static final Table TABLE = Table.ofResource("targets.csv", List.of("where", "n", "mode"));

    private Targets() {}

    /** Times: a row a target that a folder can tell something of. */
    static Grid times(List<ResultsFolder> folders) {
        Grid grid = Grid.ofNumbers("where", "n", "what", "aimed at ms", "reached ms", "by", "met");
        for (Map<String, String> target : TABLE.rows()) {
            boolean read = target.get("mode").equals("read");
            List<String> modes = read ? WorldTables.READS : List.of(target.get("mode"));
            double aim = Numbers.parse(target.get("ms"));
            for (ResultsFolder folder : folders) {
                Map<String, String> best = fastest(
                        folder.table(Kind.WORLD).rows("n", target.get("n"), "status", "ok"),
                        row -> modes.contains(row.get("mode")) && isMeant(folder, row, target.get("where")));
                if (best != null) {
                    double reached = median(best);
                    grid.add(
                            target.get("where"),
                            Numbers.whole(target.get("n")),
                            read ? "with read-back" : "steps alone",
                            Numbers.brief(aim),
                            Numbers.brief(reached),
                            best.get("engine"),
                            reached <= aim ? "yes" : "no: " + Numbers.brief(reached / aim) + " times the aim");
                }
            }
        }
        return grid;
    }

    /** Whether a run is on what a target is for: a number of cores, or a device. */
    private static boolean isMeant(ResultsFolder folder, Map<String, String> row, String where) {
        String device = row.get("engine").substring(row.get("engine").indexOf('@') + 1);
        boolean onCpu = row.get("engine").equals(Engines.WORLD_JVM)
                || Tables.kind(folder, device).equals("CPU");
        return where.endsWith(" cores")
                ? onCpu && where.equals(folder.machine("cores") + " cores")
                : folder.machine("device " + device).startsWith(where);
    }

    private static Map<String, String> fastest(List<Map<String, String>> rows, Predicate<Map<String, String>> wanted) {
        return rows.stream()
                .filter(wanted)
                .min(Comparator.comparingDouble(Targets::median))
                .orElse(null);
    }

    private static double median(Map<String, String> row) {
        return Numbers.parse(row.get("median_ms"));
    }

    /** World's time over that of other engines, by n, on the machines that have both. */
    static Grid ratios(List<ResultsFolder> folders) {
        Grid grid = Grid.ofNumbers("machine", "n", "World ms", "of", "its ms", "ratio", "aimed at", "met");
        for (ResultsFolder folder : folders) {
            Table peers = folder.table(Kind.PEERS);
            for (String n : peers.values("n", "scene", "packed", "status", "ok")) {
                List<Map<String, String>> rows = peers.rows("scene", "packed", "n", n, "status", "ok");
                Map<String, String> world =
                        fastest(rows, row -> row.get("engine").startsWith("world"));
                for (String peer : List.of("gdx-box2d", "dyn4j", Engines.JAVA_GRID)) {
                    // The row that came last.
                    Map<String, String> other = rows.stream()
                            .filter(row -> row.get("engine").equals(peer))
                            .reduce(null, (before, row) -> row);
                    if (world != null && other != null) {
                        double box2d = Integer.parseInt(n) < 5000 ? 0.1 : 0.05;
                        double aim = peer.equals("dyn4j") ? 0.02 : peer.equals(Engines.JAVA_GRID) ? 1 : box2d;
                        double ratio = median(world) / median(other);
                        grid.add(
                                folder.name(),
                                Numbers.whole(n),
                                Numbers.brief(median(world)),
                                peer,
                                Numbers.brief(median(other)),
                                String.format(Locale.ROOT, "%.3f", ratio),
                                Numbers.brief(aim),
                                ratio <= aim ? "yes" : "no");
                    }
                }
            }
        }
        return grid;
    }

    /** What a circle costs in the largest crowd, against 100,000. */
    static Grid growth(List<ResultsFolder> folders) {
        Grid grid = Grid.ofNumbers(
                "machine, engine", "ns a circle at 100,000", "largest n", "ns a circle there", "growth", "met");
        for (ResultsFolder folder : folders) {
            for (String engine : WorldTables.engines(folder)) {
                double from = nanos(folder, engine, GROWTH_FROM);
                int largest = WorldTables.sizes(folder, engine).stream()
                        .filter(n -> n > GROWTH_FROM && Double.isFinite(nanos(folder, engine, n)))
                        .reduce(0, Math::max);
                if (Double.isFinite(from) && largest > 0) {
                    double there = nanos(folder, engine, largest);
                    grid.add(
                            folder.name() + ", " + engine,
                            Numbers.brief(from),
                            Numbers.whole(largest),
                            Numbers.brief(there),
                            Numbers.brief(there / from),
                            there / from < GROWTH ? "yes" : "no");
                }
            }
        }
        return grid;
    }

    private static double nanos(ResultsFolder folder, String engine, int n) {
        return 1e6 * WorldTables.number(WorldTables.run(folder, engine, n, "steps"), "median_ms") / n;
    }
}
