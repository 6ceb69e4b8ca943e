package io.github.circles2d.world.circles;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.world.model.ContactRows;
import org.junit.jupiter.api.Test;

class StateHashTest {
    /** Or a row that is added to {@link ContactRows} would change all hashes. */
    @Test
    void aLaterRowCountsOnlyIfItIsNotZero() {
        float[] impulses = {2f, 0f, 0f, 0f};
        long ofFirstRows = StateHash.absorbRows(7, impulses, 0, 2, 2);
        assertThat(StateHash.absorbRows(7, impulses, 0, 4, 2)).isEqualTo(ofFirstRows);

        impulses[2] = 3f;
        long ofThird = StateHash.absorbRows(7, impulses, 0, 4, 2);
        impulses[2] = 0f;
        impulses[3] = 3f;
        long ofFourth = StateHash.absorbRows(7, impulses, 0, 4, 2);
        impulses[3] = -0f;
        long ofNegativeZero = StateHash.absorbRows(7, impulses, 0, 4, 2);
        assertThat(new long[] {ofThird, ofFourth, ofNegativeZero}).doesNotHaveDuplicates();
        assertThat(new long[] {ofThird, ofFourth, ofNegativeZero}).doesNotContain(ofFirstRows);
    }

    @Test
    void theFirstRowsCountAlsoIfTheyAreZero() {
        assertThat(StateHash.absorbRows(7, new float[2], 0, 2, 2))
                .isNotEqualTo(StateHash.absorbRows(7, new float[2], 0, 1, 2))
                .isNotEqualTo(7);
    }
}
