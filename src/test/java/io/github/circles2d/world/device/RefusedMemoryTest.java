package io.github.circles2d.world.device;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.DeviceMemoryException;
import io.github.circles2d.opencl.OnEachDevice;
import io.github.circles2d.opencl.Session;
import io.github.circles2d.world.device.plan.Plans;
import io.github.circles2d.world.jvm.JvmPipeline;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.ContactSettings;
import io.github.circles2d.world.model.Features;
import java.lang.reflect.Field;

/** If a device has no memory for a feature that comes later, kernels without it find their arrays where they were. */
class RefusedMemoryTest {
    private static final float DT = 1 / 60f;
    private static final long BYTES_MORE = 100_000;
    private static final int MOST_TRIES = 100;

    @OnEachDevice
    void aWorldGoesOnWithoutFeaturesThatFindTooLittleMemory(Device device) throws ReflectiveOperationException {
        DevicePipeline pipeline = Pipelines.of(device, Plans.COLOURS);
        JvmPipeline jvm = new JvmPipeline(1, JvmPipeline.LEAST_SHARE, 0, false);
        try (Twins twins = Twins.sleeping(new Bounds(0, 0, 20, 20), 4, 10, jvm, pipeline)) {
            for (int k = 0; k < 60; k++) {
                twins.add(1 + 1.1f * (k % 16), 3 + 1.2f * (k / 16), 0.5f, 1, 0, 0, 0);
            }
            twins.step(DT, 60);
            Features wanted = Features.TURNING.and(Features.TERRAIN).and(Features.JOINTS);
            int refused = 0;
            while (isRefused(pipeline, wanted, refused * BYTES_MORE)) {
                refused++;
                assertThat(refused).isLessThan(MOST_TRIES);
                twins.step(DT, 2);
                twins.assertEqual("refused with " + refused * BYTES_MORE + " bytes");
            }
            assertThat(refused).isGreaterThan(3);
            twins.step(DT, 20);
            twins.assertEqual("with the features");
        }
    }

    /** Whether features are refused if so many bytes are free. */
    private static boolean isRefused(DevicePipeline pipeline, Features wanted, long free)
            throws ReflectiveOperationException {
        Session session = (Session) field(DevicePipeline.class, "session").get(pipeline);
        Field allocated = field(Session.class, "allocatedBytes");
        long before = allocated.getLong(session);
        long limited = session.device().memoryBytes() - free;
        allocated.setLong(session, limited);
        try {
            pipeline.prepare(ContactSettings.DEFAULT, wanted);
            return false;
        } catch (DeviceMemoryException e) {
            return true;
        } finally {
            allocated.setLong(session, before + allocated.getLong(session) - limited);
        }
    }

    private static Field field(Class<?> of, String name) throws NoSuchFieldException {
        Field field = of.getDeclaredField(name);
        field.setAccessible(true);
        return field;
    }
}
