package io.github.circles2d.bench.report;

import io.github.circles2d.bench.engines.Engines;
import io.github.circles2d.bench.measure.Series;
import io.github.circles2d.bench.results.Numbers;
import io.github.circles2d.bench.results.Resources;
import io.github.circles2d.bench.results.ResultsFolder;
import io.github.circles2d.bench.results.ResultsFolder.Kind;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Writes the results pages: one of all machines by the template {@code page.md}, and one of each by {@code machine.md}. In a
 * template {@code {{name}}} on a line by itself stands for a table or chart, and {@code {{machine table key .. column}}}
 * within a sentence for one figure out of a results folder. So every measured figure on the pages comes from a committed
 * file.
 */
public final class Page {
    private static final Pattern PLACE = Pattern.compile("\\{\\{([^}]*)\\}\\}");

    private static final String NOTHING = "*There are no results yet.*\n";

    /** The file that names the folders of the page. */
    public static final String MACHINES = "machines.txt";

    private final List<ResultsFolder> folders;
    private final Map<String, Supplier<String>> parts = new HashMap<>();

    Page(List<ResultsFolder> folders) {
        this.folders = folders;
        parts.put("conclusions", this::conclusions);
        parts.put("name", () -> folders.get(0).name());
        parts.put("machines", () -> Tables.machines(folders).markdown());
        part("figure3", () -> perDevice(this::figure3));
        part("device-only", () -> perDevice((folder, device) -> block(Tables.modes(folder, device))));
        table("findings", () -> Findings.grid(folders));
        table("accuracy", () -> Tables.accuracy(folders));
        table("memory", () -> Tables.memory(folders));
        part("roof", () -> perDevice((folder, device) -> block(Tables.roof(folder, device))));
        part("plain loop", () -> perDevice((folder, device) -> block(Tables.plainLoop(folder, device))));
        part("peers packed", () -> peers("packed"));
        part("peers thesis", () -> peers("thesis"));
        part("engines", Page::engines);
        table("series headline", () -> SeriesTables.headline(folders));
        parts.put(
                "series charts",
                () -> Stream.of(Series.values()).map(this::seriesChart).collect(Collectors.joining()));
        part("surfaces cost", () -> beside("surfaces", SurfaceTables::cost));
        part("surfaces engines", () -> beside("surfaces", SurfaceTables::engines));
        part("terrain cost", () -> beside("terrain", TerrainTables::cost));
        part("terrain engines", () -> beside("terrain", TerrainTables::engines));
        part("joints cost", () -> beside("joints", JointTables::cost));
        part("joints swarm", () -> beside("joints", JointTables::swarm));
        part("sleep cost", () -> beside("sleep", SleepTables::cost));
        part("busy steps", () -> beside("busy", BusyTables::steps));
        part("sensed cost", () -> beside("events", SensedTables::cost));
        part("bodies cost", () -> beside("bodies", BodyTables::cost));
        part("bodies on a device", () -> beside("bodies", BodyTables::devices));
        part("moves", () -> beside("moves", Moves::totals));
        part("moves times", () -> beside("moves", Moves::times));
        parts.put("moves chart", () -> picture("ms a frame by frame", "moves/" + Moves.FILE));
        part("series steps", () -> Stream.of(Series.values()).map(this::series).collect(Collectors.joining()));
        parts.put("series outside", () -> SeriesTables.outside(folders));
        parts.put("world chart", () -> chart(folders.get(0).name() + "/", WorldCharts.FILE));
        table("world targets", () -> Targets.times(folders));
        table("world ratios", () -> Targets.ratios(folders));
        table("world growth", () -> Targets.growth(folders));
        part("world steps", () -> perMachine("", folder -> block(WorldTables.steps(folder)), LeftOut::world));
        table("world bits", () -> WorldTables.bits(folders));
        part(
                "world stages",
                () -> perDevice((folder, device) -> block(WorldTables.stages(folder, Engines.world(device)))));
        table("world traffic", WorldTables::traffic);
        part("world storms", () -> perMachine("", folder -> block(WorldTables.storms(folder)), folder -> ""));
        part("world transfers", () -> perDevice((folder, device) -> block(WorldTables.transfers(folder, device))));
        part("world quality", this::quality);
        part("web", () -> perMachine("", folder -> block(WebTables.steps(folder)), this::webRest));
    }

    private void part(String name, Supplier<String> text) {
        parts.put(name, () -> {
            String filled = text.get();
            return filled.isEmpty() ? NOTHING : filled;
        });
    }

    private void table(String name, Supplier<Grid> grid) {
        part(name, () -> grid.get().markdown());
    }

    /** The page of the folders that {@code machines.txt} in {@code results} names, one a line and in this order. */
    public static String of(Path results) throws IOException {
        return new Page(folders(results)).fill(Resources.text("page.md")).stripTrailing() + "\n";
    }

    /** The page of one machine, without the sections for which the machine has no results. */
    static String ofMachine(ResultsFolder folder) {
        String page = new Page(List.of(folder)).fill(Resources.text("machine.md"));
        String kept = Stream.of(page.split("(?m)^(?=## )"))
                .filter(section -> !section.contains(NOTHING))
                .collect(Collectors.joining());
        return kept.stripTrailing() + "\n";
    }

    /**
     * The pages by their file names: {@code page} of all machines, and one of each beside it. They link to the charts as
     * {@code ../bench/results}.
     */
    public static Map<Path, String> all(Path results, Path page) throws IOException {
        Map<Path, String> pages = new LinkedHashMap<>();
        pages.put(page, of(results));
        for (ResultsFolder folder : folders(results)) {
            pages.put(page.resolveSibling(fileOf(folder)), ofMachine(folder));
        }
        return pages;
    }

    /** The file name of a machine's page. */
    static String fileOf(ResultsFolder folder) {
        return "benchmarks-" + folder.name() + ".md";
    }

    /** The folders that {@code machines.txt} names. Other folders are someone's own. */
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

    /** Puts tables and figures in their places. */
    String fill(String template) {
        return PLACE.matcher(template)
                .replaceAll(place -> {
                    String name = place.group(1).trim();
                    Supplier<String> part = parts.get(name);
                    return Matcher.quoteReplacement(part == null ? figure(name) : part.get());
                })
                .replaceAll("\n{3,}", "\n\n");
    }

    /** The conclusions are drawn from certain machines; a page of others goes without. */
    private String conclusions() {
        String conclusions = Resources.text("conclusions.md");
        List<String> names = folders.stream().map(ResultsFolder::name).toList();
        boolean machinesAreThere = PLACE.matcher(conclusions)
                .results()
                .map(place -> place.group(1).trim().split("\\s+")[0])
                .allMatch(names::contains);
        return machinesAreThere ? fill(conclusions) : "";
    }

    /** A table from the folder beside those of the machines. */
    /** A table of a folder beside those of the machines. */
    private String beside(String folder, Function<Path, String> table) {
        return folders.isEmpty() ? "" : table.apply(folders.get(0).path().resolveSibling(folder));
    }

    private static String engines() {
        return Stream.concat(Engines.PEERS.stream(), Stream.of(Engines.WORLD_JVM, "world@device", "circles2d-*"))
                .map(name -> "- **" + name + "**: " + Engines.remarks(name) + ".\n")
                .collect(Collectors.joining());
    }

    private String figure3(ResultsFolder folder, String device) {
        return Tables.sizes(folder, device).isEmpty()
                ? ""
                : "Thesis: " + Figure3.device(Tables.kind(folder, device)) + ".\n\n"
                        + block(Tables.figure3(folder, device))
                        + chart(folder.name() + "/", Charts.strategiesFile(device))
                        + missing(folder, Kind.STRATEGIES, "device", device)
                        + LeftOut.strategies(folder, device);
    }

    private String peers(String scene) {
        return perMachine(
                ", scene " + scene,
                folder -> block(Tables.peers(folder, scene)),
                folder -> chart(folder.name() + "/", Charts.peersFile(scene))
                        + missing(folder, Kind.PEERS, "scene", scene)
                        + LeftOut.engines(folder, scene));
    }

    private String series(Series series) {
        String description = series.description;
        return section(
                series.title,
                description.substring(0, 1).toUpperCase(Locale.ROOT) + description.substring(1) + ".\n\n"
                        + block(SeriesTables.steps(folders, series))
                        + SeriesTables.failures(folders, series)
                        + SeriesTables.notMeasured(folders, series)
                        + "\n");
    }

    /** The chart under the name of the series and what it is; empty if it is not drawn. */
    private String seriesChart(Series series) {
        String chart = chart("", SeriesCharts.file(series));
        return chart.isEmpty() ? "" : "**" + series.title + "**: " + series.description + ".\n\n" + chart;
    }

    private String webRest(ResultsFolder folder) {
        return "As multiples of World on the JVM:\n\n"
                + block(WebTables.ratios(folder))
                + picture("µs a step by number of circles", folder.name() + "/" + WebCharts.FILE)
                + "Versions: " + WebTables.programs(folder) + ".\n\n";
    }

    private String quality() {
        StringBuilder text = new StringBuilder();
        for (ResultsFolder folder : folders) {
            for (int n : WorldCharts.QUALITY_SIZES) {
                String what = "mean depth by ms a step, n = " + Numbers.whole(n) + ", " + folder.name();
                text.append(picture(what, folder.name() + "/" + WorldCharts.qualityFile(n)));
            }
        }
        return text.toString();
    }

    private String chart(String folder, String file) {
        return picture("ms a step by number of circles", folder + file);
    }

    private String picture(String what, String file) {
        boolean drawn = !folders.isEmpty() && Files.exists(folders.get(0).path().resolveSibling(file + ".svg"));
        return drawn ? "![" + what + "](../bench/results/" + file + ".svg)\n\n" : "";
    }

    private String perMachine(
            String title, Function<ResultsFolder, String> text, Function<ResultsFolder, String> below) {
        return folders.stream()
                .filter(folder -> !text.apply(folder).isEmpty())
                .map(folder -> section(folder.name() + title, text.apply(folder) + below.apply(folder)))
                .collect(Collectors.joining());
    }

    private String perDevice(BiFunction<ResultsFolder, String, String> text) {
        return folders.stream()
                .flatMap(folder -> Tables.devices(folder).stream()
                        .map(device -> section(folder.name() + ", " + device, text.apply(folder, device))))
                .collect(Collectors.joining());
    }

    private static String section(String title, String text) {
        return text.isEmpty() ? "" : "### " + title + "\n\n" + text;
    }

    private static String block(Grid grid) {
        return grid.isEmpty() ? "" : grid.markdown() + "\n";
    }

    /** What failed or did not fit. */
    private static String missing(ResultsFolder folder, Kind kind, String column, String value) {
        String list = folder.table(kind).rows(column, value).stream()
                .filter(row -> !Tables.ok(row) && !LeftOut.is(row) && !LeftOut.followsFromASmallerSize(row))
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
        Kind kind = Kind.valueOf(words[1].toUpperCase(Locale.ROOT));
        List<String> key = Arrays.stream(words, 2, words.length - 1)
                .map(word -> word.replace('_', ' '))
                .toList();
        return folders.stream()
                .filter(folder -> folder.name().equals(words[0]))
                .flatMap(folder -> folder.table(kind).rows().stream()
                        .filter(row -> folder.table(kind).key(row).equals(key)))
                .map(row -> row.getOrDefault(words[words.length - 1], ""))
                .filter(value -> !value.isEmpty())
                .map(Numbers::brief)
                .findFirst()
                .orElseThrow(
                        () -> new IllegalArgumentException("there is no figure in the results for {{" + place + "}}"));
    }
}
