package io.github.circles2d.opencl;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import io.github.circles2d.World;
import io.github.circles2d.tools.Doctor;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** BridJ's native library cannot be loaded: AUTO says so in one line, and the doctor names the cure. */
@EnabledOnOs(OS.LINUX)
@Tag("each-jdk")
class BridjLibraryTest {
    private static final String[] MOUNT_WITHOUT_EXECUTION = {
        "unshare",
        "--user",
        "--map-root-user",
        "--mount",
        "sh",
        "-c",
        "mount -t tmpfs -o noexec tmpfs \"$0\" && exec \"$@\""
    };

    @TempDir
    Path folder;

    /** Makes a world on whatever AUTO takes. */
    static final class Auto {
        public static void main(String[] args) {
            try (World world = World.builder().capacity(1_000_000).moving(false).build()) {
                System.out.println(
                        "on " + world.stats().backend() + ": " + world.stats().reason());
            }
        }
    }

    @Test
    void aTemporaryFolderThatDoesNotExistIsNamed() {
        Path missing = folder.resolve("missing");
        String[] cure = {"'" + missing + "', which does not exist", "-Djava.io.tmpdir=FOLDER"};
        assertAutoFallsBack(withTemporary(missing), cure);
        assertDoctorSays(withTemporary(missing), cure);
    }

    @Test
    void aTemporaryFolderThatAllowsNoExecutionIsNamed() throws IOException, InterruptedException {
        assumeTrue(canMount(), "this user cannot mount a file system");
        String[] cure = {"'" + folder + "', which does not allow execution", "-Djava.io.tmpdir=FOLDER"};
        assertAutoFallsBack(withTemporary(folder).startedBy(mount()), cure);
        assertDoctorSays(withTemporary(folder).startedBy(mount()), cure);
    }

    @Test
    void aJavaThatDeniesNativeAccessIsToldToAllowIt() {
        assumeTrue(Runtime.version().feature() >= 24, "this Java denies no native access");
        ForkedJvm denying = new ForkedJvm().option("--illegal-native-access=deny");
        assertAutoFallsBack(denying, "IllegalCallerException", "--enable-native-access=ALL-UNNAMED");
        assertDoctorSays(denying, "IllegalCallerException", "--enable-native-access=ALL-UNNAMED");
    }

    private static ForkedJvm withTemporary(Path folder) {
        return new ForkedJvm().option("-Djava.io.tmpdir=" + folder);
    }

    private String[] mount() {
        String[] command = Arrays.copyOf(MOUNT_WITHOUT_EXECUTION, MOUNT_WITHOUT_EXECUTION.length + 1);
        command[command.length - 1] = folder.toString();
        return command;
    }

    private boolean canMount() throws InterruptedException {
        List<String> command = new ArrayList<>(List.of(mount()));
        command.add("true");
        try {
            Process process = new ProcessBuilder(command).start();
            return process.waitFor(10, TimeUnit.SECONDS) && process.exitValue() == 0;
        } catch (IOException e) {
            return false;
        }
    }

    private static void assertAutoFallsBack(ForkedJvm jvm, String... mentioned) {
        ForkedJvm.Result auto = jvm.run(Auto.class);
        assertThat(auto.output()).contains("on JVM").contains(mentioned).doesNotContain("Install an OpenCL driver");
        // The program's own line alone, since nobody has asked for a GPU; newer Javas warn of native access.
        assertThat(auto.output().lines().filter(line -> !line.isEmpty() && !line.startsWith("WARNING: ")))
                .as(auto.output())
                .hasSize(1);
        assertThat(auto.exitStatus()).isZero();
    }

    private static void assertDoctorSays(ForkedJvm jvm, String... mentioned) {
        ForkedJvm.Result doctor = jvm.run(Doctor.class);
        assertThat(doctor.output())
                .contains("does not work: BridJ")
                .contains(mentioned)
                .doesNotContain("What to do", "Install an OpenCL driver", "\tat ");
        assertThat(doctor.exitStatus()).isEqualTo(1);
    }
}
