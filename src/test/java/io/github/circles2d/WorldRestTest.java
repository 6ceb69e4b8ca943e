package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Piles that are built at rest stay at rest. */
class WorldRestTest {
    private static final int ROWS = 40;

    @Test
    @Tag("long")
    void aHexagonalPileOf40RowsStaysAtRest() {
        float r = 0.0125f;
        Random random = new Random(1);
        try (World world = emptyArena()) {
            for (int row = 0; row < ROWS; row++) {
                for (int column = 0; column < 40 - row % 2; column++) {
                    float x = r * (1 + row % 2) + 2 * r * column;
                    float y = r + row * r * (float) Math.sqrt(3);
                    world.add(x, y, r, 1 + 9 * random.nextFloat());
                }
            }
            assertStaysAtRest(world, r);
        }
    }

    @Test
    void aColumnOf40StaysAtRest() {
        float r = 0.0125f;
        Random random = new Random(2);
        try (World world = emptyArena()) {
            for (int row = 0; row < ROWS; row++) {
                world.add(0.5f, r + 2 * r * row, r, 1 + 9 * random.nextFloat());
            }
            assertStaysAtRest(world, r);
        }
    }

    private static World emptyArena() {
        return WorldScenes.jvm()
                .bounds(0, 0, 1, 1)
                .gravity(0, -0.01f)
                .restitution(0.5f)
                .build();
    }

    private static void assertStaysAtRest(World world, float r) {
        int n = world.size();
        float[] before = new float[4 * n];
        float[] after = new float[4 * n];
        world.read(before);
        world.step(1 / 60f, 3000);
        world.read(after);
        double creep = 0;
        for (int i = 0; i < n; i++) {
            creep = Math.max(creep, Math.hypot(after[4 * i] - before[4 * i], after[4 * i + 1] - before[4 * i + 1]));
        }
        assertThat(WorldScenes.quality(world).kineticEnergyPerCircle()).isLessThanOrEqualTo(1e-10);
        assertThat(creep / r).isLessThanOrEqualTo(0.03);
    }
}
