package io.github.circles2d;

import static io.github.circles2d.TerrainBall.DT;
import static io.github.circles2d.TerrainBall.G;

import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;

/** The scenes of many discs on terrain. */
final class TerrainCrowds {
    private static final float PI = (float) Math.PI;

    private TerrainCrowds() {}

    /** Those that take some seconds. */
    static List<FigureRow> quick() {
        return List.of(
                new FigureRow("B12, 10 s", () -> drum(600, 600)),
                new FigureRow("B12, hourglass of 200", () -> hourglass(200, 1800)),
                new FigureRow("B13", () -> lift(100, 1200)));
    }

    /** Those of the page; the drum takes longer. */
    static List<FigureRow> slow() {
        return List.of(
                new FigureRow("B12, 5 min", () -> drum(2000, 18_000)),
                new FigureRow("B12, hourglass", () -> hourglass(1000, 6000)),
                new FigureRow("B13", () -> lift(100, 3600)));
    }

    /** A body that all discs are measured against. */
    @FunctionalInterface
    private interface Depth {
        /** How deep a disc is in terrain; infinite if it is where none should be. */
        double of(double x, double y, double r);
    }

    /** Discs that are lost, and the depth of the deepest one in radii. */
    private static final class Worst {
        private int lost;
        private double depth;

        void look(World world, float[] circles, Depth depths) {
            world.read(circles);
            int beyond = 0;
            for (int i = 0; i < world.size(); i++) {
                double r = circles[4 * i + 2];
                double deep = depths.of(circles[4 * i], circles[4 * i + 1], r) / r;
                if (deep == Double.POSITIVE_INFINITY) {
                    beyond++;
                } else {
                    depth = Math.max(depth, deep);
                }
            }
            lost = Math.max(lost, beyond);
        }

        RowFigure lost(String row, String scene) {
            return RowFigure.within(row, scene + "lost", 0, Double.NaN, 0, lost);
        }

        RowFigure deepest(String row, String scene) {
            return RowFigure.between(row, scene + "greatest depth, r", Double.NaN, 0, 0.1, depth);
        }
    }

    /** How deep a disc is in a segment from (ax, ay) to (bx, by), which has a radius. */
    private static double inSegment(
            double x, double y, double r, double ax, double ay, double bx, double by, double thickness) {
        double dx = bx - ax;
        double dy = by - ay;
        double t = Math.max(0, Math.min(1, ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy)));
        return r + thickness - Math.hypot(x - ax - t * dx, y - ay - t * dy);
    }

    // ---- a drum

    /** A drum with twelve paddles turns, half full. */
    private static List<RowFigure> drum(int discs, int steps) {
        double size = 10 * Math.sqrt(discs / 2000.0);
        float thickness = 0.05f;
        SplittableRandom random = new SplittableRandom(12);
        try (World world = TerrainBall.builder(G, 0.6, 0.2).build()) {
            TerrainBody body = world.terrain().addBody(0, 0, 0);
            body.addArc(0, 0, (float) size, 0, 2 * PI, ArcSide.INNER);
            for (int k = 0; k < 12; k++) {
                float c = (float) (size * Math.cos(k * Math.PI / 6));
                float s = (float) (size * Math.sin(k * Math.PI / 6));
                body.addSegment(0.7f * c, 0.7f * s, 0.98f * c, 0.98f * s, thickness, 0);
            }
            for (int i = 0; i < discs; i++) {
                float r = 0.1f + 0.05f * (float) random.nextDouble();
                double at = 0.65 * size * Math.sqrt((i + 0.5) / discs);
                double a = i * 2.399963;
                world.add((float) (at * Math.cos(a)), (float) (at * Math.sin(a)), r, r * r, 0, 0);
            }
            body.setAngularVelocity(0.6f);
            Worst worst = new Worst();
            float[] circles = new float[4 * discs];
            for (int step = 0; step < steps; step += 4) {
                world.step((float) DT, 4);
                if (step > 120) {
                    worst.look(world, circles, (x, y, r) -> inDrum(x, y, r, size, thickness, body));
                }
            }
            String scene = String.format(Locale.ROOT, "drum of 12 paddles, %d discs, %.0f s: ", discs, steps * DT);
            return List.of(worst.lost("B12", scene), worst.deepest("B12", scene));
        }
    }

    private static double inDrum(double x, double y, double r, double size, double thickness, TerrainBody body) {
        double away = Math.hypot(x, y);
        if (!(away < size)) {
            return Double.POSITIVE_INFINITY;
        }
        double depth = away + r - size;
        for (int k = 0; k < 12; k++) {
            double c = size * Math.cos(body.angle() + k * Math.PI / 6);
            double s = size * Math.sin(body.angle() + k * Math.PI / 6);
            depth = Math.max(depth, inSegment(x, y, r, 0.7 * c, 0.7 * s, 0.98 * c, 0.98 * s, thickness));
        }
        return depth;
    }

    // ---- an hourglass

    /** Right half of the glass, from its floor to its top. */
    private static final float[] GLASS = {0.5f, 0, 6, 0, 6, 6, 0.8f, 11, 0.8f, 12, 6, 17, 6, 30};

    /** Discs run through the neck of a glass of loose segments. */
    private static List<RowFigure> hourglass(int discs, int steps) {
        SplittableRandom random = new SplittableRandom(13);
        try (World world = TerrainBall.builder(G, 0.2, 0).build()) {
            Terrain terrain = world.terrain();
            for (int side = -1; side <= 1; side += 2) {
                for (int k = 0; k + 3 < GLASS.length; k += 2) {
                    terrain.addSegment(side * GLASS[k], GLASS[k + 1], side * GLASS[k + 2], GLASS[k + 3]);
                }
            }
            terrain.addSegment(-0.5f, 0, 0.5f, 0);
            for (int i = 0; i < discs; i++) {
                float r = 0.1f + 0.03f * (float) random.nextDouble();
                world.add(-5.6f + 0.28f * (i % 41), 17 + 0.28f * (i / 41), r, r * r, 0, 0);
            }
            Worst worst = new Worst();
            float[] circles = new float[4 * discs];
            for (int step = 0; step < steps; step += 4) {
                world.step((float) DT, 4);
                worst.look(world, circles, TerrainCrowds::inGlass);
            }
            int left = 0;
            for (int i = 0; i < discs; i++) {
                left += circles[4 * i + 1] > 11 ? 1 : 0;
            }
            String scene = "hourglass of segments, " + discs + " discs: ";
            return List.of(
                    RowFigure.within("B12", scene + "left above the neck", 0, Double.NaN, 0, left),
                    worst.lost("B12", scene),
                    worst.deepest("B12", scene));
        }
    }

    private static double inGlass(double x, double y, double r) {
        double depth = r - y;
        double half = 6;
        for (int k = 0; k + 3 < GLASS.length; k += 2) {
            depth = Math.max(
                    depth, inSegment(Math.abs(x), y, r, GLASS[k], GLASS[k + 1], GLASS[k + 2], GLASS[k + 3], 0));
            if (y >= GLASS[k + 1] && y < GLASS[k + 3]) {
                double share = (y - GLASS[k + 1]) / (GLASS[k + 3] - GLASS[k + 1]);
                half = GLASS[k] + share * (GLASS[k + 2] - GLASS[k]);
            }
        }
        return y < 0 || Math.abs(x) > half ? Double.POSITIVE_INFINITY : depth;
    }

    // ---- a lift

    /** A tray carries a pile up and down, by up to 3 m/s, with less than half of the acceleration of the fall. */
    private static List<RowFigure> lift(int discs, int steps) {
        SplittableRandom random = new SplittableRandom(14);
        try (World world = TerrainBall.builder(G, 0.6, 0).build()) {
            TerrainBody body = world.terrain().addBody(0, 0, 0);
            body.addChain(Chain.of(3, 8, 3, 0, -3, 0, -3, 8), 0, null);
            for (int i = 0; i < discs; i++) {
                float r = 0.2f + 0.04f * (float) random.nextDouble();
                world.add(-2.4f + 0.53f * (i % 10), 0.3f + 0.5f * (i / 10), r, r * r, 0, 0);
            }
            world.step((float) DT, 180);
            Worst worst = new Worst();
            float[] circles = new float[4 * discs];
            for (int step = 0; step < steps; step++) {
                body.setVelocity(0, 3 * (float) Math.sin(step * DT * 1.5));
                world.step((float) DT);
                worst.look(world, circles, (x, y, r) -> inTray(x, y - body.y(), r));
            }
            String scene = "a lift with a pile of " + discs + ": ";
            return List.of(worst.lost("B13", scene), worst.deepest("B13", scene));
        }
    }

    private static double inTray(double x, double y, double r) {
        if (y < 0 || Math.abs(x) > 3) {
            return Double.POSITIVE_INFINITY;
        }
        return Math.max(r - y, Math.abs(x) + r - 3);
    }
}
