package io.github.circles2d.bench.engines;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import org.junit.jupiter.api.Test;

class MotionTest {
    private final Scene scene = Scenes.thesis(10, 1);
    private final Motion motion = moved();

    @Test
    void aPlausibleEndIsLetPass() {
        assertThatCode(() -> motion.requirePlausible(scene, 0.01f)).doesNotThrowAnyException();
    }

    @Test
    void aCircleOutsideTheArenaIsNotPlausible() {
        motion.x[3] = 1.02f;
        assertThatThrownBy(() -> motion.requirePlausible(scene, 0.01f))
                .isInstanceOf(IllegalStateException.class)
                .hasMessageContaining("circle 3");
    }

    @Test
    void aPositionOrVelocityThatIsNoNumberIsNotPlausible() {
        motion.y[4] = Float.NaN;
        assertThatThrownBy(() -> motion.requirePlausible(scene, 0.01f)).hasMessageContaining("circle 4");
        motion.y[4] = 0.5f;
        motion.vx[5] = Float.POSITIVE_INFINITY;
        assertThatThrownBy(() -> motion.requirePlausible(scene, 0.01f)).hasMessageContaining("circle 5");
    }

    @Test
    void aCrowdThatHasNotMovedIsNotPlausible() {
        System.arraycopy(scene.y(), 0, motion.y, 0, scene.size());
        assertThatThrownBy(() -> motion.requirePlausible(scene, 0.01f)).hasMessageContaining("moved");
    }

    @Test
    void anyBitOfTheStateChangesTheHash() {
        long before = motion.hash();
        assertThat(moved().hash()).isEqualTo(before);
        motion.vy[9] = Math.nextUp(motion.vy[9]);
        assertThat(motion.hash()).isNotEqualTo(before);
    }

    private Motion moved() {
        Motion moved = new Motion(scene.size());
        for (int i = 0; i < scene.size(); i++) {
            moved.x[i] = scene.x(i);
            moved.y[i] = scene.y(i) - 0.001f;
        }
        return moved;
    }
}
