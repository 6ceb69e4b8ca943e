package io.github.circles2d.thesis;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.opencl.ForkedJvm;
import io.github.circles2d.opencl.TestDevices;
import io.github.circles2d.opencl.TestScale;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.opentest4j.TestAbortedException;

/**
 * Every kernel under Oclgrind, which runs OpenCL in an interpreter that watches each access to memory. Where Oclgrind is not
 * installed these tests fail if a device is required, unless {@code -Dcircles2d.oclgrind=absent} says that it is known to be
 * absent. {@code -Dcircles2d.oclgrind=FILE} names its driver where it is not in the usual place.
 */
class OclgrindTest {
    private static final String PROPERTY = "circles2d.oclgrind";
    private static final String DRIVER = "/usr/lib/oclgrind/liboclgrind-rt-icd.so";
    private static final Pattern KERNEL = Pattern.compile("^\\s*Kernel: (\\w+)", Pattern.MULTILINE);

    /** Of the scenes whose tests are run, which run side by side from the start: each takes seconds, on one core. */
    private static final Map<String, Future<ForkedJvm.Result>> RUNS = new HashMap<>();

    @BeforeAll
    static void runEveryScene() {
        String driver = System.getProperty(PROPERTY, DRIVER);
        if (driver.equals("absent") || !Files.exists(Path.of(driver)) && !TestDevices.required()) {
            throw new TestAbortedException("Oclgrind is not installed");
        }
        assertThat(Path.of(driver))
                .as("Oclgrind's driver; install oclgrind, or set -D" + PROPERTY)
                .exists();
        ExecutorService threads =
                Executors.newFixedThreadPool(Math.min(4, Runtime.getRuntime().availableProcessors()));
        List<String> scenes = new ArrayList<>(List.of("pairs", "control"));
        if (TestScale.LONG) {
            scenes.add("wrong slots");
        }
        if (TestScale.EXHAUSTIVE) {
            scenes.add("crowd");
        }
        scenes.forEach(scene -> RUNS.put(scene, threads.submit(() -> run(scene))));
        threads.shutdown();
    }

    private static ForkedJvm.Result run(String scene) {
        ForkedJvm jvm = new ForkedJvm()
                .option("-Djavacl.cacheBinaries=false")
                .environment("OCL_ICD_VENDORS", System.getProperty(PROPERTY, DRIVER))
                .environment("OCLGRIND_UNINITIALIZED", "1")
                .environment("OCLGRIND_CHECK_API", "1")
                .environment("OCLGRIND_MAX_ERRORS", "1000000");
        if (scene.equals("pairs") || scene.equals("crowd")) {
            jvm.environment("OCLGRIND_DATA_RACES", "1");
        }
        return jvm.run(OclgrindScenes.class, scene);
    }

    private static ForkedJvm.Result resultOf(String scene) throws Exception {
        ForkedJvm.Result result = RUNS.containsKey(scene) ? RUNS.get(scene).get() : run(scene);
        assertThat(result.exitStatus()).as(result.output()).isZero();
        assertThat(result.output()).contains("done");
        return result;
    }

    private static Set<String> reportedKernels(ForkedJvm.Result result) {
        Set<String> kernels = new TreeSet<>();
        Matcher kernel = KERNEL.matcher(result.output());
        while (kernel.find()) {
            kernels.add(kernel.group(1));
        }
        return kernels;
    }

    /** Returns what was reported, without the place and the details. */
    private static Set<String> reports(ForkedJvm.Result result) {
        return result.output()
                .lines()
                .filter(line -> line.matches("\\S.*(address|race|error|Oclgrind).*"))
                .map(line -> line.replaceAll(" at .*| of size.*", ""))
                .collect(Collectors.toCollection(TreeSet::new));
    }

    @Test
    void noKernelRacesOrLeavesItsBuffersWhereNoCircleHasTwoContacts() throws Exception {
        ForkedJvm.Result result = resultOf("pairs");
        assertThat(reportedKernels(result)).as(result.output()).isEmpty();
        assertThat(reports(result)).isEmpty();
    }

    /** The thesis resolves all pairs at once, so two work-items may read and write one circle: a race by design. */
    @Test
    @Tag("exhaustive")
    void inACrowdTheResolveKernelsRaceAndNothingElseIsReported() throws Exception {
        ForkedJvm.Result result = resultOf("crowd");
        assertThat(reportedKernels(result))
                .containsExactlyInAnyOrder(
                        "resolve_collisions",
                        "resolve_collisions_with_pairs",
                        "resolve_collisions_with_rows",
                        "resolve_collisions_exact");
        assertThat(reports(result)).containsOnly("Read-write data race", "Write-write data race");
    }

    @Test
    @Tag("long")
    void slotsThatStrategyZeroMapsWronglyTouchNoMemory() throws Exception {
        ForkedJvm.Result result = resultOf("wrong slots");
        assertThat(result.output()).containsPattern("wrong slots [1-9]");
        assertThat(reportedKernels(result)).as(result.output()).isEmpty();
        assertThat(reports(result)).isEmpty();
    }

    @Test
    void anAccessOutOfBoundsWouldHaveBeenReported() throws Exception {
        ForkedJvm.Result result = resultOf("control");
        assertThat(reportedKernels(result)).containsExactly("past_the_end");
        assertThat(reports(result)).containsExactly("Invalid write");
    }
}
