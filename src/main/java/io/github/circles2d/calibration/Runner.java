package io.github.circles2d.calibration;

/**
 * What loops ran on, in two lines: the device and how it was used, and everything else that its speed depends on, such
 * as driver, kernels and library. Figures of one version say nothing of another.
 */
public record Runner(String name, String version) {
    /** Makes both fit into a field of the file. */
    public Runner {
        name = oneLine(name);
        version = oneLine(version);
    }

    private static String oneLine(String text) {
        return text.replaceAll("\\s+", " ").trim();
    }
}
