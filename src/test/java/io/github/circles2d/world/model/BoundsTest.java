package io.github.circles2d.world.model;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class BoundsTest {
    /** A replay gives places again that are inside already. */
    @ParameterizedTest
    @CsvSource({"-10, 10", "-50, 50", "-5.3, 4.7", "-20, 0.1", "0, 1", "100, 300"})
    void aPlaceThatHasBeenBroughtInsideStaysThere(float min, float max) {
        Bounds bounds = new Bounds(min, min, max, max, AxisEdge.WRAP, AxisEdge.WRAP);
        for (int period = -30; period <= 30; period++) {
            float seam = min + period * (max - min);
            for (float x : new float[] {Math.nextDown(seam), seam, Math.nextUp(seam), seam + 0.3f * (max - min)}) {
                float place = bounds.placeX(x);
                assertThat(place).isGreaterThanOrEqualTo(min).isLessThan(max);
                assertThat(bounds.placeX(place)).isEqualTo(place);
                assertThat(bounds.placeY(x)).isEqualTo(place);
            }
        }
    }

    @Test
    void withoutASeamAPlaceStaysWhereItIs() {
        Bounds bounds = new Bounds(0, 0, 1, 1, AxisEdge.OPEN, AxisEdge.WALL);
        assertThat(bounds.placeX(7)).isEqualTo(7);
        assertThat(bounds.placeY(0.5f)).isEqualTo(0.5f);
    }
}
