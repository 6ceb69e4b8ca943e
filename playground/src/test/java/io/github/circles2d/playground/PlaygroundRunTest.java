package io.github.circles2d.playground;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.Backend;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The program as a person meets it: what it prints, what it writes, how it ends. */
class PlaygroundRunTest {
    private final ByteArrayOutputStream out = new ByteArrayOutputStream();
    private final ByteArrayOutputStream err = new ByteArrayOutputStream();

    private int run(String... arguments) throws InterruptedException {
        return Playground.run(arguments, new PrintStream(out, true), new PrintStream(err, true));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "--scene nowhere | there is no scene 'nowhere': there are sandbox, hourglass",
                "--frames 0 | --frames takes a whole number from 1 to 1000000, not '0'",
                "--frames many | not 'many'",
                "--size 30 | --size takes WIDTHxHEIGHT, not '30'",
                "--size 30x400 | --size takes a whole number from 100 to 8192, not '30'",
                "--backend abacus | --backend takes auto, jvm, cpu or gpu, not 'abacus'",
                "--paint taste | --paint takes plain, speed, pressure or contacts, not 'taste'",
                "--picture | --picture needs a value",
                "--page here | --page takes an address such as https://host/toy/, without #, not 'here'",
                "--colour red | there is no option '--colour'"
            })
    void aBadCommandLineEndsWithStatus2AndSaysWhatWasWrong(String line, String message) throws Exception {
        assertThat(run(line.split(" "))).isEqualTo(2);
        assertThat(err.toString(StandardCharsets.UTF_8)).contains(message).contains("--help");
        assertThat(out.size()).isZero();
    }

    @Test
    void helpHasOptionsScenesAndKeysAndIsNoFailure() throws Exception {
        assertThat(run("--help")).isZero();
        assertThat(out.toString(StandardCharsets.UTF_8))
                .contains("--picture FILE", "hourglass", "one-cell", "back in time");
    }

    @Test
    void aPictureNeedsNoDisplay(@TempDir Path folder) {
        Path file = folder.resolve("picture.png");
        ForkedJvm.Result result = new ForkedJvm()
                .environment("DISPLAY", "")
                .run(
                        Playground.class,
                        "--picture",
                        file.toString(),
                        "--scene",
                        "marbles",
                        "--frames",
                        "30",
                        "--size",
                        "400x260",
                        "--paint",
                        "plain");

        assertThat(result.exitStatus()).as(result.output()).isZero();
        assertThat(result.output()).contains("marbles, frame 30");
        assertThat(file).exists();
        BufferedImage picture = read(file);
        assertThat(picture.getWidth()).isEqualTo(400);
        assertThat(picture.getHeight()).isEqualTo(260);
        int lit = 0;
        for (int rgb : picture.getRGB(0, 0, 400, 260, null, 0, 400)) {
            lit += (rgb & 0xff) > 0x80 ? 1 : 0;
        }
        assertThat(lit).as("pixels of circles").isGreaterThan(3000);
    }

    @Test
    void aWorldIsSavedWithItsHashAndPrintedAsALink(@TempDir Path folder) throws Exception {
        Path file = folder.resolve("world.circles2d");
        String[] line = {
            "--scene", "pyramid", "--frames", "20", "--save", file.toString(), "--link", "--page", "http://a/"
        };
        assertThat(run(line)).isZero();
        try (Sandbox sandbox = new Sandbox(Stages.named("pyramid"), Backend.JVM)) {
            for (int k = 0; k < 20; k++) {
                sandbox.stepOnce(() -> {});
            }
            String hash = String.format("%016x", sandbox.world().hash());
            String link = WorldLink.of(sandbox.snapshot().array());
            assertThat(out.toString(StandardCharsets.UTF_8).lines())
                    .containsExactly(file + ": pyramid, frame 20, hash " + hash, "http://a/" + link);
            assertThat(file).hasBinaryContent(sandbox.snapshot().array());
        }
    }

    @Test
    void aWorldThatIsTooLargeForALinkIsOneLineAndStatus1() throws Exception {
        assertThat(run("--scene", "packed", "--frames", "1", "--link")).isEqualTo(1);
        assertThat(err.toString(StandardCharsets.UTF_8).lines())
                .singleElement()
                .asString()
                .matches("circles2d play: a link would have .* save a file instead");
    }

    private static BufferedImage read(Path file) {
        try {
            return ImageIO.read(file.toFile());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"--film", "--picture", "--save"})
    @Tag("long")
    void aFileThatCannotBeWrittenIsOneLineAndStatus1(String option, @TempDir Path folder) {
        Path nowhere = folder.resolve("no-such-folder/file.png");
        ForkedJvm.Result result = new ForkedJvm().run(Playground.class, "--frames", "1", option, nowhere.toString());
        assertThat(result.exitStatus()).isEqualTo(1);
        assertThat(result.output().lines())
                .containsExactly("circles2d play: there is no such file or folder: " + nowhere);
    }

    @Test
    @EnabledOnOs(OS.LINUX)
    void withoutADisplayItSaysSoAndNamesThePicture() {
        ForkedJvm.Result result = new ForkedJvm().environment("DISPLAY", "").run(Playground.class);
        assertThat(result.exitStatus()).isEqualTo(1);
        assertThat(result.output())
                .contains("no window can be shown here")
                .contains("--picture")
                .doesNotContain("\tat ");
    }
}
