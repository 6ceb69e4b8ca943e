package io.github.circles2d.bench.physics;

import io.github.circles2d.bench.results.Numbers;
import io.github.circles2d.bench.results.Table;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;

/** The figures of all rows, as kept in a CSV file. */
final class PhysicsTable {
    private static final String FILE = "rows.csv";
    private static final List<String> KEYS = List.of("row", "scene", "figure");
    private static final List<String> COLUMNS =
            List.of("row", "scene", "figure", "world", "bound", "met", "box2d", "world_by_seed", "box2d_by_seed");
    private static final String LINE = "%3s  %-66s  %-58s  %10s  %-14s  %-3s  %10s%n";

    private final Path file;
    private final Table table;

    private PhysicsTable(Path file, Table table) {
        this.file = file;
        this.table = table;
    }

    static PhysicsTable open(Path folder) throws IOException {
        Path file = folder.resolve(FILE);
        Table table = new Table(KEYS, COLUMNS);
        if (Files.exists(file)) {
            Table.parse(Files.readString(file, StandardCharsets.UTF_8), KEYS)
                    .rows()
                    .forEach(table::put);
        }
        return new PhysicsTable(file, table);
    }

    /** What is known of a figure; empty if it was not measured. */
    Map<String, String> row(Row row, Case scene, Measure measure) {
        List<Map<String, String>> found =
                table.rows("row", Integer.toString(row.number()), "scene", scene.name(), "figure", measure.what());
        return found.isEmpty() ? Map.of() : found.get(0);
    }

    /** Takes a figure of World, and Box2D's beside it, which may be null, and writes the file. */
    Map<String, String> put(Figure world, Figure box2d) throws IOException {
        Bound bound = world.measure().bound();
        Map<String, String> row = new LinkedHashMap<>();
        row.put("row", Integer.toString(world.row().number()));
        row.put("scene", world.scene().name());
        row.put("figure", world.measure().what());
        row.put("world", Numbers.exact(world.median()));
        row.put("bound", bound.isNone() ? "" : bound.toString());
        row.put("met", bound.isNone() ? "" : world.met() ? "yes" : "no");
        row.put("box2d", box2d == null ? "" : Numbers.exact(box2d.median()));
        row.put("world_by_seed", bySeed(world));
        row.put("box2d_by_seed", box2d == null ? "" : bySeed(box2d));
        table.put(row);
        Files.createDirectories(file.toAbsolutePath().getParent());
        table.save(file);
        return row;
    }

    private static String bySeed(Figure figure) {
        return Arrays.stream(figure.values()).mapToObj(Numbers::exact).collect(Collectors.joining(" "));
    }

    static String header() {
        return String.format(Locale.ROOT, LINE, "row", "scene", "figure", "World", "asked", "met", "Box2D");
    }

    /** A row for the console. */
    static String line(Map<String, String> row) {
        return String.format(
                Locale.ROOT,
                LINE,
                row.get("row"),
                row.get("scene"),
                row.get("figure"),
                row.get("world"),
                row.get("bound"),
                row.get("met").equals("no") ? "NO" : row.get("met"),
                row.get("box2d"));
    }
}
