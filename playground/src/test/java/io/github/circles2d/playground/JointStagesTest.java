package io.github.circles2d.playground;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.Backend;
import io.github.circles2d.World;
import org.junit.jupiter.api.Test;

/** What the stages with joints do. */
class JointStagesTest {
    private static Sandbox after(String stage, int steps) {
        Sandbox sandbox = new Sandbox(Stages.named(stage), Backend.JVM);
        for (int k = 0; k < steps; k++) {
            sandbox.stepOnce(() -> {});
        }
        return sandbox;
    }

    private static float[] circles(World world) {
        float[] circles = new float[4 * world.idLimit()];
        world.readById(circles, null);
        return circles;
    }

    @Test
    void theBridgeCarriesWhatRollsOntoIt() {
        try (Sandbox sandbox = after("bridge", 300)) {
            World world = sandbox.world();
            assertThat(world.joints().size()).isEqualTo(41);
            float[] circles = circles(world);
            for (int plank = 0; plank < 40; plank++) {
                assertThat(circles[4 * plank + 1]).isBetween(15f, 70f);
                if (plank > 0) {
                    double dx = circles[4 * plank] - circles[4 * plank - 4];
                    double dy = circles[4 * plank + 1] - circles[4 * plank - 3];
                    assertThat(Math.hypot(dx, dy)).isBetween(2.1, 2.9);
                }
            }
        }
    }

    @Test
    void blobsStayRound() {
        try (Sandbox sandbox = after("blobs", 300)) {
            float[] circles = circles(sandbox.world());
            assertThat(circles).hasSize(4 * 14 * 24);
            for (int blob = 0; blob < 14; blob++) {
                double area = 0;
                for (int k = 0; k < 24; k++) {
                    int at = 4 * (24 * blob + k);
                    int next = 4 * (24 * blob + (k + 1) % 24);
                    area += 0.5 * ((double) circles[at] * circles[next + 1] - (double) circles[next] * circles[at + 1]);
                }
                assertThat(area).isGreaterThan(0.6 * Math.PI * 5.5 * 5.5);
            }
        }
    }

    @Test
    void theClothHangsUntilItIsTorn() {
        try (Sandbox sandbox = after("cloth", 200)) {
            World world = sandbox.world();
            int whole = world.joints().size();
            assertThat(whole).as("no thread breaks by itself").isEqualTo(35 * 20 + 36 * 19 + 2 * 35 * 19 + 8);
            GrabTool grab = new GrabTool();
            float[] circles = circles(world);
            int low = 4 * 18; // in the lowest row
            grab.press(sandbox, circles[low], circles[low + 1], 1);
            grab.drag(sandbox, 80, -200);
            for (int k = 0; k < 120; k++) {
                sandbox.stepOnce(() -> grab.beforeStep(sandbox));
            }
            assertThat(world.joints().size()).as("torn").isLessThan(whole);
        }
    }

    @Test
    void theWreckingBallBreaksTheWall() {
        try (Sandbox sandbox = after("wrecking-ball", 240)) {
            float[] circles = circles(sandbox.world());
            float farthest = 0;
            for (int k = 19; k < circles.length / 4; k++) {
                farthest = Math.max(farthest, circles[4 * k]);
            }
            assertThat(farthest).isGreaterThan(145);
            assertThat(Math.hypot(circles[0] - 68, circles[1] - 90))
                    .as("the chain holds")
                    .isLessThan(52.5);
        }
    }
}
