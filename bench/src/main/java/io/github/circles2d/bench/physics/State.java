package io.github.circles2d.bench.physics;

import java.util.Arrays;
import java.util.Comparator;

/** Positions and velocities at one moment, and what is measured on them. Static circles do not count as moving ones. */
final class State {
    final double[] x;
    final double[] y;
    final double[] radius;
    final double[] mass;
    final double[] vx;
    final double[] vy;

    private final double gravityY;
    private final double minX;
    private final double minY;
    private final double maxX;
    private final double maxY;

    State(int n, double gravityY, double minX, double minY, double maxX, double maxY) {
        this.gravityY = gravityY;
        this.minX = minX;
        this.minY = minY;
        this.maxX = maxX;
        this.maxY = maxY;
        x = new double[n];
        y = new double[n];
        radius = new double[n];
        mass = new double[n];
        vx = new double[n];
        vy = new double[n];
    }

    int size() {
        return x.length;
    }

    boolean moves(int i) {
        return mass[i] < Double.POSITIVE_INFINITY;
    }

    double speed(int i) {
        return Math.hypot(vx[i], vy[i]);
    }

    double distance(int i, int j) {
        return Math.hypot(x[j] - x[i], y[j] - y[i]);
    }

    /** How far two circles overlap; negative if there is a gap. */
    double overlap(int i, int j) {
        return radius[i] + radius[j] - distance(i, j);
    }

    /** Root of the mean of the squared speeds. */
    double rmsSpeed() {
        double sum = 0;
        int count = 0;
        for (int i = 0; i < size(); i++) {
            if (moves(i)) {
                sum += vx[i] * vx[i] + vy[i] * vy[i];
                count++;
            }
        }
        return Math.sqrt(sum / count);
    }

    double greatestSpeed() {
        double greatest = 0;
        for (int i = 0; i < size(); i++) {
            greatest = moves(i) ? Math.max(greatest, speed(i)) : greatest;
        }
        return greatest;
    }

    /** Height of the centre of mass above the lower wall. */
    double centreOfMass() {
        double sum = 0;
        double masses = 0;
        for (int i = 0; i < size(); i++) {
            if (moves(i)) {
                sum += mass[i] * (y[i] - minY);
                masses += mass[i];
            }
        }
        return sum / masses;
    }

    double kineticEnergy() {
        double sum = 0;
        for (int i = 0; i < size(); i++) {
            if (moves(i)) {
                sum += 0.5 * mass[i] * (vx[i] * vx[i] + vy[i] * vy[i]);
            }
        }
        return sum;
    }

    /** Kinetic energy and that of the height: a circle that lies on the lower wall has none. */
    double energy() {
        double sum = kineticEnergy();
        for (int i = 0; i < size(); i++) {
            if (moves(i)) {
                sum -= mass[i] * gravityY * (y[i] - minY - radius[i]);
            }
        }
        return sum;
    }

    /** Overlap of the deepest pair in lengths; 0 if no pair overlaps. */
    double deepest() {
        return deepest(false);
    }

    /** Overlap of the deepest pair in radii of its smaller circle; 0 if no pair overlaps. */
    double deepestOfSmaller() {
        return deepest(true);
    }

    private double deepest(boolean inRadii) {
        double[] worst = {0};
        forEachOverlap((i, j, overlap) -> {
            double depth = inRadii ? overlap / Math.min(radius[i], radius[j]) : overlap;
            worst[0] = Math.max(worst[0], depth);
        });
        return worst[0];
    }

    /** Mean overlap of the pairs that overlap, in lengths; 0 if none does. */
    double meanDepth() {
        double[] sum = {0, 0};
        forEachOverlap((i, j, overlap) -> {
            sum[0] += overlap;
            sum[1]++;
        });
        return sum[1] == 0 ? 0 : sum[0] / sum[1];
    }

    /** How far the circle that is farthest outside a wall reaches beyond it; 0 if none does. */
    double deepestInWall() {
        double worst = 0;
        for (int i = 0; i < size(); i++) {
            if (moves(i)) {
                worst = Math.max(worst, Math.max(minX - x[i], x[i] - maxX) + radius[i]);
                worst = Math.max(worst, Math.max(minY - y[i], y[i] - maxY) + radius[i]);
            }
        }
        return worst;
    }

    /** The greatest distance of a circle from where it was. */
    double farthestFrom(State before) {
        double farthest = 0;
        for (int i = 0; i < size(); i++) {
            farthest = Math.max(farthest, Math.hypot(x[i] - before.x[i], y[i] - before.y[i]));
        }
        return farthest;
    }

    private interface Visitor {
        void pair(int i, int j, double overlap);
    }

    /** Sweeps from left to right: each circle meets those whose left ends come before its right end. */
    private void forEachOverlap(Visitor visitor) {
        Integer[] order = new Integer[size()];
        Arrays.setAll(order, i -> i);
        Arrays.sort(order, Comparator.comparingDouble(i -> x[i] - radius[i]));
        for (int a = 0; a < order.length; a++) {
            int i = order[a];
            double end = x[i] + radius[i];
            for (int b = a + 1; b < order.length && x[order[b]] - radius[order[b]] < end; b++) {
                int j = order[b];
                if ((moves(i) || moves(j)) && Math.abs(y[j] - y[i]) < radius[i] + radius[j] && overlap(i, j) > 0) {
                    visitor.pair(i, j, overlap(i, j));
                }
            }
        }
    }
}
