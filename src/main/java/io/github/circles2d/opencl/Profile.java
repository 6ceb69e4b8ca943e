package io.github.circles2d.opencl;

import com.nativelibs4java.opencl.CLEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/** Sums the device time of kernels by name, from the events of a profiling queue. */
final class Profile {
    private final Map<String, Long> nanos = new TreeMap<>();
    private final List<String> names = new ArrayList<>();
    private final List<CLEvent> events = new ArrayList<>();

    void add(String kernel, CLEvent event) {
        names.add(kernel);
        events.add(event);
    }

    /** Call it when the queue has finished. */
    Map<String, Long> nanosByKernel() {
        for (int i = 0; i < events.size(); i++) {
            CLEvent event = events.get(i);
            nanos.merge(names.get(i), event.getProfilingCommandEnd() - event.getProfilingCommandStart(), Long::sum);
            event.release();
        }
        names.clear();
        events.clear();
        return Map.copyOf(nanos);
    }

    /** Leaves out all so far. Call it when the queue has finished. */
    void forget() {
        release();
        nanos.clear();
    }

    /** Releases the events that nobody asked for. */
    void release() {
        events.forEach(CLEvent::release);
        events.clear();
        names.clear();
    }
}
