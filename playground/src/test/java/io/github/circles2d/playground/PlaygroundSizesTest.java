package io.github.circles2d.playground;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Nothing of the window is cut off or covered, in a small window as in a large one. */
@Timeout(300)
class PlaygroundSizesTest {
    /** {@code -Dcircles2d.screenshots=FOLDER} has it save the screen at each turn. */
    @Test
    void theRealWindowHasAPlaceForAllInFourSizesAndItsMenusSayWhatHolds() throws Exception {
        VirtualDisplay display = VirtualDisplay.open();
        try {
            String folder = System.getProperty("circles2d.screenshots", "");
            ForkedJvm jvm = new ForkedJvm();
            if (!display.name().isEmpty()) {
                jvm.environment("DISPLAY", display.name());
            }
            ForkedJvm.Result result =
                    folder.isEmpty() ? jvm.run(SizesProgram.class) : jvm.run(SizesProgram.class, folder);
            String output = result.output();
            assertThat(output)
                    .doesNotContain("Exception")
                    .contains("main ends", "the scene is marked: true", "the next scene is marked: true")
                    .contains("the back end is marked: true", "time runs: true")
                    .contains("420 x 320, graphs are shown: false", "1000 x 800, graphs are shown: true")
                    .contains("Pause or go on=SPACE, One step=PERIOD, One step back=COMMA, Slower=S, Start again=R")
                    .contains(
                            "Next back end=N", "Back to all=HOME, Contact points=V, Times by stage=T, Graphs=G, Keys=H")
                    .contains("Open world ...=ctrl O", "Quit=ctrl Q");
            assertThat(output.lines().filter(line -> line.endsWith(": false") && !line.contains("graphs are shown")))
                    .isEmpty();
            assertThat(result.exitStatus()).as(output).isZero();
        } finally {
            display.close();
        }
    }

    @Test
    void theKeysAreReadableAtAnySizeAndWhatIsBeyondThePanelCanBeScrolledTo() {
        for (int width = 360; width <= 1700; width += 20) {
            for (int height = 130; height <= 1100; height += 10) {
                HelpLayout layout = Help.layout(width, height);
                assertThat(14 * layout.scale()).as("%d x %d", width, height).isGreaterThan(10);
                assertThat(new Rectangle(width, height)
                                .contains(layout.left(), layout.top(), layout.width(), layout.height()))
                        .as("%d x %d: %s", width, height, layout)
                        .isTrue();
                int rows = layout.columns() == 2 ? 11 : 22;
                double end = (HelpLayout.HEAD + (rows - 1) * HelpLayout.ROW + 22) * layout.scale();
                assertThat(end).isLessThanOrEqualTo(layout.height() + layout.mostScroll());
            }
        }
        assertThat(Help.layout(1000, 740).mostScroll()).isZero();
        assertThat(Help.layout(420, 180).mostScroll()).isPositive();
    }

    @Test
    void aLongMessageIsBrokenIntoLinesAndLosesNothing() {
        Graphics2D g = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB).createGraphics();
        FontMetrics metrics = g.getFontMetrics(Theme.font(13));
        String text = "OPENCL_CPU goes on from step 1,234: hash 0123456789abcdef, the same " + "x".repeat(200);
        List<String> lines = Hud.wrap(text, metrics, 250);
        assertThat(String.join("", lines)).isEqualToIgnoringWhitespace(text);
        assertThat(lines).allMatch(line -> metrics.stringWidth(line) <= 250);
    }

    @Test
    void whatIsDisabledCanBeReadAndIsDarkerThanTheRest() {
        assertThat(contrast(Theme.DISABLED, Theme.BAR)).isGreaterThan(4.5);
        assertThat(contrast(Theme.TEXT, Theme.BAR)).isGreaterThan(2 * contrast(Theme.DISABLED, Theme.BAR));
    }

    /** As the guidelines for web content define it. */
    private static double contrast(Color light, Color dark) {
        return (luminance(light) + 0.05) / (luminance(dark) + 0.05);
    }

    private static double luminance(Color colour) {
        return 0.2126 * linear(colour.getRed())
                + 0.7152 * linear(colour.getGreen())
                + 0.0722 * linear(colour.getBlue());
    }

    private static double linear(int value) {
        double share = value / 255.0;
        return share <= 0.04045 ? share / 12.92 : Math.pow((share + 0.055) / 1.055, 2.4);
    }
}
