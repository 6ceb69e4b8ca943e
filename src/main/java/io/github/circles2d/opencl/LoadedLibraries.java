package io.github.circles2d.opencl;

import java.io.BufferedReader;
import java.io.File;
import java.io.FileInputStream;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** The libraries that are part of this process, as Linux lists them in {@code /proc/self/maps}. */
final class LoadedLibraries {
    /** The list of this process. */
    static final File LIST = new File("/proc/self/maps");

    /** A part of a library's file in memory, from {@code start} to before {@code end}. */
    private record Part(long start, long end, File file) {}

    private final List<Part> parts = new ArrayList<>();

    /**
     * Reads a list.
     *
     * @param list {@link #LIST}, or another file of its format
     * @throws IOException if the system does not show it
     */
    LoadedLibraries(File list) throws IOException {
        // Not java.nio.file.Files: its channels fail if the thread has been interrupted.
        try (BufferedReader lines =
                new BufferedReader(new InputStreamReader(new FileInputStream(list), StandardCharsets.ISO_8859_1))) {
            for (String line = lines.readLine(); line != null; line = lines.readLine()) {
                add(line);
            }
        }
    }

    /** Takes a line such as {@code 7f01-7f02 r-xp 00000000 08:01 123   /usr/lib/libc.so.6}. */
    private void add(String line) {
        String[] fields = line.split(" +", 6);
        if (fields.length == 6 && fields[5].startsWith("/")) {
            String[] range = fields[0].split("-");
            parts.add(new Part(
                    Long.parseUnsignedLong(range[0], 16), Long.parseUnsignedLong(range[1], 16), new File(fields[5])));
        }
    }

    /** Returns the file of the first library whose name begins with one of these. */
    Optional<File> file(String... prefixes) {
        return parts.stream()
                .map(Part::file)
                .filter(file -> Stream.of(prefixes).anyMatch(file.getName()::startsWith))
                .findFirst();
    }

    /** Whether an address belongs to a library. */
    boolean contains(String name, long address) {
        return parts.stream()
                .anyMatch(part -> part.file().getName().equals(name)
                        && Long.compareUnsigned(part.start(), address) <= 0
                        && Long.compareUnsigned(address, part.end()) < 0);
    }
}
