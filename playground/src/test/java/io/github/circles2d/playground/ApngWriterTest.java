package io.github.circles2d.playground;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Films are what they show, and small. */
class ApngWriterTest {
    private static final int WIDTH = 90;
    private static final int HEIGHT = 50;

    private static BufferedImage[] pictures(int count, int colours) {
        BufferedImage[] pictures = new BufferedImage[count];
        for (int k = 0; k < count; k++) {
            pictures[k] = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
            Graphics2D g = pictures[k].createGraphics();
            g.setColor(new Color(0x102030));
            g.fillRect(0, 0, WIDTH, HEIGHT);
            for (int c = 0; c < colours; c++) {
                g.setColor(Color.getHSBColor((float) c / colours, 0.9f, 0.9f));
                g.fillRect(5 + 3 * c % 70, 2 + (7 * c + 5 * k) % 40, 8, 8);
            }
            g.dispose();
        }
        return pictures;
    }

    private static byte[] write(BufferedImage[] pictures) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        new ApngWriter(WIDTH, HEIGHT, 20).write(pictures, out);
        return out.toByteArray();
    }

    @Test
    void everyPictureComesBackInItsColours() throws Exception {
        BufferedImage[] pictures = pictures(12, 6);
        Apng film = new Apng(write(pictures));
        assertThat(film.count).isEqualTo(12);
        assertThat(film.plays).as("for ever").isZero();
        assertThat(film.seconds).isCloseTo(12 / 20.0, within(1e-9));
        for (int k = 0; k < pictures.length; k++) {
            assertClose(film.pictures.get(k), pictures[k], 8);
        }
    }

    @Test
    void ofManyColoursEachPixelHasOneThatIsNear() throws Exception {
        BufferedImage[] pictures = pictures(3, 200);
        Apng film = new Apng(write(pictures));
        for (int k = 0; k < pictures.length; k++) {
            assertClose(film.pictures.get(k), pictures[k], 60);
        }
    }

    @Test
    void picturesWithoutAChangeAndOnesOfOnePixelAreFine() throws Exception {
        BufferedImage[] pictures = pictures(1, 3);
        BufferedImage dotted = pictures(1, 3)[0];
        dotted.setRGB(WIDTH - 1, HEIGHT - 1, 0xffffff);
        BufferedImage[] film = {pictures[0], pictures[0], dotted, dotted, pictures[0]};
        Apng read = new Apng(write(film));
        for (int k = 0; k < film.length; k++) {
            assertClose(read.pictures.get(k), film[k], 8);
        }
    }

    @Test
    void aReaderThatKnowsNoFilmsShowsTheFirstPicture() throws Exception {
        BufferedImage[] pictures = pictures(3, 6);
        assertClose(ImageIO.read(new ByteArrayInputStream(write(pictures))), pictures[0], 8);
    }

    @Test
    @Tag("long")
    void theFilmOfTheReadmeRunsSixSecondsAndIsSmall() throws Exception {
        byte[] bytes = Files.readAllBytes(Path.of("../docs/playground.png"));
        Apng film = new Apng(bytes);
        assertThat(bytes.length).isLessThan(3_000_000);
        assertThat(film.seconds).isBetween(5.5, 6.5);
        assertThat(film.pictures).hasSize(film.count);
        assertThat(film.plays).isZero();
    }

    private static void assertClose(BufferedImage actual, BufferedImage expected, int within) {
        for (int y = 0; y < expected.getHeight(); y++) {
            for (int x = 0; x < expected.getWidth(); x++) {
                for (int shift = 0; shift <= 16; shift += 8) {
                    int a = actual.getRGB(x, y) >> shift & 0xff;
                    int b = expected.getRGB(x, y) >> shift & 0xff;
                    assertThat(Math.abs(a - b)).as("pixel %d, %d", x, y).isLessThanOrEqualTo(within);
                }
            }
        }
    }
}
