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

/** The tables on the thesis's engine and on other engines. */
final class Tables {
    /** Names of the strategies, by number. */
    static final List<String> STRATEGIES = List.of("0 computed", "1 look-up table", "2 row search", "3 exact");

    private Tables() {}

    /** The devices of a machine. */
    static List<String> devices(ResultsFolder folder) {
        return folder.table(Kind.MACHINE).values("property").stream()
                .filter(property -> property.startsWith("device "))
                .map(property -> property.substring("device ".length()))
                .toList();
    }

    /** CPU or GPU, out of the device's description. */
    static String kind(ResultsFolder folder, String device) {
        return folder.machine("device " + device).contains("(GPU,") ? "GPU" : "CPU";
    }

    /** Whether a row is there and has a figure. */
    static boolean ok(Map<String, String> run) {
        return run != null && run.get("status").equals("ok");
    }

    /** All n of a device, ascending. */
    static List<Integer> sizes(ResultsFolder folder, String device) {
        return folder.table(Kind.STRATEGIES).values("n", "device", device).stream()
                .map(Integer::valueOf)
                .sorted()
                .toList();
    }

    /** One strategy run, or null if there is none. */
    static Map<String, String> run(ResultsFolder folder, String device, int strategy, int n, String mode) {
        return folder.table(Kind.STRATEGIES)
                .row("device", device, "strategy", Integer.toString(strategy), "n", Integer.toString(n), "mode", mode);
    }

    /** Mean and standard error of a run, or in a word why there is none. */
    static String millis(Map<String, String> run) {
        if (run == null) {
            return "-";
        }
        return ok(run)
                ? Numbers.brief(run.get("mean_ms")) + " ± " + Numbers.brief(run.get("se_ms"))
                : run.get("status").replaceFirst(":.*", "");
    }

    /** The machines, each with a link to its page. */
    static Grid machines(List<ResultsFolder> folders) {
        Grid grid = Grid.ofProse("machine", "processor", "device", "Java", "date");
        for (ResultsFolder folder : folders) {
            for (String device : devices(folder)) {
                grid.add(
                        "[" + folder.name() + "](" + Page.fileOf(folder) + ")",
                        folder.machine("processor") + ", " + folder.machine("cores") + " cores, "
                                + folder.machine("memory GiB") + " GiB; " + folder.machine("system"),
                        "**" + device + "**: " + folder.machine("device " + device),
                        folder.machine("java"),
                        folder.machine("date"));
            }
        }
        return grid;
    }

    /** The thesis's figures and ours, n by n; without the n at which all was left out for want of time. */
    static Grid figure3(ResultsFolder folder, String device) {
        List<String> header = new ArrayList<>(List.of("n", "thesis 0", "thesis 1", "thesis 2"));
        header.addAll(STRATEGIES);
        Grid grid = Grid.ofNumbers(header.toArray(new String[0]));
        String kind = kind(folder, device);
        for (int n : sizes(folder, device)) {
            boolean tried = folder.table(Kind.STRATEGIES).rows("device", device, "n", Integer.toString(n)).stream()
                    .anyMatch(row -> !LeftOut.is(row));
            if (tried || !Figure3.millis(kind, n, 0).isEmpty()) {
                List<String> row = new ArrayList<>(List.of(Numbers.whole(n)));
                for (int strategy = 0; strategy < 3; strategy++) {
                    String thesis = Figure3.millis(kind, n, strategy);
                    row.add(thesis.isEmpty() ? "-" : thesis);
                }
                for (int strategy = 0; strategy < 4; strategy++) {
                    row.add(millis(run(folder, device, strategy, n, "loop")));
                }
                grid.add(row);
            }
        }
        return grid;
    }

    /** Every mode of every strategy, at each n that has any figure. */
    static Grid modes(ResultsFolder folder, String device) {
        Grid grid = Grid.ofNumbers("n", "strategy", "with read-back", "device alone", "with profiling events");
        for (int n : sizes(folder, device)) {
            if (folder.table(Kind.STRATEGIES).row("device", device, "n", Integer.toString(n), "status", "ok") != null) {
                for (int strategy = 0; strategy < 4; strategy++) {
                    grid.add(
                            Numbers.whole(n),
                            Integer.toString(strategy),
                            millis(run(folder, device, strategy, n, "loop")),
                            millis(run(folder, device, strategy, n, "deviceOnly")),
                            millis(run(folder, device, strategy, n, "profiled")));
                }
            }
        }
        return grid;
    }

    /** Memory of the buffers by n. */
    static Grid memory(List<ResultsFolder> folders) {
        Grid grid = Grid.ofNumbers("n", "collision buffer MB", "look-up table MB", "rows MB");
        folders.stream()
                .flatMap(folder -> folder.table(Kind.STRATEGIES).values("n", "mode", "loop", "strategy", "1").stream())
                .map(Integer::valueOf)
                .distinct()
                .sorted()
                .forEach(n -> grid.add(
                        Numbers.whole(n),
                        megabytes(folders, n, "1", "collision_bytes"),
                        megabytes(folders, n, "1", "table_bytes"),
                        megabytes(folders, n, "2", "table_bytes")));
        return grid;
    }

    private static String megabytes(List<ResultsFolder> folders, int n, String strategy, String column) {
        return folders.stream()
                .map(folder -> folder.table(Kind.STRATEGIES))
                .flatMap(table -> table.values(column, "n", Integer.toString(n), "strategy", strategy).stream())
                .filter(bytes -> !bytes.isEmpty())
                .map(bytes -> Numbers.brief(Numbers.parse(bytes) / 1e6))
                .findFirst()
                .orElse("-");
    }

    /** Wrong slots of the computed indexing by n, with a column for each device. */
    static Grid accuracy(List<ResultsFolder> folders) {
        List<String> header = new ArrayList<>(List.of("circles", "slots"));
        Map<Long, List<String>> rows = new TreeMap<>();
        for (ResultsFolder folder : folders) {
            for (String device : devices(folder)) {
                for (Map<String, String> row : folder.table(Kind.ACCURACY).rows("device", device)) {
                    boolean first = row.get("n").startsWith("first");
                    String circles = Numbers.whole(row.get("circles"));
                    String wrong = row.get("wrong_slots");
                    String none = first ? "none up to " + circles : "-";
                    List<String> cells = rows.computeIfAbsent(
                            first ? Long.MAX_VALUE : Long.valueOf(row.get("circles")),
                            n -> new ArrayList<>(
                                    first
                                            ? List.of("first n with a wrong slot", "")
                                            : List.of(circles, Numbers.whole(row.get("slots")))));
                    pad(cells, header.size()).add(wrong.isEmpty() ? none : first ? circles : Numbers.whole(wrong));
                }
                header.add(folder.name() + ", " + device);
            }
        }
        Grid grid = Grid.ofNumbers(header.toArray(new String[0]));
        rows.values().forEach(cells -> grid.add(pad(cells, header.size())));
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
                ("n,strategy,update µs,detect µs,resolve µs,MB that must move,copy GB/s,roof ms,share of roof")
                        .split(","));
        List<Map<String, String>> rows = folder.table(Kind.ROOF).rows("device", device);
        rows.sort(Comparator.comparing((Map<String, String> row) -> Integer.valueOf(row.get("n")))
                .thenComparing(row -> row.get("strategy")));
        for (Map<String, String> row : rows) {
            Map<String, String> run = run(
                    folder, device, Integer.parseInt(row.get("strategy")), Integer.parseInt(row.get("n")), "profiled");
            grid.add(
                    Numbers.whole(row.get("n")),
                    row.get("strategy"),
                    Numbers.brief(run.get("update_us")),
                    Numbers.brief(run.get("detect_us")),
                    Numbers.brief(run.get("resolve_us")),
                    Numbers.brief(Numbers.parse(row.get("moved_bytes")) / 1e6),
                    Numbers.brief(row.get("copy_gb_per_s")),
                    Numbers.brief(row.get("roof_ms")),
                    Numbers.percent(row.get("share_of_roof")));
        }
        return grid;
    }

    /** Speed and quality of the engines on a scene. */
    static Grid peers(ResultsFolder folder, String scene) {
        Grid grid = Grid.ofNumbers(("engine,n,ms a step,after steps,mean depth,max depth,deep pairs,energy a circle,"
                        + "KB allocated a step,peak MiB")
                .split(","));
        for (Map<String, String> row : folder.table(Kind.PEERS).rows("scene", scene)) {
            if (!LeftOut.is(row)) {
                boolean ok = ok(row);
                String energy = row.get("kinetic_energy");
                grid.add(
                        row.get("engine"),
                        Numbers.whole(row.get("n")),
                        millis(row),
                        ok ? stepsOf(row) : "-",
                        Numbers.brief(row.get("mean_depth")),
                        Numbers.brief(row.get("max_depth")),
                        ok ? Numbers.whole(Math.round(Numbers.parse(row.get("deep_pairs")))) : "-",
                        energy.isEmpty() ? "-" : String.format(Locale.ROOT, "%.1e", Numbers.parse(energy)),
                        Numbers.brief(Numbers.parse(row.get("allocated_bytes")) / 1000),
                        Numbers.brief(row.get("peak_rss_mib")));
            }
        }
        return grid;
    }

    /** The steps of a scene at the end of a run. */
    static String stepsOf(Map<String, String> run) {
        return Integer.toString(Integer.parseInt(run.get("skipped")) + Integer.parseInt(run.get("steps")));
    }

    /** The plain loop in Java beside Circles2D on a device, on the scene packed. */
    static Grid plainLoop(ResultsFolder folder, String device) {
        Grid grid = Grid.ofNumbers("n", "java-all-pairs ms", "look-up table ms", "exact ms", "faster than both");
        for (Map<String, String> loop :
                folder.table(Kind.PEERS).rows("engine", "java-all-pairs", "scene", "packed", "status", "ok")) {
            Map<String, String> lookup = same(loop, Engines.thesis(PairIndexing.LOOKUP_TABLE) + "@" + device, folder);
            Map<String, String> exact = same(loop, Engines.thesis(PairIndexing.EXACT) + "@" + device, folder);
            if (lookup != null && exact != null) {
                double best = Math.min(Numbers.parse(lookup.get("mean_ms")), Numbers.parse(exact.get("mean_ms")));
                boolean faster = Numbers.parse(loop.get("mean_ms")) < best;
                String n = Numbers.whole(loop.get("n"));
                grid.add(n, millis(loop), millis(lookup), millis(exact), faster ? "the loop" : "no");
            }
        }
        return grid;
    }

    /** The run of another engine with the same scene, n and steps; null if there is none. */
    private static Map<String, String> same(Map<String, String> run, String engine, ResultsFolder folder) {
        String scene = run.get("scene");
        return folder.table(Kind.PEERS)
                .row("engine", engine, "scene", scene, "n", run.get("n"), "steps", run.get("steps"), "status", "ok");
    }
}
