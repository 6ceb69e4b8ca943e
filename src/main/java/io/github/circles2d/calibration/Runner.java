package io.github.circles2d.calibration;

/**
 * What loops ran on. Figures of one version say nothing of another.
 *
 * @param name the device, and how it was used; one line
 * @param version everything else that its speed depends on: driver, kernels, library; one line
 */
public record Runner(String name, String version) {
    /**
     * Makes both fit into a field of the file.
     *
     * @param name the device, and how it was used
     * @param version everything else that its speed depends on
     */
    public Runner {
        name = oneLine(name);
        version = oneLine(version);
    }

    private static String oneLine(String text) {
        return text.replaceAll("\\s+", " ").trim();
    }
}
