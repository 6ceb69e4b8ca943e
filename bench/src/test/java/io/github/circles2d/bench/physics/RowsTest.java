package io.github.circles2d.bench.physics;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.Backend;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** The rows of the physics that take seconds, on World. */
class RowsTest {
    private static final Physics WORLD = new WorldPhysics(Backend.JVM, 1);

    @ParameterizedTest(name = "row {0}: {1}")
    @MethodSource("held")
    @Tag("long")
    void whatIsHeldMeetsItsBounds(int number, String name, Row row, Case scene) {
        for (Figure figure : Figure.of(row, scene, WORLD, Effort.TEST)) {
            assertThat(figure.met())
                    .as(
                            "%s is %s, asked is %s",
                            figure.measure().what(),
                            figure.median(),
                            figure.measure().bound())
                    .isTrue();
        }
    }

    @ParameterizedTest(name = "row {0}: {1}")
    @MethodSource("running")
    void whatIsNotHeldYetRunsAndGivesFigures(int number, String name, Row row, Case scene) {
        for (Figure figure : Figure.of(row, scene, WORLD, Effort.QUICK)) {
            assertThat(figure.median()).as(figure.measure().what()).isFinite();
        }
    }

    @Test
    void theRowsAreThoseOfTheTableInItsOrder() {
        assertThat(Rows.ALL.stream().map(Row::number))
                .containsExactlyElementsOf(IntStream.rangeClosed(1, 18).boxed().toList());
    }

    /** Or the files could not tell one from the other. */
    @Test
    void noTwoFiguresOfARowHaveOneName() {
        for (Row row : Rows.ALL) {
            Set<List<String>> names = new HashSet<>();
            for (Case scene : row.cases()) {
                for (Measure measure : scene.measures()) {
                    assertThat(names.add(List.of(scene.name(), measure.what())))
                            .as("%s, %s", scene.name(), measure)
                            .isTrue();
                }
            }
        }
    }

    static Stream<Arguments> held() {
        return cases(Check.HOLDS);
    }

    static Stream<Arguments> running() {
        return cases(Check.RUNS);
    }

    private static Stream<Arguments> cases(Check check) {
        return Rows.ALL.stream().flatMap(row -> row.cases().stream()
                .filter(scene -> scene.check() == check)
                .map(scene -> Arguments.of(row.number(), scene.name(), row, scene)));
    }
}
