package io.github.circles2d.calibration;

import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.NavigableMap;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;

/**
 * How long a frame of World takes, by the ratio of the greatest radius to the least and by the number of circles: measured at a few
 * ratios, and a guess everywhere else. Between two ratios the logarithm of the time is linear in the logarithm of the ratio. Above
 * the greatest ratio the times of the greatest hold.
 */
public final class CurvesByRatio {
    private static final String MIXED = "1:";

    private final NavigableMap<Double, Curve> curves;

    /**
     * Takes what was measured.
     *
     * @param curves the curves by ratio; one of them of like radii, {@link Crowd#LIKE}
     * @throws IllegalArgumentException if there is none of like radii
     */
    public CurvesByRatio(Map<Double, Curve> curves) {
        if (!curves.containsKey(Crowd.LIKE)) {
            throw new IllegalArgumentException("like radii have not been measured");
        }
        this.curves = new TreeMap<>(curves);
    }

    /**
     * Names a ratio, as the variant of a timing does.
     *
     * @param ratio greatest radius over least, at least {@link Crowd#LIKE}
     * @return 1:10 for 10; empty for like radii
     */
    public static String variant(double ratio) {
        return ratio == Crowd.LIKE ? "" : MIXED + (ratio == Math.rint(ratio) ? Long.toString((long) ratio) : ratio);
    }

    /**
     * Reads the name of a ratio.
     *
     * @param variant what {@link #variant} has given
     * @return the ratio
     * @throws IllegalArgumentException if it is no name of a ratio
     */
    static double ratio(String variant) {
        if (variant.isEmpty()) {
            return Crowd.LIKE;
        }
        try {
            double ratio = variant.startsWith(MIXED) ? Double.parseDouble(variant.substring(MIXED.length())) : 0;
            if (ratio > Crowd.LIKE && ratio < Double.POSITIVE_INFINITY) {
                return ratio;
            }
        } catch (NumberFormatException e) {
            // Refused below, as what is no ratio is.
        }
        throw new IllegalArgumentException(
                "'" + variant + "' is no ratio of radii: neither empty nor 1: and a number above " + Crowd.LIKE);
    }

    /**
     * Returns the ratios by which all can be compared.
     *
     * @param all what is to be compared
     * @return the ratios at which each was measured: {@link Crowd#LIKE} and perhaps others
     */
    public static Set<Double> common(Collection<CurvesByRatio> all) {
        Set<Double> ratios = new TreeSet<>();
        all.forEach(one -> ratios.addAll(one.curves.keySet()));
        all.forEach(one -> ratios.retainAll(one.curves.keySet()));
        return ratios;
    }

    /**
     * Returns the times of one ratio, of each by the same ratios measured, so that they can be compared.
     *
     * @param ratio greatest radius over least, at least 1
     * @param all what is to be compared
     * @param <T> what was measured
     * @return the times by number of circles, in the same order
     */
    public static <T> Map<T, Curve> at(double ratio, Map<T, CurvesByRatio> all) {
        Set<Double> ratios = common(all.values());
        Map<T, Curve> curves = new LinkedHashMap<>();
        all.forEach((one, byRatio) -> curves.put(one, byRatio.at(ratio, ratios)));
        return curves;
    }

    private Curve at(double ratio, Set<Double> by) {
        TreeMap<Double, Curve> known = new TreeMap<>(curves);
        known.keySet().retainAll(by);
        Map.Entry<Double, Curve> below = known.floorEntry(ratio);
        Map.Entry<Double, Curve> above = known.ceilingEntry(ratio);
        if (below == null || above == null) {
            return (below == null ? above : below).getValue();
        }
        if (below.getKey().equals(above.getKey())) {
            return below.getValue();
        }
        double share = Math.log(ratio / below.getKey()) / Math.log(above.getKey() / below.getKey());
        return below.getValue().towards(above.getValue(), share);
    }
}
