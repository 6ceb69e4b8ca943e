package io.github.circles2d.world.circles;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.world.model.Bounds;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.RecordComponent;
import java.util.Arrays;
import org.junit.jupiter.api.Test;

/** A parameter that the comparison forgot would be missing in snapshots. */
class WorldParametersTest {
    private static final Bounds BOUNDS = new Bounds(0, 0, 1, 1);

    @Test
    void theComparisonSeesAChangeOfEachComponent() throws ReflectiveOperationException {
        Class<?>[] types = Arrays.stream(WorldParameters.class.getRecordComponents())
                .map(RecordComponent::getType)
                .toArray(Class<?>[]::new);
        Method has = WorldParameters.class.getMethod("has", types);
        WorldParameters some = new WorldParameters(BOUNDS, 1, 2, 0.5f, 4, 0);
        Object[] values = new Object[types.length];
        for (int k = 0; k < types.length; k++) {
            values[k] =
                    WorldParameters.class.getRecordComponents()[k].getAccessor().invoke(some);
        }
        assertThat(has.invoke(some, values)).isEqualTo(true);
        for (int k = 0; k < types.length; k++) {
            assertThat(has.invoke(some, changed(values, k)))
                    .as("component %d", k)
                    .isEqualTo(false);
        }
    }

    private static Object[] changed(Object[] values, int k) throws InvocationTargetException {
        Object[] changed = values.clone();
        if (values[k] instanceof Float f) {
            changed[k] = f + 1;
        } else if (values[k] instanceof Integer i) {
            changed[k] = i + 1;
        } else if (values[k] instanceof Boolean b) {
            changed[k] = !b;
        } else {
            changed[k] = null;
        }
        return changed;
    }
}
