package io.github.circles2d.tools;

import static io.github.circles2d.Refusals.assertIllegalArgument;
import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.ForkedJvm;
import io.github.circles2d.opencl.OnEachDevice;
import io.github.circles2d.opencl.TestDevices;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

@Tag("each-jdk")
class VectorAdditionTest {

    @OnEachDevice
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

    @OnEachDevice
    void vectorsOfDifferentLengthsAreRefused(Device device) {
        assertIllegalArgument("3 and 4", () -> VectorAddition.add(device, new float[3], new float[4]));
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
