package io.github.circles2d.playground;

import java.util.Locale;

/** What the colour of a circle tells. */
enum PaintMode {
    /** Which circle it is. */
    PLAIN,
    /** How fast it is. */
    SPEED,
    /** The force that presses it, by length of its edge. */
    PRESSURE,
    /** How many circles and walls press it. */
    CONTACTS;

    String label() {
        return name().toLowerCase(Locale.ROOT);
    }

    boolean needsLoads() {
        return this == PRESSURE || this == CONTACTS;
    }

    PaintMode next() {
        return values()[(ordinal() + 1) % values().length];
    }
}
