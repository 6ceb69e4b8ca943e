package io.github.circles2d.bench.measure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.List;
import org.junit.jupiter.api.Test;

class OptionsTest {
    @Test
    void withoutArgumentsEverythingIsMeasuredWithoutALimit() {
        Options options = Options.parse(List.of());
        assertThat(options.parts()).containsExactlyElementsOf(EnumSet.complementOf(EnumSet.of(Options.Part.SERIES)));
        assertThat(options.budgetSeconds()).isInfinite();
        assertThat(options.charts()).isTrue();
        assertThat(options.sizes(List.of(1, 2))).containsExactly(1, 2);
    }

    @Test
    void quickEndsInLessThanThreeMinutes() {
        assertThat(Options.parse(List.of("--quick")).budgetSeconds()).isLessThan(180);
    }

    @Test
    void aShortLookGoesWhereItCannotTakeThePlaceOfASweepAndIsNotCommitted() throws IOException {
        Path results = Options.parse(List.of()).out();
        assertThat(Options.parse(List.of("--quick")).out()).isEqualTo(results.resolve("quick"));
        assertThat(Files.readAllLines(Path.of("../.gitignore"))).contains("/bench/results/quick/");
        assertThat(Options.parse(List.of("--out", "here", "--quick")).out()).isEqualTo(Path.of("here"));
    }

    @Test
    void timesAreSecondsMinutesOrHours() {
        assertThat(Options.parse(List.of("--time-budget", "90s")).budgetSeconds())
                .isEqualTo(90);
        assertThat(Options.parse(List.of("--time-budget", "9m")).budgetSeconds())
                .isEqualTo(540);
        assertThat(Options.parse(List.of("--time-budget", "2h", "--quick")).budgetSeconds())
                .isEqualTo(7200);
    }

    @Test
    void partsDevicesAndSizesAreLists() {
        Options options = Options.parse(
                List.of("--only", "copy,peers", "--device", "cpu-2,gpu", "--sizes", "1250,5000", "--no-charts"));
        assertThat(options.parts()).containsExactly(Options.Part.COPY, Options.Part.PEERS);
        assertThat(options.devices()).containsExactly("cpu-2", "gpu");
        assertThat(options.sizes(List.of(1))).containsExactly(1250, 5000);
        assertThat(options.charts()).isFalse();
    }

    @Test
    void whatIsWrongIsNamed() {
        refused("--fast", "--fast");
        refused("banana", "--only", "banana");
        refused("soon", "--time-budget", "soon");
        refused("-5", "--sizes", "-5");
        refused("--machine needs a value", "--machine");
        refused("--only needs a value", "--only", "--quick");
    }

    /** What is of one command alone is not passed over in silence by the other. */
    @Test
    void anOptionOfTheOtherCommandIsRefused() {
        refused("there is no option --patience", "--patience", "9s");
        refused("there is no option --write", "--write", "here");
        refused("there is no option --only", "series", "--only", "copy");
        refused("there is no option here", "here");
    }

    private static void refused(String message, String... arguments) {
        assertThatThrownBy(() -> Options.parse(List.of(arguments)))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining(message);
    }
}
