package io.github.circles2d;

import io.github.circles2d.calibration.Crowd;
import io.github.circles2d.opencl.Device;
import io.github.circles2d.world.model.Limits;

/** What a builder says of the back end of its world, and of the circles that it is to be fast for. */
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

    /** Greatest radius over least. */
    private double ratio = 1;

    /** Takes the radii that are expected. */
    void expectRadii(float least, float greatest) {
        Limits.within("the least radius", least, Limits.LEAST_EXTENT * Limits.LEAST_RADIUS_SHARE, Limits.COORDINATE);
        ratio = (double) Limits.within("the greatest radius", greatest, least, Limits.COORDINATE) / least;
    }

    /** The circles that are expected. */
    Crowd crowd() {
        return new Crowd(capacity, ratio);
    }
}
