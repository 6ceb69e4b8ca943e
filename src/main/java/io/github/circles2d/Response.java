package io.github.circles2d;

/** What the circles of two kinds do to each other; see {@link World#setResponse}. {@link Kind} says when to take which. */
public enum Response {
    /**
     * Masks and sensors decide, as for all kinds at first: solid, if the masks let both meet and neither is a sensor; sensed, if one is;
     * ignored, if both are or a mask says so.
     */
    BY_MASK,
    /** They push each other, whatever their masks say, sensors too. */
    SOLID,
    /** They pass through each other, and no event tells of it. */
    IGNORE,
    /**
     * They pass through each other, whatever their masks say, and {@link Events} tells when they begin and end to touch, if
     * {@link World#report} asks for it.
     */
    SENSE
}
