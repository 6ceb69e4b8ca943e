package io.github.circles2d.world.device;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.DeviceBuffer;
import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.opencl.KernelSource;
import io.github.circles2d.opencl.OnEachDevice;
import io.github.circles2d.opencl.Program;
import io.github.circles2d.opencl.Session;
import io.github.circles2d.world.device.memory.StageKernels;
import io.github.circles2d.world.device.memory.WorldSource;
import io.github.circles2d.world.model.Bounce;
import io.github.circles2d.world.model.Cells;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.model.Paths;
import io.github.circles2d.world.model.Surface;
import io.github.circles2d.world.model.TimeOfImpact;
import io.github.circles2d.world.model.Velocity;
import io.github.circles2d.world.model.Walls;
import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.nio.IntBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;

/**
 * Every function of {@link #FORMULAS}, called on a device and in Java with the same inputs. The functions are
 * found by reflection, so one without a twin of the same name in kernels/world/shared fails, unless {@link #TWINS} says what
 * does its work there.
 */
class CircleMathOnDevicesTest {
    private static final List<Class<?>> FORMULAS = List.of(
            CircleMath.class,
            Velocity.class,
            Paths.class,
            TimeOfImpact.class,
            Cells.class,
            Bounce.class,
            Walls.class,
            Surface.class);

    /** Of angles in radians, which devices do not know. */
    private static final Set<String> OF_THE_HOST = Set.of("units", "radians");

    /** Functions that count to their whole number, of sub-steps. */
    private static final Set<String> COUNT_SUB_STEPS = Set.of("dampedTime", "dampedFalls");

    /** Sets of arguments per function. */
    private static final int FEW_INPUTS = 1 << 15;

    private static final int MANY_INPUTS = Integer.getInteger("circles2d.math.inputs", 1 << 18);

    private static final float[] HOSTILE = {
        0f,
        -0f,
        1f,
        -1f,
        Float.MIN_VALUE,
        -Float.MIN_VALUE,
        Float.MIN_NORMAL,
        -Float.MIN_NORMAL,
        Math.nextDown(Float.MIN_NORMAL),
        Float.MAX_VALUE,
        -Float.MAX_VALUE,
        Float.POSITIVE_INFINITY,
        Float.NEGATIVE_INFINITY,
        0x1p24f,
        0x1.fffffep23f,
        0x1p31f,
        -0x1p31f,
        0x1.fffffep30f,
        1e-9f,
        1e9f,
        0.5f,
        0x1.fffffep-1f,
        0x1.000002p0f
    };

    /** Expressions in place of calls of a function of the same name; p0, p1 and so on: arguments. */
    private static final Map<String, String> TWINS = Map.of(
            "length", "lengthf(p0, p1)",
            "min", "minf(p0, p1)",
            "max", "maxf(p0, p1)",
            "clamp", "clampf(p0, p1, p2)",
            "dot", "dotf(p0, p1, p2, p3)",
            "difference", "p0 + (p2 - p1)",
            "freeBounce", "-(1.0f + p0) * p1 * p2",
            "bounceThreshold", "bounceThreshold(&k, p0, p1, p2)",
            "flightThreshold", "flightThreshold(&k, p0, p1)");

    /** Statements before these expressions. */
    private static final Map<String, String> SETUPS = Map.of(
            "bounceThreshold", "StepConstants k; k.restRate = p3; k.fixedThreshold = p4;",
            "flightThreshold", "StepConstants k; k.thresholdRate = p2; k.flightRestRate = p3; k.fixedThreshold = p4;");

    @OnEachDevice
    void everyFunctionHasTheSameBitsOnTheDeviceAsInJava(Device device) throws Throwable {
        compare(device, FEW_INPUTS);
    }

    @OnEachDevice
    @Tag("exhaustive")
    void everyFunctionHasTheSameBitsForManyInputs(Device device) throws Throwable {
        compare(device, MANY_INPUTS);
    }

    /** The files of the formulas without the stages, whose kernels a driver would compile too, for ten seconds. */
    static KernelSource formulas() {
        return WorldSource.tables()
                .define("TURNING", 1)
                .and(
                        "world/shared/Cells.cl",
                        "world/shared/Paths.cl",
                        "world/shared/TimeOfImpact.cl",
                        "world/shared/Wall.cl",
                        "world/shared/Surface.cl");
    }

    private static void compare(Device device, int count) throws Throwable {
        KernelSource source = formulas().define("TUNED", 1); // as for a world with a fixed threshold
        for (Method function : functions()) {
            source = source.and(probe(function));
        }
        try (Session session = Session.open(device)) {
            Program program = session.build(source, StageKernels.options(device));
            for (Method function : functions()) {
                compare(session, program, function, count);
            }
        }
    }

    private static List<Method> functions() {
        List<Method> functions = new ArrayList<>();
        for (Method method : FORMULAS.stream()
                .flatMap(each -> Arrays.stream(each.getDeclaredMethods()))
                .toList()) {
            if (Modifier.isStatic(method.getModifiers())
                    && !Modifier.isPrivate(method.getModifiers())
                    && !OF_THE_HOST.contains(method.getName())
                    && !method.isSynthetic()) {
                functions.add(method);
            }
        }
        functions.sort(Comparator.comparing(CircleMathOnDevicesTest::nameOf));
        return functions;
    }

    /** Two functions may have the same name in Java. */
    private static String nameOf(Method function) {
        return function.getDeclaringClass().getSimpleName() + "_" + function.getName() + function.getParameterCount();
    }

    private static void compare(Session session, Program program, Method function, int count) throws Throwable {
        Class<?>[] types = function.getParameterTypes();
        int[] inputs =
                inputs(types, count, new SplittableRandom(function.getName().hashCode()));
        if (COUNT_SUB_STEPS.contains(function.getName())) {
            int subSteps = Arrays.asList(types).indexOf(int.class);
            for (int i = subSteps; i < inputs.length; i += types.length) {
                inputs[i] = Math.floorMod(inputs[i], Limits.SUB_STEPS + 1);
            }
        }
        int[] onDevice = run(session, program, function, inputs, count);
        MethodHandle inJava = MethodHandles.lookup().unreflect(function).asSpreader(Object[].class, types.length);
        Object[] arguments = new Object[types.length];
        for (int i = 0; i < count; i++) {
            for (int p = 0; p < types.length; p++) {
                int bits = inputs[i * types.length + p];
                arguments[p] = types[p] == float.class
                        ? (Object) Float.intBitsToFloat(bits)
                        : types[p] == boolean.class ? (Object) (bits != 0) : (Object) bits;
            }
            int expected = bits(inJava.invoke(arguments));
            if (expected != canonical(function.getReturnType(), onDevice[i])) {
                assertThat(describe(function, onDevice[i]))
                        .as("%s%s on %s", function.getName(), Arrays.toString(arguments), session.device())
                        .isEqualTo(describe(function, expected));
            }
        }
    }

    /** Random bits, ordinary numbers and the hostile ones, mixed so that they meet in every position; never NaN. */
    private static int[] inputs(Class<?>[] types, int count, SplittableRandom random) {
        int[] inputs = new int[count * types.length];
        for (int i = 0; i < inputs.length; i++) {
            Class<?> type = types[i % types.length];
            int kind = random.nextInt(4);
            if (type == boolean.class) {
                inputs[i] = random.nextInt(2);
            } else if (type == int.class) {
                inputs[i] = kind == 0 ? random.nextInt() : random.nextInt(1 << (1 + random.nextInt(20)));
            } else if (kind == 0) {
                inputs[i] = Float.floatToRawIntBits(HOSTILE[random.nextInt(HOSTILE.length)]);
            } else if (kind == 1) {
                int bits;
                do {
                    bits = random.nextInt();
                } while (Float.isNaN(Float.intBitsToFloat(bits)));
                inputs[i] = bits;
            } else {
                float scale = kind == 2 ? 1f : 1000f;
                inputs[i] = Float.floatToRawIntBits((float) (random.nextDouble() * 2 - 1) * scale);
            }
        }
        return inputs;
    }

    /** A kernel that calls the function with one set of arguments a work-item. */
    private static KernelSource probe(Method function) {
        Class<?>[] types = function.getParameterTypes();
        String name = "probe_" + nameOf(function);
        StringBuilder parameters = new StringBuilder();
        StringBuilder plain = new StringBuilder(function.getName()).append('(');
        for (int p = 0; p < types.length; p++) {
            String type = types[p] == float.class ? "float" : "int";
            String input = "in[i * " + types.length + " + " + p + "]";
            parameters.append("        " + type + " p" + p + " = ");
            parameters
                    .append(types[p] == float.class ? "as_float(" + input + ")" : input)
                    .append(";\n");
            plain.append(p == 0 ? "p" : ", p").append(p);
        }
        String call = TWINS.getOrDefault(function.getName(), plain + ")");
        String result = function.getReturnType() == float.class ? "as_int(" + call + ")" : "(int) " + call;
        return KernelSource.ofText(
                name,
                "kernel void " + name + "(global const int *in, global int *out, int count) {\n"
                        + "    int i = (int) get_global_id(0);\n"
                        + "    if (i < count) {\n" + parameters
                        + "        " + SETUPS.getOrDefault(function.getName(), "") + "\n"
                        + "        out[i] = " + result + ";\n"
                        + "    }\n"
                        + "}\n");
    }

    private static int[] run(Session session, Program program, Method function, int[] inputs, int count) {
        try (DeviceBuffer in = session.allocate("inputs", 4L * inputs.length);
                DeviceBuffer out = session.allocate("results", 4L * count)) {
            in.write(0, IntBuffer.wrap(inputs));
            Kernel kernel = program.kernel("probe_" + nameOf(function));
            kernel.arg(0, in).arg(1, out).arg(2, count).run(count);
            int[] results = new int[count];
            out.read(IntBuffer.wrap(results));
            return results;
        }
    }

    /** All NaNs are one: which of them an operation returns is not defined, and the engine never makes one. */
    private static int bits(Object result) {
        if (result instanceof Float) {
            return Float.floatToIntBits((Float) result);
        }
        return result instanceof Boolean ? ((Boolean) result ? 1 : 0) : (Integer) result;
    }

    private static int canonical(Class<?> type, int bits) {
        return type == float.class ? Float.floatToIntBits(Float.intBitsToFloat(bits)) : bits;
    }

    private static String describe(Method function, int bits) {
        return function.getReturnType() == float.class
                ? Float.toHexString(Float.intBitsToFloat(bits))
                : Integer.toString(bits);
    }
}
