package io.github.circles2d;

import static io.github.circles2d.Refusals.assertIllegalArgument;
import static io.github.circles2d.Refusals.assertIllegalState;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.DeviceMemoryException;
import io.github.circles2d.opencl.KernelBuildException;
import io.github.circles2d.opencl.KernelSource;
import io.github.circles2d.opencl.OnEachDevice;
import io.github.circles2d.opencl.OpenCl;
import io.github.circles2d.opencl.TestDevices;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.logging.Handler;
import java.util.logging.Level;
import java.util.logging.LogRecord;
import java.util.logging.Logger;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** The contract of the public class: what it refuses, what it keeps, what it gives back. */
@Tag("each-jdk")
class Circles2DTest {
    private static final float STEP = 1 / 60f;
    private static final float[] GRAVITY = {0, -0.01f};

    static List<Arguments> everyIndexingOnEveryDevice() {
        List<Arguments> cases = new ArrayList<>();
        for (Device device : TestDevices.all()) {
            for (PairIndexing indexing : PairIndexing.values()) {
                cases.add(Arguments.of(device, indexing));
            }
        }
        return cases;
    }

    private static Circles2D running(Device device, PairIndexing indexing, int n) throws IOException {
        Circles2D engine = new Circles2D(device);
        for (int i = 0; i < n; i++) {
            engine.addCircle(0.1f + 0.8f * i / n, 0.1f + 0.8f * (i % 7) / 7, 0.004f, 1 + i % 3);
        }
        engine.init(STEP, indexing, 0.5f, GRAVITY);
        return engine;
    }

    @OnEachDevice
    void circlesOutOfRangeAreRefusedWithValueAndRuleAndNothingIsAdded(Device device) {
        try (Circles2D engine = new Circles2D(device)) {
            String coordinates = "from -1000000.0 to 1000000.0";
            for (float bad : new float[] {Float.NaN, Float.NEGATIVE_INFINITY, Math.nextUp(1e6f), -Float.MAX_VALUE}) {
                assertRefused(() -> engine.addCircle(bad, 0.5f, 0.1f, 1), "x", coordinates, bad);
                assertRefused(() -> engine.addCircle(0.5f, bad, 0.1f, 1), "y", coordinates, bad);
                assertRefused(() -> engine.addCircle(0.5f, 0.5f, 0.1f, 1, bad, 0), "x velocity", coordinates, bad);
                assertRefused(() -> engine.addCircle(0.5f, 0.5f, 0.1f, 1, 0, bad), "y velocity", coordinates, bad);
            }
            String positive = "from 1.0E-6 to 1000000.0";
            for (float bad : new float[] {Float.NaN, Float.MAX_VALUE, Math.nextDown(1e-6f), 0, -0f, -1}) {
                assertRefused(() -> engine.addCircle(0.5f, 0.5f, bad, 1), "radius", positive, bad);
                assertRefused(() -> engine.addCircle(0.5f, 0.5f, 0.1f, bad), "mass", positive, bad);
            }
            assertThat(engine.size()).isZero();
            engine.addCircle(-1e6f, 1e6f, 1e-6f, 1e-6f, -1e6f, 1e6f);
            engine.addCircle(1e6f, -1e6f, 1e6f, 1e6f, 1e6f, -1e6f);
            assertThat(engine.size()).isEqualTo(2);
        }
    }

    private static void assertRefused(ThrowingCallable call, String what, String rule, float value) {
        assertThatIllegalArgumentException()
                .isThrownBy(call)
                .withMessageContainingAll(what, rule, String.valueOf(value));
    }

    @OnEachDevice
    void anInitOutOfRangeIsRefusedAndTheEngineRunsOnAsBefore(Device device) throws IOException {
        try (Circles2D engine = running(device, PairIndexing.ROW_SEARCH, 20)) {
            float[][] before = engine.loop();
            for (float bad : new float[] {0, -STEP, Math.nextDown(1e-6f), Math.nextUp(1f), Float.NaN}) {
                assertRefused(() -> engine.init(bad, 2, 0.5f, GRAVITY), "time step", "from 1.0E-6 to 1.0", bad);
            }
            for (float bad : new float[] {-0.1f, 1.1f, Float.NaN, Float.POSITIVE_INFINITY}) {
                assertRefused(() -> engine.init(STEP, 2, bad, GRAVITY), "restitution", "from 0.0 to 1.0", bad);
            }
            for (float bad : new float[] {Float.NaN, Float.NEGATIVE_INFINITY, Math.nextUp(1e4f)}) {
                String range = "from -10000.0 to 10000.0";
                assertRefused(() -> engine.init(STEP, 2, 0.5f, new float[] {bad, 0}), "x of gravity", range, bad);
                assertRefused(() -> engine.init(STEP, 2, 0.5f, new float[] {0, bad}), "y of gravity", range, bad);
            }
            for (int length : new int[] {0, 1, 3}) {
                assertIllegalArgument("two values", () -> engine.init(STEP, 2, 0.5f, new float[length]));
            }
            for (int strategy : new int[] {-1, 4, Integer.MAX_VALUE, Integer.MIN_VALUE}) {
                assertThatIllegalArgumentException()
                        .isThrownBy(() -> engine.init(STEP, strategy, 0.5f, GRAVITY))
                        .withMessageContainingAll("strategy", String.valueOf(strategy));
            }
            assertThatThrownBy(() -> engine.init(STEP, 2, 0.5f, null)).isInstanceOf(NullPointerException.class);
            assertThatThrownBy(() -> engine.init(STEP, null, 0.5f, GRAVITY)).isInstanceOf(NullPointerException.class);

            assertThat(engine.indexing()).isEqualTo(PairIndexing.ROW_SEARCH);
            assertThat(engine.loop()[1][0]).isLessThan(before[1][0]);
        }
    }

    @OnEachDevice
    void unreadableOrBrokenKernelsLeaveTheEngineAsBefore(Device device, @TempDir Path folder) throws IOException {
        try (Circles2D engine = running(device, PairIndexing.EXACT, 20)) {
            float[][] before = engine.loop();
            System.setProperty(KernelSource.FOLDER_PROPERTY, folder.toString());
            try {
                assertThatThrownBy(() -> engine.init(STEP, 0, 0.5f, GRAVITY))
                        .isInstanceOf(IOException.class)
                        .hasMessageContainingAll("CirclePhysV2.cl", KernelSource.FOLDER_PROPERTY, folder.toString());
                Files.writeString(folder.resolve("CirclePhysV2.cl"), "kernel void broken( {");
                Files.createDirectory(folder.resolve("thesis"));
                Files.writeString(folder.resolve("thesis/CircleRows.cl"), ""); // a GPU needs it too
                assertThatThrownBy(() -> engine.init(STEP, 1, 0.5f, GRAVITY))
                        .isInstanceOf(KernelBuildException.class)
                        .hasMessageContaining("CirclePhysV2.cl");
            } finally {
                System.clearProperty(KernelSource.FOLDER_PROPERTY);
            }
            assertThat(engine.indexing()).isEqualTo(PairIndexing.EXACT);
            assertThat(engine.loop()[1][0]).isLessThan(before[1][0]);
        }
    }

    @OnEachDevice
    void tooManyCirclesAreRefusedWithWhatTheyNeedAndWhatWouldFit(Device device) throws IOException {
        try (Circles2D engine = running(device, PairIndexing.EXACT, 20)) {
            engine.loop();
            for (int i = engine.size(); i < 70_000; i++) {
                engine.addCircle(0.5f, 0.5f, 0.001f, 1);
            }
            long needed = 70_000L * 69_999 / 2 * 8 + 70_000L * 24 + 8;
            assertThatThrownBy(() -> engine.init(STEP, PairIndexing.EXACT, 0.5f, GRAVITY))
                    .isInstanceOf(DeviceMemoryException.class)
                    .hasMessageContaining(needed + " bytes")
                    .hasMessageContaining(device.name())
                    .hasMessageContaining(device.maxBufferBytes() + " in one buffer")
                    .hasMessageContaining("65536 circles at most")
                    .hasMessageMatching(".* \\d+ circles would fit");
            // It runs on with what it had.
            assertThat(engine.loop()[0]).hasSize(20);
            assertThat(engine.size()).isEqualTo(70_000);
            engine.clear();
            engine.addCircle(0.5f, 0.5f, 0.01f, 1);
            engine.init(STEP, PairIndexing.EXACT, 0.5f, GRAVITY);
            assertThat(engine.loop()[0]).hasSize(1);
        }
    }

    @OnEachDevice
    void nothingRunsBeforeTheFirstInit(Device device) {
        try (Circles2D engine = new Circles2D(device)) {
            engine.addCircle(0.5f, 0.5f, 0.1f, 1);
            assertThat(engine.device()).isSameAs(device);
            for (ThrowingCallable call : List.<ThrowingCallable>of(
                    engine::loop, engine::step, engine::velocities, engine::indexing, engine::wrongSlots)) {
                assertThatIllegalStateException().isThrownBy(call).withMessageContaining("init");
            }
        }
    }

    @OnEachDevice
    void everythingIsRefusedAfterCloseAndClosingTwiceIsFine(Device device) throws IOException {
        Circles2D engine = running(device, PairIndexing.LOOKUP_TABLE, 10);
        engine.step();
        engine.close();
        engine.close();
        for (ThrowingCallable call : List.<ThrowingCallable>of(
                engine::loop,
                engine::step,
                engine::finish,
                engine::velocities,
                engine::indexing,
                engine::wrongSlots,
                engine::size,
                engine::device,
                engine::clear,
                () -> engine.addCircle(0.5f, 0.5f, 0.1f, 1),
                () -> engine.init(STEP, 1, 0.5f, GRAVITY))) {
            assertThatIllegalStateException().isThrownBy(call).withMessageContaining("closed");
        }
    }

    @ParameterizedTest
    @MethodSource("everyIndexingOnEveryDevice")
    void noCircleAndOneCircleWork(Device device, PairIndexing indexing) throws IOException {
        try (Circles2D engine = new Circles2D(device)) {
            engine.init(STEP, indexing, 0.5f, GRAVITY);
            assertThat(engine.loop()).hasDimensions(4, 0);
            assertThat(engine.velocities()).hasDimensions(2, 0);
            assertThat(engine.wrongSlots()).isZero();
            engine.addCircle(0.25f, 0.5f, 0.1f, 2);
            engine.init(STEP, indexing, 0.5f, GRAVITY);
            float[][] circles = engine.loop();
            assertThat(circles[0]).containsExactly(0.25f);
            assertThat(circles[1][0]).isBetween(0.4999f, Math.nextDown(0.5f));
            assertThat(circles[2]).containsExactly(0.1f);
            assertThat(circles[3]).containsExactly(2);
        }
    }

    @ParameterizedTest
    @MethodSource("everyIndexingOnEveryDevice")
    void loopReturnsNewArraysThatLaterStepsLeaveAlone(Device device, PairIndexing indexing) throws IOException {
        try (Circles2D engine = running(device, indexing, 30)) {
            float[][] first = engine.loop();
            float[] copy = first[1].clone();
            float[][] second = engine.loop();
            assertThat(second).isNotSameAs(first);
            for (int k = 0; k < 4; k++) {
                assertThat(second[k]).isNotSameAs(first[k]);
            }
            assertThat(first[1]).isEqualTo(copy).isNotEqualTo(second[1]);
            assertThat(engine.velocities()).isNotSameAs(engine.velocities());
        }
    }

    @ParameterizedTest
    @MethodSource("everyIndexingOnEveryDevice")
    void stepsWithoutReadBackAddUpToTheSameState(Device device, PairIndexing indexing) throws IOException {
        try (Circles2D stepped = running(device, indexing, 30);
                Circles2D looped = running(device, indexing, 30)) {
            for (int k = 0; k < 9; k++) {
                stepped.step();
                looped.loop();
            }
            stepped.finish();
            assertThat(stepped.loop()).isDeepEqualTo(looped.loop());
            assertThat(stepped.velocities()).isDeepEqualTo(looped.velocities());
        }
    }

    @ParameterizedTest
    @MethodSource("everyIndexingOnEveryDevice")
    void anotherInitStartsAnewAlsoWithStepsStillUnderWay(Device device, PairIndexing indexing) throws IOException {
        try (Circles2D engine = running(device, indexing, 300)) {
            float[][] first = engine.loop();
            for (PairIndexing next : PairIndexing.values()) {
                for (int k = 0; k < 50; k++) {
                    engine.step();
                }
                engine.init(STEP, next, 0.5f, GRAVITY);
                assertThat(engine.indexing())
                        .isIn(next == PairIndexing.AUTO ? IndexingChoice.CANDIDATES : List.of(next));
                assertThat(engine.velocities()).isDeepEqualTo(new float[2][300]);
                assertThat(engine.loop()[1]).isEqualTo(first[1]);
            }
        }
    }

    @OnEachDevice
    void circlesAddedOrClearedTakePartFromTheNextInitOn(Device device) throws IOException {
        try (Circles2D engine = running(device, PairIndexing.EXACT, 3)) {
            engine.addCircle(0.5f, 0.5f, 0.01f, 1, 0.25f, 0);
            assertThat(engine.size()).isEqualTo(4);
            assertThat(engine.loop()[0]).hasSize(3);
            engine.init(STEP, PairIndexing.EXACT, 0.5f, GRAVITY);
            assertThat(engine.velocities()[0]).containsExactly(0, 0, 0, 0.25f);
            engine.clear();
            assertThat(engine.size()).isZero();
            assertThat(engine.loop()[0]).hasSize(4);
            engine.init(STEP, PairIndexing.EXACT, 0.5f, GRAVITY);
            assertThat(engine.loop()[0]).isEmpty();
        }
    }

    /** Where the thesis divides 0 by 0: no MTV, so the circles stay as they are until something parts them. */
    @ParameterizedTest
    @MethodSource("everyIndexingOnEveryDevice")
    void coincidentCentresStayFiniteAndUnchanged(Device device, PairIndexing indexing) throws IOException {
        try (Circles2D engine = new Circles2D(device)) {
            engine.addCircle(0.5f, 0.5f, 0.1f, 1);
            engine.addCircle(0.5f, 0.5f, 0.05f, 2);
            engine.addCircle(0.2f, 0.2f, 1e-6f, 1);
            engine.addCircle(Math.nextUp(0.2f), 0.2f, 1e-6f, 1);
            engine.addCircle(0.9f, 0.9f, 0.01f, 1);
            engine.addCircle(0.9f, Math.nextUp(0.9f), 0.01f, 1);
            engine.init(STEP, indexing, 0.5f, new float[] {0, 0});
            float[][] circles = engine.loop();
            assertThat(circles[0]).startsWith(0.5f, 0.5f);
            assertThat(circles[1]).startsWith(0.5f, 0.5f);
            for (int k = 0; k < 10; k++) {
                circles = engine.loop();
            }
            for (float[] row : List.of(circles[0], circles[1], engine.velocities()[0], engine.velocities()[1])) {
                for (float value : row) {
                    assertThat(value).isFinite();
                }
            }
            // Off by the least step a float can make, there is a direction, and they part.
            assertThat(circles[1][5] - circles[1][4]).isBetween(0.0199f, 0.0201f);
        }
    }

    @ParameterizedTest
    @MethodSource("everyIndexingOnEveryDevice")
    void wrongSlotsAreReportedAndWarnedOfOnce(Device device, PairIndexing indexing) throws IOException {
        List<LogRecord> warnings = new ArrayList<>();
        Handler handler = new Handler() {
            @Override
            public void publish(LogRecord entry) {
                if (entry.getLevel().intValue() >= Level.WARNING.intValue()) {
                    warnings.add(entry);
                }
            }

            @Override
            public void flush() {}

            @Override
            public void close() {}
        };
        Logger logger = Logger.getLogger(Circles2D.class.getName());
        logger.addHandler(handler);
        logger.setUseParentHandlers(false);
        try {
            try (Circles2D small = running(device, indexing, 2_049)) {
                assertThat(small.wrongSlots()).isZero();
                assertThat(warnings).isEmpty();
            }
            // 5,000 is past the first wrong number of circles of every device that was measured.
            try (Circles2D large = running(device, indexing, 5_000)) {
                large.loop();
                large.loop();
                if (indexing == PairIndexing.COMPUTED) {
                    assertThat(large.wrongSlots()).isPositive();
                    assertThat(warnings).hasSize(1);
                    assertThat(warnings.get(0).getParameters()).contains(large.wrongSlots());
                } else {
                    assertThat(large.wrongSlots()).isZero();
                    assertThat(warnings).isEmpty();
                }
            }
        } finally {
            logger.removeHandler(handler);
            logger.setUseParentHandlers(true);
        }
    }

    @Test
    void theConstructorOfTheThesisChoosesBetweenTheBestDeviceAndACpu() {
        TestDevices.all();
        try (Circles2D best = new Circles2D(true)) {
            assertThat(best.device()).isSameAs(OpenCl.bestDevice());
        }
        if (OpenCl.devices().stream().anyMatch(device -> device.kind() == Device.Kind.CPU)) {
            try (Circles2D cpu = new Circles2D(false)) {
                assertThat(cpu.device().kind()).isEqualTo(Device.Kind.CPU);
            }
        }
    }

    @Test
    void everyStrategyNumberHasItsIndexing() {
        assertThat(PairIndexing.values())
                .containsExactly(
                        PairIndexing.COMPUTED,
                        PairIndexing.LOOKUP_TABLE,
                        PairIndexing.ROW_SEARCH,
                        PairIndexing.EXACT,
                        PairIndexing.AUTO);
        for (int strategy = 0; strategy < 4; strategy++) {
            assertThat(PairIndexing.ofStrategy(strategy)).isSameAs(PairIndexing.values()[strategy]);
            assertThat(PairIndexing.ofStrategy(strategy).strategy()).isEqualTo(strategy);
        }
        assertThatIllegalArgumentException().isThrownBy(() -> PairIndexing.ofStrategy(4));
        assertIllegalState("AUTO", PairIndexing.AUTO::strategy);
    }
}
