package io.github.circles2d.bench.measure;

import io.github.circles2d.bench.Devices;
import io.github.circles2d.bench.report.Charts;
import io.github.circles2d.bench.report.ConsoleTable;
import io.github.circles2d.bench.results.ResultsFolder;
import io.github.circles2d.bench.results.ResultsFolder.Kind;
import io.github.circles2d.opencl.Device;
import io.github.circles2d.scenes.Scenes;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Does the work one piece after the other, and keeps the results as they come. */
public final class Measurements {
    private final Options options;
    private final PrintStream out;
    private final boolean series;
    private final Map<String, Device> devices = new LinkedHashMap<>();
    private final Pace pace = new Pace();
    private final long start = System.nanoTime();

    private Measurements(Options options, PrintStream out) {
        this.options = options;
        this.out = out;
        series = options.parts().contains(Options.Part.SERIES);
    }

    /**
     * Does what the command line asks, and prints the progress.
     *
     * @throws IllegalArgumentException with a sentence for the user if it is wrong
     */
    public static void run(List<String> arguments, PrintStream out) throws IOException {
        Options options = Options.parse(arguments);
        if (options.help()) {
            out.println(Options.HELP);
        } else if (options.write() != null) {
            SceneFiles.write(options, out);
        } else {
            new Measurements(options, out).run();
        }
    }

    private void run() throws IOException {
        chooseDevices();
        ResultsFolder folder = ResultsFolder.open(options.folder(Machine.name(devices)));
        if (options.take() != null) {
            Outside.take(options.take(), folder, out);
            return;
        }
        List<Work> work = Plan.of(options, devices, folder);
        pace.remember(folder);
        devices.forEach((name, device) -> out.println("device " + name + ": " + device));
        if (options.list()) {
            work.forEach(entry -> out.println(entry.label()));
            return;
        }
        requireNoOtherMeasurement(Path.of(System.getProperty("java.io.tmpdir"), "jmh.lock"));
        out.println(
                work.size() + " runs, about " + duration(secondsLeft(work, 0)) + "; results go to " + folder.path());
        describeMachine(folder);
        Thread whenInterrupted = new Thread(() -> {
            folder.seal();
            out.println();
            out.println("interrupted; what was measured is in " + folder.path());
            ConsoleTable.print(folder, out);
        });
        Runtime.getRuntime().addShutdownHook(whenInterrupted);
        doAll(work, folder);
        if (folder.sealed()) {
            return;
        }
        Runtime.getRuntime().removeShutdownHook(whenInterrupted);
        if (!series) {
            Roof.write(folder);
            ConsoleTable.print(folder, out);
        }
        if (options.charts()) {
            Charts.draw(folder, out);
        }
        out.println("results are in " + folder.path() + ", after " + duration(elapsed()));
    }

    /** JMH would refuse run after run; and two measurements on one machine are none. */
    static void requireNoOtherMeasurement(Path jmhLock) throws IOException {
        if (Boolean.getBoolean("jmh.ignoreLock") || !Files.exists(jmhLock)) {
            return;
        }
        if (isLocked(jmhLock)) {
            throw new IllegalArgumentException("another JMH measurement is under way on this machine (" + jmhLock
                    + " is locked): start again when it has ended");
        }
    }

    private static boolean isLocked(Path file) throws IOException {
        try (FileChannel channel = FileChannel.open(file, StandardOpenOption.WRITE);
                FileLock lock = channel.tryLock()) {
            return lock == null;
        } catch (OverlappingFileLockException e) {
            return true;
        }
    }

    private void chooseDevices() {
        Map<String, Device> all = Devices.all();
        if (all.isEmpty()) {
            out.println("there is no OpenCL device on this machine: only engines that need none are measured");
        }
        if (options.devices().isEmpty()) {
            devices.putAll(all);
        } else {
            options.devices().forEach(name -> devices.put(name, Devices.find(name)));
        }
    }

    /** The series leave what a sweep has said of the machine. */
    private void describeMachine(ResultsFolder folder) throws IOException {
        if (series && !folder.table(Kind.MACHINE).rows().isEmpty()) {
            return;
        }
        Map<String, String> properties = Machine.properties(devices);
        properties.put("seed", Long.toString(Scenes.SEED));
        for (Map.Entry<String, String> property : properties.entrySet()) {
            folder.put(Kind.MACHINE, Map.of("property", property.getKey(), "value", property.getValue()));
        }
    }

    private void doAll(List<Work> work, ResultsFolder folder) throws IOException {
        for (int i = 0; i < work.size() && !folder.sealed(); i++) {
            Work entry = work.get(i);
            String place = String.format("[%" + Integer.toString(work.size()).length() + "d/%d] ", i + 1, work.size());
            out.print(place + entry.label() + ": ");
            out.flush();
            String outcome = entry.run(pace, options.budgetSeconds() - elapsed());
            if (folder.sealed()) {
                return;
            }
            String left = i + 1 == work.size() ? "" : " (about " + duration(secondsLeft(work, i + 1)) + " left)";
            out.println(outcome + left);
        }
    }

    private double secondsLeft(List<Work> work, int from) {
        double seconds = work.subList(from, work.size()).stream()
                .mapToDouble(entry -> entry.seconds(pace))
                .sum();
        return Math.max(0, Math.min(seconds, options.budgetSeconds() - elapsed()));
    }

    private double elapsed() {
        return (System.nanoTime() - start) / 1e9;
    }

    private static String duration(double seconds) {
        return seconds < 90 ? Math.round(seconds) + " s" : Math.round(seconds / 60) + " min";
    }
}
