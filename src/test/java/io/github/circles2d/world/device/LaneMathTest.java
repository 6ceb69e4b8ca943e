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

/** The formulas over REAL, for four contacts at a time: every lane has the bits of the formula for one, on every device. */
class LaneMathTest {
    private static final int SETS = 20_000;
    private static final int ARGUMENTS = 6;
    private static final float[] HOSTILE = {
        0f, -0f, Float.MIN_VALUE, -Float.MIN_VALUE, Float.MIN_NORMAL, 1f, -1f, Math.nextUp(1f), 1e9f, -1e9f, 0x1p-60f
    };

    /** Over REAL; A to F: arguments. */
    private static final String[] FORMULAS = {
        "return NAME(greatest)(A, B);",
        "return NAME(norm)(A, B);",
        "return NAME(along)(A, B, C, D);",
        "return NAME(isNear)(A, B, C) ? (REAL)(1.0f) : (REAL)(0.0f);",
        "return NAME(restitutionThreshold)(k, A, B);",
        "return NAME(least)(A, B);",
        "return NAME(pushSpeed)(k, fabs(A));",
        "return NAME(pushOut)(k, A, fabs(B), k->biasRate);",
        "return NAME(halfFall)(A, B, C);",
        "return NAME(lingers)(A, fabs(B)) ? (REAL)(1.0f) : (REAL)(0.0f);",
        "return NAME(effectiveMass)(A, B);",
        "return NAME(velocityChange)(A, B, C);",
        "return NAME(carries)(A, B, NAME(restingLimit)(C, D)) ? (REAL)(1.0f) : (REAL)(0.0f);",
        "REAL x = A, y = B, s; NAME(measure)(C, D, E, F, fabs(A), &x, &y, &s); return x;",
        "REAL x = A, y = B, s; NAME(measure)(C, D, E, F, fabs(A), &x, &y, &s); return y;",
        "REAL x = A, y = B, s; NAME(measure)(C, D, E, F, fabs(A), &x, &y, &s); return s;",
        "NAME(Visited) v = NAME(solved)(k, A, B, C, D, E, F); return v.impulse;",
        "NAME(Visited) v = NAME(solved)(k, A, B, C, D, E, F); return v.normalImpulse;",
        "NAME(Visited) v = NAME(solved)(k, A, B, C, D, E, F); return v.leaves ? A : v.solved ? B : C;",
        "NAME(Visited) v = NAME(relaxed)(k, A, B, C, D, E, F); return v.impulse;",
        "NAME(Visited) v = NAME(relaxed)(k, A, B, C, D, E, F); return v.normalImpulse;",
        "NAME(Visited) v = NAME(relaxed)(k, A, B, C, D, E, F); return v.leaves ? A : v.solved ? B : C;"
    };

    /** A contact of separation A, restitution B, impulse C and target speed or speed before D, visited at E; loaded if F is positive. */
    private static final String VISITS =
            "NAME(Found) NAME(found)(const StepConstants *k, REAL A, REAL B, REAL C, REAL F) {\n"
                    + "    NAME(Found) f = {A, B, NAME(restitutionThreshold)(k, fabs(A), B),\n"
                    + "                     NAME(flightThreshold)(k, fabs(A), B), fabs(F), C, F > 0.0f,\n"
                    + "                     fabs(C), B, fabs(A * B), A};\n"
                    + "    return f;\n"
                    + "}\n"
                    + "NAME(Visited) NAME(solved)(const StepConstants *k, REAL A, REAL B, REAL C, REAL D, REAL E, REAL F) {\n"
                    + "    NAME(Found) f = NAME(found)(k, A, B, C, F);\n"
                    + "    NAME(Ready) c;\n"
                    + "    f.before = D;\n"
                    + "    NAME(makeReadyToSolve)(k, contactSoftness(k), &f, &c);\n"
                    + "    NAME(Visited) v;\n"
                    + "    NAME(visit)(&c, E, false, &v);\n"
                    + "    return v;\n"
                    + "}\n"
                    + "NAME(Visited) NAME(relaxed)(const StepConstants *k, REAL A, REAL B, REAL C, REAL D, REAL E, REAL F) {\n"
                    + "    NAME(Found) f = NAME(found)(k, A, B, C, F);\n"
                    + "    NAME(Ready) c;\n"
                    + "    NAME(makeReadyToRelax)(k, &f, D, &c);\n"
                    + "    NAME(Visited) v;\n"
                    + "    NAME(visit)(&c, E, true, &v);\n"
                    + "    return v;\n"
                    + "}\n";

    static Iterable<Device> devices() {
        return TestDevices.all();
    }

    @ParameterizedTest
    @MethodSource("devices")
    void everyLaneHasTheBitsOfTheFormulaForOne(Device device) {
        KernelSource source = CircleMathOnDevicesTest.formulas()
                .and("world/shared/Contact.cl*4", "world/shared/PairRule.cl", "world/shared/PairRule.cl*4")
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
                        .as(FORMULAS[formula] + " on " + device)
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
        StringBuilder over = new StringBuilder(VISITS);
        StringBuilder kernel =
                new StringBuilder("kernel void probe(global const float *in, global int *out, int count) {\n"
                        + "    int i = (int) get_global_id(0);\n"
                        + "    if (i >= count) return;\n"
                        + "    global const float *x = in + 24 * i;\n"
                        + "    StepConstants k;\n"
                        + "    k.h = 0x1p-8f; k.inverseH = 240.0f;\n"
                        + "    k.thresholdRate = 0.3f; k.restRate = 0.7f; k.flightRestRate = 0.2f; k.pushRate = 4.0f;\n"
                        + "    k.biasRate = 45.0f; k.massScale = 0.9f; k.impulseScale = 0.1f;\n"
                        + "    float lanes[4];\n");
        for (int formula = 0; formula < FORMULAS.length; formula++) {
            over.append("REAL NAME(formula" + formula
                            + "_)(const StepConstants *k, REAL A, REAL B, REAL C, REAL D, REAL E,")
                    .append(" REAL F) {\n    " + FORMULAS[formula] + "\n}\n");
            kernel.append("    vstore4(formula" + formula
                            + "_4(&k, vload4(0, x), vload4(1, x), vload4(2, x), vload4(3, x),")
                    .append(" vload4(4, x), vload4(5, x)), 0, lanes);\n")
                    .append("    for (int lane = 0; lane < 4; lane++) {\n")
                    .append("        float one = formula" + formula + "_(&k, x[lane], x[4 + lane], x[8 + lane],")
                    .append(" x[12 + lane], x[16 + lane], x[20 + lane]);\n")
                    .append(
                            "        bool same = as_int(one) == as_int(lanes[lane]) || isnan(one) && isnan(lanes[lane]);\n")
                    .append("        if (!same) atomic_inc(&out[" + formula + "]);\n    }\n");
        }
        return over + "#undef LANES\n#define LANES 4\n" + over + kernel + "}\n";
    }
}
