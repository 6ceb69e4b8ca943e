package io.github.circles2d;

import io.github.circles2d.calibration.CachePlace;
import io.github.circles2d.calibration.Curve;
import io.github.circles2d.calibration.FrameTimes;
import io.github.circles2d.calibration.MeasuredRow;
import io.github.circles2d.calibration.Timings;
import io.github.circles2d.calibration.Timings.Runner;
import io.github.circles2d.calibration.TimingsFile;
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
import java.util.function.IntFunction;

/**
 * Times of loops, by which {@link PairIndexing#AUTO} chooses. {@link #run} takes them on this machine, and nothing else does. Without a
 * calibration AUTO chooses by rules. World needs none: with {@link Backend#AUTO} it goes by the times of its own steps.
 *
 * <p>The times are kept in a file, for each device with its driver, its kernels and the version of this library; those of another
 * version are not used. The file lies in the user's folder for caches ({@code $XDG_CACHE_HOME} or {@code ~/.cache}, {@code
 * ~/Library/Caches}, {@code %LOCALAPPDATA%}) as {@code circles2d/calibration.txt}, and may be deleted at any time. The system
 * property {@code circles2d.calibration} names another file; {@code off} keeps no file, so that a calibration holds only for
 * the process that made it. If the file is damaged or cannot be read, or the folder for caches cannot be written, the log gets a
 * warning, and there is no error. But if the property names a file that cannot be written, {@link #run} refuses before it measures.
 *
 * <p>Circles2D is timed with crowds that fill 0.62 of an arena, at 1,000 and 8,000 circles with each exact indexing; fewer if it would
 * take long. Times between these sizes are interpolated. Beyond them, the order at the last size holds.
 */
public final class Calibration {
    private static final System.Logger LOG = System.getLogger(Calibration.class.getName());

    static final List<Integer> SIZES = List.of(1_000, 8_000);

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
     * Measures Circles2D on every OpenCL device, and keeps the times. Takes some seconds for each device, and as much memory as 8,000
     * circles; the machine should have nothing else to do. Times that are not clean are taken again, up to three times.
     *
     * @return the times
     * @throws IllegalArgumentException if the system property {@code circles2d.calibration} or {@code circles2d.kernels} names what
     *     cannot be used; nothing has been measured then
     * @throws IllegalStateException if times are not clean, also after they were taken again: loops of a size that are far apart, or
     *     a time that jumps or falls between two sizes, as on a machine that has other work. The message names the row and the
     *     figures. Nothing is kept then, and an older calibration stays
     * @throws OpenClUnavailableException if there is no OpenCL device
     */
    public static Calibration run() {
        CachePlace.findToWrite();
        List<Device> devices = OpenCl.devices();
        OpenCl.refusal().ifPresent(why -> LOG.log(Level.INFO, "the CPU is not calibrated: {0}", why));
        return run(devices);
    }

    /**
     * Measures some OpenCL devices, as {@link #run()} does all, and keeps the times; those of other devices stay. A device that fails
     * is left out, with a warning in the log.
     *
     * @param devices the devices; may be empty
     * @return the times
     * @throws IllegalArgumentException if the system property {@code circles2d.calibration} or {@code circles2d.kernels} names what
     *     cannot be used; nothing has been measured then
     * @throws IllegalStateException if times are not clean, also after they were taken again: loops of a size that are far apart, or
     *     a time that jumps or falls between two sizes, as on a machine that has other work. The message names the row and the
     *     figures. Nothing is kept then, and an older calibration stays
     */
    public static Calibration run(Collection<Device> devices) {
        return run(devices, new FrameMeter(), SIZES);
    }

    /** By any meter and at any sizes, for tests. */
    static synchronized Calibration run(Collection<Device> devices, Meter meter, List<Integer> sizes) {
        Optional<Path> place = CachePlace.findToWrite();
        devices.forEach(Calibration::requireKernels);
        List<Timings.Entry> entries = new ArrayList<>();
        Set<String> names = new HashSet<>();
        for (Device device : List.copyOf(devices)) {
            if (!names.add(Runners.name(device))) {
                continue; // the second of two alike
            }
            try {
                entries.addAll(measure(device, meter, sizes));
            } catch (OpenClException e) {
                LOG.log(Level.WARNING, "{0} is not calibrated: {1}", device.name(), e.getMessage());
            }
        }
        Timings measured = new Timings(entries);
        return new Calibration(measured, save(timings().and(measured), place));
    }

    private static void requireKernels(Device device) {
        IndexingChoice.CANDIDATES.forEach(indexing -> Runners.circles2d(device, indexing));
    }

    private static List<Timings.Entry> measure(Device device, Meter meter, List<Integer> sizes) {
        List<Timings.Entry> entries = new ArrayList<>();
        for (PairIndexing indexing : IndexingChoice.CANDIDATES) {
            Runner runner = Runners.circles2d(device, indexing);
            Curve loops = curve(
                    "Circles2D by " + indexing + " on " + runner.name(),
                    sizes,
                    circles -> meter.loop(device, indexing, circles));
            entries.add(new Timings.Entry(indexing.name(), runner, loops));
        }
        return entries;
    }

    private static Curve curve(String name, List<Integer> sizes, IntFunction<FrameTimes> meter) {
        MeasuredRow row = new MeasuredRow(name, meter);
        for (int circles : sizes) {
            try {
                if (!row.isEmpty() && FrameMeter.LOOPS_IN_ALL * row.curve().millis(circles) > MOST_MILLIS) {
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

    /** {@return the file that keeps these times; empty if it is turned off, or could not be written: the times hold for this process then} */
    public Optional<Path> file() {
        return file;
    }

    /**
     * Returns the times as text for people: a line for each device and indexing, with milliseconds a loop by number of circles.
     *
     * @return some lines
     */
    @Override
    public String toString() {
        StringBuilder text = new StringBuilder("ms a loop, by number of circles");
        for (Timings.Entry entry : timings.entries()) {
            text.append(String.format(Locale.ROOT, "%n%-12s ", entry.indexing()));
            entry.curve()
                    .measured()
                    .forEach((n, millis) -> text.append(String.format(Locale.ROOT, " %,7d: %7.3f", n, millis)));
            text.append("   ").append(entry.runner().name());
        }
        return text.toString();
    }

    /** Takes the times that a calibration is made of. */
    interface Meter {
        /**
         * Times a loop of Circles2D.
         *
         * @param device what to run on
         * @param indexing one of the indexings, not {@link PairIndexing#AUTO}
         * @param circles number of circles
         * @return what loops took
         */
        FrameTimes loop(Device device, PairIndexing indexing, int circles);
    }
}
