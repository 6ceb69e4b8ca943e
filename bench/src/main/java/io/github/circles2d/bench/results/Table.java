package io.github.circles2d.bench.results;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/** A CSV file (RFC 4180, with a header line): rows of named texts, of which some columns are the key. */
public final class Table {
    /** A field in quotes, or without, and what ends it. */
    private static final Pattern FIELD = Pattern.compile("\\G(?:\"((?:[^\"]++|\"\")*+)\"|([^,\"\r\n]*+))\r?([,\n])");

    private final List<String> columns;
    private final List<String> keys;
    private final List<Map<String, String>> rows = new ArrayList<>();

    /**
     * Creates an empty table.
     *
     * @param keys the columns that tell rows apart
     * @param columns all columns, in order
     */
    public Table(List<String> keys, List<String> columns) {
        if (!columns.containsAll(keys)) {
            throw new IllegalArgumentException("keys " + keys + " are not among the columns " + columns);
        }
        this.keys = List.copyOf(keys);
        this.columns = List.copyOf(columns);
    }

    /** The rows of a file; none if there is no such file. */
    public static List<Map<String, String>> rowsOf(Path file, List<String> keys) {
        try {
            return Files.exists(file)
                    ? parse(Files.readString(file, StandardCharsets.UTF_8), keys)
                            .rows()
                    : List.of();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** A row, or a part of one: column, value, column, value, .. */
    public static Map<String, String> columns(String... namesAndValues) {
        Map<String, String> columns = new LinkedHashMap<>();
        for (int i = 0; i < namesAndValues.length; i += 2) {
            columns.put(namesAndValues[i], namesAndValues[i + 1]);
        }
        return columns;
    }

    /** The names of the columns, in order. */
    public List<String> columns() {
        return columns;
    }

    /** The rows, in the order in which they came; unmodifiable. */
    public List<Map<String, String>> rows() {
        return Collections.unmodifiableList(rows);
    }

    /** The rows in which the columns named have the values given: column, value, column, value, .. */
    public List<Map<String, String>> rows(String... wanted) {
        return rows.stream().filter(row -> has(row, wanted)).collect(Collectors.toCollection(ArrayList::new));
    }

    /** The first of those rows, or null if there is none. */
    public Map<String, String> row(String... wanted) {
        return rows.stream().filter(row -> has(row, wanted)).findFirst().orElse(null);
    }

    /** The different values that those rows have in a column, in the order of the rows. */
    public List<String> values(String column, String... wanted) {
        return rows(wanted).stream().map(row -> row.get(column)).distinct().toList();
    }

    private static boolean has(Map<String, String> row, String... wanted) {
        for (int i = 0; i < wanted.length; i += 2) {
            if (!wanted[i + 1].equals(row.get(wanted[i]))) {
                return false;
            }
        }
        return true;
    }

    /** Adds a row, in the place of the one with the same key where there is one. Columns that it lacks stay empty. */
    public void put(Map<String, String> row) {
        if (!columns.containsAll(row.keySet())) {
            throw new IllegalArgumentException("row " + row + " has other columns than " + columns);
        }
        Map<String, String> full = new LinkedHashMap<>();
        for (String column : columns) {
            full.put(column, row.getOrDefault(column, ""));
        }
        for (int i = 0; i < rows.size(); i++) {
            if (key(rows.get(i)).equals(key(full))) {
                rows.set(i, full);
                return;
            }
        }
        rows.add(full);
    }

    /** The key of a row. */
    public List<String> key(Map<String, String> row) {
        return keys.stream().map(row::get).toList();
    }

    /** Writes the file; a reader sees the old or the new one, never half of it. */
    public void save(Path file) throws IOException {
        StringBuilder text = new StringBuilder();
        line(columns, text);
        for (Map<String, String> row : rows) {
            line(row.values(), text);
        }
        replace(file, text.toString());
    }

    /**
     * Reads a file that {@link #save} wrote into an empty table. Columns that the table does not have are left out, so that
     * files of an earlier version can still be read.
     */
    static Table read(Path file, Table table) throws IOException {
        List<List<String>> lines = lines(Files.readString(file, StandardCharsets.UTF_8));
        if (lines.isEmpty() || !lines.get(0).containsAll(table.keys)) {
            throw new IOException(file + " does not begin with a line that names " + table.keys);
        }
        for (List<String> line : lines.subList(1, lines.size())) {
            if (line.size() != lines.get(0).size()) {
                throw new IOException(file + ": " + line + " has not as many fields as the first line");
            }
        }
        table.putAll(lines);
        return table;
    }

    /** Reads a file that is part of the program. */
    public static Table ofResource(String name, List<String> keys) {
        return parse(Resources.text(name), keys);
    }

    /** Reads CSV text whose first line names the columns. */
    public static Table parse(String text, List<String> keys) {
        List<List<String>> lines = lines(text);
        Table table = new Table(keys, lines.get(0));
        table.putAll(lines);
        return table;
    }

    private void putAll(List<List<String>> lines) {
        List<String> header = lines.get(0);
        for (List<String> line : lines.subList(1, lines.size())) {
            Map<String, String> row = new LinkedHashMap<>();
            for (int i = 0; i < line.size(); i++) {
                if (columns.contains(header.get(i))) {
                    row.put(header.get(i), line.get(i));
                }
            }
            put(row);
        }
    }

    /** Writes a text file by way of a temporary one beside it. */
    static void replace(Path file, String text) throws IOException {
        Path fresh = file.resolveSibling(file.getFileName() + ".new");
        Files.writeString(fresh, text, StandardCharsets.UTF_8);
        Files.move(fresh, file, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
    }

    private static void line(Iterable<String> fields, StringBuilder text) {
        String separator = "";
        for (String field : fields) {
            text.append(separator);
            if (field.matches("(?s).*[\",\r\n].*")) {
                text.append('"').append(field.replace("\"", "\"\"")).append('"');
            } else {
                text.append(field);
            }
            separator = ",";
        }
        text.append('\n');
    }

    private static List<List<String>> lines(String text) {
        List<List<String>> lines = new ArrayList<>();
        List<String> line = new ArrayList<>();
        Matcher field = FIELD.matcher(text);
        while (field.find()) {
            String quoted = field.group(1);
            line.add(quoted == null ? field.group(2) : quoted.replace("\"\"", "\""));
            if (field.group(3).equals("\n")) {
                lines.add(line);
                line = new ArrayList<>();
            }
        }
        return lines;
    }
}
