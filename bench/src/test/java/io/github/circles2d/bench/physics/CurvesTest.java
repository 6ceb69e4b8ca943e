package io.github.circles2d.bench.physics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.circles2d.Backend;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class CurvesTest {
    /** The ball is in the air while it is recorded. */
    @Test
    void theEnergyOfAFallingBallIsALevelLine() {
        Recorder recorder = new Recorder(new WorldPhysics(Backend.JVM, 1), 0.5, 1);
        try (Arena arena = recorder.open(Setup.box(10, 20).withGravity(10))) {
            arena.add(5, 19, 0.5, 2);
            arena.step(120);
        }
        List<Recorder.Sample> samples = recorder.samples();
        assertThat(samples).hasSizeBetween(29, 32);
        assertThat(samples.get(0).seconds()).isCloseTo(0.5, within(0.02));
        assertThat(samples).allSatisfy(sample -> {
            assertThat(sample.energy()).isCloseTo(2 * 10 * 18.5, within(1.0));
            assertThat(sample.rms()).isCloseTo(10 * sample.seconds(), within(0.1));
            assertThat(sample.deepest()).isZero();
        });
    }

    @Test
    void curvesAreDrawnFromTheFile(@TempDir Path folder) throws IOException {
        String curves = "curve,engine,seconds,energy,deepest,rms\njam,World,0,1,0.5,2\njam,World,1,0.5,0.1,0.001\n";
        Files.writeString(folder.resolve(Curves.FILE), curves);
        Curves.draw(folder, new PrintStream(new ByteArrayOutputStream()));
        assertThat(folder.resolve("jam.png")).isNotEmptyFile();
        assertThat(folder.resolve("poured.png")).doesNotExist();
    }
}
