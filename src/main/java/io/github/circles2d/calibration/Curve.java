package io.github.circles2d.calibration;

import java.util.List;
import java.util.Map;
import java.util.NavigableMap;
import java.util.TreeMap;

/**
 * How long a workload takes, by the number of circles: measured at a few sizes, and a guess everywhere else. Between two sizes
 * the logarithm of the time is linear in the logarithm of the size. Below the least size the time is that of the least, for
 * there it is mostly launches; above the greatest it grows as the work does. So what is fastest at the greatest size stays so
 * above it: what only pays far beyond the sizes that were measured is not seen.
 */
public final class Curve {
    private final int growth;
    private final NavigableMap<Integer, Double> millis;

    /**
     * Makes a curve.
     *
     * @param workload what was timed
     * @param millis milliseconds, finite and greater than 0, by the number of circles, at least 1; not empty
     * @throws IllegalArgumentException if a value is out of its range
     */
    public Curve(Workload workload, Map<Integer, Double> millis) {
        if (millis.isEmpty()) {
            throw new IllegalArgumentException("a curve needs at least one size");
        }
        millis.forEach((n, time) -> {
            if (!(n >= 1 && time > 0 && Double.isFinite(time))) {
                throw new IllegalArgumentException(n + " circles in " + time + " ms is no measurement");
            }
        });
        growth = workload.growth;
        this.millis = new TreeMap<>(millis);
    }

    private Curve(int growth, Map<Integer, Double> millis) {
        this.growth = growth;
        this.millis = new TreeMap<>(millis);
    }

    /**
     * Returns the time for a number of circles.
     *
     * @param circles number of circles
     * @return milliseconds, greater than 0
     */
    public double millis(int circles) {
        Map.Entry<Integer, Double> below = millis.floorEntry(circles);
        Map.Entry<Integer, Double> above = millis.ceilingEntry(circles);
        if (below == null) {
            return above.getValue();
        }
        if (above == null) {
            return below.getValue() * Math.pow((double) circles / below.getKey(), growth);
        }
        if (below.getKey().equals(above.getKey())) {
            return below.getValue();
        }
        double share = Math.log((double) circles / below.getKey()) / Math.log((double) above.getKey() / below.getKey());
        return below.getValue() * Math.pow(above.getValue() / below.getValue(), share);
    }

    /**
     * Returns a curve between this one and another of the same workload: the logarithm of the time is linear between them.
     *
     * @param other the other curve
     * @param share 0 for this one, 1 for the other
     * @return the curve; exact at every number of circles, since its sizes are those of both
     */
    Curve towards(Curve other, double share) {
        Map<Integer, Double> between = new TreeMap<>();
        for (Curve curve : List.of(this, other)) {
            for (int n : curve.millis.keySet()) {
                between.put(n, millis(n) * Math.pow(other.millis(n) / millis(n), share));
            }
        }
        return new Curve(growth, between);
    }

    /**
     * Returns what was measured.
     *
     * @return milliseconds by the number of circles; a copy
     */
    public NavigableMap<Integer, Double> measured() {
        return new TreeMap<>(millis);
    }
}
