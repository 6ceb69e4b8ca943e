package io.github.circles2d.bench.measure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.circles2d.bench.Devices;
import io.github.circles2d.bench.results.Numbers;
import io.github.circles2d.bench.results.ResultsFolder;
import io.github.circles2d.bench.results.ResultsFolder.Kind;
import io.github.circles2d.bench.results.Table;
import io.github.circles2d.opencl.Device;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.opentest4j.TestAbortedException;

class PlanTest {
    @TempDir
    Path temporary;

    private ResultsFolder folder;

    @BeforeEach
    void open() throws IOException {
        folder = ResultsFolder.open(temporary.resolve("machine"));
    }

    @Test
    void withoutADeviceWorldIsMeasuredOnTheJvmUpToAMillion() {
        assertThat(plan("--only", "world"))
                .extracting(Work::label)
                .startsWith(
                        "start of packed 1250",
                        "world-jvm 1250 steps",
                        "world-jvm 1250 readArray",
                        "world-jvm 1250 profiled",
                        "start of packed 5000")
                .contains("world-jvm 15000 storm1", "world-jvm 15000 storm10", "world-jvm 1000000 steps")
                .doesNotContain("world-jvm 10000000 steps");
    }

    @Test
    void aShortLookHasTwoSizesAndNoMore() {
        assertThat(plan("--only", "world", "--quick"))
                .extracting(Work::label)
                .containsExactly(
                        "start of packed 1250", "world-jvm 1250 steps", "start of packed 5000", "world-jvm 5000 steps");
    }

    /** The state that runs start from is of no use without them. */
    @Test
    void whatHasAFigureIsNeitherMeasuredNorPreparedAgain() throws IOException {
        for (String mode : List.of("steps", "readArray", "profiled")) {
            folder.put(
                    Kind.WORLD,
                    Map.of("engine", "world-jvm", "n", "1250", "mode", mode, "mean_ms", "1", "status", "ok"));
        }
        assertThat(plan("--only", "world", "--missing", "--sizes", "1250")).isEmpty();
        assertThat(plan("--only", "world", "--missing", "--sizes", "1250,5000"))
                .extracting(Work::label)
                .startsWith("start of packed 5000", "world-jvm 5000 steps");
    }

    @Test
    void enginesThatAreNotAskedForAreLeftOut() {
        assertThat(plan("--only", "world", "--engine", "gdx-box2d")).isEmpty();
    }

    @Test
    void aRunThatDoesNotFitIntoTheTimeIsNamedInTheTable() throws IOException {
        Work run = plan("--only", "world", "--sizes", "1000000").get(1);
        assertThat(run.run(new Pace(), 3)).startsWith("left out");
        assertThat(folder.table(Kind.WORLD).rows("engine", "world-jvm", "n", "1000000", "mode", "steps"))
                .singleElement()
                .satisfies(row -> assertThat(row.get("status")).startsWith("left out"));
    }

    @Test
    void aStartThatDoesNotFitIntoTheTimeIsLeftToTheRuns() throws IOException {
        Work start = plan("--only", "world", "--sizes", "1000000").get(0);
        assertThat(start.label()).startsWith("start");
        assertThat(start.run(new Pace(), 3)).startsWith("left out");
    }

    @Test
    void anEarlierSweepTellsWhatALaterOneCosts() throws IOException {
        folder.put(
                Kind.WORLD,
                Map.of("engine", "world-jvm", "n", "5000", "mode", "steps", "mean_ms", "2", "status", "ok"));
        Pace pace = new Pace();
        pace.remember(folder);
        JmhWork work = (JmhWork) plan("--only", "world", "--sizes", "15000").get(1);
        assertThat(pace.stepMillis(work.task())).isCloseTo(6, within(1e-9));
    }

    static Map<String, Device> devices() {
        Map<String, Device> devices = Devices.all();
        if (devices.isEmpty() && !Boolean.getBoolean("circles2d.device.required")) {
            throw new TestAbortedException("no OpenCL device");
        }
        return devices;
    }

    @Test
    void everyDeviceIsMeasuredAloneAndWithReadBackAndByStage() {
        devices().forEach((name, device) -> assertThat(
                        Plan.of(Options.parse(List.of("--only", "world")), Map.of(name, device), folder))
                .extracting(Work::label)
                .contains(
                        "world@" + name + " 1250 steps",
                        "world@" + name + " 5000 frames",
                        "world@" + name + " 15000 readArray",
                        "world@" + name + " 15000 storm10",
                        "world@" + name + " 100000 profiled",
                        "world@" + name + " 1000000 steps"));
    }

    @Test
    void transfersAreMeasuredWithEveryKindOfMemory() {
        devices().forEach((name, device) -> assertThat(
                        Plan.of(Options.parse(List.of("--only", "transfer", "--quick")), Map.of(name, device), folder))
                .extracting(Work::label)
                .containsExactly(
                        name + " read pinned 1048576", name + " read staged 1048576", name + " read pageable 1048576"));
        assertThat(plan("--only", "transfer")).isEmpty();
    }

    @Test
    void aHashIsPutTogetherFromItsHalves() {
        assertThat(JmhWork.hash(0x89ABCDEFL, 0x12345678L)).isEqualTo("89abcdef12345678");
        assertThat(JmhWork.hash(0, 0xFFFF_FFFFL)).isEqualTo("00000000ffffffff");
    }

    @Test
    void aStageStandsBesideTheTimeOfACopyOfItsBytes() throws IOException {
        folder.put(Kind.COPY, Map.of("device", "d", "bytes", "1048576", "gb_per_s", "1000", "status", "ok"));
        folder.put(Kind.COPY, Map.of("device", "d", "bytes", "104857600", "gb_per_s", "100", "status", "ok"));
        folder.put(
                Kind.WORLD,
                Map.of(
                        "engine",
                        "world@d",
                        "n",
                        "1000000",
                        "mode",
                        "profiled",
                        "contacts",
                        "2000000",
                        "grid_us",
                        "2240",
                        "solver_us",
                        "50000",
                        "contacts_us",
                        "9000",
                        "scan_us",
                        "17",
                        "status",
                        "ok"));
        Roof.write(folder);
        Map<String, String> grid = stage("Grid");
        // 56 bytes of state, there and back
        assertThat(Numbers.parse(grid.get("moved_bytes"))).isEqualTo(112e6);
        assertThat(grid).containsEntry("copy_gb_per_s", "100");
        assertThat(Numbers.parse(grid.get("roof_us"))).isCloseTo(1120, within(0.1));
        assertThat(Numbers.parse(grid.get("share_of_roof"))).isCloseTo(0.5, within(1e-6));
        // eight passes of 48 bytes a circle and a contact, then 56 and 16
        assertThat(Numbers.parse(stage("Solver").get("moved_bytes"))).isEqualTo(1e6 * (440 + 2 * 400));
        assertThat(stage("Scan")).containsEntry("moved_bytes", "").containsEntry("time_us", "17");
        assertThat(folder.table(Kind.WORLD_STAGES).rows()).hasSize(4);
    }

    /** Beside a persistent kernel, the counts for the statistics alone would be a row of the stage of the contacts. */
    @Test
    void aStageThatAPlanDoesNotRunHasNoRow() throws IOException {
        Map<String, String> run = Table.columns("engine", "world@d", "n", "1250", "mode", "profiled", "status", "ok");
        run.putAll(Table.columns("grid_us", "0", "contacts_us", "0.03", "scan_us", "0.1", "solver_us", "0"));
        run.putAll(Table.columns("sweep_us", "0.2", "resident_us", "136", "other_us", "2", "contacts", "2000"));
        folder.put(Kind.WORLD, run);
        Roof.write(folder);
        assertThat(folder.table(Kind.WORLD_STAGES).values("stage")).containsExactly("Resident", "Other");
    }

    /** A later version may have other stages. */
    @Test
    void stagesOfAnEarlierSweepDoNotStay() throws IOException {
        folder.put(Kind.WORLD_STAGES, Map.of("engine", "world@d", "n", "5", "stage", "Alchemy", "time_us", "1"));
        Roof.write(folder);
        assertThat(folder.table(Kind.WORLD_STAGES).rows()).isEmpty();
    }

    private Map<String, String> stage(String stage) {
        return folder.table(Kind.WORLD_STAGES).rows("stage", stage).get(0);
    }

    private List<Work> plan(String... arguments) {
        return Plan.of(Options.parse(List.of(arguments)), Map.of(), folder);
    }
}
