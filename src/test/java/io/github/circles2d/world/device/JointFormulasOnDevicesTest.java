package io.github.circles2d.world.device;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.DeviceBuffer;
import io.github.circles2d.opencl.KernelSource;
import io.github.circles2d.opencl.OnEachDevice;
import io.github.circles2d.opencl.Session;
import io.github.circles2d.opencl.TestScale;
import io.github.circles2d.world.device.memory.StageKernels;
import io.github.circles2d.world.device.memory.WorldSource;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.ContactSettings;
import io.github.circles2d.world.model.JointMath;
import io.github.circles2d.world.model.Softness;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.Velocity;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.SplittableRandom;

/** The formulas of joints have the same bits on a device as in Java, also for numbers of any magnitude, infinite ones and angles that overflow. */
class JointFormulasOnDevicesTest {
    /** Floats of an input, and then four angles. */
    private static final int FLOATS = 8;

    private static final int INPUT = FLOATS + 4;
    private static final int OUTPUT = 14;

    private static final String PROBE = """
            kernel void probe(global const int *in, global const float *soft, global int *out, int count) {
                int i = (int) get_global_id(0);
                if (i >= count) return;
                float p[8];
                for (int k = 0; k < 8; k++) p[k] = as_float(in[12 * i + k]);
                global const int *angle = in + 12 * i + 8;
                global int *to = out + 14 * i;
                to[0] = as_int(keptImpulse(p[0]));
                to[1] = as_int(jointMass(p[1]));
                to[2] = as_int(solvedImpulse(p[0], p[1], p[2], p[3], soft[0], soft[1], soft[2]));
                to[3] = as_int(relaxedImpulse(p[0], p[1], p[2]));
                to[4] = as_int(springImpulse(p[1], p[2], p[3], p[4], p[5], p[6], p[7]));
                to[5] = as_int(solvedLimit(p[0], p[1], p[2], p[3], p[4], soft[0], soft[1], soft[2], fabs(p[5])));
                to[6] = as_int(relaxedLimit(p[0], p[1], p[2], p[3], p[4]));
                to[7] = as_int(shareWithin(p[0], p[1], p[2]));
                to[8] = as_int(turnedAway(angle[0], angle[1], p[0], angle[2], angle[3], p[1]));
                to[9] = meanTurn(angle[0], angle[1], p[0], angle[2], angle[3], p[1]);
                to[10] = as_int(sinOfUnits(angle[0]));
                to[11] = as_int(cosOfUnits(angle[1]));
                to[12] = as_int(heldImpulse(p[0], p[1], p[2], p[3], soft[0], soft[1], soft[2], fabs(p[4])));
                to[13] = as_int(greatestPush(p[0], p[1]));
            }
            """;

    @OnEachDevice
    void formulasHaveTheSameBits(Device device) {
        SplittableRandom random = new SplittableRandom(1);
        int count = TestScale.of(200_000, 2_000_000);
        int[] inputs = new int[INPUT * count];
        for (int i = 0; i < inputs.length; i++) {
            inputs[i] = i % INPUT < FLOATS ? Float.floatToRawIntBits(number(random)) : angle(random);
        }
        Softness soft = softness();
        int[] onDevice = run(device, inputs, soft, count);
        int[] inJava = new int[OUTPUT];
        int pulls = 0;
        for (int i = 0; i < count; i++) {
            compute(inputs, INPUT * i, soft, inJava);
            pulls += Float.intBitsToFloat(inJava[5]) > 0f ? 1 : 0;
            for (int k = 0; k < OUTPUT; k++) {
                if (inJava[k] != onDevice[OUTPUT * i + k] && !areBothNaN(k, inJava[k], onDevice[OUTPUT * i + k])) {
                    assertThat(onDevice[OUTPUT * i + k])
                            .as("number %s of input %s", k, i)
                            .isEqualTo(inJava[k]);
                }
            }
        }
        assertThat(pulls).isBetween(count / 10, 9 * count / 10);
    }

    /** NaN has many bits. */
    private static boolean areBothNaN(int k, int a, int b) {
        return k != 9 && Float.isNaN(Float.intBitsToFloat(a)) && Float.isNaN(Float.intBitsToFloat(b));
    }

    private static float number(SplittableRandom random) {
        float sign = random.nextBoolean() ? 1f : -1f;
        return switch (random.nextInt(16)) {
            case 0 -> sign * 0f;
            case 1 -> sign * Float.POSITIVE_INFINITY;
            case 2 -> sign * (float) Math.pow(10, 80 * random.nextDouble() - 40);
            default -> sign * (float) (4 * random.nextDouble());
        };
    }

    private static int angle(SplittableRandom random) {
        return switch (random.nextInt(8)) {
            case 0 -> Integer.MIN_VALUE + random.nextInt(3) - 1;
            case 1 -> random.nextInt(3) - 1;
            case 2 -> (1 << 29) * random.nextInt(8) + random.nextInt(3) - 1;
            default -> random.nextInt();
        };
    }

    private static Softness softness() {
        Bounds bounds = new Bounds(0, 0, 1, 1);
        StepConstants constants = new StepConstants();
        constants.set(1 / 60f, 4, 0, 0, bounds, bounds, 1 / 60f, ContactSettings.DEFAULT);
        return constants.jointSoftness;
    }

    private static void compute(int[] in, int at, Softness soft, int[] to) {
        float[] p = new float[FLOATS];
        for (int k = 0; k < FLOATS; k++) {
            p[k] = Float.intBitsToFloat(in[at + k]);
        }
        int a = at + FLOATS;
        float[] results = {
            JointMath.keptImpulse(p[0]),
            JointMath.jointMass(p[1]),
            JointMath.solvedImpulse(p[0], p[1], p[2], p[3], soft.massScale, soft.biasRate, soft.impulseScale),
            JointMath.relaxedImpulse(p[0], p[1], p[2]),
            JointMath.springImpulse(p[1], p[2], p[3], p[4], p[5], p[6], p[7]),
            JointMath.solvedLimit(p[0], p[1], p[2], p[3], p[4], soft, Math.abs(p[5])),
            JointMath.relaxedLimit(p[0], p[1], p[2], p[3], p[4]),
            Velocity.shareWithin(p[0], p[1], p[2]),
            JointMath.turnedAway(in[a], in[a + 1], p[0], in[a + 2], in[a + 3], p[1]),
            0f,
            JointMath.sinOfUnits(in[a]),
            JointMath.cosOfUnits(in[a + 1]),
            JointMath.heldImpulse(p[0], p[1], p[2], p[3], soft, Math.abs(p[4])),
            JointMath.greatestPush(p[0], p[1])
        };
        for (int k = 0; k < OUTPUT; k++) {
            to[k] = Float.floatToRawIntBits(results[k]);
        }
        to[9] = JointMath.meanTurn(in[a], in[a + 1], p[0], in[a + 2], in[a + 3], p[1]);
    }

    private static int[] run(Device device, int[] inputs, Softness soft, int count) {
        KernelSource source = WorldSource.tables()
                .define("JOINTS", 1)
                .and("world/shared/Velocity.cl", "world/shared/JointMath.cl")
                .and(KernelSource.ofText("probe", PROBE));
        try (Session session = Session.open(device);
                DeviceBuffer in = session.allocate("inputs", 4L * inputs.length);
                DeviceBuffer ofSoft = session.allocate("softness", 12);
                DeviceBuffer out = session.allocate("results", 4L * OUTPUT * count)) {
            in.write(0, IntBuffer.wrap(inputs));
            ofSoft.write(FloatBuffer.wrap(new float[] {soft.massScale, soft.biasRate, soft.impulseScale}));
            session.build(source, StageKernels.options(device))
                    .kernel("probe")
                    .arg(0, in)
                    .arg(1, ofSoft)
                    .arg(2, out)
                    .arg(3, count)
                    .run(count);
            int[] results = new int[OUTPUT * count];
            out.read(IntBuffer.wrap(results));
            return results;
        }
    }
}
