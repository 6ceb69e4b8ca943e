package io.github.circles2d.playground;

import java.util.Locale;

/** Numbers as text, the same in every country. */
final class Figures {
    private Figures() {}

    /** As {@link String#format}, but what is rounded to zero has no sign. */
    static String format(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values).replaceAll("-(0(?:\\.0+)?)(?![\\d.e])", "$1");
    }
}
