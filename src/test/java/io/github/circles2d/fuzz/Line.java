package io.github.circles2d.fuzz;

import java.lang.reflect.Method;
import java.util.Arrays;
import java.util.stream.Collectors;

/**
 * A call of a program.
 *
 * @param method what is called
 * @param receiver of which object; null if the method is static
 * @param arguments with what
 * @param checked whether its refusal is compared with the state before
 */
record Line(Method method, Value receiver, Value[] arguments, boolean checked) {
    @Override
    public String toString() {
        String of = receiver == null ? method.getDeclaringClass().getSimpleName() : receiver.toString();
        return Arrays.stream(arguments)
                .map(Value::toString)
                .collect(Collectors.joining(", ", of + "." + method.getName() + "(", ");"));
    }
}
