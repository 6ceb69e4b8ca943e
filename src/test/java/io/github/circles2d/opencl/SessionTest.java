package io.github.circles2d.opencl;

import static io.github.circles2d.Refusals.assertIllegalArgument;
import static io.github.circles2d.Refusals.assertIllegalState;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowable;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;

@Tag("each-jdk")
class SessionTest {
    private static final KernelSource SCALE = KernelSource.ofText(
            "scale",
            "kernel void scale(global float *data, int count, float factor) {\n"
                    + "    size_t i = get_global_id(0);\n"
                    + "    if (i < (size_t) count) data[i] *= factor;\n"
                    + "}\n");

    @OnEachDevice
    void kernelsComputeOnWhatWasWrittenAndReadsSeeTheResult(Device device) {
        try (Session session = Session.open(device)) {
            int count = 3_000_001; // more than one piece of staging memory, not a multiple of a work-group
            DeviceBuffer data = session.allocate("data", 4L * count);
            float[] values = new float[count];
            for (int i = 0; i < count; i++) {
                values[i] = i;
            }
            data.write(FloatBuffer.wrap(values));
            session.build(SCALE)
                    .kernel("scale")
                    .arg(0, data)
                    .arg(1, count)
                    .arg(2, 0.5f)
                    .run(count);
            float[] result = new float[count];
            data.read(FloatBuffer.wrap(result));
            for (int i = 0; i < count; i++) {
                assertThat(result[i]).isEqualTo(i * 0.5f);
            }
        }
    }

    @OnEachDevice
    void aKernelRunsInWorkGroupsOfTheSizeThatItRequires(Device device) {
        KernelSource source = KernelSource.ofText(
                "sizes",
                "kernel __attribute__((reqd_work_group_size(SIZE, 1, 1))) void required(global int *size) {\n"
                        + "    size[0] = (int) get_local_size(0);\n"
                        + "}\n");
        int size = Math.min(512, device.maxWorkGroupSize());
        try (Session session = Session.open(device)) {
            DeviceBuffer data = session.allocate("data", 4);
            Kernel kernel = session.build(source.define("SIZE", size)).kernel("required");
            assertThat(kernel.maxWorkGroupSize()).isEqualTo(size);
            kernel.arg(0, data).run(1, size);
            int[] result = new int[1];
            data.read(0, IntBuffer.wrap(result));
            assertThat(result[0]).isEqualTo(size);
        }
    }

    @OnEachDevice
    void anArgumentWithoutABufferIsNull(Device device) {
        KernelSource source = KernelSource.ofText(
                "null", "kernel void tell(global int *data, global int *other) { data[0] = other == 0 ? 1 : 2; }\n");
        try (Session session = Session.open(device)) {
            DeviceBuffer data = session.allocate("data", 4);
            Kernel kernel = session.build(source).kernel("tell").arg(0, data);
            int[] result = new int[1];
            kernel.withoutBuffer(1).run(1, 1);
            data.read(0, IntBuffer.wrap(result));
            assertThat(result[0]).isEqualTo(1);
            kernel.arg(1, data).run(1, 1);
            data.read(0, IntBuffer.wrap(result));
            assertThat(result[0]).isEqualTo(2);
        }
    }

    @OnEachDevice
    void intsGoThereAndBackAtAnOffsetFromHeapAndDirectBuffers(Device device) {
        try (Session session = Session.open(device)) {
            DeviceBuffer data = session.allocate("data", 32);
            data.write(0, IntBuffer.wrap(new int[] {1, 2, 3, 4}));
            IntBuffer direct =
                    ByteBuffer.allocateDirect(16).order(ByteOrder.nativeOrder()).asIntBuffer();
            direct.put(new int[] {5, 6, 7, 8}).flip();
            data.write(16, direct);
            int[] result = new int[8];
            data.read(IntBuffer.wrap(result));
            assertThat(result).containsExactly(1, 2, 3, 4, 5, 6, 7, 8);
        }
    }

    @OnEachDevice
    void aCopyBesideTheKernelsSeesWhatWasEnqueuedBeforeAndLeavesTheRestAsItIs(Device device) {
        try (Session session = Session.open(device);
                HostBuffer host = session.hostBuffer(64)) {
            DeviceBuffer data = session.allocate("data", 64);
            DeviceBuffer other = session.allocate("other", 4);
            other.write(FloatBuffer.wrap(new float[] {1}));
            Kernel scale = session.build(SCALE).kernel("scale").arg(1, 16).arg(2, 2f);
            CopyQueue copies = session.copyQueue();
            for (int round = 0; round < 50; round++) {
                for (int i = 0; i < 16; i++) {
                    host.floats().put(i, i + round);
                }
                data.write(0, host, 0, 64);
                scale.arg(0, data).run(16);
                copies.read(data, host, 32);
                scale.arg(0, other).run(1);
                copies.finish();
                assertThat(host.floats().get(7)).isEqualTo(2f * (7 + round));
                assertThat(host.floats().get(8)).isEqualTo(8f + round);
            }
        }
    }

    @OnEachDevice
    void aCopyBesideTheKernelsIsCheckedAndClosedWithTheSession(Device device) {
        Session session = Session.open(device);
        CopyQueue copies = session.copyQueue();
        DeviceBuffer data = session.allocate("data", 1 << 20);
        HostBuffer host = session.hostBuffer(1 << 20);
        try (Session another = Session.open(device)) {
            assertThatThrownBy(() -> copies.read(another.allocate("foreign", 16), host, 16))
                    .isInstanceOf(IllegalArgumentException.class);
            assertThatThrownBy(() -> copies.read(data, another.hostBuffer(16), 16))
                    .isInstanceOf(IllegalArgumentException.class);
        }
        assertThatThrownBy(() -> copies.read(data, host, (1 << 20) + 1)).isInstanceOf(IndexOutOfBoundsException.class);
        copies.read(data, host, 1 << 20);
        session.close();
        assertThatThrownBy(() -> copies.read(data, host, 16)).isInstanceOf(IllegalStateException.class);
        assertThatThrownBy(copies::finish).isInstanceOf(IllegalStateException.class);
    }

    @OnEachDevice
    void memoryThatTheDriverDoesNotKnowIsReadAndWrittenFromItsPositionOn(Device device) {
        try (Session session = Session.open(device)) {
            DeviceBuffer buffer = session.allocate("b", 64);
            ByteBuffer source = ByteBuffer.allocateDirect(80).order(ByteOrder.nativeOrder());
            for (int i = 0; i < 80; i++) {
                source.put(i, (byte) i);
            }
            buffer.writePageable(source.position(16));
            assertThat(source.position()).isEqualTo(16);
            ByteBuffer target = ByteBuffer.allocateDirect(40);
            buffer.readPageable(target.position(8));
            assertThat(target.position()).isEqualTo(8);
            for (int i = 0; i < 40; i++) {
                assertThat(target.get(i)).isEqualTo((byte) (i < 8 ? 0 : i + 8));
            }
            buffer.readPageable(target.position(40));
        }
    }

    @OnEachDevice
    void memoryThatTheDriverDoesNotKnowMustBeDirectAndFit(Device device) {
        try (Session session = Session.open(device)) {
            DeviceBuffer buffer = session.allocate("b", 64);
            assertIllegalArgument("direct", () -> buffer.readPageable(ByteBuffer.allocate(8)));
            assertThatThrownBy(() -> buffer.writePageable(ByteBuffer.allocateDirect(65)))
                    .isInstanceOf(IndexOutOfBoundsException.class)
                    .hasMessageContaining("65")
                    .hasMessageContaining("64");
            assertIllegalArgument(
                    "read-only",
                    () -> buffer.readPageable(ByteBuffer.allocateDirect(8).asReadOnlyBuffer()));
            buffer.close();
            assertThatThrownBy(() -> buffer.readPageable(ByteBuffer.allocateDirect(8)))
                    .isInstanceOf(IllegalStateException.class);
        }
    }

    @OnEachDevice
    void copiesBetweenBuffersAreCheckedAndExact(Device device) {
        try (Session session = Session.open(device)) {
            DeviceBuffer source = session.allocate("source", 16);
            DeviceBuffer target = session.allocate("target", 12);
            source.write(0, IntBuffer.wrap(new int[] {1, 2, 3, 4}));
            target.write(0, IntBuffer.wrap(new int[] {7, 7, 7}));
            source.copyTo(target, 8);
            int[] result = new int[3];
            target.read(IntBuffer.wrap(result));
            assertThat(result).containsExactly(1, 2, 7);
            source.copyTo(8, target, 4, 8);
            int[] last = new int[2];
            target.read(4, IntBuffer.wrap(last));
            assertThat(last).containsExactly(3, 4);
            assertThatThrownBy(() -> source.copyTo(target, 16)).isInstanceOf(IndexOutOfBoundsException.class);
            assertThatThrownBy(() -> source.copyTo(8, target, 8, 8)).isInstanceOf(IndexOutOfBoundsException.class);
            assertThatThrownBy(() -> source.copyTo(12, target, 0, 8)).isInstanceOf(IndexOutOfBoundsException.class);
            try (Session other = Session.open(device)) {
                DeviceBuffer foreign = other.allocate("foreign", 16);
                assertThatThrownBy(() -> source.copyTo(foreign, 8)).isInstanceOf(IllegalArgumentException.class);
            }
        }
    }

    @OnEachDevice
    void transfersOutsideEitherSideAreRefused(Device device) {
        try (Session session = Session.open(device)) {
            DeviceBuffer data = session.allocate("data", 16);
            HostBuffer host = session.hostBuffer(8);
            assertThatThrownBy(() -> data.read(FloatBuffer.allocate(5))).isInstanceOf(IndexOutOfBoundsException.class);
            assertThatThrownBy(() -> data.write(4, IntBuffer.allocate(4)))
                    .isInstanceOf(IndexOutOfBoundsException.class);
            assertThatThrownBy(() -> data.read(0, host, 0, 9)).isInstanceOf(IndexOutOfBoundsException.class);
            assertThatThrownBy(() -> data.read(0, host, 4, 8)).isInstanceOf(IndexOutOfBoundsException.class);
            assertThatThrownBy(() -> data.write(12, host, 0, 8)).isInstanceOf(IndexOutOfBoundsException.class);
            assertThatThrownBy(() -> data.write(-4, host, 0, 4)).isInstanceOf(IndexOutOfBoundsException.class);
            assertThatThrownBy(() -> data.write(Long.MAX_VALUE, host, 0, 4))
                    .isInstanceOf(IndexOutOfBoundsException.class);
        }
    }

    @OnEachDevice
    void requestsBeyondTheDevicesMemoryAreRefusedBeforeAllocation(Device device) {
        try (Session session = Session.open(device)) {
            assertThatThrownBy(() -> session.allocate("huge", device.memoryBytes() + 1))
                    .isInstanceOf(DeviceMemoryException.class)
                    .hasMessageContaining("huge")
                    .hasMessageContaining(String.valueOf(device.memoryBytes() + 1));
            assertThatThrownBy(() -> session.requireRoom("a pair table", 10, device.maxBufferBytes() + 1))
                    .isInstanceOf(DeviceMemoryException.class)
                    .hasMessageContaining("a pair table");
            assertThat(session.allocatedBytes()).isZero();
        }
    }

    @OnEachDevice
    void theByteBudgetFollowsAllocationAndClosing(Device device) {
        try (Session session = Session.open(device)) {
            DeviceBuffer first = session.allocate("first", 1000);
            DeviceBuffer empty = session.allocate("empty", 0);
            assertThat(session.allocatedBytes()).isEqualTo(1000);
            first.close();
            first.close();
            empty.close();
            assertThat(session.allocatedBytes()).isZero();
            assertIllegalState("first", () -> first.read(FloatBuffer.allocate(1)));
        }
    }

    @OnEachDevice
    void closingTwiceIsFineAndUseAfterwardsIsRefused(Device device) {
        Session session = Session.open(device);
        DeviceBuffer data = session.allocate("data", 16);
        Kernel kernel = session.build(SCALE).kernel("scale");
        session.close();
        session.close();
        kernel.close();
        data.close();
        assertThatThrownBy(session::finish).isInstanceOf(IllegalStateException.class);
        assertThatThrownBy(() -> session.allocate("more", 4)).isInstanceOf(IllegalStateException.class);
        assertThatThrownBy(() -> kernel.run(1)).isInstanceOf(IllegalStateException.class);
    }

    @OnEachDevice
    void aFailedBuildNamesFileAndLine(Device device) {
        try (Session session = Session.open(device)) {
            KernelSource broken =
                    KernelSource.ofText("broken", "kernel void k(global int *a) {\n  a[0] = nonsense;\n}\n");
            assertThatThrownBy(() -> session.build(broken))
                    .isInstanceOf(KernelBuildException.class)
                    .hasMessageContaining("broken")
                    .hasMessageContaining(device.name())
                    .hasMessageContaining("nonsense");
            assertThatThrownBy(() -> session.build(SCALE).kernel("absent"))
                    .isInstanceOf(OpenClException.class)
                    .hasMessageContaining("absent");
        }
    }

    @OnEachDevice
    void whoeverWatchesIsToldOfACommandThatFailsAndNotOfABuild(Device device) {
        List<Throwable> told = new ArrayList<>();
        try (Session session = Session.open(device)) {
            session.watch(told::add);
            assertThatThrownBy(() -> session.build(KernelSource.ofText("broken", "kernel void k() { nonsense }")))
                    .isInstanceOf(KernelBuildException.class);
            assertThat(told).isEmpty();
            Kernel withoutArguments = session.build(SCALE).kernel("scale");
            Throwable thrown = catchThrowable(() -> withoutArguments.run(1));
            assertThat(thrown).isInstanceOf(OpenClException.class);
            assertThat(told).containsExactly(thrown);
        }
    }

    @OnEachDevice
    void definedFloatsKeepEveryBit(Device device) {
        KernelSource source = KernelSource.ofText(
                        "constant", "kernel void constant_bits(global float *out) { out[0] = VALUE; }")
                .define("VALUE", 0.1f);
        try (Session session = Session.open(device)) {
            DeviceBuffer out = session.allocate("out", 4);
            session.build(source).kernel("constant_bits").arg(0, out).run(1);
            float[] result = new float[1];
            out.read(FloatBuffer.wrap(result));
            assertThat(result[0]).isEqualTo(0.1f);
        }
    }

    @OnEachDevice
    void aProfilingSessionKnowsTheTimeOfEachKernel(Device device) {
        try (Session session = Session.open(device, true)) {
            int count = 1 << 20; // so many that a coarse clock shows some time
            DeviceBuffer data = session.allocate("data", 4L * count);
            Kernel kernel = session.build(SCALE)
                    .kernel("scale")
                    .arg(0, data)
                    .arg(1, count)
                    .arg(2, 1f);
            kernel.run(count);
            kernel.run(count);
            assertThat(session.profileNanos()).containsOnlyKeys("scale");
            assertThat(session.profileNanos().get("scale")).isPositive();
        }
    }

    @OnEachDevice
    void integerDivisionByZeroStillThrowsInJavaOnceTheDriverIsLoaded(Device device) {
        try (Session session = Session.open(device)) {
            session.finish();
            int zero = session.allocatedBytes() == 0 ? 0 : 1;
            for (int i = 0; i < 20_000; i++) { // often enough to be compiled, which is where the signal is used
                int dividend = i;
                assertThatThrownBy(() -> divide(dividend, zero)).isInstanceOf(ArithmeticException.class);
            }
        }
    }

    /**
     * An OpenCL object keeps those that it was made from, so one that were left, an event above all, would keep the context and
     * all that the driver holds for it: 50 MB of the process on an NVIDIA H200.
     */
    @OnEachDevice
    void aClosedSessionLeavesNothingToTheGarbageCollector(Device device) throws Exception {
        for (boolean profiling : new boolean[] {false, true}) {
            Session session = Session.open(device, profiling);
            try (ContextReference context = new ContextReference(session)) {
                DeviceBuffer data = session.allocate("data", 4096);
                HostBuffer host = session.hostBuffer(4096);
                Program program = session.build(SCALE);
                Kernel kernel =
                        program.kernel("scale").arg(0, data).arg(1, 1024).arg(2, 1f);
                data.write(0, host, 0, 4096);
                kernel.run(1024);
                session.profileNanos();
                kernel.run(1024);
                data.copyTo(session.allocate("copy", 4096), 4096);
                data.read(0, host, 0, 4096);
                data.read(FloatBuffer.allocate(1024));
                session.copyQueue().read(data, host, 4096);
                assertThat(context.count()).isGreaterThan(1);
                session.close();
                assertThat(context.countAfterAMoment())
                        .as("profiling " + profiling)
                        .isEqualTo(1);
            }
        }
    }

    private static int divide(int a, int b) {
        return a / b;
    }

    @OnEachDevice
    void abandonedSessionsAreClosedWithTheirBuffers(Device device) throws InterruptedException {
        // Opening a session takes a GPU's driver half a second.
        int sessions = device.kind() == Device.Kind.CPU ? 200 : 20;
        for (int i = 0; i < sessions; i++) {
            Session session = Session.open(device);
            session.allocate("abandoned", 1 << 20);
            session.copyQueue().read(session.allocate("copied", 1 << 16), session.hostBuffer(1 << 16), 1 << 16);
            if (i % 10 == 9) {
                System.gc();
                Thread.sleep(20);
            }
        }
        try (Session session = Session.open(device)) {
            assertThat(session.freeBytes()).isEqualTo(device.memoryBytes());
        }
    }
}
