package io.github.circles2d.bench.broadphase;

import io.github.circles2d.bench.report.BroadPhaseCharts;
import io.github.circles2d.bench.results.ResultsFolder;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/**
 * Writes the page: a template, in which {@code {{word word ..}}} stands for what comes from a results folder. Within a
 * sentence these are {@code {{ms SCENE N NAME}}}, {@code {{ratio SCENE N NAME NAME}}} of two times, and a count per circle
 * such as {@code {{tests SCENE N NAME}}}; on a line alone the name of a table, with its n where it has one.
 */
final class BroadPhasePage {
    private static final String TEMPLATE = "/io/github/circles2d/bench/broad-phases.md";
    private static final Pattern PLACE = Pattern.compile("\\{\\{([^}]+)}}\n?");

    private BroadPhasePage() {}

    /** The page for the figures of a folder. */
    static String of(ResultsFolder folder) throws IOException {
        BroadPhaseFigures figures = new BroadPhaseFigures(folder);
        return PLACE.matcher(template())
                .replaceAll(
                        place -> Matcher.quoteReplacement(text(place.group(1).split(" "), figures, folder)
                                + (place.group().endsWith("\n") ? "\n" : "")));
    }

    private static String template() throws IOException {
        try (InputStream file = BroadPhasePage.class.getResourceAsStream(TEMPLATE)) {
            return new String(file.readAllBytes(), StandardCharsets.UTF_8);
        }
    }

    private static String text(String[] words, BroadPhaseFigures figures, ResultsFolder folder) {
        BroadPhaseTables tables = new BroadPhaseTables(figures);
        switch (words[0]) {
            case "machine":
                return folder.machine("processor") + ", " + folder.machine("java");
            case "folder":
                return folder.name();
            case "scenes":
                return tables.scenes();
            case "times":
                return tables.times(Integer.parseInt(words[1]));
            case "counts":
                return tables.counts(Integer.parseInt(words[1]));
            case "world":
                return tables.world();
            case "charts":
                return charts(folder);
            case "ms":
                return figures.brief("median_ms", words[1], words[2], words[3]);
            case "ratio":
                return figures.ratio(words[1], words[2], words[3], words[4]);
            default:
                return figures.perCircle(words[0], words[1], words[2], words[3]);
        }
    }

    private static String charts(ResultsFolder folder) {
        return BroadPhaseCharts.SCENES.stream()
                .map(scene -> "![ns per circle and step on the scene " + scene + "](../bench/results/" + folder.name()
                        + "/" + BroadPhaseCharts.file(scene) + ".svg)")
                .collect(Collectors.joining("\n\n", "", ""));
    }
}
