package io.github.circles2d.tools;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class PrescriptionTest {
    @TempDir
    Path root;

    private Path vendors;
    private Path libraries;

    @BeforeEach
    void makeARoot() throws IOException {
        vendors = Files.createDirectories(root.resolve("etc/OpenCL/vendors"));
        libraries = Files.createDirectories(root.resolve("usr/lib/x86_64-linux-gnu"));
    }

    @Test
    void aBareLinuxLacksLoaderAndDriver() {
        assertThat(linux())
                .contains("There is no libOpenCL.so.1")
                .contains("No driver is registered in " + vendors)
                .contains("apt-get install pocl-opencl-icd", "dnf install pocl", "pacman -S pocl");
    }

    @Test
    void aLinuxWithLoaderAndDriverLacksNeither() throws IOException {
        install("libOpenCL.so.1");
        install("libpocl.so.2");
        register("pocl.icd", "libpocl.so.2");
        assertThat(linux()).doesNotContain("There is no", "No driver", "was not found", "not registered");
    }

    @Test
    void aRegistrationWithoutItsLibraryIsNamed() throws IOException {
        install("libOpenCL.so.1");
        register("gone.icd", "/usr/lib/libgone.so");
        register("lost.icd", "liblost.so.1");
        assertThat(linux())
                .contains("gone.icd names the driver '/usr/lib/libgone.so', which was not found")
                .contains("lost.icd names the driver 'liblost.so.1', which was not found");
    }

    @Test
    void anNvidiaDriverThatIsNotRegisteredIsNamed() throws IOException {
        install("libOpenCL.so.1");
        install("libnvidia-opencl.so.1");
        assertThat(linux()).contains("not registered", "/etc/OpenCL/vendors/nvidia.icd");
        register("nvidia.icd", "libnvidia-opencl.so.1");
        assertThat(linux()).doesNotContain("not registered");
    }

    @Test
    void theSingleFileThatOclIcdVendorsMayNameIsRead() throws IOException {
        register("pocl.icd", "libgone.so.9");
        String lines =
                String.join("\n", new Prescription("Linux", root, vendors.resolve("pocl.icd")).forMissingDriver());
        assertThat(lines).contains("libgone.so.9").doesNotContain("No driver is registered");
    }

    @Test
    void theDriverThatOclIcdVendorsMayNameIsNotReadAsARegistration() throws IOException {
        install("libOpenCL.so.1");
        Path driver = Files.write(vendors.resolve("driver.so"), new byte[] {127, 'E', 'L', 'F', 0, 1});
        assertThat(new Prescription("Linux", root, driver).forFailingDevice()).isEmpty();
    }

    @Test
    void aRegistrationThatNamesNoFileNameIsReported() throws IOException {
        install("libOpenCL.so.1");
        register("odd.icd", "odd\0name");
        assertThat(linux()).contains("odd.icd names the driver");
    }

    @Test
    void aFailingDeviceIsNoReasonToInstallADriver() throws IOException {
        install("libOpenCL.so.1");
        install("libpocl.so.2");
        register("pocl.icd", "libpocl.so.2");
        assertThat(new Prescription("Linux", root, vendors).forFailingDevice()).isEmpty();
    }

    @Test
    void everySystemGetsItsOwnAdvice() {
        assertThat(on("Windows 11"))
                .contains("graphics driver", "Intel's CPU Runtime")
                .doesNotContain("apt-get");
        assertThat(on("Mac OS X")).contains("nothing has to be installed").doesNotContain("apt-get");
    }

    private String linux() {
        return on("Linux");
    }

    private String on(String os) {
        return String.join("\n", new Prescription(os, root, vendors).forMissingDriver());
    }

    private void install(String library) throws IOException {
        Files.createFile(libraries.resolve(library));
    }

    private void register(String file, String library) throws IOException {
        Files.writeString(vendors.resolve(file), library + "\n");
    }
}
