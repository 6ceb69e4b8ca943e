package io.github.circles2d.calibration;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.circles2d.calibration.Timings.Runner;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import java.util.zip.CRC32;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

@Tag("each-jdk")
class TimingsFileTest {
    private static final Runner DEVICE = new Runner("a device\twith\na strange name ", "driver 1, kernels 0123");
    private static final Timings SOME = new Timings(List.of(
            entry("EXACT", new Runner("another device", "17"), Map.of(250, 0.125, 1_000, 1 / 3.0)),
            entry("ROW_SEARCH", new Runner("another device", "17"), Map.of(250, 0.25)),
            entry("EXACT", DEVICE, Map.of(1_000, 1e-9, 8_000, 12_345.678))));

    @TempDir
    Path folder;

    private static Timings.Entry entry(String indexing, Runner runner, Map<Integer, Double> millis) {
        return new Timings.Entry(indexing, runner, new Curve(millis));
    }

    @Test
    void whatIsWrittenIsReadAgainToTheBitAndNothingElseIsLeftInTheFolder() throws IOException {
        Path file = folder.resolve("new/folders/calibration.txt");
        TimingsFile.write(file, Timings.NONE);
        assertThat(TimingsFile.read(file)).isEqualTo(Timings.NONE);
        TimingsFile.write(file, SOME);
        Timings read = TimingsFile.read(file);
        assertThat(read.entries()).hasSize(SOME.entries().size());
        for (int k = 0; k < SOME.entries().size(); k++) {
            Timings.Entry expected = SOME.entries().get(k);
            Timings.Entry actual = read.entries().get(k);
            assertThat(actual.indexing()).isEqualTo(expected.indexing());
            assertThat(actual.runner()).isEqualTo(expected.runner());
            assertThat(actual.curve().measured()).isEqualTo(expected.curve().measured());
        }
        try (Stream<Path> files = Files.list(file.getParent())) {
            assertThat(files).containsExactly(file);
        }
    }

    @Test
    void aMissingFileHoldsNothing() throws IOException {
        assertThat(TimingsFile.read(folder.resolve("none/there"))).isEqualTo(Timings.NONE);
    }

    @Test
    void aFileCutOffAnywhereOrWithAnyByteChangedIsKnownForOne() throws IOException {
        Path file = folder.resolve("file");
        TimingsFile.write(file, SOME);
        byte[] whole = Files.readAllBytes(file);
        for (int length = 0; length < whole.length; length++) {
            Files.write(file, Arrays.copyOf(whole, length));
            assertThatThrownBy(() -> TimingsFile.read(file)).isInstanceOf(IOException.class);
        }
        for (int k = 0; k < whole.length; k++) {
            byte[] changed = whole.clone();
            changed[k] ^= 1;
            Files.write(file, changed);
            assertThatThrownBy(() -> TimingsFile.read(file)).isInstanceOf(IOException.class);
        }
    }

    @Test
    void aFileOfAnotherKindOrSizeIsRefusedWithTheReason() throws IOException {
        Path file = folder.resolve("file");
        Files.writeString(file, "#!/bin/sh\n");
        assertThatThrownBy(() -> TimingsFile.read(file)).hasMessageContaining("does not begin with");
        Files.write(file, new byte[2 << 20]);
        assertThatThrownBy(() -> TimingsFile.read(file)).hasMessageContaining("2097152 bytes");
        assertThatThrownBy(() -> TimingsFile.read(folder)).hasMessageContaining("not a file");
    }

    @Test
    void whereItCannotBeWrittenTheOldFileStaysAsItWas() throws IOException {
        Path file = folder.resolve("file");
        TimingsFile.write(file, SOME);
        assertThatThrownBy(() -> TimingsFile.write(file.resolve("below a file"), Timings.NONE))
                .isInstanceOf(IOException.class);
        assertThat(TimingsFile.read(file).entries()).hasSize(SOME.entries().size());
    }

    @Test
    void aLineThatMakesNoSenseIsRefusedThoughTheChecksumIsRight() throws IOException {
        for (String line : List.of(
                "EXACT\tdevice\t17\t250=1\tmore\n", "EXACT\tdevice\t17\t250=-1\n", "EXACT\tdevice\t17\t250\n")) {
            String lines = "circles2d calibration 2\n" + line;
            CRC32 sum = new CRC32();
            sum.update(lines.getBytes(StandardCharsets.UTF_8));
            Path file = folder.resolve("by hand");
            Files.writeString(file, lines + "checksum " + Long.toHexString(sum.getValue()) + "\n");
            assertThatThrownBy(() -> TimingsFile.read(file))
                    .isInstanceOf(IOException.class)
                    .hasMessageContaining("a line of it");
        }
    }

    @Test
    void newerTimingsReplaceThoseOfTheSameRunnerInAnyVersionAndNoOthers() {
        Runner newer = new Runner(DEVICE.name(), "driver 2");
        Timings both = SOME.and(new Timings(List.of(entry("EXACT", newer, Map.of(1_000, 2.0)))));
        assertThat(both.entries()).hasSize(SOME.entries().size());
        assertThat(both.find("EXACT", newer)).isPresent();
        assertThat(both.find("EXACT", DEVICE)).isEmpty();
        assertThat(both.find("ROW_SEARCH", newer)).isEmpty();
        assertThat(both.find("EXACT", new Runner("another device", "17"))).isPresent();
        assertThat(both.find("EXACT", new Runner("another device", "18"))).isEmpty();
    }
}
