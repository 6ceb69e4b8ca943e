package io.github.circles2d.project;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ArchitectureTest {
    private static final Path MAIN = Path.of("src/main/java");
    private static final Path PLAYGROUND = Path.of("playground/src/main/java");
    private static final Path BENCH = Path.of("bench/src/main/java");

    @Test
    void importsOfTheLibraryRunOneWayAndOnlyOpenclKnowsJavaCl() throws IOException {
        assertThat(Rooms.filesBelow(MAIN, ".java")).isNotEmpty();
        assertThat(Rooms.violations(MAIN)).isEmpty();
    }

    @Test
    void thePlaygroundUsesThePublicRoomsOnlyAndIsNoPartOfTheLibrary() throws IOException {
        assertThat(Rooms.filesBelow(PLAYGROUND, ".java")).isNotEmpty();
        assertThat(Rooms.violations(PLAYGROUND)).isEmpty();
        assertThat(Rooms.filesBelow(MAIN, ".java"))
                .noneMatch(file -> file.startsWith(MAIN.resolve("io/github/circles2d/playground")));
    }

    @Test
    void theBenchmarksUseThePublicRoomsOnly() throws IOException {
        if (Files.exists(BENCH)) {
            assertThat(Rooms.violations(BENCH)).isEmpty();
        }
    }

    @Test
    void noArrowRunsBack() {
        for (String room : Rooms.MAY_USE.keySet()) {
            assertThat(Rooms.below(room)).as(room).doesNotContain(room);
        }
    }

    /** Lines that are not blank. Who needs more takes something away, or raises the bound for a reason. */
    @ParameterizedTest
    @CsvSource({"src/main/java, .java, 78500", "kernels, .cl, 10250", "src/test/java, .java, 72500"})
    void codeHasFewLines(Path folder, String suffix, int most) throws IOException {
        long lines = 0;
        for (Path file : Rooms.filesBelow(folder, suffix)) {
            lines += Files.readString(file)
                    .lines()
                    .filter(line -> !line.isBlank())
                    .count();
        }
        assertThat(lines).isLessThanOrEqualTo(most);
    }

    @Test
    void worldHasFewFiles() throws IOException {
        assertThat(Rooms.filesBelow(MAIN.resolve("io/github/circles2d/world"), ".java"))
                .hasSizeLessThanOrEqualTo(375);
    }

    @Test
    void kernelsAreAscii() throws IOException {
        List<Path> kernels = Rooms.filesBelow(Path.of("kernels"), ".cl");
        assertThat(kernels).isNotEmpty();
        for (Path kernel : kernels) {
            byte[] bytes = Files.readAllBytes(kernel);
            for (int i = 0; i < bytes.length; i++) {
                assertThat(bytes[i]).as("byte %d of %s", i, kernel).isGreaterThanOrEqualTo((byte) 0);
            }
        }
    }

    @Test
    void everyRuleSeesItsViolation(@TempDir Path folder) throws IOException {
        source(folder, "opencl", "import io.github.circles2d.Circles2D;");
        source(folder, "thesis", "import io.github.circles2d.world.jvm.Grid;");
        source(folder, "world", "class Qualified { com.nativelibs4java.opencl.CLDevice device; }");
        source(folder, "scenes", "import static io.github.circles2d.opencl.OpenCl.devices;");
        source(folder, "tools", "import java.awt.Color;");
        source(folder, "attic", "");
        source(folder, "world.model", "import io.github.circles2d.world.Simulation;");
        source(folder, "world.jvm.threads", "import io.github.circles2d.world.jvm.*;");
        source(folder, "world.device", "class Qualified { io.github.circles2d.world.changes.Circles circles; }");
        source(folder, "world.device.part", "import io.github.circles2d.thesis.Ranges;");
        assertThat(Rooms.violations(folder))
                .hasSize(10)
                .anyMatch(line -> line.endsWith("world.model must not use world"))
                .anyMatch(line -> line.endsWith("world.jvm.threads must not use world.jvm"))
                .anyMatch(line -> line.endsWith("world.device must not use world.changes"))
                .anyMatch(line -> line.endsWith("world.device must not use thesis"))
                .anyMatch(line -> line.endsWith("opencl must not use api"))
                .anyMatch(line -> line.endsWith("thesis must not use world.jvm"))
                .anyMatch(line -> line.endsWith("com.nativelibs4java is for opencl alone"))
                .anyMatch(line -> line.endsWith("scenes must not use opencl"))
                .anyMatch(line -> line.endsWith("java.awt is for bench and demo and playground alone"))
                .anyMatch(line -> line.endsWith("unknown room attic"));
    }

    @Test
    void commentsAndOwnNamesAreNoViolation(@TempDir Path folder) throws IOException {
        source(folder, "opencl", "/** Like {@link io.github.circles2d.Circles2D}. */ // io.github.circles2d.World");
        source(folder, "demo", "import io.github.circles2d.Circles2D;\nimport java.awt.Color;");
        assertThat(Rooms.violations(folder)).isEmpty();
    }

    private static void source(Path folder, String room, String code) throws IOException {
        Files.writeString(folder.resolve(room + ".java"), "package io.github.circles2d." + room + ";\n" + code + "\n");
    }
}
