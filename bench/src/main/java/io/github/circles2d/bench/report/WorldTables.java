package io.github.circles2d.bench.report;

import io.github.circles2d.bench.results.Numbers;
import io.github.circles2d.bench.results.ResultsFolder;
import io.github.circles2d.bench.results.ResultsFolder.Kind;
import io.github.circles2d.bench.sweep.WorldTraffic;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import java.util.stream.Collectors;

/** World's figures, for the console and for the page. */
final class WorldTables {
    /** How the circles can be read, by mode. */
    static final List<String> READS = List.of("readPositions", "requestPositions", "readArray", "readBuffer");

    private WorldTables() {}

    /** The engines that a folder has runs of, in the order of the rows. */
    static List<String> engines(ResultsFolder folder) {
        return folder.table(Kind.WORLD).rows().stream()
                .map(row -> row.get("engine"))
                .distinct()
                .collect(Collectors.toList());
    }

    /** All n that an engine was tried at, ascending. */
    static List<Integer> sizes(ResultsFolder folder, String engine) {
        return new ArrayList<>(folder.table(Kind.WORLD).rows("engine", engine).stream()
                .filter(row -> !LeftOut.is(row))
                .map(row -> Integer.valueOf(row.get("n")))
                .collect(Collectors.toCollection(TreeSet::new)));
    }

    /** One run, or null where there is none. */
    static Map<String, String> run(ResultsFolder folder, String engine, int n, String mode) {
        List<Map<String, String>> rows =
                folder.table(Kind.WORLD).rows("engine", engine, "n", Integer.toString(n), "mode", mode);
        return rows.isEmpty() ? null : rows.get(0);
    }

    /** A number of a run, NaN where there is none. */
    static double number(Map<String, String> run, String column) {
        return run == null ? Double.NaN : Numbers.parse(run.get(column));
    }

    /** Steps alone and with read-back, and the state that they end in. */
    static Grid steps(ResultsFolder folder) {
        Grid grid = Grid.ofNumbers(
                "engine",
                "n",
                "ms a step",
                "one step a call",
                "positions shared",
                "positions requested",
                "read into an array",
                "read into a buffer",
                "ns a circle",
                "contacts a circle",
                "mean depth",
                "MB held",
                "after steps",
                "state hash");
        for (String engine : engines(folder)) {
            for (int n : sizes(folder, engine)) {
                Map<String, String> run = run(folder, engine, n, "steps");
                boolean ok = run != null && run.get("status").equals("ok");
                grid.add(List.of(
                        engine,
                        Numbers.whole(n),
                        Tables.millis(run),
                        Tables.millis(run(folder, engine, n, "frames")),
                        Tables.millis(run(folder, engine, n, READS.get(0))),
                        Tables.millis(run(folder, engine, n, READS.get(1))),
                        Tables.millis(run(folder, engine, n, READS.get(2))),
                        Tables.millis(run(folder, engine, n, READS.get(3))),
                        ok ? Numbers.brief(1e6 * number(run, "mean_ms") / n) : "-",
                        ok ? Numbers.brief(number(run, "contacts") / n) : "-",
                        ok ? Numbers.brief(number(run, "mean_depth")) : "-",
                        ok ? Numbers.brief(number(run, "bytes_held") / 1e6) : "-",
                        ok ? Integer.toString(stepsOf(run)) : "-",
                        ok ? run.get("state_hash").substring(0, 8) : "-"));
            }
        }
        return grid;
    }

    private static int stepsOf(Map<String, String> run) {
        return Integer.parseInt(run.get("skipped")) + Integer.parseInt(run.get("steps"));
    }

    /** Stages of the engine on a device, beside the roof; not those that take less than a hundredth of the step. */
    static Grid stages(ResultsFolder folder, String engine) {
        Grid grid =
                Grid.ofNumbers("n", "stage", "µs a step", "MB that must move", "copy GB/s", "roof µs", "share of roof");
        List<Map<String, String>> rows =
                new ArrayList<>(folder.table(Kind.WORLD_STAGES).rows("engine", engine));
        rows.sort(Comparator.comparing(row -> Integer.valueOf(row.get("n"))));
        for (Map<String, String> row : rows) {
            double step = rows.stream()
                    .filter(other -> other.get("n").equals(row.get("n")))
                    .mapToDouble(other -> number(other, "time_us"))
                    .sum();
            if (number(row, "time_us") < 0.01 * step) {
                continue;
            }
            boolean roof = !row.get("roof_us").isEmpty();
            grid.add(List.of(
                    Numbers.whole(Long.parseLong(row.get("n"))),
                    nameOf(row.get("stage")),
                    Numbers.brief(Numbers.parse(row.get("time_us"))),
                    roof ? Numbers.brief(Numbers.parse(row.get("moved_bytes")) / 1e6) : "-",
                    roof ? Numbers.brief(Numbers.parse(row.get("copy_gb_per_s"))) : "-",
                    roof ? Numbers.brief(Numbers.parse(row.get("roof_us"))) : "-",
                    roof ? Math.round(100 * Numbers.parse(row.get("share_of_roof"))) + " %" : "-"));
        }
        return grid;
    }

    /** Result files keep the names that two stages had at first. */
    private static String nameOf(String stage) {
        return switch (stage) {
            case "Sweep" -> "Continuous collision";
            case "Resident" -> "Persistent kernel";
            default -> stage;
        };
    }

    /** What is counted as a stage's bytes. */
    static Grid traffic() {
        Grid grid = Grid.ofProse("stage", "bytes a circle", "bytes a contact", "what is counted");
        for (WorldTraffic stage : WorldTraffic.STAGES) {
            grid.add(List.of(
                    nameOf(stage.stage()),
                    Integer.toString(stage.perCircle()),
                    Integer.toString(stage.perContact()),
                    stage.counted()));
        }
        return grid;
    }

    /** Steps of a crowd in which circles come and go, beside those of the same crowd left alone. */
    static Grid storms(ResultsFolder folder) {
        Grid grid = Grid.ofNumbers("engine", "n", "left alone", "1 % replaced a step", "10 % replaced a step");
        for (String engine : engines(folder)) {
            for (int n : sizes(folder, engine)) {
                Map<String, String> one = run(folder, engine, n, "storm1");
                Map<String, String> ten = run(folder, engine, n, "storm10");
                if (one != null || ten != null) {
                    Map<String, String> frames = run(folder, engine, n, "frames");
                    grid.add(List.of(
                            engine,
                            Numbers.whole(n),
                            Tables.millis(frames == null ? run(folder, engine, n, "steps") : frames),
                            Tables.millis(one),
                            Tables.millis(ten)));
                }
            }
        }
        return grid;
    }

    /** Transfers by the kind of the host's memory. */
    static Grid transfers(ResultsFolder folder, String device) {
        Grid grid = Grid.ofNumbers(
                "bytes",
                "direction",
                "page-locked ms",
                "by way of it ms",
                "pageable ms",
                "page-locked GB/s",
                "by way of it GB/s",
                "pageable GB/s");
        Map<String, Map<String, Map<String, String>>> byTransfer = new LinkedHashMap<>();
        for (Map<String, String> row : folder.table(Kind.TRANSFER).rows("device", device)) {
            if (!LeftOut.is(row)) {
                byTransfer
                        .computeIfAbsent(row.get("bytes") + " " + row.get("direction"), key -> new LinkedHashMap<>())
                        .put(row.get("memory"), row);
            }
        }
        byTransfer.forEach((transfer, runs) -> {
            List<String> row = new ArrayList<>();
            row.add(Numbers.whole(Long.parseLong(transfer.substring(0, transfer.indexOf(' ')))));
            row.add(transfer.substring(transfer.indexOf(' ') + 1));
            for (String memory : List.of("pinned", "staged", "pageable")) {
                row.add(Tables.millis(runs.get(memory)));
            }
            for (String memory : List.of("pinned", "staged", "pageable")) {
                row.add(Numbers.brief(number(runs.get(memory), "gb_per_s")));
            }
            grid.add(row);
        });
        return grid;
    }

    /** Which engines have ended the same steps in which state. */
    static Grid bits(List<ResultsFolder> folders) {
        Map<String, Map<String, List<String>>> engines = new LinkedHashMap<>();
        for (ResultsFolder folder : folders) {
            for (Map<String, String> row : folder.table(Kind.WORLD).rows("mode", "steps", "status", "ok")) {
                String what = Numbers.whole(Long.parseLong(row.get("n"))) + "|" + stepsOf(row);
                engines.computeIfAbsent(what, key -> new LinkedHashMap<>())
                        .computeIfAbsent(row.get("state_hash"), key -> new ArrayList<>())
                        .add(row.get("engine") + " (" + folder.name() + ")");
            }
        }
        Grid grid = Grid.ofProse("n", "after steps", "state hash", "engines that end in it");
        engines.forEach((what, states) -> states.forEach((hash, who) -> grid.add(List.of(
                what.substring(0, what.indexOf('|')),
                what.substring(what.indexOf('|') + 1),
                hash,
                who.size() == 1 ? who.get(0) : String.join(", ", who)))));
        return grid;
    }
}
