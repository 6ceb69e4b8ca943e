package io.github.circles2d.playground;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Discs without holes, with smooth edges, as large as they should be. */
class RasterTest {
    private static final int SIDE = 200;
    private static final int WHITE = 0xffffff;

    private static Raster raster() {
        Raster raster = new Raster();
        raster.resize(SIDE, SIDE);
        raster.clear(0);
        return raster;
    }

    private static int at(Raster raster, int x, int y) {
        return raster.image().getRGB(x, y) & 0xffffff;
    }

    /** How much light there is, in white pixels. */
    private static double light(Raster raster) {
        double sum = 0;
        for (int y = 0; y < raster.height(); y++) {
            for (int x = 0; x < raster.width(); x++) {
                sum += (at(raster, x, y) & 0xff) / 255.0;
            }
        }
        return sum;
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.25, 0.5, 1, 1.5, 2.25, 4, 7.75, 20, 39, 60})
    void aDiscHasTheLightOfItsAreaWhereverItIsInAPixel(double radius) {
        for (double shift = 0; shift < 1; shift += 0.17) {
            Raster raster = raster();
            raster.disc(100 + shift, 100 - shift, radius, WHITE, WHITE);
            assertThat(light(raster))
                    .isCloseTo(Math.PI * radius * radius, within(0.05 * Math.PI * radius * radius + 0.3));
        }
    }

    @Test
    void theFillingIsInsideTheRimAndTheGroundOutside() {
        Raster raster = raster();
        raster.disc(100.5, 100.5, 20, 0x00ff00, 0xff0000);
        assertThat(at(raster, 100, 100)).isEqualTo(0x00ff00);
        assertThat(at(raster, 100 + 19, 100)).isEqualTo(0xff0000);
        assertThat(at(raster, 100 + 22, 100)).isZero();
        int edge = at(raster, 100 + 20, 100) >> 16;
        assertThat(edge).as("the edge is smooth").isBetween(60, 200);
    }

    @Test
    void whatLiesOutsideIsCutOff() {
        Raster all = raster();
        for (int k = 0; k < 4; k++) {
            all.disc(k % 2 * SIDE, k / 2 * SIDE, 30, WHITE, WHITE);
        }
        assertThat(light(all)).isCloseTo(Math.PI * 900, within(60.0));
        Raster none = raster();
        none.disc(-50, 100, 30, WHITE, WHITE);
        none.disc(100, SIDE + 31, 30, WHITE, WHITE);
        none.disc(Double.NaN, 100, 30, WHITE, WHITE);
        none.disc(100, Double.POSITIVE_INFINITY, 30, WHITE, WHITE);
        none.disc(100, 100, Double.NaN, WHITE, WHITE);
        none.disc(100, 100, -1, WHITE, WHITE);
        assertThat(light(none)).isZero();
    }

    @Test
    void aDiscThatIsLargerThanThePictureCoversIt() {
        Raster raster = raster();
        raster.disc(100, 100, 5000, WHITE, WHITE);
        assertThat(light(raster)).isEqualTo(SIDE * SIDE);
    }
}
