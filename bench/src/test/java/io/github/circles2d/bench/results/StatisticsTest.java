package io.github.circles2d.bench.results;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class StatisticsTest {
    @Test
    void meanErrorMinimumAndMedianOfKnownValues() {
        Statistics statistics = Statistics.of(4, 1, 3, 2);
        assertThat(statistics.runs()).isEqualTo(4);
        assertThat(statistics.mean()).isEqualTo(2.5);
        // sample variance 5/3, over 4 runs
        assertThat(statistics.standardError()).isCloseTo(Math.sqrt(5.0 / 3 / 4), within(1e-12));
        assertThat(statistics.min()).isEqualTo(1);
        assertThat(statistics.median()).isEqualTo(2.5);
        assertThat(Statistics.of(9, 1, 5).median()).isEqualTo(5);
    }

    @Test
    void oneRunHasNoStandardErrorAndNoneIsRefused() {
        assertThat(Statistics.of(7).standardError()).isNaN();
        assertThatThrownBy(Statistics::of).isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void numbersReadAsTheyAreWritten() {
        assertThat(Numbers.exact(0.0123456)).isEqualTo("0.01235");
        assertThat(Numbers.exact(123456)).isEqualTo("123500");
        assertThat(Numbers.exact(Double.NaN)).isEmpty();
        assertThat(Numbers.parse(Numbers.exact(Double.NaN))).isNaN();
        assertThat(Numbers.brief(0.06449)).isEqualTo("0.064");
        assertThat(Numbers.brief(451.4)).isEqualTo("451");
        assertThat(Numbers.brief(12345)).isEqualTo("12,345");
        assertThat(Numbers.brief(0)).isEqualTo("0");
        assertThat(Numbers.brief(Double.NaN)).isEqualTo("-");
    }
}
