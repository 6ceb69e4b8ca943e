package io.github.circles2d.opencl;

import java.io.File;
import java.io.FileInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;

/**
 * OpenCL C source: files of the folder {@code kernels}, joined in a given order, and the constants that the host defines
 * for them. Immutable.
 *
 * <p>The files come out of the library's jar. To develop kernels, name a folder that holds them by the system property
 * {@value #FOLDER_PROPERTY}.
 */
public final class KernelSource {
    /** System property that names a folder to read kernels from instead of the jar. */
    public static final String FOLDER_PROPERTY = "circles2d.kernels";

    private static final String RESOURCES = "/io/github/circles2d/kernels/";

    private final List<String> files;
    private final String text;
    private final List<String> buildOptions;

    private KernelSource(List<String> files, String text, List<String> buildOptions) {
        this.files = files;
        this.text = text;
        this.buildOptions = buildOptions;
    }

    /**
     * Reads source files.
     *
     * @param files paths below the folder {@code kernels}, in the order in which they are to be compiled
     * @return the joined source
     * @throws IllegalArgumentException if there is no such file, it cannot be read, or it is not plain ASCII
     */
    public static KernelSource of(String... files) {
        return new KernelSource(List.of(files), join(files), List.of());
    }

    /**
     * Adds source files.
     *
     * @param more paths below the folder {@code kernels}, to be compiled after those that are there
     * @return a source that has them too
     * @throws IllegalArgumentException if there is no such file, it cannot be read, or it is not plain ASCII
     */
    public KernelSource and(String... more) {
        List<String> all = new ArrayList<>(files);
        all.addAll(List.of(more));
        return new KernelSource(List.copyOf(all), text + join(more), buildOptions);
    }

    private static String join(String... files) {
        StringBuilder text = new StringBuilder();
        for (String file : files) {
            // Joined, not included: #include would look in the current directory first.
            text.append("#line 1 \"")
                    .append(file)
                    .append("\"\n")
                    .append(read(file))
                    .append('\n');
        }
        return text.toString();
    }

    /**
     * Wraps source text that is not in a file.
     *
     * @param name what to call it in messages
     * @param text OpenCL C, plain ASCII
     * @return the source
     */
    public static KernelSource ofText(String name, String text) {
        requireAscii(name, text);
        return new KernelSource(List.of(name), "#line 1 \"" + name + "\"\n" + text, List.of());
    }

    /**
     * Defines a constant for the preprocessor.
     *
     * @param name its name
     * @param value an Integer, Long, Boolean, Float or a String without spaces; a float keeps every bit
     * @return a source that has it too
     */
    public KernelSource define(String name, Object value) {
        List<String> options = new ArrayList<>(buildOptions);
        options.add("-D" + name + "=" + literal(value));
        return new KernelSource(files, text, List.copyOf(options));
    }

    /**
     * Appends another source.
     *
     * @param next what follows
     * @return a source with the files and definitions of both
     */
    public KernelSource and(KernelSource next) {
        List<String> allFiles = new ArrayList<>(files);
        allFiles.addAll(next.files);
        List<String> allOptions = new ArrayList<>(buildOptions);
        allOptions.addAll(next.buildOptions);
        return new KernelSource(List.copyOf(allFiles), text + next.text, List.copyOf(allOptions));
    }

    private static String literal(Object value) {
        if (value instanceof Float) {
            return Float.toHexString((Float) value) + "f";
        }
        if (value instanceof Boolean) {
            return (Boolean) value ? "1" : "0";
        }
        return value.toString();
    }

    String text() {
        return text;
    }

    List<String> buildOptions() {
        return buildOptions;
    }

    /**
     * Identifies what a compiler would be given: equal sources with equal definitions have equal fingerprints, others
     * practically never.
     *
     * @return 16 hexadecimal digits
     */
    public String fingerprint() {
        try {
            MessageDigest digest = MessageDigest.getInstance("SHA-256");
            digest.update(text.getBytes(StandardCharsets.US_ASCII));
            digest.update(String.join(" ", buildOptions).getBytes(StandardCharsets.US_ASCII));
            return HexFormat.of().formatHex(digest.digest(), 0, 8);
        } catch (NoSuchAlgorithmException e) {
            throw new AssertionError("every Java platform has SHA-256", e);
        }
    }

    /** Returns the names of the files. */
    @Override
    public String toString() {
        return String.join(" + ", files);
    }

    private static String read(String file) {
        String folder = System.getProperty(FOLDER_PROPERTY);
        String text = folder == null ? readResource(file) : readFile(folder, file);
        requireAscii(file, text);
        return text;
    }

    /** Not by a channel, which an interrupt may close. */
    private static String readFile(String folder, String file) {
        try (InputStream in = new FileInputStream(new File(folder, file))) {
            return new String(in.readAllBytes(), StandardCharsets.ISO_8859_1);
        } catch (IOException e) {
            throw new IllegalArgumentException(
                    "the system property " + FOLDER_PROPERTY + " is '" + folder
                            + "', but must name a folder that holds the kernel " + file + ": " + e.getMessage(),
                    e);
        }
    }

    private static String readResource(String file) {
        try (InputStream in = KernelSource.class.getResourceAsStream(RESOURCES + file)) {
            if (in == null) {
                throw new IllegalArgumentException("there is no kernel source " + file);
            }
            return new String(in.readAllBytes(), StandardCharsets.ISO_8859_1);
        } catch (IOException e) {
            throw new UncheckedIOException("could not read kernel source " + file, e);
        }
    }

    /** JavaCL passes the number of characters for the number of bytes: one wide letter would cut off the end. */
    private static void requireAscii(String file, String text) {
        for (int i = 0; i < text.length(); i++) {
            if (text.charAt(i) > 127) {
                long line = text.substring(0, i).chars().filter(c -> c == '\n').count() + 1;
                throw new IllegalArgumentException(
                        "kernel source " + file + " must be plain ASCII, but line " + line + " is not");
            }
        }
    }
}
