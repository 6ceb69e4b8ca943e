package io.github.circles2d.bench.engines;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.circles2d.World;
import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;

class StartsTest {
    @Test
    void aStartIsTheSceneAfterItsSteps() throws IOException {
        Scene scene = Scenes.packed(60, Scenes.SEED);
        Motion expected = new Motion(60);
        try (Engine engine = Engines.create(Engines.WORLD_JVM);
                World world = Engines.worldBuilder(Engines.WORLD_JVM).build()) {
            engine.load(scene);
            for (int step = 0; step < 7; step++) {
                engine.step();
            }
            engine.read(expected);
            world.restore(Starts.get(Engines.WORLD_JVM, 60, 7));
            float[] circles = new float[240];
            world.read(circles);
            for (int i = 0; i < 60; i++) {
                assertThat(circles[4 * i]).isEqualTo(expected.x[i]);
                assertThat(circles[4 * i + 1]).isEqualTo(expected.y[i]);
            }
        }
    }

    @Test
    void aStartThatIsKeptIsWhatWouldBeMade() throws IOException {
        ByteBuffer made = Starts.get(Engines.WORLD_JVM, 50, 3);
        Starts.keep(Engines.WORLD_JVM, 50, 3);
        Path kept = Path.of(
                System.getProperty("java.io.tmpdir"),
                "circles2d-starts-" + ProcessHandle.current().pid(),
                "50-3");
        assertThat(ByteBuffer.wrap(Files.readAllBytes(kept))).isEqualTo(made);
    }

    @Test
    void aWorldThatThereIsNotIsRefusedByName() {
        assertThatThrownBy(() -> Engines.worldBuilder("world-abacus"))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("world-abacus");
    }
}
