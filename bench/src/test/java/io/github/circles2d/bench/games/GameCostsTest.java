package io.github.circles2d.bench.games;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.circles2d.World;
import io.github.circles2d.bench.engines.Engines;
import io.github.circles2d.bench.jmh.GameCostBenchmark;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.openjdk.jmh.annotations.Param;

class GameCostsTest {
    private static final int N = 600;
    private static final int STEPS = 5;

    @Test
    void featuresThatMoveNothingEndInTheSilentState() throws IOException {
        ByteBuffer start = GameCosts.start(world(), N);
        long silent = end(GameCosts.NOTHING, start);
        for (String feature : GameCosts.FEATURES) {
            long hash = end(feature, start);
            assertThat(hash == silent).as(feature).isEqualTo(GameCosts.keepsState(feature));
            GameCosts.checkAgainstSilent(feature, hash, silent);
            assertThatThrownBy(() -> GameCosts.checkAgainstSilent(
                            feature, GameCosts.keepsState(feature) ? silent + 1 : silent, silent))
                    .isInstanceOf(IllegalStateException.class)
                    .hasMessageContaining(feature);
        }
    }

    @Test
    void worldsAreTheSameInEveryRun() throws IOException {
        ByteBuffer start = GameCosts.start(world(), N);
        for (String feature : GameCosts.FEATURES) {
            try (GameCosts costs = new GameCosts(feature, world(), start)) {
                costs.prepare();
                costs.frames(STEPS);
                long once = costs.end();
                costs.prepare();
                costs.frames(STEPS);
                assertThat(costs.end()).as(feature).isEqualTo(once);
            }
        }
    }

    @Test
    void theBenchmarkHasAllFeatures() throws NoSuchFieldException {
        Param values = GameCostBenchmark.class.getField("feature").getAnnotation(Param.class);
        assertThat(values.value()).containsExactlyElementsOf(GameCosts.FEATURES);
    }

    @Test
    void wrongArgumentsAreNamed() {
        for (String[] wrong : new String[][] {{"GPU"}, {"AUTO"}, {"JVM", "0"}, {"JVM", "many"}, {"JVM", "100", "-3"}}) {
            assertThatThrownBy(() -> GameCosts.run(List.of(wrong), System.out))
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessageContaining("'" + wrong[wrong.length - 1] + "'");
        }
        assertThatThrownBy(() -> new GameCosts("music", world(), ByteBuffer.allocate(0)))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("'music'");
    }

    private static World.Builder world() {
        return Engines.worldBuilder(Engines.WORLD_JVM);
    }

    private static long end(String feature, ByteBuffer start) throws IOException {
        try (GameCosts costs = new GameCosts(feature, world(), start)) {
            costs.prepare();
            costs.frames(STEPS);
            return costs.end();
        }
    }
}
