package io.github.circles2d.tools;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

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
    void forgettingDeletesTheFile(@TempDir Path folder) throws Exception {
        String before = System.getProperty("circles2d.calibration");
        Path file = Files.writeString(folder.resolve("calibration.txt"), "whatever it holds");
        System.setProperty("circles2d.calibration", file.toString());
        try {
            assertThat(run("--forget")).isZero();
            assertThat(file).doesNotExist();
            assertThat(run("--forget")).isZero();
        } finally {
            if (before == null) {
                System.clearProperty("circles2d.calibration");
            } else {
                System.setProperty("circles2d.calibration", before);
            }
        }
    }
}
