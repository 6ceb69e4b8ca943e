package io.github.circles2d.demo;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.opencl.ForkedJvm;
import io.github.circles2d.opencl.TestDevices;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The program as a person meets it: what it prints, what it writes, how it ends. */
@Tag("each-jdk")
class CirclesTestRunTest {
    private final ByteArrayOutputStream out = new ByteArrayOutputStream();
    private final ByteArrayOutputStream err = new ByteArrayOutputStream();

    @Test
    void aBadCommandLineEndsWithStatus2AndSaysWhatWasWrong() throws Exception {
        assertThat(run("--restitution", "2")).isEqualTo(2);
        assertThat(err.toString(StandardCharsets.UTF_8))
                .contains("--restitution takes a number from 0.0 to 1.0, not '2'")
                .contains("--help");
        assertThat(out.size()).isZero();
    }

    @Test
    void helpIsPrintedAndIsNoFailure() throws Exception {
        assertThat(run("--help")).isZero();
        assertThat(out.toString(StandardCharsets.UTF_8)).startsWith("usage: CirclesTest");
    }

    @Test
    void aPictureOfTheRealEngineShowsTheCirclesAndEachFramePrintsItsTime(@TempDir Path folder) throws Exception {
        TestDevices.all();
        Path file = folder.resolve("picture.png");

        assertThat(run("-n", "200", "--frames", "5", "--size", "300", "--png", file.toString()))
                .isZero();

        assertThat(out.toString(StandardCharsets.UTF_8).lines().filter(line -> line.matches("\\d+\\.\\d{3} ms")))
                .hasSize(5);
        BufferedImage picture = ImageIO.read(file.toFile());
        assertThat(picture.getWidth()).isEqualTo(320);
        assertThat(picture.getHeight()).isEqualTo(340);
        // 200 circles of the thesis's sizes cover a tenth of the arena; in y they start between 0.1 and 0.9.
        assertThat(litShare(picture, 10, 110, 300, 180)).isGreaterThan(0.05);
        assertThat(litShare(picture, 10, 300, 300, 19))
                .as("still empty near the floor")
                .isLessThan(0.05);
    }

    @Test
    void moreCirclesThanTheHeapHoldsAreOneLineThatSaysWhatToDo(@TempDir Path folder) {
        ForkedJvm.Result demo = new ForkedJvm()
                .option("-Xmx64m")
                .run(
                        CirclesTest.class,
                        "-n",
                        "10000000",
                        "--png",
                        folder.resolve("picture.png").toString());
        assertThat(demo.exitStatus()).as(demo.output()).isEqualTo(1);
        assertThat(demo.output().lines())
                .filteredOn(line -> !line.isBlank() && !line.startsWith("WARNING")) // of native access, on newer JDKs
                .singleElement()
                .asString()
                .contains("10000000 circles need more memory", "heap has (64 MB)", "-n", "-Xmx");
    }

    @Test
    void aQuietRunPrintsNoTimesAndThePictureIsTheSameEveryTime(@TempDir Path folder) throws Exception {
        TestDevices.all();
        String[] arguments = {
            "-q",
            "-n",
            "1",
            "--frames",
            "30",
            "--no-overlay",
            "--png",
            folder.resolve("a.png").toString()
        };
        assertThat(run(arguments)).isZero();
        arguments[7] = folder.resolve("b.png").toString();
        assertThat(run(arguments)).isZero();

        assertThat(out.toString(StandardCharsets.UTF_8)).doesNotContain(" ms");
        assertThat(Files.readAllBytes(folder.resolve("a.png"))).isEqualTo(Files.readAllBytes(folder.resolve("b.png")));
    }

    @Test
    void withoutADriverAPersonIsToldWhatToInstall(@TempDir Path folder) {
        ForkedJvm.Result result = new ForkedJvm()
                .environment("OCL_ICD_VENDORS", folder.toString())
                .run(CirclesTest.class, "--png", folder.resolve("picture.png").toString());

        assertThat(result.exitStatus()).isEqualTo(1);
        assertThat(result.output()).contains("circles2d demo: ", "driver", "apt-get install");
        assertThat(result.output()).doesNotContain("\tat ", "Exception in thread");
        assertThat(folder.resolve("picture.png")).doesNotExist();
    }

    @Test
    void withoutADisplayAPersonIsToldAboutPictures() {
        assertToldAboutPictures(
                new ForkedJvm().option("-Djava.awt.headless=true").run(CirclesTest.class));
    }

    @Test
    void withADisplayThatDoesNotAnswerAPersonIsToldAboutPictures() {
        org.junit.jupiter.api.Assumptions.assumeTrue(
                System.getProperty("os.name").equals("Linux"), "only X11 has displays that do not answer");
        assertToldAboutPictures(new ForkedJvm().environment("DISPLAY", ":987").run(CirclesTest.class));
    }

    @Test
    void aPictureNeedsNoDisplayEvenWhereOneIsNamedThatDoesNotAnswer(@TempDir Path folder) {
        TestDevices.all();
        Path file = folder.resolve("picture.png");
        ForkedJvm.Result result = new ForkedJvm()
                .environment("DISPLAY", ":987")
                .run(CirclesTest.class, "-n", "10", "--frames", "2", "--png", file.toString());

        assertThat(result.exitStatus()).as(result.output()).isZero();
        assertThat(file).isNotEmptyFile();
    }

    private static void assertToldAboutPictures(ForkedJvm.Result result) {
        assertThat(result.exitStatus()).isEqualTo(1);
        assertThat(result.output())
                .contains("no window can be shown here", "--png")
                .doesNotContain("\tat ");
    }

    private int run(String... arguments) throws InterruptedException {
        return CirclesTest.run(
                arguments,
                new PrintStream(out, true, StandardCharsets.UTF_8),
                new PrintStream(err, true, StandardCharsets.UTF_8));
    }

    private static double litShare(BufferedImage picture, int left, int top, int width, int height) {
        int lit = 0;
        for (int y = top; y < top + height; y++) {
            for (int x = left; x < left + width; x++) {
                lit += (picture.getRGB(x, y) & 0xffffff) != 0 ? 1 : 0;
            }
        }
        return lit / (double) (width * height);
    }
}
