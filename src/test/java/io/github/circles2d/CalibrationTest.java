package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;

import io.github.circles2d.calibration.Curve;
import io.github.circles2d.calibration.FrameTimes;
import io.github.circles2d.calibration.Timings;
import io.github.circles2d.calibration.Timings.Runner;
import io.github.circles2d.calibration.TimingsFile;
import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.DeviceMemoryException;
import io.github.circles2d.opencl.ForkedJvm;
import io.github.circles2d.opencl.KernelSource;
import io.github.circles2d.opencl.OpenClException;
import io.github.circles2d.opencl.TestDevices;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What AUTO takes, given times; and that a calibration takes them. */
@Tag("each-jdk")
class CalibrationTest {
    private static final String PROPERTY = "circles2d.calibration";
    private static final float[] NO_GRAVITY = {0, 0};

    @TempDir
    Path folder;

    private Path file;
    private String before;

    @BeforeEach
    void useAFileOfItsOwn() {
        before = System.getProperty(PROPERTY);
        file = folder.resolve("calibration.txt");
        System.setProperty(PROPERTY, file.toString());
    }

    @AfterEach
    void forget() {
        Calibration.forget();
        if (before == null) {
            System.clearProperty(PROPERTY);
        } else {
            System.setProperty(PROPERTY, before);
        }
    }

    /** Gives times instead of taking them: the row search is the fastest. */
    private static final class FakeMeter implements Calibration.Meter {
        final List<String> calls = new ArrayList<>();

        @Override
        public FrameTimes loop(Device device, PairIndexing indexing, int circles) {
            calls.add(indexing + " " + circles);
            return FrameTimes.steady(indexing == PairIndexing.ROW_SEARCH ? 1 : 2);
        }
    }

    private static Calibration calibrate(Calibration.Meter meter) {
        return Calibration.run(TestDevices.all(), meter, Calibration.SIZES);
    }

    /** Why AUTO takes what it does for a hundred circles. */
    private static String reason() {
        return IndexingChoice.of(TestDevices.all().get(0), 100, indexing -> true)
                .reason();
    }

    private static Circles2D engine(Device device, int circles) throws IOException {
        Circles2D engine = new Circles2D(device);
        for (int i = 0; i < circles; i++) {
            engine.addCircle((i + 0.5f) / circles, 0.5f, 0.2f / circles, 1);
        }
        engine.init(1 / 60f, PairIndexing.AUTO, 0.5f, NO_GRAVITY);
        return engine;
    }

    @Test
    void autoTakesWhatWasMeasuredToBeTheFastestAndSaysSo() {
        Device device = TestDevices.all().get(0);
        Calibration calibration = calibrate(new FakeMeter());
        assertThat(calibration.file()).contains(file);
        assertThat(calibration.toString()).contains(device.name(), "ROW_SEARCH");
        assertThat(reason()).contains("by calibration", "100 circles", "ROW_SEARCH 1.00", "EXACT 2.00");
    }

    @Test
    void whereTheVersionOrTheFileAreOthersTheRuleHoldsAndSaysWhy() throws IOException {
        assertThat(reason()).contains("not calibrated");
        calibrate(new FakeMeter());
        assertThat(reason()).contains("by calibration");
        Timings other = new Timings(TimingsFile.read(file).entries().stream()
                .map(entry -> new Timings.Entry(
                        entry.indexing(),
                        new Runner(
                                entry.runner().name(),
                                "an older " + entry.runner().version()),
                        entry.curve()))
                .toList());
        TimingsFile.write(file, other);
        assertThat(reason()).contains("not calibrated");
        try (Circles2D engine = engine(TestDevices.all().get(0), 20)) {
            assertThat(engine.indexing()).isNotEqualTo(PairIndexing.ROW_SEARCH);
        }

        calibrate(new FakeMeter());
        Calibration.forget();
        assertThat(file).doesNotExist();
        assertThat(reason()).contains("not calibrated");
    }

    @Test
    void aDamagedFileIsNeitherUsedNorAnErrorAndTheNextCalibrationReplacesIt() throws IOException {
        calibrate(new FakeMeter());
        byte[] whole = Files.readAllBytes(file);
        Files.write(file, java.util.Arrays.copyOf(whole, whole.length / 2));
        assertThat(reason()).contains("not calibrated");
        calibrate(new FakeMeter());
        assertThat(Files.readAllBytes(file)).isEqualTo(whole);
    }

    @Test
    void withoutAFileTheTimesHoldForThisProcess() {
        System.setProperty(PROPERTY, "off");
        assertThat(calibrate(new FakeMeter()).file()).isEmpty();
        assertThat(reason()).contains("by calibration");
        Calibration.forget();
        assertThat(reason()).contains("not calibrated");
    }

    /** Calibrates and says where the times are, and what they are good for. */
    static final class CalibrateOnce {
        public static void main(String[] args) {
            Calibration calibration = Calibration.run(TestDevices.all(), new FakeMeter(), List.of(100));
            System.out.println("file " + calibration.file() + ", " + reason());
        }
    }

    @Test
    void aFolderForCachesThatCannotBeWrittenIsAWarning() throws IOException {
        String blocked =
                Files.writeString(folder.resolve("a file"), "in the way").toString();
        String output = new ForkedJvm()
                .option("-D" + PROPERTY + "=")
                .option("-Duser.home=" + blocked)
                .environment("XDG_CACHE_HOME", blocked)
                .environment("LOCALAPPDATA", blocked)
                .environment(
                        "POCL_CACHE_DIR",
                        Files.createDirectories(folder.resolve("cache")).toString())
                .run(CalibrateOnce.class)
                .output();
        assertThat(output).contains("holds for this process alone", "file Optional.empty, by calibration");
    }

    @Test
    void aPropertyThatNamesNoFileThatCanBeWrittenIsRefusedBeforeAnythingIsMeasured() throws IOException {
        Path aFile = Files.writeString(folder.resolve("a file"), "in the way");
        Path aFolder = Files.createDirectory(folder.resolve("a folder"));
        String[] places = {
            aFolder.toString(),
            aFile + "/calibration.txt",
            "no\0path",
            folder.getRoot().toString()
        };
        try {
            for (String place : places) {
                System.setProperty(PROPERTY, place);
                FakeMeter meter = new FakeMeter();
                assertThatIllegalArgumentException()
                        .isThrownBy(() -> calibrate(meter))
                        .withMessageContainingAll(PROPERTY, "'" + place + "'", "a file that can be written", "'off'");
                assertThat(meter.calls).isEmpty();
                assertThat(reason()).contains("not calibrated");
            }
            System.setProperty(PROPERTY, aFolder.toString());
            assertThatIllegalArgumentException()
                    .isThrownBy(Calibration::forget)
                    .withMessageContainingAll(PROPERTY, "a folder");
            assertThat(aFolder).exists();
        } finally {
            System.setProperty(PROPERTY, file.toString());
        }
    }

    @Test
    void kernelsThatCannotBeReadAreRefusedBeforeAnythingIsMeasured() {
        FakeMeter meter = new FakeMeter();
        List<Device> devices = TestDevices.all();
        System.setProperty(KernelSource.FOLDER_PROPERTY, folder.resolve("none").toString());
        try {
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> Calibration.run(devices, meter, List.of(100)))
                    .withMessageContainingAll(
                            KernelSource.FOLDER_PROPERTY, folder.resolve("none").toString());
            assertThat(meter.calls).isEmpty();
        } finally {
            System.clearProperty(KernelSource.FOLDER_PROPERTY);
        }
    }

    @Test
    void anInterruptedThreadCalibratesAndChoosesAndStaysInterrupted() {
        Thread.currentThread().interrupt();
        try {
            Calibration calibration = calibrate(new FakeMeter());
            assertThat(calibration.file()).contains(file);
            assertThat(reason()).contains("by calibration");
            assertThat(Thread.currentThread().isInterrupted()).isTrue();
        } finally {
            Thread.interrupted();
        }
    }

    @Test
    void theSizesAreThoseOfTheContractAndALargeOneIsLeftOutWhereItWouldTakeLong() {
        Device device = TestDevices.all().get(0);
        FakeMeter meter = new FakeMeter();
        Calibration.run(List.of(device, device), meter, Calibration.SIZES);
        List<String> expected = new ArrayList<>();
        for (PairIndexing indexing : IndexingChoice.CANDIDATES) {
            expected.addAll(List.of(indexing + " 1000", indexing + " 8000"));
        }
        assertThat(meter.calls).isEqualTo(expected).doesNotContain("COMPUTED 1000");

        List<Integer> sizes = new ArrayList<>();
        Calibration.run(
                List.of(device),
                (on, indexing, circles) -> {
                    sizes.add(circles);
                    return FrameTimes.steady(10);
                },
                Calibration.SIZES); // 8,000 would take 640 ms a loop, 6 s in all
        assertThat(sizes).containsExactly(1_000, 1_000, 1_000);
    }

    @Test
    void timesThatStayUncleanAreRefusedAndAnOlderFileStays() throws IOException {
        Calibration.Meter busy = (device, indexing, circles) -> FrameTimes.steady(circles == 8_000 ? 250 : 1);
        String figures = "1,000 circles took 1.00 ms and 8,000 took 250, 250 times as long";
        assertThatIllegalStateException()
                .isThrownBy(() -> calibrate(busy))
                .withMessageStartingWith("the times of Circles2D by EXACT on ")
                .withMessageContaining(figures);
        assertThat(file).doesNotExist();
        assertThat(reason()).contains("not calibrated");

        calibrate(new FakeMeter());
        byte[] older = Files.readAllBytes(file);
        assertThatIllegalStateException().isThrownBy(() -> calibrate(busy));
        assertThat(Files.readAllBytes(file)).isEqualTo(older);
        assertThat(reason()).contains("by calibration");
    }

    @Test
    void aDeviceThatFailsOrIsTooSmallForASizeSpoilsNothingElse() {
        List<Device> devices = TestDevices.all();
        Calibration failed = calibrate((device, indexing, circles) -> {
            throw new OpenClException("the driver refuses");
        });
        assertThat(failed.toString()).doesNotContain(devices.get(0).name());
        Calibration small = calibrate((device, indexing, circles) -> {
            if (circles > 1000) {
                throw new DeviceMemoryException("too large", 2, 1);
            }
            return FrameTimes.steady(1);
        });
        assertThat(small.toString()).contains(devices.get(0).name(), "1,000: ").doesNotContain("8,000: ");
    }

    @Test
    void circles2DTakesTheIndexingThatWasMeasuredToBeTheFastestAndNeverTheOneThatMayBeWrong() throws IOException {
        calibrate(new FakeMeter());
        for (Device device : TestDevices.all()) {
            // Not even where a file says that it is.
            Timings computed = new Timings(List.of(new Timings.Entry(
                    "COMPUTED", Runners.circles2d(device, PairIndexing.COMPUTED), new Curve(Map.of(1000, 0.001)))));
            TimingsFile.write(file, TimingsFile.read(file).and(computed));
            try (Circles2D engine = engine(device, 2_100)) {
                assertThat(engine.indexing()).isEqualTo(PairIndexing.ROW_SEARCH);
                assertThat(engine.wrongSlots()).isZero();
                assertThat(engine.loop()[0]).hasSize(2_100);
            }
        }
    }

    @Test
    void anIndexingThatDoesNotFitIsNotTakenHoweverFastItIs() {
        Curve fast = new Curve(Map.of(1000, 1.0));
        Curve slow = new Curve(Map.of(1000, 2.0));
        Map<PairIndexing, Curve> measured =
                Map.of(PairIndexing.LOOKUP_TABLE, fast, PairIndexing.EXACT, slow, PairIndexing.ROW_SEARCH, slow);
        for (Device.Kind kind : Device.Kind.values()) {
            assertThat(IndexingChoice.of(measured, kind, 1000, indexing -> true).indexing())
                    .isEqualTo(PairIndexing.LOOKUP_TABLE);
            for (Map<PairIndexing, Curve> known : List.of(measured, Map.<PairIndexing, Curve>of())) {
                IndexingChoice choice =
                        IndexingChoice.of(known, kind, 1000, indexing -> indexing != PairIndexing.LOOKUP_TABLE);
                assertThat(choice.indexing()).isEqualTo(PairIndexing.EXACT);
                assertThat(IndexingChoice.of(known, kind, 1000, indexing -> false)
                                .indexing())
                        .as("the one whose refusal says how many circles would fit")
                        .isEqualTo(PairIndexing.EXACT);
            }
        }
    }

    @Test
    @Tag("long")
    void aRealCalibrationTimesEveryDeviceAndIsFollowed() throws IOException {
        List<Device> devices = TestDevices.all();
        Calibration.Meter meter = new FrameMeter();
        // other tests may run at the same time, so it does not tell how even loops are
        Calibration.run(
                devices,
                (device, indexing, circles) ->
                        FrameTimes.steady(meter.loop(device, indexing, circles).median()),
                List.of(300));
        Timings timings = Calibration.timings();
        for (Device device : devices) {
            for (PairIndexing indexing : IndexingChoice.CANDIDATES) {
                Curve loops = timings.find(indexing.name(), Runners.circles2d(device, indexing))
                        .orElseThrow();
                assertThat(loops.measured().keySet()).containsExactly(300);
            }
        }
        assertThat(reason()).contains("by calibration", "100 circles");
        try (Circles2D engine = engine(devices.get(0), 100)) {
            assertThat(engine.indexing()).isIn(IndexingChoice.CANDIDATES);
        }
    }

    /** Makes the same choices twice. */
    static final class TwiceTheSame {
        public static void main(String[] args) throws IOException {
            for (int k = 0; k < 2; k++) {
                engine(TestDevices.all().get(0), 3).close();
            }
        }
    }

    @Test
    void aChoiceAndABadFileAreLoggedOnceWithTheReason() throws IOException {
        TestDevices.all();
        Files.writeString(file, "something else");
        String log = new ForkedJvm()
                .option("-D" + PROPERTY + "=" + file)
                .run(TwiceTheSame.class)
                .output();
        assertThat(log).containsOnlyOnce("is not used: it does not begin with");
        // A newer JDK warns of native access, too.
        assertThat(Pattern.compile("WARNING: the calibration")
                        .matcher(log)
                        .results()
                        .count())
                .isEqualTo(1);
    }
}
