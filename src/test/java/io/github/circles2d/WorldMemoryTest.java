package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.fuzz.MemoryLimits;
import io.github.circles2d.opencl.TestScale;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/**
 * Memory that ends at any allocation of any call, on the JVM back end: a call other than a step has changed nothing, and a step has changed nothing
 * or the world says that its state is lost. {@link AllocationLimit} ends memory.
 */
class WorldMemoryTest {
    private static final Class<?> PROGRAM = load(MemoryLimits.class);

    private static Class<?> load(Class<?> program) {
        try {
            return new AllocationLimitLoader().loadClass(program.getName());
        } catch (ClassNotFoundException e) {
            throw new AssertionError(e);
        }
    }

    private static void check(String method, int... arguments) throws ReflectiveOperationException {
        check(PROGRAM, method, arguments);
    }

    private static void check(Class<?> program, String method, int... arguments) throws ReflectiveOperationException {
        Class<?>[] types = IntStream.of(arguments).mapToObj(each -> int.class).toArray(Class<?>[]::new);
        Object[] boxed = IntStream.of(arguments).boxed().toArray();
        assertThat((List<?>) program.getMethod(method, types).invoke(null, boxed))
                .isEmpty();
    }

    @Test
    void aCallThatMemoryEndsInHasChangedNothingAndMayBeMadeAgain() throws ReflectiveOperationException {
        check("each", 1, TestScale.of(2, 6, 20), TestScale.of(9, 3, 1));
    }

    @Test
    @Tag("long")
    void soItIsWithTwoThreads() throws ReflectiveOperationException {
        check("each", 2, TestScale.of(6, 20), TestScale.of(3, 1));
    }

    @Test
    void programsGoOnAsIfMemoryHadNotEnded() throws ReflectiveOperationException {
        check("programs", 1, TestScale.of(10, 60, 5000));
    }

    @Test
    void aRestoreThatLackedMemoryIsMadeSomeStepsLater() throws ReflectiveOperationException {
        for (int steps = 1; steps <= 2; steps++) {
            check(load(RestoreLimits.class), "restore", steps);
        }
    }
}
