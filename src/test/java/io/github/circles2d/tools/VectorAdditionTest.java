package io.github.circles2d.tools;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.ForkedJvm;
import io.github.circles2d.opencl.TestDevices;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

@Tag("each-jdk")
class VectorAdditionTest {
    static List<Device> devices() {
        return TestDevices.all();
    }

    @ParameterizedTest
    @MethodSource("devices")
    void everyElementIsTheSum(Device device) {
        float[] a = new float[1000]; // no multiple of a work-group
        float[] b = new float[1000];
        for (int i = 0; i < 1000; i++) {
            a[i] = 3 * i;
            b[i] = 0.5f - i;
        }
        float[] sum = VectorAddition.add(device, a, b);
        assertThat(sum).hasSize(1000);
        for (int i = 0; i < 1000; i++) {
            assertThat(sum[i]).isEqualTo(a[i] + b[i]);
        }
    }

    @ParameterizedTest
    @MethodSource("devices")
    void vectorsOfDifferentLengthsAreRefused(Device device) {
        assertThatThrownBy(() -> VectorAddition.add(device, new float[3], new float[4]))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("3 and 4");
    }

    @Test
    void theProgramPrintsThe1024SumsOfTheThesis() throws Exception {
        TestDevices.all();
        ForkedJvm.Result program = new ForkedJvm().run(VectorAddition.class);
        assertThat(program.output().lines().filter(line -> line.contains(" = ")))
                .hasSize(1024);
        assertThat(program.output()).contains("0 + 0 = 0", "1 + 1 = 2", "1023 + 1023 = 2046");
        assertThat(program.exitStatus()).isZero();
    }

    @Test
    @EnabledOnOs(OS.LINUX)
    void withoutADriverItSaysWhatToInstallAndFails(@TempDir Path folder) throws Exception {
        Path vendors = Files.createDirectory(folder.resolve("vendors"));
        ForkedJvm.Result program = new ForkedJvm()
                .environment("OCL_ICD_VENDORS", vendors.toString())
                .run(VectorAddition.class);
        assertThat(program.output()).contains("Install an OpenCL driver").doesNotContain("\tat ");
        assertThat(program.exitStatus()).isEqualTo(1);
    }
}
