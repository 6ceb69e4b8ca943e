package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Discs roll, slide, turn, bounce and lie as theory says, or, where it says nothing, at least as well as Box2D's. */
class WorldSurfaceTest {
    static List<FigureRow> quick() {
        return Stream.concat(SurfaceRows.all().stream(), SurfaceCrowds.quick().stream())
                .toList();
    }

    static List<FigureRow> slow() {
        return SurfaceCrowds.slow();
    }

    @ParameterizedTest
    @MethodSource("quick")
    void everyFigureIsAsAsked(FigureRow row) {
        assertAll(row.figures().get());
    }

    @ParameterizedTest
    @MethodSource("slow")
    @Tag("exhaustive")
    void everyFigureOfHeapsIsAsAsked(FigureRow row) {
        assertAll(row.figures().get());
    }

    /** As the large heaps do. */
    @Test
    void aSmallHeapWithRollingResistanceComesToRest() {
        assertThat(SurfaceCrowds.speedInASmallHeap()).isLessThan(1e-3);
    }

    private static void assertAll(List<RowFigure> figures) {
        assertThat(figures).isNotEmpty().allMatch(RowFigure::holds);
    }
}
