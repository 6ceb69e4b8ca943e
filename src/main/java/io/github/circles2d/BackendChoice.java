package io.github.circles2d;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.OpenCl;
import io.github.circles2d.opencl.OpenClException;
import io.github.circles2d.opencl.OpenClUnavailableException;
import io.github.circles2d.world.ClPipeline;
import io.github.circles2d.world.JvmPipeline;
import io.github.circles2d.world.Pipeline;

/**
 * What a world runs on, and why.
 *
 * @param backend the back end, never {@link Backend#AUTO}
 * @param pipeline the engine
 * @param reason why it was taken
 */
record BackendChoice(Backend backend, Pipeline pipeline, String reason) {
    private static final System.Logger LOG = System.getLogger(World.class.getName());

    /**
     * Worlds with room for fewer circles run on the JVM, which needs no read-back and starts at once. On an NVIDIA H200 a step of
     * packed circles and a look at its status take 0.2 ms for 1,250 circles and 0.25 ms for 15,000; on 16 threads of its
     * host's JVM 0.7 and 1.4 ms, on one thread 0.2 ms for 300. OpenCL on a CPU is never taken by itself: on two cores it takes
     * two to three times as long as two threads of the JVM.
     */
    private static final int LEAST_FOR_GPU = 2048;

    /** Takes what is asked for, or the fastest that is there. */
    static BackendChoice of(Backend wanted, int threads, int leastShare, int capacity, boolean profiling) {
        return switch (wanted) {
            case JVM -> jvm(threads, leastShare, capacity, profiling, "asked for");
            case OPENCL_CPU -> openCl(wanted, OpenCl.cpuDevice(), capacity, profiling, "asked for");
            case OPENCL_GPU -> openCl(wanted, gpu(), capacity, profiling, "asked for");
            case AUTO -> fastest(threads, leastShare, capacity, profiling);
        };
    }

    /** Takes this very device. */
    static BackendChoice of(Device device, int capacity, boolean profiling) {
        Backend backend = device.kind() == Device.Kind.CPU ? Backend.OPENCL_CPU : Backend.OPENCL_GPU;
        return openCl(backend, device, capacity, profiling, "this device was asked for");
    }

    private static BackendChoice fastest(int threads, int leastShare, int capacity, boolean profiling) {
        String reason;
        if (capacity < LEAST_FOR_GPU) {
            reason = "no GPU is looked for below a capacity of " + LEAST_FOR_GPU + " circles, and it is " + capacity;
        } else {
            try {
                Device gpu = gpu();
                if (gpu.correctlyRounded()) {
                    String why = "the fastest from a capacity of " + LEAST_FOR_GPU + " circles on";
                    return openCl(Backend.OPENCL_GPU, gpu, capacity, profiling, why);
                }
                reason = gpu.name() + " does not round correctly, so its results would differ";
            } catch (OpenClException e) {
                reason = "no GPU can be used: " + e.getMessage();
            }
        }
        return jvm(threads, leastShare, capacity, profiling, reason);
    }

    private static Device gpu() {
        Device best = OpenCl.bestDevice();
        if (best.kind() != Device.Kind.GPU) {
            throw new OpenClUnavailableException("no OpenCL device is a GPU; there is " + OpenCl.devices());
        }
        return best;
    }

    private static BackendChoice openCl(
            Backend backend, Device device, int capacity, boolean profiling, String reason) {
        if (!device.correctlyRounded()) {
            LOG.log(
                    System.Logger.Level.WARNING,
                    "{0} does not round divisions and square roots correctly: its results may differ from other devices",
                    device.name());
        }
        return logged(new BackendChoice(backend, new ClPipeline(device, capacity, profiling), reason));
    }

    private static BackendChoice jvm(int threads, int leastShare, int capacity, boolean profiling, String reason) {
        return logged(
                new BackendChoice(Backend.JVM, new JvmPipeline(threads, leastShare, capacity, profiling), reason));
    }

    private static BackendChoice logged(BackendChoice choice) {
        LOG.log(
                System.Logger.Level.DEBUG,
                "World on {0}, {1}: {2}",
                choice.backend,
                choice.pipeline.device(),
                choice.reason);
        return choice;
    }
}
