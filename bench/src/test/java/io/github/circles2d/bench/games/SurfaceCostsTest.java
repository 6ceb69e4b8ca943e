package io.github.circles2d.bench.games;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.circles2d.Backend;
import io.github.circles2d.World;
import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;

class SurfaceCostsTest {
    private static final int N = 300;

    private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    private final PrintStream out = new PrintStream(bytes, true, StandardCharsets.UTF_8);

    @Test
    void linesHaveTheColumnsOfTheHeader() {
        for (String radii : SurfaceCosts.CASES) {
            bytes.reset();
            SurfaceCosts.compare(radii, Backend.JVM, N, 10, 0, 1, out);
            String line = bytes.toString(StandardCharsets.UTF_8).replaceAll("\"[^\"]*\"", "machine");
            assertThat(line).startsWith("machine," + (radii.equals("like") ? "like" : "1:10") + "," + N + ",");
            assertThat(line.strip().split(",", -1)).hasSameSizeAs(SurfaceCosts.HEADER.split(","));
        }
    }

    @Test
    void circlesOfTheFirstWorldTurnAndOfTheOtherDoNot() {
        try (World with = SurfaceCosts.world("like", Backend.JVM, N, 0.6f, 0);
                World other = SurfaceCosts.world("like", Backend.JVM, N, 0, 0)) {
            with.step(1 / 60f, 100);
            other.step(1 / 60f, 100);
            assertThat(with.hash()).isNotEqualTo(other.hash());
            assertThat(with.friction(with.handle(0))).isEqualTo(0.6f);
            assertThat(other.friction(other.handle(0))).isZero();
        }
    }

    @Test
    void oneWorldIsTimedForAComparison() {
        SurfaceCosts.run(List.of("run", "300", "1", "5", "5"), out);
        assertThat(bytes.toString(StandardCharsets.UTF_8)).matches("[0-9.]+,[0-9.]+\\R");
        assertThatThrownBy(() -> SurfaceCosts.run(List.of("run", "300"), out))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("SKIPPED");
    }
}
