package io.github.circles2d.playground;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Rectangle;
import org.junit.jupiter.api.Test;

class CameraTest {
    private static final Arena ARENA = new Arena(-10, 0, 30, 20);
    private static final int WIDTH = 800;
    private static final int HEIGHT = 600;

    /** As broad as the arena. */
    private static final Rectangle PART = new Rectangle(8, 44, 500, 250);

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
    void homeInAPartOfThePictureFillsThat() {
        Camera home = Camera.home(ARENA, PART, WIDTH, HEIGHT);
        assertThat(home.screenX(ARENA.minX(), WIDTH)).isCloseTo(PART.x, within(1e-9));
        assertThat(home.screenX(ARENA.maxX(), WIDTH)).isCloseTo(PART.x + PART.width, within(1e-9));
        assertThat(home.screenY(ARENA.maxY(), HEIGHT)).isCloseTo(PART.y, within(1e-9));
        assertThat(home.screenY(ARENA.minY(), HEIGHT)).isCloseTo(PART.y + PART.height, within(1e-9));
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
        Camera home = Camera.home(ARENA, PART, WIDTH, HEIGHT);
        Camera far = home.zoom(1e-6, 0, 0, WIDTH, HEIGHT).pan(1e9, -1e9).clamp(ARENA, PART, WIDTH, HEIGHT);
        assertThat(far.scale()).isGreaterThan(home.scale() / 10);
        double x = far.worldX(PART.getCenterX(), WIDTH);
        double y = far.worldY(PART.getCenterY(), HEIGHT);
        assertThat(x).isBetween(ARENA.minX() - 1e-9, ARENA.maxX() + 1e-9);
        assertThat(y).isBetween(ARENA.minY() - 1e-9, ARENA.maxY() + 1e-9);
        assertThat(home.zoom(1e9, 0, 0, WIDTH, HEIGHT)
                        .clamp(ARENA, PART, WIDTH, HEIGHT)
                        .scale())
                .isLessThan(1000 * home.scale());
        Camera kept = home.clamp(ARENA, PART, WIDTH, HEIGHT);
        assertThat(kept.scale()).isEqualTo(home.scale());
        assertThat(kept.x()).isCloseTo(home.x(), within(1e-9));
        assertThat(kept.y()).isCloseTo(home.y(), within(1e-9));
    }
}
