package io.github.circles2d.opencl;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

@Tag("each-jdk")
class OpenClUnavailableTest {
    /** Asks for a device twice and prints what came. */
    static final class AskTwice {
        public static void main(String[] args) {
            for (int i = 0; i < 2; i++) {
                try {
                    System.out.println("found " + OpenCl.devices());
                } catch (OpenClUnavailableException e) {
                    System.out.println("unavailable: " + e.getMessage());
                }
            }
        }
    }

    private static void assertUnavailableTwice(ForkedJvm.Result result, String... mentioned) {
        assertThat(result.exitStatus()).isZero();
        String[] lines = result.output()
                .lines()
                .filter(line -> line.startsWith("unavailable: ") || line.startsWith("found "))
                .toArray(String[]::new);
        assertThat(lines).as(result.output()).hasSize(2);
        assertThat(lines[0]).startsWith("unavailable: ").contains(mentioned);
        assertThat(lines[1]).isEqualTo(lines[0]);
    }

    @Test
    void aMachineWithoutDriversIsToldWhatToInstallAndToldTheSameAgain(@TempDir Path noDrivers) {
        ForkedJvm.Result result = new ForkedJvm()
                .environment("OCL_ICD_VENDORS", noDrivers.toString())
                .environment("BRIDJ_QUIET", "0")
                .run(AskTwice.class);
        assertUnavailableTwice(result, "CL_PLATFORM_NOT_FOUND_KHR", "apt-get install pocl-opencl-icd");
    }

    @Test
    void aVariableOfPoclThatTheUserHasSetIsLeftAsItIs() {
        TestDevices.all();
        ForkedJvm.Result result =
                new ForkedJvm().environment("POCL_SIGFPE_HANDLER", "0").run(AskTwice.class);
        assertThat(result.output()).contains("found ").doesNotContain("unavailable");
    }

    @Test
    void anUnsupportedProcessorIsNamedBeforeAnyNativeCodeIsLoaded() {
        ForkedJvm.Result result = new ForkedJvm().option("-Dos.arch=aarch64").run(AskTwice.class);
        assertUnavailableTwice(result, "aarch64", "bridj.library");
    }
}
