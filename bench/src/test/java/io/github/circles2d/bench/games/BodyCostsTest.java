package io.github.circles2d.bench.games;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.circles2d.Backend;
import io.github.circles2d.World;
import java.util.List;
import org.junit.jupiter.api.Test;

class BodyCostsTest {
    @Test
    void linesHaveTheColumnsOfTheHeader() {
        for (String scene : BodyCosts.CASES) {
            String line = BodyCosts.measure(scene, 2, 3);
            assertThat(line).startsWith(scene + ",");
            assertThat(line.split(",")).hasSameSizeAs(BodyCosts.HEADER.split(","));
        }
    }

    @Test
    void linesOfADeviceHaveTheColumnsOfTheirHeader() {
        String line = BodyCosts.beside("circles", Backend.JVM, 2, 3);
        assertThat(line).startsWith("circles,0,10000,");
        assertThat(line.split(",")).hasSameSizeAs(BodyCosts.HEADER_OF_DEVICES.split(","));
    }

    @Test
    void sleepersAreCirclesWithCratesInAWorldThatSleeps() {
        for (String scene : List.of("crates asleep", "a crate falls on sleepers")) {
            try (World world = BodyCosts.world(scene)) {
                assertThat(world.bodies().size()).isEqualTo(10);
                assertThat(world.sleeps()).isTrue();
            }
        }
    }

    @Test
    void aPyramidHasTwentyRowsAndStands() {
        try (World world = BodyCosts.world("pyramid")) {
            assertThat(world.bodies().size()).isEqualTo(210);
            world.step(1 / 60f, 120);
            assertThat(world.bodies().y(world.bodies().handle(209))).isBetween(19.4f, 19.6f);
        }
    }

    @Test
    void cratesStayAmongCircles() {
        try (World crates = BodyCosts.world("crates");
                World circles = BodyCosts.world("circles")) {
            assertThat(crates.bodies().size()).isEqualTo(10);
            assertThat(circles.bodies().size()).isZero();
            assertThat(circles.size()).isEqualTo(10_000);
            assertThat(crates.size()).isBetween(9_800, 9_990);
            crates.step(1 / 60f, 30);
            for (int k = 0; k < 10; k++) {
                assertThat(crates.bodies().y(crates.bodies().handle(k))).isBetween(8f, 12.5f);
            }
        }
    }

    @Test
    void anUnknownSceneIsNamed() {
        assertThatThrownBy(() -> BodyCosts.run(List.of("tower"), System.out))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("'tower'");
    }
}
