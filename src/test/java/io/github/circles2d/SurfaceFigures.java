package io.github.circles2d;

import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Measures all scenes in which surfaces grip on the JVM back end, and prints the file that the page on the physics is made of. */
final class SurfaceFigures {
    private SurfaceFigures() {}

    public static void main(String[] arguments) {
        PrintStream out = new PrintStream(System.out, true, StandardCharsets.UTF_8);
        out.println("row,figure,exact,box2d,world,least,greatest,met");
        List<SurfaceRows.Row> rows = new ArrayList<>(SurfaceRows.all());
        rows.addAll(SurfaceCrowds.slow());
        rows.addAll(SurfaceCrowds.quick());
        for (SurfaceRows.Row row : rows) {
            for (SurfaceFigure f : row.figures().get()) {
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

    private static String number(double value) {
        return Double.isNaN(value) ? "" : String.format(Locale.ROOT, "%.6g", value);
    }
}
