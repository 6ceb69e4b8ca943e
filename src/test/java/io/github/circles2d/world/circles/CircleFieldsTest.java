package io.github.circles2d.world.circles;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** The values of fields of circles, where they are copied. */
class CircleFieldsTest {
    /** As a world and its saved state do in each frame of a game that goes back. */
    @Test
    void twoObjectsThatCopyFromEachOtherDoNotGrow() {
        CircleFields one = new CircleFields(CircleField.ALL);
        CircleFields other = new CircleFields(CircleField.ALL);
        other.ensure(CircleField.TAG, 100);
        one.ensure(CircleField.TAG, 101);
        one.set(CircleField.TAG, 100, 7);
        for (int k = 0; k < 60; k++) {
            other.copy(one);
            one.copy(other);
        }
        assertThat(one.bytes()).isLessThan(2000);
        assertThat(other.bytes()).isLessThan(2000);
        assertThat(one.get(CircleField.TAG, 100)).isEqualTo(7);
    }
}
