package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import io.github.circles2d.calibration.FrameTimes;
import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.ForkedJvm;
import io.github.circles2d.opencl.OpenCl;
import io.github.circles2d.opencl.OpenClException;
import io.github.circles2d.opencl.OpenClUnavailableException;
import io.github.circles2d.opencl.TestDevices;
import io.github.circles2d.tools.Doctor;
import java.io.FileInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** If POCL lacks what it needs, it is refused with the reason, and the process lives. All kernels are compiled anew. */
@Tag("each-jdk")
class PoclRefusedTest {
    private static final Path OCLGRIND = Path.of("/usr/lib/oclgrind/liboclgrind-rt-icd.so");

    @TempDir
    private Path folder;

    /** Asks for POCL in every way, and prints what came. */
    static final class AskForPocl {
        public static void main(String[] args) throws Exception {
            if (args.length > 0) {
                limit(args[0], Long.parseLong(args[1]));
            }
            try (World world = world(Backend.AUTO)) {
                System.out.println("AUTO takes " + world.stats().backend());
            }
            try (World world = world(Backend.OPENCL_CPU)) {
                System.out.println("OPENCL_CPU takes " + world.stats().device());
            } catch (OpenClException e) {
                System.out.println("OPENCL_CPU: " + e.getMessage());
            }
            System.out.println("refusal: " + OpenCl.refusal().orElse("none"));
            List<Device> devices = devices();
            Calibration.run(devices, (device, indexing, circles) -> FrameTimes.steady(1), List.of(100));
            System.out.println("calibrated " + devices);
        }

        private static List<Device> devices() {
            try {
                return OpenCl.devices();
            } catch (OpenClUnavailableException e) {
                return List.of();
            }
        }

        private static World world(Backend backend) {
            World world = World.builder()
                    .bounds(0, 0, 10, 10)
                    .capacity(2000)
                    .backend(backend)
                    .build();
            world.add(5, 5, 1, 1);
            world.step(1 / 60f);
            world.hash();
            return world;
        }

        /** Limits this process to what it has and some bytes more. */
        private static void limit(String resource, long more) throws Exception {
            String status;
            try (FileInputStream in = new FileInputStream("/proc/self/status")) {
                status = new String(in.readAllBytes(), StandardCharsets.ISO_8859_1);
            }
            long size = status.lines()
                    .filter(line -> line.startsWith("VmSize"))
                    .mapToLong(line -> 1024 * Long.parseLong(line.replaceAll("\\D", "")))
                    .sum();
            String limit = "--" + resource + "=" + (size + more) + ":";
            String pid = Long.toString(ProcessHandle.current().pid());
            new ProcessBuilder("prlimit", "--pid", pid, limit)
                    .inheritIO()
                    .start()
                    .waitFor();
        }
    }

    @BeforeEach
    void requirePocl() {
        boolean there =
                TestDevices.all().stream().anyMatch(device -> device.platform().equals("Portable Computing Language"));
        assumeTrue(there, "no OpenCL device is of POCL");
    }

    /** POCL is the only driver, whatever else this machine has. */
    private ForkedJvm cold() throws IOException {
        Path drivers = Files.createDirectories(folder.resolve("drivers"));
        try (var registered = Files.newDirectoryStream(Path.of("/etc/OpenCL/vendors"), "*pocl*.icd")) {
            for (Path file : registered) {
                Files.copy(file, drivers.resolve(file.getFileName()));
            }
        }
        return new ForkedJvm()
                .environment("OCL_ICD_VENDORS", drivers.toString())
                .option("-Djavacl.cacheBinaries=false")
                .option("-Xmx256m")
                .environment(
                        "POCL_CACHE_DIR",
                        Files.createDirectories(folder.resolve("cache")).toString());
    }

    private static void assertRefused(ForkedJvm.Result result, String... reason) {
        assertThat(result.exitStatus()).as(result.output()).isZero();
        assertThat(result.output())
                .contains("AUTO takes JVM", "OPENCL_CPU: POCL", "calibrated []")
                .contains(reason);
    }

    @Test
    void withoutALinker() throws IOException {
        ForkedJvm.Result result = cold().environment("PATH", "/nowhere").run(AskForPocl.class);
        assertRefused(result, "program ld", "/nowhere", "binutils");
    }

    @Test
    void withACacheThatCannotBeWritten() throws IOException {
        Path file = Files.createFile(folder.resolve("file"));
        ForkedJvm.Result result =
                cold().environment("POCL_CACHE_DIR", file.toString()).run(AskForPocl.class);
        assertRefused(result, file.toString(), "writable");
    }

    @Test
    void withACacheWithoutName() throws IOException {
        assertRefused(cold().environment("POCL_CACHE_DIR", "").run(AskForPocl.class), "POCL_CACHE_DIR is empty");
    }

    @Test
    void withLittleAddressSpace() throws IOException {
        assumeTrue(Files.isExecutable(Path.of("/usr/bin/prlimit")), "there is no prlimit");
        assertRefused(cold().run(AskForPocl.class, "as", Long.toString(300 << 20)), "address space", "ulimit -v");
    }

    @Test
    @Tag("long")
    void otherDriversStay() throws IOException {
        assumeTrue(Files.exists(OCLGRIND), "there is no Oclgrind");
        ForkedJvm jvm = cold().environment("PATH", "/nowhere");
        Files.writeString(folder.resolve("drivers/other.icd"), OCLGRIND + "\n");
        ForkedJvm.Result result = jvm.run(AskForPocl.class);
        assertThat(result.exitStatus()).as(result.output()).isZero();
        assertThat(result.output())
                .contains("refusal: POCL", "program ld", "calibrated [Oclgrind Simulator")
                .doesNotContain("pthread-");
    }

    @Test
    void theDoctorNamesThisCauseAndNoOther() throws IOException {
        ForkedJvm.Result result = cold().environment("PATH", "/nowhere").run(Doctor.class);
        assertThat(result.exitStatus()).as(result.output()).isEqualTo(1);
        assertThat(result.output())
                .contains("OpenCL   does not work: POCL", "apt-get install binutils")
                .doesNotContain("pocl-opencl-icd");
    }
}
