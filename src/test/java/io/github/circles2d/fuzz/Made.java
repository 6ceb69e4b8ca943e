package io.github.circles2d.fuzz;

import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;

/** An object that a chain of calls makes: a joint, a chain or an end of a rope. Each call but the first one is of the object before. */
record Made(List<Method> methods, List<Value[]> arguments) implements Value {
    @Override
    public Object find(Player first) {
        return arguments.stream().map(each -> Values.find(each, first)).toArray(Object[][]::new);
    }

    @Override
    public Object on(Player player, Object found) throws Throwable {
        Object object = null;
        for (int k = 0; k < methods.size(); k++) {
            Object[] given = Values.on(arguments.get(k), player, ((Object[][]) found)[k]);
            object = player.api.call(methods.get(k), object, given);
        }
        return object;
    }

    @Override
    public String toString() {
        StringBuilder text = new StringBuilder();
        for (int k = 0; k < methods.size(); k++) {
            Method method = methods.get(k);
            text.append(
                            Modifier.isStatic(method.getModifiers())
                                    ? method.getDeclaringClass().getSimpleName()
                                    : "")
                    .append('.')
                    .append(method.getName())
                    .append(Arrays.stream(arguments.get(k))
                            .map(Value::toString)
                            .collect(Collectors.joining(", ", "(", ")")));
        }
        return text.toString();
    }
}
