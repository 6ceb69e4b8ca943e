package io.github.circles2d.calibration;

import java.util.Map;
import java.util.NavigableMap;
import java.util.TreeMap;

/**
 * How long a loop of Circles2D takes, by the number of circles: measured at a few sizes, and a guess everywhere else. Between two sizes
 * the logarithm of the time is linear in the logarithm of the size. Below the least size the time is that of the least, for
 * there it is mostly launches; above the greatest it grows as the number of pairs does. So what is fastest at the greatest size stays so
 * above it: what only pays far beyond the sizes that were measured is not seen.
 */
public final class Curve {
    /** The power of the number of circles that the time of a large crowd grows by. */
    static final int GROWTH = 2;

    private final NavigableMap<Integer, Double> millis;

    /** Takes milliseconds, finite and greater than 0, by the number of circles, at least 1; there must be some. */
    public Curve(Map<Integer, Double> millis) {
        if (millis.isEmpty()) {
            throw new IllegalArgumentException("a curve needs at least one size");
        }
        millis.forEach((n, time) -> {
            if (!(n >= 1 && time > 0 && Double.isFinite(time))) {
                throw new IllegalArgumentException(n + " circles in " + time + " ms is no measurement");
            }
        });
        this.millis = new TreeMap<>(millis);
    }

    /** Milliseconds for a number of circles, greater than 0. */
    public double millis(int circles) {
        Map.Entry<Integer, Double> below = millis.floorEntry(circles);
        Map.Entry<Integer, Double> above = millis.ceilingEntry(circles);
        if (below == null) {
            return above.getValue();
        }
        if (above == null) {
            return below.getValue() * Math.pow((double) circles / below.getKey(), GROWTH);
        }
        if (below.getKey().equals(above.getKey())) {
            return below.getValue();
        }
        double share = Math.log((double) circles / below.getKey()) / Math.log((double) above.getKey() / below.getKey());
        return below.getValue() * Math.pow(above.getValue() / below.getValue(), share);
    }

    /** What was measured: milliseconds by the number of circles; a copy. */
    public NavigableMap<Integer, Double> measured() {
        return new TreeMap<>(millis);
    }
}
