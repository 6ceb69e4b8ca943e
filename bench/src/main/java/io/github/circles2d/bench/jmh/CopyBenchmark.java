package io.github.circles2d.bench.jmh;

import io.github.circles2d.bench.Devices;
import io.github.circles2d.opencl.DeviceBuffer;
import io.github.circles2d.opencl.HostBuffer;
import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.opencl.KernelSource;
import io.github.circles2d.opencl.Program;
import io.github.circles2d.opencl.Session;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
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

/** Ms that a device takes to copy a buffer: the roof over every kernel that is bound by memory. */
@State(Scope.Thread)
@BenchmarkMode(Mode.SingleShotTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@OperationsPerInvocation(20)
@Warmup(iterations = 1)
@Measurement(iterations = 5)
@Fork(value = 1, jvmArgsAppend = "--enable-native-access=ALL-UNNAMED")
public class CopyBenchmark {
    private static final int ELEMENT_BYTES = 16;

    private static final long PIECE_BYTES = 4 << 20;

    /** {@code best}, {@code cpu}, or a device's name. */
    @Param("best")
    public String device;

    /** Size of the source, and of the target. */
    @Param("1048576")
    public long bytes;

    private Session session;
    private Program program;
    private Kernel copy;
    private HostBuffer pattern;
    private DeviceBuffer source;
    private DeviceBuffer target;
    private int copies;

    /** Allocates and fills both buffers, so that every page is there. */
    @Setup(Level.Trial)
    public void open(BenchmarkParams params) throws IOException {
        copies = params.getOpsPerInvocation();
        session = Session.open(Devices.find(device));
        session.requireRoom("copy", 2 * bytes, bytes);
        source = session.allocate("source", bytes);
        target = session.allocate("target", bytes);
        pattern = session.hostBuffer(Math.min(PIECE_BYTES, bytes));
        fill(target, pattern);
        for (int i = 0; i < pattern.floats().capacity(); i++) {
            pattern.floats().put(i, i + 1);
        }
        fill(source, pattern);
        try (InputStream text = CopyBenchmark.class.getResourceAsStream("/io/github/circles2d/bench/Copy.cl")) {
            program = session.build(
                    KernelSource.ofText("Copy.cl", new String(text.readAllBytes(), StandardCharsets.US_ASCII)));
        }
        copy = program.kernel("copy");
    }

    /** Every byte of the buffer, in pieces of the transfer memory's size. */
    private void fill(DeviceBuffer buffer, HostBuffer piece) {
        for (long offset = 0; offset < bytes; offset += piece.size()) {
            buffer.write(offset, piece, 0, Math.min(piece.size(), bytes - offset));
        }
    }

    /** Copies. */
    @Benchmark
    public void copy() {
        for (int i = 0; i < copies; i++) {
            copy.arg(0, source)
                    .arg(1, target)
                    .arg(2, (int) (bytes / ELEMENT_BYTES))
                    .run(bytes / ELEMENT_BYTES);
        }
        session.finish();
    }

    /** Checks the last piece of the copy, then wipes it for the next one. */
    @TearDown(Level.Iteration)
    public void check() {
        long length = Math.min(pattern.size(), bytes);
        long offset = (bytes - 1) / pattern.size() * pattern.size();
        try (HostBuffer piece = session.hostBuffer(length)) {
            target.read(offset, piece, 0, bytes - offset);
            for (int i = 0; i < (bytes - offset) / Float.BYTES; i++) {
                if (piece.floats().get(i) != pattern.floats().get(i)) {
                    throw new IllegalStateException("float " + i + " of the last piece differs from its source");
                }
                piece.floats().put(i, -1);
            }
            target.write(offset, piece, 0, bytes - offset);
        }
    }

    /** Releases everything. */
    @TearDown(Level.Trial)
    public void close() {
        session.close();
    }
}
