package io.github.circles2d.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.catchThrowable;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class GuardedPipelineTest {
    /** All that a pipeline does, but saying what it is and closing. */
    static List<Method> calls() {
        return Arrays.stream(Pipeline.class.getMethods())
                .filter(method -> !List.of("device", "close").contains(method.getName()))
                .toList();
    }

    private static GuardedPipeline failingWith(Throwable cause) {
        return new GuardedPipeline((Pipeline) Proxy.newProxyInstance(
                Pipeline.class.getClassLoader(), new Class<?>[] {Pipeline.class}, (proxy, method, arguments) -> {
                    if (method.getName().equals("close")) {
                        return null;
                    }
                    throw cause;
                }));
    }

    private static Object call(Method method, Pipeline pipeline) throws Throwable {
        Object[] nothing = Arrays.stream(method.getParameterTypes())
                .map(type -> type == int.class ? (Object) 1 : null)
                .toArray();
        try {
            return method.invoke(pipeline, nothing);
        } catch (InvocationTargetException e) {
            throw e.getCause();
        }
    }

    @ParameterizedTest
    @MethodSource("calls")
    void whatACallThrowsIsPassedOnAndRemembered(Method method) {
        for (Throwable cause : new Throwable[] {new IllegalStateException("lost"), new OutOfMemoryError("none left")}) {
            GuardedPipeline pipeline = failingWith(cause);
            assertThat(pipeline.failure()).isNull();
            assertThat(catchThrowable(() -> call(method, pipeline))).isSameAs(cause);
            assertThat(pipeline.failure()).isSameAs(cause);
            assertThatCode(pipeline::close).doesNotThrowAnyException();
        }
    }

    @ParameterizedTest
    @MethodSource("calls")
    void whatACallGivesIsPassedOn(Method method) throws Throwable {
        Pipeline inner = (Pipeline) Proxy.newProxyInstance(
                Pipeline.class.getClassLoader(),
                new Class<?>[] {Pipeline.class},
                (proxy, called, arguments) -> called.getReturnType() == long.class
                        ? (Object) (long) called.getName().hashCode()
                        : called.getReturnType() == int.class
                                ? (Object) called.getName().hashCode()
                                : null);
        GuardedPipeline pipeline = new GuardedPipeline(inner);
        assertThat(call(method, pipeline)).isEqualTo(call(method, inner));
        assertThat(pipeline.failure()).isNull();
    }

    @Test
    void theFirstFailureIsTheOneThatIsRemembered() {
        GuardedPipeline pipeline = failingWith(new IllegalStateException());
        Throwable first = catchThrowable(pipeline::hash);
        assertThat(catchThrowable(pipeline::finish)).isNotNull();
        assertThat(pipeline.failure()).isSameAs(first);
    }
}
