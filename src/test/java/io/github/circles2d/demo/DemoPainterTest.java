package io.github.circles2d.demo;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

@Tag("each-jdk")
class DemoPainterTest {
    private static final int WIDTH = 500;
    private static final int HEIGHT = 520;
    /** The colour inside the heaviest disc. */
    private static final int CORE = Palette.ramp(10)[Palette.ramp(10).length - 1];

    @Test
    void theGroundIsBlackAndTheArenaIsOutlinedJustOutsideItself() {
        BufferedImage picture = paint(WIDTH, HEIGHT, circles());

        assertThat(rgb(picture, 250, 260)).isZero();
        assertThat(rgb(picture, 10, 20)).as("upper left pixel of the arena").isZero();
        assertThat(rgb(picture, 489, 499)).as("lower right pixel of the arena").isZero();
        assertThat(rgb(picture, 9, 260)).as("left wall").isNotZero();
        assertThat(rgb(picture, 490, 260)).as("right wall").isNotZero();
        assertThat(rgb(picture, 250, 19)).as("upper wall").isNotZero();
        assertThat(rgb(picture, 250, 500)).as("lower wall").isNotZero();
        assertThat(rgb(picture, 4, 260)).as("margin").isZero();
    }

    @Test
    void yPointsUp() {
        BufferedImage picture = paint(WIDTH, HEIGHT, circles(0.5f, 0.9f, 0.02f, 5));

        assertThat(rgb(picture, 250, 20 + 48)).isNotZero();
        assertThat(rgb(picture, 250, 20 + 432)).isZero();
    }

    @Test
    void aDiscCoversItsPixelsAndNoOthers() {
        double radius = 24;
        BufferedImage picture = paint(WIDTH, HEIGHT, circles(0.25f, 0.5f, 0.05f, 10));

        for (int y = 200; y < 320; y++) {
            for (int x = 70; x < 190; x++) {
                double distance = Math.hypot(x + 0.5 - (10 + 120), y + 0.5 - (20 + 240));
                if (distance > radius + 0.6) {
                    assertThat(rgb(picture, x, y)).as("outside at %d, %d", x, y).isZero();
                } else if (distance < radius - 2) {
                    assertThat(rgb(picture, x, y)).as("inside at %d, %d", x, y).isEqualTo(CORE);
                }
            }
        }
    }

    @Test
    void theEdgeIsSmooth() {
        DemoRaster raster = new DemoRaster();
        raster.resize(100, 100);
        raster.disc(50.25, 50, 20, new int[] {0xffffff});
        long greys = 0;
        double light = 0;
        for (int y = 0; y < 100; y++) {
            for (int x = 0; x < 100; x++) {
                int value = rgb(raster.image(), x, y) & 0xff;
                light += value / 255.0;
                greys += value > 0 && value < 255 ? 1 : 0;
            }
        }

        assertThat(greys).as("pixels between black and white").isGreaterThan(80);
        assertThat(light).as("area").isCloseTo(Math.PI * 400, org.assertj.core.data.Percentage.withPercentage(0.5));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.3, 0.7, 1, 1.5, 2, 3, 6})
    void aSmallDiscHasTheLightOfItsAreaWhereverItLies(double radius) {
        for (double shift = 0; shift < 1; shift += 0.25) {
            DemoRaster raster = new DemoRaster();
            raster.resize(20, 20);
            raster.disc(10 + shift, 10 - shift / 2, radius, new int[] {0xffffff});
            double light = 0;
            for (int y = 0; y < 20; y++) {
                for (int x = 0; x < 20; x++) {
                    light += (rgb(raster.image(), x, y) & 0xff) / 255.0;
                }
            }
            assertThat(light).isBetween(0.85 * Math.PI * radius * radius, 1.15 * Math.PI * radius * radius);
        }
    }

    @Test
    void brightnessGrowsWithMass() {
        double before = 0;
        for (float mass = 1; mass <= 10; mass += 0.5f) {
            BufferedImage picture = paint(WIDTH, HEIGHT, circles(0.5f, 0.5f, 0.05f, mass));
            double brightness = brightness(rgb(picture, 250, 260));
            assertThat(brightness).as("mass %s", mass).isGreaterThan(before);
            before = brightness;
        }
    }

    @ParameterizedTest
    @CsvSource({"0, 1", "1e-9, 1", "11, 10", "1e30, 10", "Infinity, 10"})
    void aMassBeyondTheSceneHasTheBrightnessOfTheNearerEnd(float mass, float nearest) {
        assertThat(Palette.shade(mass)).isEqualTo(Palette.shade(nearest));
    }

    @ParameterizedTest
    @CsvSource({"500, 520", "1000, 1040", "900, 400", "300, 1000", "37, 61", "1, 1"})
    void theArenaStaysASquareInTheMiddleAtEverySize(int width, int height) {
        Viewport arena = Viewport.fit(width, height, 1);

        assertThat(arena.side()).isEqualTo(Math.max(1, Math.min(width - 20, height - 40)));
        assertThat(arena.left()).isBetween((width - arena.side()) / 2 - 1, (width - arena.side()) / 2);
        assertThat(arena.top()).isBetween((height - arena.side()) / 2 - 1, (height - arena.side()) / 2);
        BufferedImage picture = paint(width, height, circles(0.5f, 0.5f, 0.1f, 10));
        assertThat(rgb(picture, (int) arena.x(0.5), (int) arena.y(0.5))).isNotZero();
    }

    @Test
    void aPainterFollowsTheWindowWhenItIsResized() {
        DemoPainter painter = new DemoPainter();
        DemoFrame frame = frame(circles(0.5f, 0.25f, 0.05f, 10));
        painter.picture(WIDTH, HEIGHT, frame, false);
        BufferedImage larger = painter.picture(980, 1040, frame, false);

        assertThat(rgb(larger, 10 + 480, 40 + 720)).isEqualTo(CORE);
        assertThat(rgb(larger, 10 + 480, 40 + 240)).isZero();
        assertThat(painter.picture(WIDTH, HEIGHT, frame, false).getRGB(250, 20 + 360) & 0xffffff)
                .isEqualTo(CORE);
    }

    @Test
    void nothingOfTheLastFrameIsLeft() {
        DemoPainter painter = new DemoPainter();
        painter.picture(WIDTH, HEIGHT, frame(circles(0.2f, 0.2f, 0.05f, 10)), false);
        BufferedImage next = painter.picture(WIDTH, HEIGHT, frame(circles(0.8f, 0.8f, 0.05f, 10)), false);

        assertThat(rgb(next, 10 + 96, 20 + 384)).isZero();
    }

    @Test
    void onAScreenWithSmallPixelsDiscsAreFilledInDevicePixels() {
        BufferedImage screen = new BufferedImage(1000, 1040, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = screen.createGraphics();
        g.scale(2, 2);
        new DemoPainter().paint(g, WIDTH, HEIGHT, frame(circles(0.5f, 0.5f, 0.05f, 10)), false, List.of());
        g.dispose();

        BufferedImage direct = new DemoPainter().picture(1000, 1040, frame(circles(0.5f, 0.5f, 0.05f, 10)), false);
        assertThat(rgb(screen, 500, 520)).isEqualTo(CORE);
        int centre = 520;
        int reach = 0;
        while (rgb(screen, 500 + reach, centre) != 0) {
            reach++;
        }
        assertThat(reach).as("radius in device pixels").isBetween(47, 50);
        assertThat(rgb(direct, 500, 520)).isEqualTo(CORE);
    }

    @Test
    void circlesBeyondThePictureAndCirclesThatAreNotFiniteAreCutOff() {
        float nan = Float.NaN;
        float inf = Float.POSITIVE_INFINITY;
        BufferedImage picture = paint(WIDTH, HEIGHT, new float[][] {
            {-5, 5, 0.5f, nan, 0.5f, inf, 0.5f, 0.0f},
            {0.5f, 0.5f, -9, 0.5f, nan, 0.5f, 0.5f, 1.0f},
            {0.1f, 0.1f, 0.1f, 0.1f, 0.1f, 0.1f, nan, 0.03f},
            {5, 5, 5, 5, 5, 5, 5, nan}
        });

        assertThat(rgb(picture, 250, 260)).isZero();
        assertThat(rgb(picture, 12, 22)).as("the one circle that is there").isNotZero();
    }

    @Test
    void theOverlaySaysEngineStrategySizeDeviceTimesAndRemark() {
        DemoFrame frame = new DemoFrame(
                new float[4][12345],
                678,
                "Circles2D",
                "a device",
                "strategy 2 (row search)",
                3.456,
                58.7,
                true,
                "a remark");

        assertThat(Overlay.lines(frame))
                .containsExactly(
                        "Circles2D, strategy 2 (row search), n = 12,345",
                        "a device",
                        "3.46 ms a loop, 59 frames a second, frame 678, paused",
                        "a remark");
    }

    @Test
    void theOverlayIsDrawnOnlyWhereItIsWanted() {
        DemoFrame frame = frame(circles());

        assertThat(lightOf(new DemoPainter().picture(WIDTH, HEIGHT, frame, true)))
                .isGreaterThan(lightOf(new DemoPainter().picture(WIDTH, HEIGHT, frame, false)));
    }

    @Test
    void theOverlayStaysInsideTheArenaHoweverLongTheDevicesName() {
        DemoFrame frame = new DemoFrame(new float[4][0], 0, "Circles2D", "x".repeat(500), "0", 0, 0, false, "");
        BufferedImage with = new DemoPainter().picture(WIDTH, HEIGHT, frame, true);
        BufferedImage without = new DemoPainter().picture(WIDTH, HEIGHT, frame, false);

        for (int y = 0; y < HEIGHT; y++) {
            for (int x = 489; x < WIDTH; x++) {
                assertThat(rgb(with, x, y)).as("%d, %d", x, y).isEqualTo(rgb(without, x, y));
            }
        }
    }

    private static BufferedImage paint(int width, int height, float[][] circles) {
        return new DemoPainter().picture(width, height, frame(circles), false);
    }

    private static DemoFrame frame(float[][] circles) {
        return new DemoFrame(circles, 1, "Test", "no device", "0", 1, 60, false, "");
    }

    /** Circles from rows of x, y, radius, mass. */
    private static float[][] circles(float... rows) {
        float[][] circles = new float[4][rows.length / 4];
        for (int k = 0; k < rows.length; k++) {
            circles[k % 4][k / 4] = rows[k];
        }
        return circles;
    }

    private static int rgb(BufferedImage picture, int x, int y) {
        return picture.getRGB(x, y) & 0xffffff;
    }

    private static double brightness(int rgb) {
        return 0.299 * (rgb >> 16) + 0.587 * (rgb >> 8 & 0xff) + 0.114 * (rgb & 0xff);
    }

    private static double lightOf(BufferedImage picture) {
        double sum = 0;
        for (int y = 0; y < picture.getHeight(); y++) {
            for (int x = 0; x < picture.getWidth(); x++) {
                sum += brightness(rgb(picture, x, y));
            }
        }
        return sum;
    }
}
