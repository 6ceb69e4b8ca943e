package io.github.circles2d;

import static io.github.circles2d.TerrainBall.DT;
import static io.github.circles2d.TerrainBall.G;
import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Pendulums, chains, bridges, springs, ropes, motors, soft rings and hubs are as stiff, and swing and turn, as theory says. */
class WorldJointTest {
    static List<FigureRow> rows() {
        return Stream.of(JointRows.all(), JointNets.all()).flatMap(List::stream).toList();
    }

    @ParameterizedTest
    @MethodSource("rows")
    void everyFigureIsAsAsked(FigureRow row) {
        assertThat(row.figures().get()).isNotEmpty().allMatch(RowFigure::holds);
    }

    /** Five elastic balls on rods: only the outer ones swing, and nothing is lost. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 0.01})
    void aCradleGoesOn(double gap) {
        try (World world = TerrainBall.builder(G, 0, 1).build()) {
            long[] balls = new long[5];
            double length = 4;
            for (int k = 0; k < balls.length; k++) {
                double top = k * (1 + gap);
                double lean = k == 0 ? -Math.PI / 4 : 0;
                float x = (float) (top + length * Math.sin(lean));
                balls[k] = world.add(x, (float) (-length * Math.cos(lean)), 0.5f, 1, 0, 0);
                world.joints().add(balls[k], (float) top, 0, Joint.distance((float) length));
            }
            double first = G * (length + world.y(balls[0]));
            double right = 0;
            for (int step = 0; step < 600; step++) {
                world.step((float) DT);
                right = Math.max(right, world.x(balls[4]) - 4 * (1 + gap));
                for (int k = 1; k < 4; k++) {
                    assertThat(world.x(balls[k]))
                            .isBetween((float) (k * (1 + gap) - 0.2), (float) (k * (1 + gap) + 0.2));
                }
            }
            double last = 0;
            for (long ball : balls) {
                double speed = Math.hypot(world.vx(ball), world.vy(ball));
                last += 0.5 * speed * speed + G * (length + world.y(ball));
            }
            assertThat(right).isGreaterThan(0.95 * length * Math.sin(Math.PI / 4));
            assertThat(last).isBetween(0.99 * first, 1.005 * first);
        }
    }
}
