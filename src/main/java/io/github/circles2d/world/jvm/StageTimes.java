package io.github.circles2d.world.jvm;

import java.util.LinkedHashMap;
import java.util.Map;

/** The time that each stage took so far on the caller's thread, with its waits for other workers. */
final class StageTimes {
    private final boolean measures;
    private final String[] names;
    private final long[] nanos;
    private long last;

    StageTimes(boolean measures, String... names) {
        this.measures = measures;
        this.names = names;
        nanos = new long[names.length];
    }

    void begin() {
        if (measures) {
            last = System.nanoTime();
        }
    }

    /** Counts the time since the last call of this or {@link #begin} for a stage. */
    void end(int stage) {
        if (measures) {
            long now = System.nanoTime();
            nanos[stage] += now - last;
            last = now;
        }
    }

    /** Milliseconds by the stage's name; empty unless it measures. */
    Map<String, Double> millis() {
        Map<String, Double> millis = new LinkedHashMap<>();
        for (int stage = 0; measures && stage < names.length; stage++) {
            millis.put(names[stage], nanos[stage] * 1e-6);
        }
        return millis;
    }
}
