package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Ropes and blobs that are refused: the call leaves no circle, joint or used handle, and no line in the log. Each call of both classes is made
 * with each of its arguments replaced by others in turn, ends and links together with each other argument.
 */
class RefusedNetsTest {
    private static final float[] FLOATS = {
        Float.NaN,
        Float.POSITIVE_INFINITY,
        Float.NEGATIVE_INFINITY,
        -1,
        0,
        Float.MIN_VALUE,
        1e-6f,
        0.5f,
        100,
        1001,
        10_001,
        1e9f,
        Float.MAX_VALUE
    };
    private static final int[] INTS = {-1, 0, 1, 2, 3, 7, 255, 256, 100_001, Integer.MIN_VALUE, Integer.MAX_VALUE};

    private static final Joint[] LINKS = {
        Joint.distance(),
        Joint.distance(0.2f),
        Joint.spring(5, 0.5f),
        Joint.spring(5, 0.5f).withLimits(0, 1),
        Joint.rope(1),
        Joint.limits(0.1f, 1),
        Joint.weld(),
        Joint.weld().breakingAt(1, 1),
        Joint.pin(),
        Joint.pin(5, 1),
        Joint.mouse(5, 1, 100),
        Joint.motor(1, 1),
        Joint.servo(1, 5, 1, 1),
        Joint.friction(1, 1),
        Joint.distance().breakingAt(1, 1).colliding(true)
    };

    /** The calls. */
    static Stream<Method> calls() {
        return Stream.of(Ropes.class, Blobs.class)
                .flatMap(type -> Stream.of(type.getMethods()))
                .filter(method -> method.getReturnType() == JointedCircles.class);
    }

    /** A world that is recorded, with circles, bodies and joints that have gone. */
    private static final class Recorded implements AutoCloseable {
        final World world;
        final World other;
        final Recording recording;
        final long left;
        final long right;
        final long fixed;
        final long alsoFixed;
        final long gone;
        final TerrainBody body;
        final TerrainBody goneBody;

        Recorded() throws IOException {
            world = WorldScenes.jvm().bounds(-50, -50, 50, 50).threads(1).build();
            other = WorldScenes.jvm().threads(1).build();
            recording = new Recording(world, new ByteArrayOutputStream(), 1000);
            left = world.add(-10, 0, 0.5f, 1);
            gone = world.add(0, 20, 0.5f, 1);
            right = world.add(10, 0, 0.5f, 1);
            fixed = world.add(-10, 10, 0.5f, Float.POSITIVE_INFINITY);
            alsoFixed = world.add(10, 10, 0.5f, Float.POSITIVE_INFINITY);
            body = world.terrain().addBody(0, 5, 1);
            goneBody = world.terrain().addBody(0, 6, 1);
            goneBody.remove();
            world.joints().add(left, right, Joint.weld());
            world.joints().remove(world.joints().add(left, right, Joint.spring(5, 1)));
            world.remove(gone);
            world.step(0.01f);
            world.setVelocity(left, 1, 1); // waits
        }

        Object[] ends() {
            return new Object[] {
                Ropes.circle(right),
                Ropes.circle(fixed),
                Ropes.circle(alsoFixed),
                Ropes.circle(gone),
                Ropes.circle(77),
                Ropes.at(4, 8),
                Ropes.at(1e9f, -1e9f),
                Ropes.on(body, 1, 2),
                Ropes.on(world.terrain().ground(), 9, 9),
                Ropes.on(goneBody, 1, 2),
                Ropes.on(other.terrain().ground(), 1, 2),
                Ropes.on(other.terrain().addBody(1, 1, 0), 1, 2)
            };
        }

        /** An array of values for a parameter. */
        Object[] values(Class<?> type) {
            if (type == float.class) {
                Object[] floats = new Object[FLOATS.length];
                for (int k = 0; k < floats.length; k++) {
                    floats[k] = FLOATS[k];
                }
                return floats;
            }
            if (type == int.class) {
                Object[] ints = new Object[INTS.length];
                for (int k = 0; k < ints.length; k++) {
                    ints[k] = INTS[k];
                }
                return ints;
            }
            return type == Joint.class ? LINKS : type == Ropes.End.class ? ends() : new Object[] {world};
        }

        /** Arguments that are taken. */
        Object[] usual(Method call) {
            Class<?>[] types = call.getParameterTypes();
            Object[] arguments = new Object[types.length];
            boolean isRope = call.getDeclaringClass() == Ropes.class;
            float[] floats = isRope ? new float[] {0.2f, 1, 0.1f} : new float[] {0, -20, 5, 0.2f, 1, 5, 0.5f};
            int float_ = 0;
            int end = 0;
            for (int k = 0; k < types.length; k++) {
                if (types[k] == float.class) {
                    arguments[k] = floats[float_++];
                } else if (types[k] == int.class) {
                    arguments[k] = 7;
                } else if (types[k] == Ropes.End.class) {
                    arguments[k] = end++ == 0 ? Ropes.circle(left) : Ropes.circle(right);
                } else {
                    arguments[k] = types[k] == Joint.class ? Joint.distance() : world;
                }
            }
            return arguments;
        }

        /** All that a refused call must not change. */
        List<Object> all() {
            ByteBuffer bytes = ByteBuffer.allocate(world.snapshotBytes());
            world.snapshot(bytes);
            return List.of(
                    bytes.flip(),
                    world.hash(),
                    recording.bytes(),
                    world.idLimit(),
                    world.joints().idLimit(),
                    world.size(),
                    world.joints().size());
        }

        @Override
        public void close() throws IOException {
            recording.close();
            world.close();
            other.close();
        }
    }

    @ParameterizedTest
    @MethodSource("calls")
    void aRefusedCallLeavesNothing(Method call) throws Exception {
        int refused = 0;
        List<String> taken = new ArrayList<>();
        Class<?>[] types = call.getParameterTypes();
        Recorded in = new Recorded();
        for (int first = 1; first < types.length; first++) {
            for (int second = first; second < types.length; second++) {
                if (second != first && types[first].isPrimitive() && types[second].isPrimitive()) {
                    continue; // each alone is enough of numbers
                }
                for (int a = 0; a < in.values(types[first]).length; a++) {
                    for (int b = 0; b < (first == second ? 1 : in.values(types[second]).length); b++) {
                        Object[] arguments = in.usual(call);
                        arguments[first] = in.values(types[first])[a];
                        if (second != first) {
                            arguments[second] = in.values(types[second])[b];
                        }
                        List<Object> before = in.all();
                        String message = refusal(call, arguments);
                        if (message == null) {
                            taken.add(List.of(arguments).toString());
                            in.close();
                            in = new Recorded();
                        } else {
                            assertThat(in.all())
                                    .as(call.getName() + ": " + message)
                                    .isEqualTo(before);
                            refused++;
                        }
                    }
                }
            }
        }
        in.close();
        assertThat(refused).isGreaterThan(40);
        assertThat(taken).hasSizeGreaterThan(10);
    }

    /** The message of the exception; null if the call is taken. */
    private static String refusal(Method call, Object[] arguments) throws IllegalAccessException {
        try {
            call.invoke(null, arguments);
            return null;
        } catch (InvocationTargetException e) {
            assertThat(e.getCause()).isInstanceOf(IllegalArgumentException.class);
            return e.getCause().getMessage();
        }
    }
}
