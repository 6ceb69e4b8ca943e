package io.github.circles2d.bench.physics;

import io.github.circles2d.bench.results.Numbers;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;

/** Writes the page on the physics: a template, in which {@code {{name}}} stands for what comes from the kept files. */
final class PhysicsPage {
    private static final String TEMPLATE = "/io/github/circles2d/bench/physics.md";

    /** The folder of the files, seen from the page. */
    private static final String LINK = "../bench/results/physics/";

    private PhysicsPage() {}

    /** The page for the files in a folder. */
    static String of(Path folder) throws IOException {
        PhysicsTable table = PhysicsTable.open(folder);
        return template()
                .replace("{{summary}}\n", summary(table.rows()))
                .replace("{{table}}\n", table(table.rows()))
                .replace("{{charts}}\n", charts(folder));
    }

    private static String template() throws IOException {
        try (InputStream file = PhysicsPage.class.getResourceAsStream(TEMPLATE)) {
            return new String(file.readAllBytes(), StandardCharsets.UTF_8);
        }
    }

    private static String summary(List<Map<String, String>> rows) {
        long asked = rows.stream().filter(row -> !row.get("bound").isEmpty()).count();
        long met = rows.stream().filter(row -> row.get("met").equals("yes")).count();
        return "World meets " + met + " of the " + asked + " bounds.\n";
    }

    private static String table(List<Map<String, String>> rows) {
        StringBuilder text = new StringBuilder("| row | scene | figure | World | asked | met | Box2D |\n");
        text.append("|--:|---|---|--:|---|---|--:|\n");
        for (Row row : Rows.ALL) {
            String number = Integer.toString(row.number());
            boolean first = true;
            for (Map<String, String> figure : rows) {
                if (figure.get("row").equals(number)) {
                    text.append(first ? "| " + number + " | **" + row.scene() + "** | | | | | |\n" : "");
                    text.append("| | ").append(figure.get("scene"));
                    text.append(" | ").append(figure.get("figure"));
                    text.append(" | ").append(brief(figure.get("world")));
                    text.append(" | ").append(figure.get("bound"));
                    text.append(" | ").append(figure.get("met").equals("no") ? "**no**" : figure.get("met"));
                    text.append(" | ").append(brief(figure.get("box2d"))).append(" |\n");
                    first = false;
                }
            }
        }
        return text.toString();
    }

    private static String brief(String value) {
        return value.isEmpty() ? "" : Numbers.brief(Numbers.parse(value));
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
