package io.github.circles2d.bench.physics;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class BoundTest {
    @Test
    void aFigureMeetsABoundUpToItsEnds() {
        assertThat(Bound.atMost(0.02).met(0.02)).isTrue();
        assertThat(Bound.atMost(0.02).met(0.0201)).isFalse();
        assertThat(Bound.atLeast(0.95).met(0.94)).isFalse();
        assertThat(Bound.between(0.97, 1.03).met(1)).isTrue();
        assertThat(Bound.between(0.97, 1.03).met(1.04)).isFalse();
    }

    @Test
    void whatIsNotANumberMeetsNoBound() {
        assertThat(Bound.atMost(1).met(Double.NaN)).isFalse();
        assertThat(Bound.atLeast(1).met(Double.NaN)).isFalse();
    }

    @Test
    void boundsAreWrittenShort() {
        assertThat(Bound.atMost(0.005)).hasToString("<= 0.005");
        assertThat(Bound.atMost(900)).hasToString("<= 900");
        assertThat(Bound.between(0.97, 1.03)).hasToString("0.97 to 1.03");
        assertThat(Bound.NONE).hasToString("-");
    }
}
