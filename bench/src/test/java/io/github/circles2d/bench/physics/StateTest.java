package io.github.circles2d.bench.physics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class StateTest {
    @Test
    void depthIsThatOfTheDeepestPairWhereverItsCirclesAre() {
        State state = new State(4, 0, 0, 0, 10, 10);
        circle(state, 0, 9, 5, 1, 1);
        circle(state, 1, 2, 5, 1, 1);
        circle(state, 2, 3.5, 5, 0.6, 1);
        circle(state, 3, 3.5, 6.5, 1, 1);
        assertThat(state.deepest()).isCloseTo(0.1, within(1e-9));
        assertThat(state.deepestOfSmaller()).isCloseTo(0.1 / 0.6, within(1e-9));
        assertThat(state.meanDepth()).isCloseTo(0.1, within(1e-9));
        assertThat(state.deepestInWall()).isZero();
    }

    @Test
    void staticCirclesMayOverlapAndHaveNoEnergy() {
        State state = new State(3, -10, 0, 0, 10, 10);
        circle(state, 0, 2, 5, 1, Double.POSITIVE_INFINITY);
        circle(state, 1, 3, 5, 1, Double.POSITIVE_INFINITY);
        circle(state, 2, 8, 4, 1, 2);
        state.vx[1] = 7;
        state.vy[2] = 3;
        assertThat(state.deepest()).isZero();
        assertThat(state.rmsSpeed()).isEqualTo(3);
        assertThat(state.centreOfMass()).isEqualTo(4);
        assertThat(state.energy()).isEqualTo(0.5 * 2 * 9 + 2 * 10 * 3);
    }

    private static void circle(State state, int i, double x, double y, double radius, double mass) {
        state.x[i] = x;
        state.y[i] = y;
        state.radius[i] = radius;
        state.mass[i] = mass;
    }
}
