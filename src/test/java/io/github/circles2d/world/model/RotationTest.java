package io.github.circles2d.world.model;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

@Tag("each-jdk")
class RotationTest {
    @Test
    void sineAndCosineAreThoseOfTheAngleButForTheLastBits() {
        Random random = new Random(1);
        for (int i = 0; i < 100_000; i++) {
            int units = random.nextInt();
            double radians = units * Rotation.RADIANS_PER_UNIT;
            assertThat(Rotation.sin(units)).as("%d", units).isCloseTo(StrictMath.sin(radians), within(4e-16));
            assertThat(Rotation.cos(units)).as("%d", units).isCloseTo(StrictMath.cos(radians), within(4e-16));
        }
    }

    @Test
    void quartersOfATurnAreExact() {
        int quarter = 1 << 30;
        assertThat(Rotation.sin(0)).isEqualTo(0);
        assertThat(Rotation.cos(0)).isEqualTo(1);
        assertThat(Rotation.sin(quarter)).isEqualTo(1);
        assertThat(Rotation.cos(quarter)).isZero();
        assertThat(Rotation.sin(2 * quarter)).isZero();
        assertThat(Rotation.cos(2 * quarter)).isEqualTo(-1);
        assertThat(Rotation.sin(-quarter)).isEqualTo(-1);
        assertThat(Rotation.cos(-quarter)).isZero();
    }

    @Test
    void anAngleHasWholeTurnsInUnits() {
        assertThat(Rotation.units(2 * Math.PI)).isEqualTo(Rotation.TURN);
        assertThat(Rotation.units(-Math.PI)).isEqualTo(-Rotation.TURN / 2);
        assertThat(Rotation.units(20 * Math.PI)).isEqualTo(10 * Rotation.TURN);
    }
}
