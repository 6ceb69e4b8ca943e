package io.github.circles2d;

import io.github.circles2d.opencl.Device;

/** What a builder says of the back end of its world. */
final class BackendWish {
    Backend backend = Backend.AUTO;

    /** Instead of a back end; null if none is named. */
    Device device;

    int threads = World.Builder.defaultThreads();
    int capacity = 1024;
    boolean profiling;

    /** Whether the first step on a device waits for the kernels of its fastest plan. Measurements do. */
    boolean waits = Boolean.getBoolean("circles2d.plans.wait");

    /** Whether a world that takes any back end moves while it runs. */
    boolean moving = true;

    /** Whether it does: it stays where steps wait for all kernels. */
    boolean moves() {
        return moving && !waits && !World.Builder.isAndroid();
    }
}
