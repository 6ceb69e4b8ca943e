package io.github.circles2d.bench.results;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Locale;

/** Numbers as text, the same in every locale. */
public final class Numbers {
    private Numbers() {}

    /** Four significant digits for a file; empty for what is not known. */
    public static String exact(double value) {
        return Double.isFinite(value) ? plain(value, 4) : "";
    }

    /** Two significant digits below 100, else a whole number: as much as a reader wants to see. */
    public static String brief(double value) {
        if (!Double.isFinite(value)) {
            return "-";
        }
        return Math.abs(value) >= 99.5 ? String.format(Locale.ROOT, "%,.0f", value) : plain(value, 2);
    }

    /** As {@link #brief(double)}, of what {@link #exact} wrote. */
    public static String brief(String number) {
        return brief(parse(number));
    }

    /** A whole number with separators. */
    public static String whole(long value) {
        return String.format(Locale.ROOT, "%,d", value);
    }

    /** As {@link #whole(long)}, of a number without separators. */
    public static String whole(String number) {
        return whole(Long.parseLong(number));
    }

    /** A share of one, in per cent. */
    public static String percent(String share) {
        return Math.round(100 * parse(share)) + " %";
    }

    /** Reads what {@link #exact} wrote; NaN for an empty text. */
    public static double parse(String text) {
        return text.isEmpty() ? Double.NaN : Double.parseDouble(text);
    }

    private static String plain(double value, int digits) {
        if (value == 0) {
            return "0";
        }
        return new BigDecimal(value)
                .round(new MathContext(digits))
                .stripTrailingZeros()
                .toPlainString();
    }
}
