package io.github.circles2d.bench.report;

import io.github.circles2d.PairIndexing;
import io.github.circles2d.bench.engines.Engines;
import io.github.circles2d.bench.results.Numbers;
import io.github.circles2d.bench.results.ResultsFolder;
import io.github.circles2d.bench.results.ResultsFolder.Kind;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;

/** The tables that the console and the page have in common. */
final class Tables {
    /** Names of the strategies, by number. */
    static final List<String> STRATEGIES = List.of("0 computed", "1 look-up table", "2 row search", "3 exact");

    private Tables() {}

    /** The devices of a machine. */
    static List<String> devices(ResultsFolder folder) {
        return folder.table(Kind.MACHINE).rows().stream()
                .map(row -> row.get("property"))
                .filter(property -> property.startsWith("device "))
                .map(property -> property.substring("device ".length()))
                .collect(Collectors.toList());
    }

    /** CPU or GPU, out of the device's description. */
    static String kind(ResultsFolder folder, String device) {
        return folder.machine("device " + device).contains("(GPU,") ? "GPU" : "CPU";
    }

    /** All n of a device, ascending. */
    static List<Integer> sizes(ResultsFolder folder, String device) {
        return new ArrayList<>(folder.table(Kind.STRATEGIES).rows("device", device).stream()
                .map(row -> Integer.valueOf(row.get("n")))
                .collect(Collectors.toCollection(TreeSet::new)));
    }

    /** Whether anything was tried for a device and n: not all was left out for want of time. */
    static boolean tried(ResultsFolder folder, String device, int n) {
        return folder.table(Kind.STRATEGIES).rows("device", device, "n", Integer.toString(n)).stream()
                .anyMatch(row -> !LeftOut.is(row));
    }

    /** Whether there is any figure for a device and n. */
    static boolean measured(ResultsFolder folder, String device, int n) {
        return !folder.table(Kind.STRATEGIES)
                .rows("device", device, "n", Integer.toString(n), "status", "ok")
                .isEmpty();
    }

    /** One strategy run, or null where there is none. */
    static Map<String, String> run(ResultsFolder folder, String device, int strategy, int n, String mode) {
        List<Map<String, String>> rows = folder.table(Kind.STRATEGIES)
                .rows("device", device, "strategy", Integer.toString(strategy), "n", Integer.toString(n), "mode", mode);
        return rows.isEmpty() ? null : rows.get(0);
    }

    /** The thesis's figures and ours, n by n. */
    static Grid figure3(ResultsFolder folder, String device, String mode) {
        String kind = kind(folder, device);
        Grid grid = Grid.ofNumbers(
                "n",
                "thesis 0",
                "thesis 1",
                "thesis 2",
                STRATEGIES.get(0),
                STRATEGIES.get(1),
                STRATEGIES.get(2),
                STRATEGIES.get(3));
        for (int n : sizes(folder, device)) {
            if (!tried(folder, device, n) && Figure3.millis(kind, n, 0).isEmpty()) {
                continue;
            }
            List<String> row = new ArrayList<>();
            row.add(Numbers.whole(n));
            for (int strategy = 0; strategy < 3; strategy++) {
                row.add(orDash(Figure3.millis(kind, n, strategy)));
            }
            for (int strategy = 0; strategy < 4; strategy++) {
                row.add(millis(run(folder, device, strategy, n, mode)));
            }
            grid.add(row);
        }
        return grid;
    }

    /** Mean and standard error of a run, or in a word why there is none. */
    static String millis(Map<String, String> run) {
        if (run == null) {
            return "-";
        }
        String status = run.get("status");
        if (!status.equals("ok")) {
            return status.contains(":") ? status.substring(0, status.indexOf(':')) : status;
        }
        return Numbers.brief(Numbers.parse(run.get("mean_ms"))) + " ± "
                + Numbers.brief(Numbers.parse(run.get("se_ms")));
    }

    /** Wrong slots of the computed indexing by device and n. */
    static Grid accuracy(List<ResultsFolder> folders) {
        Grid grid = Grid.ofNumbers("machine, device", "circles", "slots", "wrong slots");
        for (ResultsFolder folder : folders) {
            for (Map<String, String> row : folder.table(Kind.ACCURACY).rows()) {
                boolean first = row.get("n").startsWith("first");
                boolean none = row.get("wrong_slots").isEmpty();
                grid.add(List.of(
                        folder.name() + ", " + row.get("device"),
                        (first && !none ? "first wrong: " : first ? "none wrong up to " : "")
                                + Numbers.whole(Long.parseLong(row.get("circles"))),
                        Numbers.whole(Long.parseLong(row.get("slots"))),
                        none ? "-" : Numbers.whole(Long.parseLong(row.get("wrong_slots")))));
            }
        }
        return grid;
    }

    /** As {@link #accuracy}, with a column for each device. */
    static Grid accuracyByDevice(List<ResultsFolder> folders) {
        List<String> header = new ArrayList<>(List.of("circles", "slots"));
        Map<Long, List<String>> rows = new TreeMap<>();
        List<String> first = new ArrayList<>(List.of("first n with a wrong slot", ""));
        int devices = 0;
        for (ResultsFolder folder : folders) {
            for (String device : devices(folder)) {
                header.add(folder.name() + ", " + device);
                devices++;
                for (Map<String, String> row : folder.table(Kind.ACCURACY).rows("device", device)) {
                    String wrong = row.get("wrong_slots");
                    if (row.get("n").startsWith("first")) {
                        String circles = Numbers.whole(Long.parseLong(row.get("circles")));
                        pad(first, devices + 1).add(wrong.isEmpty() ? "none up to " + circles : circles);
                    } else {
                        String slots = Numbers.whole(Long.parseLong(row.get("slots")));
                        List<String> cells = rows.computeIfAbsent(
                                Long.valueOf(row.get("circles")),
                                n -> new ArrayList<>(List.of(Numbers.whole(n), slots)));
                        pad(cells, devices + 1).add(wrong.isEmpty() ? "-" : Numbers.whole(Long.parseLong(wrong)));
                    }
                }
            }
        }
        Grid grid = Grid.ofNumbers(header.toArray(new String[0]));
        for (List<String> cells : rows.values()) {
            grid.add(pad(cells, header.size()));
        }
        if (first.size() > 2) {
            grid.add(pad(first, header.size()));
        }
        return grid;
    }

    /** Fills a row with dashes up to a number of cells. */
    private static List<String> pad(List<String> cells, int size) {
        while (cells.size() < size) {
            cells.add("-");
        }
        return cells;
    }

    /** Kernel times and the share of the roof. */
    static Grid roof(ResultsFolder folder, String device) {
        Grid grid = Grid.ofNumbers(
                "n",
                "strategy",
                "update µs",
                "detect µs",
                "resolve µs",
                "MB that must move",
                "copy GB/s",
                "roof ms",
                "share of roof");
        List<Map<String, String>> rows = new ArrayList<>(folder.table(Kind.ROOF).rows("device", device));
        rows.sort(Comparator.comparing((Map<String, String> row) -> Integer.valueOf(row.get("n")))
                .thenComparing(row -> row.get("strategy")));
        for (Map<String, String> row : rows) {
            Map<String, String> run = run(
                    folder, device, Integer.parseInt(row.get("strategy")), Integer.parseInt(row.get("n")), "profiled");
            grid.add(List.of(
                    Numbers.whole(Long.parseLong(row.get("n"))),
                    row.get("strategy"),
                    brief(run.get("update_us")),
                    brief(run.get("detect_us")),
                    brief(run.get("resolve_us")),
                    Numbers.brief(Long.parseLong(row.get("moved_bytes")) / 1e6),
                    brief(row.get("copy_gb_per_s")),
                    brief(row.get("roof_ms")),
                    Math.round(100 * Numbers.parse(row.get("share_of_roof"))) + " %"));
        }
        return grid;
    }

    /** Speed and quality of the engines on a scene. */
    static Grid peers(ResultsFolder folder, String scene) {
        Grid grid = Grid.ofNumbers(
                "engine",
                "n",
                "ms a step",
                "after steps",
                "mean depth",
                "max depth",
                "deep pairs",
                "energy a circle",
                "KB allocated a step",
                "peak MiB");
        for (Map<String, String> row : folder.table(Kind.PEERS).rows("scene", scene)) {
            if (LeftOut.is(row)) {
                continue;
            }
            boolean ok = row.get("status").equals("ok");
            grid.add(List.of(
                    row.get("engine"),
                    Numbers.whole(Long.parseLong(row.get("n"))),
                    millis(row),
                    ok
                            ? Integer.toString(
                                    Integer.parseInt(row.get("skipped")) + Integer.parseInt(row.get("steps")))
                            : "-",
                    brief(row.get("mean_depth")),
                    brief(row.get("max_depth")),
                    ok ? Numbers.whole(Math.round(Numbers.parse(row.get("deep_pairs")))) : "-",
                    scientific(row.get("kinetic_energy")),
                    ok ? Numbers.brief(Numbers.parse(row.get("allocated_bytes")) / 1000) : "-",
                    brief(row.get("peak_rss_mib"))));
        }
        return grid;
    }

    /** The plain loop in Java beside Circles2D on a device, on the scene packed. */
    static Grid plainLoop(ResultsFolder folder, String device) {
        Grid grid = Grid.ofNumbers("n", "java-all-pairs ms", "look-up table ms", "exact ms", "faster than both");
        List<Map<String, String>> rows = folder.table(Kind.PEERS).rows("scene", "packed", "status", "ok");
        for (Map<String, String> loop : rows) {
            Map<String, String> lookup = same(loop, Engines.thesis(PairIndexing.LOOKUP_TABLE) + "@" + device, rows);
            Map<String, String> exact = same(loop, Engines.thesis(PairIndexing.EXACT) + "@" + device, rows);
            if (loop.get("engine").equals("java-all-pairs") && lookup != null && exact != null) {
                double best = Math.min(Numbers.parse(lookup.get("mean_ms")), Numbers.parse(exact.get("mean_ms")));
                grid.add(List.of(
                        Numbers.whole(Long.parseLong(loop.get("n"))),
                        millis(loop),
                        millis(lookup),
                        millis(exact),
                        Numbers.parse(loop.get("mean_ms")) < best ? "the loop" : "no"));
            }
        }
        return grid;
    }

    /** The run of another engine with the same scene, n and steps; null where there is none. */
    private static Map<String, String> same(Map<String, String> run, String engine, List<Map<String, String>> rows) {
        return rows.stream()
                .filter(row -> row.get("engine").equals(engine)
                        && row.get("n").equals(run.get("n"))
                        && row.get("steps").equals(run.get("steps")))
                .findFirst()
                .orElse(null);
    }

    private static String brief(String number) {
        return Numbers.brief(Numbers.parse(number));
    }

    private static String scientific(String number) {
        return number.isEmpty() ? "-" : String.format(Locale.ROOT, "%.1e", Numbers.parse(number));
    }

    private static String orDash(String text) {
        return text.isEmpty() ? "-" : text;
    }
}
