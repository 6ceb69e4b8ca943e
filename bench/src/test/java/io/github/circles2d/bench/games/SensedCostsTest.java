package io.github.circles2d.bench.games;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.Backend;
import io.github.circles2d.Events;
import io.github.circles2d.World;
import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;

class SensedCostsTest {
    private static final int N = 300;

    @Test
    void linesHaveTheColumnsOfTheHeader() {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        PrintStream out = new PrintStream(bytes, true, StandardCharsets.UTF_8);
        for (String name : SensedCosts.CASES) {
            bytes.reset();
            SensedCosts.compare(name, Backend.JVM, N, 0, 1, out);
            String line = bytes.toString(StandardCharsets.UTF_8).replaceAll("\"[^\"]*\"", "machine");
            assertThat(line).startsWith("machine," + name + "," + N + ",");
            assertThat(line.strip().split(",", -1)).hasSameSizeAs(SensedCosts.HEADER.split(","));
        }
    }

    @Test
    void somethingIsReportedInEachCase() {
        for (String name : SensedCosts.CASES) {
            try (World world = SensedCosts.world(name, Backend.JVM, N)) {
                world.report(1, name.equals("sensors") ? 1 : 0, Events.BEGIN | Events.END);
                world.step(1 / 60f, 60);
                assertThat(world.events().size()).as(name).isPositive();
            }
        }
    }

    @Test
    void sensorsPushNobody() {
        try (World world = SensedCosts.world("sensors", Backend.JVM, N)) {
            world.step(1 / 60f, 30);
            assertThat(world.stats().contacts()).isZero();
        }
    }
}
