package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;

import org.assertj.core.data.Offset;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class WorldJointsApiTest {
    private static final float STEP = 1 / 60f;

    private final World world = World.builder()
            .bounds(-100, -100, 100, 100)
            .gravity(0, -10)
            .backend(Backend.JVM)
            .build();
    private final Joints joints = world.joints();

    @AfterEach
    void close() {
        world.close();
    }

    private void steps(int n) {
        for (int k = 0; k < n; k++) {
            world.step(STEP);
        }
    }

    private float distance(long a, long b) {
        return (float) Math.hypot(world.x(a) - world.x(b), world.y(a) - world.y(b));
    }

    @Test
    void aRopeOfManyLinksHangs() {
        long[] circles = new long[100];
        for (int k = 0; k < circles.length; k++) {
            circles[k] = world.add(-50 + k, 0, 0.4f, 1);
        }
        joints.add(circles[0], -51, 0, Joint.distance());
        for (int k = 1; k < circles.length; k++) {
            joints.add(circles[k - 1], circles[k], Joint.distance());
        }
        steps(600);
        for (int k = 1; k < circles.length; k++) {
            assertThat(distance(circles[k - 1], circles[k])).isCloseTo(1, Offset.offset(0.1f));
        }
    }

    @Test
    void aHubHasManySpokes() {
        long hub = world.add(0, 0, 0.4f, 100);
        joints.add(hub, 0, 0, Joint.pin());
        long[] rim = new long[60];
        for (int k = 0; k < rim.length; k++) {
            rim[k] = world.add(10 * (float) Math.cos(k * 0.1), 10 * (float) Math.sin(k * 0.1), 0.1f, 1);
            joints.add(hub, rim[k], Joint.distance(10));
        }
        steps(300);
        for (long each : rim) {
            assertThat(distance(hub, each)).isCloseTo(10, Offset.offset(0.5f));
        }
    }

    @Test
    void aPinFollowsItsBody() {
        TerrainBody arm = world.terrain().addBody(0, 0, 0);
        long ball = world.add(3, 0, 0.4f, 1);
        joints.add(ball, arm, 3, 0, Joint.pin());
        arm.setAngularVelocity(1);
        steps(60);
        assertThat(world.x(ball)).isCloseTo(3 * (float) Math.cos(1), Offset.offset(0.02f));
        assertThat(world.y(ball)).isCloseTo(3 * (float) Math.sin(1), Offset.offset(0.02f));
    }

    @Test
    void aMotorTurns() {
        long wheel = world.add(3, 0, 0.4f, 1);
        joints.add(wheel, Joint.motor(5, 100));
        steps(60);
        assertThat(world.angularVelocity(wheel)).isCloseTo(5, Offset.offset(1e-3f));
    }
}
