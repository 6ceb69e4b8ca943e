package io.github.circles2d.reference;

/**
 * How contacts are.
 *
 * @param threshold speed up to which impacts do not bounce; -1 if it follows from gravity, radii and restitutions
 * @param frequency hertz
 * @param damping ratio
 * @param pushOutSpeed mean radii a second
 */
public record Settings(float threshold, float frequency, float damping, float pushOutSpeed) {
    /** What worlds have if they are not told otherwise. */
    public static final Settings DEFAULT = new Settings(-1f, 67f, 20f, 0.8f);
}
