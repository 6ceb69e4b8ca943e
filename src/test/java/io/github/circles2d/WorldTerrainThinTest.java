package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

/** Solid terrain that is thinner than a circle: whoever goes around its end is on the other side, and is held by none of the two. */
class WorldTerrainThinTest {
    private static World world() {
        return WorldScenes.jvm().bounds(-10, -10, 10, 10).gravity(0, 0).build();
    }

    /** It passes the upper left corner at a distance, and nothing touches it. */
    @Test
    void aCircleThatHasGoneAroundAPlateFliesOnAboveIt() {
        try (World world = world()) {
            world.terrain().addChain(Chain.of(0, 0, 2, 0, 2, 0.1f, 0, 0.1f).close());
            long ball = world.add(-0.26f, -0.3f, 0.25f, 1);
            world.setVelocity(ball, 0, 1);
            while (world.y(ball) < 0.36f) {
                world.step(1 / 60f);
            }
            world.setVelocity(ball, 1, 0);
            world.step(1 / 60f, 180);
            assertThat(world.vx(ball)).isCloseTo(1, within(0.001f));
            assertThat(world.vy(ball)).isCloseTo(0, within(0.001f));
        }
    }

    /** The part of a ring is 0.2 thick. The ball meets its end, and must get away from it. */
    @Test
    void aCircleThatMeetsTheEndOfAThinRingIsNotCaught() {
        try (World world = world()) {
            float end = 1.15f;
            float cos = (float) StrictMath.cos(end);
            float sin = (float) StrictMath.sin(end);
            float x = (float) StrictMath.cos(0.3);
            float y = (float) StrictMath.sin(0.3);
            world.terrain()
                    .addChain(Chain.from(4.4f * x, 4.4f * y)
                            .arcTo(0, 0, end - 0.3f)
                            .lineTo(4.2f * cos, 4.2f * sin)
                            .arcTo(0, 0, 0.3f - end)
                            .close());
            long ball = world.add(4.0883f, 0.5015f, 0.25f, 1, 20.712f, 42.629f, 0);
            for (int step = 0; step < 30; step++) {
                float fromX = world.x(ball);
                float fromY = world.y(ball);
                world.step(1 / 120f);
                assertThat(Math.hypot(world.x(ball) - fromX, world.y(ball) - fromY))
                        .as("its way in step %d, of 0.395 by its speed", step)
                        .isLessThan(0.5);
            }
            assertThat(Math.hypot(world.vx(ball), world.vy(ball))).isGreaterThan(10);
        }
    }
}
