package io.github.circles2d.world.device;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.opencl.ForkedJvm;
import io.github.circles2d.opencl.TestDevices;
import io.github.circles2d.opencl.TestScale;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.opentest4j.TestAbortedException;

/**
 * Every kernel of the World under Oclgrind, which runs OpenCL in an interpreter that watches each access to memory: no race,
 * no access out of bounds, no use of what was not initialised, and the bits of the pipeline in Java. Whole steps in one
 * launch have a single work-group here: Oclgrind runs work-groups one after another, so none may wait for others.
 *
 * <p>Oclgrind 21.10 does not notice that a buffer is released: if a larger one gets its number, what a kernel writes behind the
 * old end counts as not initialised. If the test reports that of a whole array, look first whether that array was replaced.
 * It may also report what the host has written to a part of a buffer (DeviceBuffer.slice): see OclgrindWorlds.MISJUDGED.
 *
 * <p>Where Oclgrind is not installed the test fails if a device is required, unless {@code -Dcircles2d.oclgrind=absent} says
 * that it is known to be absent. {@code -Dcircles2d.oclgrind=FILE} names its driver where it is not in the usual place.
 */
class WorldOclgrindTest {
    private static final String PROPERTY = "circles2d.oclgrind";
    private static final String DRIVER = "/usr/lib/oclgrind/liboclgrind-rt-icd.so";
    private static final Pattern KERNEL = Pattern.compile(
            "^kernel (?:__attribute__\\S*\\(\\w+, 1, 1\\)\\)\\) )?void\\s+(\\w+)|^TILE_KERNEL (\\w+)",
            Pattern.MULTILINE);

    /** By size and world: the kernels that ran in one that has passed. */
    private static final Map<String, List<String>> RAN = new ConcurrentHashMap<>();

    /** In the lines of each report. They are read from the output, since a log begins anew with each context. */
    private static final String[] REPORTS = {"Kernel: ", "Oclgrind - ", "OCLGRIND"};

    /** The stages by colours, of circles of several sizes that turn and touch. */
    @Test
    void circlesThatTurnDoNotRaceLeaveTheirBuffersOrReadWhatNobodyWrote() throws Exception {
        assertThat(run(TestScale.EXHAUSTIVE ? "small" : "smallest", "turning"))
                .contains(
                        "grid_gather",
                        "contacts_countByLevelAndSheet",
                        "solver_solve",
                        "events_write",
                        "readback_turns");
    }

    /** The stages by colours, of circles that turn, too, and the queries. */
    @Test
    @Tag("long")
    void noStageRacesLeavesItsBuffersOrReadsWhatNobodyWrote() throws Exception {
        assertThat(run(
                        TestScale.EXHAUSTIVE ? "small" : "smallest",
                        "COLOURS",
                        "a table of pairs that grows",
                        "fast",
                        "levels in an arena that is not folded",
                        "turning",
                        "terrain",
                        "joints",
                        "bodies",
                        "bodies that sleep",
                        "sleep",
                        "queries"))
                .containsAll(kernelsIn("queries"))
                .contains(
                        "scan_starts",
                        "grid_gather",
                        "contacts_countByLevel",
                        "solver_solve",
                        "continuousCollision_look",
                        "events_add",
                        "events_move",
                        "sensing_find",
                        "statics_find",
                        "statics_findPieces",
                        "pieces_find",
                        "joints_takeSums",
                        "bodies_give",
                        "sleeping_spread",
                        "sleeping_pressByBodies",
                        "sleeping_holdByBodies",
                        "sleeping_end",
                        "readback_turns");
    }

    @Test
    @Tag("exhaustive")
    void norDoesAnyKernelOfAWorld() throws Exception {
        assertThat(run(
                        "small",
                        "crowd",
                        "levels of tiles",
                        "levels in a crowd",
                        "PERSISTENT_GPU",
                        "levels of PERSISTENT_GPU",
                        "TILES",
                        "COLOURS",
                        "a table of pairs that grows",
                        "edges",
                        "changes",
                        "fast",
                        "levels in an arena that is not folded",
                        "turning",
                        "terrain",
                        "terrain of tiles",
                        "joints",
                        "joints of tiles",
                        "bodies",
                        "bodies of tiles",
                        "bodies that sleep",
                        "bodies that sleep, of tiles",
                        "sleep",
                        "sleep of tiles",
                        "queries"))
                .containsAll(kernelsIn(""));
    }

    /** Without worlds of several levels by tiles, which would take minutes. */
    @Test
    @Tag("exhaustive")
    void norDoesAnyInLargerWorldsAndInWorkGroupsOfTheUsualSize() throws Exception {
        assertThat(run(
                        "large",
                        "COLOURS",
                        "changes",
                        "PERSISTENT_GPU",
                        "queries",
                        "crowd",
                        "wide",
                        "fast",
                        "TILES",
                        "turning",
                        "terrain",
                        "edges"))
                .contains("scan_starts", "solver_solveTile", "persistentGpu_steps");
    }

    /** Runs worlds, some at a time, each in a process of its own; returns the kernels that ran, none of which was reported. */
    private static Set<String> run(String size, String... worlds) throws Exception {
        String driver = System.getProperty(PROPERTY, DRIVER);
        if (driver.equals("absent") || !Files.exists(Path.of(driver)) && !TestDevices.required()) {
            throw new TestAbortedException("Oclgrind is not installed");
        }
        assertThat(Path.of(driver)).as("Oclgrind's driver").exists();
        ExecutorService threads =
                Executors.newFixedThreadPool(Math.min(4, Runtime.getRuntime().availableProcessors()));
        try {
            List<Future<List<String>>> runs = new ArrayList<>();
            for (String world : worlds) {
                runs.add(threads.submit(() -> run(driver, world, size)));
            }
            Set<String> ran = new TreeSet<>();
            for (Future<List<String>> run : runs) {
                ran.addAll(run.get());
            }
            return ran;
        } finally {
            threads.shutdownNow();
        }
    }

    /** Returns the kernels that ran, none of which was reported. No world is run twice. */
    private static List<String> run(String driver, String world, String size) throws IOException {
        List<String> kernels = RAN.get(size + " " + world);
        if (kernels == null) {
            kernels = runWorld(driver, world, size);
            RAN.put(size + " " + world, kernels);
        }
        return kernels;
    }

    private static List<String> runWorld(String driver, String world, String size) throws IOException {
        ForkedJvm jvm = new ForkedJvm().option("-Djavacl.cacheBinaries=false");
        if (!size.equals("large")) {
            jvm.option("-Dcircles2d.groups.small=true");
        }
        ForkedJvm.Result result = jvm.environment("OCL_ICD_VENDORS", driver)
                .environment("OCLGRIND_DATA_RACES", "1")
                .environment("OCLGRIND_UNINITIALIZED", OclgrindWorlds.MISJUDGED.contains(world) ? "0" : "1")
                .environment("OCLGRIND_CHECK_API", "1")
                .environment("OCLGRIND_LOCAL_MEM_SIZE", "65536")
                // Optimised, a vector that is put together from its parts counts as not initialised.
                .environment("OCLGRIND_BUILD_OPTIONS", "-cl-opt-disable")
                .run(OclgrindWorlds.class, world, size);
        assertThat(result.exitStatus()).as(result.output()).isZero();
        assertThat(result.output()).contains("done");
        assertThat(result.output()).as(world).doesNotContain(REPORTS);
        return result.output()
                .lines()
                .filter(line -> line.startsWith("kernels "))
                .flatMap(line -> Arrays.stream(line.split(" ")).skip(1))
                .toList();
    }

    /** The kernels in the files of a folder of the world's. */
    private static Set<String> kernelsIn(String folder) throws IOException {
        Set<String> kernels = new TreeSet<>();
        try (Stream<Path> files = Files.walk(Path.of("kernels", "world", folder))) {
            for (Path file : files.filter(Files::isRegularFile).toList()) {
                Matcher matcher = KERNEL.matcher(Files.readString(file));
                while (matcher.find()) {
                    kernels.add(matcher.group(1) != null ? matcher.group(1) : matcher.group(2));
                }
            }
        }
        assertThat(kernels).isNotEmpty();
        return kernels;
    }
}
