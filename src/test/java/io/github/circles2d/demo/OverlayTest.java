package io.github.circles2d.demo;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The demo's text is whole and in its place, at any size of the window. */
@Tag("each-jdk")
class OverlayTest {
    private static final String DEVICE =
            "pthread-skylake-avx512-AMD EPYC (CPU, 2 compute units, 4.4 GiB, Portable Computing Language, driver 3.1+debian)";

    private final Graphics2D g = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB).createGraphics();

    private static DemoFrame frame(String device) {
        return new DemoFrame(
                new float[4][1250], 678, "Circles2D", device, "strategy 2 (row search)", 3.456, 58.7, true, "a remark");
    }

    @ParameterizedTest
    @CsvSource({"420, 320", "500, 520", "1000, 800", "800, 1000", "1600, 1000", "3000, 1200"})
    void allKeysAreUnderTheArenaAndInTheWindow(int width, int height) {
        Viewport arena = Viewport.fit(width, height, 1);
        Overlay.Block below = Overlay.below(g, arena, width, height, DemoCanvas.KEYS);
        assertThat(String.join("   ", below.lines())).isEqualTo(String.join("   ", DemoCanvas.KEYS));
        assertThat(new Rectangle(width, height).contains(below.bounds()))
                .as("%s", below)
                .isTrue();
        assertThat(below.bounds().y).isGreaterThanOrEqualTo((int) (arena.top() + arena.side()));
        assertFits(below, below.bounds().width);
    }

    @ParameterizedTest
    @CsvSource({"420, 320", "500, 520", "1000, 800", "1600, 1000"})
    void theNameOfTheDeviceIsWholeAndInTheArena(int width, int height) {
        Viewport arena = Viewport.fit(width, height, 1);
        Overlay.Block panel = Overlay.panel(g, arena, frame(DEVICE));
        assertThat(String.join(" ", panel.lines())).contains(DEVICE).endsWith("a remark");
        Rectangle square = new Rectangle((int) arena.left(), (int) arena.top(), (int) arena.side(), (int) arena.side());
        assertThat(square.contains(panel.bounds())).as("%s", panel).isTrue();
        assertFits(panel, panel.bounds().width);
    }

    @ParameterizedTest
    @CsvSource({"160, 180", "161, 400", "37, 61", "1, 1"})
    void inATinyWindowLinesAreLeftOutAndNoneIsBrokenOff(int width, int height) {
        Viewport arena = Viewport.fit(width, height, 1);
        Overlay.Block below = Overlay.below(g, arena, width, height, DemoCanvas.KEYS);
        for (String line : below.lines()) {
            assertThat(DemoCanvas.KEYS).containsAll(List.of(line.split("   ")));
        }
        assertThat(Overlay.panel(g, arena, frame(DEVICE)).lines()).isNotEmpty();
    }

    @Test
    void aWordThatIsLongerThanALineIsBroken() {
        FontMetrics metrics = g.getFontMetrics();
        List<String> lines = LineBreaker.words("a " + "x".repeat(300), metrics, 100);
        assertThat(String.join("", lines)).isEqualTo("a" + "x".repeat(300));
        assertThat(lines).allMatch(line -> metrics.stringWidth(line) <= 100).hasSizeGreaterThan(5);
    }

    private void assertFits(Overlay.Block block, int room) {
        FontMetrics metrics = g.getFontMetrics(block.font());
        assertThat(block.lines()).allMatch(line -> metrics.stringWidth(line) <= room);
    }
}
