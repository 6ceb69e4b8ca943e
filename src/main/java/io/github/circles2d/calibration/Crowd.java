package io.github.circles2d.calibration;

import java.text.DecimalFormat;
import java.text.DecimalFormatSymbols;
import java.util.Locale;

/**
 * A crowd of circles, as far as its speed depends on it.
 *
 * @param circles number of circles
 * @param ratio greatest radius over least
 */
public record Crowd(int circles, double ratio) {
    /** Greatest radius over least of the crowd of like radii that is measured. */
    public static final double LIKE = 1.5;

    /**
     * A crowd of like radii.
     *
     * @param circles number of circles
     * @return the crowd
     */
    public static Crowd like(int circles) {
        return new Crowd(circles, LIKE);
    }

    /**
     * Whether the radii are farther apart than like ones.
     *
     * @return true if so
     */
    public boolean isMixed() {
        return ratio > LIKE;
    }

    /** The crowd in words. */
    @Override
    public String toString() {
        String radii = new DecimalFormat("0.#", DecimalFormatSymbols.getInstance(Locale.ROOT)).format(ratio);
        return circles + " circles" + (isMixed() ? " of radii 1:" + radii : "");
    }
}
