package io.github.circles2d;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.TestDevices;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** The states that the scenes on record go through are the same on every device, as {@link GoldenHashesTest} has them for the JVM. */
class WorldHashesOnDevicesTest {
    static List<Arguments> plainScenesAndDevices() throws IOException {
        return scenesAndDevices(true);
    }

    static List<Arguments> otherScenesAndDevices() throws IOException {
        return scenesAndDevices(false);
    }

    private static List<Arguments> scenesAndDevices(boolean plain) throws IOException {
        List<Arguments> runs = new ArrayList<>();
        for (Device device : TestDevices.all()) {
            for (GoldenScene scene : GoldenHashes.scenes()) {
                if (scene.isPlain() == plain) {
                    runs.add(Arguments.of(scene, device));
                }
            }
        }
        return runs;
    }

    @ParameterizedTest
    @MethodSource("plainScenesAndDevices")
    void everyOpenClDeviceGivesTheHashesOfPlainScenes(GoldenScene scene, Device device) throws IOException {
        checkOn(device, scene);
    }

    /** Those with edges, surfaces, terrain and joints, each of which has kernels of its own. Bodies that are pushed have none. */
    @ParameterizedTest
    @MethodSource("otherScenesAndDevices")
    @Tag("long")
    void everyOpenClDeviceGivesTheHashesOfAllOtherScenes(GoldenScene scene, Device device) throws IOException {
        checkOn(device, scene);
    }

    private static void checkOn(Device device, GoldenScene scene) throws IOException {
        GoldenHashesTest.check(scene, scene.builder().device(device).build(), GoldenHashesTest.OF_DEVICES);
    }
}
