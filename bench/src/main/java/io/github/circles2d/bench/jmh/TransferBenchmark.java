package io.github.circles2d.bench.jmh;

import io.github.circles2d.bench.Devices;
import io.github.circles2d.opencl.DeviceBuffer;
import io.github.circles2d.opencl.HostBuffer;
import io.github.circles2d.opencl.Session;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.FloatBuffer;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;
import org.openjdk.jmh.infra.BenchmarkParams;

/**
 * Ms that a blocking transfer between host and device takes, by size and by what the host's memory is: page-locked; an array
 * of the caller's, by way of page-locked memory, as World reads its circles; or memory that the driver knows nothing of.
 */
@BenchmarkMode(Mode.SingleShotTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@OperationsPerInvocation(20)
@Warmup(iterations = 1)
@Measurement(iterations = 5)
@Fork(value = 1, jvmArgsAppend = "--enable-native-access=ALL-UNNAMED")
public class TransferBenchmark {
    /** Reads from the device. */
    @Benchmark
    public void read(Both both) {
        for (int i = 0; i < both.transfers; i++) {
            both.read();
        }
    }

    /** Writes to the device. */
    @Benchmark
    public void write(Both both) {
        for (int i = 0; i < both.transfers; i++) {
            both.write();
        }
    }

    /** What the memory of the host is. */
    public enum Memory {
        /** Registered with the driver. */
        PINNED,
        /** An array of the caller's, filled from page-locked memory, or emptied into it. */
        STAGED,
        /** Of no special kind. */
        PAGEABLE
    }

    /** Both ends of a transfer. */
    @State(Scope.Thread)
    public static class Both {
        /** {@code best}, {@code cpu}, or a device's name. */
        @Param("best")
        public String device;

        /** The kind of the host's memory. */
        @Param({"PINNED", "STAGED", "PAGEABLE"})
        public Memory memory;

        /** Size. */
        @Param("1048576")
        public int bytes;

        int transfers;
        private Session session;
        private DeviceBuffer buffer;
        private HostBuffer pinned;
        private ByteBuffer pageable;

        /** The host's memory, whatever its kind. */
        private FloatBuffer host;

        /** Allocates both ends. */
        @Setup(Level.Trial)
        public void open(BenchmarkParams params) {
            transfers = params.getOpsPerInvocation();
            session = Session.open(Devices.find(device));
            buffer = session.allocate("transfers", bytes);
            switch (memory) {
                case PINNED:
                    pinned = session.hostBuffer(bytes);
                    host = pinned.floats();
                    break;
                case STAGED:
                    host = FloatBuffer.allocate(bytes / Float.BYTES);
                    break;
                default:
                    pageable = ByteBuffer.allocateDirect(bytes).order(ByteOrder.nativeOrder());
                    host = pageable.asFloatBuffer();
            }
        }

        /** Makes the two ends equal, so that every page is there, and different from what was there before. */
        @Setup(Level.Iteration)
        public void fill() {
            for (int i = 0; i < host.capacity(); i++) {
                host.put(i, host.get(i) + i + 1);
            }
            write();
        }

        void read() {
            switch (memory) {
                case PINNED:
                    buffer.read(0, pinned, 0, bytes);
                    break;
                case STAGED:
                    buffer.read(host);
                    break;
                default:
                    buffer.readPageable(pageable);
            }
        }

        void write() {
            switch (memory) {
                case PINNED:
                    buffer.write(0, pinned, 0, bytes);
                    break;
                case STAGED:
                    buffer.write(host);
                    break;
                default:
                    buffer.writePageable(pageable);
            }
        }

        /** Checks that what comes back is what went there. */
        @TearDown(Level.Iteration)
        public void check() {
            float[] expected = new float[host.capacity()];
            host.duplicate().rewind().get(expected);
            for (int i = 0; i < expected.length; i++) {
                host.put(i, -1);
            }
            read();
            if (!FloatBuffer.wrap(expected).equals(host.duplicate().rewind())) {
                throw new IllegalStateException("what was read is not what was written");
            }
        }

        /** Frees both ends. */
        @TearDown(Level.Trial)
        public void close() {
            session.close();
        }
    }
}
