package io.github.circles2d.bench.sweep;

import io.github.circles2d.bench.Devices;
import io.github.circles2d.bench.report.Charts;
import io.github.circles2d.bench.report.ConsoleTable;
import io.github.circles2d.bench.results.ResultsFolder;
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
public final class Sweep {
    private final Options options;
    private final PrintStream out;
    private final Map<String, Device> devices = new LinkedHashMap<>();
    private final Pace pace = new Pace();
    private final long start = System.nanoTime();

    private Sweep(Options options, PrintStream out) {
        this.options = options;
        this.out = out;
    }

    /** Runs a sweep and prints its progress and its table. */
    public static void run(Options options, PrintStream out) throws IOException {
        new Sweep(options, out).run();
    }

    private void run() throws IOException {
        chooseDevices();
        String machine = options.machine().isEmpty() ? Machine.name(devices) : options.machine();
        ResultsFolder folder = ResultsFolder.open(options.out().resolve(machine));
        List<Work> work = Plan.of(options, devices, folder);
        Plan.remember(folder, pace);
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
        Roof.write(folder);
        WorldRoof.write(folder);
        ConsoleTable.print(folder, out);
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

    private void describeMachine(ResultsFolder folder) throws IOException {
        Map<String, String> properties = Machine.properties(devices);
        properties.put("seed", Long.toString(Scenes.SEED));
        for (Map.Entry<String, String> property : properties.entrySet()) {
            folder.put(ResultsFolder.Kind.MACHINE, Map.of("property", property.getKey(), "value", property.getValue()));
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
        double seconds = 0;
        for (Work entry : work.subList(from, work.size())) {
            seconds += entry.seconds(pace);
        }
        return Math.max(0, Math.min(seconds, options.budgetSeconds() - elapsed()));
    }

    private double elapsed() {
        return (System.nanoTime() - start) / 1e9;
    }

    private static String duration(double seconds) {
        return seconds < 90 ? Math.round(seconds) + " s" : Math.round(seconds / 60) + " min";
    }
}
