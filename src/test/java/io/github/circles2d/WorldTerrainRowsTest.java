package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
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

    private static void assertAll(List<RowFigure> figures) {
        assertThat(figures).isNotEmpty().allMatch(RowFigure::holds);
    }
}
