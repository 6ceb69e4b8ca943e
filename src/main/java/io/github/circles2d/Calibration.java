package io.github.circles2d;

import io.github.circles2d.calibration.CachePlace;
import io.github.circles2d.calibration.Crowd;
import io.github.circles2d.calibration.Curve;
import io.github.circles2d.calibration.CurvesByRatio;
import io.github.circles2d.calibration.FrameTimes;
import io.github.circles2d.calibration.MeasuredRow;
import io.github.circles2d.calibration.Runner;
import io.github.circles2d.calibration.Timings;
import io.github.circles2d.calibration.TimingsFile;
import io.github.circles2d.calibration.Workload;
import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.DeviceMemoryException;
import io.github.circles2d.opencl.OpenCl;
import io.github.circles2d.opencl.OpenClException;
import io.github.circles2d.opencl.OpenClUnavailableException;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.System.Logger.Level;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.function.IntFunction;

/**
 * Times of frames, by which {@link Backend#AUTO} and {@link PairIndexing#AUTO} choose. {@link #run} takes them on this machine, and
 * nothing else does. Without a calibration AUTO chooses by rules.
 *
 * <p>The times are kept in a file, for each device with its driver, its kernels and the version of this library; those of another
 * version are not used. The file lies in the user's folder for caches ({@code $XDG_CACHE_HOME} or {@code ~/.cache}, {@code
 * ~/Library/Caches}, {@code %LOCALAPPDATA%}) as {@code circles2d/calibration.txt}, and may be deleted at any time. The system
 * property {@code circles2d.calibration} names another file; {@code off} keeps no file, so that a calibration holds only for
 * the process that made it. If the file is damaged or cannot be read, or the folder for caches cannot be written, the log gets a
 * warning, and there is no error. But if the property names a file that cannot be written, {@link #run} refuses before it measures.
 *
 * <p>Crowds that fill 0.62 of an arena are timed at a few sizes: World, on the JVM and on GPUs, at 250, 1,000, 3,000, 10,000, 30,000
 * and 100,000 circles, with like radii and with radii of 1:3, 1:10 and 1:100; Circles2D, on every OpenCL device, at 1,000 and 8,000
 * with each exact indexing; fewer if it would take long. Times between these sizes and ratios are interpolated. Beyond them, the order
 * at the last size and ratio holds. {@link World.Builder#capacity} and {@link World.Builder#radii} say which of these times count for a
 * world. A world unlike those crowds (a thousand circles in one point, one boulder in sand) may be faster elsewhere.
 */
public final class Calibration {
    private static final System.Logger LOG = System.getLogger(Calibration.class.getName());

    static final List<Integer> WORLD_SIZES = List.of(250, 1_000, 3_000, 10_000, 30_000, 100_000);
    static final List<Integer> CIRCLES2D_SIZES = List.of(1_000, 8_000);

    /** Greatest radius over least of the crowds that World is timed with. Up to some ratio radii count as alike: 3 may be below it. */
    static final List<Double> RATIOS = List.of(Crowd.LIKE, 3.0, 10.0, 100.0);

    /** A size is left out where the one before it tells that it would take longer. */
    private static final double MOST_MILLIS = 5_000;

    /** What could not be saved holds for this process. */
    private static volatile Timings unsaved = Timings.NONE;

    private final Timings timings;
    private final Optional<Path> file;

    private Calibration(Timings timings, Optional<Path> file) {
        this.timings = timings;
        this.file = file;
    }

    /**
     * Measures World on the JVM and on GPUs, and Circles2D on every OpenCL device, and keeps the times. World is not timed by OpenCL
     * on a CPU, which {@link Backend#AUTO} never takes. Takes about half a minute for the JVM and for each device, and as much memory
     * as 100,000 circles in a World or 8,000 in a Circles2D; the machine should have nothing else to do. Without any OpenCL device it
     * measures the JVM. Times that are not clean are taken again, up to three times.
     *
     * @return the times
     * @throws IllegalArgumentException if the system property {@code circles2d.calibration} or {@code circles2d.kernels} names what
     *     cannot be used; nothing has been measured then
     * @throws IllegalStateException if times are not clean, also after they were taken again: frames of a size that are far apart, or
     *     a time that jumps or falls between two sizes, as on a machine that has other work. The message names the row and the
     *     figures. Nothing is kept then, and an older calibration stays
     */
    public static Calibration run() {
        CachePlace.findToWrite();
        return run(devices());
    }

    /** Every device that can be used. */
    static List<Device> devices() {
        try {
            List<Device> devices = OpenCl.devices();
            OpenCl.refusal().ifPresent(why -> LOG.log(Level.INFO, "the CPU is not calibrated for OpenCL: {0}", why));
            return devices;
        } catch (OpenClUnavailableException e) {
            LOG.log(Level.INFO, "no OpenCL device is calibrated: {0}", e.getMessage());
            return List.of();
        }
    }

    /**
     * Measures the JVM and some OpenCL devices, as {@link #run()} does all, and keeps the times; those of other devices stay. A device
     * that fails is left out, with a warning in the log.
     *
     * @param devices the devices; may be empty
     * @return the times
     * @throws IllegalArgumentException if the system property {@code circles2d.calibration} or {@code circles2d.kernels} names what
     *     cannot be used; nothing has been measured then
     * @throws IllegalStateException if times are not clean, also after they were taken again: frames of a size that are far apart, or
     *     a time that jumps or falls between two sizes, as on a machine that has other work. The message names the row and the
     *     figures. Nothing is kept then, and an older calibration stays
     */
    public static Calibration run(Collection<Device> devices) {
        return run(devices, new FrameMeter(), WORLD_SIZES, CIRCLES2D_SIZES);
    }

    /** By any meter and at any sizes, for tests. */
    static synchronized Calibration run(
            Collection<Device> devices, Meter meter, List<Integer> worldSizes, List<Integer> circles2dSizes) {
        Optional<Path> place = CachePlace.findToWrite();
        devices.forEach(Calibration::requireKernels);
        List<Timings.Entry> entries = new ArrayList<>();
        Runner jvm = Runners.jvm(World.Builder.defaultThreads());
        entries.addAll(worlds(jvm, worldSizes, crowd -> meter.world(Optional.empty(), crowd)));
        Set<String> names = new HashSet<>();
        for (Device device : List.copyOf(devices)) {
            if (!names.add(Runners.name(device))) {
                continue; // the second of two alike
            }
            try {
                entries.addAll(measure(device, meter, worldSizes, circles2dSizes));
            } catch (OpenClException e) {
                LOG.log(Level.WARNING, "{0} is not calibrated: {1}", device.name(), e.getMessage());
            }
        }
        Timings measured = new Timings(entries);
        return new Calibration(measured, save(others(devices).and(measured), place));
    }

    private static void requireKernels(Device device) {
        Runners.world(device);
        IndexingChoice.CANDIDATES.forEach(indexing -> Runners.circles2d(device, indexing));
    }

    private static List<Timings.Entry> measure(
            Device device, Meter meter, List<Integer> worldSizes, List<Integer> circles2dSizes) {
        List<Timings.Entry> entries = new ArrayList<>();
        if (OpenClChoice.isCandidate(device)) {
            Runner runner = Runners.world(device);
            entries.addAll(worlds(runner, worldSizes, crowd -> meter.world(Optional.of(device), crowd)));
        }
        for (PairIndexing indexing : IndexingChoice.CANDIDATES) {
            Runner runner = Runners.circles2d(device, indexing);
            Curve loops = curve(
                    Workload.CIRCLES2D,
                    "Circles2D by " + indexing + " on " + runner.name(),
                    circles2dSizes,
                    FrameMeter.LOOPS_IN_ALL,
                    circles -> meter.loop(device, indexing, circles));
            entries.add(new Timings.Entry(Workload.CIRCLES2D, indexing.name(), runner, loops));
        }
        return entries;
    }

    private static List<Timings.Entry> worlds(Runner runner, List<Integer> sizes, Function<Crowd, FrameTimes> meter) {
        List<Timings.Entry> entries = new ArrayList<>();
        for (double ratio : RATIOS) {
            String variant = CurvesByRatio.variant(ratio);
            Curve frames = curve(
                    Workload.WORLD,
                    "World with " + (variant.isEmpty() ? "like radii" : "radii of " + variant) + " on " + runner.name(),
                    sizes,
                    FrameMeter.WORLD_FRAMES_IN_ALL,
                    circles -> meter.apply(new Crowd(circles, ratio)));
            entries.add(new Timings.Entry(Workload.WORLD, variant, runner, frames));
        }
        return entries;
    }

    private static Curve curve(
            Workload workload, String name, List<Integer> sizes, int frames, IntFunction<FrameTimes> meter) {
        MeasuredRow row = new MeasuredRow(workload, name, meter);
        for (int circles : sizes) {
            try {
                if (!row.isEmpty() && frames * row.curve().millis(circles) > MOST_MILLIS) {
                    break;
                }
                row.measure(circles);
            } catch (DeviceMemoryException e) {
                if (row.isEmpty()) {
                    throw e;
                }
                break;
            }
        }
        return row.curve();
    }

    /** What is known without the times of World on devices that it is not timed on: versions that did so have left them. */
    private static Timings others(Collection<Device> devices) {
        Timings known = timings();
        for (Device device : devices) {
            known = OpenClChoice.isCandidate(device) ? known : known.without(Workload.WORLD, Runners.name(device));
        }
        return known;
    }

    /** Saves and returns the file; none where there is none or it cannot be written. */
    private static Optional<Path> save(Timings all, Optional<Path> place) {
        if (place.isPresent()) {
            try {
                TimingsFile.write(place.get(), all);
                unsaved = Timings.NONE;
                LOG.log(Level.INFO, "calibration saved in {0}", place.get());
                return place;
            } catch (IOException | SecurityException e) {
                LOG.log(
                        Level.WARNING,
                        "the calibration holds for this process alone, because it cannot be saved in {0}: {1}",
                        place.get(),
                        e.toString());
            }
        }
        unsaved = all;
        return Optional.empty();
    }

    /**
     * Forgets all times: from now on the rules hold again.
     *
     * @throws UncheckedIOException if the file is there and cannot be deleted
     * @throws IllegalArgumentException if the system property {@code circles2d.calibration} names what cannot be a file
     */
    public static synchronized void forget() {
        unsaved = Timings.NONE;
        Optional<Path> place = CachePlace.find();
        if (place.isPresent()) {
            try {
                if (Files.exists(place.get())) {
                    Files.delete(place.get());
                }
            } catch (IOException e) {
                throw new UncheckedIOException("cannot delete the calibration " + place.get(), e);
            }
        }
    }

    /** What is known; nothing where the file cannot be used. */
    static Timings timings() {
        Timings here = unsaved;
        if (!here.entries().isEmpty()) {
            return here;
        }
        Optional<Path> place;
        try {
            place = CachePlace.find();
        } catch (IllegalArgumentException e) {
            LOG.log(Notice.level(Level.WARNING, e.getMessage()), "no calibration is used: {0}", e.getMessage());
            return Timings.NONE;
        }
        if (place.isPresent()) {
            try {
                return TimingsFile.read(place.get());
            } catch (IOException | SecurityException e) {
                LOG.log(
                        Notice.level(Level.WARNING, place.get() + e.getMessage()),
                        "the calibration in {0} is not used: {1}",
                        place.get(),
                        e.getMessage());
            }
        }
        return Timings.NONE;
    }

    /**
     * Returns the file that keeps these times.
     *
     * @return the file; empty if it is turned off, or could not be written: the times hold for this process then
     */
    public Optional<Path> file() {
        return file;
    }

    /**
     * Returns the times as text for people: a line for each device and way, with milliseconds a frame by number of circles.
     *
     * @return some lines
     */
    @Override
    public String toString() {
        StringBuilder text = new StringBuilder("ms a frame, by number of circles");
        for (Timings.Entry entry : timings.entries()) {
            text.append(String.format(
                    Locale.ROOT,
                    "%n%-9s %-12s ",
                    entry.workload() == Workload.WORLD ? "World" : "Circles2D",
                    entry.variant()));
            entry.curve()
                    .measured()
                    .forEach((n, millis) -> text.append(String.format(Locale.ROOT, " %,7d: %7.3f", n, millis)));
            text.append("   ").append(entry.runner().name());
        }
        return text.toString();
    }
}
