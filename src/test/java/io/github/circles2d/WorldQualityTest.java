package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.scenes.Quality;
import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Piles settle without deep overlaps. Limits: a good solver's figures, not this engine's. */
class WorldQualityTest {
    @Test
    void thesisSceneSettles() {
        Quality settling = after(Scenes.thesis(1250, Scenes.SEED), 600);
        assertThat(settling.meanDepth()).isLessThanOrEqualTo(0.0015);
        assertThat(settling.maxDepth()).isLessThanOrEqualTo(0.05);
        assertThat(settling.deep()).isZero();
    }

    @Test
    @Tag("exhaustive")
    void thesisSceneComesToRest() {
        Quality settled = after(Scenes.thesis(1250, Scenes.SEED), 3000);
        assertThat(settled.meanDepth()).isLessThanOrEqualTo(0.0005);
        assertThat(settled.kineticEnergyPerCircle()).isLessThanOrEqualTo(1e-7);
    }

    @Test
    void packedSceneOf5000SettlesWithoutDeepPairs() {
        Quality quality = after(Scenes.packed(5000, Scenes.SEED), 600);
        assertThat(quality.meanDepth()).isLessThanOrEqualTo(0.003);
        assertThat(quality.deep()).isZero();
    }

    @Test
    @Tag("exhaustive")
    void packedSceneOf15000SettlesWithAtMostFiveDeepPairs() {
        Quality quality = after(Scenes.packed(15000, Scenes.SEED), 600);
        assertThat(quality.meanDepth()).isLessThanOrEqualTo(0.006);
        assertThat(quality.deep()).isLessThanOrEqualTo(5);
    }

    @Test
    @Tag("exhaustive")
    void barrelSettles() {
        assertThat(after(Scenes.barrel(Scenes.SEED), 600).meanDepth()).isLessThanOrEqualTo(0.005);
    }

    private static Quality after(Scene scene, int steps) {
        try (World world = WorldScenes.world(scene, WorldScenes.builder(scene))) {
            world.step(scene.timeStep(), steps);
            return WorldScenes.quality(world);
        }
    }
}
