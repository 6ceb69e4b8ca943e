package io.github.circles2d.scenes;

/**
 * How well a state of circles obeys the physics: how deeply pairs overlap, and how much they still move. A speed without
 * these figures says nothing, since not resolving contacts is always fastest.
 *
 * <p>The depth of a pair is its overlap, r_i + r_j - |c_j - c_i| where that is positive, divided by the mean radius of all
 * circles. Walls are not counted.
 *
 * @param meanDepth mean depth over the overlapping pairs, in mean radii; 0 where no pair overlaps
 * @param maxDepth depth of the deepest pair, in mean radii; 0 where no pair overlaps
 * @param overlapping number of overlapping pairs
 * @param deep number of pairs deeper than {@link #DEEP}
 * @param kineticEnergyPerCircle mean of m v^2 / 2 over all circles: what is left of it shows whether a pile has come to rest
 */
public record Quality(double meanDepth, double maxDepth, long overlapping, long deep, double kineticEnergyPerCircle) {
    /** A pair deeper than this, in mean radii, is plain to the eye. */
    public static final double DEEP = 0.1;

    /**
     * Measures a state, in double precision. The cost grows with the number of circles and of overlapping pairs, not with
     * the number of all pairs, for any mix of radii.
     *
     * @param x x of the centres; this and the other arrays have at least n elements, of which the first n count
     * @param y y of the centres
     * @param radius radii, greater than 0
     * @param mass masses; a circle of infinite mass at rest has no kinetic energy
     * @param vx x components of the velocities
     * @param vy y components of the velocities
     * @param n the number of circles, at least 1
     * @return the measures
     * @throws IllegalArgumentException where an array is too short, or a position, velocity or radius is not finite, or a
     *     radius or mass is not greater than 0
     */
    public static Quality of(float[] x, float[] y, float[] radius, float[] mass, float[] vx, float[] vy, int n) {
        check(x, y, radius, mass, vx, vy, n);
        double sumOfRadii = 0;
        double energy = 0;
        for (int i = 0; i < n; i++) {
            sumOfRadii += radius[i];
            double square = (double) vx[i] * vx[i] + (double) vy[i] * vy[i];
            energy += square == 0 ? 0 : 0.5 * mass[i] * square;
        }
        Depths depths = new Depths(sumOfRadii / n);
        new Overlaps(x, y, radius, n).forEach(depths);
        return new Quality(
                depths.count == 0 ? 0 : depths.sum / depths.count, depths.max, depths.count, depths.deep, energy / n);
    }

    /**
     * Measures the start of a scene.
     *
     * @param scene the scene
     * @return the measures
     */
    public static Quality of(Scene scene) {
        return of(scene.x(), scene.y(), scene.radius(), scene.mass(), scene.vx(), scene.vy(), scene.size());
    }

    private static void check(float[] x, float[] y, float[] radius, float[] mass, float[] vx, float[] vy, int n) {
        if (n < 1) {
            throw new IllegalArgumentException("the number of circles must be at least 1: " + n);
        }
        float least = -Float.MAX_VALUE;
        check("x", x, n, least, Float.MAX_VALUE);
        check("y", y, n, least, Float.MAX_VALUE);
        check("radius", radius, n, Float.MIN_VALUE, Float.MAX_VALUE);
        check("mass", mass, n, Float.MIN_VALUE, Float.POSITIVE_INFINITY);
        check("vx", vx, n, least, Float.MAX_VALUE);
        check("vy", vy, n, least, Float.MAX_VALUE);
    }

    private static void check(String name, float[] values, int n, float least, float greatest) {
        if (values.length < n) {
            throw new IllegalArgumentException(
                    name + " has " + values.length + " elements, fewer than the " + n + " circles");
        }
        for (int i = 0; i < n; i++) {
            if (!(values[i] >= least && values[i] <= greatest)) {
                throw new IllegalArgumentException("circle " + i + ": " + name + " is " + values[i]);
            }
        }
    }

    /** Sums over the overlapping pairs. */
    private static final class Depths implements Overlaps.Visitor {
        private final double meanRadius;
        private double sum;
        private double max;
        private long count;
        private long deep;

        Depths(double meanRadius) {
            this.meanRadius = meanRadius;
        }

        @Override
        public void pair(int i, int j, double overlap) {
            double depth = overlap / meanRadius;
            sum += depth;
            max = Math.max(max, depth);
            count++;
            if (depth > DEEP) {
                deep++;
            }
        }
    }
}
