package io.github.circles2d.opencl;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Writes a source as a compiler gets it, for one outside the driver. */
public final class SourceFiles {
    private SourceFiles() {}

    /** Writes {@code name.cl} with the text and {@code name.options} with an option a line. */
    public static void write(KernelSource source, Path folder, String name) throws IOException {
        Files.createDirectories(folder);
        Files.writeString(folder.resolve(name + ".cl"), source.text());
        Files.writeString(folder.resolve(name + ".options"), String.join("\n", source.buildOptions()) + "\n");
    }
}
