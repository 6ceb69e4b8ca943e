package io.github.circles2d.thesis;

/** Checks of arguments: each names the value and the rule. */
final class Checks {
    private Checks() {}

    static void finite(String what, float value) {
        if (!Float.isFinite(value)) {
            throw new IllegalArgumentException(what + " must be finite, not " + value);
        }
    }

    static void positive(String what, float value) {
        if (!(value > 0 && Float.isFinite(value))) {
            throw new IllegalArgumentException(what + " must be finite and greater than 0, not " + value);
        }
    }
}
