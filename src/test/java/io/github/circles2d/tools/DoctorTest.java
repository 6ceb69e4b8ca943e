package io.github.circles2d.tools;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.ForkedJvm;
import io.github.circles2d.opencl.TestDevices;
import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

@Tag("each-jdk")
class DoctorTest {
    @TempDir
    Path folder;

    @Test
    void everyDeviceIsListedAndTried() {
        List<Device> devices = TestDevices.all();
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        int status = Doctor.run(new PrintStream(bytes, true, StandardCharsets.UTF_8));
        String report = bytes.toString(StandardCharsets.UTF_8);
        assertThat(report).contains("Working devices: ");
        for (Device device : devices) {
            assertThat(report).contains("Platform " + device.platform()).contains(device.name() + ", by ");
        }
        assertThat(report).contains("works: compiled and ran a kernel");
        assertThat(status).isZero();
    }

    @Test
    @EnabledOnOs(OS.LINUX)
    void withoutADriverItSaysWhatToInstallAndFails() throws Exception {
        Path vendors = Files.createDirectory(folder.resolve("vendors"));
        ForkedJvm.Result doctor = new ForkedJvm()
                .environment("OCL_ICD_VENDORS", vendors.toString())
                .run(Doctor.class);
        assertThat(doctor.output())
                .contains("does not work: ")
                .contains("No driver is registered in " + vendors)
                .contains("apt-get install pocl-opencl-icd")
                .doesNotContain("\tat ");
        assertThat(doctor.exitStatus()).isEqualTo(1);
    }

    @Test
    @EnabledOnOs(OS.LINUX)
    void aHomeWithBlanksThatCannotBeWrittenDoesNotMatter() throws Exception {
        TestDevices.all();
        Path file = Files.writeString(folder.resolve("a home"), "a file, so no folder can be made in it");
        ForkedJvm.Result doctor = new ForkedJvm().option("-Duser.home=" + file).run(Doctor.class);
        assertThat(doctor.output()).contains("works: compiled and ran a kernel").doesNotContain("does not work");
        assertThat(doctor.exitStatus()).isZero();
    }

    @Test
    @EnabledOnOs(OS.LINUX)
    void aPoclThatCannotWriteIsToldWhere() throws Exception {
        assumeTrue(TestDevices.all().get(0).platform().equals("Portable Computing Language"), "POCL is not alone");
        Path file = Files.writeString(folder.resolve("file"), "a file, so no folder can be made in it");
        ForkedJvm.Result doctor =
                new ForkedJvm().environment("POCL_CACHE_DIR", file + "/cache").run(Doctor.class);
        assertThat(doctor.output())
                .contains("does not work: ", "POCL_CACHE_DIR")
                .doesNotContain("What to do", "Install an OpenCL driver");
        assertThat(doctor.exitStatus()).isEqualTo(1);
    }

    @Test
    void aProcessorWithoutNativeLibraryIsNamed() throws Exception {
        ForkedJvm.Result doctor = new ForkedJvm().option("-Dos.arch=riscv64").run(Doctor.class);
        assertThat(doctor.output())
                .contains("no native library for")
                .contains("riscv64")
                .doesNotContain("What to do");
        assertThat(doctor.exitStatus()).isEqualTo(1);
    }

    @Test
    void unknownArgumentsAreRefusedWithTheUsage() {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        assertThat(Doctor.run(new PrintStream(bytes, true, StandardCharsets.UTF_8), "--frobnicate"))
                .isEqualTo(2);
        assertThat(bytes.toString(StandardCharsets.UTF_8)).startsWith("usage: ");
    }

    @Test
    void aWrongResultIsCalledWrongAndADifferentLastBitIsReported() {
        float[] in = {0, 1, 2};
        float[] right = new float[3];
        for (int i = 0; i < 3; i++) {
            right[i] = (float) Math.sqrt(in[i]) / (i + 1) - in[i] * 0.1f;
        }
        assertThat(DeviceCheck.judge(in, right, 1).works()).isTrue();
        assertThat(DeviceCheck.judge(in, right, 1).finding()).contains("to the same bits as Java");

        float[] nearby = right.clone();
        nearby[2] = Math.nextUp(nearby[2]);
        assertThat(DeviceCheck.judge(in, nearby, 1).works()).isTrue();
        assertThat(DeviceCheck.judge(in, nearby, 1).finding()).contains("1 of 3 results differ");

        float[] wrong = right.clone();
        wrong[1] += 0.01f;
        assertThat(DeviceCheck.judge(in, wrong, 1).works()).isFalse();
        assertThat(DeviceCheck.judge(in, wrong, 1).finding()).contains("element 1");

        wrong[1] = Float.NaN;
        assertThat(DeviceCheck.judge(in, wrong, 1).works()).isFalse();
    }

    @Test
    void aPoclThatDoesNotKnowTheProcessorIsCalledTooOld() {
        assertThat(DeviceCheck.explain("build log: error: unknown target CPU 'generic'"))
                .startsWith("this POCL is older than the processor")
                .endsWith("unknown target CPU 'generic'");
        assertThat(DeviceCheck.explain("something else")).isEqualTo("something else");
    }
}
