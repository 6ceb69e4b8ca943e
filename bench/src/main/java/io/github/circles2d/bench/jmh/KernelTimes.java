package io.github.circles2d.bench.jmh;

import java.util.Map;
import org.openjdk.jmh.annotations.AuxCounters;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.State;

/** Device time of the three kernels of a step, in microseconds a step, from the driver's own profiling events. */
@AuxCounters(AuxCounters.Type.EVENTS)
@State(Scope.Thread)
public class KernelTimes {
    /** Of {@code update_position}. */
    public double updateMicros;

    /** Of the strategy's {@code detect_..} kernel. */
    public double detectMicros;

    /** Of the strategy's {@code resolve_..} kernel. */
    public double resolveMicros;

    void set(Map<String, Long> nanosBefore, Map<String, Long> nanosAfter, int steps) {
        updateMicros = (micros(nanosAfter, "update_") - micros(nanosBefore, "update_")) / steps;
        detectMicros = (micros(nanosAfter, "detect_") - micros(nanosBefore, "detect_")) / steps;
        resolveMicros = (micros(nanosAfter, "resolve_") - micros(nanosBefore, "resolve_")) / steps;
    }

    private static double micros(Map<String, Long> nanos, String prefix) {
        double micros = 0;
        for (Map.Entry<String, Long> kernel : nanos.entrySet()) {
            if (kernel.getKey().startsWith(prefix)) {
                micros += kernel.getValue() / 1000.0;
            }
        }
        return micros;
    }
}
