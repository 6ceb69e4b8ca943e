package io.github.circles2d.playground;

import java.util.ArrayList;
import java.util.List;

/** A line of fewer points along a way, no farther from it than a tolerance (Douglas and Peucker, 1973). */
final class Simplified {
    private Simplified() {}

    static List<float[]> of(List<float[]> way, double tolerance) {
        List<float[]> kept = new ArrayList<>();
        kept.add(way.get(0));
        keep(way, 0, way.size() - 1, tolerance, kept);
        return kept;
    }

    /** Keeps what is needed behind a point, up to another one. */
    private static void keep(List<float[]> way, int from, int to, double tolerance, List<float[]> kept) {
        int farthest = -1;
        double most = tolerance;
        for (int k = from + 1; k < to; k++) {
            double distance = distance(way.get(from), way.get(to), way.get(k));
            if (distance > most) {
                most = distance;
                farthest = k;
            }
        }
        if (farthest < 0) {
            kept.add(way.get(to));
        } else {
            keep(way, from, farthest, tolerance, kept);
            keep(way, farthest, to, tolerance, kept);
        }
    }

    private static double distance(float[] a, float[] b, float[] p) {
        double dx = (double) b[0] - a[0];
        double dy = (double) b[1] - a[1];
        double x = (double) p[0] - a[0];
        double y = (double) p[1] - a[1];
        double squares = dx * dx + dy * dy;
        double share = squares > 0 ? Math.min(Math.max((x * dx + y * dy) / squares, 0), 1) : 0;
        return Math.hypot(x - share * dx, y - share * dy);
    }
}
