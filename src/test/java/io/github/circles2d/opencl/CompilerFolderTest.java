package io.github.circles2d.opencl;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

@DisabledOnOs(OS.WINDOWS) // no folder there may have a name with quotes or backslashes
@Tag("each-jdk")
class CompilerFolderTest {
    @TempDir
    Path folder;

    /** Builds a kernel and says what came. The argument, if there is one, becomes the home folder. */
    static final class Build {
        public static void main(String[] args) {
            if (args.length > 0) {
                System.setProperty("user.home", args[0].replace("(e)", "\u00e9"));
            }
            try (Session session = Session.open(OpenCl.devices().get(0))) {
                session.build(KernelSource.of("tools/DeviceCheck.cl")).kernel("device_check");
                System.out.println("built");
            } catch (OpenClException e) {
                System.out.println("failed: " + e.getMessage());
            }
        }
    }

    @Test
    void anOrdinaryHomeIsJavaClsOwn() throws IOException {
        Path home = Files.createDirectory(folder.resolve("home"));
        CompilerFolder found = CompilerFolder.find(home.toString(), List.of(folder.toString()));
        assertThat(found.replacement()).isEmpty();
        assertThat(entries(folder)).containsExactly(home);
    }

    @Test
    void anUnusableHomeHasATemporaryFolderForAll() throws IOException {
        // Below a file not even a superuser can make a folder.
        Path file = Files.createFile(folder.resolve("file"));
        Path temporary = Files.createDirectory(folder.resolve("tmp"));
        Path missing = folder.resolve("missing");
        for (String home : new String[] {file.toString(), missing.toString(), "?", "relative", "", "nul\0", null}) {
            CompilerFolder found = CompilerFolder.find(home, List.of(temporary.toString()));
            assertThat(found.replacement()).as(home).isPresent();
        }
        assertThat(entries(folder)).containsExactlyInAnyOrder(file, temporary);
    }

    @Test
    void theFirstTemporaryFolderThatWillDoIsTaken() throws IOException {
        Path file = Files.createFile(folder.resolve("file"));
        Path good = Files.createDirectory(folder.resolve("good"));
        CompilerFolder found = CompilerFolder.find("?", List.of("?", file.toString(), good.toString()));
        assertThat(found.replacement().get().getParent()).isEqualTo(good);
    }

    @Test
    void withoutAnyTheExceptionNamesBothAndTheCure() throws IOException {
        Path file = Files.createFile(folder.resolve("file"));
        assertThatThrownBy(() -> CompilerFolder.find("?", List.of(file.toString())))
                .isInstanceOf(OpenClUnavailableException.class)
                .hasMessageContaining("home folder '?'")
                .hasMessageContaining("'" + file + "'")
                .hasMessageContaining("-Djava.io.tmpdir=FOLDER");
    }

    @Test
    void kernelsAreBuiltIfTheHomeHasBlanksAndQuotes() throws IOException {
        TestDevices.all();
        Path home = Files.createDirectory(folder.resolve("it's \"my\" home \\ of:all"));
        assertThat(build(home.toString())).containsExactly("built");
    }

    @Test
    void kernelsAreBuiltIfTheUserHasNoHome() throws IOException {
        TestDevices.all();
        assertThat(build("?")).containsExactly("built");
    }

    @Test
    void kernelsAreBuiltIfTheLocaleCannotEncodeTheHome() throws IOException {
        TestDevices.all();
        assertThat(build(folder + "/Andr(e)")).containsExactly("built");
    }

    @Test
    void aPathOfLibrariesThatTheLocaleCannotEncodeIsPassedOver() throws IOException {
        TestDevices.all();
        String libraries = "export LD_LIBRARY_PATH=$(printf '/Andr\\303\\251'); exec \"$@\"";
        assertThat(build("?", "sh", "-c", libraries, "sh")).containsExactly("built");
    }

    @Test
    @Tag("long")
    void poclFindsAProgramAgainInItsOwnCacheAndJavaClKeepsNone() throws IOException {
        assumeTrue(TestDevices.all().get(0).platform().equals(PoclGate.PLATFORM), "POCL is not the first platform");
        Path cache = Files.createDirectory(folder.resolve("cache"));
        Path home = Files.createDirectory(folder.resolve("home"));
        ForkedJvm jvm = new ForkedJvm().environment("POCL_CACHE_DIR", cache.toString());
        assertThat(jvm.run(Build.class, home.toString()).output()).contains("built");
        List<Path> kept = all(cache);
        assertThat(kept).isNotEmpty();
        assertThat(jvm.run(Build.class, home.toString()).output()).contains("built");
        assertThat(all(cache)).isEqualTo(kept);
        assertThat(entries(home.resolve(".javacl").resolve("cache"))).isEmpty();
    }

    private static List<Path> all(Path folder) throws IOException {
        try (Stream<Path> files = Files.walk(folder)) {
            return files.sorted().toList();
        }
    }

    /** Runs Build and returns its lines; it leaves nothing in the folder that it runs in and in the temporary one. */
    private List<String> build(String home, String... launcher) throws IOException {
        Path current = Files.createDirectory(folder.resolve("current"));
        Path temporary = Files.createDirectory(folder.resolve("tmp"));
        ForkedJvm.Result result = new ForkedJvm()
                .startedBy(launcher)
                .directory(current)
                .environment("LC_ALL", "C")
                .option("-Djava.io.tmpdir=" + temporary)
                .run(Build.class, home);
        assertThat(entries(current)).isEmpty();
        assertThat(entries(temporary)).isEmpty();
        return result.output()
                .lines()
                .filter(line -> !line.isEmpty() && !line.startsWith("WARNING: "))
                .toList();
    }

    private static List<Path> entries(Path folder) throws IOException {
        try (Stream<Path> entries = Files.list(folder)) {
            return entries.toList();
        }
    }
}
