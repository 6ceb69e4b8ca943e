package io.github.circles2d.bench.report;

import io.github.circles2d.bench.measure.WorldTraffic;
import io.github.circles2d.bench.results.Numbers;
import io.github.circles2d.bench.results.ResultsFolder;
import io.github.circles2d.bench.results.ResultsFolder.Kind;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** World's figures, for the console and for the page. */
final class WorldTables {
    /** How the circles can be read, by mode. */
    static final List<String> READS = List.of("readPositions", "requestPositions", "readArray", "readBuffer");

    private WorldTables() {}

    /** The engines that a folder has runs of, in the order of the rows. */
    static List<String> engines(ResultsFolder folder) {
        return folder.table(Kind.WORLD).values("engine");
    }

    /** All n that an engine was tried at, ascending. */
    static List<Integer> sizes(ResultsFolder folder, String engine) {
        return folder.table(Kind.WORLD).rows("engine", engine).stream()
                .filter(row -> !LeftOut.is(row))
                .map(row -> Integer.valueOf(row.get("n")))
                .distinct()
                .sorted()
                .toList();
    }

    /** One run, or null if there is none. */
    static Map<String, String> run(ResultsFolder folder, String engine, int n, String mode) {
        return folder.table(Kind.WORLD).row("engine", engine, "n", Integer.toString(n), "mode", mode);
    }

    /** A number of a run, NaN if there is none. */
    static double number(Map<String, String> run, String column) {
        return run == null ? Double.NaN : Numbers.parse(run.get(column));
    }

    /** Steps alone and with read-back, and the state that they end in. */
    static Grid steps(ResultsFolder folder) {
        Grid grid = Grid.ofNumbers(("engine,n,ms a step,one step a call,positions shared,positions requested,"
                        + "read into an array,read into a buffer,ns a circle,contacts a circle,mean depth,MB held,"
                        + "after steps,state hash")
                .split(","));
        for (String engine : engines(folder)) {
            for (int n : sizes(folder, engine)) {
                Map<String, String> run = run(folder, engine, n, "steps");
                boolean ok = Tables.ok(run);
                List<String> row = new ArrayList<>(List.of(engine, Numbers.whole(n), Tables.millis(run)));
                row.add(Tables.millis(run(folder, engine, n, "frames")));
                READS.forEach(read -> row.add(Tables.millis(run(folder, engine, n, read))));
                row.add(Numbers.brief(1e6 * number(run, "mean_ms") / n));
                row.add(Numbers.brief(number(run, "contacts") / n));
                row.add(Numbers.brief(number(run, "mean_depth")));
                row.add(Numbers.brief(number(run, "bytes_held") / 1e6));
                row.add(ok ? Tables.stepsOf(run) : "-");
                row.add(ok ? run.get("state_hash").substring(0, 8) : "-");
                grid.add(row);
            }
        }
        return grid;
    }

    /** Stages of the engine on a device, beside the roof. */
    static Grid stages(ResultsFolder folder, String engine) {
        Grid grid =
                Grid.ofNumbers("n", "stage", "µs a step", "MB that must move", "copy GB/s", "roof µs", "share of roof");
        List<Map<String, String>> rows = folder.table(Kind.WORLD_STAGES).rows("engine", engine);
        rows.sort(Comparator.comparing(row -> Integer.valueOf(row.get("n"))));
        for (Map<String, String> row : rows) {
            grid.add(
                    Numbers.whole(row.get("n")),
                    nameOf(row.get("stage")),
                    Numbers.brief(row.get("time_us")),
                    Numbers.brief(Numbers.parse(row.get("moved_bytes")) / 1e6),
                    Numbers.brief(row.get("copy_gb_per_s")),
                    Numbers.brief(row.get("roof_us")),
                    row.get("share_of_roof").isEmpty() ? "-" : Numbers.percent(row.get("share_of_roof")));
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
            String circle = Integer.toString(stage.perCircle());
            grid.add(nameOf(stage.stage()), circle, Integer.toString(stage.perContact()), stage.counted());
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
                    String alone = Tables.millis(frames == null ? run(folder, engine, n, "steps") : frames);
                    grid.add(engine, Numbers.whole(n), alone, Tables.millis(one), Tables.millis(ten));
                }
            }
        }
        return grid;
    }

    /** Transfers by the kind of the host's memory. */
    static Grid transfers(ResultsFolder folder, String device) {
        Grid grid = Grid.ofNumbers(("bytes,direction,page-locked ms,by way of it ms,pageable ms,page-locked GB/s,"
                        + "by way of it GB/s,pageable GB/s")
                .split(","));
        Map<List<String>, Map<String, Map<String, String>>> transfers = new LinkedHashMap<>();
        for (Map<String, String> row : folder.table(Kind.TRANSFER).rows("device", device)) {
            if (!LeftOut.is(row)) {
                transfers
                        .computeIfAbsent(
                                List.of(Numbers.whole(row.get("bytes")), row.get("direction")),
                                key -> new LinkedHashMap<>())
                        .put(row.get("memory"), row);
            }
        }
        transfers.forEach((transfer, runs) -> {
            List<String> row = new ArrayList<>(transfer);
            List<String> memories = List.of("pinned", "staged", "pageable");
            memories.forEach(memory -> row.add(Tables.millis(runs.get(memory))));
            memories.forEach(memory -> row.add(Numbers.brief(number(runs.get(memory), "gb_per_s"))));
            grid.add(row);
        });
        return grid;
    }

    /** Which engines have ended the same steps in which state. */
    static Grid bits(List<ResultsFolder> folders) {
        Map<List<String>, Map<String, List<String>>> engines = new LinkedHashMap<>();
        for (ResultsFolder folder : folders) {
            for (Map<String, String> row : folder.table(Kind.WORLD).rows("mode", "steps", "status", "ok")) {
                engines.computeIfAbsent(
                                List.of(Numbers.whole(row.get("n")), Tables.stepsOf(row)), key -> new LinkedHashMap<>())
                        .computeIfAbsent(row.get("state_hash"), key -> new ArrayList<>())
                        .add(row.get("engine") + " (" + folder.name() + ")");
            }
        }
        Grid grid = Grid.ofProse("n", "after steps", "state hash", "engines that end in it");
        engines.forEach((what, states) ->
                states.forEach((hash, who) -> grid.add(what.get(0), what.get(1), hash, String.join(", ", who))));
        return grid;
    }
}
