package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Pendulums, chains, bridges, springs, ropes, motors, soft rings and hubs are as stiff, and swing and turn, as theory says. */
class WorldJointTest {
    static List<FigureRow> rows() {
        return Stream.of(JointRows.all(), JointNets.all()).flatMap(List::stream).toList();
    }

    @ParameterizedTest
    @MethodSource("rows")
    void everyFigureIsAsAsked(FigureRow row) {
        assertThat(row.figures().get()).isNotEmpty().allMatch(RowFigure::holds);
    }
}
