package io.github.circles2d.tools;

import io.github.circles2d.Calibration;
import io.github.circles2d.opencl.OpenClUnavailableException;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.Optional;

/**
 * Measures what {@link io.github.circles2d.PairIndexing#AUTO} chooses by, and keeps it, or forgets it.
 *
 * <p>Exit status: 0 if it was kept or forgotten, 1 if not, 2 for a wrong call.
 */
public final class Calibrate {
    private Calibrate() {}

    /**
     * Calibrates this machine.
     *
     * @param args none, or {@code --forget}
     */
    public static void main(String[] args) {
        System.exit(run(System.out, args));
    }

    /**
     * Calibrates this machine.
     *
     * @param out where the times go
     * @param args none, or {@code --forget}
     * @return the exit status
     */
    static int run(PrintStream out, String... args) {
        if (args.length == 1 && args[0].equals("--forget")) {
            return forget(out);
        }
        if (args.length > 0) {
            boolean help = args[0].equals("--help") || args[0].equals("-h");
            out.println(
                    "usage: calibrate [--forget]: measures Circles2D on all OpenCL devices, for PairIndexing.AUTO to choose by;");
            out.println("or forgets what was measured");
            return help ? 0 : 2;
        }
        out.println("measuring: some seconds for each device, best with nothing else to do");
        Calibration calibration;
        try {
            calibration = Calibration.run();
        } catch (IllegalArgumentException | OpenClUnavailableException e) {
            out.println(e.getMessage());
            return 1;
        } catch (IllegalStateException e) {
            out.println("not saved: " + e.getMessage());
            return 1;
        }
        out.println(calibration);
        Optional<Path> file = calibration.file();
        out.println(file.map(path -> "saved in " + path).orElse("not saved: there is no file that could be written"));
        return file.isPresent() ? 0 : 1;
    }

    private static int forget(PrintStream out) {
        try {
            Calibration.forget();
            out.println("forgotten");
            return 0;
        } catch (UncheckedIOException | IllegalArgumentException e) {
            out.println(e.getMessage());
            return 1;
        }
    }
}
