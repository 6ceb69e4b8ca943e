package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.sun.management.ThreadMXBean;
import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.ForkedJvm;
import io.github.circles2d.opencl.OnEachDevice;
import io.github.circles2d.opencl.OpenCl;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;

/** The traps of JavaCL and of the drivers below it, seen from the public class. */
@Tag("each-jdk")
class Circles2DRobustnessTest {
    private static final float STEP = 1 / 60f;
    private static final float[] GRAVITY = {0, -0.01f};

    /** Circles in rows, none of which ever has two contacts, so that every run gives the same. */
    private static Circles2D quietScene(Device device, PairIndexing indexing) throws IOException {
        Circles2D engine = new Circles2D(device);
        for (int i = 0; i < 400; i++) {
            float x = 0.025f + 0.05f * (i % 20);
            float y = 0.025f + 0.05f * (i / 20);
            engine.addCircle(x, y, 0.012f, 1 + i % 5, i % 2 == 0 ? 0.05f : -0.05f, 0);
        }
        engine.init(STEP, indexing, 1, new float[] {0, 0});
        return engine;
    }

    @OnEachDevice
    void integerDivisionByZeroStillThrowsInJavaWhileKernelsRun(Device device) throws IOException {
        try (Circles2D engine = quietScene(device, PairIndexing.COMPUTED)) {
            int zero = engine.size() == 400 ? 0 : 1;
            int thrown = 0;
            for (int i = 0; i < 50_000; i++) { // often enough to be compiled: only then a signal is used
                if (i % 1_000 == 0) {
                    engine.step();
                }
                try {
                    assertThat(i / zero).isNull();
                } catch (ArithmeticException e) {
                    thrown++;
                }
            }
            assertThat(thrown).isEqualTo(50_000);
        }
    }

    /** Buffers that only a running kernel knows must not go: a collected one ends the process or changes the result. */
    @OnEachDevice
    @Tag("long")
    void collectionsUnderRunningKernelsChangeNothing(Device device) throws Exception {
        for (PairIndexing indexing : PairIndexing.values()) {
            float[][] undisturbed;
            try (Circles2D engine = quietScene(device, indexing)) {
                for (int k = 0; k < 60; k++) {
                    engine.step();
                }
                undisturbed = engine.loop();
            }
            AtomicBoolean done = new AtomicBoolean();
            Thread collector = new Thread(() -> {
                while (!done.get()) {
                    System.gc();
                    // With many cores and a large heap nothing else would run: each return from native code waits.
                    LockSupport.parkNanos(2_000_000);
                }
            });
            try (Circles2D engine = quietScene(device, indexing)) {
                collector.start();
                for (int k = 0; k < 60; k++) {
                    engine.step();
                    // An engine that nobody closes, with steps under way, is the collector's to clean up.
                    if (k % 20 == 0) {
                        quietScene(device, indexing).step();
                    }
                }
                assertThat(engine.loop()).isDeepEqualTo(undisturbed);
            } finally {
                done.set(true);
                collector.join();
            }
        }
    }

    @OnEachDevice
    void callsFromManyThreadsRunOneAtATime(Device device) throws Exception {
        ExecutorService threads = Executors.newFixedThreadPool(4);
        try (Circles2D shared = quietScene(device, PairIndexing.ROW_SEARCH);
                Circles2D alone = quietScene(device, PairIndexing.ROW_SEARCH)) {
            List<Future<?>> calls = new ArrayList<>();
            for (int t = 0; t < 4; t++) {
                calls.add(threads.submit(() -> {
                    for (int k = 0; k < 25; k++) {
                        assertThat(shared.loop()).hasDimensions(4, 400);
                        assertThat(shared.velocities()).hasDimensions(2, 400);
                        shared.finish();
                    }
                }));
            }
            for (Future<?> call : calls) {
                call.get();
            }
            for (int k = 0; k < 100; k++) {
                alone.step();
            }
            assertThat(shared.loop()).isDeepEqualTo(alone.loop());
        } finally {
            threads.shutdownNow();
        }
    }

    @OnEachDevice
    void closingWhileOtherThreadsStepGivesThemAClearException(Device device) throws Exception {
        ExecutorService threads = Executors.newFixedThreadPool(2);
        try {
            Circles2D engine = quietScene(device, PairIndexing.EXACT);
            List<Future<?>> calls = new ArrayList<>();
            for (int t = 0; t < 2; t++) {
                calls.add(threads.submit(() -> {
                    while (true) {
                        engine.loop();
                    }
                }));
            }
            Thread.sleep(50);
            engine.close();
            for (Future<?> call : calls) {
                assertThatThrownBy(call::get)
                        .isInstanceOf(ExecutionException.class)
                        .hasCauseInstanceOf(IllegalStateException.class)
                        .hasMessageContaining("closed");
            }
        } finally {
            threads.shutdownNow();
        }
    }

    @OnEachDevice
    void aLoopAllocatesItsResultAndAStepNothing(Device device) throws IOException {
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        try (Circles2D engine = quietScene(device, PairIndexing.EXACT)) {
            for (int k = 0; k < 500; k++) {
                engine.step();
                engine.loop();
            }
            long before = threads.getCurrentThreadAllocatedBytes();
            for (int k = 0; k < 100; k++) {
                engine.step();
            }
            long stepped = threads.getCurrentThreadAllocatedBytes();
            for (int k = 0; k < 100; k++) {
                engine.loop();
            }
            long looped = threads.getCurrentThreadAllocatedBytes();
            int slack = 200; // what the JVM may need beside, far less than anything that grows with n
            assertThat((stepped - before) / 100).isLessThan(slack);
            assertThat((looped - stepped) / 100).isLessThan(4 * (16 + 4 * 400) + slack);
        }
    }

    /** Each holds 4 or 8 MB on the device: were the buffers of one in five lost, it would be some 100 MB. */
    @OnEachDevice
    @EnabledOnOs(OS.LINUX)
    @Tag("long")
    void aHundredEnginesCreatedSteppedAndClosedLeaveResidentMemoryWhereItWas(Device device) {
        assertThat(growthOf(device, 100)).isLessThan(64L << 20);
    }

    /** Were the buffers of one in fifty lost, it would be more than 100 MB. */
    @OnEachDevice
    @EnabledOnOs(OS.LINUX)
    @Tag("exhaustive")
    void aThousandEnginesCreatedSteppedAndClosedLeaveResidentMemoryWhereItWas(Device device) {
        assertThat(growthOf(device, 1000)).isLessThan(80L << 20);
    }

    /**
     * Returns by how many bytes the resident memory grows in a JVM of its own, with a heap that is all touched at the start,
     * the small compiler, and a C library that returns large blocks to the system at once, so that what grows is held by an
     * engine.
     */
    private static long growthOf(Device device, int engines) {
        ForkedJvm.Result result = new ForkedJvm()
                .option("-Xms96m")
                .option("-Xmx96m")
                .option("-XX:+AlwaysPreTouch")
                .option("-XX:TieredStopAtLevel=1")
                .environment("MALLOC_MMAP_THRESHOLD_", "65536")
                .run(
                        ManyEngines.class,
                        String.valueOf(OpenCl.devices().indexOf(device)),
                        // A GPU's driver takes half a second to open a session, POCL a few milliseconds.
                        String.valueOf(device.kind() == Device.Kind.CPU ? engines : engines / 20));
        assertThat(result.exitStatus()).as(result.output()).isZero();
        String growth = result.output()
                .lines()
                .filter(line -> line.startsWith("growth "))
                .findFirst()
                .orElseThrow(() -> new AssertionError(result.output()));
        System.out.println(engines + " engines on " + device.name() + ": " + growth);
        return Long.parseLong(growth.split(" ")[1]);
    }

    /**
     * Prints by how many bytes the resident memory grows from the first to the last engines. What is resident goes up and down
     * by some ten megabytes with the free lists of the driver and of the C library, so the least of five counts. The
     * arguments are the device's place in the list and the number of engines, to which a fifth is added at the start.
     */
    static final class ManyEngines {
        public static void main(String[] args) throws IOException {
            Device device = OpenCl.devices().get(Integer.parseInt(args[0]));
            int engines = Integer.parseInt(args[1]);
            use(device, engines / 5);
            long before = leastResidentBytes(device, engines / 25);
            use(device, engines - engines / 5);
            System.out.println(
                    "growth " + (leastResidentBytes(device, engines / 25) - before) + " bytes over " + before);
        }

        private static long leastResidentBytes(Device device, int engines) throws IOException {
            long least = Long.MAX_VALUE;
            for (int k = 0; k < 5; k++) {
                use(device, engines);
                least = Math.min(least, residentBytes());
            }
            return least;
        }

        private static void use(Device device, int engines) throws IOException {
            PairIndexing[] indexings = PairIndexing.values();
            for (int k = 0; k < engines; k++) {
                try (Circles2D engine = new Circles2D(device)) {
                    for (int i = 0; i < 1024; i++) {
                        engine.addCircle(0.1f + i / 1280f, 0.5f, 0.01f, 1);
                    }
                    engine.init(STEP, indexings[k % indexings.length], 0.5f, GRAVITY);
                    engine.step();
                    engine.loop();
                }
            }
        }

        private static long residentBytes() throws IOException {
            System.gc();
            String kilobytes = Files.readAllLines(Path.of("/proc/self/status")).stream()
                    .filter(line -> line.startsWith("VmRSS:"))
                    .findFirst()
                    .orElseThrow();
            return Long.parseLong(kilobytes.replaceAll("\\D", "")) * 1024;
        }
    }
}
