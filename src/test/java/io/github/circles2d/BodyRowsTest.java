package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Bodies that are pushed stack, slide, bounce, roll and hit as the page on the physics says. */
class BodyRowsTest {
    static List<FigureRow> quickRows() {
        return BodyRows.quick();
    }

    static List<FigureRow> slowRows() {
        return BodyRows.slow();
    }

    @ParameterizedTest
    @MethodSource("quickRows")
    void everyFigureIsAsAsked(FigureRow row) {
        assertThat(row.figures().get()).isNotEmpty().allMatch(RowFigure::holds);
    }

    @ParameterizedTest
    @MethodSource("slowRows")
    @Tag("long")
    void soAreThoseThatTakeLonger(FigureRow row) {
        assertThat(row.figures().get()).isNotEmpty().allMatch(RowFigure::holds);
    }
}
