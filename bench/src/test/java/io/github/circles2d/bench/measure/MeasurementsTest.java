package io.github.circles2d.bench.measure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import io.github.circles2d.bench.results.ResultsFolder;
import io.github.circles2d.bench.results.ResultsFolder.Kind;
import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class MeasurementsTest {
    @TempDir
    Path temporary;

    @Test
    void bytesOfAStepAreThoseOfItsBuffers() {
        // n = 4: 6 slots; update 4 * 48, circles once more 4 * 16, collision written and read 2 * 48
        assertThat(PairTraffic.of("EXACT", 4)).isEqualTo(new PairTraffic(48, 0, 192 + 64 + 96));
        assertThat(PairTraffic.of("COMPUTED", 4)).isEqualTo(PairTraffic.of("EXACT", 4));
        assertThat(PairTraffic.of("LOOKUP_TABLE", 4)).isEqualTo(new PairTraffic(48, 48, 192 + 64 + 96 + 48));
        assertThat(PairTraffic.of("ROW_SEARCH", 4)).isEqualTo(new PairTraffic(48, 32, 192 + 64 + 96 + 32));
        assertThat(PairTraffic.of("EXACT", 65_000).collisionBytes()).isEqualTo(65_000L * 64_999 * 4);
    }

    @Test
    void theCauseOfAFailureIsReadOutOfJmhsLog() {
        assertThat(JmhRun.reason("# Warmup\n<failure>\n\nio.github.circles2d.opencl.DeviceMemoryException: 99 circles"
                        + " need 8 bytes\n\tat a.b.C.d(C.java:1)\n"))
                .isEqualTo("DeviceMemoryException: 99 circles need 8 bytes");
        assertThat(JmhRun.reason("<forked VM failed with exit code 134>")).contains("134");
        assertThat(JmhRun.reason("")).isEqualTo("no result");
    }

    /** JMH would refuse every run, and the folder would say of each that it failed. */
    @Test
    void aSweepDoesNotStartBesideAnotherMeasurement() throws IOException {
        Path lock = temporary.resolve("jmh.lock");
        Measurements.requireNoOtherMeasurement(lock);
        try (FileChannel channel = FileChannel.open(lock, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
                FileLock held = channel.lock()) {
            assertThat(held.isValid()).isTrue();
            assertThatThrownBy(() -> Measurements.requireNoOtherMeasurement(lock))
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessageContaining("another JMH measurement");
        }
        Measurements.requireNoOtherMeasurement(lock);
    }

    @Test
    void thePaceOfALargerSizeFollowsFromASmallerOne() {
        Pace pace = new Pace();
        assertThat(pace.stepMillis(task(1000))).isEqualTo(7);
        pace.learn(task(1000), 2, 10, 3);
        assertThat(pace.stepMillis(task(3000))).isCloseTo(18, within(1e-9));
        // 5 skipped, 14 counted, 1 for the start
        assertThat(pace.iterationSeconds(task(3000))).isCloseTo(0.36, within(1e-9));
    }

    @Test
    void anEarlierSweepTellsTheCostOfALaterOne() throws IOException {
        ResultsFolder folder = ResultsFolder.open(temporary.resolve("machine"));
        for (int n : new int[] {5000, 2500}) {
            folder.put(
                    Kind.PEERS,
                    Map.of(
                            "engine",
                            "dyn4j",
                            "scene",
                            "packed",
                            "n",
                            Integer.toString(n),
                            "steps",
                            "500",
                            "mean_ms",
                            n == 5000 ? "80" : "1",
                            "status",
                            "ok"));
        }
        List<String> arguments = List.of("--only", "peers", "--sizes", "10000", "--quick", "--engine", "dyn4j");
        Work work = Plan.of(Options.parse(arguments), Map.of(), folder).get(0);
        Pace pace = new Pace();
        pace.remember(folder);
        // 320 ms a step at 10,000: an iteration of 201 steps is 64 s
        assertThat(work.label()).startsWith("dyn4j");
        assertThat(work.run(pace, 60)).startsWith("left out: it would take about 131 s");
    }

    /** Where the time ends, what a newcomer looks for must be there. */
    @Test
    void aShortLookMeasuresWhatScalesFirst() throws IOException {
        ResultsFolder folder = ResultsFolder.open(temporary.resolve("machine"));
        assertThat(Plan.of(Options.parse(List.of("--only", "peers", "--quick")), Map.of(), folder))
                .extracting(Work::label)
                .containsExactly(
                        "gdx-box2d packed 1250 100",
                        "java-grid packed 1250 100",
                        "world-jvm packed 1250 100",
                        "gdx-box2d packed 5000 100",
                        "java-grid packed 5000 100",
                        "world-jvm packed 5000 100",
                        "java-all-pairs packed 1250 100",
                        "jbox2d packed 1250 100",
                        "dyn4j packed 1250 100");
    }

    @Test
    void onlyWhatHasNoFigureIsMissing() throws IOException {
        ResultsFolder folder = ResultsFolder.open(temporary.resolve("machine"));
        Map<String, String> there = new LinkedHashMap<>(
                Map.of("engine", "dyn4j", "scene", "packed", "n", "1250", "steps", "100", "status", "ok"));
        folder.put(Kind.PEERS, there);
        there.put("engine", "jbox2d");
        there.put("status", "left out: the time was up");
        folder.put(Kind.PEERS, there);
        List<String> quick = List.of("--quick", "--only", "peers", "--sizes", "1250", "--engine", "dyn4j,jbox2d");
        List<String> missing = new ArrayList<>(quick);
        missing.add("--missing");
        assertThat(labels(quick, folder)).containsExactly("jbox2d packed 1250 100", "dyn4j packed 1250 100");
        assertThat(labels(missing, folder)).containsExactly("jbox2d packed 1250 100");
    }

    private static List<String> labels(List<String> arguments, ResultsFolder folder) {
        return Plan.of(Options.parse(arguments), Map.of(), folder).stream()
                .map(Work::label)
                .collect(Collectors.toList());
    }

    @Test
    void whatDoesNotFitIntoTheTimeIsLeftOutAndNamed() throws IOException {
        ResultsFolder folder = ResultsFolder.open(temporary.resolve("machine"));
        Pace pace = new Pace();
        pace.learn(task(1000), 5000, 10, 1);
        JmhWork work = new JmhWork(task(1000), JmhWork.Effort.FULL, folder, new HashMap<>());
        assertThat(work.run(pace, 60)).startsWith("left out: it would take about");
        assertThat(folder.table(Kind.STRATEGIES).rows().get(0))
                .containsEntry("n", "1000")
                .containsEntry("mean_ms", "")
                .hasEntrySatisfying("status", status -> assertThat(status).startsWith("left out"));
    }

    @Test
    void whatIsLeftOutDoesNotWipeAnEarlierFigure() throws IOException {
        ResultsFolder folder = ResultsFolder.open(temporary.resolve("machine"));
        folder.put(
                Kind.STRATEGIES,
                Map.of("device", "d", "strategy", "0", "n", "1000", "mode", "loop", "mean_ms", "5", "status", "ok"));
        JmhWork work = new JmhWork(task(1000), JmhWork.Effort.FULL, folder, new HashMap<>());
        assertThat(work.run(new Pace(), -1))
                .startsWith("left out: the time was up")
                .endsWith("stays");
        assertThat(folder.table(Kind.STRATEGIES).rows().get(0)).containsEntry("mean_ms", "5");
    }

    @Test
    void sizesAboveOneThatDidNotFitAreNotTried() throws IOException {
        ResultsFolder folder = ResultsFolder.open(temporary.resolve("machine"));
        JmhWork work = new JmhWork(
                task(1000),
                JmhWork.Effort.FULL,
                folder,
                Map.of(task(1000).family(), "does not fit: a smaller size does not"));
        assertThat(work.run(new Pace(), 60)).startsWith("does not fit");
    }

    @Test
    void aWatchdogEndsAProcessThatRunsForTooLong() throws Exception {
        // a JVM that waits for its standard input
        Process waiting = new ProcessBuilder(Path.of(System.getProperty("java.home"), "bin", "jshell")
                        .toString())
                .start();
        assertThat(JmhRun.killChildrenAfter(60).cancel(false)).isTrue();
        assertThat(waiting.isAlive()).isTrue();
        CompletableFuture<Void> watchdog = JmhRun.killChildrenAfter(1);
        assertThat(watchdog.isDone()).isFalse();
        assertThat(waiting.waitFor()).isNotZero();
        watchdog.get(1, TimeUnit.SECONDS);
    }

    @Test
    void aSealedFolderTakesNoMoreResults() throws IOException {
        ResultsFolder folder = ResultsFolder.open(temporary.resolve("machine"));
        folder.put(Kind.MACHINE, Map.of("property", "a", "value", "1"));
        folder.seal();
        folder.put(Kind.MACHINE, Map.of("property", "b", "value", "2"));
        assertThat(ResultsFolder.open(temporary.resolve("machine"))
                        .table(Kind.MACHINE)
                        .rows())
                .hasSize(1);
    }

    @Test
    void theRoofIsTheTimeOfACopyOfAsManyBytes() throws IOException {
        ResultsFolder folder = ResultsFolder.open(temporary.resolve("machine"));
        long moved = PairTraffic.of("EXACT", 5000).movedBytes();
        folder.put(Kind.COPY, Map.of("device", "d", "bytes", "1048576", "gb_per_s", "1000", "status", "ok"));
        folder.put(Kind.COPY, Map.of("device", "d", "bytes", "104857600", "gb_per_s", "100", "status", "ok"));
        folder.put(
                Kind.STRATEGIES,
                Map.of(
                        "device",
                        "d",
                        "strategy",
                        "3",
                        "n",
                        "5000",
                        "mode",
                        "profiled",
                        "indexing",
                        "EXACT",
                        "update_us",
                        "10",
                        "detect_us",
                        "3000",
                        "resolve_us",
                        "990",
                        "status",
                        "ok"));
        Roof.write(folder);
        Map<String, String> roof = folder.table(Kind.ROOF).rows().get(0);
        assertThat(roof).containsEntry("moved_bytes", Long.toString(moved)).containsEntry("copy_gb_per_s", "100");
        assertThat(Double.parseDouble(roof.get("roof_ms"))).isCloseTo(moved / 1e8, within(0.001));
        assertThat(Double.parseDouble(roof.get("kernels_ms"))).isEqualTo(4);
        assertThat(Double.parseDouble(roof.get("share_of_roof"))).isCloseTo(moved / 4e8, within(0.001));
    }

    private static Task task(int n) {
        return new Task(
                Kind.STRATEGIES,
                Map.of("device", "d", "strategy", "0", "n", Integer.toString(n), "mode", "loop"),
                2,
                "none",
                Map.of(),
                5,
                14,
                7);
    }

    @Test
    void aMachineHasANameThatFitsAFolder() {
        assertThat(Machine.name(Map.of())).matches("[a-z0-9-]+");
        assertThat(Machine.properties(Map.of())).containsKeys("date", "processor", "cores", "java");
    }

    @Test
    void theQuickPlanIsShorterThanTheFullOneAndSmallSizesComeFirst() throws IOException {
        ResultsFolder folder = ResultsFolder.open(temporary.resolve("machine"));
        List<Work> quick = Plan.of(Options.parse(List.of("--quick")), Map.of(), folder);
        List<Work> full = Plan.of(Options.parse(List.of()), Map.of(), folder);
        assertThat(quick).hasSizeLessThan(full.size());
        assertThat(full)
                .extracting(Work::label)
                .startsWith("start of packed 1250")
                .containsSubsequence("java-all-pairs packed 1250 500", "java-all-pairs packed 15000 500");
    }
}
