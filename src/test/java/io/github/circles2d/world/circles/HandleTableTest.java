package io.github.circles2d.world.circles;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class HandleTableTest {
    private static final int KINDS = 5;

    @Test
    void theStaticCirclesOfAKindAreCounted() {
        SplittableRandom random = new SplittableRandom(1);
        HandleTable table = new HandleTable();
        for (int k = 0; k < 3000; k++) {
            int id = random.nextInt(40);
            if (id >= table.end() || !table.lives(id)) {
                id = table.add(1);
                table.fields().ensure(CircleField.KIND, id + 1);
            }
            switch (random.nextInt(4)) {
                case 0 -> table.remove(id);
                case 1 -> table.setField(CircleField.KIND, id, random.nextInt(KINDS));
                default -> table.setMass(id, random.nextInt(8) == 0 ? Float.POSITIVE_INFINITY : 1);
            }
            for (int kind = 0; kind < KINDS; kind++) {
                assertThat(table.hasStatics(kind)).isEqualTo(has(table, kind));
            }
        }
    }

    private static boolean has(HandleTable table, int kind) {
        boolean has = false;
        for (int id = 0; id < table.end(); id++) {
            has |= table.lives(id) && table.isStatic(id) && table.fields().getInt(CircleField.KIND, id) == kind;
        }
        return has;
    }
}
