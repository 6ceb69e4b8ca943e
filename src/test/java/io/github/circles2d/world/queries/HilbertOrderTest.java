package io.github.circles2d.world.queries;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class HilbertOrderTest {
    @Test
    void neighboursInTheOrderAreNeighboursOnASquareOfPowersOfTwo() {
        int side = 64;
        float[] circles = new float[4 * side * side];
        for (int i = 0; i < side * side; i++) {
            circles[4 * i] = i % side;
            circles[4 * i + 1] = i / side;
        }
        int[] order = new HilbertOrder().order(circles, side * side);
        boolean[] seen = new boolean[side * side];
        for (int k = 0; k < side * side; k++) {
            assertThat(seen[order[k]]).isFalse();
            seen[order[k]] = true;
            if (k > 0) {
                int steps = Math.abs(order[k] % side - order[k - 1] % side)
                        + Math.abs(order[k] / side - order[k - 1] / side);
                assertThat(steps).as("from place %d", k - 1).isEqualTo(1);
            }
        }
    }
}
