package io.github.circles2d.bench.physics;

import java.util.Locale;

/** What is asked of a figure: to lie between two numbers, either of which may be infinite. */
record Bound(double least, double greatest) {
    /** For figures that are shown and not judged. */
    static final Bound NONE = new Bound(Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);

    static Bound atMost(double greatest) {
        return new Bound(Double.NEGATIVE_INFINITY, greatest);
    }

    static Bound atLeast(double least) {
        return new Bound(least, Double.POSITIVE_INFINITY);
    }

    static Bound between(double least, double greatest) {
        return new Bound(least, greatest);
    }

    boolean isNone() {
        return least == Double.NEGATIVE_INFINITY && greatest == Double.POSITIVE_INFINITY;
    }

    /** A figure that is not a number meets no bound but {@link #NONE}. */
    boolean met(double figure) {
        return isNone() || figure >= least && figure <= greatest;
    }

    @Override
    public String toString() {
        if (isNone()) {
            return "-";
        }
        if (least == Double.NEGATIVE_INFINITY) {
            return "<= " + number(greatest);
        }
        return greatest == Double.POSITIVE_INFINITY ? ">= " + number(least) : number(least) + " to " + number(greatest);
    }

    private static String number(double value) {
        return String.format(Locale.ROOT, "%.4g", value)
                .replaceAll("(\\.[0-9]*?)0+(e|$)", "$1$2")
                .replaceAll("\\.(e|$)", "$1");
    }
}
