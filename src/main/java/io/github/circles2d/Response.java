package io.github.circles2d;

/**
 * The effect that the circles of two kinds have on each other; see {@link World#setResponse}. {@link Kind} says when to take which.
 *
 * <p><img src="doc-files/kinds.svg" alt="Groups decide first, then the matrix, then masks, then sensors: ignore, sense or push">
 */
public enum Response {
    /**
     * Masks and sensors decide, as for all kinds at first. If a mask refuses the other kind, or both kinds are sensors, the circles
     * ignore each other. Else they sense each other if one kind is a sensor, and push each other if none is.
     */
    BY_MASK,
    /** They push each other, whatever their masks say, sensors too. */
    SOLID,
    /** They pass through each other, and no event tells of it. */
    IGNORE,
    /**
     * They pass through each other, whatever their masks say, and {@link Events} tells when they begin and end to touch, if
     * {@link World#report} asks for it, or {@link BodyEvents} of bodies.
     */
    SENSE
}
