package io.github.circles2d.bench.report;

import io.github.circles2d.bench.engines.Engines;
import io.github.circles2d.bench.results.Numbers;
import io.github.circles2d.bench.results.ResultsFolder;
import io.github.circles2d.bench.results.ResultsFolder.Kind;
import io.github.circles2d.bench.series.Series;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Writes the results pages: one of all machines by the template {@code page.md}, and one of each by {@code machine.md}. In a template
 * {@code {{name}}} on a line of its own stands for a table or chart, and {@code {{machine table key .. column}}} within a sentence for one
 * figure out of a results folder. So every measured figure on the pages comes from a committed file.
 */
public final class Page {
    private static final Pattern PLACE = Pattern.compile("\\{\\{([^}]*)\\}\\}");

    private static final String NOTHING = "*There are no results yet.*\n";

    /** The file that names the folders of the page. */
    public static final String MACHINES = "machines.txt";

    private final List<ResultsFolder> folders;

    Page(List<ResultsFolder> folders) {
        this.folders = folders;
    }

    /**
     * The page for the folders that {@code machines.txt} in {@code results} names, one a line and in this order; it links
     * them as {@code ../bench/results}. Other folders are someone's own and stay out of it.
     */
    public static String of(Path results) throws IOException {
        return new Page(folders(results)).fill(template()).stripTrailing() + "\n";
    }

    /** The page of one machine, without the sections of which the machine has nothing. */
    public static String ofMachine(ResultsFolder folder) {
        String page = new Page(List.of(folder)).fill(machine());
        return Stream.of(page.split("(?m)^(?=## )"))
                        .filter(section -> !section.contains(NOTHING))
                        .collect(Collectors.joining())
                        .stripTrailing()
                + "\n";
    }

    /** The pages by their file names: the one of all machines, and beside it one of each. */
    public static Map<Path, String> all(Path results, Path page) throws IOException {
        Map<Path, String> pages = new LinkedHashMap<>();
        pages.put(page, of(results));
        for (ResultsFolder folder : folders(results)) {
            pages.put(page.resolveSibling(fileOf(folder)), ofMachine(folder));
        }
        return pages;
    }

    private static String fileOf(ResultsFolder folder) {
        return "benchmarks-" + folder.name() + ".md";
    }

    /** The folders that {@code machines.txt} names. */
    public static List<ResultsFolder> folders(Path results) throws IOException {
        List<ResultsFolder> folders = new ArrayList<>();
        for (String name : Files.readAllLines(results.resolve(MACHINES))) {
            if (!Files.isDirectory(results.resolve(name))) {
                throw new IllegalArgumentException(
                        "machines.txt names " + name + ", but there is no such folder in " + results);
            }
            folders.add(ResultsFolder.open(results.resolve(name)));
        }
        return folders;
    }

    /** The page's prose, with places for tables and figures. */
    static String template() {
        return resource("page.md");
    }

    /** What follows from the committed results, with places for figures. */
    static String conclusions() {
        return resource("conclusions.md");
    }

    /** The prose of a machine's page, with places for tables. */
    static String machine() {
        return resource("machine.md");
    }

    private static String resource(String name) {
        try (InputStream in = Page.class.getResourceAsStream("/io/github/circles2d/bench/" + name)) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Puts tables and figures in their places. */
    String fill(String template) {
        String page = PLACE.matcher(template)
                .replaceAll(
                        place -> Matcher.quoteReplacement(value(place.group(1).trim())));
        return page.replaceAll("\n{3,}", "\n\n");
    }

    private String value(String place) {
        switch (place) {
            case "conclusions":
                return machinesOfConclusionsAreThere() ? fill(conclusions()) : "";
            case "machine rows":
                return machines();
            case "machine facts":
                return machines().isEmpty() ? "" : machineHead() + machines();
            case "name":
                return folders.get(0).name();

            case "figure3":
                return orNothing(figure3());
            case "device-only":
                return orNothing(deviceOnly());
            case "findings":
                return folders.isEmpty() ? NOTHING : Findings.grid(folders).markdown();
            case "accuracy":
                return orNothing(grid(Tables.accuracyByDevice(folders)));
            case "memory":
                return orNothing(memory());
            case "roof":
                return orNothing(perDevice(Tables::roof));
            case "plain loop":
                return orNothing(perDevice(Tables::plainLoop));
            case "peers packed":
                return orNothing(peers("packed"));
            case "peers thesis":
                return orNothing(peers("thesis"));
            case "engines":
                return Stream.concat(
                                Engines.PEERS.stream(), Stream.of(Engines.WORLD_JVM, "world@device", "circles2d-*"))
                        .map(name -> "- **" + name + "**: " + Engines.remarks(name) + ".\n")
                        .collect(Collectors.joining());
            case "series headline":
                return orNothing(grid(SeriesTables.headline(folders)));
            case "series charts":
                return seriesCharts();
            case "series steps":
                return orNothing(allSeries());
            case "series outside":
                return SeriesTables.outside(folders);
            default:
                return place.startsWith("world") ? world(place) : figure(place);
        }
    }

    /** A chart of each series that is drawn, under its name and what it is. */
    private String seriesCharts() {
        StringBuilder text = new StringBuilder();
        for (Series series : Series.values()) {
            String file = SeriesCharts.file(series);
            if (!folders.isEmpty() && Files.exists(folders.get(0).path().resolveSibling(file + ".svg"))) {
                text.append("**")
                        .append(series.title)
                        .append("**: ")
                        .append(series.description)
                        .append(".\n\n");
                text.append("![ms a step by number of circles](../bench/results/")
                        .append(file)
                        .append(".svg)\n\n");
            }
        }
        return text.toString();
    }

    private String allSeries() {
        StringBuilder text = new StringBuilder();
        for (Series series : Series.values()) {
            text.append("### ").append(series.title).append("\n\n");
            String description = series.description;
            text.append(description.substring(0, 1).toUpperCase(Locale.ROOT))
                    .append(description.substring(1))
                    .append(".\n\n");
            text.append(grid(SeriesTables.steps(folders, series))).append('\n');
            text.append(SeriesTables.failures(folders, series));
            text.append(SeriesTables.notMeasured(folders, series)).append('\n');
        }
        return text.toString();
    }

    /** World's parts. */
    private String world(String place) {
        switch (place) {
            case "world bits":
                return orNothing(grid(WorldTables.bits(folders)));
            case "world chart":
                return chart(folders.get(0), WorldCharts.FILE);
            case "world targets":
                return orNothing(grid(Targets.times(folders)));
            case "world ratios":
                return orNothing(grid(Targets.ratios(folders)));
            case "world growth":
                return orNothing(grid(Targets.growth(folders)));
            case "world steps":
                return orNothing(perMachine(WorldTables::steps, LeftOut::world));
            case "world stages":
                return orNothing(perDevice((folder, device) -> WorldTables.stages(folder, Engines.world(device))));
            case "world traffic":
                return WorldTables.traffic().markdown();
            case "world storms":
                return orNothing(perMachine(WorldTables::storms, folder -> ""));
            case "world transfers":
                return orNothing(perDevice(WorldTables::transfers));
            case "world quality":
                return orNothing(qualityCharts());
            default:
                throw new IllegalArgumentException("the page has no part {{" + place + "}}");
        }
    }

    private String qualityCharts() {
        StringBuilder text = new StringBuilder();
        for (ResultsFolder folder : folders) {
            for (int n : WorldCharts.QUALITY_SIZES) {
                String file = WorldCharts.qualityFile(n) + ".svg";
                if (Files.exists(folder.path().resolve(file))) {
                    text.append("![mean depth by ms a step, n = ")
                            .append(Numbers.whole(n))
                            .append(", ")
                            .append(folder.name())
                            .append("](../bench/results/")
                            .append(folder.name())
                            .append("/")
                            .append(file)
                            .append(")\n\n");
                }
            }
        }
        return text.toString();
    }

    private String perMachine(Function<ResultsFolder, Grid> table, Function<ResultsFolder, String> below) {
        StringBuilder text = new StringBuilder();
        for (ResultsFolder folder : folders) {
            String grid = grid(table.apply(folder));
            if (!grid.isEmpty()) {
                text.append("### ")
                        .append(folder.name())
                        .append("\n\n")
                        .append(grid)
                        .append('\n');
                text.append(below.apply(folder));
            }
        }
        return text.toString();
    }

    /** The conclusions are drawn from certain machines; a page of others goes without. */
    private boolean machinesOfConclusionsAreThere() {
        List<String> names = folders.stream().map(ResultsFolder::name).collect(Collectors.toList());
        return PLACE.matcher(conclusions())
                .results()
                .map(place -> place.group(1).trim().split("\\s+")[0])
                .allMatch(names::contains);
    }

    private static String orNothing(String text) {
        return text.isEmpty() ? NOTHING : text;
    }

    private static String grid(Grid grid) {
        return grid.isEmpty() ? "" : grid.markdown();
    }

    private static String machineHead() {
        return "| machine | processor | device | Java | date |\n|---|---|---|---|---|\n";
    }

    private String machines() {
        StringBuilder rows = new StringBuilder();
        for (ResultsFolder folder : folders) {
            for (String device : Tables.devices(folder)) {
                rows.append(String.join(
                        " | ",
                        "| [" + folder.name() + "](" + fileOf(folder) + ")",
                        folder.machine("processor") + ", " + folder.machine("cores") + " cores, "
                                + folder.machine("memory GiB") + " GiB; " + folder.machine("system"),
                        "**" + device + "**: " + folder.machine("device " + device),
                        folder.machine("java"),
                        folder.machine("date") + " |\n"));
            }
        }
        return rows.toString();
    }

    private String figure3() {
        StringBuilder text = new StringBuilder();
        for (ResultsFolder folder : folders) {
            for (String device : Tables.devices(folder)) {
                if (Tables.sizes(folder, device).isEmpty()) {
                    continue;
                }
                String thesis = Figure3.device(Tables.kind(folder, device));
                text.append("### ")
                        .append(folder.name())
                        .append(", ")
                        .append(device)
                        .append("\n\n");
                text.append("Thesis: ").append(thesis).append(".\n\n");
                text.append(Tables.figure3(folder, device, "loop").markdown()).append('\n');
                text.append(chart(folder, Charts.strategiesFile(device)));
                text.append(missing(folder, Kind.STRATEGIES, "device", device));
                text.append(LeftOut.strategies(folder, device));
            }
        }
        return text.toString();
    }

    private String deviceOnly() {
        return perDevice((folder, device) -> {
            Grid grid = Grid.ofNumbers("n", "strategy", "with read-back", "device alone", "with profiling events");
            for (int n : Tables.sizes(folder, device)) {
                for (int strategy = 0; strategy < 4 && Tables.measured(folder, device, n); strategy++) {
                    List<String> row = new ArrayList<>(List.of(Numbers.whole(n), Integer.toString(strategy)));
                    for (String mode : List.of("loop", "deviceOnly", "profiled")) {
                        row.add(Tables.millis(Tables.run(folder, device, strategy, n, mode)));
                    }
                    grid.add(row);
                }
            }
            return grid;
        });
    }

    private String memory() {
        Grid grid = Grid.ofNumbers("n", "collision buffer MB", "look-up table MB", "rows MB");
        folders.stream()
                .flatMap(folder -> folder.table(Kind.STRATEGIES).rows("mode", "loop", "strategy", "1").stream())
                .map(row -> Integer.valueOf(row.get("n")))
                .distinct()
                .sorted()
                .forEach(n -> grid.add(List.of(
                        Numbers.whole(n),
                        megabytes(n, 1, "collision_bytes"),
                        megabytes(n, 1, "table_bytes"),
                        megabytes(n, 2, "table_bytes"))));
        return grid(grid);
    }

    private String megabytes(int n, int strategy, String column) {
        return folders.stream()
                .flatMap(
                        folder -> folder
                                .table(Kind.STRATEGIES)
                                .rows("n", Integer.toString(n), "strategy", Integer.toString(strategy))
                                .stream())
                .map(row -> Numbers.parse(row.get(column)))
                .filter(Double::isFinite)
                .map(bytes -> Numbers.brief(bytes / 1e6))
                .findFirst()
                .orElse("-");
    }

    private String peers(String scene) {
        StringBuilder text = new StringBuilder();
        for (ResultsFolder folder : folders) {
            String table = grid(Tables.peers(folder, scene));
            if (!table.isEmpty()) {
                text.append("### ")
                        .append(folder.name())
                        .append(", scene ")
                        .append(scene)
                        .append("\n\n");
                text.append(table).append('\n').append(chart(folder, Charts.peersFile(scene)));
                text.append(missing(folder, Kind.PEERS, "scene", scene));
                text.append(LeftOut.engines(folder, scene));
            }
        }
        return text.toString();
    }

    private String perDevice(BiFunction<ResultsFolder, String, Grid> table) {
        StringBuilder text = new StringBuilder();
        for (ResultsFolder folder : folders) {
            for (String device : Tables.devices(folder)) {
                String grid = grid(table.apply(folder, device));
                if (!grid.isEmpty()) {
                    text.append("### ")
                            .append(folder.name())
                            .append(", ")
                            .append(device)
                            .append("\n\n");
                    text.append(grid).append('\n');
                }
            }
        }
        return text.toString();
    }

    private static String chart(ResultsFolder folder, String file) {
        return Files.exists(folder.path().resolve(file + ".svg"))
                ? "![ms a step by number of circles](../bench/results/" + folder.name() + "/" + file + ".svg)\n\n"
                : "";
    }

    /** What failed or did not fit. */
    private static String missing(ResultsFolder folder, Kind kind, String column, String value) {
        String list = folder.table(kind).rows(column, value).stream()
                .filter(row ->
                        !row.get("status").equals("ok") && !LeftOut.is(row) && !LeftOut.followsFromASmallerSize(row))
                .map(row -> "- " + String.join(" ", folder.table(kind).key(row)) + ": " + row.get("status") + "\n")
                .collect(Collectors.joining());
        return list.isEmpty()
                ? ""
                : "Without a figure (where one size does not fit, larger ones were not tried):\n\n" + list + "\n";
    }

    /** One figure: folder, table, the key's values in order with _ for a space, column. */
    private String figure(String place) {
        String[] words = place.split("\\s+");
        if (words.length < 4) {
            throw new IllegalArgumentException("the page has no part {{" + place + "}}");
        }
        ResultsFolder folder = one(folders, f -> f.name().equals(words[0]), place);
        Kind kind = Kind.valueOf(words[1].toUpperCase(Locale.ROOT));
        List<String> key = Stream.of(words)
                .skip(2)
                .limit(words.length - 3)
                .map(word -> word.replace('_', ' '))
                .collect(Collectors.toList());
        Map<String, String> row =
                one(folder.table(kind).rows(), r -> folder.table(kind).key(r).equals(key), place);
        String value = row.getOrDefault(words[words.length - 1], "");
        if (value.isEmpty()) {
            throw new IllegalArgumentException("there is no figure for {{" + place + "}}");
        }
        return Numbers.brief(Numbers.parse(value));
    }

    private static <T> T one(List<T> all, Predicate<T> wanted, String place) {
        return all.stream()
                .filter(wanted)
                .findFirst()
                .orElseThrow(
                        () -> new IllegalArgumentException("there is nothing in the results for {{" + place + "}}"));
    }
}
