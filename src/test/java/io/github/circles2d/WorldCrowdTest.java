package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.scenes.Quality;
import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Circles that are all in one place: slow, never wrong. */
class WorldCrowdTest {
    @Test
    void twoThousandCirclesAtOnePointComeApart() {
        assertComesApart(Scenes.onePoint(2_000, Scenes.SEED), 400);
    }

    @Test
    @Tag("exhaustive")
    void tenThousandCirclesAtOnePointComeApart() {
        assertComesApart(Scenes.onePoint(10_000, Scenes.SEED), 800); // until then some still fall onto others
    }

    @Test
    @Tag("long")
    void allCirclesInOneCellComeApart() {
        assertComesApart(Scenes.oneCell(2_000, Scenes.SEED), 400);
    }

    private static void assertComesApart(Scene scene, int steps) {
        try (World world = WorldScenes.world(scene, WorldScenes.builder(scene))) {
            for (int k = 0; k < steps; k += 10) {
                world.step(scene.timeStep(), 10);
                assertInside(world, scene);
            }
            Quality quality = WorldScenes.quality(world);
            assertThat(quality.meanDepth()).isLessThanOrEqualTo(0.003);
            assertThat(quality.deep()).isLessThanOrEqualTo(1);
        }
    }

    @Test
    @Tag("long")
    void tenThousandCirclesAtOnePointHaveFarFewerContactsThanPairs() {
        Scene scene = Scenes.onePoint(10_000, Scenes.SEED);
        try (World world = WorldScenes.world(scene, WorldScenes.builder(scene))) {
            for (int k = 0; k < 3; k++) {
                world.step(scene.timeStep());
                assertInside(world, scene);
                assertThat(world.stats().contacts()).isBetween(100_000, 400_000);
                assertThat(world.stats().bytesHeld()).isLessThan(100_000_000);
            }
        }
    }

    private static void assertInside(World world, Scene scene) {
        float[] circles = new float[4 * world.size()];
        world.read(circles);
        for (int i = 0; i < world.size(); i++) {
            float r = circles[4 * i + 2];
            assertThat(circles[4 * i]).isBetween(scene.minX() + r, scene.maxX() - r);
            assertThat(circles[4 * i + 1]).isBetween(scene.minY() + r, scene.maxY() - r);
        }
    }
}
