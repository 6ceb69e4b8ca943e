package io.github.circles2d;

/** What the circles of two kinds do to each other; see {@link World#setResponse}. */
public enum Response {
    /** Masks and sensors decide: at first it is so for all kinds. */
    BY_MASK,
    /** They push each other, whatever their masks say and even if one is a sensor. */
    SOLID,
    /** They pass through each other. */
    IGNORE,
    /** They pass through each other, and are to be noticed. (Nothing reports it yet.) */
    SENSE
}
