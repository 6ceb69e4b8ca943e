package io.github.circles2d;

/** What the circles of two kinds do to each other; see {@link World#setResponse}. */
public enum Response {
    /** Masks and sensors decide: at first it is so for all kinds. */
    BY_MASK,
    /** They push each other, whatever their masks say and even if one is a sensor. */
    SOLID,
    /** They pass through each other. */
    IGNORE,
    /** They pass through each other, and {@link Events} tells when they begin and end to touch, if {@link World#report} asks for it. */
    SENSE
}
