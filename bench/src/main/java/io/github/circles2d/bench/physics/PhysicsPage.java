package io.github.circles2d.bench.physics;

import io.github.circles2d.bench.results.Numbers;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;

/** Writes the page on the physics: a template, in which {@code {{name}}} stands for what comes from the kept files. */
final class PhysicsPage {
    private static final String TEMPLATE = "/io/github/circles2d/bench/physics.md";

    /** The folder of the files, seen from the page. */
    private static final String LINK = "../bench/results/physics/";

    /** Smaller figures are rounding. */
    private static final double LEAST = 1e-6;

    private PhysicsPage() {}

    /** The page for the files in a folder. */
    static String of(Path folder) throws IOException {
        PhysicsTable table = PhysicsTable.open(folder);
        return template()
                .replace("{{summary}}\n", summary(table))
                .replace("{{table}}\n", table(table))
                .replace("{{surfaces}}\n", FigureTable.of(folder, "surfaces.csv"))
                .replace("{{terrain}}\n", FigureTable.of(folder, "terrain.csv"))
                .replace("{{joints}}\n", FigureTable.of(folder, "joints.csv"))
                .replace("{{bodies}}\n", FigureTable.of(folder, "bodies.csv"))
                .replace("{{charts}}\n", charts(folder));
    }

    private static String template() throws IOException {
        try (InputStream file = PhysicsPage.class.getResourceAsStream(TEMPLATE)) {
            return new String(file.readAllBytes(), StandardCharsets.UTF_8);
        }
    }

    private static String summary(PhysicsTable table) {
        int asked = 0;
        int met = 0;
        for (Row row : Rows.ALL) {
            for (Case scene : row.cases()) {
                for (Measure measure : scene.measures()) {
                    String answer = table.row(row, scene, measure).getOrDefault("met", "");
                    asked += answer.isEmpty() ? 0 : 1;
                    met += answer.equals("yes") ? 1 : 0;
                }
            }
        }
        return "World meets " + met + " of the " + asked + " bounds.\n";
    }

    private static String table(PhysicsTable table) {
        StringBuilder text = new StringBuilder("| row | scene | figure | World | asked | met | Box2D |\n");
        text.append("|--:|---|---|--:|---|---|--:|\n");
        for (Row row : Rows.ALL) {
            text.append("| ")
                    .append(row.number())
                    .append(" | **")
                    .append(row.scene())
                    .append("** | | | | | |\n");
            for (Case scene : row.cases()) {
                String name = scene.name();
                for (Measure measure : scene.measures()) {
                    Map<String, String> figure = table.row(row, scene, measure);
                    if (!figure.isEmpty()) {
                        text.append("| | ").append(name).append(line(figure));
                        name = "";
                    }
                }
            }
        }
        return text.toString();
    }

    private static String line(Map<String, String> figure) {
        String met = figure.get("met").equals("no") ? "**no**" : figure.get("met");
        return String.join(
                " | ",
                "",
                figure.get("figure"),
                brief(figure.get("world")),
                figure.get("bound"),
                met,
                brief(figure.get("box2d")) + " |\n");
    }

    private static String brief(String value) {
        if (value.isEmpty()) {
            return "";
        }
        double number = Numbers.parse(value);
        return number != 0 && Math.abs(number) < LEAST ? "< " + Numbers.brief(LEAST) : Numbers.brief(number);
    }

    private static String charts(Path folder) {
        StringBuilder text = new StringBuilder();
        for (Curves.Curve curve : Curves.ALL) {
            if (Files.exists(folder.resolve(curve.name() + ".png"))) {
                text.append("![")
                        .append(curve.title())
                        .append("](")
                        .append(LINK)
                        .append(curve.name())
                        .append(".png)\n\n");
            }
        }
        return text.toString().stripTrailing() + "\n";
    }
}
