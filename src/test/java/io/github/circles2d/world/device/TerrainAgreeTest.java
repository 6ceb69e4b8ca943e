package io.github.circles2d.world.device;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.TestDevices;
import io.github.circles2d.opencl.TestScale;
import io.github.circles2d.scenes.HardScenes;
import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import io.github.circles2d.world.model.Bounds;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Circles and pieces of terrain have the same bits on every device as in Java. */
class TerrainAgreeTest {
    static Iterable<Device> devices() {
        return TestDevices.all();
    }

    private static TerrainTwins terrain(Scene scene) {
        Bounds bounds = new Bounds(scene.minX(), scene.minY(), scene.maxX(), scene.maxY());
        return new TerrainTwins(bounds, 0.2f * (scene.maxX() - scene.minX()));
    }

    /** Random pieces at rest, in scenes of every sort. */
    @ParameterizedTest
    @MethodSource("devices")
    void piecesAtRestHaveTheSameBits(Device device) {
        compare(device, false, Scenes.thesis(600, 1), Scenes.mixed(600, 1), Scenes.gas(600, 1), Scenes.bouncy(1));
    }

    @ParameterizedTest
    @MethodSource("devices")
    void piecesThatMoveHaveTheSameBits(Device device) {
        compare(device, true, Scenes.thesis(600, 2), HardScenes.blend(500, 10, 1), Scenes.gas(600, 2));
    }

    private static void compare(Device device, boolean moving, Scene... scenes) {
        for (Scene scene : scenes) {
            TerrainTwins terrain = terrain(scene);
            SplittableRandom random = new SplittableRandom(3);
            try (Twins twins = Twins.load(scene, terrain.on(PipelinesAgreeTest.pipelines(device)))) {
                for (int k = 0; k < TestScale.of(8, 30); k++) {
                    terrain.make(k % 4 == 3 ? 3 : 20 + k, moving, random);
                    for (int step = 0; step < 6; step++) {
                        twins.step(k == 5 ? 0.2f : scene.timeStep(), moving ? 1 : 1 + step % 2);
                        twins.assertEqual(scene.name() + " behind change " + k + ", step " + step);
                        if (moving) {
                            terrain.move(random);
                        }
                    }
                }
            }
        }
    }
}
