package io.github.circles2d.bench.games;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import io.github.circles2d.Backend;
import io.github.circles2d.World;
import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;

class TerrainCostsTest {
    private static final int N = 600;

    @Test
    void linesHaveTheColumnsOfTheHeader() {
        for (String each : TerrainCosts.CASES) {
            ByteArrayOutputStream bytes = new ByteArrayOutputStream();
            TerrainCosts.compare(each, Backend.JVM, N, 0, 1, new PrintStream(bytes, true, StandardCharsets.UTF_8));
            String line = bytes.toString(StandardCharsets.UTF_8).replaceAll("\"[^\"]*\"", "machine");
            assertThat(line).startsWith(each + ",machine,");
            assertThat(line.strip().split(",", -1)).hasSameSizeAs(TerrainCosts.HEADER.split(","));
        }
    }

    @Test
    void shelvesHaveAsManyContactsAsTheLattice() {
        try (World with = TerrainCosts.world("lie", true, Backend.JVM, N);
                World other = TerrainCosts.world("lie", false, Backend.JVM, N)) {
            with.step(1 / 60f, 200);
            other.step(1 / 60f, 200);
            assertThat(other.terrain().size()).isZero();
            assertThat(with.size()).isEqualTo(other.size());
            double ratio = (double) TerrainCosts.contacts(with) / TerrainCosts.contacts(other);
            assertThat(ratio).isCloseTo(1, within(0.1));
        }
    }

    @Test
    void levelsKeepTheirCirclesWithinTheBounds() {
        for (String name : TerrainLevels.LEVELS) {
            String level = TerrainLevels.level(name, N);
            try (World world = TerrainLevels.load(level, World.builder().backend(Backend.JVM), 1)) {
                assertThat(world.size()).as(name).isEqualTo(N);
                boolean hasTerrain = !name.equals("pile");
                assertThat(world.terrain().size() > 20).as(name).isEqualTo(hasTerrain);
                float[] circles = new float[4 * N];
                world.read(circles);
                double before = meanHeight(circles);
                world.step(1 / 60f, 60);
                world.read(circles);
                assertThat(meanHeight(circles)).as(name).isLessThan(before);
            }
        }
    }

    private static double meanHeight(float[] circles) {
        double sum = 0;
        for (int k = 1; k < circles.length; k += 4) {
            sum += circles[k];
        }
        return sum / (circles.length / 4);
    }

    @Test
    void wrongArgumentsAreNamed() {
        for (String wrong : new String[] {"GPU", "0", "99", "river"}) {
            assertThatThrownBy(() -> TerrainCosts.run(List.of(wrong), System.out))
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessageContaining("'" + wrong + "'");
        }
        assertThatThrownBy(() -> TerrainLevels.run(List.of("write"), System.out))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("[write]");
    }
}
