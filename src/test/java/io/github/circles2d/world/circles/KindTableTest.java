package io.github.circles2d.world.circles;

import static io.github.circles2d.world.model.PairTable.IGNORE;
import static io.github.circles2d.world.model.PairTable.SENSE;
import static io.github.circles2d.world.model.PairTable.SOLID;
import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.world.model.KindField;
import io.github.circles2d.world.model.PairTable;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class KindTableTest {
    private final KindTable kinds = new KindTable();

    private int response(int a, int b) {
        assertThat(PairTable.get(kinds.responses(), b, a)).isEqualTo(PairTable.get(kinds.responses(), a, b));
        return PairTable.get(kinds.responses(), a, b);
    }

    private void set(int kind, int category, int mask) {
        kinds.set(KindField.CATEGORY, kind, category);
        kinds.set(KindField.MASK, kind, mask);
    }

    @Test
    void atFirstAllPairsAreSolidAndNothingIsFiltered() {
        assertThat(kinds.filters()).isFalse();
        assertThat(kinds.hash()).isZero();
        for (int a = 0; a < PairTable.KINDS; a += 15) {
            for (int b = 0; b < PairTable.KINDS; b++) {
                assertThat(response(a, b)).isEqualTo(SOLID);
            }
        }
    }

    @Test
    void masksOfBothMustAccept() {
        int[][] rows = {
            // category and mask of one, of the other, what they do to each other
            {1, 2, 2, 1, SOLID},
            {1, 2, 2, 2, IGNORE},
            {1, 1, 2, 1, IGNORE},
            {1, 1, 2, 2, IGNORE},
            {0, -1, 1, -1, IGNORE},
            {1 << 31, -1, 1, 1 << 31, SOLID},
            {3, 4, 6, 2, SOLID}
        };
        for (int[] row : rows) {
            set(17, row[0], row[1]);
            set(255, row[2], row[3]);
            assertThat(response(17, 255)).isEqualTo(row[4]);
            assertThat(response(16, 18)).isEqualTo(SOLID);
        }
    }

    @Test
    void aSensorSensesWhatItWouldMeetButNoOtherSensor() {
        kinds.set(KindField.SENSOR, 5, 1);
        set(6, 2, -1);
        kinds.set(KindField.MASK, 5, 1);
        assertThat(response(5, 4)).isEqualTo(SENSE);
        assertThat(response(5, 5)).isEqualTo(IGNORE);
        assertThat(response(5, 6)).isEqualTo(IGNORE);
        assertThat(response(4, 6)).isEqualTo(SOLID);
    }

    @Test
    void theMatrixWinsOverMasksAndSensorsAndGivesWayAgain() {
        kinds.set(KindField.SENSOR, 5, 1);
        set(6, 0, 0);
        for (int response : new int[] {SOLID, IGNORE, SENSE}) {
            kinds.setSetting(6, 5, KindTable.RESPONSE + response);
            kinds.setSetting(2, 2, KindTable.RESPONSE + response);
            assertThat(response(5, 6)).isEqualTo(response);
            assertThat(response(2, 2)).isEqualTo(response);
        }
        kinds.setSetting(5, 6, KindTable.BY_MASK);
        kinds.setSetting(2, 2, KindTable.BY_MASK);
        assertThat(response(5, 6)).isEqualTo(IGNORE);
        assertThat(response(2, 2)).isEqualTo(SOLID);
    }

    @Test
    void whatIsPutBackLeavesNothingBehind() {
        SplittableRandom random = new SplittableRandom(4);
        for (int k = 0; k < 500; k++) {
            set(random.nextInt(6), random.nextInt(4), random.nextInt(4));
            kinds.set(KindField.SENSOR, random.nextInt(6), random.nextInt(2));
            kinds.setSetting(random.nextInt(6), random.nextInt(6), random.nextInt(4));
            assertThat(kinds.filters()).isEqualTo(anyNotSolid());
        }
        for (int a = 0; a < 6; a++) {
            for (KindField field : KindField.ALL) {
                kinds.set(field, a, field.initial());
            }
            for (int b = 0; b < 6; b++) {
                kinds.setSetting(a, b, KindTable.BY_MASK);
            }
        }
        assertThat(kinds.filters()).isFalse();
        assertThat(kinds.hash()).isZero();
        assertThat(kinds.used() + kinds.settings()).isZero();
    }

    private boolean anyNotSolid() {
        for (int word : kinds.responses()) {
            if (word != 0) {
                return true;
            }
        }
        return false;
    }
}
