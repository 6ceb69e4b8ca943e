package io.github.circles2d.bench.report;

import io.github.circles2d.bench.engines.Engines;
import io.github.circles2d.bench.results.Numbers;
import io.github.circles2d.bench.results.ResultsFolder;
import io.github.circles2d.bench.results.ResultsFolder.Kind;
import io.github.circles2d.bench.results.Table;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;

/** What World's speed was meant to be, from {@code targets.csv}, against what it is. */
final class Targets {
    /** A circle in the largest crowd may cost this many times what it costs among 100,000. */
    private static final double GROWTH = 1.5;

    private static final int GROWTH_FROM = 100_000;

    private static final Table TABLE = read();

    private Targets() {}

    private static Table read() {
        try (InputStream in = Targets.class.getResourceAsStream("/io/github/circles2d/bench/targets.csv")) {
            return Table.parse(new String(in.readAllBytes(), StandardCharsets.UTF_8), List.of("where", "n", "mode"));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Times: a row a target that a folder can tell something of. */
    static Grid times(List<ResultsFolder> folders) {
        Grid grid = Grid.ofNumbers("where", "n", "what", "aimed at ms", "reached ms", "by", "met");
        for (Map<String, String> target : TABLE.rows()) {
            for (ResultsFolder folder : folders) {
                Map<String, String> best = best(folder, target);
                if (best == null) {
                    continue;
                }
                double aim = Numbers.parse(target.get("ms"));
                double reached = Numbers.parse(best.get("median_ms"));
                grid.add(List.of(
                        target.get("where"),
                        Numbers.whole(Long.parseLong(target.get("n"))),
                        target.get("mode").equals("read") ? "with read-back" : "steps alone",
                        Numbers.brief(aim),
                        Numbers.brief(reached),
                        best.get("engine"),
                        verdict(reached, aim)));
            }
        }
        return grid;
    }

    private static String verdict(double reached, double aim) {
        return reached <= aim ? "yes" : "no: " + Numbers.brief(reached / aim) + " times the aim";
    }

    /** The run with the least median that a target is about; null where the folder has none. */
    private static Map<String, String> best(ResultsFolder folder, Map<String, String> target) {
        String where = target.get("where");
        List<String> modes = target.get("mode").equals("read") ? WorldTables.READS : List.of(target.get("mode"));
        Map<String, String> best = null;
        for (Map<String, String> row : folder.table(Kind.WORLD).rows("n", target.get("n"), "status", "ok")) {
            boolean onCpu = row.get("engine").equals(Engines.WORLD_JVM)
                    || Tables.kind(folder, device(row)).equals("CPU");
            boolean meant = where.endsWith(" cores")
                    ? onCpu && where.equals(folder.machine("cores") + " cores")
                    : folder.machine("device " + device(row)).startsWith(where);
            if (meant && modes.contains(row.get("mode")) && (best == null || median(row) < median(best))) {
                best = row;
            }
        }
        return best;
    }

    private static String device(Map<String, String> row) {
        return row.get("engine").substring(row.get("engine").indexOf('@') + 1);
    }

    private static double median(Map<String, String> row) {
        return Numbers.parse(row.get("median_ms"));
    }

    /** World's time over that of other engines, by n, on the machines that have both. */
    static Grid ratios(List<ResultsFolder> folders) {
        Grid grid = Grid.ofNumbers("machine", "n", "World ms", "of", "its ms", "ratio", "aimed at", "met");
        for (ResultsFolder folder : folders) {
            List<Map<String, String>> rows = folder.table(Kind.PEERS).rows("scene", "packed", "status", "ok");
            for (String n : rows.stream().map(row -> row.get("n")).distinct().collect(Collectors.toList())) {
                for (String peer : List.of("gdx-box2d", "dyn4j", Engines.JAVA_GRID)) {
                    addRatio(grid, folder.name(), Integer.parseInt(n), peer, rows);
                }
            }
        }
        return grid;
    }

    private static void addRatio(Grid grid, String machine, int n, String peer, List<Map<String, String>> rows) {
        Map<String, String> world = null;
        Map<String, String> other = null;
        for (Map<String, String> row : rows) {
            if (Integer.parseInt(row.get("n")) == n) {
                other = row.get("engine").equals(peer) ? row : other;
                boolean isWorld = row.get("engine").startsWith("world");
                world = isWorld && (world == null || median(row) < median(world)) ? row : world;
            }
        }
        if (world == null || other == null) {
            return;
        }
        double aim = peer.equals("dyn4j") ? 0.02 : peer.equals(Engines.JAVA_GRID) ? 1 : n < 5000 ? 0.1 : 0.05;
        double ratio = median(world) / median(other);
        grid.add(List.of(
                machine,
                Numbers.whole(n),
                Numbers.brief(median(world)),
                peer,
                Numbers.brief(median(other)),
                String.format(Locale.ROOT, "%.3f", ratio),
                Numbers.brief(aim),
                ratio <= aim ? "yes" : "no"));
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
                    grid.add(List.of(
                            folder.name() + ", " + engine,
                            Numbers.brief(from),
                            Numbers.whole(largest),
                            Numbers.brief(there),
                            Numbers.brief(there / from),
                            there / from < GROWTH ? "yes" : "no"));
                }
            }
        }
        return grid;
    }

    private static double nanos(ResultsFolder folder, String engine, int n) {
        return 1e6 * WorldTables.number(WorldTables.run(folder, engine, n, "steps"), "median_ms") / n;
    }
}
