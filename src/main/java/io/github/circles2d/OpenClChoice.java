package io.github.circles2d;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.OpenCl;
import io.github.circles2d.opencl.OpenClException;
import io.github.circles2d.opencl.OpenClUnavailableException;
import io.github.circles2d.world.device.DevicePipeline;
import io.github.circles2d.world.shared.Pipeline;

/** Chooses among OpenCL devices and the JVM. */
final class OpenClChoice {
    private static final System.Logger LOG = System.getLogger(World.class.getName());

    /**
     * Worlds with room for fewer circles, if they do not move, run on the JVM, which needs no read-back and starts at
     * once. On an NVIDIA H200 a step of packed circles takes 0.16 ms for 1,250 circles, the fewest of the benchmarks, and 0.21 ms for
     * 15,000; on 16 threads of its host's JVM 0.3 and 1.2 ms.
     */
    private static final int LEAST_FOR_GPU = 1250;

    private OpenClChoice() {}

    /** Takes the device, or the OpenCL back end, that is asked for. */
    static BackendChoice askedFor(BackendWish wish) {
        if (wish.device != null) {
            return openCl(wish.device, wish, "this device was asked for");
        }
        Device device = wish.backend == Backend.OPENCL_CPU ? OpenCl.cpuDevice() : gpu();
        return openCl(device, wish, BackendChoice.ASKED_FOR);
    }

    /** The JVM, from where the world moves to a GPU if that is there, ready and faster. */
    static BackendChoice moving(BackendWish wish) {
        Pipeline home = BackendChoice.jvm(wish);
        RunningChoice running = new RunningChoice(
                home, () -> BackendChoice.jvm(wish), circles -> beside(wish, circles), new FrameRule(), wish.capacity);
        return new BackendChoice(Backend.JVM, home, running.reason(), running);
    }

    private static Pipeline beside(BackendWish wish, int circles) {
        Device gpu = gpu();
        if (!gpu.correctlyRounded()) {
            throw new OpenClUnavailableException(gpu.name() + " does not round correctly, so its results would differ");
        }
        return new DevicePipeline(gpu, Math.max(wish.capacity, circles), wish.profiling, false);
    }

    /** Takes what is the fastest for so many circles, as a rule. */
    static BackendChoice fastest(BackendWish wish) {
        String reason;
        if (wish.capacity < LEAST_FOR_GPU) {
            reason = "no GPU is looked for below a capacity of " + LEAST_FOR_GPU + " circles, and it is "
                    + wish.capacity;
        } else {
            try {
                Device gpu = gpu();
                if (gpu.correctlyRounded()) {
                    return openCl(
                            gpu,
                            wish,
                            "a GPU is the fastest from a capacity of " + LEAST_FOR_GPU + " circles on, as a rule");
                }
                reason = gpu.name() + " does not round correctly, so its results would differ";
            } catch (OpenClException e) {
                reason = "no GPU can be used: " + e.getMessage();
            }
        }
        return BackendChoice.jvm(wish, reason);
    }

    private static Device gpu() {
        Device best = OpenCl.bestDevice();
        if (best.kind() != Device.Kind.GPU) {
            throw new OpenClUnavailableException("no OpenCL device is a GPU; there is " + OpenCl.devices());
        }
        return best;
    }

    private static BackendChoice openCl(Device device, BackendWish wish, String reason) {
        if (!device.correctlyRounded()) {
            LOG.log(
                    System.Logger.Level.WARNING,
                    "{0} does not round divisions and square roots correctly: its results may differ from other devices",
                    device.name());
        }
        Backend backend = device.kind() == Device.Kind.CPU ? Backend.OPENCL_CPU : Backend.OPENCL_GPU;
        return new BackendChoice(
                backend, new DevicePipeline(device, wish.capacity, wish.profiling, wish.waits), reason);
    }
}
