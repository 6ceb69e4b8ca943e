package io.github.circles2d;

import io.github.circles2d.calibration.Crowd;
import io.github.circles2d.calibration.Curve;
import io.github.circles2d.calibration.CurvesByRatio;
import io.github.circles2d.calibration.Pick;
import io.github.circles2d.calibration.Timings;
import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.OpenCl;
import io.github.circles2d.opencl.OpenClException;
import io.github.circles2d.opencl.OpenClUnavailableException;
import io.github.circles2d.world.device.DevicePipeline;
import io.github.circles2d.world.shared.Pipeline;
import java.io.UncheckedIOException;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Chooses among OpenCL devices and the JVM, by measured times or by a rule. */
final class OpenClChoice {
    private static final System.Logger LOG = System.getLogger(World.class.getName());

    /**
     * Where nothing has been calibrated, worlds with room for fewer circles run on the JVM, which needs no read-back and starts at
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
        FrameRule rule = new FrameRule();
        RunningChoice running = new RunningChoice(
                home, () -> BackendChoice.jvm(wish), circles -> beside(wish, circles, rule), rule, wish.capacity);
        return new BackendChoice(Backend.JVM, home, running.reason(), running);
    }

    private static Pipeline beside(BackendWish wish, int circles, FrameRule rule) {
        Device gpu = gpu();
        if (!gpu.correctlyRounded()) {
            throw new OpenClUnavailableException(gpu.name() + " does not round correctly, so its results would differ");
        }
        curvesOf(gpu, Calibration.timings())
                .map(curves -> CurvesByRatio.at(wish.crowd().ratio(), Map.of(true, curves)))
                .ifPresent(curves -> rule.expect(1e6 * curves.get(true).millis(circles), circles));
        return new DevicePipeline(gpu, Math.max(wish.capacity, circles), wish.profiling, false);
    }

    /** Takes the fastest of all devices and the JVM. */
    static BackendChoice fastest(BackendWish wish) {
        Crowd crowd = wish.crowd();
        Timings timings = Calibration.timings();
        if (timings.entries().isEmpty()) {
            return byRule(wish, "; not calibrated: Calibration.run() would measure it");
        }
        Optional<CurvesByRatio> jvm = timings.world(Runners.jvm(wish.threads));
        if (jvm.isEmpty()) {
            return byRule(wish, "; the calibration is not of this Java virtual machine with so many threads");
        }
        Map<Optional<Device>, CurvesByRatio> known = new LinkedHashMap<>();
        known.put(Optional.empty(), jvm.get());
        // Below the rule's threshold no device is looked for, which takes a while, unless one promises to be faster.
        boolean jvmIsFastest = isFastest(jvm.get(), timings, crowd);
        if (crowd.circles() >= LEAST_FOR_GPU || !jvmIsFastest) {
            for (Device device : candidates()) {
                Optional<CurvesByRatio> curves = curvesOf(device, timings);
                curves.ifPresent(found -> known.put(Optional.of(device), found));
                if (curves.isEmpty() && isTheGpuOfTheRule(device)) {
                    String hint =
                            "; the calibration is not of " + device.name() + " with this driver and these kernels";
                    return byRule(wish, hint);
                }
            }
        }
        Pick<Optional<Device>> pick =
                Pick.among(known, crowd, device -> device.map(Device::name).orElse("JVM"));
        String why = pick.reason() + (jvmIsFastest ? "; nothing that was measured is faster" : "");
        if (pick.taken().isEmpty()) {
            return BackendChoice.jvm(wish, why);
        }
        Device device = pick.taken().get();
        try {
            return openCl(device, wish, why);
        } catch (OpenClException e) {
            return BackendChoice.jvm(wish, device.name() + " cannot be used: " + e.getMessage());
        }
    }

    private static boolean isTheGpuOfTheRule(Device device) {
        return device.kind() == Device.Kind.GPU && device == OpenCl.bestDevice();
    }

    /** Whether nothing that was measured, here or on what was here once, is faster. */
    private static boolean isFastest(CurvesByRatio jvm, Timings timings, Crowd crowd) {
        return timings.worlds().stream().allMatch(other -> {
            Map<Boolean, Curve> isJvm = CurvesByRatio.at(crowd.ratio(), Map.of(true, jvm, false, other));
            return isJvm.get(false).millis(crowd.circles()) >= isJvm.get(true).millis(crowd.circles());
        });
    }

    private static Optional<CurvesByRatio> curvesOf(Device device, Timings timings) {
        try {
            return timings.world(Runners.world(device));
        } catch (IllegalArgumentException | UncheckedIOException e) {
            return Optional.empty(); // Kernels that cannot be read: whoever builds them says so.
        }
    }

    /** Whether a device may be taken unasked, if it is fast. On a processor the JVM is faster than OpenCL. */
    static boolean isCandidate(Device device) {
        return device.kind() != Device.Kind.CPU && device.correctlyRounded();
    }

    private static List<Device> candidates() {
        try {
            return OpenCl.devices().stream().filter(OpenClChoice::isCandidate).toList();
        } catch (OpenClException e) {
            return List.of();
        }
    }

    private static BackendChoice byRule(BackendWish wish, String hint) {
        String reason;
        if (wish.capacity < LEAST_FOR_GPU) {
            reason = "no GPU is looked for below a capacity of " + LEAST_FOR_GPU + " circles, and it is "
                    + wish.capacity;
        } else {
            try {
                Device gpu = gpu();
                if (gpu.correctlyRounded()) {
                    String why = "a GPU is the fastest from a capacity of " + LEAST_FOR_GPU + " circles on, as a rule";
                    return openCl(gpu, wish, why + hint);
                }
                reason = gpu.name() + " does not round correctly, so its results would differ";
            } catch (OpenClException e) {
                reason = "no GPU can be used: " + e.getMessage();
            }
        }
        return BackendChoice.jvm(wish, reason + hint);
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
