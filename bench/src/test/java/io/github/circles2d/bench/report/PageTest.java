package io.github.circles2d.bench.report;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.circles2d.bench.measure.Series;
import io.github.circles2d.bench.results.Resources;
import io.github.circles2d.bench.results.ResultsFolder;
import io.github.circles2d.bench.results.ResultsFolder.Kind;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class PageTest {
    private static final Path RESULTS = Path.of("results");
    private static final Path PAGE = Path.of("../docs/benchmarks.md");

    @TempDir
    Path temporary;

    private ResultsFolder folder;

    @BeforeEach
    void measure() throws IOException {
        Files.writeString(temporary.resolve("machines.txt"), "box\n");
        folder = ResultsFolder.open(temporary.resolve("box"));
        folder.put(
                Kind.MACHINE,
                Map.of("property", "device gpu", "value", "Some GPU (GPU, 10 compute units, 1.0 GiB, P, driver 1)"));
        double[] millis = {1.25, 2.5, 3.75, 1.0};
        for (int strategy = 0; strategy < 4; strategy++) {
            folder.put(
                    Kind.STRATEGIES,
                    Map.of(
                            "device",
                            "gpu",
                            "strategy",
                            Integer.toString(strategy),
                            "n",
                            "15000",
                            "mode",
                            "loop",
                            "mean_ms",
                            Double.toString(millis[strategy]),
                            "se_ms",
                            "0.01",
                            "collision_bytes",
                            "899940000",
                            "table_bytes",
                            strategy == 1 ? "899940000" : "0",
                            "status",
                            "ok"));
        }
        folder.put(
                Kind.STRATEGIES,
                Map.of(
                        "device",
                        "gpu",
                        "strategy",
                        "1",
                        "n",
                        "65000",
                        "mode",
                        "loop",
                        "status",
                        "does not fit: DeviceMemoryException: 65000 circles need too much"));
        folder.put(
                Kind.ACCURACY,
                Map.of(
                        "device",
                        "gpu",
                        "n",
                        "first wrong",
                        "circles",
                        "2050",
                        "slots",
                        "2100225",
                        "wrong_slots",
                        "1",
                        "status",
                        "ok"));
    }

    @Test
    void theCommittedPagesAreWhatTheCommittedResultsGive() throws IOException {
        Map<Path, String> pages = Page.all(RESULTS, PAGE);
        assertThat(pages).hasSize(1 + Page.folders(RESULTS).size());
        for (Map.Entry<Path, String> page : pages.entrySet()) {
            assertThat(Files.readString(page.getKey()))
                    .as("run: java -jar bench/target/benchmarks.jar page bench/results docs/benchmarks.md")
                    .isEqualTo(page.getValue());
        }
    }

    @Test
    void theProseItselfHoldsNoMeasuredFigure() {
        String prose = Stream.of("page.md", "conclusions.md", "machine.md")
                .map(Resources::text)
                .collect(Collectors.joining())
                .replaceAll("\\{\\{[^}]*\\}\\}", "");
        assertThat(Pattern.compile("[0-9][0-9.,]* ?(ms|µs|us|GB|MB|GiB|MiB|KB|%|times)\\b")
                        .matcher(prose)
                        .results()
                        .map(match -> match.group())
                        .filter(figure -> !figure.equals("1/60 s")))
                .isEmpty();
    }

    @Test
    void everyChartThatAPageShowsIsCommitted() throws IOException {
        for (String page : Page.all(RESULTS, PAGE).values()) {
            List<Path> charts = Pattern.compile("\\]\\((\\.\\./bench/results[^)]*)\\)")
                    .matcher(page)
                    .results()
                    .map(link -> PAGE.resolveSibling(link.group(1)).normalize())
                    .toList();
            assertThat(charts).isNotEmpty().allSatisfy(chart -> assertThat(chart)
                    .exists());
        }
    }

    @Test
    void ourTableStandsBesideTheThesiss() throws IOException {
        assertThat(machinePage())
                .contains("### box, gpu")
                .contains("| 15,000 | 16 | 26 | 36 | 1.3 ± 0.01 | 2.5 ± 0.01 | 3.8 ± 0.01 | 1 ± 0.01 |")
                .contains("| 65,000 | - | - | - | - | does not fit | - | - |")
                .contains("- gpu 1 65000 loop: does not fit: DeviceMemoryException: 65000 circles need too much");
    }

    @Test
    void conclusionsStandOnThePageOfTheMachinesThatTheyAreDrawnFromAndOnNoOther() throws IOException {
        assertThat(Page.of(RESULTS)).contains("## In short", "compute the pair");
        assertThat(Page.of(temporary)).doesNotContain("## In short");
    }

    /** A page of runs that were not made would hide those that were. */
    @Test
    void whatWasLeftOutIsNamedInALineForAllSizesThatLackTheSame() throws IOException {
        for (int n : new int[] {20_000, 30_000}) {
            for (String strategy : List.of("0", "3")) {
                for (String mode : List.of("loop", "deviceOnly")) {
                    boolean measured = strategy.equals("3") && mode.equals("loop");
                    folder.put(
                            Kind.STRATEGIES,
                            Map.of(
                                    "device",
                                    "gpu",
                                    "strategy",
                                    strategy,
                                    "n",
                                    Integer.toString(n),
                                    "mode",
                                    mode,
                                    "mean_ms",
                                    measured ? "7" : "",
                                    "se_ms",
                                    measured ? "1" : "",
                                    "status",
                                    measured ? "ok" : "left out: it would take about 9 s, 1 s are there for it"));
                }
            }
        }
        folder.put(
                Kind.STRATEGIES,
                Map.of("device", "gpu", "strategy", "0", "n", "46000", "mode", "loop", "status", "left out: no time"));
        assertThat(machinePage())
                .contains("| 20,000 | - | - | - | left out | - | - | 7 ± 1 |")
                .contains("- n = 20,000, 30,000: strategies 0, 3 (deviceOnly)\n")
                .contains("- n = 46,000: strategy 0\n")
                .doesNotContain("| 46,000 |")
                .doesNotContain("9 s");
    }

    @Test
    void theFindingsFollowFromTheResults() throws IOException {
        assertThat(Page.of(temporary))
                .contains(
                        "| on the GPU strategy 0 is fastest and 2 is slowest | box, gpu | yes | at n = 15,000 strategies 0,"
                                + " 1, 2 take 1.3, 2.5, 3.8 ms; the fastest of all four is 3 exact |")
                .contains("| in kind | the first wrong slot comes at n = 2,050 |");
        folder.put(
                Kind.STRATEGIES,
                Map.of(
                        "device",
                        "gpu",
                        "strategy",
                        "0",
                        "n",
                        "15000",
                        "mode",
                        "loop",
                        "mean_ms",
                        "2.6",
                        "se_ms",
                        "0.1",
                        "status",
                        "ok"));
        assertThat(Page.of(temporary))
                .contains("| on the GPU strategy 0 is fastest and 2 is slowest | box, gpu | no |");
    }

    @Test
    void whatIsNotMeasuredOfWorldHasNoSection() throws IOException {
        assertThat(machinePage()).doesNotContain("## World\n", "## World:");
    }

    @Test
    void worldHasASectionOfItsOwnWithStepsStagesTransfersAndStorms() throws IOException {
        measureWorld();
        assertThat(machinePage())
                .contains("## World\n", "### box\n", "## World: stages and the roof")
                .contains(
                        "| world@gpu | 15,000 | 0.09 ± 0.001 | 0.2 ± 0.001 | - | - | - | 0.5 ± 0.001 | 6 | 1.8 | 0.0037 | 12 | 300 | 89abcdef |")
                .contains("| 15,000 | Grid | 10 | 1.7 | 1,000 | 1.7 | 17 % |")
                .contains("| 15,000 | Scan | 3 | - | - | - | - |")
                .contains("| 15,000 | Continuous collision | 4 | - | - | - | - |")
                .contains("| Grid | 112 | 0 |")
                .contains("| world@gpu | 15,000 | 0.2 ± 0.001 | 0.3 ± 0.001 | - |")
                .contains("| 1,048,576 | read | 0.04 ± 0.001 | - | 0.2 ± 0.001 | 26 | - | 5.2 |")
                .contains("- n = 1,000,000: world@gpu (steps, profiled)\n");
    }

    @Test
    void targetsAreHeldAgainstTheLeastMedianOfTheMachineThatTheyAreFor() throws IOException {
        measureWorld();
        assertThat(machinePage()).doesNotContain("| NVIDIA H200 |");
        folder.put(
                Kind.MACHINE,
                Map.of(
                        "property",
                        "device gpu",
                        "value",
                        "NVIDIA H200 (GPU, 132 compute units, 1.0 GiB, P, driver 1)"));
        assertThat(machinePage()).contains("| NVIDIA H200 | 15,000 | steps alone | 0.1 | 0.09 | world@gpu | yes |");
        world("world@gpu", "1250", "steps", "0.12");
        assertThat(machinePage())
                .contains("| NVIDIA H200 | 1,250 | steps alone | 0.06 | 0.12 | world@gpu | no: 2 times the aim |");
    }

    @Test
    void targetsForTwoCoresTakeTheBestOfJavaAndOpenClOnTheCpuAlone() throws IOException {
        folder.put(Kind.MACHINE, Map.of("property", "cores", "value", "2"));
        folder.put(Kind.MACHINE, Map.of("property", "device cpu", "value", "Some CPU (CPU, 2 compute units)"));
        world("world@gpu", "5000", "steps", "0.1");
        world("world@cpu", "5000", "steps", "3");
        world("world-jvm", "5000", "steps", "1.5");
        assertThat(machinePage())
                .contains("| 2 cores | 5,000 | steps alone | 1 | 1.5 | world-jvm | no: 1.5 times the aim |");
    }

    @Test
    void otherEnginesAreComparedByTheRatioOfTheMedians() throws IOException {
        world("world-jvm", "1250", "steps", "9");
        peer("world-jvm", "0.2", "0.001");
        peer("gdx-box2d", "2.5", "0.01");
        peer("java-grid", "0.1", "0.001");
        assertThat(machinePage())
                .contains("| box | 1,250 | 0.2 | gdx-box2d | 2.5 | 0.080 | 0.1 | yes |")
                .contains("| box | 1,250 | 0.2 | java-grid | 0.1 | 2.000 | 1 | no |");
    }

    @Test
    void theCostOfACircleIsComparedBetweenAHundredThousandAndTheLargestCrowd() throws IOException {
        world("world-jvm", "100000", "steps", "10");
        world("world-jvm", "1000000", "steps", "120");
        assertThat(machinePage()).contains("| box, world-jvm | 100 | 1,000,000 | 120 | 1.2 | yes |");
    }

    @Test
    void enginesThatEndInTheSameStateStandTogether() throws IOException {
        world("world-jvm", "1250", "steps", "1");
        world("world@gpu", "1250", "steps", "2");
        assertThat(Page.of(temporary))
                .contains("| 1,250 | 300 | 89abcdef12345678 | world-jvm (box), world@gpu (box) |");
    }

    @Test
    void worldIsDrawnBesideOtherEnginesAndSpeedAgainstQuality() throws IOException {
        world("world-jvm", "1250", "steps", "1");
        peer("world-jvm", "0.2", "0.001");
        peer("gdx-box2d", "2.5", "0.01");
        ByteArrayOutputStream said = new ByteArrayOutputStream();
        Charts.draw(folder, new PrintStream(said, true, StandardCharsets.UTF_8));
        Charts.drawAll(temporary, Page.folders(temporary), new PrintStream(said, true, StandardCharsets.UTF_8));
        assertThat(said.toString(StandardCharsets.UTF_8).lines())
                .contains("chart " + temporary.resolve("box/world.png"))
                .allMatch(line -> line.startsWith("chart "));
        assertThat(WorldCharts.steps(List.of(folder)).getSeriesMap())
                .containsOnlyKeys("World, Java,  cores", "gdx-box2d");
        for (String chart : List.of("box/world.svg", "box/quality-1250.png", "world.png", "world.svg")) {
            assertThat(temporary.resolve(chart)).exists();
        }
        assertThat(temporary.resolve("box/quality-5000.svg")).doesNotExist();
        assertThat(machinePage())
                .contains("(../bench/results/box/world.svg)", "(../bench/results/box/quality-1250.svg)");
    }

    /** The host of a GPU is often a machine that was measured without it, too. */
    @Test
    void machinesThatAreAlikeShareALine() throws IOException {
        Files.writeString(temporary.resolve("machines.txt"), "box\ntwin\n");
        world("world-jvm", "1250", "steps", "1");
        ResultsFolder twin = ResultsFolder.open(temporary.resolve("twin"));
        twin.put(
                Kind.WORLD,
                Map.of("engine", "world-jvm", "n", "1250", "mode", "steps", "mean_ms", "3", "status", "ok"));
        assertThat(WorldCharts.steps(List.of(folder, twin)).getSeriesMap()).hasSize(1);
    }

    private String machinePage() throws IOException {
        return Page.ofMachine(Page.folders(temporary).get(0));
    }

    private void measureWorld() throws IOException {
        world("world@gpu", "15000", "steps", "0.09");
        world("world@gpu", "15000", "frames", "0.2");
        world("world@gpu", "15000", "readBuffer", "0.5");
        world("world@gpu", "15000", "storm1", "0.3");
        for (String mode : List.of("steps", "profiled")) {
            folder.put(
                    Kind.WORLD,
                    Map.of("engine", "world@gpu", "n", "1000000", "mode", mode, "status", "left out: the time was up"));
        }
        for (String memory : List.of("pinned", "pageable")) {
            folder.put(
                    Kind.TRANSFER,
                    Map.of(
                            "device",
                            "gpu",
                            "direction",
                            "read",
                            "memory",
                            memory,
                            "bytes",
                            "1048576",
                            "mean_ms",
                            memory.equals("pinned") ? "0.04" : "0.2",
                            "se_ms",
                            "0.001",
                            "gb_per_s",
                            memory.equals("pinned") ? "26.2" : "5.24",
                            "status",
                            "ok"));
        }
        folder.put(
                Kind.WORLD_STAGES,
                Map.of(
                        "engine",
                        "world@gpu",
                        "n",
                        "15000",
                        "stage",
                        "Grid",
                        "time_us",
                        "10",
                        "moved_bytes",
                        "1680000",
                        "copy_gb_per_s",
                        "1000",
                        "roof_us",
                        "1.68",
                        "share_of_roof",
                        "0.168"));
        folder.put(Kind.WORLD_STAGES, Map.of("engine", "world@gpu", "n", "15000", "stage", "Scan", "time_us", "3"));
        folder.put(Kind.WORLD_STAGES, Map.of("engine", "world@gpu", "n", "15000", "stage", "Sweep", "time_us", "4"));
    }

    private void world(String engine, String n, String mode, String millis) throws IOException {
        Map<String, String> row = new LinkedHashMap<>(Map.of("engine", engine, "n", n, "mode", mode, "status", "ok"));
        row.putAll(Map.of("skipped", "100", "steps", "200", "mean_ms", millis, "se_ms", "0.001", "median_ms", millis));
        row.putAll(Map.of("contacts", "27000", "mean_depth", "0.0037", "bytes_held", "12000000"));
        row.put("state_hash", "89abcdef12345678");
        folder.put(Kind.WORLD, row);
    }

    private void peer(String engine, String millis, String depth) throws IOException {
        Map<String, String> row = new LinkedHashMap<>(Map.of("engine", engine, "scene", "packed", "n", "1250"));
        row.putAll(Map.of("steps", "500", "skipped", "100", "mean_ms", millis, "median_ms", millis, "se_ms", "0.1"));
        row.putAll(Map.of("mean_depth", depth, "max_depth", "0.1", "deep_pairs", "0", "kinetic_energy", "0.01"));
        row.putAll(Map.of("allocated_bytes", "1", "peak_rss_mib", "50", "status", "ok"));
        folder.put(Kind.PEERS, row);
    }

    @Test
    void worldInABrowserStandsBesideEnginesForJavaScript() throws IOException {
        assertThat(Page.of(temporary)).doesNotContain("box2d-wasm 7.0.0");
        web("world", "JVM", Map.of("median_us", "400", "mean_depth", "0.001"));
        web("world", "Node", Map.of("median_us", "500", "mean_depth", "0.001", "remarks", "Node 24"));
        web("box2d-wasm", "Node", Map.of("median_us", "4800", "mean_depth", "0.06", "outside", "3"));
        web("planck", "Node", Map.of("status", "left out: a run would take ..", "mean_us", "90000"));
        assertThat(Page.of(temporary))
                .contains("| engine | in | µs, n = 5,000 | depth, n = 5,000 |")
                .contains("| world | JVM | 400 | 0.001 |")
                .contains("| box2d-wasm | Node | 4,800 | 0.06, 3 outside |")
                .contains("| planck | Node | about 90,000 | - |")
                .contains("| world | Node | 1.25 |")
                .contains("| box2d-wasm | Node | 12 |")
                .contains("| planck | Node | - |")
                .contains("Versions: ", "Node 24")
                .doesNotContain("| world | JVM | 1.00 |")
                .doesNotContain("box/web.svg");
        assertThat(WebCharts.chart(folder).getSeriesMap())
                .containsOnlyKeys("World, JVM", "World, Node", "box2d-wasm, Node");
        WebCharts.draw(folder);
        assertThat(Page.of(temporary)).contains("(../bench/results/box/web.svg)");
    }

    private void web(String engine, String runsIn, Map<String, String> figures) throws IOException {
        Map<String, String> row = new LinkedHashMap<>(Map.of("engine", engine, "runs_in", runsIn, "n", "5000"));
        row.putAll(Map.of("outside", "0", "status", "ok"));
        row.putAll(figures);
        folder.put(Kind.WEB, row);
    }

    @Test
    void theSeriesShowWhatIsMeasuredWhatWasGivenUpAndWhatIsStillMissing() throws IOException {
        assertThat(machinePage()).contains("## Series", "- Not measured on box: world@gpu.\n");
        folder.put(Kind.MACHINE, Map.of("property", "cores", "value", "4"));
        folder.put(Kind.MACHINE, Map.of("property", "device gpu", "value", "Some CPU (CPU, 4 compute units)"));
        series("world-jvm", "4", "1250", Map.of("median_ms", "0.25", "mean_depth", "0.0012", "outside", "0"));
        series("world-jvm", "4", "10000", Map.of("median_ms", "2.5", "mean_depth", "0.2", "outside", "1003"));
        series("dyn4j", "1", "10000", Map.of("status", "left out: 200 steps of about 52 ms ..", "mean_ms", "52.3"));
        series("dyn4j", "1", "100000", Map.of("status", "left out: the time was up"));
        series("jbox2d", "1", "1250", Map.of("status", "failed: SomeException: broke"));
        series(
                "box2d-v3",
                "4",
                "1250",
                Map.of(
                        "median_ms",
                        "0.5",
                        "mean_depth",
                        "0.01",
                        "outside",
                        "0",
                        "remarks",
                        "outside Maven: commit abc"));
        assertThat(machinePage())
                .contains("## Series: World beside other engines", "### packed-similar", "### over-full", "### boulder")
                .contains(
                        "| world-jvm | 4 | box | 0.25 | 2.5 | not measured | not measured | 0.0012 | 0.2, 1,003 outside | - | - |")
                .contains("| dyn4j | 1 | box | not measured | about 52 | not measured | not measured | - | - | - | - |")
                .contains("| jbox2d | 1 | box | failed | not measured |")
                .contains("- jbox2d on 1 thread, n = 1,250, box: failed: SomeException: broke.\n")
                .contains(
                        "- Not measured on box: world-jvm on 1 thread, box2d-v3 on 1 thread, gdx-box2d on 1 thread.\n")
                .doesNotContain("world@gpu")
                .contains("- **box2d-v3**, outside Maven: commit abc (box).\n")
                .doesNotContain("series-packed-similar.svg");
        assertThat(Page.of(temporary))
                .contains("| world-jvm | 4 | box | 0.25 | 2.5 | not measured | not measured |")
                .doesNotContain("gdx-box2d |");
    }

    @Test
    void aSeriesIsDrawnOnceWorldHasAFigureInIt() throws IOException {
        folder.put(Kind.MACHINE, Map.of("property", "cores", "value", "4"));
        series("box2d-v3", "1", "1250", Map.of("median_ms", "0.5"));
        SeriesCharts.draw(temporary, Page.folders(temporary));
        assertThat(temporary.resolve("series-packed-similar.svg")).doesNotExist();
        series("world-jvm", "4", "1250", Map.of("median_ms", "0.25"));
        series("world-jvm", "1", "1250", Map.of("median_ms", "0.3"));
        List<ResultsFolder> folders = Page.folders(temporary);
        SeriesCharts.draw(temporary, folders);
        assertThat(SeriesCharts.steps(folders, Series.PACKED_SIMILAR).getSeriesMap())
                .containsOnlyKeys("World, Java, 4 cores", "World, Java, 1 thread", "box2d-v3, 1 thread");
        assertThat(temporary.resolve("series-packed-similar.svg")).exists();
        assertThat(Page.of(temporary)).contains("(../bench/results/series-packed-similar.svg)");
        assertThat(temporary.resolve("series-over-full.svg")).doesNotExist();
    }

    /** The same bits on every machine and back end, in every series that was measured. */
    @Test
    void allWorldsOfTheCommittedSeriesEndInOneState() throws IOException {
        Map<String, String> states = new LinkedHashMap<>();
        for (ResultsFolder machine : Page.folders(RESULTS)) {
            for (Map<String, String> row : machine.table(Kind.SERIES).rows("status", "ok")) {
                if (row.get("engine").startsWith("world")) {
                    String run = row.get("series") + " " + row.get("n");
                    states.putIfAbsent(run, row.get("state_hash"));
                    assertThat(row.get("state_hash"))
                            .as(run + ", " + row.get("engine") + " of " + machine.name())
                            .isEqualTo(states.get(run));
                }
            }
        }
    }

    private void series(String engine, String threads, String n, Map<String, String> more) throws IOException {
        Map<String, String> row = new LinkedHashMap<>(Map.of("engine", engine, "threads", threads, "n", n));
        row.put("series", "packed-similar");
        row.put("status", "ok");
        row.putAll(more);
        folder.put(Kind.SERIES, row);
    }

    @Test
    void aPageWithoutResultsSaysSo() throws IOException {
        Files.writeString(temporary.resolve("machines.txt"), "");
        assertThat(Page.of(temporary)).contains("There are no results yet").doesNotContain("### box");
    }

    @Test
    void aMachineThatIsNamedButNotThereIsAnError() throws IOException {
        Files.writeString(temporary.resolve("machines.txt"), "box\nattic\n");
        assertThatThrownBy(() -> Page.of(temporary))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("attic");
    }

    @Test
    void theConsoleNamesWhatHasNoFigure() throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        ConsoleTable.print(folder, new PrintStream(bytes, true, StandardCharsets.UTF_8));
        assertThat(bytes.toString(StandardCharsets.UTF_8))
                .contains("AMD R9 270X")
                .contains("1.3 +/- 0.01")
                .matches("\\p{ASCII}*")
                .contains("gpu 1 65000 loop: does not fit");
    }

    @Test
    void chartsAreDrawnAsPictureAndAsVectors() throws IOException {
        ByteArrayOutputStream said = new ByteArrayOutputStream();
        Charts.draw(folder, new PrintStream(said, true, StandardCharsets.UTF_8));
        Path picture = folder.path().resolve("strategies-gpu.png");
        assertThat(said.toString(StandardCharsets.UTF_8)).isEqualToIgnoringNewLines("chart " + picture);
        assertThat(ImageIO.read(picture.toFile()).getWidth()).isEqualTo(900);
        assertThat(Files.readString(folder.path().resolve("strategies-gpu.svg")))
                .contains("<svg", "<path");
        // there are no engines to draw
        assertThat(folder.path().resolve("peers-packed.svg")).doesNotExist();
    }

    @Test
    void coordinatesOfAVectorChartAreShortened() {
        assertThat(Charts.slim("<path d=\"M-5.46875,7.0000001 L12,3.5\"/>\n    <g clip-path=\"url(#clip123)\">"))
                .isEqualTo("<path d=\"M-5.5,7 L12,3.5\"/>\n<g clip-path=\"url(#clip)\">");
    }

    @Test
    void aPlaceForAFigureThatIsNotThereIsAnError() {
        assertThatThrownBy(() -> new Page(List.of(folder)).fill("{{box strategies gpu 0 99 loop mean_ms}}"))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("gpu 0 99 loop");
        assertThatThrownBy(() -> new Page(List.of(folder)).fill("{{nothing}}"))
                .isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void aPlaceInASentenceTakesItsFigureFromTheFile() {
        assertThat(new Page(List.of(folder)).fill("from {{box accuracy gpu first_wrong circles}} circles on"))
                .isEqualTo("from 2,050 circles on");
        assertThat(new Page(List.of(folder)).fill("takes {{box strategies gpu 0 15000 loop mean_ms}} ms"))
                .isEqualTo("takes 1.3 ms");
    }
}
