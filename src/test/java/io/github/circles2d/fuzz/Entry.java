package io.github.circles2d.fuzz;

import java.lang.reflect.Method;
import java.util.function.Function;

/**
 * A method that programs call.
 *
 * @param weight how often, beside the others
 * @param method the method
 * @param receiver draws the object; null if the method is static
 * @param parameters how the parameters get their values
 */
record Entry(int weight, Method method, Function<Draw, Value> receiver, Drawn[] parameters) {
    private static final int CHECKED = 5;

    Line draw(Draw draw) {
        Value[] arguments = new Value[parameters.length];
        for (int k = 0; k < parameters.length; k++) {
            arguments[k] = parameters[k].draw().apply(draw);
        }
        return new Line(method, receiver == null ? null : receiver.apply(draw), arguments, draw.oneOf(CHECKED));
    }
}
