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
import java.util.Collections;
import java.util.HexFormat;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * OpenCL C source: files of the folder {@code kernels}, each behind those that it uses, and the constants that the host
 * defines for them. Immutable.
 *
 * <p>A file names the files that it uses in lines such as {@code // uses: world/shared/Contact.cl world/stages/World.cl}. A
 * source has each file once.
 *
 * <p>The files come out of the library's jar. To develop kernels, name a folder that holds them by the system property
 * {@value #FOLDER_PROPERTY}.
 */
public final class KernelSource {
    /** System property that names a folder to read kernels from instead of the jar. */
    public static final String FOLDER_PROPERTY = "circles2d.kernels";

    private static final String RESOURCES = "/io/github/circles2d/kernels/";

    private static final Pattern USES = Pattern.compile("^// uses: (.*)$", Pattern.MULTILINE);

    /** Texts by the names of their files, in the order in which they are compiled. */
    private final Map<String, String> files;

    private final List<String> buildOptions;

    private KernelSource(Map<String, String> files, List<String> buildOptions) {
        this.files = Collections.unmodifiableMap(files);
        this.buildOptions = buildOptions;
    }

    /**
     * Reads source files, and those that they use.
     *
     * @param files paths below the folder {@code kernels}
     * @return the files in this order, each behind those that it uses
     * @throws IllegalArgumentException if there is no such file, it cannot be read, it is not plain ASCII, or it uses itself
     */
    public static KernelSource of(String... files) {
        return new KernelSource(Map.of(), List.of()).and(files);
    }

    /**
     * Adds source files, and those that they use.
     *
     * @param more paths below the folder {@code kernels}, to be compiled after those that are there
     * @return a source that has them too
     * @throws IllegalArgumentException if there is no such file, it cannot be read, it is not plain ASCII, or it uses itself
     */
    public KernelSource and(String... more) {
        Map<String, String> all = new LinkedHashMap<>(files);
        for (String file : more) {
            add(file, all, new ArrayList<>());
        }
        return new KernelSource(all, buildOptions);
    }

    /** Adds a file behind those that it uses. users: the files that led here. */
    private static void add(String file, Map<String, String> files, List<String> users) {
        if (users.contains(file)) {
            String ring = String.join(" uses ", users.subList(users.indexOf(file), users.size()));
            throw new IllegalArgumentException("kernel sources use each other in a ring: " + ring + " uses " + file);
        }
        if (files.containsKey(file)) {
            return;
        }
        String text = read(file, users);
        users.add(file);
        Matcher uses = USES.matcher(text);
        while (uses.find()) {
            for (String used : uses.group(1).split(" ")) {
                add(used, files, users);
            }
        }
        users.remove(users.size() - 1);
        // Joined, not included: #include would look in the current directory first.
        files.put(file, "#line 1 \"" + file + "\"\n" + text + "\n");
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
        return new KernelSource(Map.of(name, "#line 1 \"" + name + "\"\n" + text), List.of());
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
        return new KernelSource(files, List.copyOf(options));
    }

    /**
     * Appends another source.
     *
     * @param next what follows
     * @return a source with the files and definitions of both; a file that both have comes once
     * @throws IllegalArgumentException if both have a file of one name, but not the same
     */
    public KernelSource and(KernelSource next) {
        Map<String, String> allFiles = new LinkedHashMap<>(files);
        next.files.forEach((file, text) -> {
            if (!text.equals(allFiles.getOrDefault(file, text))) {
                throw new IllegalArgumentException("two different kernel sources are named " + file);
            }
            allFiles.put(file, text);
        });
        List<String> allOptions = new ArrayList<>(buildOptions);
        allOptions.addAll(next.buildOptions);
        return new KernelSource(allFiles, List.copyOf(allOptions));
    }

    /** A source of another text, with the same definitions. */
    KernelSource withText(String text) {
        return new KernelSource(Map.of(toString(), text), buildOptions);
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
        return String.join("", files.values());
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
            digest.update(text().getBytes(StandardCharsets.US_ASCII));
            digest.update(String.join(" ", buildOptions).getBytes(StandardCharsets.US_ASCII));
            return HexFormat.of().formatHex(digest.digest(), 0, 8);
        } catch (NoSuchAlgorithmException e) {
            throw new AssertionError("every Java platform has SHA-256", e);
        }
    }

    /** Returns the names of the files. */
    @Override
    public String toString() {
        return String.join(" + ", files.keySet());
    }

    private static String read(String file, List<String> users) {
        String folder = System.getProperty(FOLDER_PROPERTY);
        String user = users.isEmpty() ? "" : ", which " + users.get(users.size() - 1) + " uses";
        String text = folder == null ? readResource(file, user) : readFile(folder, file, user);
        requireAscii(file, text);
        return text;
    }

    /** Not by a channel, which an interrupt may close. */
    private static String readFile(String folder, String file, String user) {
        try (InputStream in = new FileInputStream(new File(folder, file))) {
            return new String(in.readAllBytes(), StandardCharsets.ISO_8859_1);
        } catch (IOException e) {
            throw new IllegalArgumentException(
                    "the system property " + FOLDER_PROPERTY + " is '" + folder
                            + "', but must name a folder that holds the kernel " + file + user + ": " + e.getMessage(),
                    e);
        }
    }

    private static String readResource(String file, String user) {
        try (InputStream in = KernelSource.class.getResourceAsStream(RESOURCES + file)) {
            if (in == null) {
                throw new IllegalArgumentException("there is no kernel source " + file + user);
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
