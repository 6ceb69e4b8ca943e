package io.github.circles2d.world.circles;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class CircleFieldsTest {
    /** As a world and its saved state do, once a frame. It took all memory before. */
    @Test
    void twoThatCopyEachOtherInTurnsDoNotGrow() {
        CircleFields a = new CircleFields(CircleField.ALL);
        CircleFields b = new CircleFields(CircleField.ALL);
        a.ensure(CircleField.TAG, 10);
        b.ensure(CircleField.TAG, 12);
        b.set(CircleField.TAG, 11, 7);
        for (int k = 0; k < 200; k++) {
            a.copy(b);
            b.copy(a);
        }
        assertThat(a.get(CircleField.TAG, 11)).isEqualTo(7);
        assertThat(b.get(CircleField.TAG, 12)).isEqualTo(CircleField.TAG.initial());
    }
}
