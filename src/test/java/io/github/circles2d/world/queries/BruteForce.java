package io.github.circles2d.world.queries;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

/** The answers that the searches must give, by a look at every circle. It shares no code with them. */
public final class BruteForce {
    /** x, y, radius, mass of each circle. */
    private final float[] circles;

    private final int n;

    /** Circles, numbered in the order of their ids. */
    public BruteForce(float[] circles, int n) {
        this.circles = circles;
        this.n = n;
    }

    /** A circle and where it was met. */
    public record Hit(int circle, double distance, float[] row) {}

    private double x(int i) {
        return circles[4 * i];
    }

    private double y(int i) {
        return circles[4 * i + 1];
    }

    private double r(int i) {
        return circles[4 * i + 2];
    }

    private double square(int i, double px, double py) {
        return (x(i) - px) * (x(i) - px) + (y(i) - py) * (y(i) - py);
    }

    private boolean inDisc(int i, double px, double py, double radius) {
        return square(i, px, py) <= (r(i) + radius) * (r(i) + radius);
    }

    public int[] disc(float px, float py, float radius) {
        return IntStream.range(0, n).filter(i -> inDisc(i, px, py, radius)).toArray();
    }

    public int[] box(float minX, float minY, float maxX, float maxY) {
        return IntStream.range(0, n)
                .filter(i -> {
                    double dx = x(i) < minX ? minX - x(i) : x(i) > maxX ? x(i) - maxX : 0;
                    double dy = y(i) < minY ? minY - y(i) : y(i) > maxY ? y(i) - maxY : 0;
                    return dx * dx + dy * dy <= r(i) * r(i);
                })
                .toArray();
    }

    /** The circle at a point, or -1. */
    public int pick(float px, float py) {
        return IntStream.of(disc(px, py, 0))
                .boxed()
                .min(Comparator.comparingDouble(i -> square(i, px, py)))
                .orElse(-1);
    }

    public List<Hit> nearest(float px, float py, float within, int most) {
        List<Hit> all = new ArrayList<>();
        for (int i : disc(px, py, within)) {
            all.add(new Hit(i, Math.sqrt(square(i, px, py)) - r(i), null));
        }
        all.sort(Comparator.comparingDouble(Hit::distance));
        return all.subList(0, Math.min(most, all.size()));
    }

    /** All circles that a disc meets, in their order. */
    public List<Hit> cast(float px, float py, float radius, float dx, float dy) {
        double length = Math.sqrt((double) dx * dx + (double) dy * dy);
        double ux = length == 0 ? 0 : dx / length;
        double uy = length == 0 ? 0 : dy / length;
        List<Hit> all = new ArrayList<>();
        for (int i = 0; i < n; i++) {
            double distance = 0;
            if (!inDisc(i, px, py, radius)) {
                double along = (x(i) - px) * ux + (y(i) - py) * uy;
                double across = (x(i) - px) * uy - (y(i) - py) * ux;
                double s = r(i) + radius;
                distance = Math.max(0, along - Math.sqrt(s * s - across * across));
                if (!(along > 0) || !(distance <= length)) { // no number if the path passes by
                    continue;
                }
            }
            all.add(new Hit(i, distance, row(i, distance, px + ux * distance, py + uy * distance, ux, uy)));
        }
        all.sort(Comparator.comparingDouble(Hit::distance));
        return all;
    }

    private float[] row(int i, double distance, double hitX, double hitY, double ux, double uy) {
        double nx = hitX - x(i);
        double ny = hitY - y(i);
        double norm = Math.sqrt(nx * nx + ny * ny);
        if (norm == 0) {
            boolean still = ux == 0 && uy == 0;
            return new float[] {
                (float) distance, (float) hitX, (float) hitY, (float) (0 - ux), still ? 1 : (float) (0 - uy)
            };
        }
        return new float[] {(float) distance, (float) hitX, (float) hitY, (float) (nx / norm), (float) (ny / norm)};
    }

    /** What a cast gives that meets nothing. */
    public static float[] miss(float px, float py, float dx, float dy) {
        double length = Math.sqrt((double) dx * dx + (double) dy * dy);
        return new float[] {(float) length, (float) ((double) px + dx), (float) ((double) py + dy), 0, 0};
    }
}
