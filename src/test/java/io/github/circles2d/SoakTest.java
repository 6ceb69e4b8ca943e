package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.opencl.TestDevices;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A soak takes hours, and is run by hand; that it can be run, and tells what grows, holds always. */
@Tag("each-jdk")
class SoakTest {
    @ParameterizedTest
    @ValueSource(strings = {"world-jvm", "world-cpu", "circles2d"})
    @Tag("long")
    void aRoundAgreesWithItsControl(String name) throws Exception {
        if (!name.equals("world-jvm")) {
            TestDevices.all();
        }
        try (Soak.Soaked soaked = Soak.soaked(name)) {
            soaked.round();
            assertThat(soaked.steps()).isPositive();
            assertThat(soaked.bytes()).isPositive();
        }
    }

    @Test
    void whatGoesUpAndDownDoesNotGrowAndWhatGoesUpDoes() {
        SoakSamples flat = new SoakSamples();
        SoakSamples growing = new SoakSamples();
        for (int k = 0; k < 60; k++) {
            long wave = (k % 5) * 50_000_000L;
            flat.add(wave, 0, wave, 20 + k % 3, 10, wave);
            growing.add(wave, 0, wave + k * 1_000_000L, 20, 10 + k / 5, wave);
        }
        assertThat(flat.growth()).isEmpty();
        assertThat(growing.growth()).hasSize(2);
        assertThat(growing.growth().get(0)).startsWith("RESIDENT has grown from 10000000 to 45000000");
        assertThat(growing.growth().get(1)).startsWith("DESCRIPTORS");
    }
}
