package io.github.circles2d.bench.broadphase;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.DeviceBuffer;
import io.github.circles2d.opencl.HostBuffer;
import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.opencl.KernelSource;
import io.github.circles2d.opencl.Program;
import io.github.circles2d.opencl.Session;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * {@link SubdividedSweepAndPrune} on an OpenCL device. A circle has as many slots for entries as its radius may need, so a step
 * enqueues all its kernels at once, and waits for the number of pairs only. Positions and pairs stay on the device.
 */
final class DeviceSweep implements AutoCloseable {
    private static final String SOURCE = "SweepAndPrune.cl";
    private static final int GROUP = 128;
    private static final int EACH = 8;
    private static final int BLOCK = GROUP * EACH;
    private static final int DIGIT_BITS = 4;
    private static final int DIGITS = 1 << DIGIT_BITS;

    /** Bits of a key: few passes, and intervals that begin within 1/16 of a radius of each other in any order. */
    private static final int KEY_BITS = 24;

    /** Pairs per circle that there is room for at first. */
    private static final int PAIRS = 4;

    private final Session session;
    private final Program program;
    private final Map<String, Kernel> kernels = new HashMap<>();
    private final List<DeviceBuffer> buffers = new ArrayList<>();
    private final List<DeviceBuffer> sums = new ArrayList<>();
    private final int chunk;
    private final int n;
    private final int entries;
    private final int strips;
    private final int xBits;
    private final float minX;
    private final float perX;
    private final DeviceBuffer x;
    private final DeviceBuffer y;
    private final DeviceBuffer reach;
    private final DeviceBuffer slot;
    private final DeviceBuffer digits;
    private final DeviceBuffer sorted;
    private final DeviceBuffer counts;
    private DeviceBuffer keys;
    private DeviceBuffer numbers;
    private DeviceBuffer otherKeys;
    private DeviceBuffer otherNumbers;
    private DeviceBuffer pairs;
    private final HostBuffer total;
    private int room;
    private int found;

    /** Takes over circles. */
    DeviceSweep(Device device, float[] reach) {
        n = reach.length;
        chunk = device.kind() == Device.Kind.CPU ? 1024 : 32;
        double sum = 0;
        float greatest = 0;
        for (float r : reach) {
            sum += r;
            greatest = Math.max(greatest, r);
        }
        strips = (int) Math.max(1, Math.min(n / (SubdividedSweepAndPrune.STRIP * sum), 1 << KEY_BITS / 2 - 1));
        xBits = KEY_BITS - (32 - Integer.numberOfLeadingZeros(strips + 1));
        minX = -greatest;
        perX = ((1 << xBits) - 1) / (1 + 2 * greatest);
        int[] slots = new int[n + 1];
        for (int i = 0; i < n; i++) {
            slots[i + 1] = slots[i] + (int) (2 * (reach[i] + 2 * BroadPhase.SLACK) * strips) + 2;
        }
        entries = slots[n];
        session = Session.open(device);
        program = session.build(KernelSource.ofText(SOURCE, source())
                .define("GROUP", GROUP)
                .define("EACH", EACH)
                .define("CHUNK", chunk)
                .define("SLACK", BroadPhase.SLACK + "f"));
        x = allocate("x", n);
        y = allocate("y", n);
        this.reach = allocate("reach", n);
        this.reach.write(FloatBuffer.wrap(reach));
        slot = allocate("slot", n + 1);
        slot.write(0, IntBuffer.wrap(slots));
        keys = allocate("keys", entries);
        numbers = allocate("numbers", entries);
        otherKeys = allocate("other keys", entries);
        otherNumbers = allocate("other numbers", entries);
        digits = allocate("digits", (long) DIGITS * chunks());
        sorted = allocate("sorted", 4L * entries);
        counts = allocate("counts", entries + 1L);
        total = session.hostBuffer(4);
        room = PAIRS * n;
        pairs = allocate("pairs", 2L * room);
    }

    private static String source() {
        try (InputStream text = DeviceSweep.class.getResourceAsStream("/io/github/circles2d/bench/" + SOURCE)) {
            return new String(text.readAllBytes(), StandardCharsets.US_ASCII);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private DeviceBuffer allocate(String name, long words) {
        DeviceBuffer buffer = session.allocate(name, 4 * words);
        buffers.add(buffer);
        return buffer;
    }

    private int chunks() {
        return (entries + chunk - 1) / chunk;
    }

    private Kernel kernel(String name) {
        return kernels.computeIfAbsent(name, program::kernel);
    }

    /** Copies positions to the device. */
    void move(float[] px, float[] py) {
        x.write(FloatBuffer.wrap(px));
        y.write(FloatBuffer.wrap(py));
        session.finish();
    }

    /**
     * Finds the pairs of the positions on the device.
     *
     * @return their number
     */
    int findPairs() {
        int pad = (1 << KEY_BITS) - 1;
        set("make_entries", x, y, reach, slot, keys, numbers, n, strips, xBits, minX, perX, pad)
                .run(n);
        for (int shift = 0; shift < KEY_BITS; shift += DIGIT_BITS) {
            sort(shift);
        }
        set("gather", x, y, reach, numbers, sorted, entries, strips).run(entries);
        set("count_pairs", keys, sorted, numbers, pairs, counts, entries, xBits, minX, perX, pad)
                .run(entries + 1);
        scan(counts, entries + 1, 0);
        writePairs(pad);
        counts.read(4L * entries, total, 0, 4);
        found = total.ints().get(0);
        if (found > room) {
            room = found + (found >> 2);
            pairs = allocate("more pairs", 2L * room);
            writePairs(pad);
            session.finish();
        }
        return found;
    }

    private void writePairs(int pad) {
        set("write_pairs", keys, sorted, numbers, pairs, counts, room, entries, xBits, minX, perX, pad)
                .run(entries);
    }

    private void sort(int shift) {
        int chunks = chunks();
        set("count_digits", keys, digits, entries, chunks, shift).run(chunks);
        scan(digits, DIGITS * chunks, 0);
        set("scatter_digits", keys, numbers, digits, otherKeys, otherNumbers, entries, chunks, shift)
                .run(chunks);
        DeviceBuffer swap = keys;
        keys = otherKeys;
        otherKeys = swap;
        swap = numbers;
        numbers = otherNumbers;
        otherNumbers = swap;
    }

    private void scan(DeviceBuffer values, int length, int level) {
        int blocks = (length + BLOCK - 1) / BLOCK;
        if (sums.size() == level) {
            // Room for the longest array that is ever summed up at this level.
            long most = Math.max((long) DIGITS * chunks(), entries + 1L);
            for (int l = 0; l <= level; l++) {
                most = (most + BLOCK - 1) / BLOCK;
            }
            sums.add(allocate("sums", most));
        }
        set("scan_blocks", values, sums.get(level), length).run((long) blocks * GROUP, GROUP);
        if (blocks > 1) {
            scan(sums.get(level), blocks, level + 1);
            set("add_sums", values, sums.get(level), length).run(length);
        }
    }

    private Kernel set(String name, Object... arguments) {
        Kernel kernel = kernel(name);
        for (int i = 0; i < arguments.length; i++) {
            if (arguments[i] instanceof DeviceBuffer buffer) {
                kernel.arg(i, buffer);
            } else if (arguments[i] instanceof Float value) {
                kernel.arg(i, value);
            } else {
                kernel.arg(i, (int) (Integer) arguments[i]);
            }
        }
        return kernel;
    }

    /** Adds the pairs that were found to a list. */
    void read(PairList list) {
        IntBuffer members = IntBuffer.allocate(2 * found);
        if (found > 0) {
            pairs.read(members);
        }
        for (int k = 0; k < 2 * found; k += 2) {
            list.add(members.get(k), members.get(k + 1));
        }
    }

    @Override
    public void close() {
        total.close();
        buffers.forEach(DeviceBuffer::close);
        kernels.values().forEach(Kernel::close);
        program.close();
        session.close();
    }
}
