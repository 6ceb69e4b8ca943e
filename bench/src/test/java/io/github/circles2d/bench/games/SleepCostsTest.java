package io.github.circles2d.bench.games;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.Backend;
import io.github.circles2d.World;
import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;

class SleepCostsTest {
    private static final int N = 300;

    private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    private final PrintStream out = new PrintStream(bytes, true, StandardCharsets.UTF_8);

    @Test
    void linesHaveTheColumnsOfTheHeader() {
        for (String scene : SleepCosts.CASES) {
            bytes.reset();
            SleepCosts.compare(scene, Backend.JVM, N, 100, 0, 1, out);
            String line = bytes.toString(StandardCharsets.UTF_8).replaceAll("\"[^\"]*\"", "machine");
            assertThat(line).startsWith("machine," + scene + "," + N + ",");
            assertThat(line.strip().split(",", -1)).hasSameSizeAs(SleepCosts.HEADER.split(","));
        }
    }

    @Test
    void aPileComesToRestAndACrowdDoesNot() {
        try (World pile = SleepCosts.world("pile", Backend.JVM, N, true);
                World other = SleepCosts.world("pile", Backend.JVM, N, false);
                World moving = SleepCosts.world("moving", Backend.JVM, N, true)) {
            pile.step(1 / 60f, 600);
            other.step(1 / 60f, 600);
            moving.step(1 / 60f, 120);
            assertThat(pile.stats().awake()).isLessThan(N / 10);
            assertThat(other.stats().awake()).isEqualTo(N);
            assertThat(moving.stats().awake()).isEqualTo(N);
        }
    }

    @Test
    void aLevelHasStaticCirclesThatTheOtherWorldLacks() {
        try (World level = SleepCosts.world("level", Backend.JVM, N, true);
                World alone = SleepCosts.world("level", Backend.JVM, N, false)) {
            assertThat(level.size()).isEqualTo(N + alone.size());
            assertThat(alone.size()).isEqualTo(100);
        }
    }
}
