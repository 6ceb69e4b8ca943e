package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** A marble run in the lines that a new user would write: no marble jams, leaves a slope too early or falls through one. */
class MarbleRunTest {
    private static final int SLOPES = 20;
    private static final int MARBLES = 20;

    @Test
    void allMarblesRollDownTwentySlopesIntoTheBowl() {
        try (World world = World.builder()
                .bounds(0, -10, 20, 90)
                .gravity(0, -40)
                .friction(0.4f)
                .build()) {
            Terrain terrain = world.terrain();
            for (int k = 0; k < SLOPES; k++) { // to the left, then to the right, and so on
                float y = 82 - 4 * k;
                terrain.addSegment(k % 2 == 0 ? 20 : 0, y, k % 2 == 0 ? 2 : 18, y - 2, 0.1f, 0);
            }
            terrain.addArc(10, 0, 10, (float) Math.PI, 2 * (float) Math.PI, ArcSide.INNER); // the bowl
            int steps = 0;
            while (inTheBowl(world) < MARBLES && steps < 60 * 120) {
                if (steps % 20 == 0 && world.size() < MARBLES) {
                    world.add(15, 86, 0.3f, 1);
                }
                world.step(1 / 60f);
                steps++;
            }
            assertThat(inTheBowl(world)).isEqualTo(MARBLES);
            assertThat(steps).as("not by falling").isGreaterThan(60 * 45);
        }
    }

    private static int inTheBowl(World world) {
        return world.queries().overlapBox(0, -10, 20, -4, new long[0]);
    }
}
