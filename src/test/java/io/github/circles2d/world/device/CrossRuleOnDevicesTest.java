package io.github.circles2d.world.device;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.DeviceBuffer;
import io.github.circles2d.opencl.KernelSource;
import io.github.circles2d.opencl.Program;
import io.github.circles2d.opencl.Session;
import io.github.circles2d.opencl.TestDevices;
import io.github.circles2d.world.device.memory.StageKernels;
import io.github.circles2d.world.device.memory.WorldSource;
import io.github.circles2d.world.model.CrossRule;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** The functions of {@link CrossRule} on a device and in Java, and the sums that work-items add to at the same time. */
class CrossRuleOnDevicesTest {
    private static final int COUNT = 1 << 14;
    private static final int INPUTS = 4;
    private static final int RESULTS = 6;

    private static final String PROBE =
            "kernel void probe(global const float4 *in, global long *out, global long *sums) {\n"
                    + "    int i = (int) get_global_id(0);\n"
                    + "    float4 a = in[i];\n"
                    + "    float range = impulseRange(a.x, a.y, a.z);\n"
                    + "    global long *o = out + " + RESULTS + " * i;\n"
                    + "    int load = loadOfHeavy(a.x, a.y);\n"
                    + "    long fixed_ = toFixed(a.w, scaleOf(range));\n"
                    + "    o[0] = load;\n"
                    + "    o[1] = as_int(crossMass(a.x, a.y, crossShare(load)));\n"
                    + "    o[2] = as_int(velocityRange(a.x, a.y));\n"
                    + "    o[3] = isFinerLight(a.x, a.y);\n"
                    + "    o[4] = fixed_;\n"
                    + "    o[5] = as_int(fromFixed(fixed_, unitOf(range)));\n"
                    + "    addFixed(sums + i % 2, fixed_);\n"
                    + "}\n";

    static List<Arguments> devices() {
        List<Arguments> both = new ArrayList<>();
        for (Device device : TestDevices.all()) {
            both.add(Arguments.of(device, false));
            both.add(Arguments.of(device, true));
        }
        return both;
    }

    @ParameterizedTest(name = "{0}, additions by halves: {1}")
    @MethodSource("devices")
    void formulasAndSumsHaveTheSameBitsAsInJava(Device device, boolean byHalves) {
        float[] in = inputs();
        long[] sums = {Long.MIN_VALUE, -1};
        long[] expected = expected(in, sums);
        KernelSource source =
                WorldSource.tables().and("world/shared/CrossRule.cl").and(KernelSource.ofText("probe", PROBE));
        KernelSource defined = byHalves ? source.define("ATOMICS_BY_HALVES", 1) : source;
        try (Session session = Session.open(device);
                DeviceBuffer inputs = session.allocate("inputs", 4L * in.length);
                DeviceBuffer results = session.allocate("results", 8L * expected.length);
                DeviceBuffer sumsOnDevice = session.allocate("sums", 16)) {
            Program program = session.build(defined, StageKernels.options(device));
            inputs.write(FloatBuffer.wrap(in));
            sumsOnDevice.write(0, IntBuffer.wrap(new int[] {0, Integer.MIN_VALUE, -1, -1}));
            program.kernel("probe")
                    .arg(0, inputs)
                    .arg(1, results)
                    .arg(2, sumsOnDevice)
                    .run(COUNT);
            assertArrayEquals(expected, read(results, expected.length));
            assertArrayEquals(sums, read(sumsOnDevice, sums.length));
        }
    }

    private static long[] read(DeviceBuffer buffer, int count) {
        int[] halves = new int[2 * count];
        buffer.read(IntBuffer.wrap(halves));
        long[] longs = new long[count];
        for (int k = 0; k < count; k++) {
            longs[k] = (long) halves[2 * k + 1] << 32 | halves[2 * k] & 0xffffffffL;
        }
        return longs;
    }

    /** Sets of four: positive numbers of any size, and a value of any sign. */
    private static float[] inputs() {
        SplittableRandom random = new SplittableRandom(5);
        float[] in = new float[INPUTS * COUNT];
        for (int k = 0; k < in.length; k++) {
            float size = (float) Math.pow(2, 60 * random.nextDouble() - 30);
            in[k] = k % INPUTS == 3 && random.nextBoolean() ? -size : size;
        }
        return in;
    }

    private static long[] expected(float[] in, long[] sums) {
        long[] out = new long[RESULTS * COUNT];
        for (int i = 0; i < COUNT; i++) {
            float x = in[INPUTS * i];
            float y = in[INPUTS * i + 1];
            float range = CrossRule.impulseRange(x, y, in[INPUTS * i + 2]);
            int load = CrossRule.loadOfHeavy(x, y);
            long fixed = CrossRule.toFixed(in[INPUTS * i + 3], CrossRule.scaleOf(range));
            int o = RESULTS * i;
            out[o] = load;
            out[o + 1] = Float.floatToRawIntBits(CrossRule.crossMass(x, y, CrossRule.crossShare(load)));
            out[o + 2] = Float.floatToRawIntBits(CrossRule.velocityRange(x, y));
            out[o + 3] = CrossRule.isFinerLight(x, y) ? 1 : 0;
            out[o + 4] = fixed;
            out[o + 5] = Float.floatToRawIntBits(CrossRule.fromFixed(fixed, CrossRule.unitOf(range)));
            sums[i % 2] += fixed;
        }
        return out;
    }
}
