package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;
import static org.assertj.core.api.Assumptions.assumeThat;

import io.github.circles2d.calibration.Crowd;
import io.github.circles2d.calibration.Curve;
import io.github.circles2d.calibration.FrameTimes;
import io.github.circles2d.calibration.Runner;
import io.github.circles2d.calibration.Timings;
import io.github.circles2d.calibration.TimingsFile;
import io.github.circles2d.calibration.Workload;
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
import java.util.Optional;
import java.util.function.Predicate;
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
    private static final int THREADS = World.Builder.defaultThreads();

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

    /**
     * Gives times instead of taking them: the JVM's grow with n, a device's only with the ratio of radii, and the row search is the
     * fastest.
     */
    private static final class FakeMeter implements Meter {
        final List<String> calls = new ArrayList<>();

        @Override
        public FrameTimes world(Optional<Device> device, Crowd crowd) {
            calls.add((device.isPresent() ? "device, " : "JVM, ") + crowd);
            if (device.isEmpty()) {
                return FrameTimes.steady(crowd.circles() / 1000.0);
            }
            return FrameTimes.steady(crowd.isMixed() ? crowd.ratio() : 1);
        }

        @Override
        public FrameTimes loop(Device device, PairIndexing indexing, int circles) {
            calls.add(indexing + " " + circles);
            return FrameTimes.steady(indexing == PairIndexing.ROW_SEARCH ? 1 : 2);
        }
    }

    private static Calibration calibrate(Meter meter) {
        return Calibration.run(TestDevices.all(), meter, Calibration.WORLD_SIZES, Calibration.CIRCLES2D_SIZES);
    }

    private static WorldStats statsOf(World.Builder builder) {
        try (World world = builder.moving(false).build()) {
            return world.stats();
        }
    }

    private static Circles2D engine(Device device, int circles) throws IOException {
        Circles2D engine = new Circles2D(device);
        for (int i = 0; i < circles; i++) {
            engine.addCircle((i + 0.5f) / circles, 0.5f, 0.2f / circles, 1);
        }
        engine.init(1 / 60f, PairIndexing.AUTO, 0.5f, NO_GRAVITY);
        return engine;
    }

    /** The back end of what is fast on a device: on a processor AUTO takes the JVM. */
    private static Backend fastBackend(Device device) {
        return OpenClChoice.isCandidate(device) ? Backend.OPENCL_GPU : Backend.JVM;
    }

    @Test
    void aWorldRunsOnWhatWasMeasuredToBeTheFastestForItsCapacityAndSaysSo() {
        Device device = TestDevices.all().get(0);
        Calibration calibration = calibrate(new FakeMeter());
        assertThat(calibration.file()).contains(file);
        assertThat(calibration.toString()).contains(device.name(), "JVM", "ROW_SEARCH");

        WorldStats few = statsOf(World.builder().capacity(500));
        assertThat(few.backend()).isEqualTo(Backend.JVM);
        assertThat(few.reason()).contains("by calibration", "500 circles", "JVM 0.5");
        WorldStats many = statsOf(World.builder().capacity(5_000));
        assertThat(many.backend()).isEqualTo(fastBackend(device));
        assertThat(many.reason()).contains("by calibration", "5000 circles", "JVM 5.");
        if (OpenClChoice.isCandidate(device)) {
            assertThat(many.device()).isEqualTo(device.toString());
            assertThat(many.reason()).contains(device.name() + " 1.0");
        }
    }

    @Test
    void aWorldRunsOnWhatWasMeasuredToBeTheFastestForTheRadiiThatItExpects() {
        Backend byDevice = fastBackend(TestDevices.all().get(0));
        calibrate(new FakeMeter());
        assertThat(statsOf(World.builder().capacity(5_000).radii(2, 3)).backend())
                .isEqualTo(byDevice);
        WorldStats mixed = statsOf(World.builder().capacity(5_000).radii(0.5f, 5));
        assertThat(mixed.backend()).isEqualTo(Backend.JVM);
        assertThat(mixed.reason())
                .contains("5000 circles of radii 1:10: JVM 5.", "nothing that was measured is faster");
        assertThat(statsOf(World.builder().capacity(20_000).radii(0.5f, 5)).backend())
                .isEqualTo(byDevice);
        assertThat(statsOf(World.builder().capacity(20_000).radii(0.5f, 25)).backend())
                .isEqualTo(Backend.JVM);
        // The last word counts.
        assertThat(statsOf(World.builder().capacity(5_000).radii(0.5f, 5).radii(1, 1))
                        .backend())
                .isEqualTo(byDevice);
    }

    /** A calibration of a version that timed World by OpenCL on processors, too. */
    @Test
    void timesOfWorldOnAProcessorByOpenClAreReadAndNotFollowedAndTheNextCalibrationLeavesThemOut() throws IOException {
        Device processor = TestDevices.all().stream()
                .filter(device -> device.kind() == Device.Kind.CPU)
                .findFirst()
                .orElse(null);
        assumeThat(processor).isNotNull();
        calibrate(new FakeMeter());
        byte[] bytes = Files.readAllBytes(file);
        Timings now = TimingsFile.read(file);
        assertThat(now.world(Runners.world(processor))).isEmpty();
        Curve fast = new Curve(Workload.WORLD, Map.of(250, 0.001, 100_000, 0.001));
        Timings old =
                now.and(new Timings(List.of(new Timings.Entry(Workload.WORLD, "", Runners.world(processor), fast))));
        TimingsFile.write(file, old);

        WorldStats stats = statsOf(World.builder().capacity(500));
        assertThat(stats.backend()).isEqualTo(Backend.JVM);
        assertThat(stats.reason())
                .contains("by calibration", "500 circles: JVM 0.5")
                .doesNotContain(processor.name());
        try (Circles2D engine = engine(processor, 100)) {
            assertThat(engine.indexing()).isEqualTo(PairIndexing.ROW_SEARCH);
        }

        calibrate(new FakeMeter());
        assertThat(Files.readAllBytes(file)).isEqualTo(bytes);
    }

    @Test
    void aFileWithoutMixedRadiiIsFollowedByItsFiguresOfLikeOnesAndTheReasonSaysSo() throws IOException {
        calibrate(new FakeMeter());
        Timings both = TimingsFile.read(file);
        Predicate<Timings.Entry> isMixed =
                entry -> entry.workload() == Workload.WORLD && !entry.variant().isEmpty();
        TimingsFile.write(
                file,
                new Timings(both.entries().stream().filter(isMixed.negate()).toList()));
        WorldStats stats = statsOf(World.builder().capacity(5_000).radii(1, 10));
        assertThat(stats.backend()).isEqualTo(fastBackend(TestDevices.all().get(0)));
        assertThat(stats.reason()).contains("5000 circles: JVM 5.", "mixed radii are not calibrated");
        assertThat(statsOf(World.builder().capacity(5_000)).reason()).doesNotContain("mixed");
    }

    @Test
    void theStateAfterAStepIsTheSameWhateverWasMeasured() {
        Backend byDevice = fastBackend(TestDevices.all().get(0));
        long[] hashes = new long[2];
        for (int k = 0; k < 2; k++) {
            if (k == 1) {
                calibrate(new FakeMeter());
            }
            try (World world =
                    World.builder().capacity(2_000).gravity(0, -1).moving(false).build()) {
                for (int i = 0; i < 400; i++) {
                    world.add((i % 20 + 0.5f) / 20, (i / 20 + 0.5f) / 20, 0.026f, 1 + i % 3);
                }
                world.step(1 / 60f, 10);
                hashes[k] = world.hash();
                assertThat(world.stats().backend()).isEqualTo(k == 0 ? Backend.JVM : byDevice);
            }
        }
        assertThat(hashes[1]).isEqualTo(hashes[0]);
    }

    @Test
    void whereTheThreadsTheVersionOrTheFileAreOthersTheRuleHoldsAndSaysWhy() throws IOException {
        assertThat(statsOf(World.builder()).reason()).contains("1250", "not calibrated");
        calibrate(new FakeMeter());
        assertThat(statsOf(World.builder()).reason()).contains("by calibration");
        assertThat(statsOf(World.builder().threads(THREADS + 1)).reason())
                .contains("1250", "not of this Java virtual machine");

        Timings other = new Timings(TimingsFile.read(file).entries().stream()
                .map(entry -> new Timings.Entry(
                        entry.workload(),
                        entry.variant(),
                        new Runner(
                                entry.runner().name(),
                                "an older " + entry.runner().version()),
                        entry.curve()))
                .toList());
        TimingsFile.write(file, other);
        assertThat(statsOf(World.builder()).reason()).contains("1250", "not of this Java virtual machine");
        try (Circles2D engine = engine(TestDevices.all().get(0), 20)) {
            assertThat(engine.indexing()).isNotEqualTo(PairIndexing.ROW_SEARCH);
        }

        calibrate(new FakeMeter());
        Calibration.forget();
        assertThat(file).doesNotExist();
        assertThat(statsOf(World.builder()).reason()).contains("1250", "not calibrated");
    }

    @Test
    void aDamagedFileIsNeitherUsedNorAnErrorAndTheNextCalibrationReplacesIt() throws IOException {
        calibrate(new FakeMeter());
        byte[] whole = Files.readAllBytes(file);
        Files.write(file, java.util.Arrays.copyOf(whole, whole.length / 2));
        assertThat(statsOf(World.builder()).reason()).contains("not calibrated");
        calibrate(new FakeMeter());
        assertThat(Files.readAllBytes(file)).isEqualTo(whole);
    }

    @Test
    void withoutAFileTheTimesHoldForThisProcess() {
        System.setProperty(PROPERTY, "off");
        assertThat(calibrate(new FakeMeter()).file()).isEmpty();
        assertThat(statsOf(World.builder()).reason()).contains("by calibration");
        Calibration.forget();
        assertThat(statsOf(World.builder()).reason()).contains("not calibrated");
    }

    /** Calibrates and says where the times are, and what they are good for. */
    static final class CalibrateOnce {
        public static void main(String[] args) {
            Calibration calibration = Calibration.run(List.of(), new FakeMeter(), List.of(100), List.of());
            System.out.println("file " + calibration.file() + ", "
                    + statsOf(World.builder()).reason());
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
                assertThat(statsOf(World.builder()).reason()).contains("not calibrated");
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
                    .isThrownBy(() -> Calibration.run(devices, meter, List.of(100), List.of(100)))
                    .withMessageContainingAll(
                            KernelSource.FOLDER_PROPERTY, folder.resolve("none").toString());
            assertThat(meter.calls).isEmpty();
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> statsOf(World.builder().device(devices.get(0))))
                    .withMessageContaining(KernelSource.FOLDER_PROPERTY);
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
            assertThat(statsOf(World.builder().capacity(500)).reason()).contains("by calibration");
            assertThat(Thread.currentThread().isInterrupted()).isTrue();
        } finally {
            Thread.interrupted();
        }
    }

    @Test
    void theSizesAreThoseOfTheContractAndALargeOneIsLeftOutWhereItWouldTakeLong() {
        FakeMeter meter = new FakeMeter();
        Calibration.run(List.of(), meter, Calibration.WORLD_SIZES, Calibration.CIRCLES2D_SIZES);
        List<String> jvm = new ArrayList<>();
        List<String> world = new ArrayList<>();
        for (String radii : List.of("", " of radii 1:3", " of radii 1:10", " of radii 1:100")) {
            for (int circles : Calibration.WORLD_SIZES) {
                world.add("device, " + circles + " circles" + radii);
                if (circles < 100_000) { // Those would take 100 ms a frame, 8 s in all.
                    jvm.add("JVM, " + circles + " circles" + radii);
                }
            }
        }
        assertThat(meter.calls).isEqualTo(jvm);
        meter.calls.clear();
        Device device = TestDevices.all().get(0);
        Calibration.run(List.of(device, device), meter, Calibration.WORLD_SIZES, Calibration.CIRCLES2D_SIZES);
        List<String> expected = new ArrayList<>(jvm);
        if (OpenClChoice.isCandidate(device)) {
            // By the time of 250 circles of radii 1:100, which is that of all others, each takes 8 s in all.
            expected.addAll(world.subList(0, 3 * Calibration.WORLD_SIZES.size() + 1));
        }
        for (PairIndexing indexing : IndexingChoice.CANDIDATES) {
            expected.addAll(List.of(indexing + " 1000", indexing + " 8000"));
        }
        assertThat(meter.calls).isEqualTo(expected).doesNotContain("COMPUTED 1000");
    }

    @Test
    void timesThatStayUncleanAreRefusedAndAnOlderFileStays() throws IOException {
        Meter busy = new Meter() {
            @Override
            public FrameTimes world(Optional<Device> device, Crowd crowd) {
                boolean slow = crowd.ratio() == 10 && crowd.circles() == 3_000;
                return FrameTimes.steady(crowd.circles() * (slow ? 0.011 : 0.001));
            }

            @Override
            public FrameTimes loop(Device device, PairIndexing indexing, int circles) {
                return FrameTimes.steady(1);
            }
        };
        String row = "the times of World with radii of 1:10 on JVM";
        String figures = "1,000 circles took 1.00 ms and 3,000 took 33.0, 33.0 times as long";
        assertThatIllegalStateException()
                .isThrownBy(() -> calibrate(busy))
                .withMessageStartingWith(row)
                .withMessageContaining(figures);
        assertThat(file).doesNotExist();
        assertThat(statsOf(World.builder()).reason()).contains("not calibrated");

        calibrate(new FakeMeter());
        byte[] older = Files.readAllBytes(file);
        assertThatIllegalStateException().isThrownBy(() -> calibrate(busy));
        assertThat(Files.readAllBytes(file)).isEqualTo(older);
        assertThat(statsOf(World.builder()).reason()).contains("by calibration");
    }

    @Test
    void aDeviceThatFailsOrIsTooSmallForASizeSpoilsNothingElse() {
        List<Device> devices = TestDevices.all();
        Calibration failed = calibrate(new Meter() {
            @Override
            public FrameTimes world(Optional<Device> device, Crowd crowd) {
                return FrameTimes.steady(1);
            }

            @Override
            public FrameTimes loop(Device device, PairIndexing indexing, int circles) {
                throw new OpenClException("the driver refuses");
            }
        });
        assertThat(failed.toString())
                .contains("JVM")
                .doesNotContain(devices.get(0).name());
        Calibration small = calibrate(new Meter() {
            @Override
            public FrameTimes world(Optional<Device> device, Crowd crowd) {
                return FrameTimes.steady(1);
            }

            @Override
            public FrameTimes loop(Device device, PairIndexing indexing, int circles) {
                if (circles > 1000) {
                    throw new DeviceMemoryException("too large", 2, 1);
                }
                return FrameTimes.steady(1);
            }
        });
        assertThat(small.toString()).contains(devices.get(0).name(), "1,000: ").doesNotContain("8,000: ");
    }

    @Test
    void circles2DTakesTheIndexingThatWasMeasuredToBeTheFastestAndNeverTheOneThatMayBeWrong() throws IOException {
        calibrate(new FakeMeter());
        for (Device device : TestDevices.all()) {
            // Not even where a file says that it is.
            Timings computed = new Timings(List.of(new Timings.Entry(
                    Workload.CIRCLES2D,
                    "COMPUTED",
                    Runners.circles2d(device, PairIndexing.COMPUTED),
                    new Curve(Workload.CIRCLES2D, Map.of(1000, 0.001)))));
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
        Curve fast = new Curve(Workload.CIRCLES2D, Map.of(1000, 1.0));
        Curve slow = new Curve(Workload.CIRCLES2D, Map.of(1000, 2.0));
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

    /** Really runs the frames; but other tests may run at the same time, so it does not tell how even they are. */
    private static final class EvenMeter implements Meter {
        private final Meter meter = new FrameMeter();

        @Override
        public FrameTimes world(Optional<Device> device, Crowd crowd) {
            return FrameTimes.steady(meter.world(device, crowd).median());
        }

        @Override
        public FrameTimes loop(Device device, PairIndexing indexing, int circles) {
            return FrameTimes.steady(meter.loop(device, indexing, circles).median());
        }
    }

    @Test
    @Tag("long")
    void aRealCalibrationTimesEveryDeviceAndIsFollowed() throws IOException {
        List<Device> devices = TestDevices.all();
        Calibration.run(devices, new EvenMeter(), List.of(400), List.of(300));
        Timings timings = Calibration.timings();
        for (String radii : List.of("", "1:3", "1:10", "1:100")) {
            Curve jvm =
                    timings.find(Workload.WORLD, radii, Runners.jvm(THREADS)).orElseThrow();
            assertThat(jvm.measured().keySet()).containsExactly(400);
        }
        for (Device device : devices) {
            assertThat(timings.find(Workload.WORLD, "", Runners.world(device)).isPresent())
                    .isEqualTo(OpenClChoice.isCandidate(device));
            for (PairIndexing indexing : IndexingChoice.CANDIDATES) {
                Curve loops = timings.find(Workload.CIRCLES2D, indexing.name(), Runners.circles2d(device, indexing))
                        .orElseThrow();
                assertThat(loops.measured().keySet()).containsExactly(300);
            }
        }
        WorldStats stats = statsOf(World.builder().capacity(400));
        assertThat(stats.reason()).contains("by calibration", "400 circles");
        try (Circles2D engine = engine(devices.get(0), 100)) {
            assertThat(engine.indexing()).isIn(IndexingChoice.CANDIDATES);
        }
    }

    /** Makes the same choices twice. */
    static final class TwiceTheSame {
        public static void main(String[] args) throws IOException {
            for (int k = 0; k < 2; k++) {
                World.builder().moving(false).build().close();
                World.builder().capacity(k).moving(false).build().close();
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
        assertThat(log).doesNotContain("World on JVM"); // so few circles need no GPU
        assertThat(log).containsOnlyOnce("is not used: it does not begin with");
        // A newer JDK warns of native access, too.
        assertThat(Pattern.compile("WARNING: the calibration")
                        .matcher(log)
                        .results()
                        .count())
                .isEqualTo(1);
    }
}
