package io.github.circles2d.world.device;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.DeviceBuffer;
import io.github.circles2d.opencl.KernelSource;
import io.github.circles2d.opencl.Program;
import io.github.circles2d.opencl.Session;
import io.github.circles2d.opencl.TestDevices;
import io.github.circles2d.world.device.memory.StageKernels;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The formulas for four contacts at a time: every lane has the bits of the formula for one, on every device. */
class LaneMathTest {
    private static final int SETS = 20_000;
    private static final int ARGUMENTS = 6;
    private static final float[] HOSTILE = {
        0f, -0f, Float.MIN_VALUE, -Float.MIN_VALUE, Float.MIN_NORMAL, 1f, -1f, Math.nextUp(1f), 1e9f, -1e9f, 0x1p-60f
    };

    /** Of formulas: that for four, that for one lane; a to f: arguments. StepConstants have the values of the last set. */
    private static final String[][] FORMULAS = {
        {"greatest4(A, B)", "greatest(a, b)"},
        {"norm4(A, B)", "norm(a, b)"},
        {"along4(A, B, C, D)", "along(a, b, c, d)"},
        {"convert_float4(carries4(A, B, C, D) & 1)", "(float) carries(a, b, c, d)"},
        {"bounceThreshold4(A, B, e, f)", "bounceThreshold(a, b, e, f)"},
        {"pushSpeed4(fabs(A), e, f)", "pushSpeed(fabs(a), e, f)"},
        {"rigid4(A, B, C, D)", "rigid(a, b, c, d)"},
        {"freeBounce4(A, B, C)", "freeBounce(a, b, c)"},
        {
            "rigidOrSoft4(&k, A, B, C, D, E)",
            "d > 0.0f ? rigid(a, b, c, d * k.inverseH)"
                    + " : soft(a, b, c, d, e, k.biasRate, k.massScale, k.impulseScale)"
        },
    };

    static Iterable<Device> devices() {
        return TestDevices.all();
    }

    @ParameterizedTest
    @MethodSource("devices")
    void everyLaneHasTheBitsOfTheFormulaForOne(Device device) {
        KernelSource source = CircleMathOnDevicesTest.formulas()
                .and("world/World.cl", "world/LaneMath.cl")
                .and(KernelSource.ofText("probe", probe()));
        try (Session session = Session.open(device);
                DeviceBuffer in = session.allocate("inputs", 16L * ARGUMENTS * SETS);
                DeviceBuffer out = session.allocate("lanes that differ", 4L * FORMULAS.length)) {
            Program program = session.build(source, StageKernels.options(device));
            in.write(FloatBuffer.wrap(inputs()));
            out.write(0, IntBuffer.wrap(new int[FORMULAS.length]));
            program.kernel("probe").arg(0, in).arg(1, out).arg(2, SETS).run(SETS);
            int[] different = new int[FORMULAS.length];
            out.read(IntBuffer.wrap(different));
            for (int formula = 0; formula < FORMULAS.length; formula++) {
                assertThat(different[formula])
                        .as(FORMULAS[formula][0] + " on " + device)
                        .isZero();
            }
        }
    }

    /** Numbers such as a state can hold, and hostile ones, mixed so that they meet in every position. */
    private static float[] inputs() {
        SplittableRandom random = new SplittableRandom(9);
        float[] inputs = new float[4 * ARGUMENTS * SETS];
        for (int i = 0; i < inputs.length; i++) {
            float scale = random.nextBoolean() ? 1f : 1000f;
            inputs[i] = random.nextInt(4) == 0
                    ? HOSTILE[random.nextInt(HOSTILE.length)]
                    : (float) (random.nextDouble() * 2 - 1) * scale;
        }
        return inputs;
    }

    private static String probe() {
        StringBuilder text =
                new StringBuilder("kernel void probe(global const float *in, global int *out, int count) {\n"
                        + "    int i = (int) get_global_id(0);\n"
                        + "    if (i >= count) return;\n"
                        + "    global const float *x = in + 24 * i;\n"
                        + "    float4 A = vload4(0, x), B = vload4(1, x), C = vload4(2, x);\n"
                        + "    float4 D = vload4(3, x), E = fabs(vload4(4, x));\n"
                        + "    StepConstants k;\n"
                        + "    k.inverseH = 240.0f; k.biasRate = 45.0f; k.massScale = 0.9f; k.impulseScale = 0.1f;\n"
                        + "    float lanes[4];\n");
        for (int formula = 0; formula < FORMULAS.length; formula++) {
            text.append("    {\n        float e = fabs(x[16]), f = fabs(x[20]);\n")
                    .append("        vstore4(" + FORMULAS[formula][0] + ", 0, lanes);\n    }\n")
                    .append("    for (int lane = 0; lane < 4; lane++) {\n")
                    .append("        float a = x[lane], b = x[4 + lane], c = x[8 + lane], d = x[12 + lane];\n")
                    .append("        float e = fabs(x[" + (formula == FORMULAS.length - 1 ? "16 + lane" : "16")
                            + "]), f = fabs(x[20]);\n")
                    .append("        float one = " + FORMULAS[formula][1] + ";\n")
                    .append(
                            "        bool same = as_int(one) == as_int(lanes[lane]) || isnan(one) && isnan(lanes[lane]);\n")
                    .append("        if (!same) atomic_inc(&out[" + formula + "]);\n    }\n");
        }
        return text.append("}\n").toString();
    }
}
