package io.github.circles2d.opencl;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

@DisabledOnOs(OS.WINDOWS) // no folder there may have a name with quotes or backslashes
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

    @ParameterizedTest
    @ValueSource(strings = {"a home", "a\thome", "a\u00a0home", "a\"home", "a'home", "a\\home"})
    void aHomeThatNoOptionTakesKeepsTheCacheButHasATemporaryFolderForIncludes(String name) throws IOException {
        Path home = Files.createDirectory(folder.resolve(name));
        Path temporary = Files.createDirectory(folder.resolve("tmp"));
        CompilerFolder found = CompilerFolder.find(home.toString(), List.of(temporary.toString()));
        assertThat(found.replacement()).isPresent();
        assertThat(found.replacement().get().getParent()).isEqualTo(temporary);
        assertThat(found.cache()).isEqualTo(home.resolve(".javacl").resolve("cache"));
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
            assertThat(found.cache().getParent())
                    .as(home)
                    .isEqualTo(found.replacement().get());
        }
        assertThat(entries(folder)).containsExactlyInAnyOrder(file, temporary);
    }

    @Test
    void theFirstTemporaryFolderThatWillDoIsTaken() throws IOException {
        Path file = Files.createFile(folder.resolve("file"));
        Path blank = Files.createDirectory(folder.resolve("a blank"));
        Path good = Files.createDirectory(folder.resolve("good"));
        CompilerFolder found =
                CompilerFolder.find("?", List.of("?", file.toString(), blank.toString(), good.toString()));
        assertThat(found.replacement().get().getParent()).isEqualTo(good);
        assertThat(entries(blank)).isEmpty();
    }

    @Test
    void withoutAnyTheExceptionNamesBothAndTheCure() throws IOException {
        Path blank = Files.createDirectory(folder.resolve("a blank"));
        assertThatThrownBy(() -> CompilerFolder.find("?", List.of(blank.toString())))
                .isInstanceOf(OpenClUnavailableException.class)
                .hasMessageContaining("home folder '?'")
                .hasMessageContaining("'" + blank + "'")
                .hasMessageContaining("-Djava.io.tmpdir=FOLDER");
    }

    @Test
    void kernelsAreBuiltIfTheHomeHasBlanksAndQuotes() throws IOException {
        TestDevices.all();
        Path home = Files.createDirectory(folder.resolve("it's \"my\" home \\ of:all"));
        assertThat(build(home.toString())).containsExactly("built");
        assertThat(entries(home.resolve(".javacl").resolve("cache"))).hasSize(1);
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
