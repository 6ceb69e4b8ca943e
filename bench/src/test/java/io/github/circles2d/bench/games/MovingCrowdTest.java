package io.github.circles2d.bench.games;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.Backend;
import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;

/** The crowd that grows and shrinks ends with one hash in all worlds, and each frame is in a row. */
class MovingCrowdTest {
    @Test
    void theRowsHaveAllFramesAndTheCrowdComesBackToItsSize() {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        PrintStream out = new PrintStream(bytes, true, StandardCharsets.UTF_8);
        MovingCrowd.measure(100, 130, List.of(Backend.AUTO, Backend.JVM, Backend.JVM), out);
        List<String> lines = bytes.toString(StandardCharsets.UTF_8).lines().toList();
        assertThat(lines.get(0)).isEqualTo(MovingCrowd.HEADER);
        int frames = 0;
        for (String line : lines.subList(1, lines.size())) {
            String[] cells = line.split(",");
            assertThat(cells).hasSize(11);
            assertThat(Integer.parseInt(cells[0])).isEqualTo(frames);
            frames += Integer.parseInt(cells[1]);
            assertThat(cells[9]).isEqualTo("JVM");
        }
        assertThat(frames).isPositive();
        assertThat(lines.get(lines.size() - 1).split(",")[2]).isEqualTo("100");
    }
}
