package io.github.circles2d.tools;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

@Tag("each-jdk")
class CalibrateTest {
    private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();

    private int run(String... arguments) {
        return Calibrate.run(new PrintStream(bytes, true, StandardCharsets.UTF_8), arguments);
    }

    @Test
    void unknownArgumentsAreRefusedWithTheUsageAndHelpIsNoError() {
        assertThat(run("--frobnicate")).isEqualTo(2);
        assertThat(bytes.toString(StandardCharsets.UTF_8)).startsWith("usage: ");
        assertThat(run("--forget", "it")).isEqualTo(2);
        assertThat(run("--help")).isZero();
    }

    @Test
    void aPropertyThatNamesAFolderIsOneLineAndKeepsTheFolder(@TempDir Path folder) {
        withCalibration(folder, () -> {
            assertThat(run()).isEqualTo(1);
            assertThat(run("--forget")).isEqualTo(1);
        });
        assertThat(bytes.toString(StandardCharsets.UTF_8).lines())
                .filteredOn(line -> !line.startsWith("measuring"))
                .hasSize(2)
                .allMatch(line -> line.contains("circles2d.calibration is '" + folder + "'"));
        assertThat(folder).exists();
    }

    @Test
    void allPlacesNameTheSameDuration() throws Exception {
        List<String> places = List.of(
                "docs/thesis.md",
                "circles2d",
                "src/main/java/io/github/circles2d/Calibration.java",
                "src/main/java/io/github/circles2d/tools/Calibrate.java");
        for (String place : places) {
            String text = Files.readString(Path.of(place)).replaceAll("[\\s*]+", " ");
            assertThat(text).as(place).containsOnlyOnce("some seconds for each device");
        }
    }

    @Test
    void forgettingDeletesTheFile(@TempDir Path folder) throws Exception {
        Path file = Files.writeString(folder.resolve("calibration.txt"), "whatever it holds");
        withCalibration(file, () -> {
            assertThat(run("--forget")).isZero();
            assertThat(file).doesNotExist();
            assertThat(run("--forget")).isZero();
        });
    }

    private static void withCalibration(Path place, Runnable test) {
        String before = System.getProperty("circles2d.calibration");
        System.setProperty("circles2d.calibration", place.toString());
        try {
            test.run();
        } finally {
            if (before == null) {
                System.clearProperty("circles2d.calibration");
            } else {
                System.setProperty("circles2d.calibration", before);
            }
        }
    }
}
