package io.github.circles2d.world.jvm;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.world.model.AxisEdge;
import io.github.circles2d.world.model.Bounds;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Steps visit what moves and what is near to it; counted, not timed. */
class RestingTest {
    private static final int SIDE = 317;
    private static final int MOVING = 100;

    /** Circles and cells that a step looks at for each that moves: its own, the least that tori have, and those around. */
    private static final int LOOKS = 24;

    @ParameterizedTest
    @CsvSource({"WALL, 1, 1", "OPEN, 1, 1", "WRAP, 1, 1", "WALL, 20, 1", "WALL, 1, 20", "WALL, 200, 0.25"})
    void aStepOfAHundredAmongAHundredThousandThatRestVisitsWhatIsNearToThem(
            AxisEdge edge, float speed, float radiusOfStatic) {
        SplittableRandom random = new SplittableRandom(1);
        float spacing = 4 * Math.max(radiusOfStatic, 1);
        float size = spacing * SIDE;
        try (JvmWorld world = new JvmWorld(new Bounds(0, 0, size, size, edge, edge), 2)) {
            for (int k = 0; k < SIDE * SIDE; k++) {
                float x = spacing * (k % SIDE) + 0.5f * spacing;
                float y = spacing * (k / SIDE) + 0.5f * spacing;
                world.simulation.newCircles.add(x, y, radiusOfStatic, Float.POSITIVE_INFINITY, 0, 0, 0);
            }
            for (int k = 0; k < MOVING; k++) {
                float x = spacing * (1 + random.nextInt(SIDE - 2));
                float y = spacing * (1 + random.nextInt(SIDE - 2));
                world.simulation.newCircles.add(x, y, 0.5f, 1, speed, 0.5f * speed, 0);
            }
            for (int k = 0; k < 20; k++) {
                world.step(1);
                assertThat(world.pipeline.state.awake).isEqualTo(MOVING);
                assertThat(world.pipeline.levels.buckets).isLessThan(LOOKS * MOVING);
                assertThat(world.pipeline.candidatePairs()).isLessThan(LOOKS * MOVING);
            }
            assertThat(world.pipeline.state.n).isEqualTo(SIDE * SIDE + MOVING);
        }
    }
}
