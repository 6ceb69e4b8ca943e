package io.github.circles2d;

import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * Measures scenes on the JVM back end, and prints the file that the page on the physics is made of: those in which surfaces grip, those of
 * terrain, those of joints, or those of bodies.
 */
final class RowFigures {
    private RowFigures() {}

    public static void main(String[] arguments) {
        PrintStream out = new PrintStream(System.out, true, StandardCharsets.UTF_8);
        out.println("row,figure,exact,box2d,world,least,greatest,met");
        for (FigureRow row : rows(arguments[0])) {
            for (RowFigure f : row.figures().get()) {
                String numbers = String.join(
                        ",",
                        number(f.exact()),
                        number(f.box2d()),
                        number(f.world()),
                        number(f.least()),
                        number(f.greatest()));
                out.printf("%s,\"%s\",%s,%s%n", f.row(), f.what(), numbers, f.met() ? "yes" : "no");
            }
        }
    }

    private static List<FigureRow> rows(String of) {
        List<FigureRow> rows = new ArrayList<>();
        switch (of) {
            case "surfaces" -> {
                rows.addAll(SurfaceRows.all());
                rows.addAll(SurfaceCrowds.slow());
                rows.addAll(SurfaceCrowds.quick());
            }
            case "terrain" -> {
                rows.addAll(TerrainRows.all());
                rows.addAll(TerrainShots.all());
                rows.addAll(TerrainCrowds.slow());
            }
            case "joints" -> {
                rows.addAll(JointRows.all());
                rows.addAll(JointNets.all());
            }
            case "bodies" -> rows.addAll(BodyRows.all());
            default -> throw new IllegalArgumentException("surfaces, terrain, joints or bodies, not " + of);
        }
        return rows;
    }

    private static String number(double value) {
        return Double.isNaN(value) ? "" : String.format(Locale.ROOT, "%.6g", value);
    }
}
