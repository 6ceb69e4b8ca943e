package io.github.circles2d;

import static io.github.circles2d.SurfaceBall.DT;
import static io.github.circles2d.SurfaceBall.G;

import java.util.List;
import java.util.Locale;

/** The scenes of many discs that measure how surfaces grip. */
final class SurfaceCrowds {
    private static final double FOR_EVER = 60;
    private static final int HEAPS = 5;

    private final World world;
    private final int n;
    private final float[] circles;
    private final float[] velocities;

    private SurfaceCrowds(World world) {
        this.world = world;
        n = world.size();
        circles = new float[4 * n];
        velocities = new float[2 * n];
        world.read(circles);
        world.readVelocities(velocities);
    }

    /** Those that take a second or two. */
    static List<FigureRow> quick() {
        return List.of(new FigureRow("A18", SurfaceCrowds::box), new FigureRow("A19", SurfaceCrowds::stacks));
    }

    /** Those that take longer. */
    static List<FigureRow> slow() {
        return List.of(
                new FigureRow("A14, mu 0.6, c 0", () -> heaps(0.6, 0, 15.9, 5)),
                new FigureRow("A14, mu 0.6, c 0.1", () -> heaps(0.6, 0.1, 33.0, 21)),
                new FigureRow("A14, mu 0.6, c 0.3", () -> heaps(0.6, 0.3, 44.6, 33)),
                new FigureRow("A14, mu 0.1, c 0.3", () -> heaps(0.1, 0.3, 8.8, 5)));
    }

    /** The random numbers of the scenes as they were run on Box2D: in [0, 1). */
    private static final class Sequence {
        private int state;

        Sequence(int seed) {
            state = seed;
        }

        float next() {
            state = state * 1664525 + 1013904223;
            return (state >>> 8) / 16777216f;
        }
    }

    private double x(int i) {
        return circles[4 * i];
    }

    private double y(int i) {
        return circles[4 * i + 1];
    }

    /** Where a disc ends upwards. */
    private double top(int i) {
        return circles[4 * i + 1] + circles[4 * i + 2];
    }

    private double meanSpeed() {
        double sum = 0;
        for (int i = 0; i < n; i++) {
            sum += Math.hypot(velocities[2 * i], velocities[2 * i + 1]);
        }
        return sum / n;
    }

    // ---- a heap

    private static List<RowFigure> heaps(double friction, double resistance, double box2d, double floor) {
        double slope = 0;
        double speed = 0;
        for (int seed = 1; seed <= HEAPS; seed++) {
            SurfaceCrowds heap = heap(friction, resistance, 600, seed);
            slope += heap.slope() / HEAPS;
            speed = Math.max(speed, heap.meanSpeed());
        }
        String scene = String.format(Locale.ROOT, "heap of 600, mu %.1f, c %.1f: ", friction, resistance);
        RowFigure steep = RowFigure.between(
                        "A14", scene + "slope, mean of five, degrees", box2d, box2d - 5, box2d + 5, slope)
                .notBelow(floor);
        if (resistance == 0) {
            return List.of(steep); // some discs roll away for ever
        }
        return List.of(steep, RowFigure.within("A14", scene + "mean speed after 20 s, m/s", 0, 1.5e-6, 1e-3, speed));
    }

    /** The mean speed in a heap of a hundred discs with rolling resistance, 20 s after the last one fell. */
    static double speedInASmallHeap() {
        return heap(0.6, 0.1, 100, 1).meanSpeed();
    }

    /** A heap of discs that have fallen one after the other on the same place, and 20 s later. */
    private static SurfaceCrowds heap(double friction, double resistance, int discs, int seed) {
        World.Builder builder = SurfaceBall.builder(friction, resistance, 0).bounds(-200, 0, 200, 60);
        Sequence random = new Sequence(seed);
        try (World world = builder.build()) {
            for (int i = 0; i < discs; i++) {
                float r = (float) (0.2 + 0.1 * random.next());
                world.add((random.next() - 0.5f) * 1.0f, 12, r, r * r, 0, -3);
                world.step((float) DT, 8);
            }
            world.step((float) DT, 1200);
            return new SurfaceCrowds(world);
        }
    }

    /** The slope of both flanks, in degrees, by the highest discs of strips of 0.5. */
    private double slope() {
        double highest = 0;
        for (int i = 0; i < n; i++) {
            highest = Math.max(highest, top(i));
        }
        return (flank(-1, highest) + flank(1, highest)) / 2;
    }

    /** The slope of the line of least squares through the middle of a flank. */
    private double flank(int side, double highest) {
        double sx = 0;
        double sy = 0;
        double sxx = 0;
        double sxy = 0;
        int count = 0;
        for (double from = 0; from < 60; from += 0.5) {
            int best = -1;
            for (int i = 0; i < n; i++) {
                boolean inside = side * x(i) >= from && side * x(i) < from + 0.5;
                best = inside && (best < 0 || top(i) > top(best)) ? i : best;
            }
            if (best >= 0 && top(best) > Math.max(0.2 * highest, 0.65) && top(best) < 0.85 * highest) {
                double at = side * x(best);
                sx += at;
                sy += top(best);
                sxx += at * at;
                sxy += at * top(best);
                count++;
            }
        }
        return Math.toDegrees(Math.atan(-(count * sxy - sx * sy) / (count * sxx - sx * sx)));
    }

    // ---- a box

    private static List<RowFigure> box() {
        World.Builder builder = SurfaceBall.builder(0.6, 0, 0.5).bounds(0, 0, 20, 40);
        Sequence random = new Sequence(7);
        try (World world = builder.build()) {
            for (int i = 0; i < 300; i++) {
                double angle = random.next() * 2 * Math.PI;
                world.add(1 + i % 18, 1 + i / 18, 0.4f, 1, 8 * (float) Math.cos(angle), 8 * (float) Math.sin(angle));
            }
            double first = new SurfaceCrowds(world).energy();
            double least = first;
            double rise = 0;
            for (int step = 0; step < 1200; step++) {
                world.step((float) DT);
                double energy = new SurfaceCrowds(world).energy();
                least = Math.min(least, energy);
                rise = Math.max(rise, energy - least);
            }
            double speed = new SurfaceCrowds(world).meanSpeed();
            return List.of(
                    RowFigure.within(
                            "A18",
                            "300 discs in a box, e 0.5: greatest rise of energy, %",
                            0,
                            0.00335635,
                            0.1,
                            100 * rise / first),
                    RowFigure.within(
                            "A18",
                            "300 discs in a box, e 0.5: mean speed after 20 s, m/s",
                            0,
                            6.30625e-5,
                            1e-3,
                            speed));
        }
    }

    /** Of motion, turning and height, of discs of mass 1. */
    private double energy() {
        long[] handles = new long[n];
        world.readHandles(handles);
        double sum = 0;
        for (int i = 0; i < n; i++) {
            double v = Math.hypot(velocities[2 * i], velocities[2 * i + 1]);
            double s = world.angularVelocity(handles[i]) * circles[4 * i + 2];
            sum += 0.5 * v * v + 0.25 * s * s + G * y(i);
        }
        return sum;
    }

    // ---- stacks

    private static List<RowFigure> stacks() {
        return List.of(
                stands("column of 50", 1, 50, 0, 0),
                stands("column of 50, up to 1 mm off, c 0.1", 1, 50, 0.1, 1e-3f).notBelow(5),
                stands("wall of 20 x 20, c 0.1", 20, 20, 0.1, 0),
                stands("wall of 20 x 20, up to 1 mm off, c 0.1", 20, 20, 0.1, 1e-3f)
                        .notBelow(3.5));
    }

    /** Columns side by side, of discs as high as each other; how long it takes until one is a radius off its place. */
    private static RowFigure stands(String what, int columns, int rows, double resistance, float off) {
        World.Builder builder = SurfaceBall.builder(0.6, resistance, 0).bounds(-200, 0, 200, 100);
        Sequence random = new Sequence(1);
        double stands = 0;
        try (World world = builder.build()) {
            for (int i = 0; i < columns * rows; i++) {
                float x = i / rows + 2 * off * (random.next() - 0.5f);
                world.add(x, 0.5f + i % rows, 0.5f, 1, 0, 0);
            }
            SurfaceCrowds before = new SurfaceCrowds(world);
            while (stands < FOR_EVER && new SurfaceCrowds(world).farthest(before) <= 0.5) {
                world.step((float) DT, 15);
                stands += 0.25;
            }
        }
        return RowFigure.between("A19", what + ", mu 0.6: stands, s (of 60)", FOR_EVER, FOR_EVER, FOR_EVER, stands);
    }

    /** How far the disc is off to a side that is farthest off. */
    private double farthest(SurfaceCrowds before) {
        double farthest = 0;
        for (int i = 0; i < n; i++) {
            farthest = Math.max(farthest, Math.abs(x(i) - before.x(i)));
        }
        return farthest;
    }
}
