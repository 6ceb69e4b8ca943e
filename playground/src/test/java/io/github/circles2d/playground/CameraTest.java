package io.github.circles2d.playground;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class CameraTest {
    private static final Arena ARENA = new Arena(-10, 0, 30, 20);
    private static final int WIDTH = 800;
    private static final int HEIGHT = 600;

    @Test
    void homeShowsAllOfTheArenaInTheMiddle() {
        Camera home = Camera.home(ARENA, WIDTH, HEIGHT);
        assertThat(home.screenX(ARENA.minX(), WIDTH)).isBetween(0.0, 60.0);
        assertThat(home.screenX(ARENA.maxX(), WIDTH)).isBetween(WIDTH - 60.0, (double) WIDTH);
        assertThat(home.screenY(ARENA.maxY(), HEIGHT)).isGreaterThan(0);
        assertThat(home.screenY(ARENA.minY(), HEIGHT)).isLessThan(HEIGHT);
        assertThat(home.screenX(10, WIDTH)).isEqualTo(WIDTH / 2.0);
        assertThat(home.screenY(10, HEIGHT)).isEqualTo(HEIGHT / 2.0);
    }

    @Test
    void placesOfTheWorldAndOfThePictureBelongTogether() {
        Camera camera = new Camera(3, 4, 17);
        assertThat(camera.worldX(camera.screenX(7.5, WIDTH), WIDTH)).isCloseTo(7.5, within(1e-9));
        assertThat(camera.worldY(camera.screenY(-2.5, HEIGHT), HEIGHT)).isCloseTo(-2.5, within(1e-9));
        assertThat(camera.screenY(5, HEIGHT)).as("y points up").isLessThan(camera.screenY(4, HEIGHT));
    }

    @Test
    void aZoomLeavesThePointUnderTheMouseWhereItIs() {
        Camera camera = new Camera(3, 4, 17);
        Camera closer = camera.zoom(2.5, 100, 450, WIDTH, HEIGHT);
        assertThat(closer.scale()).isEqualTo(42.5);
        assertThat(closer.worldX(100, WIDTH)).isCloseTo(camera.worldX(100, WIDTH), within(1e-9));
        assertThat(closer.worldY(450, HEIGHT)).isCloseTo(camera.worldY(450, HEIGHT), within(1e-9));
    }

    @Test
    void aDragTakesThePictureAlong() {
        Camera camera = new Camera(3, 4, 10);
        Camera moved = camera.pan(50, 20);
        assertThat(moved.screenX(3, WIDTH)).isEqualTo(camera.screenX(3, WIDTH) + 50);
        assertThat(moved.screenY(4, HEIGHT)).isEqualTo(camera.screenY(4, HEIGHT) + 20);
    }

    @Test
    void theArenaStaysInSightHoweverFarAPersonZoomsOrDrags() {
        Camera home = Camera.home(ARENA, WIDTH, HEIGHT);
        Camera far = home.zoom(1e-6, 0, 0, WIDTH, HEIGHT).pan(1e9, -1e9).clamp(ARENA, WIDTH, HEIGHT);
        assertThat(far.scale()).isGreaterThan(home.scale() / 10);
        assertThat(ARENA.contains((float) far.x(), (float) far.y())).isTrue();
        assertThat(home.zoom(1e9, 0, 0, WIDTH, HEIGHT)
                        .clamp(ARENA, WIDTH, HEIGHT)
                        .scale())
                .isLessThan(1000 * home.scale());
    }
}
