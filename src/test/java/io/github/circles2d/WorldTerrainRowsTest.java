package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** Discs roll over joints and corners, bounce and lie on terrain as theory says, and none passes it. */
class WorldTerrainRowsTest {
    static List<FigureRow> quick() {
        return Stream.of(TerrainRows.all(), TerrainShots.all(), TerrainCrowds.quick())
                .flatMap(List::stream)
                .toList();
    }

    static List<FigureRow> slow() {
        return TerrainCrowds.slow();
    }

    @ParameterizedTest
    @MethodSource("quick")
    void everyFigureIsAsAsked(FigureRow row) {
        assertAll(row.figures().get());
    }

    @ParameterizedTest
    @MethodSource("slow")
    @Tag("exhaustive")
    void everyFigureOfCrowdsIsAsAsked(FigureRow row) {
        assertAll(row.figures().get());
    }

    /** A blade that turns presses a ball against the floor, which friction lets it not leave. */
    @ParameterizedTest
    @CsvSource({"0.3, 0.6", "1, 0.3", "1, 1", "3, 0.6"})
    void aBallThatIsJammedIsNotShotAway(float omega, float friction) {
        try (TerrainBall ball =
                TerrainBall.at(2, 0.5, TerrainBall.builder(10, friction, 0)).on(false, 60, 0, -60, 0)) {
            TerrainBody body = ball.world.terrain().addBody(0, 1.2f, 0);
            body.addSegment(0, 0, 4, 0);
            body.setAngularVelocity(-omega);
            double greatest = 0;
            for (int step = 0; step < 150 / omega; step++) {
                ball.step(1);
                greatest = Math.max(greatest, ball.speed());
            }
            assertThat(greatest).isLessThan(4 * omega + 2);
        }
    }

    private static void assertAll(List<RowFigure> figures) {
        assertThat(figures).isNotEmpty().allMatch(RowFigure::holds);
    }
}
