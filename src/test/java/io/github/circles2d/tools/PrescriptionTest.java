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
        assertThat(linux("amd64"))
                .contains("There is no libOpenCL.so.1")
                .contains("No driver is registered in " + vendors)
                .contains("apt-get install pocl-opencl-icd", "dnf install pocl", "pacman -S pocl");
    }

    @Test
    void aLinuxWithLoaderAndDriverLacksNeither() throws IOException {
        install("libOpenCL.so.1");
        install("libpocl.so.2");
        register("pocl.icd", "libpocl.so.2");
        assertThat(linux("amd64")).doesNotContain("There is no", "No driver", "was not found", "not registered");
    }

    @Test
    void aRegistrationWithoutItsLibraryIsNamed() throws IOException {
        install("libOpenCL.so.1");
        register("gone.icd", "/usr/lib/libgone.so");
        register("lost.icd", "liblost.so.1");
        assertThat(linux("amd64"))
                .contains("gone.icd names the driver '/usr/lib/libgone.so', which was not found")
                .contains("lost.icd names the driver 'liblost.so.1', which was not found");
    }

    @Test
    void anNvidiaDriverThatIsNotRegisteredIsNamed() throws IOException {
        install("libOpenCL.so.1");
        install("libnvidia-opencl.so.1");
        assertThat(linux("amd64")).contains("not registered", "/etc/OpenCL/vendors/nvidia.icd");
        register("nvidia.icd", "libnvidia-opencl.so.1");
        assertThat(linux("amd64")).doesNotContain("not registered");
    }

    @Test
    void theSingleFileThatOclIcdVendorsMayNameIsRead() throws IOException {
        register("pocl.icd", "libgone.so.9");
        String lines = String.join("\n", new Prescription("Linux", "amd64", root, vendors.resolve("pocl.icd")).lines());
        assertThat(lines).contains("libgone.so.9").doesNotContain("No driver is registered");
    }

    @Test
    void everySystemGetsItsOwnAdvice() {
        assertThat(linux("aarch64")).contains("64-bit Arm", "-Dbridj.library=FILE");
        assertThat(on("Windows 11", "amd64"))
                .contains("graphics driver", "Intel's CPU Runtime")
                .doesNotContain("apt-get");
        assertThat(on("Mac OS X", "x86_64"))
                .contains("nothing has to be installed")
                .doesNotContain("Rosetta");
        assertThat(on("Mac OS X", "aarch64")).contains("Rosetta").doesNotContain("apt-get");
    }

    private String linux(String arch) {
        return on("Linux", arch);
    }

    private String on(String os, String arch) {
        return String.join("\n", new Prescription(os, arch, root, vendors).lines());
    }

    private void install(String library) throws IOException {
        Files.createFile(libraries.resolve(library));
    }

    private void register(String file, String library) throws IOException {
        Files.writeString(vendors.resolve(file), library + "\n");
    }
}
