package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.OnEachDevice;
import java.io.IOException;
import java.util.Map;

class Circles2DProfileTest {

    @OnEachDevice
    void anEngineForProfilingTellsAGrowingTimeForEachKernelOfAStep(Device device) throws IOException {
        try (Circles2D engine = new Circles2D(device, true)) {
            start(engine);
            engine.step();
            Map<String, Long> first = engine.profileNanos();
            assertThat(first)
                    .containsOnlyKeys(
                            "update_position", "detect_collisions_precomputed_pairs", "resolve_collisions_with_pairs");
            engine.loop();
            Map<String, Long> second = engine.profileNanos();
            first.forEach((kernel, nanos) -> assertThat(second.get(kernel)).isGreaterThan(nanos));
        }
    }

    @OnEachDevice
    void otherEnginesHaveNoProfile(Device device) throws IOException {
        Circles2D engine = new Circles2D(device);
        start(engine);
        engine.loop();
        assertThat(engine.profileNanos()).isEmpty();
        engine.close();
        assertThatThrownBy(engine::profileNanos).isInstanceOf(IllegalStateException.class);
    }

    private static void start(Circles2D engine) throws IOException {
        for (int i = 0; i < 50; i++) {
            engine.addCircle(0.01f + 0.019f * i, 0.5f, 0.01f, 1);
        }
        engine.init(1f / 60, PairIndexing.LOOKUP_TABLE, 0.5f, new float[] {0, -0.01f});
    }
}
