package io.github.circles2d.calibration;

import java.io.FileInputStream;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.zip.CRC32;

/**
 * The file that keeps timings: a line for each curve, with tabs between the fields, and a last line with a checksum of all before
 * it, so that a file that was cut off is known for one. The fields are those of {@link Timings.Entry}. It is replaced as a whole, so a reader sees the old one or the new one.
 */
public final class TimingsFile {
    private static final String FIRST_LINE = "circles2d calibration 2";
    private static final String COMMENT =
            "# What PairIndexing.AUTO chooses by: ms by number of circles. Delete this file to forget it.";
    private static final String LAST_LINE = "checksum ";
    private static final int FIELDS = 4;

    /** A file of this library has some hundred bytes a device. */
    private static final long MOST_BYTES = 1 << 20;

    private TimingsFile() {}

    /**
     * What a file has; nothing if there is none. Throws IOException that says what is wrong if it cannot be read, or is
     * not what {@link #write} wrote.
     */
    public static Timings read(Path file) throws IOException {
        if (!Files.exists(file)) {
            return Timings.NONE;
        }
        if (!Files.isRegularFile(file)) {
            throw new IOException("it is not a file");
        }
        if (Files.size(file) > MOST_BYTES) {
            throw new IOException("it has " + Files.size(file) + " bytes, more than any calibration");
        }
        String text;
        // Not by a channel, which an interrupt may close.
        try (InputStream in = new FileInputStream(file.toFile())) {
            text = new String(in.readAllBytes(), StandardCharsets.UTF_8);
        }
        if (!text.startsWith(FIRST_LINE + "\n")) {
            throw new IOException("it does not begin with '" + FIRST_LINE + "'");
        }
        int end = text.lastIndexOf(LAST_LINE);
        if (end < 0 || !text.substring(end).equals(lastLine(text.substring(0, end)))) {
            throw new IOException("it is cut off or damaged: its checksum is missing or wrong");
        }
        List<Timings.Entry> entries = new ArrayList<>();
        for (String line : text.substring(FIRST_LINE.length() + 1, end).split("\n")) {
            if (!line.startsWith("#")) {
                entries.add(parse(line));
            }
        }
        return new Timings(entries);
    }

    private static Timings.Entry parse(String line) throws IOException {
        String[] fields = line.split("\t", -1);
        if (fields.length != FIELDS) {
            throw new IOException("a line of it has " + fields.length + " fields, not " + FIELDS);
        }
        try {
            Map<Integer, Double> millis = new TreeMap<>();
            for (String time : fields[3].split(" ")) {
                int sign = time.indexOf('=');
                millis.put(Integer.valueOf(time.substring(0, sign)), Double.valueOf(time.substring(sign + 1)));
            }
            return new Timings.Entry(fields[0], new Timings.Runner(fields[1], fields[2]), new Curve(millis));
        } catch (IllegalArgumentException | IndexOutOfBoundsException e) {
            throw new IOException("a line of it makes no sense: " + e.getMessage(), e);
        }
    }

    /**
     * Writes a file, in place of what it was, and makes the folder if there is none. If that throws, the file is as it
     * was.
     */
    public static void write(Path file, Timings timings) throws IOException {
        StringBuilder text = new StringBuilder(FIRST_LINE + "\n" + COMMENT + "\n");
        for (Timings.Entry entry : timings.entries()) {
            text.append(entry.indexing()).append('\t');
            text.append(entry.runner().name()).append('\t');
            text.append(entry.runner().version()).append('\t');
            List<String> times = new ArrayList<>();
            entry.curve().measured().forEach((n, millis) -> times.add(n + "=" + millis));
            text.append(String.join(" ", times)).append('\n');
        }
        text.append(lastLine(text.toString()));
        Path whole = createNextTo(file);
        try {
            try (OutputStream out = new FileOutputStream(whole.toFile())) {
                out.write(text.toString().getBytes(StandardCharsets.UTF_8));
            }
            try {
                Files.move(whole, file, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
            } catch (AtomicMoveNotSupportedException e) {
                Files.move(whole, file, StandardCopyOption.REPLACE_EXISTING);
            }
        } finally {
            Files.deleteIfExists(whole);
        }
    }

    /** Makes the folder of a file, and checks that a file can be made there. */
    static void requireWritable(Path file) throws IOException {
        Files.delete(createNextTo(file));
    }

    private static Path createNextTo(Path file) throws IOException {
        Path folder = file.toAbsolutePath().getParent();
        Files.createDirectories(folder);
        return Files.createTempFile(folder, "calibration", ".tmp");
    }

    private static String lastLine(String before) {
        CRC32 sum = new CRC32();
        sum.update(before.getBytes(StandardCharsets.UTF_8));
        return LAST_LINE + Long.toHexString(sum.getValue()) + "\n";
    }
}
